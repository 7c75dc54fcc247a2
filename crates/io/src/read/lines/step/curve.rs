//! Curves (ISO 10303-42) as rows of points.

use super::super::kind_of;
use super::super::sample::{Spline, ellipse};
use super::parse::{Fault, Instance, Value};
use lineament::evaluate::{CurveKind, LineKind};
use lineament::math::vec3::{add_scaled, cross, dot, norm, perpendicular, scale, sub, unit};
use std::cell::Cell;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// Points of a curve, and its type with the radius of a circle.
type Curve = (Vec<[f64; 3]>, Option<(CurveKind, Option<f64>)>);

/// Curves of curves beyond which a file is refused.
const DEEPEST: usize = 16;

/// The instances of a file, and what they say of angles.
pub(super) struct Model<'a> {
    instances: &'a BTreeMap<u64, Instance>,
    /// Radians of a unit of angle.
    angle: f64,
    others: Cell<usize>,
}

/// Where a curve begins or ends: by its parameter, or at a place.
#[derive(Clone, Copy)]
enum Bound {
    Parameter(f64),
    Place([f64; 3]),
}

impl<'a> Model<'a> {
    pub fn new(instances: &'a BTreeMap<u64, Instance>) -> Self {
        let degrees = |i: &Instance| {
            i.records.iter().any(|(name, values)| {
                name == b"CONVERSION_BASED_UNIT"
                    && matches!(values.first(), Some(Value::Text(text)) if text.to_ascii_uppercase().starts_with(b"DEGREE"))
            })
        };
        let angle = if instances.values().any(degrees) { 1f64.to_radians() } else { 1.0 };
        Self { instances, angle, others: Cell::new(0) }
    }

    /// The curves of all sets of curves, each with the kind that the set's name tells.
    pub fn sets(&self) -> Vec<(LineKind, u64)> {
        let mut all = Vec::new();
        for (name, values) in self.records() {
            if ![b"GEOMETRIC_CURVE_SET" as &[u8], b"GEOMETRIC_SET"].contains(&name) {
                continue;
            }
            let [Value::Text(called), Value::List(items)] = values else { continue };
            all.extend(items.iter().filter_map(id_of).map(|id| (kind_of(called), id)));
        }
        all
    }

    /// The edges of faces.
    pub fn edges(&self) -> Vec<u64> {
        let edge = |i: &&u64| self.instances[i].records.iter().any(|r| r.0 == b"EDGE_CURVE");
        self.instances.keys().filter(edge).copied().collect()
    }

    /// The number of items asked for that were no curves.
    pub fn passed_over(&self) -> usize {
        self.others.get()
    }

    fn records(&self) -> impl Iterator<Item = (&'a [u8], &'a [Value])> {
        self.instances.values().flat_map(|i| i.records.iter().map(|(name, values)| (&name[..], &values[..])))
    }

    /// The points of a curve; none for an item that is no curve.
    ///
    /// # Errors
    /// A curve with parameters that are none of it.
    pub fn curve(&self, id: u64) -> Result<Vec<Curve>, Fault> {
        self.bounded(id, None, DEEPEST)
    }

    /// A curve between two bounds, against its sense where that is said.
    fn bounded(
        &self,
        id: u64,
        bounds: Option<([Bound; 2], bool)>,
        depth: usize,
    ) -> Result<Vec<Curve>, Fault> {
        let Some(instance) = self.instances.get(&id) else { return Err((0, format!("there is no #{id}"))) };
        let bad = |what: &str| (instance.at, format!("#{id}: {what}"));
        if depth == 0 {
            return Err(bad("curves of curves without end"));
        }
        if let Some(spline) = spline(self, instance) {
            let curve = spline.ok_or_else(|| bad("a spline without its knots"))?;
            return self.along(&curve, bounds).map_err(|what| bad(&what)).map(|c| vec![c]);
        }
        match instance.records.first() {
            Some((name, values)) => self.plain(name, values, bounds, depth, &bad),
            None => Ok(Vec::new()),
        }
    }

