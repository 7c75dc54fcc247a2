//! The pipeline over tiles.

use super::found::Found;
use super::linked::joined;
use super::plan::Plan;
use super::points::Points;
use super::run::Run;
use crate::classify::classes_of;
use crate::error::Error;
use crate::extract::placed;
use crate::measure::Class;
use crate::method;
use crate::network::Network;
use crate::params::Params;
use crate::prepare::SURFACE_POINTS;
use crate::relation::Related;
use crate::resolution::Resolution;
use crate::surface::Scales;

/// The result of [`extract`].
#[derive(Clone, Debug)]
pub struct Tiled {
    /// The network, world frame, sources as indices of the input.
    pub network: Network,
    /// The relations between its typed curves.
    pub related: Related,
    /// Spacing and noise of the points on surfaces, in the unit of the input.
    pub resolution: Resolution,
    /// Points on surfaces.
    pub points: usize,
    /// `(T)` most points that each tile of the plan held at a time, its margin included.
    pub held: Vec<usize>,
    lines: Lines,
}

/// The network in the local frame with the scales of its sources.
#[derive(Clone, Debug)]
struct Lines {
    network: Network,
    mean: Resolution,
    spacing: Vec<f32>,
}

impl Tiled {
    /// `(M)` class of each of a tile's own points on surfaces, from the lines beside it.
    pub fn classes(&self, found: &Found) -> Vec<Class> {
        let Lines { network, mean, spacing } = &self.lines;
        let own = Scales::new(*mean, &found.spacing);
        classes_of(&found.position, own, network, Scales::new(*mean, spacing))
    }
}

/// Extracts the feature network of points tile by tile: bit by bit that of [`extract`](crate::extract()). `plan` is made of
/// the histogram of the same points, and `take` gets the measure of each tile's own points, in the order of the tiles.
///
/// # Errors
/// Those of [`extract`](crate::extract()), except that collinear points give a network without strips; those of the points; and
/// [`Error::Parameter`] for what does not run over tiles yet: other methods than `penalty`, its form as printed, recovery from
/// wedges and patches.
pub fn extract(
    points: &impl Points,
    params: &Params,
    plan: &Plan,
    mut take: impl FnMut(Found),
) -> Result<Tiled, Error> {
    params.check()?;
    method::refuse_tiles(params)?;
    let read = points.count();
    let (mut run, counts) = Run::new(points, params, plan)?;
    enough(read, counts.iter().sum())?;
    let all = run.all();
    let mean = run.resolution(&counts, all)?;
    let kept = run.kept(mean, counts)?;
    let (resolution, count) = run.after(&kept)?;
    enough(read, count)?;
    let tiles = if kept.none { Vec::new() } else { run.detect(&kept, resolution, &mut take)? };
    let (cloud, mut measure) = joined(tiles, (&plan.grid, run.frame), resolution, count);
    let (pattern, _) = method::link(&cloud, &mut measure, params);
    let mut network = method::recovered(&cloud, &measure, &pattern, params);
    let related = method::related(&cloud, &mut network, params);
    let spacing = (0..cloud.positions.len()).filter_map(|i| cloud.spacing_at(i)).collect();
    let lines = Lines { network: network.clone(), mean: resolution, spacing };
    let (network, related, _) = placed(network, related, &run.frame, &cloud.source);
    let world = |length: f64| run.frame.length_to_world(length);
    let Resolution { spacing, noise } = resolution;
    let resolution = Resolution { spacing: world(spacing), noise: world(noise) };
    Ok(Tiled { network, related, resolution, points: count, held: run.held, lines })
}

fn enough(read: usize, distinct: usize) -> Result<(), Error> {
    match distinct < SURFACE_POINTS {
        true => Err(Error::TooFewPoints { read, distinct, needed: SURFACE_POINTS }),
        false => Ok(()),
    }
}
