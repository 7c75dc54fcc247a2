//! The parts of the bench: outlines of known edges, or a cylinder cut aslant.

use lineament::shapes::{Edge, Outline, Shape, gear, polygon, ring, rounded_rectangle, slot, tube, walls};

/// A part and what its section is.
pub struct Part {
    pub name: &'static str,
    /// Its outlines, in the section's unit.
    pub outlines: Vec<Outline>,
    /// Upright walls over them.
    pub shape: Shape,
    /// Greatest extent, which the densities are shares of.
    pub size: f64,
    /// Whether the section is cut aslant, so that circles come out as ellipses.
    pub aslant: bool,
}

/// Height of the walls, in spacings.
const WALL: f64 = 10.0;

/// All parts, their walls as high as needed for a spacing that is this share of their size.
pub fn parts(spacing: f64) -> Vec<Part> {
    let part = |name, size: f64, outlines: Vec<Outline>| {
        let shape = walls(name, &outlines, WALL * spacing * size);
        Part { name, outlines, shape, size, aslant: false }
    };
    let half_pipe = vec![Edge::Arc { centre: [0.0; 2], radius: 50.0, from: 0.0, sweep: 0.5 }];
    let shell = vec![
        Edge::Line([[-80.0, 0.0], [-50.0, 0.0]]),
        Edge::Arc { centre: [0.0; 2], radius: 50.0, from: 0.5, sweep: -0.5 },
        Edge::Line([[50.0, 0.0], [80.0, 0.0]]),
    ];
    let channel = [[0.0, 60.0], [0.0, 0.0], [100.0, 0.0], [100.0, 60.0]];
    let square = polygon(&[[0.0, 0.0], [100.0, 0.0], [100.0, 80.0], [0.0, 80.0]], true);
    let hexagon: Vec<[f64; 2]> = (0..6).map(|k| ring([0.0; 2], 60.0)[0].at(f64::from(k) / 6.0)).collect();
    vec![
        part("slot", 120.0, vec![slot(120.0, 40.0)]),
        part("rounded rectangle", 120.0, vec![rounded_rectangle([120.0, 80.0], 16.0)]),
        part("half pipe", 100.0, vec![half_pipe]),
        part("open shell", 160.0, vec![shell]),
        part("gear", 100.0, vec![gear(6, [36.0, 50.0])]),
        part("bored block", 100.0, vec![square, reversed(ring([40.0, 40.0], 20.0))]),
        part("channel", 100.0, vec![polygon(&channel, false)]),
        part("hexagon", 120.0, vec![polygon(&hexagon, true)]),
        part("circle", 100.0, vec![ring([0.0; 2], 50.0)]),
        Part { name: "ellipse", outlines: Vec::new(), shape: tube(), size: 4.0, aslant: true },
    ]
}

fn reversed(outline: Outline) -> Outline {
    let back = |edge: Edge| match edge {
        Edge::Line([a, b]) => Edge::Line([b, a]),
        Edge::Arc { centre, radius, from, sweep } => {
            Edge::Arc { centre, radius, from: from + sweep, sweep: -sweep }
        }
    };
    outline.into_iter().rev().map(back).collect()
}
