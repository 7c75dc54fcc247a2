//! A fold into a slanted wall along a curve that is level at one place, as the rim of a countersink cut from the side: a
//! parabola along the outline, through the points of the slanted wall, tells that place.

use super::ground::Spot;
use super::meet::{FEWEST_MEETS, Fitted, Meet, meet};
use super::parts::parts;
use super::search::Search;
use crate::math::least_squares::least_squares;
use crate::math::vec2::{along, distance, dot, sub, unit};

/// Distance from the edge beyond which points show one wall, spacings: without noise, and for each spacing of noise.
const OWN_WALL: (f64, f64) = (0.7, 2.0);
/// Width, in spacings, of the middle two thirds of a wall: planes at a sharp edge lean as well, but no farther from it.
const WALL_WIDTH: f64 = 1.5;
/// Greatest distance to which a curve is followed beyond its level place, spacings.
const RISE: f64 = 3.0;
/// Standard errors of a bend that make it one, and the share of the squared spread that it may leave.
const BEND_ERRORS: f64 = 6.0;
const PARABOLA_SHARE: f64 = 0.5;

/// The level place of a curve along which slanted walls meet the outline.
pub(super) fn rim(search: &Search, spots: &[Spot], h: f64, noise: f64) -> Option<Fitted> {
    let own = (OWN_WALL.0 + OWN_WALL.1 * noise) * h;
    let slack = (0.3 + noise) * h;
    let clear = |s: &&Spot| {
        let meets = meet(search, s, h, noise).is_some_and(|m| m.off.hypot(m.own - m.ahead) >= own);
        s.fits && meets && search.stands_at(s.foot, slack)
    };
    let slanted: Vec<Spot> = spots.iter().filter(clear).copied().collect();
    let groups = parts(&slanted, |s| s.foot, 2.0 * h);
    let found = groups.iter().filter_map(|group| curve(search, group, h, noise));
    found.min_by(|a, b| a.ahead.total_cmp(&b.ahead))
}

/// The level place of the curve along which one wall meets a straight part of the outline.
fn curve(search: &Search, group: &[Spot], h: f64, noise: f64) -> Option<Fitted> {
    let mut all: Vec<Meet> = group.iter().filter_map(|s| meet(search, s, h, noise)).collect();
    if all.len() < 2 * FEWEST_MEETS {
        return None;
    }
    all.sort_by(|a, b| a.off.total_cmp(&b.off));
    let at = |share: f64| all[((all.len() - 1) as f64 * share) as usize].off;
    if at(0.84) - at(0.16) < WALL_WIDTH * h {
        return None;
    }
    all.sort_by(|a, b| a.ahead.total_cmp(&b.ahead));
    let low = all[all.len() / 20].ahead;
    all.retain(|m| m.ahead <= low + RISE * h);
    let origin = all[0].foot;
    let far =
        all.iter().map(|m| m.foot).max_by(|a, b| distance(*a, origin).total_cmp(&distance(*b, origin)))?;
    let way = unit(sub(far, origin));
    let reach = distance(far, origin);
    let straight = |m: &Meet| distance(along(origin, way, dot(sub(m.foot, origin), way)), m.foot) <= 0.5 * h;
    if reach < RISE * h || !all.iter().all(straight) {
        return None;
    }
    // Places along the outline are taken from the level place as it is known.
    let mut middle = 0.0;
    for round in 0..4 {
        let place = |m: &Meet| dot(sub(m.foot, origin), way) / reach - middle;
        let bent = Bent::fit(&all, place)?;
        let level = -bent.slope / (2.0 * bent.bend);
        let (least, most) =
            all.iter().map(place).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, m), s| (l.min(s), m.max(s)));
        if !bent.clearly || !(least..=most).contains(&level) {
            return None;
        }
        let ahead = bent.at - bent.slope * bent.slope / (4.0 * bent.bend);
        if round == 3 {
            let error = 2.0 * bent.sigma / (all.len() as f64).sqrt() + 0.02 * h;
            return Some(Fitted { ahead, error });
        }
        let near = |m: &Meet| {
            let s = place(m);
            bent.at + (bent.slope + bent.bend * s) * s <= ahead + RISE * h
        };
        all.retain(|m| bent.rest(m, place(m)).abs() <= 2.5 * bent.sigma && near(m));
        middle += level;
    }
    None
}

/// A parabola along the outline from which a wall rises, the steeper the farther from the level place.
struct Bent {
    at: f64,
    slope: f64,
    bend: f64,
    rise: f64,
    /// Growth of the rise with the squared place.
    gain: f64,
    /// Standard deviation about it.
    sigma: f64,
    /// Whether it is bent, and away from the run.
    clearly: bool,
}

impl Bent {
    fn fit(all: &[Meet], place: impl Fn(&Meet) -> f64) -> Option<Bent> {
        let n = all.len() as f64;
        if all.len() < 2 * FEWEST_MEETS {
            return None;
        }
        let [a, k] = least_squares(all.iter().map(|m| ([1.0, m.off], m.own)))?;
        let plain = all.iter().map(|m| (m.own - a - k * m.off).powi(2)).sum::<f64>();
        let row = |m: &Meet| {
            let s = place(m);
            ([1.0, s, s * s, m.off, s * s * m.off], m.own)
        };
        let [at, slope, bend, rise, gain] = least_squares(all.iter().map(row))?;
        let mut bent = Bent { at, slope, bend, rise, gain, sigma: 0.0, clearly: false };
        let left = all.iter().map(|m| bent.rest(m, place(m)).powi(2)).sum::<f64>();
        bent.sigma = (left / (n - 5.0)).sqrt();
        let squares: Vec<f64> = all.iter().map(|m| place(m).powi(2)).collect();
        let mean = squares.iter().sum::<f64>() / n;
        let power = squares.iter().map(|x| (x - mean).powi(2)).sum::<f64>().sqrt();
        bent.clearly = bend > BEND_ERRORS * bent.sigma / power && left <= PARABOLA_SHARE * plain;
        Some(bent)
    }

    /// The distance of a point at a place from it.
    fn rest(&self, m: &Meet, s: f64) -> f64 {
        m.own - self.at - (self.slope + self.bend * s) * s - (self.rise + self.gain * s * s) * m.off
    }
}
