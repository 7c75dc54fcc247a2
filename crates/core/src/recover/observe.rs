//! All lines and circles of a network as the faces beside them show them, for the relations between them.

use super::faces::{Fitted, Lengths, near, of_piece};
use crate::curve::pieces::{Observed, Piece, Shape};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::network::{Network, Strip, StripKind};
use crate::parallel;
use crate::surface::Scales;

/// For each strip and each of its curves the line or circle along the faces beside it, or else through the strip's points; `None` for
/// splines and where nothing determines it. Local frame, sources as canonical indices.
pub(crate) fn observe(
    network: &Network,
    points: &[[f64; 3]],
    graph: &Neighbors,
    scales: Scales,
) -> Vec<Vec<Option<Observed>>> {
    let strips = &network.strips;
    parallel::map_with(strips.len(), parallel::TASK, |scratch: &mut Scratch, s| {
        let strip = &strips[s];
        let has_faces = strip.kind == StripKind::Crease
            && strip.curves.iter().any(|p| !matches!(p.shape, Shape::Ellipse { .. } | Shape::Spline(_)));
        let beside = if has_faces { near(strip, graph, scratch) } else { Vec::new() };
        let beside: Vec<[f64; 3]> = beside.iter().map(|&i| points[i as usize]).collect();
        let lengths = Lengths::of(scales.finest(&strip.sources));
        let by_faces = |p: &Piece| of_piece(p, &beside, lengths).and_then(|f| observed(&f));
        // Circles were laid along their faces already, if these showed any.
        let laid = |p: &Piece| matches!(p.shape, Shape::Circle(_));
        let faced = |p: &Piece| if laid(p) { None } else { by_faces(p) };
        let one = |p: &Piece| faced(p).or_else(|| Observed::of(p, &row(strip, p)));
        strip.curves.iter().map(one).collect()
    })
}

/// The points of a strip that a piece stands for.
fn row(strip: &Strip, piece: &Piece) -> Vec<[f64; 3]> {
    let n = strip.points.len();
    let last = if piece.last <= piece.first { piece.last + n } else { piece.last };
    (piece.first..=last).map(|k| strip.points[k % n]).collect()
}

fn observed(fitted: &Fitted) -> Option<Observed> {
    let covariance: [[f64; 6]; 6] = std::array::from_fn(|i| std::array::from_fn(|j| fitted.covariance[i][j]));
    let sound = covariance.iter().flatten().all(|x| x.is_finite());
    let (free, axes, half) = (fitted.sweep.free(), fitted.sweep.axes(), fitted.sweep.half());
    sound.then_some(Observed { free, axes, half, covariance })
}
