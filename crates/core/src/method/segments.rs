//! The method `segments`: segmentation, then a closed graph over it (Demarsin et al. 2007, Algorithm 1).

use crate::detect::penalty;
use crate::detect::segments::{Segmented, as_printed, robust};
use crate::link::CycleRule;
use crate::link::clusters::{GraphStage, Segments, borders, link_as_printed, link_robust};
use crate::measure::Measure;
use crate::params::{Params, SegmentForm};
use crate::pattern::Pattern;
use crate::prepare::Prepared;

/// The steps of the method `segments`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClusterStages {
    /// Clusters of points, with the times of the steps.
    pub segmented: Segmented,
    /// The graph after each step.
    pub graphs: Vec<GraphStage>,
}

/// The measure before the segmentation: as printed the borders alone, in the robust form all penalties.
pub(super) fn detect(cloud: &Prepared, params: &Params) -> Measure {
    let Prepared { positions, graph, resolution, .. } = cloud;
    match params.segments.form {
        SegmentForm::Paper => Measure {
            density: penalty::densities(positions, graph),
            border: penalty::borders(positions, graph, *resolution, &params.penalty),
            ..Measure::default()
        },
        SegmentForm::Robust => penalty::penalty(positions, graph, cloud.scales(), &params.penalty),
    }
}

/// Segments the cloud and links the clusters.
pub(super) fn link(
    cloud: &Prepared,
    measure: &mut Measure,
    params: &Params,
    rule: CycleRule,
) -> (Pattern, ClusterStages) {
    let &Prepared { ref positions, ref graph, resolution, .. } = cloud;
    let (segmented, linked) = match params.segments.form {
        SegmentForm::Paper => {
            let (segmented, normals) = as_printed(positions, resolution, &params.segments);
            measure.normal = normals;
            measure.score = segmented.segments.score();
            let smooth = if segmented.rounds > 0 { &segmented.smoothed } else { positions };
            let border = borders(graph, measure, resolution, rule, &params.repair);
            let linked =
                link_as_printed(smooth, &segmented.rings, &segmented.segments, border, &params.segments);
            (segmented, linked)
        }
        SegmentForm::Robust => {
            let segmented = robust(positions, graph, resolution, &params.segments, measure);
            let segments = &segmented.segments;
            let points = &positions[..];
            let linked =
                link_robust(&Segments { points, graph, measure, segments, resolution, rule, params });
            (segmented, linked)
        }
    };
    (linked.pattern, ClusterStages { segmented, graphs: linked.stages })
}
