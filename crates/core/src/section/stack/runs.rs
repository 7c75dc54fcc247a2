//! Tracks cut into runs, and runs that repeat.

use super::super::nest;
use super::super::result::Sections;
use super::super::vec2::{along, distance, onto, sub};
use super::profile::Profile;
use super::track::Track;
use super::{Feature, Repeat, Run};

/// Fewest slices of a taper or revolution: two always agree, and a third may by chance.
const LEAST: usize = 4;

/// A run with its lowest, middle and highest contour.
pub(super) struct Found<'a> {
    pub run: Run,
    pub profiles: [&'a Profile; 3],
}

/// The runs of a track. Extrusions come first, as they are the strictest: where the outline stays and then jumps. What
/// lies between them is the taper or revolution that reaches farthest; a run of one slice is none.
pub(super) fn runs<'a>(track: &Track<'a>, sections: &Sections, tolerance: f64) -> Vec<Found<'a>> {
    let all = &track.profiles;
    let mut found = Vec::new();
    let mut first = 0;
    while first + 1 < all.len() {
        let best = settled_extrusion(all, first, tolerance).or_else(|| {
            let rest = &all[..next_extrusion(all, first, tolerance)];
            let taper = reach(rest, first, LEAST, |p| taper(p, tolerance));
            let turned = reach(rest, first, LEAST, |p| revolution(p, tolerance));
            [taper, turned].into_iter().flatten().reduce(|a, b| if b.0 > a.0 { b } else { a })
        });
        let Some((last, feature, residual)) = best else {
            first += 1;
            continue;
        };
        let own = &all[first..=last];
        let below = if first == 0 { track.below } else { Some(all[first - 1].height) };
        let above = if last + 1 == all.len() { track.above } else { Some(all[last + 1].height) };
        let run = run(own, [below, above], feature, residual, sections);
        found.push(Found { run, profiles: [own[0], own[own.len() / 2], own[own.len() - 1]] });
        first = last + 1;
    }
    found
}

/// An extrusion from `first` whose outline does not drift: where the track goes on, it jumps. On a dome or a cone
/// neighbouring slices agree within the tolerance too, but go on changing as they did.
fn settled_extrusion(all: &[&Profile], first: usize, tolerance: f64) -> Option<Reached> {
    let found = reach(all, first, 2, |p| extrusion(p, tolerance))?;
    let middle = all[(first + found.0) / 2];
    let settled = |end: usize, next: Option<&&Profile>| {
        let Some(next) = next else { return true };
        let (drift, jump) = (all[end].apart(middle, [0.0; 2]), next.apart(middle, [0.0; 2]));
        jump >= JUMP * tolerance || drift <= 0.2 * jump
    };
    let before = first.checked_sub(1).and_then(|k| all.get(k));
    // Three slices at least show that nothing drifts, where nothing jumps.
    (settled(first, before) && settled(found.0, all.get(found.0 + 1))).then_some(found)
}

/// How far an outline jumps at the end of an extrusion, in tolerances.
const JUMP: f64 = 3.0;

/// Where the next extrusion after `first` begins, or the end of the track.
fn next_extrusion(all: &[&Profile], first: usize, tolerance: f64) -> usize {
    (first + 1..all.len()).find(|&k| settled_extrusion(all, k, tolerance).is_some()).unwrap_or(all.len())
}

type Reached = (usize, Feature, f64);

/// The last slice up to which a kind holds.
fn reach(
    all: &[&Profile],
    first: usize,
    least: usize,
    test: impl Fn(&[&Profile]) -> Option<(Feature, f64)>,
) -> Option<Reached> {
    let mut best = None;
    for last in first + least - 1..all.len() {
        match test(&all[first..=last]) {
            Some((feature, residual)) => best = Some((last, feature, residual)),
            None => break,
        }
    }
    best
}

fn extrusion(profiles: &[&Profile], tolerance: f64) -> Option<(Feature, f64)> {
    let middle = profiles[profiles.len() / 2];
    let mut worst = 0.0f64;
    for p in profiles {
        worst = worst.max(p.apart(middle, [0.0; 2]));
        if worst > tolerance {
            return None;
        }
    }
    let radii: Option<Vec<f64>> = profiles.iter().map(|p| p.round.map(|r| r.radius)).collect();
    let radius = radii.map(|r| r.iter().sum::<f64>() / r.len() as f64);
    Some((Feature::Extrusion { radius }, worst))
}

