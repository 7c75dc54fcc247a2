//! Relations of networks made by hand, whose curves are observed with known errors.

use super::*;
use crate::curve::pieces::{Free, Observed, Piece, Shape};
use crate::curve::{BSpline, Round};
use crate::math::uniform::uniform;
use crate::math::vec3::{add_scaled, cross, distance, dot, norm, perpendicular, sub, unit};
use crate::network::{Network, Node, NodeKind, Strip, StripKind};
use crate::params::RelationParams;
use std::time::Instant;

/// Standard deviation of a line across itself, at its middle and of its end against that; points are 1 apart.
const ERROR: f64 = 0.1;

/// Lines between nodes, with the observation of each: the true line, aside by a random error.
fn lines(places: &[[f64; 3]], pairs: &[[usize; 2]], seed: u64) -> (Network, Vec<Vec<Option<Observed>>>) {
    let mut uniform = uniform(seed);
    let mut normal = move || (0..12).map(|_| uniform()).sum::<f64>() - 6.0;
    let mut degree = vec![0; places.len()];
    pairs.iter().flatten().for_each(|&n| degree[n] += 1);
    let drawn: Vec<[f64; 3]> = places.iter().map(|p| p.map(|x| x + 0.3 * normal())).collect();
    let node = |(&position, &degree): (&[f64; 3], &u32)| Node {
        position,
        kind: NodeKind::of_degree(degree),
        degree,
        source: 0,
        sigma: None,
    };
    let nodes = drawn.iter().zip(&degree).map(node).collect();
    let strips = pairs.iter().map(|&pair| strip(pair, &drawn)).collect();
    let mut seen = |&[a, b]: &[usize; 2]| {
        let along = unit(sub(places[b], places[a]));
        let u = perpendicular(along);
        let axes = [u, cross(along, u)];
        let half = 0.5 * distance(places[a], places[b]);
        let mut at = add_scaled(places[a], along, half);
        let mut direction = along;
        let mut covariance = [[0.0; 6]; 6];
        for k in [0, 1, 4, 5] {
            covariance[k][k] = ERROR * ERROR;
        }
        for axis in axes {
            at = add_scaled(at, axis, ERROR * normal());
            direction = add_scaled(direction, axis, ERROR * normal() / half);
        }
        vec![Some(Observed { free: Free::Line { at, direction: unit(direction) }, axes, half, covariance })]
    };
    let observed = pairs.iter().map(&mut seen).collect();
    (Network { nodes, strips }, observed)
}

/// A strip of one line between two places.
fn strip([a, b]: [usize; 2], drawn: &[[f64; 3]]) -> Strip {
    let (from, to) = (drawn[a], drawn[b]);
    let points: Vec<[f64; 3]> = (0..9).map(|k| add_scaled(from, sub(to, from), f64::from(k) / 8.0)).collect();
    let curve =
        BSpline { degree: 1, knots: vec![0.0, 0.0, 1.0, 1.0], controls: vec![from, to], periodic: false };
    let piece = Piece { shape: Shape::Line, from, to, first: 0, last: 8, deviation: 0.0, sigma: None };
    Strip {
        kind: StripKind::Crease,
        closed: false,
        start: Some(a as u32),
        end: Some(b as u32),
        points,
        curve,
        curves: vec![piece],
        sources: vec![0, 1],
        deviation: 0.0,
        fold_deg: None,
        evidence: None,
        confidence: 1.0,
        sigma: Vec::new(),
        blend: None,
    }
}

fn cuboid() -> (Vec<[f64; 3]>, Vec<[usize; 2]>) {
    let place = |k: usize| [80.0 * (k & 1) as f64, 60.0 * (k >> 1 & 1) as f64, 40.0 * (k >> 2) as f64];
    let along = |axis: usize| (0..8).filter(move |k| k >> axis & 1 == 0).map(move |k| [k, k | 1 << axis]);
    ((0..8).map(place).collect(), (0..3).flat_map(along).collect())
}

fn run(network: &mut Network, observed: &[Vec<Option<Observed>>], regularise: bool) -> Related {
    let params = RelationParams { regularise, ..RelationParams::default() };
    let spacing = vec![1.0; network.strips.len()];
    related(network, observed, &spacing, 0.1, &params)
}

fn direction(strip: &Strip) -> [f64; 3] {
    unit(sub(strip.curves[0].to, strip.curves[0].from))
}

