//! Bridges from loose ends to the end or strip at which they point, or to the place where two of them would meet.
//!
//! Where a fold fades for a few spacings, or faces are too narrow to show it, the minimum spanning graph stops. Two strips that
//! stop in line with each other on both sides of a gap are one line. The shorter the gap, the more their directions may differ.
//! Not in Gumhold 2001.

use crate::math::vec3::{add_scaled, distance, dot, norm, scale, sub, unit};
use crate::neighbors::{Found, Index};
use crate::network::StripKind;
use crate::params::RepairParams;
use crate::pattern::LineGraph;
use crate::surface::Scales;

/// Gaps between creases, in spacings, and the greatest angle between either end's direction and the gap, degrees; one round
/// each, the nearest first.
const CREASE_GAPS: [(f64, f64); 4] = [(3.0, 60.0), (4.5, 40.0), (6.5, 25.0), (10.0, 10.0)];
/// The same for borders, over longer gaps: the border of a surface never ends.
const BORDER_GAPS: [(f64, f64); 7] =
    [(3.0, 60.0), (4.5, 40.0), (6.5, 25.0), (10.0, 10.0), (6.0, 100.0), (10.0, 60.0), (16.0, 30.0)];
/// Distance at which two ends are joined whatever their directions, spacings.
const TOUCHING: f64 = 1.5;
/// The same in the last round, for creases and for borders: no better partner was found, so one of them has turned a corner.
const TOUCHING_LAST: [f64; 2] = [3.5, 10.0];
/// Both ends of one strip are joined only if that closes a loop at least this many times as long as the gap.
const LOOP_TO_GAP: f64 = 3.0;
/// Length of the piece of strip that gives the direction of its end, spacings.
const TANGENT: f64 = 4.0;
/// Ends that run into a strip ahead of them: the round, the greatest distance, spacings, and the greatest angle, degrees. No end
/// is led on by more than half its own length.
const INTO_STRIP: [(usize, f64, f64); 3] = [(SIDEWAYS, 3.5, 50.0), (2, 5.5, 22.0), (3, 8.0, 10.0)];
/// Two ends that meet at an angle: the greatest distance to the meeting, and the greatest distance at which their lines pass
/// each other, spacings.
const MEETING: (f64, f64) = (4.5, 1.0);
/// Distance at which an end meets a strip whatever its direction, as a share of the reach.
const TOUCHING_STRIP: f64 = 0.14;
/// The round in which ends may also meet at an angle.
const SIDEWAYS: usize = 1;

/// A loose end: a vertex of degree one and the direction in which its strip points.
struct End {
    vertex: u32,
    position: [f64; 3],
    tangent: [f64; 3],
    /// The local spacing.
    h: f64,
    /// The vertices of its own strip near it, with their distances along the strip.
    own: Vec<(u32, f64)>,
}

impl End {
    /// The length to which its own strip was followed.
    fn length(&self) -> f64 {
        self.own.last().map_or(0.0, |o| o.1)
    }

    /// The distance of a vertex along its own strip; `None` for other vertices and far ones.
    fn along(&self, vertex: u32) -> Option<f64> {
        self.own.iter().find(|o| o.0 == vertex).map(|o| o.1)
    }
}

/// A join that closes a gap.
enum Bridge {
    /// An end to another end, or to a vertex of a strip.
    Edge(u32, u32),
    /// Both ends to a new vertex.
    Corner(u32, u32, [f64; 3]),
}

