//! The choice of method: the detector and the linker of each, with their settings and notes. Only this file names methods.

mod segments;
mod used;

pub use segments::ClusterStages;

use crate::detect::edgelets::edgelets;
use crate::detect::{penalty, projection};
use crate::error::Error;
use crate::link::{self, CycleRule, Known, Metric};
use crate::measure::Measure;
use crate::network::Network;
use crate::params::{Method, ParamValue, Params, PenaltyForm, SegmentForm, WedgeForm};
use crate::patch::{self, Ground, Patches};
use crate::pattern::Pattern;
use crate::prepare::Prepared;
use crate::recover::{
    LED_ON, SPANNING, append_rounded, close_rings, meet, observe, recover, refit, settle_ends, sharpen,
    take_back,
};
use crate::relation::{Related, related as relations};
use crate::stages::{self, Stages};

/// The parameters for a detector of the caller's own: its measure goes to the linker of the method `penalty`.
pub(crate) fn with_own_detector(params: &Params) -> Params {
    Params { method: Method::Penalty, ..params.clone() }
}

/// Runs the method's detector; where there is no surface there is nothing to detect.
pub(crate) fn detect(cloud: &Prepared, params: &Params) -> Measure {
    let Prepared { positions, graph, resolution, .. } = cloud;
    if !cloud.has_surface() {
        return Measure::of_clutter(positions.len(), *resolution);
    }
    match params.method {
        Method::Auto => {
            let mut measure = penalty::penalty(positions, graph, cloud.scales(), &params.penalty);
            if params.penalty.form == PenaltyForm::Robust {
                let found = edgelets(positions, &measure.normal, cloud.scales(), &params.edgelets);
                (measure.edgelets, measure.flat, measure.blends) = (found.edgelets, found.flat, found.blends);
            }
            measure
        }
        Method::Penalty => penalty::penalty(positions, graph, cloud.scales(), &params.penalty),
        Method::Segments => segments::detect(cloud, params),
        Method::Projection => projection::candidates::measure(positions, graph, *resolution, params),
    }
}

/// Steps along the neighbour graph over which the detector reads, at least one.
pub(crate) fn steps(cloud: &Prepared, params: &Params) -> usize {
    penalty::robust_steps(&params.penalty, cloud.scales(), cloud.positions.len())
}

/// Refuses what does not run over tiles.
///
/// # Errors
/// [`Error::Parameter`] with the first parameter at fault.
pub(crate) fn refuse_tiles(params: &Params) -> Result<(), Error> {
    let fault = |key: &str, value: &str, expected: &str| {
        let expected = format!("{expected}, as clouds in tiles have no more yet");
        Err(Error::Parameter { key: key.into(), value: value.into(), expected })
    };
    if params.method != Method::Penalty {
        return fault("method", &params.method.show(), "penalty");
    }
    if params.penalty.form != PenaltyForm::Robust {
        return fault("penalty.form", &params.penalty.form.show(), "robust");
    }
    if params.recover.wedge != WedgeForm::None {
        return fault("recover.wedge", &params.recover.wedge.show(), "none");
    }
    if wants_patches(params) {
        return fault("patches.find", "true", "false");
    }
    Ok(())
}

/// Runs the method's linker; the method `segments` also returns its steps.
pub(crate) fn link(
    cloud: &Prepared,
    measure: &mut Measure,
    params: &Params,
) -> (Pattern, Option<ClusterStages>) {
    match params.method {
        _ if !cloud.has_surface() => Default::default(),
        Method::Auto | Method::Penalty | Method::Projection => {
            let rule = cycle_rule(cloud, params);
            let mut pattern =
                link::link(&cloud.graph, measure, cloud.scales(), params, rule, &known(cloud, params));
            if params.method == Method::Auto && params.penalty.form == PenaltyForm::Robust {
                close_rings(&mut pattern.crease, &cloud.positions, cloud.scales());
                link::unborder(&mut pattern, cloud.scales());
            }
            (pattern, None)
        }
        Method::Segments => {
            let (pattern, stages) = segments::link(cloud, measure, params, cycle_rule(cloud, params));
            (pattern, Some(stages))
        }
    }
}

/// The folds of the mesh that the points were sampled on, for the method that is of no paper.
fn known<'a>(cloud: &'a Prepared, params: &Params) -> Known<'a> {
    let wanted = params.method == Method::Auto && params.edgelets.folds;
    let folds = if wanted { cloud.folds.as_slice() } else { &[] };
    Known { folds, points: &cloud.positions, least: params.penalty.fold_deg.to_radians() }
}

/// The network of a pattern, its creases and corners recovered from the faces if asked for.
pub(crate) fn recovered(cloud: &Prepared, measure: &Measure, pattern: &Pattern, params: &Params) -> Network {
    let Prepared { positions, graph, .. } = cloud;
    let mut network = recover(pattern, cloud.scales(), &params.spline, contracted(params));
    if params.method == Method::Auto {
        meet(&mut network, cloud.scales(), &params.spline);
    }
    let ground = Ground { points: positions, graph, normals: &measure.normal, scales: cloud.scales() };
    sharpen(&mut network, &ground, &params.recover, &params.spline);
    refit(&mut network, positions, graph, cloud.scales());
    network
}

