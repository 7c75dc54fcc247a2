//! Entities as curves.

use super::super::sample::{Spline, ellipse, object_axes};
use super::group::{Fault, Group, number};
use lineament::evaluate::CurveKind;
use lineament::math::vec3::{add, add_scaled, cross, norm, scale, sub, unit};

/// Points of a curve, and its type with the radius of a circle.
type Curve = (Vec<[f64; 3]>, Option<(CurveKind, Option<f64>)>);

/// An entity with its groups in order; a POLYLINE with those of its vertices.
pub(super) struct Entity {
    head: Group,
    groups: Vec<Group>,
    /// The groups of each vertex of a POLYLINE.
    vertices: Vec<Vec<Group>>,
    in_vertices: bool,
}

impl Entity {
    pub fn new(head: Group) -> Self {
        Self { head, groups: Vec::new(), vertices: Vec::new(), in_vertices: false }
    }

    pub fn name(&self) -> &[u8] {
        &self.head.value
    }

    pub fn layer(&self) -> &[u8] {
        self.groups.iter().find(|g| g.code == 8).map_or(&[], |g| &g.value)
    }

    pub fn is_polyline(&self) -> bool {
        self.name() == b"POLYLINE"
    }

    pub fn begin_vertex(&mut self) {
        self.vertices.push(Vec::new());
        self.in_vertices = true;
    }

    pub fn end_vertices(&mut self) {
        self.in_vertices = false;
    }

    pub fn push(&mut self, group: Group) {
        match self.vertices.last_mut().filter(|_| self.in_vertices) {
            Some(vertex) => vertex.push(group),
            None => self.groups.push(group),
        }
    }

    /// The curves of the entity; `None` for one that is none.
    pub fn curves(&self) -> Result<Option<Vec<Curve>>, Fault> {
        let curves = match self.name() {
            b"LINE" => vec![(vec![self.place(10)?, self.place(11)?], Some((CurveKind::Line, None)))],
            b"CIRCLE" | b"ARC" => vec![self.arc()?],
            b"ELLIPSE" => vec![self.ellipse()?],
            b"SPLINE" => match self.spline()? {
                Some(curve) => vec![curve],
                None => return Ok(None),
            },
            b"LWPOLYLINE" => self.flat(self.lightweight()?, self.value(38, 0.0)?)?,
            // Meshes of faces are written as POLYLINE too.
            b"POLYLINE" if self.flags() & (16 | 64) == 0 => self.polyline()?,
            _ => return Ok(None),
        };
        Ok(Some(curves))
    }

    fn flags(&self) -> i64 {
        self.value(70, 0.0).unwrap_or(0.0) as i64
    }

    /// The first number of a group, or the default.
    fn value(&self, code: i32, default: f64) -> Result<f64, Fault> {
        self.groups.iter().find(|g| g.code == code).map_or(Ok(default), number)
    }

    /// A number that must be there.
    fn needed(&self, code: i32) -> Result<f64, Fault> {
        let group = self.groups.iter().find(|g| g.code == code);
        let missing =
            || (self.head.line, format!("{} without group {code}", String::from_utf8_lossy(self.name())));
        number(group.ok_or_else(missing)?)
    }

    fn all(&self, code: i32) -> Result<Vec<f64>, Fault> {
        self.groups.iter().filter(|g| g.code == code).map(number).collect()
    }

    /// The place of the groups `code`, `code + 10` and `code + 20`, of which the last may be missing.
    fn place(&self, code: i32) -> Result<[f64; 3], Fault> {
        Ok([self.needed(code)?, self.needed(code + 10)?, self.value(code + 20, 0.0)?])
    }

    /// The axes of the plane of the entity.
    fn axes(&self) -> Result<[[f64; 3]; 3], Fault> {
        let normal = [self.value(210, 0.0)?, self.value(220, 0.0)?, self.value(230, 1.0)?];
        Ok(object_axes(if norm(normal) > 0.0 { normal } else { [0.0, 0.0, 1.0] }))
    }

    fn arc(&self) -> Result<Curve, Fault> {
        let [x, y, z] = self.axes()?;
        let (centre, radius) = (in_world(self.place(10)?, [x, y, z]), self.needed(40)?);
        let whole = self.name() == b"CIRCLE";
        let from = if whole { 0.0 } else { self.needed(50)?.to_radians() };
        let to = if whole { std::f64::consts::TAU } else { after(from, self.needed(51)?.to_radians()) };
        let points = ellipse(centre, scale(x, radius), scale(y, radius), [from, to]).unwrap_or_default();
        Ok((points, Some((CurveKind::Circle, Some(radius)))))
    }

    fn ellipse(&self) -> Result<Curve, Fault> {
        let [_, _, normal] = self.axes()?;
        let (centre, major, ratio) = (self.place(10)?, self.place(11)?, self.needed(40)?);
        let minor = scale(cross(normal, major), ratio);
        let from = self.value(41, 0.0)?;
        let to = after(from, self.value(42, std::f64::consts::TAU)?);
        let points = ellipse(centre, major, minor, [from, to]).unwrap_or_default();
        let round = (ratio - 1.0).abs() < 1e-9;
        let kind = if round { (CurveKind::Circle, Some(norm(major))) } else { (CurveKind::Ellipse, None) };
        Ok((points, Some(kind)))
    }

