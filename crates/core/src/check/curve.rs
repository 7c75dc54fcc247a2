//! Invariants of the curve that a strip was fitted with.

use super::finite;
use crate::math::vec3::{distance, norm, sub};
use crate::network::{Network, Strip};

pub(super) fn faults(network: &Network, strip: &Strip) -> Vec<String> {
    let curve = &strip.curve;
    let (degree, knots, controls) = (curve.degree, &curve.knots, &curve.controls);
    if !(1..=3).contains(&degree) {
        return vec![format!("curve of degree {degree}")];
    }
    let mut faults = Vec::new();
    let mut claim = |holds: bool, fault: &dyn Fn() -> String| {
        if !holds {
            faults.push(fault());
        }
    };
    claim(curve.periodic == strip.closed, &|| {
        format!("closed is {} but the curve's periodic {}", strip.closed, curve.periodic)
    });
    claim(controls.iter().all(finite), &|| "a control point is not finite".into());
    let least = if curve.periodic { 3 } else { degree + 1 };
    claim(controls.len() >= least, &|| format!("{} control points, at least {least} needed", controls.len()));
    let wanted = controls.len() + if curve.periodic { 1 } else { degree + 1 };
    claim(knots.len() == wanted, &|| format!("{} knots, {wanted} needed", knots.len()));
    claim(knots.iter().all(|x| x.is_finite()), &|| "a knot is not finite".into());
    let falls = knots.windows(2).position(|w| w[0] > w[1]);
    claim(falls.is_none(), &|| format!("the knots fall after knot {}", falls.unwrap_or(0)));
    claim(knots.first() < knots.last(), &|| "the knots span nothing".into());
    if !curve.periodic && knots.len() > degree {
        let clamped = |ends: &[f64]| ends.iter().all(|x| x == &ends[0]);
        let [first, last] = [&knots[..=degree], &knots[knots.len() - degree - 1..]];
        claim(clamped(first) && clamped(last), &|| format!("the first or last {} knots differ", degree + 1));
    }
    faults.extend(loose_ends(network, strip));
    faults
}

/// A clamped curve starts and ends in its outer control points.
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
