//! Gaps that have samples in them, bridged.
//!
//! Points strewn at random, and faces cut near their rim, leave stretches of a curve whose samples are too few, or too much to
//! one side of the plane, to agree on nodes. They do not show how the curve runs, but they show that the surface goes on:
//! two loose ends are joined over them, while the ends at a border of the surface, with nothing between them, stay.

use super::carry::Sample;
use super::join::{End, Joint};
use super::packed::Packed;
use super::vec2::{along, distance, dot, local, meet, sub, unit};

/// Longest bridge, in local spacings.
pub(crate) const LONGEST: f64 = 30.0;
/// How far from each place of a bridge a sample is looked for, along and across it, in local spacings.
const BESIDE: (f64, f64) = (1.0, 0.6);
/// Least cosine between a bridge and the curve as a sample on it has it.
const ALIKE: f64 = 0.7;

/// The samples of a slab, and a tree over their feet.
pub(crate) struct Support<'a> {
    pub samples: &'a [Sample],
    pub tree: &'a Packed,
}

impl Support<'_> {
    /// A bridge between two ends: straight, or by the corner in which their straight continuations meet.
    pub(crate) fn joint(&self, ends: &[End], a: usize, b: usize) -> Option<Joint> {
        let (e, f) = (&ends[a], &ends[b]);
        let spacing = 0.5 * (e.spacing + f.spacing);
        let bridge = |corner: Option<[f64; 2]>| {
            let path: Vec<[f64; 2]> = [Some(e.at), corner, Some(f.at)].into_iter().flatten().collect();
            let length: f64 = path.windows(2).map(|w| distance(w[0], w[1])).sum();
            let holds = || path.windows(2).all(|w| self.holds(w[0], w[1], spacing));
            (length <= LONGEST * spacing && holds()).then(|| Joint { cost: length / spacing, a, b, corner })
        };
        bridge(None).or_else(|| bridge(Some(corner(e, f, spacing)?)))
    }

    /// Whether samples lie all along a straight stretch; what its ends and corners hide is taken for granted.
    fn holds(&self, from: [f64; 2], to: [f64; 2], spacing: f64) -> bool {
        let (length, way) = (distance(from, to), unit(sub(to, from)));
        let mut found = Vec::new();
        let steps = (length / spacing).ceil().max(1.0);
        (0..=steps as usize).all(|k| {
            let at = length * k as f64 / steps;
            at.min(length - at) < BESIDE.0 * spacing || {
                let place = along(from, way, at);
                self.tree.within(place, BESIDE.0 * spacing, &mut found);
                found.iter().map(|&i| &self.samples[i as usize]).any(|s| {
                    let (_, across) = local(way, place, s.foot);
                    across.abs() <= BESIDE.1 * spacing && dot(s.tangent, way).abs() >= ALIKE
                })
            }
        })
    }
}

/// Where two ends would meet if both went straight on.
fn corner(e: &End, f: &End, spacing: f64) -> Option<[f64; 2]> {
    let (ahead, behind) = meet(e.at, e.out, f.at, f.out)?;
    (ahead.min(behind) >= -1.2 * spacing).then(|| along(e.at, e.out, ahead))
}

#[cfg(test)]
mod tests {
    use super::super::chain::{Chain, Vertex};
    use super::super::join::joined;
    use super::*;

    fn sample(foot: [f64; 2], tangent: [f64; 2]) -> Sample {
        Sample {
            raw: foot,
            foot,
            tangent,
            drift: [0.0; 2],
            lift: 0.0,
            lifts: (0.0, 0.0),
            weight: 1.0,
            spacing: 1.0,
            blur: 0.02,
            count: 1,
            weak: false,
        }
    }

    /// Two chains a spacing a vertex, and what they become with samples every 1.5 spacings of a path.
    fn with(ends: [[[f64; 2]; 2]; 2], path: &[[f64; 2]], turned: bool) -> Vec<Chain> {
        let line = |[from, to]: [[f64; 2]; 2]| {
            let (length, way) = (distance(from, to), unit(sub(to, from)));
            let vertices = (0..=length as usize).map(|k| Vertex::new(along(from, way, k as f64), 1.0));
            Chain { vertices: vertices.collect(), closed: false }
        };
        let mut samples = Vec::new();
        for w in path.windows(2) {
            let (length, way) = (distance(w[0], w[1]), unit(sub(w[1], w[0])));
            let tangent = if turned { [-way[1], way[0]] } else { way };
            let places = (0..=(length / 1.5) as usize).map(|k| along(w[0], way, 1.5 * k as f64));
            samples.extend(places.map(|foot| sample(foot, tangent)));
        }
        let feet: Vec<[f64; 2]> = samples.iter().map(|s| s.foot).collect();
        let support = Support { samples: &samples, tree: &Packed::new(&feet) };
        joined(ends.map(line).into(), &[], &support)
    }

    #[test]
    fn ends_are_joined_over_samples_that_run_their_way() {
        let ends = [[[0.0, 0.0], [30.0, 0.0]], [[44.0, 0.0], [70.0, 0.0]]];
        let between = [[30.0, 0.2], [44.0, 0.2]];
        assert_eq!(with(ends, &between, false).len(), 1);
        assert_eq!(with(ends, &between, true).len(), 2, "samples of a curve across");
        assert_eq!(with(ends, &[], false).len(), 2, "a border of the surface");
        assert_eq!(with(ends, &[[30.0, 0.2], [36.0, 0.2]], false).len(), 2, "samples half the way");
    }

    #[test]
    fn ends_are_joined_by_the_corner_that_samples_lead_to() {
        let ends = [[[0.0, 0.0], [30.0, 0.0]], [[40.0, 40.0], [40.0, 10.0]]];
        let found = with(ends, &[[30.0, 0.0], [40.0, 0.0], [40.0, 10.0]], false);
        assert_eq!(found.len(), 1);
        let corner = found[0].vertices.iter().find(|v| v.corner).unwrap();
        assert!(distance(corner.at, [40.0, 0.0]) < 1e-9);
    }
}
