//! The method `segments`: segmentation, then a closed graph over it (Demarsin et al. 2007, Algorithm 1).

use crate::detect::segments::steps::{self, Segmented};
use crate::link::Reach;
use crate::link::clusters::{GraphStage, border, link_paper, link_robust};
use crate::measure::Measure;
use crate::params::{SegmentForm, SegmentParams};
use crate::pattern::Pattern;
use crate::prepare::Prepared;

/// The steps of the method `segments`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClusterStages {
    /// Clusters of points, and the time that it took to find them.
    pub segmented: Segmented,
    /// The graph after each step.
    pub graphs: Vec<GraphStage>,
}

/// Segments the cloud and links over the clusters.
pub(super) fn link(
    cloud: &Prepared,
    measure: &mut Measure,
    params: &SegmentParams,
    reach: Reach,
) -> (Pattern, ClusterStages) {
    let Prepared { positions, graph, resolution, .. } = cloud;
    let (segmented, linked) = match params.form {
        SegmentForm::Paper => {
            let candidates = std::mem::take(&mut measure.border);
            let density = std::mem::take(&mut measure.density);
            let segmented = steps::paper(positions, *resolution, params, measure);
            measure.density = density;
            let smooth = if segmented.rounds > 0 { &segmented.smoothed } else { positions };
            let border = border(graph, measure, &candidates, *resolution, reach);
            let linked =
                link_paper(smooth, &segmented.rings, &segmented.segments, border, *resolution, params);
            (segmented, linked)
        }
        SegmentForm::Robust => {
            let segmented = steps::robust(positions, graph, *resolution, params, measure);
            let linked = link_robust(positions, graph, measure, &segmented.segments, *resolution, reach);
            (segmented, linked)
        }
    };
    (linked.pattern, ClusterStages { segmented, graphs: linked.stages })
}
