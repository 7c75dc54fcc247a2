//! Parts as they come from a workshop: counterbores, a nut, a slot, a channel, a hollow shaft, a hub.

use super::drilled::{BOTTOM, TOP, rectangle};
use super::polyhedron::prism;
use super::revolution::revolve;
use crate::shapes::face::{Face, Trim, shoelace};
use crate::shapes::shape::Shape;
use crate::shapes::surface::{Axes, FaceSurface};
use crate::shapes::truth::{CIRCLE, Fold, TruthCurve, circle};
use crate::shapes::turns::sin_cos;

/// A plate of 5 by 3 by 1.2 with two bores of radius 0.35, widened to 0.7 for the upper 0.5.
pub fn counterbored_plate() -> Shape {
    let (bore, head, depth, thickness) = (0.35, 0.7, 0.5, 1.2);
    let mut shape = prism("counterbored plate", &rectangle(5.0, 3.0), thickness, |p| p);
    for x in [1.4, 3.6] {
        let axes = Axes::at([x, 1.5, thickness]);
        shape.counterbore([TOP, BOTTOM], axes, [bore, head], [depth, thickness]);
    }
    shape
}

/// A hexagonal nut about z, corners at radius 1 and 0.8 high, with a bore of radius 0.45 sunk by 0.12 at both ends.
pub fn hex_nut() -> Shape {
    let (bore, sink, height) = (0.45, 0.12, 0.8);
    let outline: Vec<[f64; 2]> = (0..6).map(|i| sin_cos(f64::from(i) / 6.0)).collect();
    let mut shape = prism("hex nut", &outline, height, |p| p);
    let axes = Axes::at([0.0; 3]);
    let way = [[bore + sink, height], [bore, height - sink], [bore, sink], [bore + sink, 0.0]];
    for w in way.windows(2) {
        shape.faces.push(Face::new(FaceSurface::Cone { axes, from: w[0], to: w[1] }));
    }
    for [radius, z] in way {
        let line = circle([0.0, 0.0, z], axes.x, axes.y, radius);
        shape.network.curves.push(TruthCurve::crease(line, 45.0, Fold::Convex, None));
    }
    shape.cut(BOTTOM, axes, bore + sink);
    shape.cut(TOP, axes, bore + sink);
    shape
}

/// Ends of the slot's middle line, and half its width.
const SLOT: ([f64; 2], [f64; 2], f64) = ([1.3, 1.5], [2.7, 1.5], 0.4);

/// A plate of 4 by 3 by 0.8 with a slot through it, 1.4 long between the centres of its round ends of radius 0.4.
pub fn slotted_plate() -> Shape {
    let (thickness, (left, right, half)) = (0.8, SLOT);
    let outer = rectangle(4.0, 3.0);
    let mut shape = prism("slotted plate", &outer, thickness, |p| p);
    for (face, z) in [(BOTTOM, 0.0), (TOP, thickness)] {
        let rim: Vec<[f64; 2]> = stadium();
        // A seam leads from the first corner to the slot, round it the other way, and back.
        let way = outer.iter().chain(&outer[..1]).chain(&rim[..1]).chain(rim.iter().rev());
        let axes = *shape.faces[face].surface.axes();
        let mut outline: Vec<[f64; 2]> =
            way.map(|p| axes.to_local([p[0], p[1], z])).map(|q| [q[0], q[1]]).collect();
        if shoelace(&outline) < 0.0 {
            outline.reverse();
        }
        shape.faces[face].trims.push(Trim::Polygon(outline));
        let line = rim.iter().map(|p| [p[0], p[1], z]).collect();
        shape.network.curves.push(TruthCurve::crease(line, 90.0, Fold::Convex, None));
    }
    for ([x, y], side) in [(left, -1.0), (right, 1.0)] {
        let axes = Axes::at([x, y, 0.0]);
        let mut end = Face::new(FaceSurface::Cone { axes, from: [half, thickness], to: [half, 0.0] });
        let far = 2.0 * side;
        end.trims.push(Trim::Polygon(vec![[0.0, -2.0], [far, -2.0], [far, 2.0], [0.0, 2.0]]));
        shape.faces.push(end);
    }
    // Each wall of the slot looks at the other.
    for ([x, y], side) in [(left, 1.0), (right, -1.0)] {
        let axes = Axes {
            origin: [x, y + side * half, 0.0],
            x: [side, 0.0, 0.0],
            y: [0.0, 0.0, 1.0],
            z: [0.0, -side, 0.0],
        };
        let high = [right[0] - left[0], thickness];
        shape.faces.push(Face::new(FaceSurface::Plane { axes, low: [0.0; 2], high }));
    }
    shape
}

/// The slot's outline turning left, from the lower end of its right arc.
fn stadium() -> Vec<[f64; 2]> {
    let (left, right, half) = SLOT;
    let arc = |[x, y]: [f64; 2], from: f64| {
        // Where arc and wall meet, three faces would hold the point.
        (0..CIRCLE / 2).map(move |i| {
            let [c, s] = sin_cos(from + (f64::from(i) + 0.5) / f64::from(CIRCLE));
            [x + half * c, y + half * s]
        })
    };
    arc(right, -0.25).chain(arc(left, 0.25)).collect()
}

/// A channel 5 long along x: a web 3 wide with flanges 2 high at both sides, all 0.5 thick.
pub fn channel() -> Shape {
    let outline =
        [[0.0, 0.0], [3.0, 0.0], [3.0, 2.0], [2.5, 2.0], [2.5, 0.5], [0.5, 0.5], [0.5, 2.0], [0.0, 2.0]];
    prism("channel", &outline, 5.0, |[y, z, x]| [x, y, z])
}

/// A hollow shaft about z, 4 long: a step, a groove, and a bore in two radii.
pub fn hollow_shaft() -> Shape {
    let profile = [
        [0.4, 0.0],
        [0.8, 0.0],
        [0.8, 1.2],
        [1.1, 1.2],
        [1.1, 2.8],
        [0.9, 2.8], // the groove
        [0.9, 3.1],
        [1.1, 3.1],
        [1.1, 4.0],
        [0.6, 4.0],
        [0.6, 2.5],
        [0.4, 2.5],
        [0.4, 0.0],
    ];
    revolve("hollow shaft", &profile)
}

/// A hub about z: a disc of radius 1.8 and thickness 0.4, a neck that tapers from radius 1.1 to 0.7 over 1, a collar of
/// 0.6, and a bore of radius 0.5 through all of it.
pub fn tapered_hub() -> Shape {
    let profile =
        [[0.5, 0.0], [1.8, 0.0], [1.8, 0.4], [1.1, 0.4], [0.7, 1.4], [0.7, 2.0], [0.5, 2.0], [0.5, 0.0]];
    revolve("tapered hub", &profile)
}
