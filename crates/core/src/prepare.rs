//! What every method begins from: the cloud in its local frame, the neighbour graph, spacing and noise.

use crate::cloud::Cloud;
use crate::error::Error;
use crate::frame::{Frame, Localised};
use crate::math::vec3::{cross, norm, sub};
use crate::neighbors::{Neighbors, all_nearest, riemannian};
use crate::params::{Auto, Params};
use crate::report::{Clock, Report, Stage};
use crate::resolution::Resolution;

/// Fewest distinct points that can lie on a surface.
const SURFACE_POINTS: usize = 4;
/// Share of the extent within which points are on one line.
const COLLINEAR: f64 = 1e-9;

/// A cloud ready for a detector: distinct points in canonical order, local frame.
pub(crate) struct Prepared {
    /// World frame to local frame.
    pub(crate) frame: Frame,
    /// `(M, 3)` positions.
    pub(crate) positions: Vec<[f64; 3]>,
    /// `(M)` for each point its index in the input.
    pub(crate) source: Vec<u32>,
    /// `(N)` for each point of the input its canonical index; `u32::MAX` if it was dropped.
    pub(crate) canonical: Vec<u32>,
    /// The Riemannian graph.
    pub(crate) graph: Neighbors,
    /// Spacing and noise, the noise as given where a parameter gives it.
    pub(crate) resolution: Resolution,
    dropped: usize,
    merged: usize,
}

/// Localises a cloud, refuses it if it has no surface, joins its points to a graph and estimates its resolution.
///
/// # Errors
/// [`Error::TooFewPoints`], [`Error::Collinear`], [`Error::Extent`] or [`Error::TooManyPoints`].
pub(crate) fn prepare(world: &Cloud, params: &Params, clock: &mut Clock) -> Result<Prepared, Error> {
    let (canonical, local) =
        clock.run(Stage::Localise, || Frame::localise(world).map(|local| (local.canonical(), local)))?;
    let merged = local.merged();
    let Localised { frame, positions, source, dropped, .. } = local;
    refuse_degenerate(world.len(), &positions)?;
    let (resolution, graph) = clock.run(Stage::Neighbors, || {
        let nearest = all_nearest(&positions, params.neighbors.k);
        let graph = riemannian::graph(&positions, &nearest);
        (Resolution::estimate(&positions, &nearest, &graph), graph)
    });
    let resolution = match params.penalty.noise_spacings {
        Auto::Given(ratio) => Resolution { noise: ratio * resolution.spacing, ..resolution },
        Auto::Auto => resolution,
    };
    Ok(Prepared { frame, positions, source, canonical, graph, resolution, dropped, merged })
}

impl Prepared {
    /// Counts and estimates; stages, settings and notes are still empty.
    pub(crate) fn report(&self) -> Report {
        Report {
            read: self.canonical.len(),
            dropped: self.dropped,
            merged: self.merged,
            points: self.positions.len(),
            spacing: self.frame.length_to_world(self.resolution.spacing),
            noise: self.frame.length_to_world(self.resolution.noise),
            ..Report::default()
        }
    }
}

fn refuse_degenerate(read: usize, positions: &[[f64; 3]]) -> Result<(), Error> {
    if positions.len() < SURFACE_POINTS {
        return Err(Error::TooFewPoints { read, distinct: positions.len(), needed: SURFACE_POINTS });
    }
    // A point far out makes a line of all others: then the nearer half of the points decides.
    let off_line =
        beside_line(positions, COLLINEAR) || beside_line(&nearer_half(positions), 10.0 * COLLINEAR);
    if off_line { Ok(()) } else { Err(Error::Collinear { distinct: positions.len() }) }
}

/// Whether points lie beside the line from the first to the one farthest from it, by more than `share` of its length.
fn beside_line(positions: &[[f64; 3]], share: f64) -> bool {
    let Some(&origin) = positions.first() else { return false };
    let farthest = positions
        .iter()
        .map(|&p| sub(p, origin))
        .fold([0.0; 3], |best, d| if norm(d) > norm(best) { d } else { best });
    let length = norm(farthest);
    positions.iter().any(|&p| norm(cross(farthest, sub(p, origin))) > share * length * length)
}

/// The half of the points that lies nearer to the median of each axis.
fn nearer_half(positions: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let half = positions.len().div_ceil(2);
    let median = |axis: usize| {
        let mut along: Vec<f64> = positions.iter().map(|p| p[axis]).collect();
        *along.select_nth_unstable_by(half - 1, f64::total_cmp).1
    };
    let middle = [median(0), median(1), median(2)];
    let mut near = positions.to_vec();
    near.sort_by(|&a, &b| norm(sub(a, middle)).total_cmp(&norm(sub(b, middle))));
    near.truncate(half);
    near
}