    /// As `bounded`, of an instance that is one record.
    fn plain(
        &self,
        name: &[u8],
        values: &[Value],
        bounds: Option<([Bound; 2], bool)>,
        depth: usize,
        bad: &dyn Fn(&str) -> Fault,
    ) -> Result<Vec<Curve>, Fault> {
        let one = |curve: Option<Curve>| curve.map(|c| vec![c]).ok_or_else(|| bad("a curve that is none"));
        match (name, values) {
            (b"TRIMMED_CURVE", [_, Value::Id(basis), Value::List(from), Value::List(to), sense, ..]) => {
                let ends = self.bound(from).zip(self.bound(to)).ok_or_else(|| bad("no bounds"))?;
                self.bounded(*basis, Some(([ends.0, ends.1], is_true(sense))), depth - 1)
            }
            (b"EDGE_CURVE", [_, Value::Id(from), Value::Id(to), Value::Id(basis), sense]) => {
                let ends = self.vertex(*from).zip(self.vertex(*to)).ok_or_else(|| bad("no vertices"))?;
                let ends = [Bound::Place(ends.0), Bound::Place(ends.1)];
                self.bounded(*basis, Some((ends, is_true(sense))), depth - 1)
            }
            (b"SURFACE_CURVE" | b"SEAM_CURVE" | b"INTERSECTION_CURVE", [_, Value::Id(basis), ..]) => {
                self.bounded(*basis, bounds, depth - 1)
            }
            (b"COMPOSITE_CURVE", [_, Value::List(segments), ..]) => self.composite(segments, depth - 1),
            (b"POLYLINE", [_, Value::List(points)]) => {
                let points: Option<Vec<_>> = points.iter().map(|p| self.point(id_of(p)?)).collect();
                let straight = points.as_ref().is_some_and(|p| p.len() == 2);
                one(points.map(|points| (points, straight.then_some((CurveKind::Line, None)))))
            }
            (b"LINE", [_, Value::Id(at), Value::Id(vector)]) => one(self.line(*at, *vector, bounds)),
            (b"CIRCLE", [_, Value::Id(place), Value::Number(r)]) => {
                one(self.ellipse(*place, [*r, *r], bounds))
            }
            (b"ELLIPSE", [_, Value::Id(place), Value::Number(a), Value::Number(b)]) => {
                one(self.ellipse(*place, [*a, *b], bounds))
            }
            _ => {
                self.others.set(self.others.get() + 1);
                Ok(Vec::new())
            }
        }
    }

    fn composite(&self, segments: &[Value], depth: usize) -> Result<Vec<Curve>, Fault> {
        let mut all = Vec::new();
        for segment in segments.iter().filter_map(id_of) {
            if let Some([.., Value::Id(part)]) = self.parts(segment, b"COMPOSITE_CURVE_SEGMENT") {
                all.extend(self.bounded(*part, None, depth)?);
            }
        }
        Ok(all)
    }

    fn bound(&self, values: &[Value]) -> Option<Bound> {
        values.iter().find_map(|value| match value {
            Value::Typed(name, values) if name == b"PARAMETER_VALUE" => match values[..] {
                [Value::Number(t)] => Some(Bound::Parameter(t)),
                _ => None,
            },
            Value::Id(point) => self.point(*point).map(Bound::Place),
            _ => None,
        })
    }

    fn line(&self, at: u64, vector: u64, bounds: Option<([Bound; 2], bool)>) -> Option<Curve> {
        let [_, Value::Id(direction), Value::Number(length)] = self.parts(vector, b"VECTOR")? else {
            return None;
        };
        let (at, along) = (self.point(at)?, scale(unit(self.direction(*direction)?), *length));
        let place = |bound: Bound| match bound {
            Bound::Parameter(t) => add_scaled(at, along, t),
            Bound::Place(p) => p,
        };
        let (ends, _) = bounds?;
        Some((ends.map(place).to_vec(), Some((CurveKind::Line, None))))
    }

    fn ellipse(&self, place: u64, [a, b]: [f64; 2], bounds: Option<([Bound; 2], bool)>) -> Option<Curve> {
        let [centre, x, y] = self.placement(place)?;
        let parameter = |bound: Bound| match bound {
            Bound::Parameter(t) => t * self.angle,
            Bound::Place(p) => (dot(sub(p, centre), y) / b).atan2(dot(sub(p, centre), x) / a),
        };
        let range = match bounds {
            None => [0.0, TAU],
            Some((ends, same)) => {
                let [from, to] = ends.map(parameter);
                let sweep = (if same { to - from } else { from - to }).rem_euclid(TAU);
                // Ends that rounding alone sets apart are those of the whole.
                let sweep = if sweep < 1e-9 { TAU } else { sweep };
                [from, if same { from + sweep } else { from - sweep }]
            }
        };
        let mut points = ellipse(centre, scale(x, a), scale(y, b), range)?;
        if let Some(([Bound::Place(from), Bound::Place(to)], _)) = bounds {
            let last = points.len() - 1;
            (points[0], points[last]) = (from, to);
        }
        let kind = if a == b { (CurveKind::Circle, Some(a)) } else { (CurveKind::Ellipse, None) };
        Some((points, Some(kind)))
    }