#[test]
fn a_box_has_three_directions_at_right_angles_and_planes_that_are_its_faces() {
    let (places, pairs) = cuboid();
    for seed in 0..5 {
        let (mut network, observed) = lines(&places, &pairs, seed);
        let found = run(&mut network, &observed, false);
        let counts = [RelationKind::Parallel, RelationKind::Perpendicular];
        assert_eq!(counts.map(|k| found.count(k)), [3, 3], "{seed}");
        let planes: Vec<&Relation> =
            found.relations.iter().filter(|r| r.kind == RelationKind::Coplanar).collect();
        let faces = planes.iter().filter(|r| r.members.len() == 4).count();
        assert!(faces >= 4, "{seed}: {faces}");
        for plane in planes {
            let ends = plane.members.iter().flat_map(|m| pairs[m.strip as usize]);
            let flat = |k: usize| {
                ends.clone().all(|n| places[n][k] == places[pairs[plane.members[0].strip as usize][0]][k])
            };
            assert!((0..3).any(flat), "{seed}: {plane:?}");
        }
        assert!(found.relations.iter().all(|r| r.likelihood >= 0.7 && !r.imposed));
    }
}

#[test]
fn an_imposed_box_is_a_box_to_rounding_and_nearer_the_truth() {
    let (places, pairs) = cuboid();
    let away = |network: &Network| -> f64 {
        network.nodes.iter().zip(&places).map(|(n, p)| distance(n.position, *p)).sum::<f64>() / 8.0
    };
    for seed in 0..5 {
        let (mut network, observed) = lines(&places, &pairs, seed);
        let before = away(&network);
        // A peak, which no curve ends in.
        let apex =
            Node { position: [40.0, 30.0, 50.0], kind: NodeKind::Apex, degree: 0, source: 0, sigma: None };
        network.nodes.push(apex);
        let found = run(&mut network, &observed, true);
        let directions: Vec<[f64; 3]> = network.strips.iter().map(direction).collect();
        for (a, one) in directions.iter().enumerate() {
            for (b, other) in directions.iter().enumerate() {
                let off = if a / 4 == b / 4 { norm(cross(*one, *other)) } else { dot(*one, *other).abs() };
                assert!(off < 1e-12, "{seed}: {a} {b} {off:e}");
            }
        }
        assert!(away(&network) < 0.4 * before, "{} of {before}", away(&network));
        let moved = found.regularised.unwrap();
        assert!(moved.released.is_empty() && moved.greatest() > 0.1);
        assert!(found.relations.iter().all(|r| r.imposed || r.kind == RelationKind::Symmetric));
        for strip in &network.strips {
            let ends = [strip.start, strip.end].map(|n| network.nodes[n.unwrap() as usize].position);
            assert_eq!([strip.curves[0].from, strip.curves[0].to], ends);
            assert_eq!([strip.points[0], strip.points[8]], ends);
        }
    }
}

#[test]
fn a_taper_that_the_points_show_stays_one() {
    // A long narrow wedge: its sides lean by 3 degrees, of which each is known to .3.
    let places = [[0.0, 0.0, 0.0], [40.0, 0.0, 0.0], [40.0, 10.0, 0.0], [0.0, 12.1, 0.0]];
    let pairs = [[0, 1], [1, 2], [2, 3], [3, 0]];
    let (mut network, observed) = lines(&places, &pairs, 1);
    run(&mut network, &observed, true);
    let lean = norm(cross(direction(&network.strips[0]), direction(&network.strips[2])));
    assert!((0.04..0.065).contains(&lean), "{lean}");
}

/// Adds an arc between two nodes, bent about the third axis and far better known than the nodes.
fn add_arc(
    network: &mut Network,
    observed: &mut Vec<Vec<Option<Observed>>>,
    [a, b]: [usize; 2],
    truth: Round,
) {
    let at = |n: usize| network.nodes[n].position;
    let drawn: Vec<[f64; 3]> = network.nodes.iter().map(|n| n.position).collect();
    let mut strip = strip([a, b], &drawn);
    let sweep = truth.sweep_between(at(a), at(b));
    strip.points = truth.samples(at(a), sweep, 9);
    strip.curves[0].shape = Shape::Arc { round: truth, sweep };
    let mut covariance = [[0.0; 6]; 6];
    (0..6).for_each(|k| covariance[k][k] = 1e-4);
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
    network.strips.push(strip);
    observed.push(vec![Some(Observed { free: Free::Arc(truth), axes, half: truth.radius, covariance })]);
}

