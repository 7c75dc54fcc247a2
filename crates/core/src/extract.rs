//! The pipeline: from a cloud to its feature network.

use crate::detect::segments::steps::{self, Segmented};
use crate::detect::{detect, penalty, projection};
use crate::frame::{Frame, Localised, on_grid};
use crate::link::clusters::{GraphStage, border, link_paper, link_robust};
use crate::link::{Reach, link, reach};
use crate::math::vec3::{cross, norm, sub};
use crate::measure::{Class, Measure};
use crate::neighbors::{Neighbors, all_nearest, riemannian};
use crate::network::Network;
use crate::params::{SegmentForm, SegmentParams};
use crate::patch::{Ground, NO_PATCH, Patches, patches};
use crate::pattern::Pattern;
use crate::recover::{recover, settle, take_back};
use crate::resolution::Resolution;
use crate::{Cloud, Error, Method, Params};
use std::time::Instant;

/// Everything that [`extract`] found, stage by stage.
#[derive(Clone, Debug)]
pub struct Extraction {
    /// Counts, estimates and times.
    pub report: Report,
    /// World frame to local frame.
    pub frame: Frame,
    /// `(M)` for each point kept, in canonical order, its index in the input.
    pub source: Vec<u32>,
    /// `(N)` for each point of the input its canonical index; `u32::MAX` if it was dropped.
    pub canonical: Vec<u32>,
    /// What the detector said of every point kept, canonical order, local frame.
    pub measure: Measure,
    /// What the linker made of it, canonical indices, local frame.
    pub pattern: Pattern,
    /// What the method `segments` went through, canonical indices, local frame; `None` with any other.
    pub clusters: Option<ClusterStages>,
    /// The result, world frame, sources as indices of the input.
    pub network: Network,
    /// The patches between the strips, world frame, where they were asked for.
    pub patches: Option<Patches>,
}

/// What happened, for a summary.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Points given.
    pub read: usize,
    /// Points left out because a coordinate was not finite.
    pub dropped: usize,
    /// Points merged into an exact duplicate.
    pub merged: usize,
    /// Points kept.
    pub points: usize,
    /// Mean distance to the six nearest neighbours, corrected for noise; unit of the input.
    pub spacing: f64,
    /// Standard deviation of the noise along the surface normal; unit of the input.
    pub noise: f64,
    /// Seconds that each stage took.
    pub stages: Vec<(Stage, f64)>,
    /// The values chosen for parameters left to the data.
    pub settings: Vec<(String, String)>,
    /// What the user should know of this result.
    pub notes: Vec<String>,
}

/// A stage of the pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// Canonical order and local frame.
    Localise,
    /// Nearest neighbours and the neighbour graph.
    Neighbors,
    /// What every point says of lines.
    Detect,
    /// Patterns.
    Link,
    /// Strips, nodes and curves.
    Recover,
    /// Patches and their loops.
    Patches,
}

impl Stage {
    /// The name in progress lines and summaries.
    pub fn name(self) -> &'static str {
        match self {
            Stage::Localise => "localise",
            Stage::Neighbors => "neighbors",
            Stage::Detect => "detect",
            Stage::Link => "link",
            Stage::Recover => "recover",
            Stage::Patches => "patches",
        }
    }
}

/// A stage that begins (`done` = 0) or ends (`done` = 1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Which stage.
    pub stage: Stage,
    /// Share done, 0 to 1.
    pub done: f64,
}

/// Fewest distinct points that can lie on a surface.
const LEAST_POINTS: usize = 4;

/// Extracts the feature network of a cloud.
///
/// # Errors
/// [`Error::Parameter`] for a value out of range; [`Error::TooFewPoints`], [`Error::Collinear`], [`Error::Extent`] or
/// [`Error::TooManyPoints`] for a cloud that has no surface.
pub fn extract(world: &Cloud, params: &Params) -> Result<Extraction, Error> {
    extract_observed(world, params, &|_| ())
}

