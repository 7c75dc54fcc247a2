//! A network as STEP: a wireframe of true curves, a GEOMETRIC_CURVE_SET for each strip, named by it and on the layer of its kind.

use super::context::NetworkContext;
use crate::write::encode::step::{Head, Id, List, Step, Text};
use lineament::curve::pieces::Shape;
use lineament::math::vec3::{add_scaled, perpendicular};
use lineament::{Network, Strip, StripKind};
use std::f64::consts::TAU;
use std::io::{self, Write};

/// Shares of extent and coordinates up to which curves that meet may lie apart.
const OF_EXTENT: f64 = 1e-9;
const OF_COORDINATES: f64 = 1e-14;
/// Change of the parameter from which on an ellipse is whole, radians.
const WHOLE: f64 = TAU - 1e-9;

/// Writes the typed curves of each strip, a polyline where it has none.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let mut step = Step::begin(out, &head(context, rounding(network)))?;
    let mut sets: Vec<(StripKind, Id)> = Vec::new();
    for (number, strip) in network.strips.iter().enumerate() {
        let curves = curves(&mut step, strip)?;
        if !curves.is_empty() {
            let name = format!("{}_{number}", strip.kind.name());
            let set = step.add(format_args!("GEOMETRIC_CURVE_SET('{name}',{})", List(&curves)))?;
            sets.push((strip.kind, set));
        }
    }
    for kind in [StripKind::Crease, StripKind::Border, StripKind::Rounded] {
        let of_kind: Vec<Id> = sets.iter().filter(|s| s.0 == kind).map(|s| s.1).collect();
        if kind == StripKind::Rounded && of_kind.is_empty() {
            continue;
        }
        step.layer(&kind.name().to_uppercase(), &of_kind)?;
    }
    let sets: Vec<Id> = sets.into_iter().map(|s| s.1).collect();
    wireframe(step, &context.input_name, &sets)
}

/// Ends a file whose product consists of these sets of curves.
pub(in crate::write) fn wireframe(mut step: Step, name: &str, sets: &[Id]) -> io::Result<()> {
    let place = step.placement([0.0; 3], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])?;
    let items: Vec<Id> = [place].iter().chain(sets).copied().collect();
    // A wireframe has at least one set of curves.
    let kind = if sets.is_empty() { "SHAPE" } else { "GEOMETRICALLY_BOUNDED_WIREFRAME_SHAPE" };
    let (items, inside) = (List(&items), step.context);
    let name = Text(name);
    let shape = step.add(format_args!("{kind}_REPRESENTATION({name},{items},#{inside})"))?;
    step.end(&[shape])
}

/// What a file states, with the distance up to which places may lie apart.
pub(in crate::write) fn head(context: &NetworkContext, uncertainty: f64) -> Head<'_> {
    Head {
        protocol: context.step,
        name: &context.input_name,
        version: &context.program_version,
        unit: context.known_unit(),
        uncertainty,
    }
}

/// What rounding leaves between places of a network: a share of its extent, and of its coordinates, which on maps are far greater.
pub(in crate::write) fn rounding(network: &Network) -> f64 {
    rounding_of(network.strips.iter().flat_map(|s| &s.points))
}

/// The same of any points.
pub(in crate::write) fn rounding_of<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> f64 {
    let none = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    let wider = |[low, high]: [[f64; 3]; 2], p: &[f64; 3]| {
        [[0, 1, 2].map(|k| low[k].min(p[k])), [0, 1, 2].map(|k| high[k].max(p[k]))]
    };
    let [low, high] = points.fold(none, wider);
    let side = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    if low[0] > high[0] {
        return OF_EXTENT;
    }
    let most = low.iter().chain(&high).fold(0.0, |most: f64, c| most.max(c.abs()));
    (OF_EXTENT * side + OF_COORDINATES * most).max(f64::MIN_POSITIVE)
}

fn curves(step: &mut Step, strip: &Strip) -> io::Result<Vec<Id>> {
    let typed: Vec<_> = strip.curves.iter().map(|p| (p.shape.clone(), [p.from, p.to])).collect();
    curves_of(step, &typed, &strip.points, strip.closed)
}

/// The typed curves of a line with their ends, or a polyline through its points where it has none.
pub(in crate::write) fn curves_of(
    step: &mut Step,
    typed: &[(Shape, [[f64; 3]; 2])],
    points: &[[f64; 3]],
    closed: bool,
) -> io::Result<Vec<Id>> {
    if typed.is_empty() && points.len() > 1 {
        let closing = points.first().filter(|_| closed);
        let points: Vec<[f64; 3]> = points.iter().chain(closing).copied().collect();
        return Ok(vec![step.polyline("", &points)?]);
    }
    typed.iter().map(|(shape, ends)| curve(step, shape, *ends)).collect()
}

fn curve(step: &mut Step, shape: &Shape, [from, to]: [[f64; 3]; 2]) -> io::Result<Id> {
    let name = shape.name();
    match shape {
        Shape::Line => step.segment(name, [from, to]),
        Shape::Arc { round, sweep } => {
            let circle = step.circle("", round, from)?;
            step.trimmed(name, circle, [0.0, *sweep])
        }
        Shape::Circle(round) => {
            let first = add_scaled(round.centre, perpendicular(round.normal), round.radius);
            step.circle(name, round, first)
        }
        Shape::Ellipse { ellipse, sweep } => {
            let whole = *sweep >= WHOLE;
            let basis = step.ellipse(if whole { name } else { "" }, ellipse)?;
            let first = ellipse.angle(from).rem_euclid(TAU);
            if whole { Ok(basis) } else { step.trimmed(name, basis, [first, first + sweep]) }
        }
        Shape::Spline(spline) => step.spline(name, spline),
    }
}
