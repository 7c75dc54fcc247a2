//! The robust form of the penalties: Gumhold 2001, section 3.1, made safe against noise, outliers and blunt folds.
//!
//! Departures from the paper, and their reasons:
//! * **Curvature.** The paper's `kappa / kappa_max` depends on the one sharpest point of the cloud. Here the fold is read
//!   from the correlation tensor of the neighbours' *normals*, `M = sum w n n^t`: two faces that fold by `phi` give it a
//!   middle eigenvalue of `sin^2(phi / 2)`, while noise and thin sheets leave it near zero. The penalty is one half where the
//!   fold is `fold_deg` and zero at twice that sine, and depends on no quantity of the whole cloud.
//! * **Direction.** The least eigenvector of `M` is the crease's direction, even where the fold is too blunt to stretch the
//!   ellipsoid of the points. An edge is penalised by its deviation from that direction.
//! * **Corner.** At a corner the least eigenvalue of `M` is large too, and no direction is preferred.
//! * **Foot.** The place of a point on its crease or corner is the place nearest to all tangent planes of the neighbourhood
//!   (the quadric error of the paper's section 4.2, along the well-determined eigenvectors of `M` only).
//! * **Narrow faces.** Where a neighbourhood holds more than two faces, only two of them are taken (`evidence/pair.rs`).
//! * **Border.** The open angle counts only if it is wider than the angle that chance leaves between as many directions, and not
//!   at an acute crease, where one face hides the other.

use super::{Derived, densities};
use crate::detect::evidence::align::{align_borders, align_creases};
use crate::detect::evidence::border::{HIDING_FOLD, border, may_be_border};
use crate::detect::evidence::crease::crease;
use crate::detect::evidence::fold::CrossSection;
use crate::detect::evidence::hops::hops;
use crate::detect::evidence::normals::{inner, normals};
use crate::detect::evidence::sides::Sides;
use crate::detect::evidence::surroundings::Surroundings;
use crate::measure::{Direction, Measure, Penalties, Row};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::parallel;
use crate::params::PenaltyParams;
use crate::surface::Scales;

/// Points that a thread takes at a time.
const BLOCK: usize = 1024;

/// The result for a block of points: a score for each, and the candidates among them.
#[derive(Default)]
struct Block {
    score: Vec<f32>,
    crease: Vec<(u32, Row)>,
    border: Vec<(u32, Row)>,
}

/// Buffers that are used again for each point.
#[derive(Default)]
struct Buffers {
    scratch: Scratch,
    angles: Vec<f64>,
    section: CrossSection,
}

/// Steps along the neighbour graph over which the values of a point are made of those of others, where neighbourhoods are `hops`
/// wide: the planes that are tried are those of neighbours, or a ring more decides (`consensus`); two bilateral passes follow (`normals`);
/// a crease looks at the normals around it and its foot is aligned with those beside it (`align`).
pub(super) fn steps(hops: usize) -> usize {
    (hops + 1) + 2 * hops + 2 * hops.max(2)
}

/// Robust penalties of every point.
pub fn penalties(
    points: &[[f64; 3]],
    graph: &Neighbors,
    scales: Scales,
    params: &PenaltyParams,
    derived: Derived,
) -> Measure {
    let normals = normals(points, graph, |i| hops(params.hops, scales.at(i)), scales);
    let surroundings = Surroundings::new(points, graph, normals, scales, params.hops, params.fold_deg);
    let mut measure = Measure {
        density: densities(points, graph),
        crease: Penalties::new(derived.alpha, Direction::Across),
        border: Penalties::new(params.gamma, Direction::Across),
        ..Default::default()
    };
    for block in blocks(points.len(), |i, buffers, block| point(&surroundings, params, i, buffers, block)) {
        measure.score.extend(block.score);
        block.crease.into_iter().for_each(|(i, row)| measure.crease.push(i, row));
        block.border.into_iter().for_each(|(i, row)| measure.border.push(i, row));
    }
    align_creases(graph, &mut measure.crease, scales, |i| surroundings.hops(i));
    align_borders(graph, &mut measure.border, scales);
    measure.normal = surroundings.normals.vectors;
    measure
}

/// The border penalties alone.
pub fn borders(points: &[[f64; 3]], graph: &Neighbors, scales: Scales, params: &PenaltyParams) -> Penalties {
    let normals = normals(points, graph, |i| hops(params.hops, scales.at(i)), scales);
    let surroundings = Surroundings::new(points, graph, normals, scales, params.hops, params.fold_deg);
    let mut penalties = Penalties::new(params.gamma, Direction::Across);
    let only_border = |i: usize, buffers: &mut Buffers, block: &mut Block| {
        if !may_be_border(points, i, graph.of(i)) {
            return;
        }
        let sides =
            Sides::around(&surroundings, i, inner(graph, i, surroundings.hops(i), &mut buffers.scratch));
        let fold = sides.fold();
        if fold < HIDING_FOLD {
            let wide = graph.hops(i, surroundings.hops(i).max(2), &mut buffers.scratch);
            let row = border(&surroundings, i, wide, fold, params, &mut buffers.angles);
            block.border.extend(row.map(|row| (i as u32, row)));
        }
    };
    for block in blocks(points.len(), only_border) {
        block.border.into_iter().for_each(|(i, row)| penalties.push(i, row));
    }
    align_borders(graph, &mut penalties, scales);
    penalties
}

/// Calls `of` with every point, block by block, in parallel.
fn blocks(count: usize, of: impl Fn(usize, &mut Buffers, &mut Block) + Sync) -> Vec<Block> {
    parallel::map_with(count.div_ceil(BLOCK), parallel::TASK, |buffers, b| {
        let mut block = Block::default();
        (b * BLOCK..((b + 1) * BLOCK).min(count)).for_each(|i| of(i, buffers, &mut block));
        block
    })
}

/// The score of a point, and its rows if it is a candidate.
fn point(
    surroundings: &Surroundings,
    params: &PenaltyParams,
    i: usize,
    buffers: &mut Buffers,
    block: &mut Block,
) {
    let Surroundings { points, graph, least_fold, .. } = surroundings;
    let hops = surroundings.hops(i);
    let Buffers { scratch, angles, section } = buffers;
    let sides = Sides::around(surroundings, i, inner(graph, i, hops, scratch));
    let fold = sides.fold();
    let penalty = 1.0 - fold / (2.0 * least_fold);
    let folded = penalty < params.candidate;
    let open = fold < HIDING_FOLD && may_be_border(points, i, graph.of(i));
    block.score.push((fold / (2.0 * least_fold)).min(1.0) as f32);
    if !folded && !open {
        return;
    }
    let wide = graph.hops(i, hops.max(2), scratch);
    if folded {
        let row = crease(surroundings, i, &sides, penalty.max(0.0), wide, section);
        block.crease.extend(row.map(|row| (i as u32, row)));
    }
    if open {
        let row = border(surroundings, i, wide, fold, params, angles);
        block.border.extend(row.map(|row| (i as u32, row)));
    }
}
