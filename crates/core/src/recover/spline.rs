//! Fits a smooth spline to a strip (Gumhold 2001, section 4, the simple solution).

use crate::curve::pieces::{Noise, Piece, pieces};
use crate::curve::{BSpline, FitOptions, fit};
use crate::math::vec3::{distance, distance2};
use crate::network::{Blend, Node, Strip, StripKind};
use crate::params::SplineParams;
use crate::pattern::{LineGraph, Path};
use crate::resolution::Resolution;
use crate::surface::Scales;

/// Greatest number of points for one control of a curve: enough to follow any cubic, even where the span is very long.
const SPAN_POINTS: usize = 64;
/// Greatest number of points for one edge of its path: an edge many spacings long has no more to tell.
const EDGE_POINTS: usize = 16;

/// Standard deviation across the line of a vertex of a clean cloud, in spacings.
const LEAST_ERROR: f64 = 0.07;
/// Length beside a node over which the vertices of a line see more than its two faces, in spacings.
pub(super) const BENT: f64 = 2.5;
/// Length over which the vertices of a line err alike, as they come from the same points, in spacings.
pub(super) const ALIKE: f64 = 3.0;

/// The span for the noise, in units of the resolution: the more noise, the more data for each control point.
pub(crate) fn span_spacings(params: &SplineParams, resolution: Resolution) -> f64 {
    let ratio = resolution.noise / resolution.spacing;
    params.span_spacings.or(|| 3.0 + 6.0 * ratio.min(1.0))
}

/// The strip along a path; `ends` are its nodes in the network.
pub(super) fn strip(
    nodes: &[Node],
    kind: StripKind,
    lines: &LineGraph,
    path: &Path,
    ends: Option<[u32; 2]>,
    scales: Scales,
    params: &SplineParams,
) -> Strip {
    let mut sources: Vec<u32> = path.vertices.iter().map(|&v| lines.points[v as usize]).collect();
    sources.dedup();
    // That of the densest place, so that none is smoothed over.
    let resolution = scales.finest(&sources);
    let mut positions: Vec<[f64; 3]> = path.vertices.iter().map(|&v| lines.positions[v as usize]).collect();
    if let Some([start, end]) = ends {
        let last = positions.len() - 1;
        positions[0] = nodes[start as usize].position;
        positions[last] = nodes[end as usize].position;
    }
    let laid = laid(&positions, ends.is_none(), resolution, params);
    Strip {
        kind,
        closed: ends.is_none(),
        start: ends.map(|e| e[0]),
        end: ends.map(|e| e[1]),
        points: laid.points,
        curve: laid.curve,
        curves: laid.curves,
        sources,
        fold_deg: fold_deg(lines, path),
        evidence: evidence(lines, path),
        deviation: laid.deviation,
        confidence: confidence(kind, lines, path),
        sigma: Vec::new(),
        blend: (kind == StripKind::Rounded).then(|| blend(lines, path)),
    }
}

/// The mean radius along a path, with the standard deviation of that mean.
fn blend(lines: &LineGraph, path: &Path) -> Blend {
    let radii = || path.vertices.iter().map(|&v| f64::from(lines.radius[v as usize]));
    let count = path.vertices.len() as f64;
    let radius = radii().sum::<f64>() / count;
    let square = radii().map(|r| (r - radius).powi(2)).sum::<f64>() / (count - 1.0).max(1.0);
    Blend { radius, sigma: (square / count).sqrt() }
}

/// The confidence in a line: one minus its mean penalty. Along a border that is the share of a turn that is open (Gumhold 2001,
/// equation 8), which half a turn makes certain.
fn confidence(kind: StripKind, lines: &LineGraph, path: &Path) -> f64 {
    let certain = if kind == StripKind::Border { 0.5 } else { 1.0 };
    ((1.0 - mean(path, |v| lines.penalty[v])) / certain).clamp(0.0, 1.0)
}

/// A curve through places in order.
struct Laid {
    curve: BSpline,
    points: Vec<[f64; 3]>,
    curves: Vec<Piece>,
    deviation: f64,
}

/// The curve through a row of places, whose ends are held unless it is closed.
fn laid(positions: &[[f64; 3]], closed: bool, resolution: Resolution, params: &SplineParams) -> Laid {
    let (span, smoothing) = (span_spacings(params, resolution) * resolution.unit(), params.smoothing);
    let (curve, parameters) = fit(positions, FitOptions { span, smoothing, closed });
    let squares: f64 = positions.iter().zip(&parameters).map(|(&p, &t)| distance2(p, curve.point(t))).sum();
    let most = (SPAN_POINTS * curve.controls.len()).min(EDGE_POINTS * positions.len());
    let points = polyline(&curve, params.step_spacings * resolution.spacing, most);
    let curves = typed(positions, &parameters, &curve, points.len(), resolution);
    Laid { deviation: (squares / positions.len() as f64).sqrt(), curve, points, curves }
}

