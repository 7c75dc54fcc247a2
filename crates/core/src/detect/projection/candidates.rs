//! From marked points to candidates for the minimum spanning graph. Not in Tran 2013, which ends with marked points; the marks
//! are not changed here.
//!
//! Candidates are all points above a share of the threshold, so that a line is not cut where the sampling keeps off the edge,
//! noise hides it or it is blunt; points that are not on a crease fail the tests below. A candidate's scalar penalty is one half
//! at the threshold and falls as its score rises. Its direction and foot come from the tensor of the normals around it, as in
//! the robust penalties, with two differences: a sharp neighbour has little weight, as its plane is not that of a face; and of
//! a band of candidates only the ridge of the score is kept. The evidence that tells a fold from a round is taken in the same
//! way; without it a linker would make lines of all the points that a threshold marks on a sphere.
//!
//! A border lies in the plane of its face and has no projected distance, so Tran's method does not mark it. Border lines are
//! those of the robust penalties; they do not count for the marks.

use super::{Projection, marks::Marks, project};
use crate::detect::evidence::align::{NO_DIRECTION, align_borders, align_creases};
use crate::detect::evidence::border::{HIDING_FOLD, border, may_be_border};
use crate::detect::evidence::crease::crease;
use crate::detect::evidence::fold::CrossSection;
use crate::detect::evidence::normals::normals;
use crate::detect::evidence::sides::{FOLDED, Sides};
use crate::detect::evidence::surroundings::Surroundings;
use crate::detect::penalty::{densities, derive};
use crate::math::vec3::{dot, norm, sub};
use crate::measure::{Direction, Measure, Penalties, Row};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::parallel;
use crate::params::{Auto, Params, PenaltyParams};
use crate::resolution::Resolution;

/// Share of the threshold that makes a point a candidate.
const CANDIDATE_SHARE: f64 = 0.25;
/// Distances across the line, spacings: up to the lesser, feet belong to the same line in any case, and from the greater on to
/// two lines.
const BAND: (f64, f64) = (0.3, 1.5);
/// Share of an offset at right angles to the line above which a foot lies beside the line rather than along it: 45 degrees.
const ACROSS: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// The method's measure: classes from the marks, and candidates along the ridges of the score. `points` in canonical order,
/// local frame; `graph` is the Riemannian graph.
pub fn measure(points: &[[f64; 3]], graph: &Neighbors, resolution: Resolution, params: &Params) -> Measure {
    let Projection { marks, normal, .. } = project(points, resolution, &params.projection);
    let derived = derive(&params.penalty, resolution);
    let mut faces = normals(points, graph, |_| derived.hops, resolution);
    faces.support = marks.score.iter().map(|s| (1.0 - s).powi(2)).collect();
    let surroundings = Surroundings::new(
        points,
        graph,
        faces,
        resolution,
        Auto::Given(derived.hops),
        params.penalty.fold_deg,
    );
    let rows = rows(&surroundings, &marks, &params.penalty);
    let folds: Vec<(u32, Row)> = rows.iter().filter_map(|r| Some((r.0, r.1?))).collect();
    let mut crease = Penalties::new(derived.alpha, Direction::Across);
    for fold in folds.iter().filter(|fold| is_ridge(graph, resolution, &marks, &folds, fold)) {
        crease.push(fold.0, fold.1);
    }
    align_creases(graph, &mut crease, resolution.into(), |_| derived.hops);
    let mut border = Penalties::new(params.penalty.gamma, Direction::Across);
    rows.iter().filter_map(|r| Some((r.0, r.2?))).for_each(|(i, row)| border.push(i, row));
    align_borders(graph, &mut border, resolution.into());
    let class = Some(marks.classes());
    Measure {
        density: densities(points, graph),
        class,
        score: marks.score,
        normal,
        crease,
        border,
        ..Measure::default()
    }
}

/// A point that may lie on a crease, on a border, or on either.
type Candidate = (u32, Option<Row>, Option<Row>);

/// The candidates of creases where the surface folds, and those of borders, ascending, with their penalties.
fn rows(surroundings: &Surroundings, marks: &Marks, params: &PenaltyParams) -> Vec<Candidate> {
    let Surroundings { points, graph, least_fold, .. } = surroundings;
    type Buffers = (Scratch, CrossSection, Vec<f64>);
    parallel::flat_map_with(
        points.len(),
        parallel::QUICK,
        |(scratch, section, angles): &mut Buffers, i, out| {
            let hops = surroundings.hops(i).max(2);
            let may_be_border = may_be_border(points, i, graph.of(i));
            let score = f64::from(marks.score[i]);
            let is_crease = score > CANDIDATE_SHARE * marks.threshold;
            if !is_crease && !may_be_border {
                return;
            }
            let sides = Sides::around(surroundings, i, graph.hops(i, hops - 1, scratch));
            let fold = sides.fold();
            let wide = graph.hops(i, hops, scratch);
            let penalty = marks.threshold / (score + marks.threshold);
            let crease = (is_crease && fold > FOLDED * least_fold)
                .then(|| crease(surroundings, i, &sides, penalty, wide, section))
                .flatten();
            let border = (may_be_border && fold < HIDING_FOLD)
                .then(|| border(surroundings, i, wide, fold, params, angles))
                .flatten();
            if is_crease || border.is_some() {
                out.push((i as u32, crease, border));
            }
        },
    )
}

/// Whether the point is on the ridge of the score: no neighbour with a foot beside it, across the line, has a higher score (or
/// the same score and a lesser index) and is at least as sharp. Sharpness counts because on a sheet about as thin as the
/// spacing the greatest scores are not at the rims.
fn is_ridge(
    graph: &Neighbors,
    resolution: Resolution,
    marks: &Marks,
    folds: &[(u32, Row)],
    (own, row): &(u32, Row),
) -> bool {
    let direction = row.vector.map(f64::from);
    let certainty = norm(direction);
    if certainty < NO_DIRECTION {
        return true;
    }
    let score = |i: u32| marks.score[i as usize];
    let higher = |j: u32| score(j) > score(*own) || (score(j) == score(*own) && j < *own);
    let sharpness = |row: &Row| row.evidence.map_or(0.0, |e| e.sharp / e.expected.max(f32::MIN_POSITIVE));
    let band = BAND.0 * resolution.unit()..BAND.1 * resolution.unit();
    let beside = |other: &Row| {
        let offset = sub(other.foot, row.foot);
        let (length, along) = (norm(offset), dot(offset, direction) / certainty);
        let across = (length * length - along * along).max(0.0).sqrt();
        across > ACROSS * length && band.contains(&across) && sharpness(other) >= sharpness(row)
    };
    let near = graph.of(*own as usize).iter().filter(|&&j| higher(j));
    !near.filter_map(|j| folds.binary_search_by_key(j, |f| f.0).ok()).any(|k| beside(&folds[k].1))
}
