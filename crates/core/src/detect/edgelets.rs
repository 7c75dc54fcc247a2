//! Edgelets: short pieces of edge, from cross-sections of the surface. Ours.
//!
//! Along an edge the surface does not change. `field` finds this direction at every point from the structure tensor of the
//! normals, and fits the normals anew to points in tubes along it, so that they keep to their face however narrow it is. At seeds
//! spread over the folds, `section` follows the field some spacings to either side and pools the points beside it in one plane
//! across. There `links` and `pieces` cut them to smooth pieces, and `corners` takes the places where two pieces meet at an angle.
//! `distinct` keeps those that several seeds agree on.

mod corners;
mod distinct;
mod field;
mod links;
mod moments;
mod pieces;
mod section;

use crate::neighbors::Index;
use crate::parallel;
use crate::surface::Scales;
use field::Field;
use links::Links;
use pieces::Pieces;
use section::Section;

/// Least certainty of the field at a seed.
const CERTAIN: f64 = 0.7;
/// Distance of seeds from each other, in spacings.
const APART: f64 = 1.0;

pub(crate) fn knob(name: &str, default: f64) -> f64 {
    std::env::var(name).ok().and_then(|v| v.parse().ok()).unwrap_or(default)
}

/// A short piece of edge, local frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edgelet {
    pub(crate) place: [f64; 3],
    /// Unit direction of the edge, of either sign.
    pub(crate) along: [f64; 3],
    /// Unit directions of both faces away from the edge.
    pub(crate) arms: [[f64; 3]; 2],
    /// The spacing there.
    pub(crate) spacing: f64,
    /// Standard deviation of the place across the edge.
    pub(crate) deviation: f64,
    /// By how much one smooth piece describes the section worse than two; half of it is a log likelihood.
    pub(crate) evidence: f64,
    /// Number of stations that the section pools: edgelets nearer to each other than this many spacings share points.
    pub(crate) stations: f64,
    /// Weight in means of edgelets.
    pub(crate) weight: f64,
}

/// The edgelets of a cloud that several cross-sections agree on.
pub(crate) fn edgelets(points: &[[f64; 3]], normals: &[[f32; 3]], scales: Scales) -> Vec<Edgelet> {
    let start = std::time::Instant::now();
    let index = Index::build(points);
    let field = Field::new(points, normals, &index, scales);
    let t1 = start.elapsed();
    let seeds = seeds(&field);
    let t2 = start.elapsed();
    #[derive(Default)]
    struct Scratch {
        section: Section,
        links: Links,
        pieces: Pieces,
    }
    let (e0, e1) = (knob("PIECE", 9.0), knob("PIECEN", 8.0));
    let all: Vec<Edgelet> = parallel::flat_map_with(seeds.len(), 8, |s: &mut Scratch, i, out| {
        if s.section.take(&field, seeds[i]) {
            s.links.find(&s.section.points, s.section.noise);
            let share = s.section.noise.powi(2) / pieces::variance(&s.section);
            s.pieces.cut(&s.section, &s.links, e0 + e1 * share);
            corners::corners(&s.section, &s.links, &s.pieces, out);
        }
    });
    let t3 = start.elapsed();
    let kept = distinct::distinct(&all);
    if knob("VERBOSE", 0.0) > 0.0 {
        let active = field.near.len();
        eprintln!(
            "active {active} seeds {} edgelets {} kept {} field {t1:?} seeds {t2:?} sections {t3:?} all {:?}",
            seeds.len(),
            all.len(),
            kept.len(),
            start.elapsed()
        );
    }
    if let Ok(path) = std::env::var("DUMPE") {
        let of = |i: usize, f: fn(f64, f64) -> f64| points.iter().map(|p| p[i]).fold(points[0][i], f);
        let head = (0..3).map(|i| of(i, f64::min)).chain((0..3).map(|i| of(i, f64::max))).chain([0.0; 10]);
        let rows = kept.iter().flat_map(|e| {
            e.place.into_iter().chain(e.along).chain(e.arms[0]).chain(e.arms[1]).chain([e.weight, e.deviation, e.evidence, e.stations])
        });
        let _ = std::fs::write(path, head.chain(rows).flat_map(f64::to_le_bytes).collect::<Vec<u8>>());
    }
    kept
}

/// Points at folds, in canonical order, none near an earlier one.
fn seeds(field: &Field) -> Vec<usize> {
    let apart = knob("THIN", APART);
    let mut gone = vec![false; field.points.len()];
    let mut seeds = Vec::new();
    for i in field.near.iter().map(|&i| i as usize) {
        let certain = field.along(i).is_some_and(|(_, grade)| grade >= CERTAIN);
        if certain && !gone[i] {
            let radius = apart * field.scales.at(i).spacing;
            field.index.around(field.points[i], radius, |f| gone[f.index as usize] = true);
            seeds.push(i);
        }
    }
    seeds
}