/// Lays the curves of a strip through other places, between the nodes at its ends.
pub(super) fn relay(
    strip: &mut Strip,
    places: &[Place],
    ends: [Option<Place>; 2],
    scales: Scales,
    params: &SplineParams,
) {
    let row: Vec<Place> = ends[0].into_iter().chain(places.iter().copied()).chain(ends[1]).collect();
    let at: Vec<[f64; 3]> = row.iter().map(|p| p.at).collect();
    let laid = laid(&at, strip.closed, scales.finest(&strip.sources), params);
    (strip.curve, strip.points, strip.curves) = (laid.curve, laid.points, laid.curves);
    strip.deviation = laid.deviation;
    strip.sigma = sigma(strip, &row);
}

/// A place that a strip is laid through, and its standard deviation on each axis if it is known.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub at: [f64; 3],
    pub sigma: Option<[f64; 3]>,
}

/// The standard deviations at the points of a strip: those of the places it was laid through, in between in proportion to the length. A
/// smooth curve through neighbouring places, which err alike, is hardly surer than these. Empty if no place has any.
fn sigma(strip: &Strip, row: &[Place]) -> Vec<[f64; 3]> {
    let lengths = |points: &mut dyn Iterator<Item = [f64; 3]>| {
        let (mut sum, mut before) = (0.0, None);
        let mut step = |p| {
            sum += before.map_or(0.0, |b| distance(b, p));
            before = Some(p);
            sum
        };
        points.map(&mut step).collect::<Vec<f64>>()
    };
    let at = lengths(&mut row.iter().map(|p| p.at));
    let known: Vec<(f64, [f64; 3])> = at.iter().zip(row).filter_map(|(&t, p)| Some((t, p.sigma?))).collect();
    let (Some(first), Some(last)) = (known.first(), known.last()) else { return Vec::new() };
    let along = lengths(&mut strip.points.iter().copied());
    let stretch = at[at.len() - 1] / along[along.len() - 1].max(f64::MIN_POSITIVE);
    let of = |t: f64| {
        let next = known.partition_point(|k| k.0 <= t);
        match (next.checked_sub(1).map(|k| known[k]), known.get(next)) {
            (Some((a, low)), Some(&(b, high))) => {
                let share = (t - a) / (b - a);
                [0, 1, 2].map(|k| low[k] + share * (high[k] - low[k]))
            }
            (None, _) => first.1,
            (_, None) => last.1,
        }
    };
    along.iter().map(|&t| of(t * stretch)).collect()
}

/// The strip in pieces of a type. `count` points lie at even parameters on its curve.
fn typed(
    positions: &[[f64; 3]],
    parameters: &[f64],
    curve: &BSpline,
    count: usize,
    resolution: Resolution,
) -> Vec<Piece> {
    let (from, to) = curve.domain();
    let sigma = (LEAST_ERROR * resolution.spacing).hypot(resolution.noise);
    let noise = Noise::new(sigma, ALIKE * resolution.spacing, positions.len(), to - from);
    let steps = if curve.periodic { count } else { count - 1 };
    let index = |k: usize| {
        let t = parameters.get(k).copied().unwrap_or(to);
        (((t - from) / (to - from) * steps as f64).round() as usize).min(steps)
    };
    let mut curves = pieces(positions, curve.periodic, &noise, BENT * resolution.spacing);
    for piece in &mut curves {
        (piece.first, piece.last) = (index(piece.first), index(piece.last));
    }
    curves
}

/// The mean of the known values at the vertices of a path, over all vertices.
fn mean(path: &Path, known: impl Fn(usize) -> Option<f32>) -> f64 {
    let sum: f64 = path.vertices.iter().map(|&v| f64::from(known(v as usize).unwrap_or(0.0))).sum();
    sum / path.vertices.len() as f64
}

/// The mean evidence, zero for vertices without any; `None` if no vertex has any.
fn evidence(lines: &LineGraph, path: &Path) -> Option<f64> {
    let sharp = |v: usize| lines.evidence[v].map(|e| e.sharp);
    path.vertices.iter().any(|&v| sharp(v as usize).is_some()).then(|| mean(path, sharp))
}

/// The mean fold over the vertices with a measured fold, degrees.
fn fold_deg(lines: &LineGraph, path: &Path) -> Option<f64> {
    let evidence = || path.vertices.iter().filter_map(|&v| lines.evidence[v as usize]);
    let folds = || evidence().map(|e| f64::from(e.fold)).filter(|&f| f > 0.0);
    let count = folds().count();
    (count > 0).then(|| (folds().sum::<f64>() / count as f64).to_degrees())
}

/// Points on the curve about `step` apart, `most` or fewer of them; a closed curve's first is not repeated.
fn polyline(curve: &BSpline, step: f64, most: usize) -> Vec<[f64; 3]> {
    let (from, to) = curve.domain();
    let pieces = (((to - from) / step).ceil() as usize).clamp(if curve.periodic { 3 } else { 1 }, most);
    let last = if curve.periodic { pieces - 1 } else { pieces };
    let mut points: Vec<[f64; 3]> =
        (0..=last).map(|i| curve.point(from + (to - from) * i as f64 / pieces as f64)).collect();
    if !curve.periodic {
        // The ends of the curve are its end controls, which equal the nodes to the bit.
        points[0] = curve.controls[0];
        points[last] = curve.controls[curve.controls.len() - 1];
    }
    points.dedup_by(|a, b| distance(*a, *b) == 0.0);
    points
}
