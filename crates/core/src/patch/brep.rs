//! Patches as faces of a boundary representation: trimmed by edges that neighbours share, which lie on the surfaces of both.
//!
//! The curves of a network and the surfaces of its patches are fitted to different points, so that they miss each other by the noise.
//! Here the surfaces hold, and the curves follow:
//!
//! 1. `choice`: the patches that can be faces, those of a known surface with closed loops;
//! 2. `vertex`: nodes, and joints of typed curves, moved onto the surfaces that meet there;
//! 3. `edge`: the curve between two vertices that lies on the surfaces of both sides: a line or a circle where these have one, else
//!    a spline through points on both;
//! 4. `short`: edges without length are taken out;
//! 5. `seam`: faces that go round an axis are cut open;
//! 6. `tangle`: faces whose edges cross or leave a side open are left out, and the others made anew;
//! 7. `shell`: faces that hang together by their edges.

mod choice;
mod edge;
mod seam;
mod shell;
mod short;
mod tangle;
mod unroll;
mod vertex;

use super::fit::Surface;
use super::patches::Patches;
use crate::curve::pieces::Shape;
use crate::network::Network;

pub use choice::Omission;

/// Faces with their edges and vertices, world frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Brep {
    /// `(V, 3)` f64, in the unit of the input.
    pub vertices: Vec<[f64; 3]>,
    /// Curves between vertices.
    pub edges: Vec<Edge>,
    /// Trimmed surfaces.
    pub faces: Vec<Face>,
    /// The faces that hang together.
    pub shells: Vec<Shell>,
    /// Patches that are no faces, with the reason, ascending.
    pub omitted: Vec<(u32, Omission)>,
    /// Greatest distance of a vertex or an edge from a surface on which it should lie, or of a vertex from the end of an edge, in
    /// the unit of the input.
    pub gap: f64,
}

/// A curve between two vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// Line, arc, circle or spline; an arc and a circle run counter-clockwise about their normal.
    pub shape: Shape,
    /// Vertices at its ends, the same one twice for a closed curve.
    pub ends: [u32; 2],
    /// The strip of the network.
    pub strip: u32,
}

/// A trimmed surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// The patch.
    pub patch: u32,
    /// Its surface.
    pub surface: Surface,
    /// Whether the normal of the surface points out of the material.
    pub outward: bool,
    /// Loops of edges, each with whether it is gone along; the face lies to their left as seen from outside. The outer loop comes
    /// first; none for a surface that closes on itself.
    pub loops: Vec<Vec<(u32, bool)>>,
    /// Unit axis of the parameters of its surface: its normal, its axis, or of a sphere that through its poles.
    pub axis: [f64; 3],
    /// Unit vector across the axis from which the angle about it counts: that of the seam, or one away from the face.
    pub first: [f64; 3],
}

/// Faces that hang together.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shell {
    /// Indices of faces, ascending.
    pub faces: Vec<u32>,
    /// Whether every edge is gone along once in each direction, so that the shell encloses a solid.
    pub closed: bool,
}

/// The patches of an extraction as faces. `network` is the network that they belong to.
pub fn brep(network: &Network, patches: &Patches) -> Brep {
    let (mut chosen, mut omitted) = choice::choice(network, patches);
    loop {
        let mut found = build(network, patches, &chosen);
        let (mut without, mut why) = (edge::astray(&found, patches), Omission::Astray);
        if without.is_empty() {
            short::collapse(&mut found);
            seam::seams(&mut found);
            (without, why) = (tangle::tangled(&mut found), Omission::Tangled);
        }
        if without.is_empty() {
            found.omitted = omitted;
            found.omitted.sort_unstable();
            found.shells = shell::shells(&found.faces);
            found.gap = edge::gap(&found);
            return found;
        }
        chosen.retain(|p| !without.contains(p));
        omitted.extend(without.into_iter().map(|p| (p, why)));
    }
}

/// Vertices, edges and faces of the chosen patches.
fn build(network: &Network, patches: &Patches, chosen: &[u32]) -> Brep {
    let mut found = Brep::default();
    let mut vertices = vertex::Vertices::new(network, patches, chosen);
    let mut of_strip: Vec<Vec<u32>> = vec![Vec::new(); network.strips.len()];
    for &p in chosen {
        let patch = &patches.patches[p as usize];
        let mut loops = Vec::new();
        for boundary in &patch.loops {
            let mut edges = Vec::new();
            for coedge in &boundary.coedges {
                let s = coedge.strip as usize;
                if of_strip[s].is_empty() {
                    let added = edge::edges(&network.strips[s], coedge.strip, &mut vertices);
                    let first = found.edges.len() as u32;
                    of_strip[s] = (first..first + added.len() as u32).collect();
                    found.edges.extend(added);
                }
                let own = of_strip[s].iter().map(|&e| (e, coedge.forward));
                if coedge.forward { edges.extend(own) } else { edges.extend(own.rev()) }
            }
            loops.push(edges);
        }
        let (surface, outward) = (patch.fit.surface, patch.fit.outward);
        let unset = [0.0; 3];
        found.faces.push(Face { patch: p, surface, outward, loops, axis: unset, first: unset });
    }
    found.vertices = vertices.positions;
    found
}

#[cfg(test)]
mod tests;
