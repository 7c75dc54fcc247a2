//! Chains laid end to end where their ends were paired.

use super::chain::{Chain, Vertex};
use super::end::End;
use crate::math::vec2::{dot, sub, unit};

/// The end that an end is joined to, and the corner between them.
pub(crate) type Mate = Option<(usize, Option<[f64; 2]>)>;

/// The chains that paired ends make, and those that were closed.
pub(crate) fn splice(chains: Vec<Chain>, ends: &[End], mate: &[Mate]) -> Vec<Chain> {
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
