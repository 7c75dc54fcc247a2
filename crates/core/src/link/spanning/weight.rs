//! Edge weights (Gumhold 2001, section 3.2, `w_c` and `w_b`).

use crate::math::vec3::{add_scaled, dot, norm, scale, sub};
use crate::measure::{Direction, Penalties};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::surface::Scales;
use rayon::prelude::*;

/// Greatest length of an edge in mean distances to the direct neighbours, at the end where those are less.
const LONGEST_EDGE: f64 = 8.0;

/// An edge between two candidates that may enter a pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// Penalty share plus length over mean density.
    pub weight: f64,
    /// Lesser candidate (index into [`Penalties`]).
    pub a: u32,
    /// Greater candidate.
    pub b: u32,
}

/// The edges between candidates at most `hops` apart in the neighbour graph whose penalty share stays below `tau`, in
/// ascending order of weight, ties by index. `density` is that of every point.
pub(crate) fn candidate_edges(
    graph: &Neighbors,
    density: &[f32],
    penalties: &Penalties,
    scales: Scales,
    tau: f64,
    hops: usize,
) -> Vec<Candidate> {
    let mut edges: Vec<Candidate> = (0..penalties.len())
        .into_par_iter()
        .with_min_len(256)
        .map_init(Scratch::default, |scratch, a| {
            let own = penalties.points[a];
            let near = graph.hops(own as usize, hops, scratch).iter().filter(|&&other| other > own);
            let edges = near.filter_map(|other| {
                let b = penalties.points.binary_search(other).ok()?;
                let density = [own, *other].map(|i| f64::from(density[i as usize]));
                weigh(penalties, a, b, density, scales.between(own, *other), tau)
            });
            edges.collect::<Vec<_>>()
        })
        .flatten_iter()
        .collect();
    edges.par_sort_unstable_by(order);
    edges
}

/// Sorts edges by ascending weight, ties by index.
pub(crate) fn sort(edges: &mut [Candidate]) {
    edges.sort_unstable_by(order);
}

fn order(x: &Candidate, y: &Candidate) -> std::cmp::Ordering {
    x.weight.total_cmp(&y.weight).then((x.a, x.b).cmp(&(y.a, y.b)))
}

/// The weight of the edge between the candidates `a` and `b`; `None` at or above `tau`, and for an
/// edge that is far longer than the sampling at its denser end: it leads to a stray point. `density` is that of both, zero
/// where unknown; `spacing` is the length of one there.
fn weigh(
    penalties: &Penalties,
    a: usize,
    b: usize,
    density: [f64; 2],
    spacing: f64,
    tau: f64,
) -> Option<Candidate> {
    let edge = sub(penalties.foot[b], penalties.foot[a]);
    let length = norm(edge);
    if length > LONGEST_EDGE * density[0].min(density[1]) && density[0].min(density[1]) > 0.0 {
        return None;
    }
    let directional: f64 = [a, b].map(|i| directional(penalties, i, edge, length, spacing)).iter().sum();
    let scalar = f64::from(penalties.scalar[a] + penalties.scalar[b]);
    // w_c with omega_kappa, omega_cr and omega_co, or w_b with omega_b2 and omega_b1: the penalties, then the length.
    let share = penalties.share * scalar + (1.0 - penalties.share) * directional;
    let weight =
        share + if density[0] + density[1] > 0.0 { 2.0 * length / (density[0] + density[1]) } else { 0.0 };
    (share < tau).then_some(Candidate { weight, a: a as u32, b: b as u32 })
}

/// The vector penalty of one end of an edge, bounded by its corner penalty.
fn directional(penalties: &Penalties, i: usize, edge: [f64; 3], length: f64, spacing: f64) -> f64 {
    let vector = penalties.vector[i].map(f64::from);
    let penalty = match penalties.direction {
        Direction::Along if length > 0.0 => dot(vector, edge).abs() / length,
        Direction::Along => 0.0,
        Direction::Across => {
            let certainty = norm(vector);
            let unit = scale(vector, 1.0 / certainty.max(1e-9));
            let across = norm(add_scaled(edge, unit, -dot(edge, unit)));
            certainty * (across / spacing).min(1.0)
        }
    };
    penalty.min(f64::from(penalties.corner[i]))
}
