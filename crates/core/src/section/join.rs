//! Chains joined at corners and over gaps into contours.
//!
//! Loose ends are paired greedily by cost, in rounds of growing reach: two that look straight at each other over a gap,
//! two whose straight continuations meet in a corner, or two so close that it does not matter how they look. What is left
//! is bridged where samples lie between.

use super::bridge::{LONGEST, Support};
use super::chain::{Chain, Vertex};
use super::stray;
use super::tree::Tree;
use super::vec2::{along, cross, distance, dot, meet, sub, unit};

/// Joins the ends of chains, the nearest first, and leaves out strays, also those along `settled` contours: contours,
/// longest first.
pub(crate) fn joined(mut chains: Vec<Chain>, settled: &[Chain], support: &Support) -> Vec<Chain> {
    for reach in [2.5, 5.0, 9.0] {
        chains = join(chains, 1.5 * reach, |ends, a, b| joint(ends, a, b, reach));
    }
    chains = join(chains, LONGEST, |ends, a, b| support.joint(ends, a, b));
    stray::dropped(chains, settled)
}

/// A loose end: where it lies and which way it looks.
#[derive(Clone, Copy)]
pub(super) struct End {
    chain: usize,
    last: bool,
    pub at: [f64; 2],
    pub out: [f64; 2],
    pub spacing: f64,
    length: f64,
    weak: bool,
}

/// How two ends meet.
#[derive(Clone, Copy)]
pub(super) struct Joint {
    pub cost: f64,
    pub a: usize,
    pub b: usize,
    pub corner: Option<[f64; 2]>,
}

/// Joins ends at most some spacings apart by a rule, the cheapest joints first.
fn join(chains: Vec<Chain>, reach: f64, rule: impl Fn(&[End], usize, usize) -> Option<Joint>) -> Vec<Chain> {
    if chains.iter().all(|c| c.closed) {
        return chains;
    }
    let ends: Vec<End> = chains.iter().enumerate().filter(|(_, c)| !c.closed).flat_map(ends_of).collect();
    let places: Vec<[f64; 2]> = ends.iter().map(|e| e.at).collect();
    let tree = Tree::new(&places);
    let (mut joints, mut found) = (Vec::new(), Vec::new());
    for (a, end) in ends.iter().enumerate() {
        tree.within(end.at, reach * end.spacing, &mut found);
        let later = found.iter().map(|&b| b as usize).filter(|&b| b > a && may_join(end, &ends[b]));
        joints.extend(later.filter_map(|b| rule(&ends, a, b)));
    }
    for j in &mut joints {
        j.cost += if ends[j.a].weak || ends[j.b].weak { WEAK } else { 0.0 };
    }
    joints.sort_by(|x, y| x.cost.total_cmp(&y.cost).then((x.a, x.b).cmp(&(y.a, y.b))));
    let mut mate = vec![None; ends.len()];
    for j in &joints {
        if mate[j.a].is_none() && mate[j.b].is_none() {
            mate[j.a] = Some((j.b, j.corner));
            mate[j.b] = Some((j.a, j.corner));
        }
    }
    splice(chains, &ends, &mate)
}

fn ends_of((index, chain): (usize, &Chain)) -> [End; 2] {
    let length = chain.length();
    let end = |last: bool| {
        let v = &chain.vertices;
        let pick = |k: usize| if last { v[v.len() - 1 - k] } else { v[k] };
        let tip = pick(0);
        // Three steps back: one node beside a corner may lean.
        let back = pick(3.min(v.len() - 1));
        End {
            chain: index,
            last,
            at: tip.at,
            out: unit(sub(tip.at, back.at)),
            spacing: tip.spacing,
            length,
            weak: tip.weak,
        }
    };
    [end(false), end(true)]
}

/// Whether two ends lie near enough to each other beside what they are the ends of.
fn may_join(e: &End, f: &End) -> bool {
    let (gap, spacing) = (distance(e.at, f.at), 0.5 * (e.spacing + f.spacing));
    if e.chain == f.chain {
        gap <= 0.5 * e.length
    } else {
        gap <= (e.length.min(f.length) + spacing).max(1.5 * spacing)
    }
}

fn joint(ends: &[End], a: usize, b: usize, reach: f64) -> Option<Joint> {
    let (e, f) = (&ends[a], &ends[b]);
    let spacing = 0.5 * (e.spacing + f.spacing);
    let gap = distance(e.at, f.at);
    let turn = (-dot(e.out, f.out)).clamp(-1.0, 1.0).acos().to_degrees();
    let near = (gap <= NEAR * spacing).then_some(Joint { cost: NEAR + gap / spacing, a, b, corner: None });
    if turn < 30.0 {
        return straight(e, f, gap, spacing, reach).map(|cost| Joint { cost, a, b, corner: None }).or(near);
    }
    corner(e, f, spacing, reach, turn).map(|(cost, at)| Joint { cost, a, b, corner: Some(at) }).or(near)
}