/// Adds the rounded edges to a network, which no other stage reads.
pub(crate) fn round_off(cloud: &Prepared, network: &mut Network, pattern: &Pattern, params: &Params) {
    append_rounded(network, pattern, cloud.scales(), &params.spline);
}

/// The steps to a pattern and on from it for viewers; `None` of `auto`, and of `segments`, which keeps its own.
pub(crate) fn stages(
    cloud: &Prepared,
    measure: &Measure,
    pattern: &Pattern,
    params: &Params,
) -> Option<Stages> {
    let rule = cycle_rule(cloud, params);
    match params.method {
        Method::Penalty | Method::Projection => Some(stages::of(cloud, measure, pattern, rule, params)),
        Method::Auto | Method::Segments => None,
    }
}

/// Greatest length of a strip that is taken for a node, spacings.
fn contracted(params: &Params) -> f64 {
    if params.method == Method::Auto { LED_ON } else { SPANNING }
}

/// The relations between the typed curves of a network, which is moved so that they hold if that is asked for.
pub(crate) fn related(cloud: &Prepared, network: &mut Network, params: &Params) -> Related {
    let scales = cloud.scales();
    let observed = observe(network, &cloud.positions, &cloud.graph, scales);
    let spacing: Vec<f64> = network.strips.iter().map(|s| scales.finest(&s.sources).spacing).collect();
    let related = relations(network, &observed, &spacing, cloud.resolution.noise, &params.relations);
    if !params.relations.regularise {
        // What is imposed moves lines off their own nodes, to where all curves together want them.
        settle_ends(network, scales);
    }
    related
}

/// Whether patches are to be found: if asked for, and by the method whose lines bound them.
pub(crate) fn wants_patches(params: &Params) -> bool {
    params.patches.find.or(|| params.method == Method::Segments)
}

/// The patches between the strips; the robust form of `segments` removes strips that the patches do not confirm.
pub(crate) fn patches(
    cloud: &Prepared,
    measure: &Measure,
    pattern: &mut Pattern,
    network: &mut Network,
    params: &Params,
) -> Patches {
    let Prepared { positions, graph, resolution, .. } = cloud;
    if !cloud.has_surface() {
        return Patches::without_surface(positions.len());
    }
    let ground = Ground { points: positions, graph, normals: &measure.normal, scales: cloud.scales() };
    let first = patch::patches(&ground, network);
    let verified = params.method == Method::Segments && params.segments.form == SegmentForm::Robust;
    let fold_deg = params.penalty.fold_deg;
    if !verified || !take_back(&mut pattern.crease, network, &first, *resolution, fold_deg) {
        return first;
    }
    *network = recover(pattern, *resolution, &params.spline, contracted(params));
    patch::patches(&ground, network)
}

/// The values of parameters derived from the data.
pub(crate) fn settings(cloud: &Prepared, params: &Params) -> Vec<(String, String)> {
    let derived = penalty::derive(&params.penalty, cloud.resolution);
    let CycleRule { rho, metric, .. } = cycle_rule(cloud, params);
    let unit = match metric {
        Metric::Edges => "edges",
        Metric::Lengths(_) => "spacings",
    };
    vec![
        ("penalty.hops".into(), derived.hops.to_string()),
        ("penalty.alpha".into(), format!("{:.3}", derived.alpha)),
        ("spanning.rho".into(), format!("{rho:.1} {unit}")),
    ]
}

/// Every parameter that the method reads, with the value it had.
pub(crate) fn used(cloud: &Prepared, params: &Params) -> Vec<(String, String)> {
    used::used(cloud, params)
}

/// Notes for the user on the result.
pub(crate) fn notes(cloud: &Prepared, clusters: Option<&ClusterStages>, params: &Params) -> Vec<String> {
    let hops = penalty::derive(&params.penalty, cloud.resolution).hops;
    let noisy = |c: &ClusterStages| c.segmented.note(&params.segments, cloud.resolution, hops);
    match params.method {
        Method::Projection => projection::warning(cloud.resolution).into_iter().collect(),
        Method::Segments => clusters.and_then(noisy).into_iter().collect(),
        Method::Auto | Method::Penalty if params.penalty.form == PenaltyForm::Paper => {
            let (tau, borders) = (params.spanning.tau, params.spanning.borders);
            penalty::note(tau, borders, cloud.resolution).into_iter().collect()
        }
        Method::Auto | Method::Penalty => Vec::new(),
    }
}

fn cycle_rule<'a>(cloud: &'a Prepared, params: &Params) -> CycleRule<'a> {
    CycleRule::new(&params.spanning, params.penalty.form, cloud.count, cloud.scales())
}
