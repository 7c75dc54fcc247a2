//! Corners of a cross-section: where two of its smooth pieces meet at an angle.

use super::Weighted;
use super::gaps;
use super::links::Links;
use super::pieces::{Piece, Pieces, meet, variance};
use super::section::{Across, CENTRE, Section};
use crate::curve::circle::Circle;
use crate::math::vec3::add_scaled;
use crate::measure::Edgelet;

/// Greatest turn from one face to the other, degrees: sharper ones are two sides of a sheet.
const SHEET_DEG: f64 = 150.0;
/// Least length of a piece, in spacings, to which the noise is added, and its least number of points.
const SHORT: (f64, f64) = (0.5, 8.0);
/// Least points along the joint of two pieces, those of both sides counted.
const JOINT: f64 = 6.0;
/// Greatest distance of a corner from the joint and from both pieces, in spacings, and what a spacing of noise adds.
const GAP: (f64, f64) = (0.6, 2.0);
/// Smallest standard deviation of a corner that is believed, in spacings.
const EXACT: f64 = 0.03;
/// Least sine of a turn by which the deviation is divided.
const OBLIQUE: f64 = 0.1;
/// Loss of weight with each spacing of distance from the seed.
const ASIDE: f64 = 0.3;
/// By how much two parabolas must describe two pieces better than one circle, as they have three parameters more.
const MORE: f64 = 3.0;
/// Greatest standard deviation of a corner, in spacings.
const VAGUE: f64 = 0.5;

/// The joint of two pieces: links between them.
#[derive(Clone, Copy, Debug)]
struct Joint {
    pieces: (u32, u32),
    sum: [f64; 2],
    count: f64,
}

/// Appends the corners of a section with a turn of at least `least` radians, but for those between two pieces of one circle.
pub(super) fn corners(
    section: &Section,
    links: &Links,
    pieces: &Pieces,
    least: f64,
    out: &mut Vec<Weighted>,
) {
    let joints = joints(section, links, pieces);
    for joint in &joints {
        let (a, b) = joint.pieces;
        let (Some(a), Some(b)) = (&pieces.all[a as usize], &pieces.all[b as usize]) else { continue };
        let Some(p) = place(section, joint, a, b) else { continue };
        admit(section, pieces, joint.pieces, p, least, out);
    }
    let joined = |pair| joints.iter().any(|j| j.pieces == pair && j.count >= JOINT);
    gaps::gaps(section, pieces, joined, |pair, p| admit(section, pieces, pair, p, least, out));
}

/// Appends the corner of two pieces at a place unless they are smooth, a sheet or round there, or the place is vague.
fn admit(
    section: &Section,
    pieces: &Pieces,
    pair: (u32, u32),
    p: [f64; 2],
    least: f64,
    out: &mut Vec<Weighted>,
) {
    let (Some(a), Some(b)) = (&pieces.all[pair.0 as usize], &pieces.all[pair.1 as usize]) else { return };
    let evidence = pieces.loss(pair, variance(section));
    let corner = corner(section, p, [a, b], evidence);
    let turns = (least..SHEET_DEG.to_radians()).contains(&corner.edgelet.turn());
    let vague = corner.edgelet.deviation > VAGUE * section.unit;
    if turns && !vague && round_loss(section, pieces, pair) >= MORE {
        out.push(corner);
    }
}

/// How much worse one circle describes two pieces than two parabolas do: small pipes and rods have no creases.
fn round_loss(section: &Section, pieces: &Pieces, pair: (u32, u32)) -> f64 {
    let of = |&(p, label): &(&Across, &u32)| (*label == pair.0 || *label == pair.1).then_some(p.raw);
    let points: Vec<[f64; 2]> = section.points.iter().zip(&pieces.label).filter_map(|p| of(&p)).collect();
    let Some(circle) = Circle::fit(&points) else { return f64::INFINITY };
    let cost = points.iter().map(|&p| circle.off(p).powi(2)).sum::<f64>() / variance(section);
    cost - pieces.cost(pair, variance(section))
}

fn joints(section: &Section, links: &Links, pieces: &Pieces) -> Vec<Joint> {
    let mut joints: Vec<Joint> = Vec::new();
    for link in &links.all {
        let [a, b] = [link.a, link.b].map(|i| pieces.label[i as usize]);
        if a == b {
            continue;
        }
        let pieces = (a.min(b), a.max(b));
        let at = joints.iter().position(|j| j.pieces == pieces).unwrap_or(joints.len());
        if at == joints.len() {
            joints.push(Joint { pieces, sum: [0.0; 2], count: 0.0 });
        }
        let joint = &mut joints[at];
        for place in [link.a, link.b].map(|i| section.points[i as usize].place) {
            joint.sum = [joint.sum[0] + place[0], joint.sum[1] + place[1]];
            joint.count += 1.0;
        }
    }
    joints.sort_unstable_by_key(|j| j.pieces);
    joints
}

/// The place in the section where two pieces meet, if they are long enough and meet near their joint and the seed.
fn place(section: &Section, joint: &Joint, a: &Piece, b: &Piece) -> Option<[f64; 2]> {
    let (short, few) = SHORT;
    let fits = |p: &Piece| p.length() >= short + section.noise && p.count >= few;
    if joint.count < JOINT || !fits(a) || !fits(b) {
        return None;
    }
    let middle = joint.sum.map(|x| x / joint.count);
    let p = meet(a, b, middle)?;
    let gap = GAP.0 + GAP.1 * section.noise;
    let far = (p[0] - middle[0]).hypot(p[1] - middle[1]);
    let near = far <= gap && p[0].hypot(p[1]) <= CENTRE && a.offset(p).max(b.offset(p)) <= gap;
    near.then_some(p)
}

fn corner(section: &Section, p: [f64; 2], pieces: [&Piece; 2], evidence: f64) -> Weighted {
    let variance = variance(section);
    let [one, other] = pieces.map(|piece| {
        let (_, _, u) = piece.curve.value(p);
        piece.curve.deviation(u, variance)
    });
    let arms = pieces.map(|piece| section.in_space(arm(piece, p)));
    let mut edgelet = Edgelet {
        place: add_scaled(section.origin, section.in_space(p), section.unit),
        point: section.seed,
        along: section.axes[0],
        arms,
        spacing: section.unit,
        deviation: 0.0,
        evidence,
        reach: section.stations as f64 * section.unit,
        radius: 0.0,
    };
    let deviation = (one.hypot(other) / edgelet.turn().sin().abs().max(OBLIQUE)).max(EXACT);
    edgelet.deviation = deviation * section.unit;
    Weighted { edgelet, weight: 1.0 / (deviation * deviation * (1.0 + ASIDE * p[0].hypot(p[1]))) }
}

/// The unit direction of a piece at `p`, towards its middle.
fn arm(piece: &Piece, p: [f64; 2]) -> [f64; 2] {
    let (_, gradient, u) = piece.curve.value(p);
    let along = [gradient[1], -gradient[0]];
    let [a, b] = piece.curve.axis;
    let ahead = 0.5 * (piece.extent[0] + piece.extent[1]) > u;
    let sign = if (along[0] * a + along[1] * b > 0.0) == ahead { 1.0 } else { -1.0 };
    along.map(|x| sign * x / gradient[0].hypot(gradient[1]))
}
