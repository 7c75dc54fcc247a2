//! Circles through stretches of lines.

use crate::curve::Round;
use crate::math::vec3::distance;
use crate::pattern::{LineGraph, paths};
use crate::surface::Scales;

/// Lengths of the stretches, in spacings, of which one begins at every half.
const LENGTHS: [f64; 4] = [4.0, 8.0, 16.0, 32.0];
/// Fewest vertices of a stretch.
const FEWEST: usize = 4;
/// Least angle that a stretch goes about the centre, radians.
const ANGLE: f64 = 0.8;
/// Least and greatest radius, in spacings.
const RADIUS: (f64, f64) = (1.0, 60.0);
/// Greatest root mean square distance of the vertices from the circle, in spacings, and the share of the noise added to it.
const OFF: (f64, f64) = (0.3, 0.5);

/// The circles, line by line.
pub(super) fn circles(lines: &LineGraph, scales: Scales) -> Vec<Round> {
    let mut circles = Vec::new();
    for path in paths(lines) {
        let mut places: Vec<[f64; 3]> = path.vertices.iter().map(|&v| lines.positions[v as usize]).collect();
        if path.ends.is_none() {
            places.extend_from_within(..1);
        }
        let middle = path.vertices[path.vertices.len() / 2];
        let resolution = scales.at(lines.points[middle as usize] as usize);
        let (h, most) = (resolution.spacing, OFF.0 * resolution.spacing + OFF.1 * resolution.noise);
        let mut whole = false;
        for length in LENGTHS.map(|l| l * h) {
            let mut from = 0;
            while !whole && from < places.len() {
                let to = end(&places, from, length);
                whole = from == 0 && to == places.len();
                circles.extend(of_stretch(&places[from..to], h, most));
                from = end(&places, from, 0.5 * length).max(from + 1);
                if to == places.len() {
                    break;
                }
            }
        }
    }
    circles
}

/// One past the last place within a length from one on.
fn end(places: &[[f64; 3]], from: usize, length: f64) -> usize {
    let mut gone = 0.0;
    for k in from + 1..places.len() {
        gone += distance(places[k - 1], places[k]);
        if gone > length {
            return k;
        }
    }
    places.len()
}

/// The circle of a stretch if it goes on along one for long enough.
fn of_stretch(places: &[[f64; 3]], h: f64, most: f64) -> Option<Round> {
    let round = Round::fit(places).filter(|_| places.len() >= FEWEST)?;
    let off2 = places.iter().map(|&p| distance(p, round.foot(p)).powi(2)).sum::<f64>() / places.len() as f64;
    let sized = (RADIUS.0 * h..=RADIUS.1 * h).contains(&round.radius);
    (sized && off2 <= most * most && round.sweep(places).abs() >= ANGLE).then_some(round)
}
