//! Parts with what their stack of slices is to say, axis by axis.

use lineament::shapes::{self, Shape};

/// What a feature is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// With its radius if round.
    Extrusion(Option<f64>),
    /// With its apex, and its radius at the low end if round.
    Taper(f64, Option<f64>),
    /// With its greatest radius.
    Revolution(f64),
}

/// A feature that a part has along an axis.
#[derive(Clone, Debug)]
pub struct Known {
    pub kind: Kind,
    pub hole: bool,
    pub from: f64,
    pub to: f64,
    /// Whether it need not be named: too short, or a matter of taste.
    pub optional: bool,
}

impl Known {
    /// The feature along the axis (1), or against it (-1).
    pub fn along(&self, way: f64) -> Known {
        if way > 0.0 {
            return self.clone();
        }
        let kind = match self.kind {
            Kind::Taper(apex, radius) => {
                let at = |r: f64| r * (apex - self.to) / (apex - self.from);
                Kind::Taper(-apex, radius.map(at))
            }
            other => other,
        };
        Known { kind, from: -self.to, to: -self.from, ..self.clone() }
    }
}

/// A part seen along one axis.
pub struct View {
    pub axis: usize,
    pub features: Vec<Known>,
    /// Groups of equal runs.
    pub repeats: usize,
}

pub struct Part {
    pub shape: Shape,
    pub count: usize,
    pub views: Vec<View>,
}

use Kind::{Extrusion, Revolution, Taper};

fn known(kind: Kind, from: f64, to: f64) -> Known {
    Known { kind, hole: false, from, to, optional: false }
}

fn hole(kind: Kind, from: f64, to: f64) -> Known {
    Known { hole: true, ..known(kind, from, to) }
}

fn maybe(known: Known) -> Known {
    Known { optional: true, ..known }
}

fn view(axis: usize, features: Vec<Known>) -> View {
    View { axis, features, repeats: 0 }
}

const PLAIN: Kind = Extrusion(None);

fn round(radius: f64) -> Kind {
    Extrusion(Some(radius))
}

/// All parts.
pub fn parts() -> Vec<Part> {
    let part = |shape, count, views| Part { shape, count, views };
    vec![
        part(shapes::bracket(), 40_000, bracket()),
        part(shapes::stepped_shaft(), 40_000, vec![view(2, shaft()), view(0, vec![])]),
        part(shapes::tube(), 15_000, vec![view(2, vec![known(round(1.0), 0.0, 4.0)]), view(0, vec![])]),
        part(shapes::tapered_block(), 30_000, tapered_block()),
        part(shapes::star_prism(5), 20_000, vec![view(2, vec![known(PLAIN, 0.0, 2.0)])]),
        part(
            shapes::cone(1.0, 2.0),
            15_000,
            vec![view(2, vec![known(Taper(2.0, Some(1.0)), 0.0, 2.0)]), view(0, vec![])],
        ),
        part(frustum(), 20_000, vec![view(2, vec![known(Taper(3.0, Some(1.5)), 0.0, 2.0)])]),
        part(shapes::sphere(1.0), 15_000, vec![view(2, vec![known(Revolution(1.0), -1.0, 1.0)])]),
        part(
            shapes::dome(1.0),
            15_000,
            vec![view(2, vec![known(Revolution(1.0), 0.0, 1.0)]), view(0, vec![])],
        ),
        part(shapes::torus(1.0, 0.4), 20_000, torus()),
        part(shapes::countersunk_plate(), 30_000, countersunk()),
        part(shapes::crossed_bores(), 40_000, crossed_bores()),
        part(shapes::punched_plate(), 20_000, punched_plate()),
        part(shapes::keyed_shaft(), 20_000, vec![view(2, vec![known(PLAIN, 0.0, 3.0)])]),
        part(shapes::regular_prism(6, 2.0), 15_000, vec![view(2, vec![known(PLAIN, 0.0, 2.0)])]),
        part(shapes::flange(), 40_000, flange()),
        part(shapes::pocketed_block(), 40_000, pocketed_block()),
        part(shapes::wedge(60.0), 15_000, wedge()),
        part(shapes::chamfered_block(0.4), 15_000, chamfered_block()),
    ]
}