/// What a joint to a weak end costs more, in local spacings.
const WEAK: f64 = 2.5;
/// Ends this close, in local spacings, belong together whichever way they look.
const NEAR: f64 = 3.0;

fn corner(e: &End, f: &End, spacing: f64, reach: f64, turn: f64) -> Option<(f64, [f64; 2])> {
    let (ahead, behind) = meet(e.at, e.out, f.at, f.out)?;
    let late = |x: f64| if x < 0.0 { -2.0 * x } else { x };
    let cost = (late(ahead) + late(behind)) / spacing;
    let back = -1.2 * spacing;
    if turn > 165.0 || ahead < back || behind < back || cost > reach {
        return None;
    }
    Some((cost + 0.3, along(e.at, e.out, ahead)))
}

fn straight(e: &End, f: &End, gap: f64, spacing: f64, reach: f64) -> Option<f64> {
    let step = sub(f.at, e.at);
    let (forward, aside) = (dot(step, e.out), cross(e.out, step).abs().min(cross(f.out, step).abs()));
    let fits = forward > -0.7 * spacing && aside <= 0.3 * gap + 0.4 * spacing && gap <= reach * spacing;
    fits.then_some((gap + aside) / spacing)
}

/// The end that an end is joined to, and the corner between them.
type Mate = Option<(usize, Option<[f64; 2]>)>;

fn splice(chains: Vec<Chain>, ends: &[End], mate: &[Mate]) -> Vec<Chain> {
    // Ends come in pairs: `e` and `e ^ 1` belong to one chain.
    let mut seen = vec![false; ends.len() / 2];
    let mut result: Vec<Chain> = chains.iter().filter(|c| c.closed).cloned().collect();
    let loose = (0..ends.len()).filter(|&e| mate[e].is_none());
    for start in loose.chain(0..ends.len()).collect::<Vec<_>>() {
        if seen[start / 2] {
            continue;
        }
        result.push(follow(&chains, ends, mate, start, &mut seen));
    }
    result
}

fn follow(chains: &[Chain], ends: &[End], mate: &[Mate], start: usize, seen: &mut [bool]) -> Chain {
    let mut vertices: Vec<Vertex> = Vec::new();
    let mut entry = start;
    let mut closed = false;
    loop {
        seen[entry / 2] = true;
        let piece = &chains[ends[entry].chain].vertices;
        if ends[entry].last {
            append(&mut vertices, piece.iter().rev().copied());
        } else {
            append(&mut vertices, piece.iter().copied());
        }
        let Some((next, corner)) = mate[entry ^ 1] else { break };
        if let Some(at) = corner {
            trim(&mut vertices, at, ends[entry ^ 1].out);
            vertices.push(Vertex::corner(at, ends[next].spacing));
        }
        if next == start {
            closed = true;
            break;
        }
        if seen[next / 2] {
            break;
        }
        entry = next;
    }
    if closed {
        close_trim(&mut vertices);
    }
    Chain { closed: closed && vertices.len() >= 3, vertices }
}

/// Adds a piece, leaving out its first vertices that lie behind the corner just set.
fn append(vertices: &mut Vec<Vertex>, piece: impl Iterator<Item = Vertex>) {
    let corner = vertices.last().filter(|v| v.corner).copied();
    let piece: Vec<Vertex> = piece.collect();
    let mut skip = 0;
    if let Some(c) = corner {
        let away = unit(sub(piece[3.min(piece.len() - 1)].at, c.at));
        while skip + 1 < piece.len() && dot(sub(piece[skip].at, c.at), away) < 0.25 * c.spacing {
            skip += 1;
        }
    }
    vertices.extend_from_slice(&piece[skip..]);
}

/// Takes off the last vertices that lie past a corner.
fn trim(vertices: &mut Vec<Vertex>, at: [f64; 2], out: [f64; 2]) {
    while vertices.len() > 1 {
        let last = vertices[vertices.len() - 1];
        if last.corner || dot(sub(at, last.at), out) >= 0.25 * last.spacing {
            break;
        }
        vertices.pop();
    }
}

/// A closing corner was set after the first piece was laid: its first vertices may lie behind it.
fn close_trim(vertices: &mut Vec<Vertex>) {
    let Some(c) = vertices.last().filter(|v| v.corner).copied() else { return };
    let away = unit(sub(vertices[3.min(vertices.len() - 1)].at, c.at));
    let behind = |v: &Vertex| !v.corner && dot(sub(v.at, c.at), away) < 0.25 * c.spacing;
    let skip = vertices.iter().take(3).take_while(|v| behind(v)).count();
    vertices.drain(..skip);
}
