//! The best direction of view: the one that shows most line and surface.

use super::camera::Camera;
use super::depth_buffer::DepthBuffer;
use super::hidden::is_visible;
use super::scene::{Scene, Settings};
use super::style::LINE_BIAS;
use super::surfel::{Projected, Surfel};
use crate::apply::shown::Shown;
use crate::parallel;

/// Side of the small trial pictures in pixels.
const TRIAL: usize = 160;
/// Greatest number of surfels of a trial picture; their discs grow to make up for those left out.
const TRIAL_SURFELS: usize = 15_000;
/// Factor by which a view from below must show more than one from above.
const FROM_BELOW: f64 = 0.85;
/// Directions around the up axis. The first lies 0.73 steps off the axis, so that none looks along an axis of the
/// world or its bisector, where edges of square parts would fall together.
const AZIMUTHS: usize = 12;
const FIRST_AZIMUTH: f64 = 0.73;
const ELEVATIONS: [f64; 6] = [22.0, 35.0, 55.0, 75.0, -25.0, -55.0];

/// The direction towards the eye, of a fixed set of oblique ones, with the most visible edges and visible surface.
/// The first of equals.
pub(super) fn direction(scene: &Scene, settings: &Settings) -> [f64; 3] {
    let (surfels, growth) = thinned(scene.surfels);
    let lines = edges(&surfels);
    let frame = Camera::looking(settings.up, [0.0, 1.0, 0.0]);
    let candidates: Vec<([f64; 3], f64)> = candidates(&frame);
    let shown = parallel::map(candidates.len(), parallel::TASK, |c| {
        let (from, weight) = candidates[c];
        let [area, length] = shown(&surfels, growth, &lines, from, scene, settings);
        [area * weight, length * weight]
    });
    let most = |i: usize| shown.iter().map(|s| s[i]).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let [most_area, most_length] = [most(0), most(1)];
    let score = |s: &[f64; 2]| s[0] / most_area + 2.0 * s[1] / most_length;
    let mut best = 0;
    for i in 1..candidates.len() {
        if score(&shown[i]) > score(&shown[best]) {
            best = i;
        }
    }
    candidates[best].0
}

/// World directions around the third axis of `frame`, which looks down on the ground, each with its weight.
fn candidates(frame: &Camera) -> Vec<([f64; 3], f64)> {
    let [right, ahead, up] = frame.axes();
    let mut all = Vec::new();
    for elevation in ELEVATIONS {
        let (sin, cos) = elevation.to_radians().sin_cos();
        for k in 0..AZIMUTHS {
            let azimuth = (k as f64 + FIRST_AZIMUTH) * std::f64::consts::TAU / AZIMUTHS as f64;
            let [x, y] = [cos * azimuth.cos(), cos * azimuth.sin()];
            let from = std::array::from_fn(|i| x * right[i] + y * ahead[i] + sin * up[i]);
            all.push((from, if elevation < 0.0 { FROM_BELOW } else { 1.0 }));
        }
    }
    all
}

/// Every n-th surfel that the picture shows, and the factor by which discs must grow to cover the same surface.
fn thinned(surfels: &[Surfel]) -> (Vec<Surfel>, f32) {
    let step = surfels.len().div_ceil(TRIAL_SURFELS).max(1);
    let some: Vec<Surfel> = surfels.iter().step_by(step).copied().collect();
    let shown = Shown::around(&some.iter().map(|s| s.position).collect::<Vec<_>>());
    (some.into_iter().filter(|s| shown.holds(s.position)).collect(), (step as f32).sqrt())
}

/// Places where the surface folds or ends, as their discs tell: no lines of a network, so that pictures of one scan are seen from one
/// side whatever was found.
fn edges(surfels: &[Surfel]) -> Vec<[f64; 3]> {
    let folded = surfels.iter().filter(|s| s.center != s.position);
    folded.map(|s| s.position).collect()
}

/// Visible area in square world units and the number of visible places on edges.
fn shown(
    surfels: &[Surfel],
    growth: f32,
    lines: &[[f64; 3]],
    from: [f64; 3],
    scene: &Scene,
    settings: &Settings,
) -> [f64; 2] {
    let size = TRIAL as f64;
    let camera = Camera::looking(from, settings.up);
    let camera = camera.fitted(surfels.iter().map(|s| s.position), size, size, 4.0);
    let projected: Vec<Projected> = surfels
        .iter()
        .map(|s| {
            let mut p = s.project(&camera);
            p.radius *= growth;
            p
        })
        .collect();
    let surface = DepthBuffer::draw(&projected, TRIAL, TRIAL);
    let covered = surface.surfel.iter().filter(|&&id| id != u32::MAX).count();
    let bias = (LINE_BIAS * f64::from(growth) * scene.spacing * camera.scale) as f32 + 1.0;
    let visible = lines.iter().filter(|&&p| is_visible(camera.project(p), &surface, bias)).count();
    [covered as f64 / (camera.scale * camera.scale), visible as f64]
}
