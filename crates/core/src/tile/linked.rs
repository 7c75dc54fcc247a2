//! What linking reads of a tile: its candidates, and the neighbour graph around these. Memory for it grows with the lines, not with
//! the cloud.

use super::found::rows;
use crate::frame::{Frame, Grid, Localised};
use crate::measure::{Direction, Measure, Penalties, Row};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::prepare::Prepared;
use crate::resolution::Resolution;

/// Steps along the neighbour graph around candidates from which lines are linked and recovered: those of
/// the faces beside a line.
const AROUND: usize = crate::recover::FACE_HOPS;

/// The candidates of a tile and the points around them; points are known by their indices in the input.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Linked {
    crease: Vec<(u32, Row)>,
    border: Vec<(u32, Row)>,
    /// Shares and directions of both penalties.
    kinds: [(f64, Direction); 2],
    around: Vec<Around>,
}

/// A point near a candidate.
#[derive(Clone, Debug, PartialEq)]
struct Around {
    point: u32,
    /// Local frame.
    position: [f64; 3],
    density: f32,
    spacing: Option<f32>,
    normal: [f32; 3],
    /// Its row of the neighbour graph; empty at the rim.
    row: Vec<u32>,
}

impl Linked {
    pub(super) fn new(cloud: &Prepared, measure: &Measure, owned: &[bool]) -> Linked {
        Linked {
            crease: rows(&measure.crease, cloud, owned),
            border: rows(&measure.border, cloud, owned),
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
        position: cloud.positions[i],
        density: measure.density[i],
        spacing: cloud.spacing_at(i),
        normal: measure.normal[i],
        row: if inner[i] { cloud.graph.of(i).iter().map(source).collect() } else { Vec::new() },
    };
    (0..owned.len()).filter(|&i| outer[i]).map(one).collect()
}

/// Joins what all tiles gave to the part of the cloud that linkers see: candidates and the points around them, in canonical order.
pub(super) fn joined(
    mut tiles: Vec<Linked>,
    (grid, frame): (&Grid, Frame),
    resolution: Resolution,
    count: usize,
) -> (Prepared, Measure) {
    let mut around: Vec<Around> = tiles.iter_mut().flat_map(|t| std::mem::take(&mut t.around)).collect();
    // Of several copies that with a row comes first.
    around.sort_by_key(|a| (a.point, a.row.is_empty()));
    around.dedup_by_key(|a| a.point);
    // Local lengths are those of the world times a power of two, so that the order is that of the points as they were read.
    let places: Vec<[f64; 3]> = around.iter().map(|a| a.position.map(|x| x * frame.scale)).collect();
    let Localised { positions, source: order, .. } = frame.of_part(&grid.at_corner(), &places);
    let mut number = vec![0; order.len()];
    order.iter().zip(0..).for_each(|(&a, n)| number[a as usize] = n);
    // The points of rows that are not empty all lie around candidates.
    let new = |point: u32| around.binary_search_by_key(&point, |a| a.point).ok().map(|a| number[a]);
    let [crease, border] = [0, 1].map(|kind| penalties(&tiles, kind, &new));
    let around: Vec<&Around> = order.iter().map(|&a| &around[a as usize]).collect();
    let mut graph = Neighbors { offsets: vec![0], indices: Vec::new() };
    for a in &around {
        graph.indices.extend(a.row.iter().filter_map(|&j| new(j)));
        graph.offsets.push(graph.indices.len() as u64);
    }
    let measure = Measure {
        density: around.iter().map(|a| a.density).collect(),
        score: vec![0.0; around.len()],
        normal: around.iter().map(|a| a.normal).collect(),
        crease,
        border,
        ..Measure::default()
    };
    let spacing = around.iter().filter_map(|a| a.spacing).collect();
    let source = around.iter().map(|a| a.point).collect();
    (Prepared::of_part(frame, (positions, source), graph, (resolution, spacing), count), measure)
}

/// The candidates of creases (0) or borders (1), with the indices that `new` gives them.
fn penalties(tiles: &[Linked], kind: usize, new: &impl Fn(u32) -> Option<u32>) -> Penalties {
    let own = |t: &'_ Linked| -> Vec<(u32, Row)> {
        let rows = if kind == 0 { &t.crease } else { &t.border };
        rows.iter().filter_map(|(point, row)| Some((new(*point)?, *row))).collect()
    };
    let mut rows: Vec<(u32, Row)> = tiles.iter().flat_map(own).collect();
    rows.sort_by_key(|(n, _)| *n);
    let (share, direction) = tiles.first().map_or_else(Default::default, |t| t.kinds[kind]);
    let mut penalties = Penalties::new(share, direction);
    rows.into_iter().for_each(|(n, row)| penalties.push(n, row));
    penalties
}
