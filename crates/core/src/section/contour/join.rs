//! Chains joined at corners and over gaps into contours.
//!
//! Loose ends are paired greedily by cost, in rounds of growing reach: two that look straight at each other over a gap,
//! two whose straight continuations meet in a corner, or two so close that it does not matter how they look. The rest
//! is bridged where samples lie between.

use super::bridge::Support;
use super::chain::Chain;
use super::end::{End, Joint, ends_of, may_join};
use super::splice::splice;
use super::stray;
use crate::math::trees::kd::Tree;
use crate::math::vec2::{along, cross, distance, dot, meet, sub};

/// Extra cost of a joint to a weak end, in local spacings.
const WEAK_COST: f64 = 2.5;
/// Ends this close, in local spacings, belong together whichever way they look.
const TOUCHING: f64 = 3.0;

/// Joins the ends of chains, the nearest first, and leaves out strays: open chains shorter than `shortest` local spacings,
/// and those along others or along `settled` contours. Contours, longest first.
pub(crate) fn joined(
    mut chains: Vec<Chain>,
    settled: &[Chain],
    support: &Support,
    shortest: f64,
) -> Vec<Chain> {
    for reach in [2.5, 5.0, 9.0] {
        chains = join(chains, 1.5 * reach, |ends, a, b| joint(ends, a, b, reach));
    }
    chains = join(chains, support.longest, |ends, a, b| support.joint(ends, a, b));
    stray::dropped(chains, settled, shortest)
}

/// Joins ends at most some spacings apart by a rule, the cheapest joints first.
fn join(chains: Vec<Chain>, reach: f64, rule: impl Fn(&[End], usize, usize) -> Option<Joint>) -> Vec<Chain> {
    if chains.iter().all(|c| c.closed) {
        return chains;
    }
    let ends: Vec<End> = chains.iter().enumerate().filter(|(_, c)| !c.closed).flat_map(ends_of).collect();
    let places: Vec<[f64; 2]> = ends.iter().map(|e| e.at).collect();
    let tree = Tree::new(&places);
    let (mut joints, mut found) = (Vec::new(), Vec::new());
    for (a, end) in ends.iter().enumerate() {
        tree.within(end.at, reach * end.spacing, &mut found);
        let later = found.iter().map(|&b| b as usize).filter(|&b| b > a && may_join(end, &ends[b]));
        joints.extend(later.filter_map(|b| rule(&ends, a, b)));
    }
    for j in &mut joints {
        j.cost += if ends[j.a].weak || ends[j.b].weak { WEAK_COST } else { 0.0 };
    }
    joints.sort_by(|x, y| x.cost.total_cmp(&y.cost).then((x.a, x.b).cmp(&(y.a, y.b))));
    let mut mate = vec![None; ends.len()];
    for j in &joints {
        if mate[j.a].is_none() && mate[j.b].is_none() {
            mate[j.a] = Some((j.b, j.corner));
            mate[j.b] = Some((j.a, j.corner));
        }
    }
    splice(chains, &ends, &mate)
}

fn joint(ends: &[End], a: usize, b: usize, reach: f64) -> Option<Joint> {
    let (e, f) = (&ends[a], &ends[b]);
    let spacing = 0.5 * (e.spacing + f.spacing);
    let gap = distance(e.at, f.at);
    let turn = (-dot(e.out, f.out)).clamp(-1.0, 1.0).acos().to_degrees();
    let near =
        (gap <= TOUCHING * spacing).then_some(Joint { cost: TOUCHING + gap / spacing, a, b, corner: None });
    if turn < 30.0 {
        return straight(e, f, gap, spacing, reach).map(|cost| Joint { cost, a, b, corner: None }).or(near);
    }
    corner(e, f, spacing, reach, turn).map(|(cost, at)| Joint { cost, a, b, corner: Some(at) }).or(near)
}

fn corner(e: &End, f: &End, spacing: f64, reach: f64, turn: f64) -> Option<(f64, [f64; 2])> {
    let (ahead, behind) = meet(e.at, e.out, f.at, f.out)?;
    let late = |x: f64| if x < 0.0 { -2.0 * x } else { x };
    let cost = (late(ahead) + late(behind)) / spacing;
    let back = -1.2 * spacing;
    if turn > 165.0 || ahead < back || behind < back || cost > reach {
        return None;
    }
    Some((cost + 0.3, along(e.at, e.out, ahead)))
}

fn straight(e: &End, f: &End, gap: f64, spacing: f64, reach: f64) -> Option<f64> {
    let step = sub(f.at, e.at);
    let (forward, aside) = (dot(step, e.out), cross(e.out, step).abs().min(cross(f.out, step).abs()));
    let fits = forward > -0.7 * spacing && aside <= 0.3 * gap + 0.4 * spacing && gap <= reach * spacing;
    fits.then_some((gap + aside) / spacing)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::trees::packed::Packed;
    use crate::math::vec2::unit;
    use crate::section::contour::chain::Vertex;
    use crate::section::surface::carry::Sample;

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
        let support = Support { samples: &samples, tree: &Packed::new(&feet), longest: 30.0 };
        joined(ends.map(line).into(), &[], &support, 4.0)
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
