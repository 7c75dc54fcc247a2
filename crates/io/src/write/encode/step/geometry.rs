//! Points, directions, placements and curves (ISO 10303-42).

use super::{Id, List, Real, Step};
use lineament::curve::{BSpline, Ellipse, Round};
use lineament::math::vec3::{distance, norm, sub, unit};
use std::io;

impl Step<'_> {
    pub fn point(&mut self, [x, y, z]: [f64; 3]) -> io::Result<Id> {
        self.add(format_args!("CARTESIAN_POINT('',({},{},{}))", Real(x), Real(y), Real(z)))
    }

    fn direction(&mut self, [x, y, z]: [f64; 3]) -> io::Result<Id> {
        self.add(format_args!("DIRECTION('',({},{},{}))", Real(x), Real(y), Real(z)))
    }

    /// A place with its third and its first axis.
    pub fn placement(&mut self, at: [f64; 3], axis: [f64; 3], first: [f64; 3]) -> io::Result<Id> {
        let (at, axis, first) = (self.point(at)?, self.direction(axis)?, self.direction(first)?);
        self.add(format_args!("AXIS2_PLACEMENT_3D('',#{at},#{axis},#{first})"))
    }

    /// The line through two points; its parameter is the length from the first.
    pub fn line(&mut self, from: [f64; 3], to: [f64; 3]) -> io::Result<Id> {
        let (at, along) = (self.point(from)?, self.direction(unit(sub(to, from)))?);
        let vector = self.add(format_args!("VECTOR('',#{along},1.)"))?;
        self.add(format_args!("LINE('',#{at},#{vector})"))
    }

    /// A circle; its parameter is the angle from `first`, a point of its plane.
    pub fn circle(&mut self, name: &str, round: &Round, first: [f64; 3]) -> io::Result<Id> {
        let towards = unit(sub(first, round.centre));
        let place = self.placement(round.centre, round.normal, towards)?;
        self.add(format_args!("CIRCLE('{name}',#{place},{})", Real(round.radius)))
    }

    /// An ellipse; its parameter is that of its own.
    pub fn ellipse(&mut self, name: &str, ellipse: &Ellipse) -> io::Result<Id> {
        let size = norm(ellipse.major);
        let place = self.placement(ellipse.centre, ellipse.normal, unit(ellipse.major))?;
        self.add(format_args!("ELLIPSE('{name}',#{place},{},{})", Real(size), Real(ellipse.minor)))
    }

    /// A curve from a parameter of its basis to another.
    pub fn trimmed(&mut self, name: &str, basis: Id, [from, to]: [f64; 2]) -> io::Result<Id> {
        self.add(format_args!(
            "TRIMMED_CURVE('{name}',#{basis},(PARAMETER_VALUE({})),(PARAMETER_VALUE({})),.T.,.PARAMETER.)",
            Real(from),
            Real(to)
        ))
    }

    /// The segment between two points.
    pub fn segment(&mut self, name: &str, [from, to]: [[f64; 3]; 2]) -> io::Result<Id> {
        let line = self.line(from, to)?;
        self.trimmed(name, line, [0.0, distance(from, to)])
    }

    /// A polyline through points.
    pub fn polyline(&mut self, name: &str, points: &[[f64; 3]]) -> io::Result<Id> {
        let points: Vec<Id> = points.iter().map(|&p| self.point(p)).collect::<io::Result<_>>()?;
        self.add(format_args!("POLYLINE('{name}',{})", List(&points)))
    }

    /// A B-spline, in the clamped form if it is periodic.
    pub fn spline(&mut self, name: &str, curve: &BSpline) -> io::Result<Id> {
        let closed = if curve.periodic { "T" } else { "F" };
        let curve = curve.clamped();
        let controls: Vec<Id> = curve.controls.iter().map(|&p| self.point(p)).collect::<io::Result<_>>()?;
        let knots: Vec<&[f64]> = curve.knots.chunk_by(|a, b| a == b).collect();
        let joined = |text: Vec<String>| text.join(",");
        let often = joined(knots.iter().map(|k| k.len().to_string()).collect());
        let places = joined(knots.iter().map(|k| Real(k[0]).to_string()).collect());
        self.add(format_args!(
            "B_SPLINE_CURVE_WITH_KNOTS('{name}',{},{},.UNSPECIFIED.,.{closed}.,.F.,({often}),({places}),.UNSPECIFIED.)",
            curve.degree,
            List(&controls)
        ))
    }
}
