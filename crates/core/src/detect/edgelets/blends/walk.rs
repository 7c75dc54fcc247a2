//! The surface in a cross-section followed from the seed to both sides, step by step.

use super::super::section::Across;
use crate::math::vec2;

/// Length of a step, and the half length of the window of points at each, spacings.
const STEP: f64 = 0.5;
const WINDOW: f64 = 0.5;
/// Greatest distance of a point from the tangent of the place before, in spacings, and what a spacing of noise adds.
const OFF: (f64, f64) = (0.5, 2.5);
/// Least cosine of a normal to that of the place before.
const ALIKE: f64 = 0.2;
/// Steps over which a gap without points may go.
const GAP: usize = 3;
/// Steps to each side.
const STEPS: usize = 26;

/// A place on the surface of a section.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) at: [f64; 2],
    /// Unit tangent, onwards.
    pub(super) tangent: [f64; 2],
    /// Length along the surface from the seed.
    pub(super) along: f64,
    /// Turn of the tangent since the first place, radians.
    pub(super) turn: f64,
}

/// The places along the surface in order, and the points beside them.
#[derive(Debug, Default)]
pub(super) struct Walk {
    pub(super) places: Vec<Place>,
    /// The points with their length along the surface; infinite for those of other faces.
    lengths: Vec<f64>,
}

impl Walk {
    /// Follows the surface through the points of a section, in spacings.
    pub(super) fn along(&mut self, points: &[Across], noise: f64) {
        self.lengths.clear();
        self.lengths.resize(points.len(), f64::INFINITY);
        let start = Place { at: [0.0; 2], tangent: [0.0, 1.0], along: 0.0, turn: 0.0 };
        self.places.clear();
        let back = Place { tangent: [0.0, -1.0], ..start };
        self.follow(points, noise, back, -1.0);
        self.places.reverse();
        for place in &mut self.places {
            place.tangent = place.tangent.map(|x| -x);
        }
        self.places.push(start);
        self.follow(points, noise, start, 1.0);
        let mut turn = 0.0;
        for k in 1..self.places.len() {
            let [a, b] = [self.places[k - 1].tangent, self.places[k].tangent];
            turn += vec2::cross(a, b).atan2(vec2::dot(a, b));
            self.places[k].turn = turn;
        }
        self.places[0].turn = 0.0;
    }

    /// The points beside the places within a range of lengths.
    pub(super) fn points<'a>(
        &'a self,
        points: &'a [Across],
        [from, to]: [f64; 2],
    ) -> impl Iterator<Item = [f64; 2]> + 'a {
        points.iter().zip(&self.lengths).filter(move |(_, l)| (from..=to).contains(*l)).map(|(p, _)| p.raw)
    }

    fn follow(&mut self, points: &[Across], noise: f64, start: Place, sign: f64) {
        let mut at = start;
        let mut gap = 0;
        let off = OFF.0 + OFF.1 * noise;
        for _ in 0..STEPS {
            let Place { at: from, tangent, along, .. } = at;
            let ahead = vec2::along(from, tangent, STEP);
            let normal = vec2::left(tangent);
            let along = along + sign * STEP;
            let (mut height, mut facing, mut count) = (0.0, [0.0; 2], 0);
            for (p, length) in points.iter().zip(&mut self.lengths) {
                let (l, h) = vec2::local(tangent, ahead, p.place);
                let side = vec2::dot(p.normal, normal);
                if l.abs() <= WINDOW && h.abs() <= off && side.abs() >= ALIKE {
                    (height, count) = (height + h, count + 1);
                    facing = vec2::along(facing, p.normal, side.signum());
                    if length.is_infinite() {
                        *length = along + sign * l;
                    }
                }
            }
            gap = if count < 2 { gap + 1 } else { 0 };
            if gap > GAP {
                gap = GAP;
                break;
            }
            let (at_place, tangent) = match count {
                0 | 1 => (ahead, tangent),
                _ => {
                    let n = vec2::unit(facing);
                    (vec2::along(ahead, normal, height / f64::from(count)), [n[1], -n[0]])
                }
            };
            at = Place { at: at_place, tangent, along, turn: 0.0 };
            self.places.push(at);
        }
        let kept = self.places.len() - gap;
        self.places.truncate(kept);
    }
}
