//! Scenes to be surveyed: rooms, buildings and plant, with the edges of what stands in them.

use super::polyhedron::polyhedron;
use super::revolution::revolve_about;
use crate::shapes::shape::Shape;
use crate::shapes::surface::Axes;

/// The faces of a block whose corner `i` is high in x, y, z where the bits 0, 1, 2 of `i` are set; the lowest comes last.
const BLOCK: [&[u32]; 6] =
    [&[0, 4, 6, 2], &[1, 3, 7, 5], &[0, 1, 5, 4], &[2, 6, 7, 3], &[4, 5, 7, 6], &[0, 2, 3, 1]];

/// A room 6 by 4.5 by 2.6 metres, to be seen from inside, with a cupboard, two boxes and a column from floor to ceiling.
pub fn room() -> Shape {
    let mut scene = block([0.0; 3], [6.0, 4.5, 2.6]);
    scene.join(block([0.0, 1.2, 0.0], [0.6, 2.8, 2.0]));
    scene.join(block([3.2, 3.1, 0.0], [4.4, 3.9, 0.75]));
    scene.join(block([3.5, 3.3, 0.75], [3.9, 3.7, 1.2]));
    scene.join(upright([4.6, 1.4], 0.22, [0.0, 2.6]));
    Shape { name: "room", ..scene }
}

/// A house with a gable roof and a lower wing on a lawn 30 metres square.
pub fn farmyard() -> Shape {
    let lawn = [[-15.0, -15.0, 0.0], [15.0, -15.0, 0.0], [15.0, 15.0, 0.0], [-15.0, 15.0, 0.0]];
    let mut scene = polyhedron("lawn", &lawn, &[&[0, 1, 2, 3]]);
    scene.join(house([-5.0, -4.0], [4.0, 3.0], 4.0, 6.8));
    scene.join(block([4.0, -2.0, 0.0], [7.5, 2.0, 2.6]));
    Shape { name: "farmyard", ..scene }
}

/// Two tanks, a beam across them and a plinth on a floor 12 metres square.
pub fn plant() -> Shape {
    let floor = [[-6.0, -6.0, 0.0], [6.0, -6.0, 0.0], [6.0, 6.0, 0.0], [-6.0, 6.0, 0.0]];
    let mut scene = polyhedron("floor", &floor, &[&[0, 1, 2, 3]]);
    scene.join(upright([-2.0, 0.0], 1.0, [0.0, 3.2]));
    scene.join(upright([2.2, 0.4], 0.8, [0.0, 2.6]));
    scene.join(block([-4.5, 2.0, 0.0], [-2.5, 4.0, 0.5]));
    scene.join(block([-4.0, -2.6, 2.8], [4.0, -2.3, 3.1]));
    Shape { name: "plant", ..scene }
}

/// The block between two opposite corners.
fn block(low: [f64; 3], high: [f64; 3]) -> Shape {
    let corner = |i: usize| [0, 1, 2].map(|k| if i >> k & 1 == 1 { high[k] } else { low[k] });
    polyhedron("block", &(0..8).map(corner).collect::<Vec<_>>(), &BLOCK)
}

/// A house between two corners of its plan, with the ridge along x.
fn house(low: [f64; 2], high: [f64; 2], eaves: f64, ridge: f64) -> Shape {
    let middle = 0.5 * (low[1] + high[1]);
    let gable = |x: f64| {
        [[x, low[1], 0.0], [x, high[1], 0.0], [x, high[1], eaves], [x, middle, ridge], [x, low[1], eaves]]
    };
    let corners: Vec<[f64; 3]> = [gable(low[0]), gable(high[0])].concat();
    let faces: [&[u32]; 7] = [
        &[0, 4, 3, 2, 1],
        &[5, 6, 7, 8, 9],
        &[0, 5, 9, 4],
        &[1, 2, 7, 6],
        &[2, 3, 8, 7],
        &[3, 4, 9, 8],
        &[0, 1, 6, 5],
    ];
    polyhedron("house", &corners, &faces)
}

/// A closed cylinder that stands between two heights.
fn upright(centre: [f64; 2], radius: f64, [low, high]: [f64; 2]) -> Shape {
    let axes = Axes::at([centre[0], centre[1], 0.0]);
    revolve_about("upright", axes, &[[0.0, low], [radius, low], [radius, high], [0.0, high]])
}