    /// `None` where the file has the points that a spline goes through alone.
    fn spline(&self) -> Result<Option<Curve>, Fault> {
        let coordinates = [self.all(10)?, self.all(20)?, self.all(30)?];
        let count = coordinates[0].len();
        if count == 0 {
            return Ok(None);
        }
        if coordinates.iter().any(|c| c.len() != count) {
            return Err((self.head.line, "SPLINE with controls that lack a coordinate".into()));
        }
        let controls = (0..count).map(|i| [0, 1, 2].map(|a| coordinates[a][i])).collect();
        let (degree, knots, weights) = (self.value(71, 3.0)?, self.all(40)?, self.all(41)?);
        let spline = Spline { degree: degree.max(0.0) as usize, knots, controls, weights };
        let points = spline.points().map_err(|what| (self.head.line, what))?;
        let straight = spline.degree == 1 && points.len() == 2;
        Ok(Some((points, Some((if straight { CurveKind::Line } else { CurveKind::Spline }, None)))))
    }

    /// The corners of an LWPOLYLINE, each with the bulge behind it.
    fn lightweight(&self) -> Result<Vec<([f64; 2], f64)>, Fault> {
        let mut corners: Vec<([f64; 2], f64)> = Vec::new();
        for group in &self.groups {
            match (group.code, corners.last_mut()) {
                (10, _) => corners.push(([number(group)?, 0.0], 0.0)),
                (20, Some(corner)) => corner.0[1] = number(group)?,
                (42, Some(corner)) => corner.1 = number(group)?,
                _ => {}
            }
        }
        Ok(corners)
    }

    fn polyline(&self) -> Result<Vec<Curve>, Fault> {
        let vertex = |groups: &Vec<Group>| -> Result<Option<([f64; 3], f64)>, Fault> {
            let value = |code: i32| groups.iter().find(|g| g.code == code).map_or(Ok(0.0), number);
            // The frame of a curve is no part of it.
            let frame = value(70)? as i64 & 16 != 0;
            Ok((!frame).then_some(([value(10)?, value(20)?, value(30)?], value(42)?)))
        };
        let vertices: Vec<Option<([f64; 3], f64)>> =
            self.vertices.iter().map(vertex).collect::<Result<_, Fault>>()?;
        let vertices: Vec<([f64; 3], f64)> = vertices.into_iter().flatten().collect();
        if self.flags() & 8 == 0 {
            let height = self.value(30, 0.0)?;
            return self.flat(vertices.iter().map(|&([x, y, _], bulge)| ([x, y], bulge)).collect(), height);
        }
        let mut points: Vec<[f64; 3]> = vertices.iter().map(|v| v.0).collect();
        if self.flags() & 1 != 0 {
            points.extend(points.first().copied());
        }
        let typed = (points.len() == 2).then_some((CurveKind::Line, None));
        Ok(vec![(points, typed)])
    }

    /// Lines and arcs between the corners of a plane polyline.
    fn flat(&self, corners: Vec<([f64; 2], f64)>, height: f64) -> Result<Vec<Curve>, Fault> {
        let (axes, closed) = (self.axes()?, self.flags() & 1 != 0);
        let pairs = corners.len().saturating_sub(usize::from(!closed));
        let curve = |i: usize| {
            let (a, bulge) = corners[i];
            let (b, _) = corners[(i + 1) % corners.len()];
            let [from, to] = [a, b].map(|[x, y]| in_world([x, y, height], axes));
            bulged(from, to, bulge, axes[2])
        };
        Ok((0..pairs).map(curve).filter(|(points, _)| points.first() != points.last()).collect())
    }
}

/// From the coordinates of the plane of an entity to those of the world.
fn in_world([x, y, z]: [f64; 3], [u, v, w]: [[f64; 3]; 3]) -> [f64; 3] {
    add(add(scale(u, x), scale(v, y)), scale(w, z))
}

/// The angle, at most a turn after `from`.
fn after(from: f64, to: f64) -> f64 {
    let sweep = (to - from).rem_euclid(std::f64::consts::TAU);
    from + if sweep > 0.0 { sweep } else { std::f64::consts::TAU }
}

/// The arc between two points whose bulge is the tangent of a quarter of its angle; a line without.
fn bulged(from: [f64; 3], to: [f64; 3], bulge: f64, normal: [f64; 3]) -> Curve {
    let chord = sub(to, from);
    if bulge == 0.0 || norm(chord) == 0.0 {
        return (vec![from, to], Some((CurveKind::Line, None)));
    }
    let half = norm(chord) / 2.0;
    // Height of the centre over the chord, to the left of it for a bulge of less than half a turn.
    let (radius, height) =
        (half * (1.0 + bulge * bulge) / (2.0 * bulge.abs()), half * (1.0 - bulge * bulge) / (2.0 * bulge));
    let middle = add_scaled(from, chord, 0.5);
    let centre = add_scaled(middle, unit(cross(normal, chord)), height);
    let x = sub(from, centre);
    let y = scale(cross(normal, x), bulge.signum());
    let mut points = ellipse(centre, x, y, [0.0, 4.0 * bulge.abs().atan()]).unwrap_or_default();
    if let Some(last) = points.last_mut() {
        *last = to;
    }
    (points, Some((CurveKind::Circle, Some(radius))))
}
