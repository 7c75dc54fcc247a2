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
/// Spacings below this have squares that vanish in f64.
const SQUARABLE_SPACING: f64 = 1e-140;

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
    refuse_tiny(&frame, &positions)?;
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
    let origin = positions[0];
    let farthest = positions
        .iter()
        .map(|&p| sub(p, origin))
        .fold([0.0; 3], |best, d| if norm(d) > norm(best) { d } else { best });
    let length = norm(farthest);
    let off_line =
        positions.iter().any(|&p| norm(cross(farthest, sub(p, origin))) > COLLINEAR * length * length);
    if off_line { Ok(()) } else { Err(Error::Collinear { distinct: positions.len() }) }
}

fn refuse_tiny(frame: &Frame, positions: &[[f64; 3]]) -> Result<(), Error> {
    if frame.scale >= SQUARABLE_SPACING {
        return Ok(());
    }
    let side = |axis: usize| frame.length_to_world(positions.iter().map(|p| p[axis]).fold(0.0, f64::max));
    let axis = (1..3).fold(0, |best, axis| if side(axis) > side(best) { axis } else { best });
    let min = frame.offset[axis];
    Err(Error::Extent { axis, min, max: min + side(axis) })
}