    /// A spline between bounds: the points of the whole, cut at the nearest of them.
    fn along(&self, spline: &Spline, bounds: Option<([Bound; 2], bool)>) -> Result<Curve, String> {
        let points = spline.points()?;
        let kind = if spline.degree == 1 && points.len() == 2 { CurveKind::Line } else { CurveKind::Spline };
        let Some((ends, same)) = bounds else { return Ok((points, Some((kind, None)))) };
        let domain = [spline.knots[spline.degree], spline.knots[spline.controls.len()]];
        let nearest = |bound: Bound| match bound {
            Bound::Parameter(t) => {
                ((t - domain[0]) / (domain[1] - domain[0]) * (points.len() - 1) as f64).round() as usize
            }
            Bound::Place(p) => {
                let apart = |i: &usize| norm(sub(points[*i], p));
                (0..points.len()).min_by(|i, j| apart(i).total_cmp(&apart(j))).unwrap_or(0)
            }
        };
        let [mut from, mut to] = ends.map(nearest).map(|i| i.min(points.len() - 1));
        if !same {
            (from, to) = (to, from);
        }
        let mut cut = if from < to { points[from..=to].to_vec() } else { points.clone() };
        if let [Bound::Place(first), Bound::Place(last)] = if same { ends } else { [ends[1], ends[0]] } {
            let end = cut.len() - 1;
            (cut[0], cut[end]) = (first, last);
        }
        Ok((cut, Some((kind, None))))
    }

    /// The parameters of an instance of a type.
    fn parts(&self, id: u64, name: &[u8]) -> Option<&'a [Value]> {
        let records = &self.instances.get(&id)?.records;
        records.iter().find(|r| r.0 == name).map(|r| &r.1[..])
    }

    pub(super) fn point(&self, id: u64) -> Option<[f64; 3]> {
        let [_, Value::List(numbers)] = self.parts(id, b"CARTESIAN_POINT")? else { return None };
        three(numbers)
    }

    fn direction(&self, id: u64) -> Option<[f64; 3]> {
        let [_, Value::List(numbers)] = self.parts(id, b"DIRECTION")? else { return None };
        three(numbers).filter(|d| norm(*d) > 0.0)
    }

    fn vertex(&self, id: u64) -> Option<[f64; 3]> {
        let [_, Value::Id(point)] = self.parts(id, b"VERTEX_POINT")? else { return None };
        self.point(*point)
    }

    /// Origin, first and second axis.
    fn placement(&self, id: u64) -> Option<[[f64; 3]; 3]> {
        let [_, Value::Id(at), axis, first] = self.parts(id, b"AXIS2_PLACEMENT_3D")? else { return None };
        let z = unit(id_of(axis).map_or(Some([0.0, 0.0, 1.0]), |d| self.direction(d))?);
        let first = id_of(first).map_or(Some(perpendicular(z)), |d| self.direction(d))?;
        let x = sub(first, scale(z, dot(first, z)));
        let x = if norm(x) > 0.0 { unit(x) } else { perpendicular(z) };
        Some([self.point(*at)?, x, cross(z, x)])
    }
}

fn id_of(value: &Value) -> Option<u64> {
    if let Value::Id(id) = value { Some(*id) } else { None }
}

fn is_true(value: &Value) -> bool {
    !matches!(value, Value::Word(word) if word == b"F")
}

/// Two or three numbers as a place.
fn three(numbers: &[Value]) -> Option<[f64; 3]> {
    let numbers: Option<Vec<f64>> =
        numbers.iter().map(|n| if let Value::Number(x) = n { Some(*x) } else { None }).collect();
    match numbers?[..] {
        [x, y, z] => Some([x, y, z]),
        [x, y] => Some([x, y, 0.0]),
        _ => None,
    }
}

/// The spline of an instance, which may be complex; the inner `None` is one whose parameters are not all there.
fn spline(model: &Model, instance: &Instance) -> Option<Option<Spline>> {
    let part = |name: &[u8]| instance.records.iter().find(|r| r.0 == name).map(|r| &r.1[..]);
    let numbers = |value: &Value| match value {
        Value::List(list) => {
            list.iter().map(|n| if let Value::Number(x) = n { Some(*x) } else { None }).collect()
        }
        _ => None,
    };
    let with_knots = part(b"B_SPLINE_CURVE_WITH_KNOTS")?;
    // Alone it has all parameters, beside B_SPLINE_CURVE those of the knots.
    let (head, knots) = match part(b"B_SPLINE_CURVE") {
        Some(head) => (head, with_knots),
        None if with_knots.len() >= 9 => (&with_knots[1..6], &with_knots[6..]),
        None => return Some(None),
    };
    let made = || {
        let [Value::Number(degree), Value::List(controls), ..] = head else { return None };
        let [often, places, ..] = knots else { return None };
        let (often, places): (Vec<f64>, Vec<f64>) = (numbers(often)?, numbers(places)?);
        let total: f64 = often.iter().sum();
        // As many as the controls ask for, whatever the file says.
        if !(0.0..=2.0 * controls.len() as f64 + 64.0).contains(&total) {
            return None;
        }
        let knots =
            places.iter().zip(&often).flat_map(|(&k, &n)| std::iter::repeat_n(k, n as usize)).collect();
        let weights = part(b"RATIONAL_B_SPLINE_CURVE").map_or(Some(Vec::new()), |r| numbers(r.first()?))?;
        let controls = controls.iter().map(|c| model.point(id_of(c)?)).collect::<Option<Vec<_>>>()?;
        Some(Spline { degree: degree.max(0.0) as usize, knots, controls, weights })
    };
    Some(made())
}