/// A short arc whose points leave its radius open says nothing of where its centre lies.
#[test]
fn an_arc_whose_radius_is_open_is_in_no_relation() {
    let (places, pairs) = cuboid();
    let (mut network, mut observed) = lines(&places, &pairs, 1);
    let round = Round { centre: [40.0, 2.0, 0.0], normal: [0.0, 0.0, 1.0], radius: 1604.0_f64.sqrt() };
    for open in [0.01, 0.2] {
        add_arc(&mut network, &mut observed, [0, 1], round);
        let last = observed.len() - 1;
        let seen = observed[last][0].as_mut().unwrap();
        seen.covariance[4][4] = (open * round.radius).powi(2);
        let found = run(&mut network.clone(), &observed, false);
        let with = |r: &Relation| r.members.iter().any(|m| m.strip as usize == last);
        assert_eq!(found.relations.iter().any(with), open < 0.05, "{open}");
    }
}

/// Arcs bend what the least squares takes for straight: by steps that were not led back to the conditions nothing held. All of the box can, but not
/// that its arcs are tangent to it at corners that are known as well.
#[test]
fn relations_are_imposed_beside_arcs_that_are_better_known_than_their_ends() {
    let (places, pairs) = cuboid();
    for seed in 0..5 {
        let (mut network, mut observed) = lines(&places, &pairs, seed);
        for [a, b] in [[0, 1], [4, 5]] {
            let z = places[a][2];
            let round = Round { centre: [40.0, 2.0, z], normal: [0.0, 0.0, 1.0], radius: 1604.0_f64.sqrt() };
            add_arc(&mut network, &mut observed, [a, b], round);
        }
        let found = run(&mut network, &observed, true);
        let imposed = found.relations.iter().filter(|r| r.imposed).count();
        let released = found.regularised.unwrap().released.len();
        assert!(imposed >= 8 && released <= 9, "{seed}: {imposed} imposed, {released} released");
    }
}

/// A triangle whose long sides cannot be told from parallels is not drawn out to a line.
#[test]
fn what_would_take_the_length_of_a_line_is_not_imposed() {
    let places = [[0.0, 0.0, 0.0], [12.0, 0.0, 0.0], [12.0, 0.6, 0.0]];
    let (mut network, observed) = lines(&places, &[[0, 1], [1, 2], [2, 0]], 3);
    let found = run(&mut network, &observed, true);
    assert!(network.strips.iter().all(|s| distance(s.curves[0].from, s.curves[0].to) > 0.2));
    let moved = found.regularised.unwrap();
    assert!(moved.nodes.iter().all(|&m| m <= 3.0 * 0.5_f64.hypot(0.1)), "{moved:?}");
}

/// Seconds for relations and imposition of the front of a building, `side` windows wide and high, all of whose lines are connected; and their number.
fn front(side: usize) -> (f64, usize) {
    let place = |k: usize| [10.0 * (k % side) as f64, 0.0, 12.0 * (k / side) as f64];
    let places: Vec<[f64; 3]> = (0..side * side).map(place).collect();
    let beside = (0..side * side).filter(|k| k % side + 1 < side).map(|k| [k, k + 1]);
    let above = (0..side * (side - 1)).map(|k| [k, k + side]);
    let pairs: Vec<[usize; 2]> = beside.chain(above).collect();
    let (mut network, observed) = lines(&places, &pairs, 1);
    let began = Instant::now();
    let found = run(&mut network, &observed, true);
    let seconds = began.elapsed().as_secs_f64();
    let members: usize = found.relations.iter().map(|r| r.members.len() + r.others.len()).sum();
    assert!(members <= 8 * pairs.len(), "{members}");
    (seconds, pairs.len())
}

/// 950 lines and 3,800. By the number of pairs, or by a band as wide as the front, the time would be 16 times as long.
#[test]
fn relations_grow_with_the_number_of_lines_not_with_that_of_pairs() {
    let least = |side| (0..3).map(|_| front(side)).min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    let ((less, few), (more, many)) = (least(22), least(44));
    let power = (more / less).ln() / (many as f64 / few as f64).ln();
    assert!(power < 1.7, "{few} lines: {less} s, {many}: {more} s");
}
