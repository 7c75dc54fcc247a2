mod clouds;
mod sampling;
mod scanner;
mod truth;

use super::*;

fn all() -> Vec<Shape> {
    vec![
        cube(1.0),
        cuboid([4.0, 3.0, 2.0]),
        wedge(40.0),
        tapered_block(),
        star_prism(5),
        bracket(),
        brick(),
        cylinders(1.0, 0.6),
        cylinders(1.0, 1.0),
        pipe_cross(),
        sheet(),
        sheet_with_hole(),
        bent_sheet(60.0),
        tube(),
        cone(1.0, 2.0),
        stepped_shaft(),
        sphere(1.0),
        torus(1.0, 0.4),
        dome(1.0),
        keyed_shaft(),
        regular_prism(6, 2.0),
        pocketed_block(),
        punched_plate(),
        countersunk_plate(),
        crossed_bores(),
        flange(),
        counterbored_plate(),
        hex_nut(),
        slotted_plate(),
        channel(),
        hollow_shaft(),
        tapered_hub(),
        stepped_plate(),
        ribbed_bracket(),
        dovetail(),
        pulley(),
        manifold(),
        walls("slot", &[slot(3.0, 1.0), ring([0.5, 0.0], 0.3)], 1.5),
        walls("channel", &[polygon(&[[0.0, 1.0], [0.0, 0.0], [2.0, 0.0], [2.0, 1.0]], false)], 1.2),
    ]
}

fn ways() -> [Sampling; 5] {
    let scanner = |distance| Sampling::Scanner { views: 6, pitch: 0.15, distance, grazing_deg: 80.0 };
    let count = 1500;
    [
        Sampling::Grid { step: 0.2 },
        Sampling::Area { count },
        Sampling::BlueNoise { count },
        scanner(None),
        scanner(Some(3.0)),
    ]
}

/// Faces that a point lies on, trims allowing for rounding.
fn faces_at(shape: &Shape, p: [f64; 3]) -> usize {
    shape.faces.iter().filter(|f| f.surface.distance(p) < 1e-9 && touches(f, p)).count()
}

fn touches(face: &Face, p: [f64; 3]) -> bool {
    // The truth's chords leave its circles by 1e-5 of the radius.
    let beside = |n: i32| [n % 3, n / 3 % 3, n / 9].map(|s| 2e-5 * f64::from(s - 1));
    (0..27).any(|n| face.holds(crate::math::vec3::add(p, beside(n))))
}