/// Joins loose ends, the cheapest first, in rounds of growing reach.
pub(crate) fn bridge(lines: &mut LineGraph, kind: StripKind, scales: Scales, params: &RepairParams) {
    let far = params.bridge_reach;
    let (gaps, last): (&[(f64, f64)], f64) = match kind {
        StripKind::Crease | StripKind::Rounded => (&CREASE_GAPS, TOUCHING_LAST[0]),
        StripKind::Border => (&BORDER_GAPS, TOUCHING_LAST[1]),
    };
    for (round, &(reach, angle)) in gaps.iter().enumerate() {
        let ends = loose_ends(lines, scales);
        let touching = if round + 1 == gaps.len() { last } else { TOUCHING };
        let mut bridges = facing(&ends, reach * far, angle, touching);
        for &(_, reach, angle) in INTO_STRIP.iter().filter(|s| s.0 == round) {
            bridges.extend(into_strips(lines, &ends, reach * far, angle));
        }
        if round == SIDEWAYS {
            bridges.extend(meetings(&ends));
        }
        bridges.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.ends().cmp(&b.1.ends())));
        for (_, bridge) in bridges {
            build(lines, bridge);
        }
    }
}

impl Bridge {
    fn ends(&self) -> (u32, u32) {
        match *self {
            Bridge::Edge(a, b) | Bridge::Corner(a, b, _) => (a, b),
        }
    }
}

/// All vertices of degree one with their directions.
fn loose_ends(lines: &LineGraph, scales: Scales) -> Vec<End> {
    (0..lines.edges.len() as u32)
        .filter(|&v| lines.edges[v as usize].len() == 1)
        .map(|v| {
            let (position, h) = (lines.positions[v as usize], scales.unit(lines.points[v as usize]));
            let (mut own, mut length) = (vec![(v, 0.0)], 0.0);
            let (mut before, mut at) = (v, lines.edges[v as usize][0]);
            let mut back = position;
            loop {
                length += distance(lines.positions[before as usize], lines.positions[at as usize]);
                own.push((at, length));
                if length <= TANGENT * h || own.len() <= 2 {
                    back = lines.positions[at as usize];
                }
                let next = &lines.edges[at as usize];
                if next.len() != 2 || length > 4.0 * TANGENT * h {
                    break;
                }
                (before, at) = (at, if next[0] == before { next[1] } else { next[0] });
            }
            End { vertex: v, position, tangent: unit(sub(position, back)), h, own }
        })
        .collect()
}

/// The ends, among those `found` within `reach` spacings of end `i`, that form a pair with it. Each pair is returned once: the
/// later ends, and the earlier ones whose own search does not reach `i`.
fn partners<'a>(
    ends: &'a [End],
    found: &'a [Found],
    i: usize,
    reach: f64,
) -> impl Iterator<Item = usize> + 'a {
    let falls_short = move |f: &Found| f.distance2 > (reach * ends[f.index as usize].h).powi(2);
    let seen = move |f: &&Found| (f.index as usize) > i || ((f.index as usize) < i && falls_short(f));
    found.iter().filter(seen).map(|f| f.index as usize)
}

/// Pairs of ends that face each other over at most `reach` spacings, with their cost.
fn facing(ends: &[End], reach: f64, angle_deg: f64, touching: f64) -> Vec<(f64, Bridge)> {
    let positions: Vec<[f64; 3]> = ends.iter().map(|e| e.position).collect();
    let index = Index::build(&positions);
    let cosine = angle_deg.to_radians().cos();
    let (mut found, mut bridges) = (Vec::new(), Vec::new());
    for (i, end) in ends.iter().enumerate() {
        index.within(end.position, reach * end.h, &mut found);
        for other in partners(ends, &found, i, reach) {
            let gap = sub(ends[other].position, end.position);
            let length = norm(gap);
            let aside =
                [dot(end.tangent, gap), -dot(ends[other].tangent, gap)].map(|d| d / length.max(1e-12));
            let straight = aside[0].min(aside[1]);
            if end.along(ends[other].vertex).is_some_and(|along| along < LOOP_TO_GAP * length) {
                continue;
            }
            if length <= touching * end.h.max(ends[other].h) || straight >= cosine {
                let cost = length * (2.0 - straight);
                bridges.push((cost, Bridge::Edge(end.vertex, ends[other].vertex)));
            }
        }
    }
    bridges
}

