//! Invariants of the fitted curve of a strip.

use super::verdict::finite;
use crate::curve::BSpline;
use crate::math::vec3::{distance, norm, sub};
use crate::network::{Network, Strip};

pub(super) fn faults(network: &Network, strip: &Strip) -> Vec<String> {
    let BSpline { degree, controls, periodic, .. } = &strip.curve;
    if !(1..=3).contains(degree) {
        return vec![format!("curve of degree {degree}")];
    }
    let least = if *periodic { 3 } else { degree + 1 };
    let own = [
        (*periodic != strip.closed)
            .then(|| format!("closed is {} but the curve's periodic {periodic}", strip.closed)),
        (!controls.iter().all(finite)).then(|| "a control point is not finite".into()),
        (controls.len() < least)
            .then(|| format!("{} control points, at least {least} needed", controls.len())),
    ];
    let mut faults: Vec<String> = own.into_iter().flatten().collect();
    faults.extend(knot_faults(&strip.curve));
    faults.extend(loose_ends(network, strip));
    faults
}

fn knot_faults(curve: &BSpline) -> Vec<String> {
    let (degree, knots) = (curve.degree, &curve.knots);
    let wanted = curve.controls.len() + if curve.periodic { 1 } else { degree + 1 };
    let falls = knots.windows(2).position(|w| w[0] > w[1]);
    let same = |ends: &[f64]| ends.iter().all(|x| x == &ends[0]);
    let loose = !curve.periodic
        && knots.len() > degree
        && !(same(&knots[..=degree]) && same(&knots[knots.len() - degree - 1..]));
    let faults = [
        (knots.len() != wanted).then(|| format!("{} knots, {wanted} needed", knots.len())),
        (!knots.iter().all(|x| x.is_finite())).then(|| "a knot is not finite".into()),
        falls.map(|i| format!("the knots fall after knot {i}")),
        (knots.first() >= knots.last()).then(|| "the knots span nothing".into()),
        loose.then(|| format!("the first or last {} knots differ", degree + 1)),
    ];
    faults.into_iter().flatten().collect()
}

/// Faults at the ends of a clamped curve, which starts and ends in its outer control points.
fn loose_ends(network: &Network, strip: &Strip) -> Vec<String> {
    if strip.curve.periodic {
        return Vec::new();
    }
    let controls = &strip.curve.controls;
    let ends = [("start", strip.start, controls.first()), ("end", strip.end, controls.last())];
    let first = strip.points.first().copied().unwrap_or_default();
    let extent = strip.points.iter().map(|&p| norm(sub(p, first))).fold(0.0, f64::max);
    let away = |(name, node, control): (&str, Option<u32>, Option<&[f64; 3]>)| {
        let node = network.nodes.get(node? as usize)?;
        let gap = distance(*control?, node.position);
        // Rounding grows with the distance from the origin as well as with the strip.
        let allowed = 1e-9 * extent + 4.0 * f64::EPSILON * norm(node.position);
        (gap > allowed).then(|| format!("the curve's {name} is {gap:e} off its node"))
    };
    ends.into_iter().filter_map(away).collect()
}
