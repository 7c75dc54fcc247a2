//! What a tile gives: the measure of its own points, its candidates, and the neighbour graph around these.

use super::plan::Plan;
use crate::frame::{Frame, Localised};
use crate::measure::{Direction, Measure, Penalties, Row};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::prepare::Prepared;
use crate::resolution::Resolution;

/// Steps along the neighbour graph around candidates from which lines are linked and recovered: those of
/// the faces beside a line.
const AROUND: usize = crate::recover::FACE_HOPS;

/// The measure of a tile's own points; points are known by their indices in the input.
#[derive(Clone, Debug, Default)]
pub struct Found {
    /// `(M)` own points on surfaces, in canonical order, as indices of the input.
    pub source: Vec<u32>,
    /// `(M, 3)` their positions in the local frame of the whole cloud, and the spacing at each; empty if the mean holds everywhere.
    pub(super) position: Vec<[f64; 3]>,
    pub(super) spacing: Vec<f32>,
    /// `(M)` sampling density, evidence of a feature, and normal of each, as in [`Measure`](crate::Measure).
    pub density: Vec<f32>,
    /// See `density`.
    pub score: Vec<f32>,
    /// `(M, 3)` unit normals without orientation.
    pub normal: Vec<[f32; 3]>,
    /// Candidates of creases among them, with their penalties, local frame of the whole cloud.
    pub crease: Vec<(u32, Row)>,
    /// Candidates of borders.
    pub border: Vec<(u32, Row)>,
    /// Shares and directions of both penalties.
    kinds: [(f64, Direction); 2],
    around: Vec<Around>,
}

/// A point near a candidate.
#[derive(Clone, Debug)]
struct Around {
    point: u32,
    density: f32,
    spacing: Option<f32>,
    normal: [f32; 3],
    /// Its row of the neighbour graph; empty at the rim.
    row: Vec<u32>,
}

impl Found {
    pub(super) fn new(cloud: &Prepared, measure: &Measure, owned: &[bool]) -> Found {
        let own = || (0..owned.len()).filter(|&i| owned[i]);
        let rows = |penalties: &Penalties| -> Vec<(u32, Row)> {
            let own = (0..penalties.len()).filter(|&c| owned[penalties.points[c] as usize]);
            own.map(|c| (cloud.source[penalties.points[c] as usize], penalties.row(c))).collect()
        };
        Found {
            source: own().map(|i| cloud.source[i]).collect(),
            position: own().map(|i| cloud.positions[i]).collect(),
            spacing: own().filter_map(|i| cloud.spacing_at(i)).collect(),
            density: own().map(|i| measure.density[i]).collect(),
            score: own().map(|i| measure.score[i]).collect(),
            normal: own().map(|i| measure.normal[i]).collect(),
            crease: rows(&measure.crease),
            border: rows(&measure.border),
            kinds: [&measure.crease, &measure.border].map(|p| (p.share, p.direction)),
            around: around(cloud, measure, owned),
        }
    }
}

/// The points up to [`AROUND`] steps from a tile's own candidates.
fn around(cloud: &Prepared, measure: &Measure, owned: &[bool]) -> Vec<Around> {
    let candidates = measure.crease.points.iter().chain(&measure.border.points);
    let (mut inner, mut outer) = (vec![false; owned.len()], vec![false; owned.len()]);
    let mut scratch = Scratch::default();
    for &c in candidates.filter(|&&c| owned[c as usize]) {
        for (marks, steps) in [(&mut inner, AROUND - 1), (&mut outer, AROUND)] {
            let near = cloud.graph.hops(c as usize, steps, &mut scratch);
            near.iter().chain([&c]).for_each(|&j| marks[j as usize] = true);
        }
    }
    let source = |&j: &u32| cloud.source[j as usize];
    let one = |i: usize| Around {
        point: cloud.source[i],
        density: measure.density[i],
        spacing: cloud.spacing_at(i),
        normal: measure.normal[i],
        row: if inner[i] { cloud.graph.of(i).iter().map(source).collect() } else { Vec::new() },
    };
    (0..owned.len()).filter(|&i| outer[i]).map(one).collect()
}

/// Joins what all tiles gave to the part of the cloud that linkers see: candidates and the points around them, in canonical order.
pub(super) fn joined(
    found: &[Found],
    (world, plan, frame): (&[[f64; 3]], &Plan, Frame),
    resolution: Resolution,
    count: usize,
) -> (Prepared, Measure) {
    let mut around: Vec<&Around> = found.iter().flat_map(|f| &f.around).collect();
    // Of several copies that with a row comes first.
    around.sort_by_key(|a| (a.point, a.row.is_empty()));
    around.dedup_by_key(|a| a.point);
    let places: Vec<[f64; 3]> = around.iter().map(|a| world[a.point as usize]).collect();
    let Localised { positions, source: order, .. } = frame.of_part(&plan.grid, &places);
    let mut number = vec![0; order.len()];
    order.iter().zip(0..).for_each(|(&a, n)| number[a as usize] = n);
    // The points of rows that are not empty all lie around candidates.
    let new = |point: u32| around.binary_search_by_key(&point, |a| a.point).ok().map(|a| number[a]);
    let around: Vec<&Around> = order.iter().map(|&a| around[a as usize]).collect();
    let mut graph = Neighbors { offsets: vec![0], indices: Vec::new() };
    for a in &around {
        graph.indices.extend(a.row.iter().filter_map(|&j| new(j)));
        graph.offsets.push(graph.indices.len() as u64);
    }
    let penalties = |kind: usize, of: fn(&Found) -> &[(u32, Row)]| {
        let mut rows: Vec<(u32, Row)> = Vec::new();
        for (point, row) in found.iter().flat_map(of) {
            rows.extend(new(*point).map(|n| (n, *row)));
        }
        rows.sort_by_key(|(n, _)| *n);
        let (share, direction) = found.first().map_or_else(Default::default, |f| f.kinds[kind]);
        let mut penalties = Penalties::new(share, direction);
        rows.into_iter().for_each(|(n, row)| penalties.push(n, row));
        penalties
    };
    let measure = Measure {
        density: around.iter().map(|a| a.density).collect(),
        score: vec![0.0; around.len()],
        normal: around.iter().map(|a| a.normal).collect(),
        crease: penalties(0, |f| &f.crease),
        border: penalties(1, |f| &f.border),
        ..Measure::default()
    };
    let spacing = around.iter().filter_map(|a| a.spacing).collect();
    let source = around.iter().map(|a| a.point).collect();
    (Prepared::of_part(frame, (positions, source), graph, (resolution, spacing), count), measure)
}
