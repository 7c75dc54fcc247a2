//! Named runs beside what a part has.

use super::parts::known::{Kind, Known};
use lineament::section::{Feature, Run, Sections, Stack};

/// A length of a named feature beside the true one, in spacings.
#[derive(Clone, Debug)]
pub struct Off {
    pub error: f64,
    /// How far off it may be, as the run states; infinite where nothing is stated.
    pub stated: f64,
    /// The run.
    pub text: String,
}

/// What became of one cloud.
#[derive(Clone, Debug, Default)]
pub struct Verdict {
    /// Both ends of each named feature.
    pub ends: Vec<Off>,
    /// Radii and apexes.
    pub sizes: Vec<Off>,
    /// Features that are not named.
    pub missing: Vec<String>,
    /// Runs that are no feature.
    pub extra: Vec<String>,
    /// Features named.
    pub named: usize,
}

/// Slices of a feature from which on it is to be named.
fn enough(kind: Kind) -> usize {
    if matches!(kind, Kind::Revolution(_)) { 4 } else { 2 }
}

/// Holds a stack against the features; `shift` is what heights along the axis are moved by.
pub fn judge(known: &[Known], shift: f64, sections: &Sections, stack: &Stack) -> Verdict {
    let h = sections.spacing;
    let mut verdict = Verdict::default();
    let mut taken = vec![false; stack.runs.len()];
    for k in known {
        let (from, to) = (k.from + shift, k.to + shift);
        let off = |r: &Run| (r.from - from).abs().max((r.to - to).abs());
        let overlaps = |r: &Run| r.from.max(from) + h < r.to.min(to);
        let fitting = |&i: &usize| {
            let r = &stack.runs[i];
            !taken[i] && r.hole == k.hole && same(k.kind, r, h) && overlaps(r)
        };
        let best = (0..taken.len())
            .filter(fitting)
            .min_by(|&a, &b| off(&stack.runs[a]).total_cmp(&off(&stack.runs[b])));
        // A slice half a spacing from a face may show it.
        let within = |z: &&f64| (from + 0.5 * h..=to - 0.5 * h).contains(*z);
        let slices = sections.heights.iter().filter(within).count();
        match best {
            Some(i) => {
                taken[i] = true;
                verdict.named += 1;
                compare(k, shift, &stack.runs[i], h, &mut verdict);
            }
            None if !k.optional && slices >= enough(k.kind) => verdict.missing.push(format!(
                "{}{:?} {:.2}..{:.2} of {slices} slices",
                if k.hole { "hole " } else { "" },
                k.kind,
                k.from,
                k.to
            )),
            None => {}
        }
    }
    let left = stack.runs.iter().zip(&taken).filter(|(_, taken)| !**taken);
    verdict.extra = left.map(|(r, _)| text(r, shift, h)).collect();
    verdict
}

fn same(kind: Kind, run: &Run, h: f64) -> bool {
    match (kind, &run.feature) {
        (Kind::Extrusion(a), Feature::Extrusion { radius: b }) => {
            a.is_some() == b.is_some() && a.zip(*b).is_none_or(|(a, b)| (a - b).abs() <= h)
        }
        (Kind::Taper(..), Feature::Taper { .. }) => true,
        (Kind::Revolution(_), Feature::Revolution { .. }) => true,
        _ => false,
    }
}

fn compare(k: &Known, shift: f64, run: &Run, h: f64, verdict: &mut Verdict) {
    let what = text(run, shift, h);
    let ends = [(run.from, k.from), (run.to, k.to)];
    for ((found, truth), stated) in ends.into_iter().zip(run.range_error) {
        let text = format!("{truth:.3}: {what}");
        verdict.ends.push(Off { error: (found - shift - truth) / h, stated: stated / h, text });
    }
    let mut size = |found: f64, truth: f64| {
        if truth.is_finite() {
            let text = what.clone();
            verdict.sizes.push(Off { error: (found - truth) / h, stated: f64::INFINITY, text });
        }
    };
    match (k.kind, run.feature) {
        (Kind::Extrusion(Some(a)), Feature::Extrusion { radius: Some(b) }) => size(b, a),
        (Kind::Taper(a, r), Feature::Taper { apex, radius, .. }) => {
            // An apex is extrapolated: a twentieth of its distance stands for the tenth of a spacing asked of the rest.
            let far = (a - k.from).abs().max((a - k.to).abs());
            size(h * (apex - a - shift) / (0.5 * far), 0.0);
            if let Some(r) = r {
                size(radius.unwrap_or(f64::MAX), r);
            }
        }
        _ => {}
    }
}

fn text(run: &Run, shift: f64, h: f64) -> String {
    let kind = match run.feature {
        Feature::Extrusion { radius } => format!("extrusion r {radius:.3?}"),
        Feature::Taper { angle_deg, apex, radius } => {
            format!("taper {angle_deg:.1} apex {:.3} r {radius:.3?}", apex - shift)
        }
        Feature::Revolution { least, most } => format!("revolution {least:.3} to {most:.3}"),
    };
    let hole = if run.hole { "hole " } else { "" };
    let [a, b] = run.range_error.map(|e| e / h);
    let (n, from, to) = (run.contours.len(), run.from - shift, run.to - shift);
    format!("{hole}{kind} {from:.3}..{to:.3} (+-{a:.2} {b:.2} h) in {n}")
}
