//! A line in space and the faces that it explains.

use super::facets::{Facet, Facets};
use crate::math::least_squares::least_squares;
use crate::math::vec3;

/// Rounds in which a line settles, and the factors on the angle that facets may be off in the first half of them and in the
/// second: without room it would not move.
const ROUNDS: usize = 8;
const WIDER: [f64; 2] = [3.0, 2.0];
/// Greatest distance at which the normals of facets turned about a line pass it, spacings.
const PASSES_WITHIN: f64 = 0.5;
/// Least radius of facets turned about a line, as a share of the reach: nearer ones count as if they were there.
const LEAST_RADIUS: f64 = 0.1;
/// Weight, as a share of the whole surface, that keeps a line in place where no facet moves it.
const STAY_WEIGHT: f64 = 1e-6;
/// Standard errors within which an axis is the same.
const SURE: f64 = 3.0;
/// Height, in spacings, over which faces across the axis are one change of the section.
const LEVEL_HEIGHT: f64 = 2.0;

/// An axis, the unit direction, through a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pose {
    pub axis: [f64; 3],
    through: [f64; 3],
}

/// The relation of a facet to a line.
enum Lie {
    Standing,
    /// With the sign that its normal has along the axis.
    Across(f64),
    /// With the distance of its place from the line.
    Turned(f64),
}

impl Pose {
    /// The line near a direction that explains most about it.
    pub(crate) fn along(axis: [f64; 3], facets: &Facets) -> Self {
        let mut pose = Self { axis, through: facets.all.first().map_or([0.0; 3], |f| f.at) };
        pose.centre(facets);
        for round in 0..ROUNDS {
            let off = facets.off * WIDER[usize::from(round >= ROUNDS / 2)];
            match pose.settled(facets, off) {
                Some(next) => pose = next,
                None => break,
            }
        }
        pose
    }

    /// Moves the line to where the normals pass nearest, those far from it counting little.
    fn centre(&mut self, facets: &Facets) {
        let [u, v] = self.across();
        let flat = |p: [f64; 3]| [vec3::dot(p, u), vec3::dot(p, v)];
        for round in 0..ROUNDS {
            let row = |f: &Facet| {
                let [x, y] = flat(f.normal);
                let [a, b] = flat(vec3::sub(f.at, self.through));
                let off = x * b - y * a;
                let far = if round == 0 { 0.0 } else { off / (4.0 * f.spacing) };
                let weight = (f.area / facets.area).sqrt() / (1.0 + far * far).sqrt();
                ([-y * weight, x * weight], off * weight)
            };
            let Some([a, b]) = least_squares(facets.all.iter().map(row)) else { return };
            self.through = vec3::add_scaled(vec3::add_scaled(self.through, u, a), v, b);
        }
    }

    /// The line of least squares for the facets that this one explains.
    fn settled(&self, facets: &Facets, off: f64) -> Option<Self> {
        let [u, v] = self.across();
        let still = [([0.0, 0.0, STAY_WEIGHT, 0.0], 0.0), ([0.0, 0.0, 0.0, STAY_WEIGHT], 0.0)];
        let [a, b, c, d] = least_squares(self.rows(facets, off).into_iter().chain(still))?;
        let move_by = |p: [f64; 3], x: f64, y: f64| vec3::add_scaled(vec3::add_scaled(p, u, x), v, y);
        Some(Self { axis: vec3::unit(move_by(self.axis, a, b)), through: move_by(self.through, c, d) })
    }

    /// Two unit vectors across the axis.
    fn across(&self) -> [[f64; 3]; 2] {
        let u = vec3::perpendicular(self.axis);
        [u, vec3::cross(self.axis, u)]
    }

