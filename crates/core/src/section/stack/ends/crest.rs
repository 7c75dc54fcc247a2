//! Curved faces where they are level: rings about an axis, and crests, as of a bore that lies along the slices or a dome.

use super::ground::Spot;
use crate::math::least_squares::least_squares;
use crate::math::quantile::middle;
use crate::math::vec2::{distance, dot, left};

/// Least bend that counts, in its standard errors.
const CLEAR_BEND: f64 = 6.0;
/// Cosine of the angle between the axis and the normals of points that may lie on a crest: 37 degrees.
const CREST_COSINE: f64 = 0.8;
/// Greatest distance of the level place from the middle of the points, in units of their reach.
const OUTSIDE: f64 = 1.3;
/// Rounds in which the points near a crest are gathered.
const ROUNDS: usize = 2;

/// The level height and the spread about a parabola over the distance from a centre.
pub(super) fn ring(cluster: &[Spot], centre: [f64; 2]) -> Option<(f64, f64)> {
    let origin = cluster[0].height;
    let radius = |s: &Spot| distance(s.at, centre);
    let radii: Vec<f64> = cluster.iter().map(radius).collect();
    let (least, most) = radii.iter().fold((f64::INFINITY, 0.0f64), |(l, m), &r| (l.min(r), m.max(r)));
    let scale = most.max(f64::MIN_POSITIVE);
    // About an axis that the face reaches the parabola is level there.
    let cap = least < 0.2 * most;
    let row = |(s, r): (&Spot, &f64)| {
        let x = r / scale;
        ([1.0, if cap { 0.0 } else { x }, x * x], s.height - origin)
    };
    let rows = || cluster.iter().zip(&radii).map(row);
    let [a, b, c] = if cap {
        let [a, c] = least_squares(rows().map(|(x, y)| ([x[0], x[2]], y)))?;
        [a, 0.0, c]
    } else {
        least_squares(rows())?
    };
    let level = (-b / (2.0 * c)).clamp(least / scale, 1.0);
    let level = if cap { 0.0 } else { level };
    let rest: Vec<f64> = rows().map(|(x, y)| y - a * x[0] - b * x[1] - c * x[2]).collect();
    Some((origin + a + b * level + c * level * level, middle(&rest).1))
}

/// Heights as a parabola over one or both of two axes across each other.
struct Crest {
    origin: [f64; 2],
    axes: [[f64; 2]; 2],
    reach: f64,
    /// Height at the origin; slope and bend along each axis, over the reach.
    height: f64,
    slopes: [f64; 2],
    bends: [f64; 2],
}

/// A crest that points show.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shown {
    /// Where it is level; not a number where it is slanted and nowhere level.
    pub height: f64,
    /// Width of the middle two thirds of the points about it, and about one height.
    pub spread: f64,
    pub level: f64,
    pub count: usize,
}

/// The level height of a parabola over both coordinates. Where it is bent one way only, as over a bore, that way alone
/// counts. The planes of noisy points lean by chance, and of a curved face fit best those points that noise has moved inwards,
/// so that the points that seem level lie off the surface: all `spots` near it tell.
pub(super) fn crest(cluster: &[Spot], spots: &[Spot], h: f64, noise: f64) -> Option<Shown> {
    let reach = (3.0 * noise + 0.2) * h;
    let leans = |s: &Spot| s.normal[2].abs() < CREST_COSINE;
    let mut used = cluster.to_vec();
    let (mut found, mut spread) = Crest::fit(cluster)?;
    for _ in 0..ROUNDS {
        let near = |s: &&Spot| !leans(s) && found.holds(s) && (s.height - found.at(s)).abs() <= reach;
        let more: Vec<Spot> = spots.iter().filter(near).copied().collect();
        if more.len() < used.len() / 2 {
            break;
        }
        (found, spread) = Crest::fit(&more)?;
        used = more;
    }
    let (_, level) = middle(&used.iter().map(|s| s.height).collect::<Vec<_>>());
    let bent = found.bends != [0.0; 2];
    bent.then(|| Shown { height: found.level((0.5 * h).max(spread)), spread, level, count: used.len() })
}

