//! How well lines are known that end on nodes. Such a line is drawn from node to node: it errs as these do, which is more than the line
//! through its points does.

use crate::curve::pieces::{Piece, Shape, Sigma};
use crate::math::vec3::distance;
use crate::network::Network;
use crate::resolution::Resolution;
use crate::surface::Scales;

/// Standard deviation of a node on each axis: without noise, in spacings, and in that of the points; measured on cubes and brackets of three noises
/// and two densities by the bench `coverage`.
const NODE: [f64; 2] = [0.02, 0.76];
/// Share of a node's variance that the node at the other end of a line has in common with it: corners lie inwards, at both ends.
const COMMON: f64 = 0.25;

/// Gives lines the standard deviations of the ends that they have; local frame, sources as canonical indices.
pub(crate) fn settle(network: &mut Network, scales: Scales) {
    for strip in network.strips.iter_mut().filter(|s| !s.closed && !s.curves.is_empty()) {
        let Resolution { spacing, noise } = scales.finest(&strip.sources);
        let (last, node) = (strip.curves.len() - 1, (NODE[0] * spacing).powi(2) + (NODE[1] * noise).powi(2));
        for (k, piece) in strip.curves.iter_mut().enumerate() {
            piece.sigma = line(piece, [k == 0, k == last], node).or(piece.sigma);
        }
    }
}

/// The standard deviations of a line of which some ends are nodes with the variance `node`; `None` of others.
fn line(piece: &Piece, nodes: [bool; 2], node: f64) -> Option<Sigma> {
    let Some(Sigma::Line { offset, direction }) = piece.sigma.filter(|_| piece.shape == Shape::Line) else {
        return None;
    };
    let length = distance(piece.from, piece.to);
    // At an end that is no node the line is where its fit says.
    let fitted = offset * offset + (0.5 * direction * length).powi(2);
    let [a, b] = nodes.map(|is| if is { node } else { fitted });
    let both = if nodes == [true; 2] { COMMON * node } else { 0.0 };
    let known = Sigma::Line {
        offset: (0.25 * (a + b + 2.0 * both)).sqrt(),
        direction: (a + b - 2.0 * both).sqrt() / length,
    };
    (length > 0.0 && nodes != [false; 2]).then_some(known)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_between_nodes_errs_as_they_do_and_one_between_curves_as_its_fit() {
        let piece = Piece {
            shape: Shape::Line,
            from: [0.0; 3],
            to: [10.0, 0.0, 0.0],
            first: 0,
            last: 9,
            deviation: 0.0,
            sigma: Some(Sigma::Line { offset: 0.03, direction: 0.01 }),
        };
        let of = |nodes| match line(&piece, nodes, 0.04) {
            Some(Sigma::Line { offset, direction }) => Some([offset, direction]),
            _ => None,
        };
        assert_eq!(of([false; 2]), None);
        let [offset, direction] = of([true; 2]).unwrap();
        assert!((offset - 0.025_f64.sqrt()).abs() < 1e-12 && (direction - 0.0006_f64.sqrt()).abs() < 1e-12);
        let [half, _] = of([true, false]).unwrap();
        assert!(half > 0.1 && half < offset, "{half}");
    }
}
