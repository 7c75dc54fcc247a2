//! The pipeline: from a cloud to its feature network.

mod holes;

use crate::classify::classes;
use crate::error::Error;
use crate::frame::Frame;
use crate::measure::{Class, Measure};
use crate::mesh::Fold;
use crate::method::{self, ClusterStages};
use crate::neighbors::Neighbors;
use crate::network::{Network, Strip};
use crate::params::Params;
use crate::patch::{NO_PATCH, Patches};
use crate::pattern::Pattern;
use crate::prepare::{Prepared, prepare};
use crate::recover::to_world;
use crate::relation::Related;
use crate::report::{Clock, Progress, Report, Stage};
use crate::resolution::Resolution;
use crate::stages::Stages;

/// Extracts the feature network of a cloud, or of `(N, 3)` positions in the world frame that are held elsewhere.
///
/// # Errors
/// [`Error::Parameter`] for a value out of range; [`Error::TooFewPoints`], [`Error::Collinear`], [`Error::Extent`] or
/// [`Error::TooManyPoints`] for a cloud without a surface, or one beyond the limits.
pub fn extract(world: &(impl AsRef<[[f64; 3]]> + ?Sized), params: &Params) -> Result<Extraction, Error> {
    extract_observed(world, params, &|_| ())
}

/// As [`extract`]; `observe` is called when each stage begins and ends.
///
/// # Errors
/// As [`extract`].
pub fn extract_observed(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    params: &Params,
    observe: &(dyn Fn(Progress) + Sync),
) -> Result<Extraction, Error> {
    extract_sampled(world, &[], params, observe)
}

/// As [`extract_observed`], of points sampled on a mesh, whose `folds` in the world frame the default method takes for creases.
///
/// # Errors
/// As [`extract`].
pub fn extract_sampled(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    folds: &[Fold],
    params: &Params,
    observe: &(dyn Fn(Progress) + Sync),
) -> Result<Extraction, Error> {
    pipeline(world.as_ref(), folds, params, observe, false, &|cloud| Ok(method::detect(cloud, params)))
}

/// As [`extract_sampled`], with the steps of the method in [`Extraction::stages`]. They take about as long as linking and recovery
/// do.
///
/// # Errors
/// As [`extract`].
pub fn extract_staged(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    folds: &[Fold],
    params: &Params,
    observe: &(dyn Fn(Progress) + Sync),
) -> Result<Extraction, Error> {
    pipeline(world.as_ref(), folds, params, observe, true, &|cloud| Ok(method::detect(cloud, params)))
}

/// As [`extract`], with a detector of one's own and the linker of the method `penalty`. `detect` gets the positions (distinct
/// points on surfaces in canonical order, local frame), their neighbour graph, and the mean spacing and the noise.
///
/// # Errors
/// As [`extract`], and [`Error::Measure`] for a measure whose rows do not match the points or whose values are out of range.
pub fn extract_with(
    world: &(impl AsRef<[[f64; 3]]> + ?Sized),
    params: &Params,
    detect: impl Fn(&[[f64; 3]], &Neighbors, Resolution) -> Measure,
) -> Result<Extraction, Error> {
    let params = method::with_own_detector(params);
    pipeline(world.as_ref(), &[], &params, &|_| (), false, &|cloud| {
        let measure = detect(&cloud.positions, &cloud.graph, cloud.resolution);
        measure.check(cloud.positions.len(), method::wants_patches(&params))?;
        Ok(measure)
    })
}

fn pipeline(
    world: &[[f64; 3]],
    folds: &[Fold],
    params: &Params,
    observe: &(dyn Fn(Progress) + Sync),
    staged: bool,
    detect: &dyn Fn(&Prepared) -> Result<Measure, Error>,
) -> Result<Extraction, Error> {
    params.check()?;
    let mut clock = Clock::new(observe);
    let cloud = prepare(world, params, &mut clock)?.with_folds(folds);
    let mut measure = clock.run(Stage::Detect, || detect(&cloud))?;
    let (mut pattern, clusters) = clock.run(Stage::Link, || method::link(&cloud, &mut measure, params));
    let mut network = clock.run(Stage::Recover, || method::recovered(&cloud, &measure, &pattern, params));
    let patches = method::wants_patches(params).then(|| {
        clock.run(Stage::Patches, || method::patches(&cloud, &measure, &mut pattern, &mut network, params))
    });
    let related = clock.run(Stage::Relations, || method::related(&cloud, &mut network, params));
    let stages = staged.then(|| method::stages(&cloud, &measure, &pattern, params)).flatten();
    let class = measure.class.clone().unwrap_or_else(|| classes(&cloud.positions, &network, cloud.scales()));
    method::round_off(&cloud, &mut network, &pattern, params);
    let mut report = cloud.report();
    report.stages = clock.stages;
    report.settings = method::settings(&cloud, params);
    report.used = method::used(&cloud, params);
    report.notes.extend(method::notes(&cloud, clusters.as_ref(), params));
    let Prepared { frame, source, canonical, clutter, .. } = cloud;
    let (network, related, stay) = placed(network, related, &frame, &source);
    let patches = patches.map(|p| p.placed(&frame).of_strips(&stay));
    Ok(Extraction {
        report,
        frame,
        source,
        canonical,
        clutter,
        measure,
        class,
        pattern,
        clusters,
        stages,
        network,
        related,
        patches,
    })
}

