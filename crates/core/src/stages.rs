//! The steps of a method for viewers, made again from what the pipeline holds by the functions that it calls: a run that is not asked
//! for them does no more than before.

use crate::detect::penalty::ellipsoids;
use crate::detect::projection::steps::{Steps, steps};
use crate::link::{self, CycleRule, LineSteps};
use crate::math::tensor::Ellipsoid;
use crate::measure::Measure;
use crate::network::Network;
use crate::params::{Method, Params, PenaltyForm};
use crate::patch::Ground;
use crate::pattern::Pattern;
use crate::prepare::Prepared;
use crate::recover::{Recovery, SPANNING, recover, sharpen};

/// The steps of the methods `penalty` and `projection`, canonical indices, local frame.
#[derive(Clone, Debug)]
pub struct Stages {
    /// The method.
    pub method: Method,
    /// `(M)` the correlation ellipsoid of each point kept; of the method `penalty`.
    pub ellipsoids: Vec<Ellipsoid>,
    /// The projected distances with their scales and cuts; of the method `projection`.
    pub projection: Option<Steps>,
    /// The graphs of creases and of borders, those that were asked for. What repair makes of them is the pattern.
    pub lines: Vec<LineSteps>,
    /// Whether the pruned graphs were repaired: in the robust form.
    pub repaired: bool,
    /// The network of the pattern with its splines, before creases and corners are recovered and typed curves laid.
    pub splines: Network,
    /// The groups and places by which creases and corners were recovered; `None` unless `recover.wedge` asks for it.
    pub recovery: Option<Recovery>,
}

/// The steps that led to a pattern and on from it.
pub(crate) fn of(
    cloud: &Prepared,
    measure: &Measure,
    pattern: &Pattern,
    rule: CycleRule,
    params: &Params,
) -> Stages {
    let Prepared { positions, graph, .. } = cloud;
    let scales = cloud.scales();
    let splines = recover(pattern, scales, &params.spline, SPANNING);
    let ground = Ground { points: positions, graph, normals: &measure.normal, scales };
    let recovery = sharpen(&mut splines.clone(), &ground, &params.recover, &params.spline);
    Stages {
        method: params.method,
        ellipsoids: match params.method {
            Method::Penalty => ellipsoids(positions, graph, scales, &params.penalty),
            _ => Vec::new(),
        },
        projection: (params.method == Method::Projection)
            .then(|| steps(positions, cloud.resolution, &params.projection)),
        lines: link::steps(graph, measure, scales, params, rule),
        repaired: rule.form == PenaltyForm::Robust,
        splines,
        recovery: recovery.map(Recovery::from),
    }
}
