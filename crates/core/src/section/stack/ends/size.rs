//! How the area of a run's outline goes with height: not at all for an extrusion; as a square for a taper, since each part
//! of its outline moves evenly.

use crate::math::least_squares::least_squares;
use crate::section::stack::pairs;
use crate::section::stack::profile::Profile;
use crate::section::stack::result::Feature;
use crate::section::stack::runs::Found;

/// Greatest distance of an apex from the last contour, spacings.
const APEX_REACH: f64 = 12.0;
/// Distance from the ends of a run beyond which its slices do not show the next wall, spacings.
const CLEAR_OF_ENDS: f64 = 2.0;
/// Fewest of them that are taken alone.
const FEWEST_CLEAR: usize = 4;
/// Greatest difference of the quadratic share from 0, or from 1, at which the moves count as a line, or as a square.
const NEARLY: f64 = 0.4;
/// Least squared standard errors that the free parabola must explain more, to be preferred.
const FREE_GAIN: f64 = 9.0;

/// Area, and radius if round, as polynomials of the height over the middle.
#[derive(Clone, Debug)]
pub(super) struct Size {
    middle: f64,
    /// Constant, linear, squared; `None` where the outline moves in no even way.
    area: Option<[f64; 3]>,
    radius: Option<[f64; 2]>,
    /// Error of the area; infinite for few slices.
    error: f64,
    /// Whether the outline grows with height.
    grows: bool,
}

impl Size {
    pub(super) fn new(found: &Found, h: f64, tolerance: f64) -> Self {
        let all = &found.profiles;
        let (low, high) = (all[0].height + CLEAR_OF_ENDS * h, all[all.len() - 1].height - CLEAR_OF_ENDS * h);
        let clear: Vec<&Profile> = all.iter().copied().filter(|p| (low..=high).contains(&p.height)).collect();
        let sure = clear.len() >= FEWEST_CLEAR;
        let own = if sure { &clear } else { all };
        let middle = 0.5 * (own[0].height + own[own.len() - 1].height);
        let areas: Vec<[f64; 2]> = own.iter().map(|p| [p.height - middle, p.area]).collect();
        let mut size = Self {
            middle,
            area: None,
            radius: None,
            error: f64::INFINITY,
            grows: own[own.len() - 1].area > own[0].area,
        };
        match found.run.feature {
            Feature::Extrusion { .. } => {
                size.area = Some([areas.iter().map(|a| a[1]).sum::<f64>() / areas.len() as f64, 0.0, 0.0]);
            }
            Feature::Taper { .. } => {
                let rounds: Vec<[f64; 2]> =
                    own.iter().filter_map(|p| Some([p.height - middle, p.round?.radius])).collect();
                size.radius = (4 * rounds.len() >= 3 * own.len()).then(|| line(&rounds));
                size.area = Some(match size.radius {
                    Some([a, b]) => [a * a, 2.0 * a * b, b * b].map(|x| std::f64::consts::PI * x),
                    None => quadratic(&areas, bent(own[0], own[own.len() - 1], tolerance)),
                });
            }
            Feature::Revolution { .. } => {}
        }
        if let Some([a, b, c]) = size.area.filter(|_| sure) {
            let rest = |[x, area]: &[f64; 2]| area - a - b * x - c * x * x;
            let n = areas.len() as f64;
            // Noise draws neighbouring slices out or in together.
            size.error =
                2.0 * (areas.iter().map(|p| rest(p).powi(2)).sum::<f64>() / (n - 3.0)).sqrt() / n.sqrt();
        }
        size
    }

    /// The radius at a height, if round.
    pub(super) fn radius(&self, height: f64) -> Option<f64> {
        self.radius.map(|[a, b]| a + b * (height - self.middle))
    }

    /// Where the outline would shrink to nothing.
    pub(super) fn apex(&self) -> f64 {
        if let Some([a, b]) = self.radius {
            return self.middle - a / b;
        }
        let Some([a, b, c]) = self.area else { return f64::NAN };
        // Of two roots on one side the nearer; a pair of complex ones is a double root but for the noise.
        let side = if self.grows { -1.0 } else { 1.0 };
        let roots = roots([a, b, c]).into_iter().filter(|r| r * side > 0.0);
        self.middle + roots.min_by(|p, q| p.abs().total_cmp(&q.abs())).unwrap_or(-b / (2.0 * c))
    }

    /// The ends of searches from the outermost contours, farther where the outline shrinks to nothing not far beyond: the
    /// last slices before an apex show no contour.
    pub(super) fn to_apex(&self, outer: [f64; 2], own: [f64; 2], h: f64) -> [f64; 2] {
        let apex = self.apex();
        let [below, above] = outer;
        if apex > own[1] && apex - own[1] <= APEX_REACH * h {
            return [below, above.max(apex + 2.0 * h)];
        }
        if apex < own[0] && own[0] - apex <= APEX_REACH * h {
            return [below.min(apex - 2.0 * h), above];
        }
        outer
    }