/// Takes a network and the relations in it to the world frame; tells whether each strip stays.
pub(crate) fn placed(
    network: Network,
    related: Related,
    frame: &Frame,
    source: &[u32],
) -> (Network, Related, Vec<bool>) {
    let ends: Vec<_> = network.strips.iter().map(|s| [s.start, s.end]).collect();
    let (network, stay) = to_world(network, frame, source, related.regularised.is_some());
    let met = |n: usize| ends.iter().zip(&stay).any(|(e, &s)| s && e.contains(&Some(n as u32)));
    (network, related.placed(frame).of_strips(&stay, met), stay)
}

/// The results of [`extract`], stage by stage.
#[derive(Clone, Debug)]
pub struct Extraction {
    /// Counts, estimates and times.
    pub report: Report,
    /// World frame to local frame.
    pub frame: Frame,
    /// `(M)` index in the input of each point kept, in canonical order.
    pub source: Vec<u32>,
    /// `(N)` canonical index of each input point; `u32::MAX` if it was dropped or is clutter.
    pub canonical: Vec<u32>,
    /// Points of the input that lie on no surface, ascending.
    pub clutter: Vec<u32>,
    /// The detector's measure of every point kept, canonical order, local frame.
    pub measure: Measure,
    /// `(M)` class of each point kept, canonical order: from the detector, or else from the network.
    pub class: Vec<Class>,
    /// The linker's pattern, canonical indices, local frame.
    pub pattern: Pattern,
    /// The steps of the method `segments`, canonical indices, local frame; `None` with other methods.
    pub clusters: Option<ClusterStages>,
    /// The steps of the methods `penalty` and `projection`; `None` with other methods, and unless [`extract_staged`] was called.
    pub stages: Option<Stages>,
    /// The result, world frame, sources as indices of the input.
    pub network: Network,
    /// The relations between the typed curves of the network, and what their imposition moved.
    pub related: Related,
    /// The patches between the strips, world frame; `None` if they were not asked for.
    pub patches: Option<Patches>,
}

impl Extraction {
    /// Leaves only the strips that `keep` says, with the nodes that they have; those of less strips than before become of another
    /// kind. The classes of points stay.
    pub fn choose(&mut self, keep: impl Fn(&Strip) -> bool) {
        let stay: Vec<bool> = self.network.strips.iter().map(keep).collect();
        self.keep(&stay);
    }

    /// As [`choose`](Extraction::choose), leaves out the borders around holes in the surface that are shorter than `length`, in
    /// the unit of `world`, the `(N, 3)` positions of the input. Such a border is a closed line, or several that meet two by two, from
    /// which the surface leads outwards: the edge of missing data, or of an opening as small.
    pub fn choose_holes(&mut self, world: &[[f64; 3]], length: f64) {
        let positions = self.source.iter().filter_map(|&i| world.get(i as usize));
        let local: Vec<[f64; 3]> = positions.map(|&p| self.frame.to_local(p)).collect();
        let holes = holes::holes(&self.network, &local, |p| self.frame.to_local(p));
        let stay: Vec<bool> = holes.iter().map(|hole| hole.is_none_or(|around| around >= length)).collect();
        self.keep(&stay);
    }

    fn keep(&mut self, stay: &[bool]) {
        let kept = self.network.keep(stay);
        self.related = std::mem::take(&mut self.related).of_strips(stay, |n| kept[n]);
        self.patches = self.patches.take().map(|patches| patches.of_strips(stay));
    }

    /// `(N)` class of every point of the input, in its order; dropped points are smooth.
    pub fn classes(&self) -> Vec<Class> {
        let of = |&c: &u32| self.class.get(c as usize).copied().unwrap_or_default();
        let mut classes: Vec<Class> = self.canonical.iter().map(of).collect();
        self.clutter.iter().for_each(|&i| classes[i as usize] = Class::Clutter);
        classes
    }

    /// `(N)` score of every point of the input, in its order, 0 to 1; NaN for dropped points, zero for clutter.
    pub fn scores(&self) -> Vec<f32> {
        let of = |&c: &u32| self.measure.score.get(c as usize).copied().unwrap_or(f32::NAN);
        let mut scores: Vec<f32> = self.canonical.iter().map(of).collect();
        self.clutter.iter().for_each(|&i| scores[i as usize] = 0.0);
        scores
    }

    /// `(N)` patch of every point of the input, in its order; [`NO_PATCH`] for none, and for all points if patches were not asked
    /// for.
    pub fn patch_labels(&self) -> Vec<u32> {
        let label = |c: u32| self.patches.as_ref().and_then(|p| p.label.get(c as usize).copied());
        self.canonical.iter().map(|&c| label(c).unwrap_or(NO_PATCH)).collect()
    }
}
