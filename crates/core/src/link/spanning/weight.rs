//! The edge weights `w_c` and `w_b` of the minimum spanning graph (Gumhold 2001, section 3.2).

use crate::math::vec3::{add_scaled, dot, norm, scale, sub};
use crate::measure::{Direction, Penalties};
use crate::neighbors::{Neighbors, riemannian::Scratch};
use crate::parallel;
use crate::surface::Scales;
use rayon::prelude::*;

/// Greatest length of an edge, in units of the lesser of the average neighbour distances (`mu`) at its ends.
const LONGEST_EDGE: f64 = 8.0;

/// An edge between two candidates that may enter a pattern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// `w_c` or `w_b`: penalty share plus length term.
    pub weight: f64,
    /// Lesser candidate (index into [`Penalties`]).
    pub a: u32,
    /// Greater candidate.
    pub b: u32,
}

/// The edges between candidates at most `hops` apart in the neighbour graph whose penalty share is below `tau`, in ascending
/// order of weight, ties by index. `density` is the average neighbour distance (`mu`) of every point.
pub(crate) fn candidate_edges(
    graph: &Neighbors,
    density: &[f32],
    penalties: &Penalties,
    scales: Scales,
    tau: f64,
    hops: usize,
) -> Vec<Candidate> {
    let mut edges =
        parallel::flat_map_with(penalties.len(), parallel::SLOW, |scratch: &mut Scratch, a, edges| {
            let own = penalties.points[a];
            let near = graph.hops(own as usize, hops, scratch).iter().filter(|&&other| other > own);
            edges.extend(near.filter_map(|other| {
                let b = penalties.points.binary_search(other).ok()?;
                let density = [own, *other].map(|i| f64::from(density[i as usize]));
                weigh(penalties, a, b, density, scales.between(own, *other), tau)
            }));
        });
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

/// The edge between the candidates `a` and `b` with its weight; `None` if its penalty share reaches `tau`, or if it is far
/// longer than the sampling at its denser end, as it then leads to a stray point. `density` holds the `mu` of both ends, zero
/// where unknown; `spacing` is the local spacing.
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
    // w_c = alpha (omega_kappa of both ends) + (1 - alpha) (min of |omega_cr . e| and omega_co of both ends) + length term;
    // w_b the same with gamma, omega_b2 and omega_b1. The length term is 2 |e| / (mu(p) + mu(q)).
    let share = penalties.share * scalar + (1.0 - penalties.share) * directional;
    let weight = share + length_term(length, density);
    (share < tau).then_some(Candidate { weight, a: a as u32, b: b as u32 })
}

/// The part of a weight that grows with the length of the edge; `density` is `mu` at both ends, zero where unknown.
pub(crate) fn length_term(length: f64, density: [f64; 2]) -> f64 {
    let sum = density[0] + density[1];
    if sum > 0.0 { 2.0 * length / sum } else { 0.0 }
}

/// The directional penalty of one end of an edge, at most its corner penalty.
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
