//! The features of each part, axis by axis.

use super::known::Kind::{Revolution, Taper};
use super::known::{Known, PLAIN, View, hole, known, maybe, round, view};
use lineament::shapes::{self, Shape};

pub fn bracket() -> Vec<View> {
    let z = vec![
        known(PLAIN, 0.0, 1.2),
        known(PLAIN, 1.2, 2.5),
        known(PLAIN, 4.1, 5.0),
        hole(round(0.9), 0.0, 1.2),
    ];
    let y = vec![
        known(PLAIN, 0.0, 1.2),
        known(PLAIN, 1.2, 3.1),
        known(PLAIN, 4.9, 6.0),
        known(round(0.8), 1.2, 2.2),
    ];
    let x = vec![known(PLAIN, 0.0, 1.1), known(PLAIN, 2.9, 4.0)];
    vec![view(2, z), view(1, y), view(0, x)]
}

pub fn shaft() -> Vec<Known> {
    let steps = [
        (0.6, 0.0, 1.5),
        (1.0, 1.5, 3.0),
        (1.4, 3.0, 3.6),
        (1.0, 3.6, 4.2),
        (0.8, 4.2, 4.8),
        (1.0, 4.8, 6.7),
    ];
    let mut all: Vec<Known> = steps.iter().map(|&(r, from, to)| known(round(r), from, to)).collect();
    all.push(known(Taper(7.7, Some(1.0)), 6.7, 7.0));
    all
}

pub fn frustum() -> Shape {
    shapes::revolve("cone frustum", &[[0.0, 0.0], [1.5, 0.0], [0.5, 2.0], [0.0, 2.0]])
}

pub fn tapered_block() -> Vec<View> {
    // Sides meet at 4 - 0.65 z = 0 and 3 - 0.45 z = 0.
    let apex = 4.0 / 0.65;
    let x = vec![
        maybe(known(Taper(0.0, None), 0.0, 0.5)),
        known(PLAIN, 0.5, 3.2),
        maybe(known(Taper(4.0, None), 3.2, 4.0)),
    ];
    vec![view(2, vec![known(Taper(apex, None), 0.0, 2.0)]), view(0, x)]
}

pub fn torus() -> Vec<View> {
    let outer = known(Revolution(1.4), -0.4, 0.4);
    vec![view(2, vec![outer, hole(Revolution(1.0), -0.4, 0.4)])]
}

pub fn countersunk() -> Vec<View> {
    let sunk = hole(Taper(0.6, Some(0.4)), 1.0, 1.5);
    let z = vec![known(PLAIN, 0.0, 1.5), hole(round(0.4), 0.0, 1.0), sunk];
    let x = vec![known(PLAIN, 0.0, 1.1), known(PLAIN, 2.9, 4.0)];
    vec![view(2, z), view(0, x)]
}

pub fn crossed_bores() -> Vec<View> {
    let z = vec![
        known(PLAIN, 0.0, 0.7),
        known(PLAIN, 1.3, 2.0),
        hole(round(0.5), 0.0, 0.7),
        hole(round(0.5), 1.3, 2.0),
        hole(round(0.35), 0.6, 2.0),
    ];
    let x = vec![
        known(PLAIN, 0.0, 0.8),
        known(PLAIN, 1.8, 2.65),
        known(PLAIN, 3.35, 4.0),
        hole(round(0.3), 0.0, 0.8),
        hole(round(0.3), 1.8, 4.0),
    ];
    vec![view(2, z), view(0, x)]
}

pub fn punched_plate() -> Vec<View> {
    let x =
        vec![known(PLAIN, 0.0, 1.2), known(PLAIN, 1.2, 2.5), known(PLAIN, 1.2, 2.5), known(PLAIN, 2.5, 4.0)];
    let z = vec![known(PLAIN, 0.0, 0.9), hole(PLAIN, 0.0, 0.9)];
    vec![view(2, z), view(0, x)]
}

pub fn flange() -> Vec<View> {
    let mut z = vec![known(round(2.0), 0.0, 0.5), known(round(0.9), 0.5, 1.5), hole(round(0.5), 0.0, 1.5)];
    z.extend((0..6).map(|_| hole(round(0.2), 0.0, 0.5)));
    vec![View { repeats: 1, ..view(2, z) }]
}

