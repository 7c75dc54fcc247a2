//! A typed curve as an object of the schema `lineament-network/2`.

use crate::write::encode::json::{Number, Point, list};
use lineament::curve::pieces::{Piece, Shape, Sigma};
use lineament::curve::{BSpline, Ellipse, Round};
use std::io::{self, Write};

/// Type, range, ends, parameters, how well they are known, and how far relations moved it.
pub(super) fn piece(out: &mut dyn Write, piece: &Piece, moved: Option<f64>) -> io::Result<()> {
    let Piece { shape, from, to, first, last, deviation, sigma } = piece;
    write!(out, "{{\"type\": \"{}\", \"range\": [{first}, {last}], ", shape.name())?;
    write!(out, "\"from\": {}, \"to\": {}", Point(from), Point(to))?;
    match shape {
        Shape::Line => {}
        Shape::Arc { round, sweep } => {
            circle(out, round)?;
            write!(out, ", \"sweep_deg\": {}", Number(sweep.to_degrees()))?;
        }
        Shape::Circle(round) => circle(out, round)?,
        Shape::Ellipse { ellipse: found, sweep } => {
            ellipse(out, found)?;
            write!(out, ", \"sweep_deg\": {}", Number(sweep.to_degrees()))?;
        }
        Shape::Spline(curve) => spline(out, curve)?,
    }
    write!(out, ", \"deviation\": {}", Number(*deviation))?;
    if let Some(known) = sigma {
        deviations(out, known)?;
    }
    if let Some(moved) = moved {
        write!(out, ", \"moved\": {}", Number(moved))?;
    }
    write!(out, "}}")
}

/// Standard deviations, of circles and ellipses also the covariance of centre and size.
fn deviations(out: &mut dyn Write, sigma: &Sigma) -> io::Result<()> {
    match sigma {
        Sigma::Line { offset, direction } => {
            let direction = Number(direction.to_degrees());
            write!(out, ", \"sigma\": {{\"offset\": {}, \"direction_deg\": {direction}}}", Number(*offset))
        }
        Sigma::Round { radius, normal, covariance } => {
            let center = [0, 1, 2].map(|i| covariance[i][i].sqrt());
            write!(out, ", \"sigma\": {{\"radius\": {}, \"center\": {}", Number(*radius), Point(&center))?;
            write!(out, ", \"normal_deg\": {}}}", Number(normal.to_degrees()))?;
            rows(out, covariance)
        }
        Sigma::Ellipse { turn, normal, covariance } => {
            let [x, y, z, major, minor] = std::array::from_fn(|i| covariance[i][i].sqrt());
            write!(out, ", \"sigma\": {{\"major\": {}, \"minor\": {}", Number(major), Number(minor))?;
            write!(out, ", \"center\": {}, \"turn_deg\": ", Point(&[x, y, z]))?;
            write!(out, "{}, \"normal_deg\": {}}}", Number(turn.to_degrees()), Number(normal.to_degrees()))?;
            rows(out, covariance)
        }
    }
}

fn rows<const N: usize>(out: &mut dyn Write, covariance: &[[f64; N]; N]) -> io::Result<()> {
    write!(out, ", \"covariance\": [")?;
    list(out, covariance, |out, _, row| {
        write!(out, "[")?;
        list(out, row, |out, _, &c| write!(out, "{}", Number(c)))?;
        write!(out, "]")
    })?;
    write!(out, "]")
}

fn ellipse(out: &mut dyn Write, ellipse: &Ellipse) -> io::Result<()> {
    let Ellipse { centre, normal, major, minor } = ellipse;
    write!(out, ", \"center\": {}, \"normal\": {}", Point(centre), Point(normal))?;
    write!(out, ", \"major\": {}, \"minor\": {}", Point(major), Number(*minor))
}

fn circle(out: &mut dyn Write, round: &Round) -> io::Result<()> {
    let Round { centre, normal, radius } = round;
    write!(out, ", \"center\": {}, \"normal\": {}", Point(centre), Point(normal))?;
    write!(out, ", \"radius\": {}", Number(*radius))
}

/// Degree, knots and control points.
pub(super) fn spline(out: &mut dyn Write, curve: &BSpline) -> io::Result<()> {
    let BSpline { degree, knots, controls, periodic } = curve;
    write!(out, ", \"degree\": {degree}, \"periodic\": {periodic}, \"knots\": [")?;
    list(out, knots, |out, _, &knot| write!(out, "{}", Number(knot)))?;
    write!(out, "], \"controls\": [")?;
    list(out, controls, |out, _, control| write!(out, "{}", Point(control)))?;
    write!(out, "]")
}