/// [`extract`], telling `observe` when each stage begins and ends.
///
/// # Errors
/// As [`extract`].
pub fn extract_observed(
    world: &Cloud,
    params: &Params,
    observe: &(dyn Fn(Progress) + Sync),
) -> Result<Extraction, Error> {
    params.check()?;
    let mut clock = Clock { observe, stages: Vec::new() };
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
        crate::params::Auto::Given(ratio) => Resolution { noise: ratio * resolution.spacing, ..resolution },
        crate::params::Auto::Auto => resolution,
    };
    let reach = reach(&params.spanning, params.penalty.form, positions.len());
    let mut measure = clock.run(Stage::Detect, || detect(&positions, &graph, resolution, params));
    let (mut pattern, clusters) =
        clock.run(Stage::Link, || linked(&positions, &graph, &mut measure, resolution, params, reach));
    let mut network = clock.run(Stage::Recover, || recover(&pattern, resolution, &params.spline));
    let robust_segments = params.method == Method::Segments && params.segments.form == SegmentForm::Robust;
    let wanted = params.patches.find.or(|| params.method == Method::Segments);
    let patches = wanted.then(|| {
        let ground = Ground { points: &positions, graph: &graph, normals: &measure.normal, resolution };
        clock.run(Stage::Patches, || {
            let first = patches(&ground, &network);
            if !robust_segments
                || !take_back(&mut pattern.crease, &network, &first, resolution, params.penalty.fold_deg)
            {
                return first;
            }
            network = recover(&pattern, resolution, &params.spline);
            patches(&ground, &network)
        })
    });

    if measure.class.is_empty() {
        measure.class = crate::classify::classes(&positions, &network, resolution);
    }
    let report = Report {
        read: world.len(),
        dropped,
        merged,
        points: positions.len(),
        spacing: frame.length_to_world(resolution.spacing),
        noise: frame.length_to_world(resolution.noise),
        stages: clock.stages,
        settings: settings(params, resolution, reach),
        notes: notes(params, resolution, clusters.as_ref()),
    };
    let (network, stay) = to_world(network, &frame, &source);
    let patches = patches.map(|p| p.placed(&frame).of_strips(&stay));
    Ok(Extraction { report, frame, source, canonical, measure, pattern, clusters, network, patches })
}

impl Extraction {
    /// `(N)` the class of every point of the input, in its order; dropped points are smooth.
    pub fn classes(&self) -> Vec<Class> {
        self.canonical
            .iter()
            .map(|&c| self.measure.class.get(c as usize).copied().unwrap_or_default())
            .collect()
    }

    /// `(N)` the score of every point of the input, in its order, 0 to 1; NaN for dropped points.
    pub fn scores(&self) -> Vec<f32> {
        self.canonical
            .iter()
            .map(|&c| self.measure.score.get(c as usize).copied().unwrap_or(f32::NAN))
            .collect()
    }

    /// `(N)` the patch of every point of the input, in its order; [`NO_PATCH`] for none, and where none were looked for.
    pub fn patch_labels(&self) -> Vec<u32> {
        let label = |c: u32| self.patches.as_ref().and_then(|p| p.label.get(c as usize).copied());
        self.canonical.iter().map(|&c| label(c).unwrap_or(NO_PATCH)).collect()
    }
}

/// The steps of the method `segments`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClusterStages {
    /// Clusters of points, and the time that it took to find them.
    pub segmented: Segmented,
    /// The graph after each step.
    pub graphs: Vec<GraphStage>,
}

/// Links by the method asked for; the method `segments` also says what it went through.
fn linked(
    positions: &[[f64; 3]],
    graph: &Neighbors,
    measure: &mut Measure,
    resolution: Resolution,
    params: &Params,
    reach: Reach,
) -> (Pattern, Option<ClusterStages>) {
    match params.method {
        Method::Penalty | Method::Projection => {
            (link(graph, measure, resolution, &params.spanning, reach), None)
        }
        Method::Segments => {
            let (pattern, clusters) =
                segmented(positions, graph, measure, resolution, &params.segments, reach);
            (pattern, Some(clusters))
        }
    }
}

/// Demarsin's segmentation and closed graph (Demarsin et al. 2007, Algorithm 1).
fn segmented(
    positions: &[[f64; 3]],
    graph: &Neighbors,
    measure: &mut Measure,
    resolution: Resolution,
    params: &SegmentParams,
    reach: Reach,
) -> (Pattern, ClusterStages) {
    let (segmented, linked) = match params.form {
        SegmentForm::Paper => {
            let candidates = std::mem::take(&mut measure.border);
            let density = std::mem::take(&mut measure.density);
            let segmented = steps::paper(positions, resolution, params, measure);
            measure.density = density;
            let smooth = if segmented.rounds > 0 { &segmented.smoothed } else { positions };
            let border = border(graph, measure, &candidates, resolution, reach);
            let linked =
                link_paper(smooth, &segmented.rings, &segmented.segments, border, resolution, params);
            (segmented, linked)
        }
        SegmentForm::Robust => {
            let segmented = steps::robust(positions, graph, resolution, params, measure);
            let linked = link_robust(positions, graph, measure, &segmented.segments, resolution, reach);
            (segmented, linked)
        }
    };
    (linked.pattern, ClusterStages { segmented, graphs: linked.stages })
}