pub fn pocketed_block() -> Vec<View> {
    let z = vec![known(PLAIN, 0.0, 2.0), hole(PLAIN, 0.8, 2.0), hole(PLAIN, 0.8, 2.0)];
    let x = [(0.0, 0.5), (0.5, 1.9), (1.9, 3.1), (3.1, 4.5), (4.5, 5.0)];
    let x: Vec<Known> = x.iter().map(|&(from, to)| known(PLAIN, from, to)).collect();
    vec![View { repeats: 1, ..view(2, z) }, view(0, x)]
}

pub fn wedge() -> Vec<View> {
    // Folding by 60 degrees, the slopes drop by half a unit to eaves at -0.5.
    let drop = 0.5;
    let half = 0.75f64.sqrt();
    let z = vec![known(PLAIN, -drop - 0.5, -drop), known(Taper(0.0, None), -drop, 0.0)];
    let y = vec![
        known(Taper(-half - 0.5 * half / drop, None), -half, 0.0),
        known(Taper(half + 0.5 * half / drop, None), 0.0, half),
    ];
    vec![view(2, z), view(1, y), view(0, vec![known(PLAIN, 0.0, 2.0)])]
}

pub fn chamfered_block() -> Vec<View> {
    let leg = 0.4 * std::f64::consts::FRAC_1_SQRT_2;
    // Along x the outline is a rectangle that grows in y over the chamfer.
    let x = vec![
        known(Taper(leg - 1.0, None), 0.0, leg),
        known(PLAIN, leg, 3.0 - leg),
        known(Taper(4.0 - leg, None), 3.0 - leg, 3.0),
    ];
    vec![view(2, vec![known(PLAIN, 0.0, 1.0)]), view(0, x)]
}

pub fn counterbored_plate() -> Vec<View> {
    let mut z = vec![known(PLAIN, 0.0, 1.2)];
    z.extend([0.0, 0.7].into_iter().flat_map(|from| {
        let (radius, to) = if from == 0.0 { (0.35, 0.7) } else { (0.7, 1.2) };
        [(); 2].map(|()| hole(round(radius), from, to))
    }));
    let x = vec![known(PLAIN, 0.0, 0.7), known(PLAIN, 2.1, 2.9), known(PLAIN, 4.3, 5.0)];
    let y = vec![known(PLAIN, 0.0, 0.8), known(PLAIN, 2.2, 3.0)];
    vec![View { repeats: 2, ..view(2, z) }, view(0, x), view(1, y)]
}

pub fn hex_nut() -> Vec<View> {
    let rim = 0.57;
    let z = vec![
        known(PLAIN, 0.0, 0.8),
        hole(Taper(rim, Some(rim)), 0.0, 0.12),
        hole(round(0.45), 0.12, 0.68),
        hole(Taper(0.8 - rim, Some(0.45)), 0.68, 0.8),
    ];
    // From the side the outline grows up to where the rim of the bore begins.
    let x = vec![known(Taper(-1.0, None), -1.0, -rim), known(Taper(1.0, None), rim, 1.0)];
    let (half, apex) = (0.75f64.sqrt(), 3f64.sqrt());
    let y = vec![known(Taper(-apex, None), -half, -rim), known(Taper(apex, None), rim, half)];
    vec![view(2, z), view(0, x), view(1, y)]
}

pub fn slotted_plate() -> Vec<View> {
    let z = vec![known(PLAIN, 0.0, 0.8), hole(PLAIN, 0.0, 0.8)];
    // Beside the slot the walls run on smoothly from its round ends.
    let beside = maybe(known(PLAIN, 1.3, 2.7));
    let x = vec![known(PLAIN, 0.0, 0.9), beside.clone(), beside, known(PLAIN, 3.1, 4.0)];
    let y = vec![known(PLAIN, 0.0, 1.1), known(PLAIN, 1.9, 3.0)];
    vec![view(2, z), view(0, x), view(1, y)]
}

pub fn channel() -> Vec<View> {
    let z = vec![known(PLAIN, 0.0, 0.5), known(PLAIN, 0.5, 2.0), known(PLAIN, 0.5, 2.0)];
    let y = vec![known(PLAIN, 0.0, 0.5), known(PLAIN, 0.5, 2.5), known(PLAIN, 2.5, 3.0)];
    vec![
        view(0, vec![known(PLAIN, 0.0, 5.0)]),
        View { repeats: 1, ..view(2, z) },
        View { repeats: 1, ..view(1, y) },
    ]
}

