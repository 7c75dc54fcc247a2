//! From the samples of one slab to the outlines of its contours. A contour that is closed at once is drawn once; where
//! ends are left, smooth ends are joined, and drawn again.

use super::assign::assign;
use super::band::{Band, Growth};
use super::bridge::Support;
use super::carry::Sample;
use super::chain::Chain;
use super::packed::Packed;
use super::params::{Outline, SectionParams, Side};
use super::surface::Texture;
use super::tree::Tree;
use super::vec2::{along, cross, left, sub, unit};
use super::{hull, join, link, lsq, node, smooth, tidy, voronoi};

/// One contour of a slab.
pub(crate) struct Drawn {
    /// Its outline.
    pub chain: Chain,
    /// How fast the wall moves to the right of the outline with growing height.
    pub growth: Growth,
}

/// The outlines of a slab's contours, longest first.
pub(crate) fn contours(samples: &[Sample], params: &SectionParams, texture: &Texture) -> Vec<Drawn> {
    let feet: Vec<[f64; 2]> = samples.iter().map(|s| s.foot).collect();
    let tree = Packed::new(&feet);
    let support = Support { samples, tree: &tree };
    let nodes = node::nodes(samples, &tree);
    let chains = link::chains(&nodes);
    let chains = join::joined(chains, &[], &support).into_iter().map(tidy::tidy).collect();
    let mut free = vec![true; samples.len()];
    let mut bands = assign(samples, &nodes.owners, &free, chains);
    let middle = |b: &Band| tidy::tidy(smooth::middle(b, texture.noise));
    let mut lines: Vec<Chain> = bands.iter().map(middle).collect();
    if !lines.iter().all(|c| c.closed) {
        again(&support, &nodes.owners, &mut free, &mut bands, &mut lines, middle);
    }
    if params.outline == Outline::Middle && params.side == Side::Middle {
        return drawn(&bands, lines);
    }
    free.fill(true);
    let bands = assign(samples, &nodes.owners, &free, lines.into_iter().filter(drawable).collect());
    let outlines = bands.iter().map(|b| outline(b, params)).collect();
    drawn(&bands, outlines)
}

/// Draws the contours that are open once more, through the samples that no closed one has: smooth ends look the right
/// way, and may now meet; and samples go to smooth contours, not to chains of nodes.
fn again(
    support: &Support,
    owners: &[u32],
    free: &mut [bool],
    bands: &mut Vec<Band>,
    lines: &mut Vec<Chain>,
    middle: impl Fn(&Band) -> Chain,
) {
    let (settled, open): (Vec<_>, Vec<_>) = bands.drain(..).zip(lines.drain(..)).partition(|(_, c)| c.closed);
    (*bands, *lines) = settled.into_iter().unzip();
    bands.iter().flat_map(|b| &b.marks).for_each(|m| free[m.source as usize] = false);
    let open = open.into_iter().map(|(_, line)| line).filter(drawable).collect();
    let redrawn = assign(support.samples, owners, free, join::joined(open, lines, support));
    lines.extend(redrawn.iter().map(middle));
    bands.extend(redrawn);
}

fn drawable(chain: &Chain) -> bool {
    chain.vertices.len() > 2
}

fn drawn(bands: &[Band], chains: Vec<Chain>) -> Vec<Drawn> {
    let both = bands.iter().zip(chains).filter(|(_, chain)| drawable(chain));
    let mut drawn: Vec<Drawn> = both.map(|(band, chain)| Drawn { growth: band.growth(), chain }).collect();
    drawn.sort_by_cached_key(|d| std::cmp::Reverse(d.chain.length().to_bits()));
    drawn
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
        sum += super::vec2::distance(band.at(mark.arc), mark.raw);
        spacing += mark.spacing;
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
    let points: Vec<[f64; 2]> = chain.points();
    let area = super::nest::measure(&points, true).area;
    // Right of a counter-clockwise contour is outside.
    let sign = if area >= 0.0 { -side } else { side };
    let n = points.len();
    let raw: Vec<[f64; 2]> = band.marks.iter().map(|m| m.raw).collect();
    let (tree, mut found) = (Tree::new(&raw), Vec::new());
    let mut vertices = chain.vertices;
    for (k, vertex) in vertices.iter_mut().enumerate() {
        let direction = unit(sub(points[(k + 1) % n], points[(k + n - 1) % n]));
        let outward = left(direction).map(|x| x * sign);
        tree.within(points[k], 1.5 * vertex.spacing, &mut found);
        let off = |&m: &u32| cross(direction, sub(band.marks[m as usize].raw, points[k])) * sign;
        let mut offs: Vec<f64> = found.iter().map(off).collect();
        if offs.len() >= 3 {
            let at = ((offs.len() - 1) as f64 * (1.0 - BEYOND)) as usize;
            let shift = *offs.select_nth_unstable_by(at, f64::total_cmp).1;
            vertex.at = along(vertex.at, outward, shift.max(0.0));
        }
    }
    Chain { vertices, closed: true }
}
