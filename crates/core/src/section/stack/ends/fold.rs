//! A fold into a slanted wall: the planes beside the outline meet the upright wall at one height. First the planes of
//! single points tell about where; then one line through the points themselves tells it to a fraction of the spacing.

use super::end::{By, End};
use super::ground::{Spot, ahead_of_start};
use super::meet::{FEWEST_MEETS, Fitted, Meet, meet};
use super::rim;
use super::search::Search;

/// Share of the points on slanted walls that must show a fold.
const FOLD_SHARE: f64 = 0.35;
/// Distance from an edge beyond which planes show one face, spacings: without noise, and for each spacing of noise.
pub(super) const CLEAR_OF_EDGE: (f64, f64) = (1.6, 2.0);
/// Spread of the slopes of one wall, degrees: without noise, and for each spacing of noise.
const ALIKE_DEG: (f64, f64) = (4.0, 40.0);

/// The height at which the slanted walls beside an outline meet it.
pub(super) fn fold(search: &Search, spots: &[Spot], h: f64, noise: f64) -> Option<End> {
    let forward = (search.outer - search.inner).signum();
    let straight = if search.upright { straight_fold(search, spots, h, noise) } else { None };
    let level = rim::rim(search, spots, h, noise).filter(|f| search.holds_slow(f.ahead));
    let (first, by) = match (straight, level) {
        (Some(a), Some(b)) if a.ahead >= b.ahead - 0.5 * h => (b, By::Rim),
        (Some(a), _) => (a, By::Fold),
        (None, b) => (b?, By::Rim),
    };
    Some(End { height: search.inner + first.ahead * forward, error: first.error, by })
}

/// The height of a straight fold.
fn straight_fold(search: &Search, spots: &[Spot], h: f64, noise: f64) -> Option<Fitted> {
    let width = (0.4 + 2.5 * noise) * h;
    let forward = (search.outer - search.inner).signum();
    let near = |f: &Fitted| search.holds(search.inner + f.ahead * forward);
    let all = meets(search, spots, h, noise);
    let ahead = meets(search, ahead_of_start(search, spots), h, noise);
    straight(&ahead, width, h, noise, Lies::Beyond)
        .filter(near)
        // Where a small part of the outline folds, slices some way beyond still nearly show it.
        .or_else(|| straight(&all, width, h, noise, Lies::Beyond).filter(|f| search.holds_slow(f.ahead)))
        .or_else(|| straight(&all, width, h, noise, Lies::Behind).filter(near))
}

/// Where a slanted wall lies, from the height at which it meets the outline: beyond it, or over the run's own wall as that of
/// a dovetail does.
#[derive(Clone, Copy, PartialEq)]
enum Lies {
    Beyond,
    Behind,
}

/// Slanted planes that are clear of their edge, by where they meet the outline.
fn meets(search: &Search, spots: &[Spot], h: f64, noise: f64) -> Vec<Meet> {
    let clear = (CLEAR_OF_EDGE.0 + CLEAR_OF_EDGE.1 * noise) * h;
    let slanted = spots.iter().filter(|s| s.fits).filter_map(|s| meet(search, s, h, noise));
    let mut all: Vec<Meet> = slanted.filter(|m| m.off.hypot(m.own - m.ahead) >= clear).collect();
    all.sort_by(|a, b| a.ahead.total_cmp(&b.ahead));
    all
}

/// The height at which most planes meet the outline.
fn straight(all: &[Meet], width: f64, h: f64, noise: f64, lies: Lies) -> Option<Fitted> {
    let window = |i: usize| i..all.partition_point(|a| a.ahead <= all[i].ahead + width);
    let fullest = (0..all.len()).map(window).max_by_key(|w| (w.len(), std::cmp::Reverse(w.start)))?;
    let found = &all[fullest];
    if found.len() < FEWEST_MEETS || (found.len() as f64) < FOLD_SHARE * all.len() as f64 {
        return None;
    }
    let at = |share: f64| found[((found.len() - 1) as f64 * share) as usize].ahead;
    let ahead = at(0.5);
    let lies_so = |a: &&Meet| match lies {
        Lies::Beyond => a.own >= ahead - 0.5 * h,
        Lies::Behind => a.own <= ahead + 0.5 * h,
    };
    let there = found.iter().filter(lies_so).count();
    // A wall over the run's own may end before it reaches that.
    let reach = (CLEAR_OF_EDGE.0 + CLEAR_OF_EDGE.1 * noise + 1.0) * h;
    let reaches = lies == Lies::Beyond || found.iter().any(|a| a.off.hypot(a.own - ahead) <= reach);
    let error = 1.3 * (at(0.84) - at(0.16)) / (found.len() as f64).sqrt() + 1e-2 * h;
    let refined = line(all, ahead, width, noise).filter(|f| (f.ahead - ahead).abs() <= width);
    (reaches && 4 * there >= 3 * found.len()).then_some(refined.unwrap_or(Fitted { ahead, error }))
}

/// The height at which a line through the points themselves, by their distance from the outline, meets it: of walls that
/// lean alike.
fn line(all: &[Meet], ahead: f64, width: f64, noise: f64) -> Option<Fitted> {
    let mut near: Vec<Meet> = all.iter().filter(|m| (m.ahead - ahead).abs() <= width).copied().collect();
    let mut leans: Vec<f64> = near.iter().map(|m| m.rise.atan().to_degrees()).collect();
    leans.sort_by(f64::total_cmp);
    let at = |share: f64| leans[((leans.len() - 1) as f64 * share) as usize];
    if near.len() < FEWEST_MEETS || at(0.84) - at(0.16) > ALIKE_DEG.0 + ALIKE_DEG.1 * noise {
        return None;
    }
    let mut found = None;
    for _ in 0..3 {
        // Noise moves points across the wall, so that the line is the one of least distances across itself.
        let n = near.len() as f64;
        let mean = |of: &dyn Fn(&Meet) -> f64| near.iter().map(of).sum::<f64>() / n;
        let (x, y) = (mean(&|m| m.off), mean(&|m| m.own));
        let xx = mean(&|m| (m.off - x).powi(2));
        let yy = mean(&|m| (m.own - y).powi(2));
        let xy = mean(&|m| (m.off - x) * (m.own - y));
        let (sine, cosine) = (0.5 * (2.0 * xy).atan2(xx - yy)).sin_cos();
        let rest = |m: &Meet| (m.own - y) * cosine - (m.off - x) * sine;
        let sigma = (near.iter().map(|m| rest(m).powi(2)).sum::<f64>() / (n - 2.0)).sqrt();
        let wide = n * (xx * cosine * cosine + 2.0 * xy * sine * cosine + yy * sine * sine);
        // How far along the line the outline lies from the middle of the points.
        let lever = x / cosine;
        let error = sigma / cosine * (1.0 / n + lever * lever / wide).sqrt();
        found = Some(Fitted { ahead: y - x * sine / cosine, error }).filter(|f| f.ahead.is_finite());
        near.retain(|m| rest(m).abs() <= 2.5 * sigma);
        if near.len() < FEWEST_MEETS {
            break;
        }
    }
    found
}
