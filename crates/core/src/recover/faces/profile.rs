//! The cross-section of two faces that meet: a pair of half lines, bent a little, from the edge outwards.

use super::sweep::Seen;
use std::f64::consts::TAU;

/// Directions among which the two faces are sought first.
const DIRECTIONS: usize = 48;
/// Angle beyond which a point speaks for neither of two faces, in steps of the directions.
const FAR: f64 = 6.0;
/// Least angle between two faces, in steps of the directions.
const APART: usize = 4;

/// One face in the cross-section.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Face {
    /// Angle of its direction away from the edge.
    pub angle: f64,
    /// Its curvature at the edge, positive to the left of one who leaves the edge.
    pub bend: f64,
}

/// A point relative to a face: how far from the edge along the face, and how far off the face to the left.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Place {
    pub along: f64,
    pub off: f64,
}

impl Face {
    /// Where a point of the cross-section lies.
    pub(in crate::recover) fn place(&self, [x, y]: [f64; 2]) -> Place {
        let (sin, cos) = self.angle.sin_cos();
        let along = cos * x + sin * y;
        Place { along, off: cos * y - sin * x - 0.5 * self.bend * along * along }
    }

    /// Distance from the face, which ends at the edge.
    fn distance(&self, at: [f64; 2]) -> f64 {
        let Place { along, off } = self.place(at);
        if along >= 0.0 { off.abs() } else { at[0].hypot(at[1]) }
    }
}

/// The two faces.
#[derive(Clone, Copy, Debug)]
pub(in crate::recover) struct Profile {
    pub faces: [Face; 2],
}

impl Profile {
    /// The two directions from the edge near which most points lie.
    pub(in crate::recover) fn start(seen: &[Seen]) -> Option<Self> {
        let mut counts = [0.0; DIRECTIONS];
        let step = TAU / DIRECTIONS as f64;
        for s in seen {
            let angle = s.at[1].atan2(s.at[0]).rem_euclid(TAU);
            counts[(angle / step) as usize % DIRECTIONS] += 1.0;
        }
        // Most directions have no point.
        let seen: Vec<(usize, f64)> = counts.into_iter().enumerate().filter(|c| c.1 > 0.0).collect();
        let apart = |a: usize, b: usize| {
            let d = a.abs_diff(b);
            d.min(DIRECTIONS - d)
        };
        let cost = |a: usize, b: usize| -> f64 {
            let one = |&(k, n): &(usize, f64)| n * (apart(k, a).min(apart(k, b)) as f64).min(FAR).powi(2);
            seen.iter().map(one).sum()
        };
        let mut best = (f64::INFINITY, 0, 0);
        for a in 0..DIRECTIONS {
            for b in (a + 1..DIRECTIONS).filter(|&b| apart(a, b) >= APART) {
                let cost = cost(a, b);
                if cost < best.0 {
                    best = (cost, a, b);
                }
            }
        }
        let face = |k: usize| Face { angle: (k as f64 + 0.5) * step, bend: 0.0 };
        best.0.is_finite().then(|| Profile { faces: [face(best.1), face(best.2)] })
    }

    /// The face to which a point belongs, and its place there.
    pub(in crate::recover) fn nearest(&self, at: [f64; 2]) -> (usize, Place) {
        let [a, b] = &self.faces;
        let k = usize::from(b.distance(at) < a.distance(at));
        (k, self.faces[k].place(at))
    }

    /// The sine of the angle by which the faces fold.
    pub(in crate::recover) fn fold_sine(&self) -> f64 {
        (self.faces[0].angle - self.faces[1].angle).sin().abs()
    }
}
