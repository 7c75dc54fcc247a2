//! From the samples of one slab to the outlines of its contours. A contour that is closed at once is drawn once; where
//! ends are left, smooth ends are joined, and drawn again.

pub(crate) mod corner;
pub(crate) mod hull;
pub(crate) mod knots;
pub(crate) mod middle;
mod reach;
pub(crate) mod regions;
pub(crate) mod regression;
pub(crate) mod side;
pub(crate) mod voronoi;

use crate::math::quantile::quantile;
use crate::math::trees::packed::Packed;
use crate::math::vec2::distance;
use crate::params::section::{Outline, Side};
use crate::params::{Auto, SectionParams};
use crate::section::contour::assign::assign;
use crate::section::contour::band::{Band, Growth, Mark};
use crate::section::contour::bridge::Support;
use crate::section::contour::chain::Chain;
use crate::section::contour::cut::cut;
use crate::section::contour::tidy::tidy;
use crate::section::contour::{join, link, node};
use crate::section::curves::Datum;
use crate::section::surface::carry::Sample;
use crate::section::surface::texture::Texture;
use regions::FeatureMark;
use side::shifted;
use voronoi::EmptyCircle;

/// Distance from an outline, in medians of that of its samples, from which on no curve is fitted to a sample; and the least of it, spacings.
const FAR: f64 = 6.0;
const FAR_LEAST: f64 = 0.15;

/// One contour of a slab.
pub(crate) struct Drawn {
    /// Its outline.
    pub chain: Chain,
    /// Slope of the wall: its movement to the right of the outline with growing height.
    pub growth: Growth,
    /// The samples along it, for curves to be fitted to; none if that is not wanted, or if the outline is not their middle.
    pub data: Vec<Datum>,
}

