//! From the samples of one slab to the outlines of its contours.

use super::band::{self, Band};
use super::carry::Sample;
use super::link::{self, Chain};
use super::params::{Outline, SectionParams, Side};
use super::surface::Texture;
use super::vec2::{along, cross, left, sub, unit};
use super::{hull, lsq, node, smooth, tidy, voronoi};

/// The outlines of a slab's contours, longest first.
pub(crate) fn contours(samples: &[Sample], params: &SectionParams, texture: &Texture) -> Vec<Chain> {
    let nodes = node::nodes(samples);
    let mut chains: Vec<Chain> = link::contours(&nodes).into_iter().map(tidy::tidy).collect();
    // The second round gives samples to smooth contours instead of to chains of nodes.
    for round in 0..2 {
        let bands = band::assign(samples, chains);
        let middle = |b: &Band| tidy::tidy(smooth::middle(b, texture.noise));
        chains = bands.iter().map(middle).filter(|c| c.vertices.len() > 2).collect();
        if round == 0 {
            // Smooth ends look the right way, and may now meet.
            chains = link::rejoin(chains);
        }
    }
    if params.outline == Outline::Middle && params.side == Side::Middle {
        return chains;
    }
    let bands = band::assign(samples, chains);
    bands.iter().map(|b| outline(b, params)).filter(|c| c.vertices.len() > 1).collect()
}

fn outline(band: &Band, params: &SectionParams) -> Chain {
    let threshold = threshold(band);
    let features = match params.outline {
        Outline::Middle => None,
        Outline::Hull => Some(hull::features(band, threshold)),
        Outline::Voronoi => Some(voronoi::features(band, threshold, params.circle_bound)),
    };
    let chain = features.map_or_else(|| band.chain.clone(), |f| lsq::polyline(band, &f));
    match params.side {
        Side::Middle => chain,
        Side::Outside => shifted(band, chain, 1.0),
        Side::Inside => shifted(band, chain, -1.0),
    }
}

/// How far a region's points may lie from its chord on average: what the band's own thickness gives, be it from the
/// noise or from the slab, and a little for the bend within a chord.
fn threshold(band: &Band) -> f64 {
    let (mut sum, mut spacing) = (0.0, 0.0);
    for mark in &band.marks {
        sum += super::vec2::distance(band.at(mark.arc), mark.sample.raw);
        spacing += mark.sample.spacing;
    }
    (2.0 * sum + 0.05 * spacing) / band.marks.len().max(1) as f64
}

/// Share of the samples that the outside and the inside of a band leave beyond them.
const BEYOND: f64 = 0.1;

/// Moves each vertex of a closed outline to the side of the band that looks away from (1) or towards (-1) the
/// enclosed area; an open one has no such sides and stays.
fn shifted(band: &Band, chain: Chain, side: f64) -> Chain {
    if !chain.closed || band.marks.is_empty() {
        return chain;
    }
    let points: Vec<[f64; 2]> = chain.vertices.iter().map(|v| v.at).collect();
    let area = super::nest::measure(&points, true).area;
    // Right of a counter-clockwise contour is outside.
    let sign = if area >= 0.0 { -side } else { side };
    let n = points.len();
    let mut vertices = chain.vertices;
    for (k, vertex) in vertices.iter_mut().enumerate() {
        let direction = unit(sub(points[(k + 1) % n], points[(k + n - 1) % n]));
        let outward = left(direction).map(|x| x * sign);
        let off = |s: &Sample| {
            let d = sub(s.raw, points[k]);
            cross(direction, d) * sign
        };
        let mut offs: Vec<f64> = near(band, points[k], 1.5 * vertex.spacing).iter().map(off).collect();
        if offs.len() >= 3 {
            let at = ((offs.len() - 1) as f64 * (1.0 - BEYOND)) as usize;
            let shift = *offs.select_nth_unstable_by(at, f64::total_cmp).1;
            vertex.at = along(vertex.at, outward, shift.max(0.0));
        }
    }
    Chain { vertices, closed: true }
}

/// The samples of a band within a radius of a point of its outline, searched where the nearest mark lies.
fn near(band: &Band, p: [f64; 2], radius: f64) -> Vec<Sample> {
    let close = |m: &&band::Mark| super::vec2::distance(m.sample.raw, p) <= radius;
    band.marks.iter().filter(close).map(|m| m.sample).collect()
}
