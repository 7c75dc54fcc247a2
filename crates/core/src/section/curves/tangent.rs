//! Lines and arcs that touch: least squares under the condition that neighbours are tangent.
//!
//! The sum of the squared distances of all data is least under the conditions, by Gauss-Newton steps with Lagrange's multipliers
//! (Nocedal and Wright, Numerical Optimization, 2006, section 18.1, equation 18.6, with the matrix of the distances' first derivatives).

use super::data::Datum;
use super::primitive::Primitive;
use crate::curve::circle::Circle;
use crate::curve::line::Line;
use crate::math::dense;
use crate::math::vec2::{along, distance, dot, left, sub, unit};

/// Steps at most.
const STEPS: usize = 25;
/// Step, spacings or radians, from which on the sum is least.
const SETTLED: f64 = 1e-6;
/// Error of a condition, spacings, at which it holds.
const HOLDS: f64 = 1e-11;
/// Least distance of the centres of circles that touch, in radii: nearer ones are one circle.
const CONCENTRIC: f64 = 1e-3;
/// Added to the diagonal, relative to its own entry, so that a short arc can be solved.
const RIDGE: f64 = 1e-10;

/// A curve with the data that it is fitted to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Fitted<'a> {
    pub curve: Primitive,
    pub data: &'a [Datum],
}

impl Fitted<'_> {
    /// The weighted squared distances of its data.
    pub(super) fn squares(&self) -> f64 {
        self.data.iter().map(|d| d.weight * self.curve.off(d.at).powi(2)).sum()
    }

    /// The number of its parameters: the turn and the shift of a line, the centre and the radius of a circle.
    fn unknowns(&self) -> usize {
        match self.curve {
            Primitive::Line(_) => 2,
            Primitive::Arc { .. } => 3,
            Primitive::Free => 0,
        }
    }

    /// The distance of a datum with its derivatives.
    fn row(&self, p: [f64; 2]) -> ([f64; 3], f64) {
        match self.curve {
            Primitive::Line(line) => {
                let (d, normal) = (sub(p, line.at), left(line.direction));
                ([-dot(line.direction, d), -1.0, 0.0], dot(normal, d))
            }
            Primitive::Arc { circle, .. } => {
                let d = sub(p, circle.centre);
                let u = unit(d);
                ([-u[0], -u[1], -1.0], dot(d, d).sqrt() - circle.radius)
            }
            Primitive::Free => ([0.0; 3], 0.0),
        }
    }

    fn moved(&mut self, step: &[f64]) {
        match &mut self.curve {
            Primitive::Line(line) => {
                line.at = along(line.at, left(line.direction), step[1]);
                line.direction = unit(along(line.direction, left(line.direction), step[0]));
            }
            Primitive::Arc { circle, .. } => {
                circle.centre = along(circle.centre, [step[0], step[1]], 1.0);
                // Not through a point at once.
                circle.radius = (circle.radius + step[2]).max(0.25 * circle.radius);
            }
            Primitive::Free => {}
        }
    }
}

/// The condition that two curves touch: its error and the derivatives by the parameters of both. `None` where they cannot.
fn condition(a: &Primitive, b: &Primitive) -> Option<(f64, [f64; 3], [f64; 3])> {
    match (a, b) {
        (Primitive::Line(line), Primitive::Arc { circle, left }) => Some(beside(line, circle, *left)),
        (Primitive::Arc { circle, left }, Primitive::Line(line)) => {
            let (error, of_line, of_circle) = beside(line, circle, *left);
            Some((error, of_circle, of_line))
        }
        (Primitive::Arc { circle: a, left: l }, Primitive::Arc { circle: b, left: m }) => {
            let apart = distance(a.centre, b.centre);
            if apart <= CONCENTRIC * a.radius.max(b.radius) {
                return None;
            }
            let u = unit(sub(a.centre, b.centre));
            // Circles that turn alike touch from within.
            let signs = match (l == m, a.radius >= b.radius) {
                (true, true) => [1.0, -1.0],
                (true, false) => [-1.0, 1.0],
                (false, _) => [1.0, 1.0],
            };
            let error = apart - signs[0] * a.radius - signs[1] * b.radius;
            Some((error, [u[0], u[1], -signs[0]], [-u[0], -u[1], -signs[1]]))
        }
        _ => None,
    }
}

/// A circle touches the line from the side that it turns to.
fn beside(line: &Line, circle: &Circle, turns_left: bool) -> (f64, [f64; 3], [f64; 3]) {
    let (d, normal) = (sub(circle.centre, line.at), left(line.direction));
    let side = if turns_left { 1.0 } else { -1.0 };
    let error = dot(normal, d) - side * circle.radius;
    (error, [-dot(line.direction, d), -1.0, 0.0], [normal[0], normal[1], -side])
}

/// The curves under the conditions that the pairs `touch`, or `None` where no such curves are found near them.
pub(super) fn solve<'a>(
    curves: &[Fitted<'a>],
    touch: &[(usize, usize)],
    error: f64,
) -> Option<Vec<Fitted<'a>>> {
    let mut found = curves.to_vec();
    let firsts: Vec<usize> =
        found.iter().scan(0, |sum, f| Some(std::mem::replace(sum, *sum + f.unknowns()))).collect();
    let unknowns: usize = found.iter().map(Fitted::unknowns).sum();
    for _ in 0..STEPS {
        let conditions: Vec<_> =
            touch.iter().map(|&(a, b)| condition(&found[a].curve, &found[b].curve)).collect::<Option<_>>()?;
        let n = unknowns + conditions.len();
        let (mut matrix, mut right) = (vec![vec![0.0; n]; n], vec![0.0; n]);
        for (f, &first) in found.iter().zip(&firsts) {
            normal_equations(f, first, error, &mut matrix, &mut right);
        }
        for (k, (&(a, b), (off, of_a, of_b))) in touch.iter().zip(&conditions).enumerate() {
            right[unknowns + k] = -off;
            for (piece, own) in [(a, of_a), (b, of_b)] {
                for j in 0..found[piece].unknowns() {
                    matrix[unknowns + k][firsts[piece] + j] += own[j];
                    matrix[firsts[piece] + j][unknowns + k] += own[j];
                }
            }
        }
        let step = dense::solve(matrix, right)?;
        for (f, &first) in found.iter_mut().zip(&firsts) {
            let count = f.unknowns();
            f.moved(&step[first..first + count]);
        }
        let greatest = step[..unknowns].iter().fold(0.0, |most: f64, s| most.max(s.abs()));
        let errors = conditions.iter().fold(0.0, |most: f64, c| most.max(c.0.abs()));
        if greatest < SETTLED && errors < HOLDS {
            return Some(found);
        }
    }
    None
}

/// A curve of least weighted squares near another; that one where none is found.
pub(super) fn settled<'a>(fitted: Fitted<'a>, error: f64) -> Fitted<'a> {
    solve(&[fitted], &[], error).map_or(fitted, |found| found[0])
}

/// Adds the normal equations of one curve's data.
fn normal_equations(f: &Fitted, first: usize, error: f64, matrix: &mut [Vec<f64>], right: &mut [f64]) {
    let count = f.unknowns();
    let per_variance = 1.0 / (error * error);
    for d in f.data {
        let (row, off) = f.row(d.at);
        let weight = d.weight * per_variance;
        for i in 0..count {
            right[first + i] -= weight * row[i] * off;
            (0..count).for_each(|j| matrix[first + i][first + j] += weight * row[i] * row[j]);
        }
    }
    (first..first + count).for_each(|i| matrix[i][i] *= 1.0 + RIDGE);
}
