//! A survey: stations within a scene, with what makes such scans hard: occlusion, density that falls with the range, noise along
//! the ray, mixed returns at silhouettes and leaves.

use crate::math::vec3::{add_scaled, dot, sub};
use crate::shapes::random::Rng;
use crate::shapes::shape::Shape;
use crate::shapes::turns::{ln, sin_cos};

/// Jump of the range between neighbours on the raster above which a return may be mixed of both, in steps of the raster there.
const JUMP: f64 = 6.0;

/// How a scene is surveyed.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey<'a> {
    /// The places of the scanner.
    pub stations: &'a [[f64; 3]],
    /// Step of the raster in both angles, degrees.
    pub step_deg: f64,
    /// Lowest and highest direction, degrees over the horizon.
    pub elevation_deg: [f64; 2],
    /// Standard deviation of the range.
    pub noise: f64,
    /// Greatest range.
    pub reach: f64,
    /// Share of the rays past a silhouette that return a place between both surfaces.
    pub mixed: f64,
    /// Crowns of trees: centre, radius, and the mean way of a ray among their leaves.
    pub crowns: &'a [([f64; 3], f64, f64)],
    /// Stray returns over all that a station sees, as a share of its rays.
    pub strays: f64,
}

/// The points of a survey.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surveyed {
    /// `(N, 3)` positions.
    pub points: Vec<[f64; 3]>,
    /// `(N)` whether each lies on no surface of the scene.
    pub clutter: Vec<bool>,
}

impl Shape {
    /// The points that a survey of this scene gives.
    pub fn survey(&self, survey: &Survey, seed: u64) -> Surveyed {
        let mut rng = Rng::new(seed);
        let mut found = Surveyed::default();
        for &eye in survey.stations {
            self.station(survey, eye, &mut rng, &mut found);
        }
        found
    }

    fn station(&self, survey: &Survey, eye: [f64; 3], rng: &mut Rng, found: &mut Surveyed) {
        let columns = (360.0 / survey.step_deg).round() as u32;
        let [low, high] = survey.elevation_deg;
        let rows = ((high - low) / survey.step_deg).round() as u32;
        let turn = rng.uniform();
        for column in 0..columns {
            let [c, s] = sin_cos(turn + f64::from(column) / f64::from(columns));
            let mut before = None;
            for row in 0..rows {
                let [up, over] = sin_cos((low + survey.step_deg * f64::from(row)) / 360.0);
                let ray = [up * c, up * s, over];
                let range = self.range(eye, ray).filter(|&r| r <= survey.reach);
                let (own, clutter) = returned(survey, eye, ray, range, before, rng);
                before = range;
                if let Some(range) = own {
                    found.points.push(add_scaled(eye, ray, range + survey.noise * rng.gaussian()));
                    found.clutter.push(clutter);
                }
            }
        }
    }

    /// The range of the first surface along a ray.
    fn range(&self, eye: [f64; 3], ray: [f64; 3]) -> Option<f64> {
        self.faces.iter().filter_map(|face| face.hit(eye, ray)).min_by(f64::total_cmp)
    }
}

/// The range that a ray returns, and whether no surface is there. `before` is that of the ray beside it.
fn returned(
    survey: &Survey,
    eye: [f64; 3],
    ray: [f64; 3],
    range: Option<f64>,
    before: Option<f64>,
    rng: &mut Rng,
) -> (Option<f64>, bool) {
    let leaf = survey.crowns.iter().filter_map(|&crown| leaf(eye, ray, crown, rng)).min_by(f64::total_cmp);
    if let Some(leaf) = leaf.filter(|&l| l < range.unwrap_or(survey.reach)) {
        return (Some(leaf), true);
    }
    if rng.uniform() < survey.strays {
        return (Some(range.unwrap_or(survey.reach) * rng.between(0.1, 0.95)), true);
    }
    if let (Some(own), Some(beside)) = (range, before) {
        let step = survey.step_deg.to_radians() * own.min(beside);
        if (own - beside).abs() > JUMP * step && rng.uniform() < survey.mixed {
            return (Some(rng.between(own.min(beside), own.max(beside))), true);
        }
    }
    (range, false)
}

/// The range at which a ray meets a leaf of a crown.
fn leaf(
    eye: [f64; 3],
    ray: [f64; 3],
    (centre, radius, way): ([f64; 3], f64, f64),
    rng: &mut Rng,
) -> Option<f64> {
    let out = sub(centre, eye);
    let along = dot(out, ray);
    let half = (radius * radius - dot(out, out) + along * along).max(0.0).sqrt();
    let depth = -way * ln(1.0 - rng.uniform());
    (half > 0.0 && along > half && depth < 2.0 * half).then_some(along - half + depth)
}
