//! Contours cut where no point of the cloud is near.
//!
//! The points of a slab come from above and below the plane, so that a contour may run through a gap that both sides end at: a wall
//! that a scanner could not see behind a balcony, a hole. There it is drawn by the sides' planes alone. A stretch with no point
//! near it is left out, and a closed contour opens.

use super::chain::{Chain, Vertex};
use crate::math::vec2::{along, distance, sub};

/// Shortest stretch that is left out, spacings: the way over a corner is shorter.
const STRETCH: f64 = 2.0;
/// Longest distance between the places looked at, spacings.
const STEP: f64 = 1.0;

/// A place on a chain.
struct Place {
    vertex: Vertex,
    /// Whether it is a vertex of the chain, not one between two of them.
    own: bool,
    near: bool,
}

/// The pieces of a chain that are left without the stretches at which no place is `near`.
pub(crate) fn cut(chain: Chain, near: impl Fn([f64; 2]) -> bool) -> Vec<Chain> {
    let mut places = places(&chain, near);
    if chain.closed {
        // From a place that is near, so that no stretch runs over the beginning.
        let first = places.iter().position(|p| p.near).unwrap_or(0);
        places.rotate_left(first);
    }
    for stretch in places.chunk_by_mut(|a, b| a.near == b.near) {
        let length: f64 = stretch.windows(2).map(|w| distance(w[0].vertex.at, w[1].vertex.at)).sum();
        let short = length < STRETCH * stretch[0].vertex.spacing;
        stretch.iter_mut().for_each(|p| p.near |= short);
    }
    let Some(far) = places.iter().position(|p| !p.near) else { return vec![chain] };
    if chain.closed {
        places.rotate_left(far);
    }
    places.chunk_by(|a, b| a.near == b.near).filter(|piece| piece[0].near).map(piece).collect()
}

/// The vertices of a chain and places between them.
fn places(chain: &Chain, near: impl Fn([f64; 2]) -> bool) -> Vec<Place> {
    let n = chain.vertices.len();
    let mut places = Vec::new();
    for (i, &vertex) in chain.vertices.iter().enumerate() {
        places.push(Place { vertex, own: true, near: near(vertex.at) });
        if i + 1 == n && !chain.closed {
            break;
        }
        let step = sub(chain.vertices[(i + 1) % n].at, vertex.at);
        let parts = (distance(step, [0.0; 2]) / (STEP * vertex.spacing)).ceil();
        for k in 1..parts as usize {
            let at = along(vertex.at, step, k as f64 / parts);
            places.push(Place { vertex: Vertex::new(at, vertex.spacing), own: false, near: near(at) });
        }
    }
    places
}

/// A chain of the vertices of a stretch, and of its ends where they lie between two.
fn piece(stretch: &[Place]) -> Chain {
    let end = |k: usize| k == 0 || k + 1 == stretch.len();
    let kept = stretch.iter().enumerate().filter(|(k, p)| p.own || end(*k));
    Chain { vertices: kept.map(|(_, p)| p.vertex).collect(), closed: false }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Chain {
        let side = |from: [f64; 2], way: [f64; 2]| {
            (0..20).map(move |k| Vertex::new(along(from, way, k as f64), 1.0))
        };
        let [a, b, c, d] = [[0.0, 0.0], [20.0, 0.0], [20.0, 20.0], [0.0, 20.0]];
        let ways = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
        let vertices = [a, b, c, d].into_iter().zip(ways).flat_map(|(from, way)| side(from, way)).collect();
        Chain { vertices, closed: true }
    }

    #[test]
    fn a_closed_contour_opens_where_nothing_is_near() {
        let gap = |p: [f64; 2]| p[1] == 0.0 && (5.2..11.3).contains(&p[0]);
        let pieces = cut(square(), |p| !gap(p));
        assert_eq!(pieces.len(), 1);
        assert!(!pieces[0].closed);
        let [first, last] = [pieces[0].vertices[0].at, pieces[0].vertices.last().unwrap().at];
        assert_eq!([first, last], [[12.0, 0.0], [5.0, 0.0]]);
        assert!((pieces[0].length() - 73.0).abs() < 1e-9);
    }

    #[test]
    fn a_gap_at_the_beginning_is_one_gap() {
        let pieces = cut(square(), |p| p[0] + p[1] > 5.2);
        assert_eq!(pieces.len(), 1);
        assert!((pieces[0].length() - 68.0).abs() < 1e-9);
    }

    #[test]
    fn open_contours_fall_into_pieces_and_lose_their_ends() {
        let open = Chain { closed: false, ..square() };
        let gap = |p: [f64; 2]| p[0] < 4.2 && p[1] == 0.0 || p[0] == 20.0 && (8.2..12.3).contains(&p[1]);
        assert_eq!(cut(open, |p| !gap(p)).len(), 2);
    }

    #[test]
    fn a_short_gap_and_no_gap_change_nothing() {
        assert_eq!(cut(square(), |_| true), [square()]);
        assert_eq!(cut(square(), |p| p[0] + p[1] > 0.8), [square()]);
        assert_eq!(cut(square(), |_| false), []);
    }
}