pub fn hollow_shaft() -> Vec<Known> {
    let steps = [(0.8, 0.0, 1.2), (1.1, 1.2, 2.8), (0.9, 2.8, 3.1), (1.1, 3.1, 4.0)];
    let mut all: Vec<Known> = steps.iter().map(|&(r, from, to)| known(round(r), from, to)).collect();
    all.extend([hole(round(0.4), 0.0, 2.5), hole(round(0.6), 2.5, 4.0)]);
    all
}

pub fn tapered_hub() -> Vec<Known> {
    vec![
        known(round(1.8), 0.0, 0.4),
        known(Taper(3.15, Some(1.1)), 0.4, 1.4),
        known(round(0.7), 1.4, 2.0),
        hole(round(0.5), 0.0, 2.0),
    ]
}

pub fn stepped_plate() -> Vec<View> {
    let z = vec![
        known(PLAIN, 0.0, 0.8),
        known(PLAIN, 0.8, 1.6),
        hole(round(0.3), 0.0, 1.2),
        hole(round(0.6), 1.2, 1.6),
        hole(round(0.5), 0.3, 0.8),
    ];
    let plain = |ranges: &[(f64, f64)]| ranges.iter().map(|&(from, to)| known(PLAIN, from, to)).collect();
    let x = plain(&[(0.0, 0.7), (1.9, 2.6), (2.6, 3.3), (4.3, 5.0)]);
    vec![view(2, z), view(0, x), view(1, plain(&[(0.0, 0.9), (2.1, 3.0)]))]
}

pub fn ribbed_bracket() -> Vec<View> {
    // Wall and foot have one thickness, so that the rib runs out along both alike; it is a small part of the outline.
    let rib = maybe(known(Taper(2.8 + 3.2 / 0.6, None), 0.8, 2.8));
    let x = [(0.0, 1.7), (1.7, 2.3), (2.3, 4.0)].map(|(from, to)| known(PLAIN, from, to));
    let along = |end| vec![known(PLAIN, 0.0, 0.8), rib.clone(), known(PLAIN, 2.8, end)];
    vec![View { repeats: 1, ..view(0, x.to_vec()) }, view(2, along(4.0)), view(1, along(5.0))]
}

pub fn dovetail() -> Vec<View> {
    let wall = known(Taper(-1.6, None), 0.8, 1.6);
    let z = vec![known(PLAIN, 0.0, 0.8), wall.clone(), wall];
    // Under the groove lies a plate, over its walls two wedges.
    let x = vec![
        known(PLAIN, 0.0, 0.9),
        known(PLAIN, 0.9, 3.1),
        known(Taper(1.2, None), 0.9, 1.2),
        known(Taper(2.8, None), 2.8, 3.1),
        known(PLAIN, 3.1, 4.0),
    ];
    vec![view(2, z), view(1, vec![known(PLAIN, 0.0, 3.0)]), view(0, x)]
}

pub fn pulley() -> Vec<Known> {
    let rims = [(1.6, 0.0, 0.3), (1.6, 0.9, 1.2), (1.3, 1.2, 1.5), (1.6, 1.5, 1.8), (0.8, 1.8, 2.4)];
    let mut all: Vec<Known> = rims.iter().map(|&(r, from, to)| known(round(r), from, to)).collect();
    all.push(known(Taper(1.5, Some(1.6)), 0.3, 0.6));
    all.push(known(Taper(-0.3, Some(1.2)), 0.6, 0.9));
    all.push(hole(round(0.4), 0.0, 2.4));
    all
}

pub fn manifold() -> Vec<View> {
    let mut z = vec![known(PLAIN, 0.0, 0.7), known(PLAIN, 1.7, 2.4)];
    for _ in 0..2 {
        z.extend([hole(round(0.3), 0.0, 0.7), hole(round(0.3), 1.7, 2.4)]);
    }
    z.extend((0..4).map(|_| hole(round(0.15), 1.6, 2.4)));
    let solid = [(0.0, 0.25), (0.55, 0.9), (1.5, 2.5), (3.1, 3.45), (3.75, 4.0)];
    let mut x: Vec<Known> = solid.iter().map(|&(from, to)| known(PLAIN, from, to)).collect();
    x.extend([(0.0, 0.9), (1.5, 2.5), (3.1, 4.0)].map(|(from, to)| hole(round(0.5), from, to)));
    vec![View { repeats: 1, ..view(2, z) }, view(0, x)]
}