/// What a viewer sees on the way from a slab to its outlines; contours have the numbers of their bands.
pub(crate) enum Seen<'a> {
    /// The samples, on the slicing plane.
    Samples(&'a [Sample]),
    /// The samples of each contour in their order along it.
    Bands(&'a [Band]),
    /// The feature points of a contour.
    Features(usize, &'a Band, &'a [FeatureMark]),
    /// An empty circle that gave feature points of a contour.
    Circle(usize, EmptyCircle),
}

/// The outlines of a slab's contours, longest first, without the stretches at which no place is `near` the cloud. `see` is shown
/// the steps.
pub(crate) fn contours(
    samples: &[Sample],
    params: &SectionParams,
    texture: &Texture,
    near: &dyn Fn([f64; 2]) -> bool,
    see: &mut dyn FnMut(Seen),
) -> Vec<Drawn> {
    see(Seen::Samples(samples));
    let feet: Vec<[f64; 2]> = samples.iter().map(|s| s.foot).collect();
    let tree = Packed::new(&feet);
    let support = Support { samples, tree: &tree, longest: params.bridge_spacings };
    let nodes = node::nodes(samples, &tree);
    let chains = link::chains(&nodes, params.link_spacings);
    let chains = join::joined(chains, &[], &support, params.stray_spacings).into_iter().map(tidy).collect();
    let mut free = vec![true; samples.len()];
    let mut bands = assign(samples, &nodes.owners, &free, chains);
    let middle = |b: &Band| tidy(middle::middle(b, texture.noise, params.corner_deg));
    let mut lines: Vec<Chain> = bands.iter().map(middle).collect();
    if !lines.iter().all(|c| c.closed) {
        let join =
            |open: Vec<Chain>, lines: &[Chain]| join::joined(open, lines, &support, params.stray_spacings);
        again(samples, &nodes.owners, &mut free, &mut bands, &mut lines, (join, middle));
    }
    reach::carried_on(samples, &tree, &bands, &mut lines, texture.noise);
    if params.outline == Outline::Middle && params.side == Side::Middle {
        see(Seen::Bands(&bands));
        let mut drawn = drawn(&bands, lines, near);
        if params.fit {
            along(samples, &nodes.owners, &mut drawn);
        }
        return drawn;
    }
    free.fill(true);
    let lines = lines.into_iter().flat_map(|line| cut(line, near)).filter(drawable).collect();
    let bands = assign(samples, &nodes.owners, &free, lines);
    see(Seen::Bands(&bands));
    let outlines = bands.iter().enumerate().map(|(b, band)| outline(b, band, params, see)).collect();
    drawn(&bands, outlines, &|_| true)
}

/// Draws the contours that are open once more, through the samples that no closed one has: smooth ends look the right
/// way, and may now meet; and samples go to smooth contours, not to chains of nodes.
fn again(
    samples: &[Sample],
    owners: &[u32],
    free: &mut [bool],
    bands: &mut Vec<Band>,
    lines: &mut Vec<Chain>,
    (join, middle): (impl Fn(Vec<Chain>, &[Chain]) -> Vec<Chain>, impl Fn(&Band) -> Chain),
) {
    let (settled, open): (Vec<_>, Vec<_>) = bands.drain(..).zip(lines.drain(..)).partition(|(_, c)| c.closed);
    (*bands, *lines) = settled.into_iter().unzip();
    bands.iter().flat_map(|b| &b.marks).for_each(|m| free[m.source as usize] = false);
    let open = open.into_iter().map(|(_, line)| line).filter(drawable).collect();
    let redrawn = assign(samples, owners, free, join(open, lines));
    lines.extend(redrawn.iter().map(middle));
    bands.extend(redrawn);
}

fn drawable(chain: &Chain) -> bool {
    chain.vertices.len() > 2
}

fn drawn(bands: &[Band], chains: Vec<Chain>, near: &dyn Fn([f64; 2]) -> bool) -> Vec<Drawn> {
    let pieces = |(band, chain)| cut(chain, near).into_iter().map(move |piece| (band, piece));
    let both = bands.iter().zip(chains).flat_map(pieces).filter(|(_, chain)| drawable(chain));
    let mut drawn: Vec<Drawn> =
        both.map(|(band, chain)| Drawn { growth: Band::growth(band), chain, data: Vec::new() }).collect();
    drawn.sort_by_cached_key(|d| std::cmp::Reverse(d.chain.length().to_bits()));
    drawn
}

/// Gives outlines the samples along them.
fn along(samples: &[Sample], owners: &[u32], drawn: &mut [Drawn]) {
    let free = vec![true; samples.len()];
    let bands = assign(samples, owners, &free, drawn.iter().map(|d| d.chain.clone()).collect());
    for (band, drawn) in bands.iter().zip(drawn) {
        drawn.data = data(band);
    }
}

/// The samples of a band but those far off, whose weights are 1 on the average.
fn data(band: &Band) -> Vec<Datum> {
    let off = |mark: &Mark| distance(band.at(mark.arc), mark.raw);
    let mut offs: Vec<f64> = band.marks.iter().map(off).collect();
    let far = (FAR * quantile(&mut offs, 0.5)).max(FAR_LEAST * band.chain.spacing());
    let weight = |mark: &Mark| mark.weight / (mark.blur * mark.spacing).powi(2);
    let kept: Vec<&Mark> = band.marks.iter().filter(|m| off(m) <= far).collect();
    let mean = kept.iter().map(|m| weight(m)).sum::<f64>() / kept.len().max(1) as f64;
    kept.into_iter().map(|m| Datum { at: m.raw, weight: weight(m) / mean, arc: m.arc }).collect()
}

fn outline(number: usize, band: &Band, params: &SectionParams, see: &mut dyn FnMut(Seen)) -> Chain {
    let threshold = threshold(band, params.region_spacings);
    let features = match params.outline {
        Outline::Middle => None,
        Outline::Hull => Some(hull::features(band, threshold)),
        Outline::Voronoi => Some(voronoi::features(band, threshold, params.circle_bound, |circle| {
            see(Seen::Circle(number, circle));
        })),
    };
    let chain = features.map_or_else(
        || band.chain.clone(),
        |features| {
            see(Seen::Features(number, band, &features));
            knots::polyline(band, &features.iter().map(|f| f.mark).collect::<Vec<usize>>())
        },
    );
    match params.side {
        Side::Middle => chain,
        Side::Outside => shifted(band, chain, 1.0, params.beyond),
        Side::Inside => shifted(band, chain, -1.0, params.beyond),
    }
}

/// Greatest mean distance of a region's points from its chord (the paper's e): as given, or twice the band's own thickness,
/// from noise or from the slab, plus a little for the bend within a chord.
fn threshold(band: &Band, given: Auto<f64>) -> f64 {
    let (mut sum, mut spacing) = (0.0, 0.0);
    for mark in &band.marks {
        sum += distance(band.at(mark.arc), mark.raw);
        spacing += mark.spacing;
    }
    let all = match given {
        Auto::Given(spacings) => spacings * spacing,
        Auto::Auto => 2.0 * sum + 0.05 * spacing,
    };
    all / band.marks.len().max(1) as f64
}
