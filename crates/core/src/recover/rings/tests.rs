use super::*;
use crate::math::vec3::distance;
use crate::pattern::paths;
use crate::resolution::Resolution;
use crate::shapes::Rng;
use std::f64::consts::TAU;

const NOISE: f64 = 0.1;

fn scales() -> Scales<'static> {
    Resolution { spacing: 1.0, noise: NOISE }.into()
}

/// A plate at z = 0 with an opening, the wall of the opening down to z = -8, and the plate below it, with noise. `radius` is that of the
/// opening in each direction.
fn bored(radius: impl Fn(f64) -> f64) -> Vec<[f64; 3]> {
    let mut rng = Rng::new(5);
    let mut points = Vec::new();
    for k in 0..4000 {
        let (angle, share) = (rng.between(0.0, TAU), rng.uniform());
        let own = radius(angle);
        let far = (share * (225.0 - own * own) + own * own).sqrt();
        let [off, z] =
            if k % 4 == 0 { [own, -8.0 * share] } else { [far, if k % 2 == 0 { 0.0 } else { -8.0 }] };
        let place = [off * angle.cos(), off * angle.sin(), z];
        points.push(place.map(|c| c + NOISE * rng.gaussian()));
    }
    points
}

/// Adds a row of vertices along a curve.
fn row(lines: &mut LineGraph, count: u32, at: impl Fn(f64) -> [f64; 3]) -> u32 {
    let first = lines.edges.len() as u32;
    (0..count).for_each(|k| _ = lines.push_vertex(0, at(f64::from(k))));
    (1..count).for_each(|k| lines.add_edge(first + k - 1, first + k));
    first
}

/// Two pieces of the upper rim, a little too wide, and a line down the wall that ends on one of them.
fn pieces() -> LineGraph {
    let mut lines = LineGraph::default();
    let rim = |from: f64| move |k: f64| [4.4 * (from + 0.2 * k).cos(), 4.4 * (from + 0.2 * k).sin(), 0.2];
    let first = row(&mut lines, 10, rim(0.0));
    row(&mut lines, 8, rim(3.0));
    let down = row(&mut lines, 7, |k| [4.1, 0.0, -1.0 - k]);
    lines.add_edge(first, down);
    lines
}

fn loops(lines: &LineGraph) -> Vec<Vec<[f64; 3]>> {
    let closed = paths(lines).into_iter().filter(|p| p.ends.is_none());
    closed.map(|p| p.vertices.iter().map(|&v| lines.positions[v as usize]).collect()).collect()
}

#[test]
fn pieces_of_a_rim_become_a_circle_and_the_other_rim_is_found() {
    let mut lines = pieces();
    close(&mut lines, &bored(|_| 4.0), scales());
    let found = loops(&lines);
    assert_eq!((found.len(), paths(&lines).len()), (2, 2), "the line down the wall is none");
    for (rim, z) in found.iter().zip([0.0, -8.0]) {
        for p in rim {
            assert!((p[0].hypot(p[1]) - 4.0).abs() < 0.2 && (p[2] - z).abs() < 0.2, "{p:?} beside {z}");
        }
    }
    let longest =
        found.iter().flat_map(|rim| rim.windows(2)).map(|w| distance(w[0], w[1])).fold(0.0, f64::max);
    assert!(longest < 1.5);
}

#[test]
fn a_smooth_tube_and_a_plate_have_no_ring() {
    let tube: Vec<[f64; 3]> = bored(|_| 4.0).into_iter().filter(|p| p[0].hypot(p[1]) < 4.4).collect();
    let middle = |p: &[f64; 3]| [p[0], p[1], p[2] + 4.0];
    let plate: Vec<[f64; 3]> = bored(|_| 0.0).into_iter().filter(|p| p[2] > -0.5).collect();
    for points in [tube.iter().map(middle).collect(), plate] {
        let mut lines = pieces();
        close(&mut lines, &points, scales());
        assert_eq!(lines, pieces());
    }
}

#[test]
fn a_square_opening_is_no_ring() {
    let square = |angle: f64| 6.0 / angle.cos().abs().max(angle.sin().abs());
    let mut lines = LineGraph::default();
    row(&mut lines, 30, |k| [6.6 * (0.2 * k).cos(), 6.6 * (0.2 * k).sin(), 0.0]);
    let before = lines.clone();
    close(&mut lines, &bored(square), scales());
    assert_eq!(lines, before);
}