impl Crest {
    /// The parabola through points, a level where they are not bent, and the spread about it.
    fn fit(points: &[Spot]) -> Option<(Crest, f64)> {
        let mut all = Crest::level_through(points);
        let base = all.height;
        all.turn_to_axes(points)?;
        let row = |s: &Spot| {
            let [u, v] = all.place(s);
            ([1.0, u, v, u * u, v * v], s.height - base)
        };
        let [a, bu, bv, cu, cv] = least_squares(points.iter().map(row))?;
        (all.height, all.slopes, all.bends) = (base + a, [bu, bv], [cu, cv]);
        let spread = all.spread(points);
        let bent = [0, 1].map(|k| all.bends[k].abs() * all.power(points, k) > CLEAR_BEND * 0.5 * spread);
        let [across, along] = match bent {
            [true, true] => return Some((all, spread)),
            [true, false] => [0, 1],
            [false, true] => [1, 0],
            [false, false] => {
                (all.height, all.slopes, all.bends) = (base, [0.0; 2], [0.0; 2]);
                let spread = all.spread(points);
                return Some((all, spread));
            }
        };
        let row = |s: &Spot| {
            let at = all.place(s);
            ([1.0, at[across], at[along], at[across] * at[across]], s.height - base)
        };
        let [a, b, slope, c] = least_squares(points.iter().map(row))?;
        all.height = base + a;
        (all.slopes[across], all.slopes[along]) = (b, slope);
        (all.bends[across], all.bends[along]) = (c, 0.0);
        let spread = all.spread(points);
        Some((all, spread))
    }

    /// The mean height of points, with the middle and the reach of their places.
    fn level_through(points: &[Spot]) -> Self {
        let n = points.len() as f64;
        let mean = |of: &dyn Fn(&Spot) -> f64| points.iter().map(of).sum::<f64>() / n;
        let mut level = Crest {
            origin: [mean(&|s| s.at[0]), mean(&|s| s.at[1])],
            axes: [[1.0, 0.0], [0.0, 1.0]],
            reach: 1.0,
            height: mean(&|s| s.height),
            slopes: [0.0; 2],
            bends: [0.0; 2],
        };
        level.reach = points
            .iter()
            .map(|s| level.place(s))
            .fold(f64::MIN_POSITIVE, |r, [x, y]| r.max(x.abs()).max(y.abs()));
        level
    }

    /// Turns the axes of a level to those of the quadric through the points.
    fn turn_to_axes(&mut self, points: &[Spot]) -> Option<()> {
        let row = |s: &Spot| {
            let [x, y] = self.place(s);
            ([1.0, x, y, x * x, x * y, y * y], s.height - self.height)
        };
        let [_, _, _, xx, xy, yy] = least_squares(points.iter().map(row))?;
        let (sine, cosine) = (0.5 * xy.atan2(xx - yy)).sin_cos();
        self.axes = [[cosine, sine], left([cosine, sine])];
        Some(())
    }

    /// A point along both axes, over the reach.
    fn place(&self, s: &Spot) -> [f64; 2] {
        let d = [s.at[0] - self.origin[0], s.at[1] - self.origin[1]];
        self.axes.map(|axis| dot(d, axis) / self.reach)
    }

    /// Whether a point lies among those that were fitted.
    fn holds(&self, s: &Spot) -> bool {
        self.place(s).iter().all(|x| x.abs() <= 1.0)
    }

    /// The height here.
    fn at(&self, s: &Spot) -> f64 {
        let at = self.place(s);
        (0..2).fold(self.height, |z, k| z + self.slopes[k] * at[k] + self.bends[k] * at[k] * at[k])
    }

    fn spread(&self, points: &[Spot]) -> f64 {
        middle(&points.iter().map(|s| s.height - self.at(s)).collect::<Vec<_>>()).1
    }

    /// Root of the sum of squares about the mean of the squared coordinate: standard errors of the bend go by its inverse.
    fn power(&self, points: &[Spot], k: usize) -> f64 {
        let squares: Vec<f64> = points.iter().map(|s| self.place(s)[k].powi(2)).collect();
        let mean = squares.iter().sum::<f64>() / squares.len() as f64;
        squares.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>().sqrt()
    }

    /// The height where it is level; not a number where a slope of more than `steep` over the reach has no such place.
    fn level(&self, steep: f64) -> f64 {
        let mut height = self.height;
        for (slope, bend) in self.slopes.into_iter().zip(self.bends) {
            let place = -slope / (2.0 * bend);
            if bend != 0.0 && place.abs() <= OUTSIDE {
                height += 0.5 * slope * place;
            } else if slope.abs() > steep {
                return f64::NAN;
            }
        }
        height
    }
}
