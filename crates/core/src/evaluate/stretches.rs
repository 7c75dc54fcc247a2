//! What was found rightly, what was missed and what is false, as stretches of lines.

use super::lines::Lines;
use super::sides::{Row, Scoring, Sides, length};

/// The verdict on a stretch of line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Found, and near a known line, or where it counts neither way.
    Right,
    /// Known, and far from every found line.
    Missed,
    /// Found, and far from every known line.
    False,
}

impl Verdict {
    /// All of them.
    pub const ALL: [Verdict; 3] = [Verdict::Right, Verdict::Missed, Verdict::False];

    /// The name in files: `right`, `missed` or `false`.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Right => "right",
            Verdict::Missed => "missed",
            Verdict::False => "false",
        }
    }
}

/// A stretch of a line with one verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// The verdict on it.
    pub verdict: Verdict,
    /// The line: of those that were found, or, where it was missed, of those that are known; weak ones are not counted.
    pub line: usize,
    /// `(M, 3)` points, a fifth of a spacing apart or less.
    pub points: Vec<[f64; 3]>,
    /// Its length.
    pub length: f64,
}

/// The stretches of all lines: found ones, right or false, then known ones that were missed. Lines are near each other up to
/// `tolerance` spacings.
pub fn stretches(found: &Lines, known: &Lines, scoring: &Scoring, tolerance: f64) -> Vec<Stretch> {
    let sides = Sides::new(found, known, scoring);
    let mut all = Vec::new();
    for (number, row) in sides.found.iter().enumerate() {
        let far = |p| sides.to_truth(p).is_some_and(|d| d > tolerance);
        all.extend(runs(row, number, far, Verdict::False));
    }
    for (number, row) in sides.known.iter().enumerate() {
        let far = |p| sides.away_from_found(p) > tolerance;
        // What is right is shown where it was found.
        all.extend(runs(row, number, far, Verdict::Missed).filter(|s| s.verdict == Verdict::Missed));
    }
    all
}

/// The runs of a row by whether its samples are far, which is `verdict`. Each goes on to the first sample of the next, so that
/// there is no gap between them.
fn runs(
    row: &Row,
    line: usize,
    far: impl Fn([f64; 3]) -> bool,
    verdict: Verdict,
) -> impl Iterator<Item = Stretch> {
    let is_far: Vec<bool> = row.points.iter().map(|&p| far(p)).collect();
    let (mut first, mut all) = (0, Vec::new());
    for run in is_far.chunk_by(|a, b| a == b) {
        let end = first + run.len();
        let points = row.points[first..(end + 1).min(is_far.len())].to_vec();
        let verdict = if run[0] { verdict } else { Verdict::Right };
        let length = length(&points);
        all.push(Stretch { verdict, line, points, length });
        first = end;
    }
    all.into_iter().filter(|s| s.points.len() > 1)
}