/// Whether each outline lies where the first and the last, blended by height, would put it.
fn taper(profiles: &[&Profile], tolerance: f64) -> Option<(Feature, f64)> {
    let (low, high) = (profiles[0], profiles[profiles.len() - 1]);
    let span = high.height - low.height;
    let foot = |p: [f64; 2]| nearest(p, &high.points);
    let feet: Vec<[f64; 2]> = low.points.iter().map(|&p| foot(p)).collect();
    let mut worst = 0.0f64;
    for p in &profiles[1..profiles.len() - 1] {
        let share = (p.height - low.height) / span;
        let blend: Vec<[f64; 2]> =
            low.points.iter().zip(&feet).map(|(&a, &b)| along(a, sub(b, a), share)).collect();
        worst = worst.max(nest::apart(&blend, &p.points, true).0);
    }
    let moved = (high.area.sqrt() - low.area.sqrt()) / span;
    if worst > tolerance || !moved.is_finite() || moved == 0.0 {
        return None;
    }
    let mean_length = profiles.iter().map(|p| p.length).sum::<f64>() / profiles.len() as f64;
    let angle_deg = ((high.area - low.area) / span / mean_length).atan().to_degrees();
    let apex = low.height - low.area.sqrt() / moved;
    let radius = profiles.iter().all(|p| p.round.is_some()).then(|| low.round.map(|r| r.radius)).flatten();
    Some((Feature::Taper { angle_deg, apex, radius }, worst))
}

fn nearest(p: [f64; 2], ring: &[[f64; 2]]) -> [f64; 2] {
    let mut best = (f64::INFINITY, p);
    for (k, &a) in ring.iter().enumerate() {
        let b = ring[(k + 1) % ring.len()];
        let (share, off) = onto(a, b, p);
        if off < best.0 {
            best = (off, along(a, sub(b, a), share));
        }
    }
    best.1
}

fn revolution(profiles: &[&Profile], tolerance: f64) -> Option<(Feature, f64)> {
    let rounds: Option<Vec<_>> = profiles.iter().map(|p| p.round).collect();
    let rounds = rounds?;
    let centre = rounds[rounds.len() / 2].centre;
    let worst = rounds.iter().map(|r| distance(r.centre, centre)).fold(0.0, f64::max);
    let least = rounds.iter().map(|r| r.radius).fold(f64::INFINITY, f64::min);
    let most = rounds.iter().map(|r| r.radius).fold(0.0, f64::max);
    (worst <= tolerance).then_some((Feature::Revolution { least, most }, worst))
}

fn run(
    own: &[&Profile],
    beside: [Option<f64>; 2],
    feature: Feature,
    residual: f64,
    sections: &Sections,
) -> Run {
    let (first, last) = (own[0], own[own.len() - 1]);
    let middle = own[own.len() / 2];
    let [x, y] = middle.round.map_or(middle.centroid, |r| r.centre);
    let ends = [(first.height, beside[0]), (last.height, beside[1])];
    let [from, to] = ends.map(|(own, next)| next.map_or(own, |n| 0.5 * (own + n)));
    let range_error = ends.map(|(own, next)| next.map_or(f64::INFINITY, |n| 0.5 * (n - own).abs()));
    Run {
        feature,
        hole: first.hole,
        from,
        to,
        range_error,
        residual,
        centre: sections.frame.vector([x, y, middle.height]),
        contours: own.iter().map(|p| p.id).collect(),
    }
}

/// Groups of runs with the same outline, laid over each other by their centroids.
pub(super) fn repeats(runs: &[Found], tolerance: f64) -> Vec<Repeat> {
    let mut grouped = vec![false; runs.len()];
    let mut found = Vec::new();
    for i in 0..runs.len() {
        if grouped[i] {
            continue;
        }
        let mut repeat = Repeat { runs: vec![i], residual: 0.0 };
        for j in i + 1..runs.len() {
            if let Some(off) = same(&runs[i], &runs[j], tolerance).filter(|_| !grouped[j]) {
                grouped[j] = true;
                repeat.runs.push(j);
                repeat.residual = repeat.residual.max(off);
            }
        }
        if repeat.runs.len() > 1 {
            found.push(repeat);
        }
    }
    found
}

fn same(a: &Found, b: &Found, tolerance: f64) -> Option<f64> {
    let extruded = |r: &Run| matches!(r.feature, Feature::Extrusion { .. });
    let alike = a.run.hole == b.run.hole && extruded(&a.run) && extruded(&b.run);
    let size = (a.profiles[1].area.sqrt() - b.profiles[1].area.sqrt()).abs();
    if !alike || size > 4.0 * tolerance {
        return None;
    }
    let off = a.profiles[1].apart(b.profiles[1], a.profiles[1].onto(b.profiles[1]));
    (off <= tolerance).then_some(off)
}