    /// The angle by which each facet that the line explains is off, to first order in the turns of the axis and the
    /// shifts both ways across it; weighted by the root of its share of the surface.
    fn rows(&self, facets: &Facets, off: f64) -> Vec<([f64; 4], f64)> {
        let [u, v] = self.across();
        let mut rows = Vec::with_capacity(2 * facets.all.len());
        for f in &facets.all {
            let n = f.normal;
            let weight = (f.area / facets.area).sqrt();
            let mut add = |row: [f64; 4], rest: f64| rows.push((row.map(|x| x * weight), rest * weight));
            match self.lie(f, facets, off) {
                None => {}
                Some(Lie::Standing) => {
                    add([vec3::dot(n, u), vec3::dot(n, v), 0.0, 0.0], -vec3::dot(n, self.axis));
                }
                Some(Lie::Across(sign)) => {
                    add([1.0, 0.0, 0.0, 0.0], sign * vec3::dot(n, u));
                    add([0.0, 1.0, 0.0, 0.0], sign * vec3::dot(n, v));
                }
                Some(Lie::Turned(radius)) => {
                    // Those near the axis would count most if each were held by its own radius.
                    let radius = radius.max(LEAST_RADIUS * facets.reach);
                    let from = vec3::sub(f.at, self.through);
                    let past = |a: [f64; 3]| vec3::dot(n, vec3::cross(a, from)) / radius;
                    let shift = [v, u].map(|a| vec3::dot(n, a) / radius);
                    let moved = [past(u), past(v), -shift[0], shift[1]];
                    add(moved, -past(self.axis));
                }
            }
        }
        rows
    }

    /// The share of the surface that holds the axis against turning the way that it turns easiest: one plane wall, or a sphere,
    /// leaves it free.
    pub(crate) fn held(&self, facets: &Facets) -> f64 {
        let mut m = [[0.0; 4]; 4];
        for (row, _) in self.rows(facets, facets.off) {
            (0..16).for_each(|k| m[k / 4][k % 4] += row[k / 4] * row[k % 4]);
        }
        // The turns, once the line has taken its best shift for each.
        for k in [3, 2] {
            if m[k][k] > f64::MIN_POSITIVE {
                for (i, j) in (0..k).flat_map(|i| (0..k).map(move |j| (i, j))) {
                    m[i][j] -= m[i][k] * m[k][j] / m[k][k];
                }
            }
        }
        let (middle, half) = (0.5 * (m[0][0] + m[1][1]), 0.5 * (m[0][0] - m[1][1]));
        middle - half.hypot(m[0][1])
    }

    /// How far the axis may be off, radians: three standard errors of the turn that is least sure, facets being off independently.
    pub(crate) fn uncertainty(&self, facets: &Facets) -> f64 {
        // Weights are roots of shares of the surface: squares sum to the mean over it.
        let rows = self.rows(facets, facets.off);
        let mean: f64 = rows.iter().map(|(_, rest)| rest * rest).sum();
        let count = facets.all.len().max(1) as f64;
        SURE * (mean / (self.held(facets).max(f64::MIN_POSITIVE) * count)).sqrt()
    }

    /// How a facet lies, `off` being how far its normal may be off.
    fn lie(&self, f: &Facet, facets: &Facets, off: f64) -> Option<Lie> {
        let (sine, cosine) = off.sin_cos();
        let along = vec3::dot(f.normal, self.axis);
        if along.abs() <= sine {
            return Some(Lie::Standing);
        }
        if along.abs() >= cosine {
            return Some(Lie::Across(along.signum()));
        }
        let around = vec3::cross(self.axis, vec3::sub(f.at, self.through));
        let radius = vec3::norm(around);
        let past = vec3::dot(f.normal, around).abs();
        // By the part of the normal that does not run along the axis.
        let level = (1.0 - along * along).sqrt();
        // A line far off would be met by all normals across one direction.
        let near = radius > f.spacing && radius <= facets.reach;
        let turned = near && past <= level * (radius * sine + PASSES_WITHIN * f.spacing);
        turned.then_some(Lie::Turned(radius))
    }

    /// The share of the surface that it explains.
    pub(crate) fn explained(&self, facets: &Facets) -> f64 {
        let own = facets.all.iter().filter(|f| self.lie(f, facets, facets.off).is_some());
        own.map(|f| f.area).sum::<f64>() / facets.area
    }

    /// The number of faces across it, in which those of great area count fully.
    pub(crate) fn changes(&self, facets: &Facets) -> f64 {
        let across =
            facets.all.iter().filter(|f| matches!(self.lie(f, facets, facets.off), Some(Lie::Across(_))));
        let mut levels: Vec<(f64, f64, f64)> =
            across.map(|f| (vec3::dot(f.at, self.axis), f.area, f.spacing)).collect();
        levels.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mut sum, mut squares, mut level) = (0.0, 0.0, 0.0);
        let mut last = f64::NEG_INFINITY;
        for (height, area, spacing) in levels {
            if height - last > LEVEL_HEIGHT * spacing {
                squares += level * level;
                level = 0.0;
            }
            (last, level, sum) = (height, level + area, sum + area);
        }
        squares += level * level;
        if squares > 0.0 { sum * sum / squares } else { 0.0 }
    }
}
