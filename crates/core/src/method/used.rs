//! The parameters that a result was made with.

use crate::detect::evidence::hops::hops;
use crate::detect::{penalty, projection, segments};
use crate::params::{Auto, Clutter, Method, ParamValue, Params};
use crate::prepare::{Prepared, cleaned};
use crate::recover::span_spacings;
use crate::resolution::Resolution;

/// The sections that every method reads, and those of its own.
const SHARED: [&str; 9] =
    ["neighbors", "surface", "penalty", "spanning", "repair", "recover", "spline", "relations", "patches"];

/// Each parameter that the method reads with the value it had, as [`Params::set`] reads it: set to these, the same cloud gives the
/// same result. Left out are parameters left to the data that have no one value: those that follow the noise at each place of an
/// uneven cloud, the noise itself where the stage `surface` left points out (it is estimated before and after), `spanning.rho` (in the robust form `spanning.loop_spacings` stands for it) and `segments.connect`.
pub(super) fn used(cloud: &Prepared, params: &Params) -> Vec<(String, String)> {
    let params = resolved(cloud, params);
    let own = match params.method {
        Method::Auto => "edgelets",
        Method::Penalty => "",
        Method::Projection => "projection",
        Method::Segments => "segments",
    };
    let read = |key: &str| match key.split_once('.') {
        Some((section, _)) => section == own || SHARED.contains(&section),
        None => true,
    };
    // Of the method, `auto` is a value; of other parameters it says that there is none.
    let known = |key: &str, value: &str| key == "method" || value != Auto::<f64>::Auto.show();
    let entries = params.entries().into_iter().filter(|e| read(&e.key) && known(&e.key, &e.value));
    entries.map(|e| (e.key, e.value)).collect()
}

/// The parameters with the values that follow from the data.
fn resolved(cloud: &Prepared, params: &Params) -> Params {
    let mut params = params.clone();
    let noise = cloud.resolution.noise / cloud.resolution.spacing;
    let derived = penalty::derive(&params.penalty, cloud.resolution);
    let local = params.method != Method::Projection;
    let (steps, spans) = (|at| hops(params.penalty.hops, at), |at| span_spacings(&params.spline, at));
    let hops = if local { everywhere(cloud, steps) } else { Some(derived.hops) };
    let span = everywhere(cloud, spans);
    params.penalty.hops = hops.map_or(Auto::Auto, Auto::Given);
    params.penalty.alpha = Auto::Given(derived.alpha);
    if !cloud.is_part() {
        params.penalty.noise_spacings = Auto::Given(noise);
    }
    params.surface.clutter = if cleaned(&params) { Clutter::LeaveOut } else { Clutter::Keep };
    params.spline.span_spacings = span.map_or(Auto::Auto, Auto::Given);
    params.projection.floor_spacings =
        Auto::Given(projection::floor_spacings(cloud.resolution, &params.projection));
    params.segments.angle_deg = Auto::Given(segments::angle(&params.segments, cloud.resolution));
    params.segments.cycle = Auto::Given(params.segments.cycle.or(|| 2 * params.segments.branch));
    params.patches.find = Auto::Given(super::wants_patches(&params));
    params
}

/// A value that follows from the resolution at a place, if it is the same at all of them.
fn everywhere<T: PartialEq>(cloud: &Prepared, of: impl Fn(Resolution) -> T) -> Option<T> {
    let scales = cloud.scales();
    let first = of(scales.at(0));
    (0..cloud.positions.len()).all(|i| of(scales.at(i)) == first).then_some(first)
}
