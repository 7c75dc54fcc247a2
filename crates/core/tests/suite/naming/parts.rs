//! Parts with the features that their stack of slices should show, axis by axis.

pub mod known;
mod views;

use known::{PLAIN, View, known, round, view};
use lineament::shapes::{self, Shape};
use views::*;

use known::Kind::{Revolution, Taper};

pub struct Part {
    pub shape: Shape,
    pub count: usize,
    pub views: Vec<View>,
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
