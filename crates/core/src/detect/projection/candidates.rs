//! From marked points to candidates of the minimum spanning graph.
//!
//! Not in Tran 2013, which ends with points. The normals of the best scales are those of the faces right up to an edge; so
//! the tangent planes of a marked point's neighbours meet where the edge is, and run along it. The tensor of these normals,
//! in which a neighbour counts the less the more it is itself sharp, gives the line's direction, the foot on it and the
//! angle, by the same code as the robust penalties, and with it the evidence that tells a fold from a round: without that
//! evidence a linker would make lines of all the points that a threshold marks on a sphere. The scalar penalty is one less
//! the normalised score. Which points are *marked* is the paper's own affair and not touched by any of this.

use super::{Projection, project};
use crate::detect::fold::CrossSection;
use crate::detect::normals::Normals;
use crate::detect::penalty::{density, derive, robust::Context};
use crate::math::vec3::{dot, norm, sub};
use crate::measure::{Direction, Measure, Penalties, Row};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::params::Params;
use crate::resolution::Resolution;
use rayon::prelude::*;

/// How far across the line a better point makes one superfluous, spacings.
const BAND: f64 = 1.5;
/// A neighbour lies across the line rather than along it when its offset is within 45 degrees of across.
const ACROSS: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Certainty of direction below which a point is near a corner and has no across.
const NO_DIRECTION: f64 = 0.5;

/// The method's measure: marks as classes, and as candidates the ridge of the marked bands.
pub fn measure(
    points: &[[f64; 3]],
    graph: &Neighbors,
    resolution: Resolution,
    params: &Params,
) -> Measure {
    let projection = project(points, resolution, &params.projection);
    let derived = derive(&params.penalty, resolution);
    let context = Context {
        points,
        graph,
        normals: Normals {
            vectors: projection.normal.clone(),
            support: projection.marks.score.iter().map(|s| (1.0 - s).powi(2)).collect(),
        },
        resolution,
        hops: derived.hops,
        least_fold: (0.5 * params.penalty.fold_deg.to_radians()).sin(),
    };
    let marked: Vec<u32> = (0..points.len() as u32).filter(|&i| projection.marks.is_marked(i as usize)).collect();
    let rows: Vec<Row> = marked
        .par_iter()
        .with_min_len(256)
        .map_init(<(Scratch, CrossSection)>::default, |(scratch, section), &i| {
            row(&context, &projection, i as usize, scratch, section)
        })
        .collect();
    let mut crease = Penalties { share: derived.alpha, direction: Direction::Across, ..Default::default() };
    for (k, &i) in marked.iter().enumerate() {
        if is_ridge(points, graph, resolution, &projection, i as usize, rows[k].vector) {
            crease.push(i, rows[k]);
        }
    }
    Measure {
        density: (0..points.len()).into_par_iter().map(|i| density(points, graph, i) as f32).collect(),
        class: projection.marks.classes(),
        score: projection.marks.score,
        normal: projection.normal,
        crease,
        border: Penalties { direction: Direction::Across, ..Default::default() },
    }
}

fn row(
    context: &Context,
    projection: &Projection,
    i: usize,
    scratch: &mut Scratch,
    section: &mut CrossSection,
) -> Row {
    let (tensor, pull) = context.normal_tensor(i, context.graph.of(i));
    let wide = context.graph.hops(i, context.hops.max(2), scratch);
    let penalty = 1.0 - f64::from(projection.marks.score[i]);
    context.crease(i, &tensor, pull, penalty, wide, section)
}

/// Whether no neighbour across the line scores higher (or as high with a lesser index): the ridge of the score.
fn is_ridge(
    points: &[[f64; 3]],
    graph: &Neighbors,
    resolution: Resolution,
    projection: &Projection,
    i: usize,
    direction: [f32; 3],
) -> bool {
    let direction = direction.map(f64::from);
    let certainty = norm(direction);
    if certainty < NO_DIRECTION {
        return true;
    }
    let score = &projection.marks.score;
    !graph.of(i).iter().map(|&j| j as usize).any(|j| {
        let offset = sub(points[j], points[i]);
        let (length, along) = (norm(offset), dot(offset, direction) / certainty);
        let across = (length * length - along * along).max(0.0).sqrt();
        let higher = score[j] > score[i] || (score[j] == score[i] && j < i);
        higher && across > ACROSS * length && across < BAND * resolution.spacing
    })
}