/// Ends that run into a strip ahead of them, at most `reach` spacings away.
fn into_strips(lines: &LineGraph, ends: &[End], reach: f64, angle_deg: f64) -> Vec<(f64, Bridge)> {
    let vertices: Vec<u32> =
        (0..lines.edges.len() as u32).filter(|&v| lines.edges[v as usize].len() > 1).collect();
    let positions: Vec<[f64; 3]> = vertices.iter().map(|&v| lines.positions[v as usize]).collect();
    let index = Index::build(&positions);
    let cosine = angle_deg.to_radians().cos();
    let (mut found, mut bridges) = (Vec::new(), Vec::new());
    for end in ends {
        let reach = reach * end.h;
        index.within(end.position, reach.min(0.5 * end.length()), &mut found);
        let nearest = found
            .iter()
            .map(|f| vertices[f.index as usize])
            .filter(|&v| end.along(v).is_none())
            .filter_map(|v| {
                let gap = sub(lines.positions[v as usize], end.position);
                let length = norm(gap);
                let straight = dot(end.tangent, gap) / length.max(1e-12);
                (straight >= cosine || length <= TOUCHING_STRIP * reach)
                    .then_some((length * (2.0 - straight), v))
            })
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        if let Some((cost, v)) = nearest {
            bridges.push((cost, Bridge::Edge(end.vertex, v)));
        }
    }
    bridges
}

/// Pairs of ends whose lines meet at an angle ahead of both, with their cost.
fn meetings(ends: &[End]) -> Vec<(f64, Bridge)> {
    let positions: Vec<[f64; 3]> = ends.iter().map(|e| e.position).collect();
    let index = Index::build(&positions);
    let (mut found, mut bridges) = (Vec::new(), Vec::new());
    for (i, end) in ends.iter().enumerate() {
        index.within(end.position, 2.0 * MEETING.0 * end.h, &mut found);
        for other in partners(ends, &found, i, 2.0 * MEETING.0) {
            let h = end.h.max(ends[other].h);
            if let Some((ahead, apart, at)) = meeting(end, &ends[other])
                && ahead <= MEETING.0 * h
                && apart <= MEETING.1 * h
            {
                bridges.push((2.0 * ahead + apart, Bridge::Corner(end.vertex, ends[other].vertex, at)));
            }
        }
    }
    bridges
}

/// The place where the lines of two ends pass nearest: its distance ahead of the farther end, the distance between the lines, and
/// the middle between them. `None` if it lies behind either end or the lines are nearly parallel.
fn meeting(a: &End, b: &End) -> Option<(f64, f64, [f64; 3])> {
    let cosine = dot(a.tangent, b.tangent);
    let sine2 = 1.0 - cosine * cosine;
    if sine2 < 0.12 {
        return None;
    }
    let gap = sub(b.position, a.position);
    let (u, v) = (dot(gap, a.tangent), dot(gap, b.tangent));
    let (s, t) = ((u - cosine * v) / sine2, (cosine * u - v) / sine2);
    if s < 0.0 || t < 0.0 {
        return None;
    }
    let (p, q) = (add_scaled(a.position, a.tangent, s), add_scaled(b.position, b.tangent, t));
    let middle = add_scaled(scale(p, 0.5), q, 0.5);
    Some((s.max(t), distance(p, q), middle))
}

/// Adds a bridge if its ends are still loose.
fn build(lines: &mut LineGraph, bridge: Bridge) {
    let loose = |lines: &LineGraph, v: u32| lines.edges[v as usize].len() == 1;
    match bridge {
        Bridge::Edge(a, b) if loose(lines, a) && !lines.edges[b as usize].is_empty() => {
            lines.add_edge(a, b);
        }
        Bridge::Corner(a, b, at) if loose(lines, a) && loose(lines, b) => {
            let corner = lines.add_vertex(a, at);
            lines.corner[corner as usize] = 0.0;
            lines.add_edge(a, corner);
            lines.add_edge(b, corner);
        }
        _ => {}
    }
}