    /// The height, about between two slices, at which this outline and the next are of one size, and how far off that may be.
    pub(super) fn meets(&self, next: &Self, between: [f64; 2], h: f64) -> Option<(f64, f64)> {
        let (own, other) = (self.area?, next.area?);
        let shift = self.middle - next.middle;
        let [a, b, c] = other;
        // The next one's polynomial about this one's middle.
        let moved = [a + b * shift + c * shift * shift, b + 2.0 * c * shift, c];
        let difference = [0, 1, 2].map(|k| own[k] - moved[k]);
        let middle = 0.5 * (between[0] + between[1]) - self.middle;
        let reach = 0.5 * (between[1] - between[0]) + h;
        let near = roots(difference).into_iter().filter(|r| (r - middle).abs() <= reach);
        let root = near.min_by(|p, q| (p - middle).abs().total_cmp(&(q - middle).abs()))?;
        let slope = difference[1] + 2.0 * difference[2] * root;
        Some((self.middle + root, self.error.hypot(next.error) / slope.abs() + 1e-2 * h))
    }
}

/// The square's coefficient that the moves of an outline tell.
fn bent(low: &Profile, high: &Profile, tolerance: f64) -> f64 {
    pairs::bent(&pairs::pairs(low, high, tolerance)) / (high.height - low.height).powi(2)
}

/// The area of an outline whose parts each move evenly: the line of one that moves in a part only, the square of one that
/// shrinks all round, or a mean of both, as the moves tell; the free parabola where that explains far more.
fn quadratic(areas: &[[f64; 2]], bent: f64) -> [f64; 3] {
    let mapped =
        |of: &dyn Fn(&[f64; 2]) -> f64| line(&areas.iter().map(|p| [p[0], of(p)]).collect::<Vec<_>>());
    let [a, b] = mapped(&|p| p[1].sqrt());
    let square = [a * a, 2.0 * a * b, b * b];
    let told = match bent / square[2] {
        share if share.abs() <= NEARLY => 0.0,
        share if (share - 1.0).abs() <= NEARLY => square[2],
        _ => bent,
    };
    let [a, b] = mapped(&|[x, area]| area - told * x * x);
    let told = if told == square[2] { square } else { [a, b, told] };
    let freedom = areas.len() as f64 - 3.0;
    if freedom < 1.0 {
        return told;
    }
    let free = parabola(areas);
    let rest =
        |[a, b, c]: [f64; 3]| areas.iter().map(|[x, area]| (area - a - (b + c * x) * x).powi(2)).sum::<f64>();
    if rest(told) <= rest(free) * (1.0 + FREE_GAIN / freedom) { told } else { free }
}

/// Real roots of `a + b x + c x^2`.
fn roots([a, b, c]: [f64; 3]) -> Vec<f64> {
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return Vec::new();
    }
    let q = -0.5 * (b + b.signum() * discriminant.sqrt());
    [a / q, q / c].into_iter().filter(|r| r.is_finite()).collect()
}

/// The line of least squares through (x, y): constant and slope.
fn line(points: &[[f64; 2]]) -> [f64; 2] {
    let n = points.len() as f64;
    let [x, y] = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
    let (mut xx, mut xy) = (0.0, 0.0);
    for p in points {
        xx += (p[0] - x) * (p[0] - x);
        xy += (p[0] - x) * (p[1] - y);
    }
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    [y - slope * x, slope]
}

/// The parabola of least squares through (x, y): constant, slope, square.
fn parabola(points: &[[f64; 2]]) -> [f64; 3] {
    let rows = points.iter().map(|&[x, y]| ([1.0, x, x * x], y));
    least_squares(rows).unwrap_or_else(|| {
        let [a, b] = line(points);
        [a, b, 0.0]
    })
}

#[cfg(test)]
mod tests {
    use super::{line, parabola, quadratic, roots};

    #[test]
    fn polynomials_are_fitted_and_solved() {
        let points: Vec<[f64; 2]> = (-4..5).map(f64::from).map(|x| [x, 3.0 - 4.0 * x + x * x]).collect();
        let fitted = parabola(&points);
        assert!(fitted.iter().zip([3.0, -4.0, 1.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{fitted:?}");
        let mut found = roots([3.0, -4.0, 1.0]);
        found.sort_by(f64::total_cmp);
        assert_eq!(found, [1.0, 3.0]);
        assert_eq!(roots([4.0, -2.0, 0.0]), [2.0]);
        assert_eq!(line(&[[0.0, 1.0], [2.0, 5.0]]), [1.0, 2.0]);
    }

    #[test]
    fn few_areas_go_on_as_the_outline_moves() {
        // A wall four times as high as it is far, between sides that close: its area is 12 x - 3.6 x^2.
        let area = |x: f64| [x, 12.0 * x - 3.6 * x * x];
        let mut found = roots(quadratic(&[area(0.26), area(0.43)], -3.6));
        found.sort_by(f64::total_cmp);
        assert!(found[0].abs() < 1e-9, "{found:?}");
        // A near line or square counts as one, whatever noise makes of the moves.
        assert_eq!(quadratic(&[[0.0, 1.0], [1.0, 2.0]], 0.01), [1.0, 1.0, 0.0]);
        let square = quadratic(&[[0.0, 1.0], [1.0, 4.0]], 1.2);
        assert!(square.iter().zip([1.0, 2.0, 1.0]).all(|(a, b)| (a - b).abs() < 1e-9), "{square:?}");
    }
}