struct Clock<'a> {
    observe: &'a (dyn Fn(Progress) + Sync),
    stages: Vec<(Stage, f64)>,
}

impl Clock<'_> {
    fn run<T>(&mut self, stage: Stage, work: impl FnOnce() -> T) -> T {
        (self.observe)(Progress { stage, done: 0.0 });
        let start = Instant::now();
        let result = work();
        self.stages.push((stage, start.elapsed().as_secs_f64()));
        (self.observe)(Progress { stage, done: 1.0 });
        result
    }
}

pub(crate) fn refuse_degenerate(read: usize, positions: &[[f64; 3]]) -> Result<(), Error> {
    if positions.len() < LEAST_POINTS {
        return Err(Error::TooFewPoints { read, distinct: positions.len(), needed: LEAST_POINTS });
    }
    let origin = positions[0];
    let farthest = positions
        .iter()
        .map(|&p| sub(p, origin))
        .fold([0.0; 3], |best, d| if norm(d) > norm(best) { d } else { best });
    let length = norm(farthest);
    let off_line = positions.iter().any(|&p| norm(cross(farthest, sub(p, origin))) > 1e-9 * length * length);
    if off_line { Ok(()) } else { Err(Error::Collinear { distinct: positions.len() }) }
}

/// Spacings below this have squares that vanish in f64.
const LEAST_SPACING: f64 = 1e-140;

fn refuse_tiny(frame: &Frame, positions: &[[f64; 3]]) -> Result<(), Error> {
    if frame.scale >= LEAST_SPACING {
        return Ok(());
    }
    let side = |axis: usize| frame.length_to_world(positions.iter().map(|p| p[axis]).fold(0.0, f64::max));
    let axis = (1..3).fold(0, |best, axis| if side(axis) > side(best) { axis } else { best });
    let min = frame.offset[axis];
    Err(Error::Extent { axis, min, max: min + side(axis) })
}

fn settings(params: &Params, resolution: Resolution, reach: crate::link::Reach) -> Vec<(String, String)> {
    let derived = penalty::derive(&params.penalty, resolution);
    vec![
        ("penalty.hops".into(), derived.hops.to_string()),
        ("penalty.alpha".into(), format!("{:.3}", derived.alpha)),
        (
            "spanning.rho".into(),
            format!("{:.1} {}", reach.rho, if reach.in_edges { "edges" } else { "spacings" }),
        ),
    ]
}

fn notes(params: &Params, resolution: Resolution, clusters: Option<&ClusterStages>) -> Vec<String> {
    let hops = penalty::derive(&params.penalty, resolution).hops;
    let noisy = |c: &ClusterStages| c.segmented.note(&params.segments, resolution, hops);
    match params.method {
        Method::Projection => projection::warning(resolution).into_iter().collect(),
        Method::Segments => clusters.and_then(noisy).into_iter().collect(),
        Method::Penalty => Vec::new(),
    }
}

/// Positions into the world frame, sources into the order of the input; which strips stay, as far coordinates can be too
/// coarse for a short line.
fn to_world(mut network: Network, frame: &Frame, source: &[u32]) -> (Network, Vec<bool>) {
    let unit = frame.length_to_world(1.0);
    let placed = |p: [f64; 3]| frame.to_world(p.map(on_grid));
    for node in &mut network.nodes {
        node.position = placed(node.position);
        node.source = source[node.source as usize];
    }
    for strip in &mut network.strips {
        for p in &mut strip.points {
            *p = placed(*p);
        }
        strip.points.dedup();
        strip.curve = strip.curve.mapped(placed, unit);
        strip.deviation *= unit;
        for s in &mut strip.sources {
            *s = source[*s as usize];
        }
    }
    let stay = settle(&mut network);
    (network, stay)
}