/// Parts that no method was tried on while it was made: they tell what to expect of others.
pub fn held_out() -> Vec<Part> {
    let part = |shape, count, views| Part { shape, count, views };
    vec![
        part(shapes::counterbored_plate(), 40_000, counterbored_plate()),
        part(shapes::hex_nut(), 30_000, hex_nut()),
        part(shapes::slotted_plate(), 30_000, slotted_plate()),
        part(shapes::channel(), 40_000, channel()),
        part(shapes::hollow_shaft(), 40_000, vec![view(2, hollow_shaft())]),
        part(shapes::tapered_hub(), 40_000, vec![view(2, tapered_hub())]),
    ]
}

/// Parts that came last, when all methods had been made.
pub fn newest() -> Vec<Part> {
    let part = |shape, count, views| Part { shape, count, views };
    vec![
        part(shapes::stepped_plate(), 40_000, stepped_plate()),
        part(shapes::ribbed_bracket(), 40_000, ribbed_bracket()),
        part(shapes::dovetail(), 40_000, dovetail()),
        part(shapes::pulley(), 40_000, vec![view(2, pulley())]),
        part(shapes::manifold(), 40_000, manifold()),
    ]
}

fn bracket() -> Vec<View> {
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

fn shaft() -> Vec<Known> {
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

fn frustum() -> Shape {
    shapes::revolve("cone frustum", &[[0.0, 0.0], [1.5, 0.0], [0.5, 2.0], [0.0, 2.0]])
}

fn tapered_block() -> Vec<View> {
    // Sides meet at 4 - 0.65 z = 0 and 3 - 0.45 z = 0.
    let apex = 4.0 / 0.65;
    let x = vec![
        maybe(known(Taper(0.0, None), 0.0, 0.5)),
        known(PLAIN, 0.5, 3.2),
        maybe(known(Taper(4.0, None), 3.2, 4.0)),
    ];
    vec![view(2, vec![known(Taper(apex, None), 0.0, 2.0)]), view(0, x)]
}

fn torus() -> Vec<View> {
    let outer = known(Revolution(1.4), -0.4, 0.4);
    vec![view(2, vec![outer, hole(Revolution(1.0), -0.4, 0.4)])]
}

fn countersunk() -> Vec<View> {
    let sunk = hole(Taper(0.6, Some(0.4)), 1.0, 1.5);
    let z = vec![known(PLAIN, 0.0, 1.5), hole(round(0.4), 0.0, 1.0), sunk];
    let x = vec![known(PLAIN, 0.0, 1.1), known(PLAIN, 2.9, 4.0)];
    vec![view(2, z), view(0, x)]
}

fn crossed_bores() -> Vec<View> {
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

fn punched_plate() -> Vec<View> {
    let x =
        vec![known(PLAIN, 0.0, 1.2), known(PLAIN, 1.2, 2.5), known(PLAIN, 1.2, 2.5), known(PLAIN, 2.5, 4.0)];
    let z = vec![known(PLAIN, 0.0, 0.9), hole(PLAIN, 0.0, 0.9)];
    vec![view(2, z), view(0, x)]
}

fn flange() -> Vec<View> {
    let mut z = vec![known(round(2.0), 0.0, 0.5), known(round(0.9), 0.5, 1.5), hole(round(0.5), 0.0, 1.5)];
    z.extend((0..6).map(|_| hole(round(0.2), 0.0, 0.5)));
    vec![View { repeats: 1, ..view(2, z) }]
}

fn pocketed_block() -> Vec<View> {
    let z = vec![known(PLAIN, 0.0, 2.0), hole(PLAIN, 0.8, 2.0), hole(PLAIN, 0.8, 2.0)];
    let x = [(0.0, 0.5), (0.5, 1.9), (1.9, 3.1), (3.1, 4.5), (4.5, 5.0)];
    let x: Vec<Known> = x.iter().map(|&(from, to)| known(PLAIN, from, to)).collect();
    vec![View { repeats: 1, ..view(2, z) }, view(0, x)]
}

fn wedge() -> Vec<View> {
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

fn chamfered_block() -> Vec<View> {
    let leg = 0.4 * std::f64::consts::FRAC_1_SQRT_2;
    // Along x the outline is a rectangle that grows in y over the chamfer.
    let x = vec![
        known(Taper(leg - 1.0, None), 0.0, leg),
        known(PLAIN, leg, 3.0 - leg),
        known(Taper(4.0 - leg, None), 3.0 - leg, 3.0),
    ];
    vec![view(2, vec![known(PLAIN, 0.0, 1.0)]), view(0, x)]
}

fn counterbored_plate() -> Vec<View> {
    let mut z = vec![known(PLAIN, 0.0, 1.2)];
    z.extend([0.0, 0.7].into_iter().flat_map(|from| {
        let (radius, to) = if from == 0.0 { (0.35, 0.7) } else { (0.7, 1.2) };
        [(); 2].map(|()| hole(round(radius), from, to))
    }));
    let x = vec![known(PLAIN, 0.0, 0.7), known(PLAIN, 2.1, 2.9), known(PLAIN, 4.3, 5.0)];
    let y = vec![known(PLAIN, 0.0, 0.8), known(PLAIN, 2.2, 3.0)];
    vec![View { repeats: 2, ..view(2, z) }, view(0, x), view(1, y)]
}

fn hex_nut() -> Vec<View> {
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

fn slotted_plate() -> Vec<View> {
    let z = vec![known(PLAIN, 0.0, 0.8), hole(PLAIN, 0.0, 0.8)];
    // Beside the slot the walls run on smoothly from its round ends.
    let beside = maybe(known(PLAIN, 1.3, 2.7));
    let x = vec![known(PLAIN, 0.0, 0.9), beside.clone(), beside, known(PLAIN, 3.1, 4.0)];
    let y = vec![known(PLAIN, 0.0, 1.1), known(PLAIN, 1.9, 3.0)];
    vec![view(2, z), view(0, x), view(1, y)]
}

fn channel() -> Vec<View> {
    let z = vec![known(PLAIN, 0.0, 0.5), known(PLAIN, 0.5, 2.0), known(PLAIN, 0.5, 2.0)];
    let y = vec![known(PLAIN, 0.0, 0.5), known(PLAIN, 0.5, 2.5), known(PLAIN, 2.5, 3.0)];
    vec![
        view(0, vec![known(PLAIN, 0.0, 5.0)]),
        View { repeats: 1, ..view(2, z) },
        View { repeats: 1, ..view(1, y) },
    ]
}

fn hollow_shaft() -> Vec<Known> {
    let steps = [(0.8, 0.0, 1.2), (1.1, 1.2, 2.8), (0.9, 2.8, 3.1), (1.1, 3.1, 4.0)];
    let mut all: Vec<Known> = steps.iter().map(|&(r, from, to)| known(round(r), from, to)).collect();
    all.extend([hole(round(0.4), 0.0, 2.5), hole(round(0.6), 2.5, 4.0)]);
    all
}

fn tapered_hub() -> Vec<Known> {
    vec![
        known(round(1.8), 0.0, 0.4),
        known(Taper(3.15, Some(1.1)), 0.4, 1.4),
        known(round(0.7), 1.4, 2.0),
        hole(round(0.5), 0.0, 2.0),
    ]
}

fn stepped_plate() -> Vec<View> {
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

fn ribbed_bracket() -> Vec<View> {
    // Wall and foot have one thickness, so that the rib runs out along both alike; it is a small part of the outline.
    let rib = maybe(known(Taper(2.8 + 3.2 / 0.6, None), 0.8, 2.8));
    let x = [(0.0, 1.7), (1.7, 2.3), (2.3, 4.0)].map(|(from, to)| known(PLAIN, from, to));
    let along = |end| vec![known(PLAIN, 0.0, 0.8), rib.clone(), known(PLAIN, 2.8, end)];
    vec![View { repeats: 1, ..view(0, x.to_vec()) }, view(2, along(4.0)), view(1, along(5.0))]
}

fn dovetail() -> Vec<View> {
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

fn pulley() -> Vec<Known> {
    let rims = [(1.6, 0.0, 0.3), (1.6, 0.9, 1.2), (1.3, 1.2, 1.5), (1.6, 1.5, 1.8), (0.8, 1.8, 2.4)];
    let mut all: Vec<Known> = rims.iter().map(|&(r, from, to)| known(round(r), from, to)).collect();
    all.push(known(Taper(1.5, Some(1.6)), 0.3, 0.6));
    all.push(known(Taper(-0.3, Some(1.2)), 0.6, 0.9));
    all.push(hole(round(0.4), 0.0, 2.4));
    all
}

fn manifold() -> Vec<View> {
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
