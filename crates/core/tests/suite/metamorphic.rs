//! What must not change the network, or change it in a known way.

use crate::common::{cloud, few_bits, found};
use lineament::curve::pieces::{Piece, Shape, Sigma};
use lineament::shapes::{self, Rng, Sampling, Scan, Truth, TruthCurve, TruthNode};
use lineament::shapes::{Fold, bent_sheet, cube_386, cylinders, random_cube, sheet_with_hole, wedge};
use lineament::{Extraction, Network, evaluate};
use std::sync::OnceLock;

/// A cloud with what is found in it.
struct Base {
    name: &'static str,
    points: Vec<[f64; 3]>,
    found: Extraction,
}

/// The clouds of these tests with what is found in them, which all tests share.
fn bases() -> &'static [Base] {
    static BASES: OnceLock<Vec<Base>> = OnceLock::new();
    let base = |(name, points): (_, Vec<[f64; 3]>)| Base { name, found: found(&cloud(&points)), points };
    BASES.get_or_init(|| clouds().into_iter().map(base).collect())
}

/// Clouds with creases, borders, loops and noise, no point twice, coordinates of few bits.
fn clouds() -> Vec<(&'static str, Vec<[f64; 3]>)> {
    let scan = |shape: shapes::Shape, count, noise| {
        shape.sample(&Scan::new(Sampling::BlueNoise { count }).noise(noise).seed(3)).cloud.positions
    };
    let clouds = [
        ("cube", cube_386().cloud.positions),
        ("bent sheet", scan(bent_sheet(60.0), 1500, 0.1)),
        ("sheet with a hole", scan(sheet_with_hole(), 2000, 0.0)),
        ("cylinders", scan(cylinders(1.0, 0.6), 3000, 0.0)),
        ("wedge", scan(wedge(90.0), 2500, 0.25)),
    ];
    let clouds = clouds.into_iter().chain([("strays, rows and a coarse sheet", uneven())]);
    clouds.map(|(name, points)| (name, few_bits(&points))).collect()
}

/// A folded sheet in rows, beside it a sheet four times as coarse, and strays above both.
fn uneven() -> Vec<[f64; 3]> {
    let mut rng = Rng::new(11);
    let mut points = crate::scales::rows();
    let mut coarse = |i: u32| [f64::from(i % 20), f64::from(i / 20)].map(|x| 2.0 * x + 0.3 * rng.uniform());
    points.extend((0..400).map(&mut coarse).map(|[x, y]| [x + 60.0, y, 0.0]));
    points.extend((0..12).map(|i| [8.0 * f64::from(i), 17.0 - f64::from(i % 5), 45.0 + 3.0 * f64::from(i)]));
    points
}

/// The network with its sources as `number` counts them.
fn renumbered(mut network: Network, number: impl Fn(u32) -> u32) -> Network {
    network.nodes.iter_mut().for_each(|n| n.source = number(n.source));
    network.strips.iter_mut().flat_map(|s| &mut s.sources).for_each(|s| *s = number(*s));
    network
}

/// The network with its positions through `place` and its lengths times `scale`.
fn mapped(mut network: Network, scale: f64, place: impl Fn([f64; 3]) -> [f64; 3]) -> Network {
    let put = |p: &mut [f64; 3]| *p = place(*p);
    network.nodes.iter_mut().for_each(|n| put(&mut n.position));
    for strip in &mut network.strips {
        strip.points.iter_mut().for_each(put);
        strip.curve.controls.iter_mut().for_each(put);
        strip.curve.knots.iter_mut().for_each(|t| *t *= scale);
        strip.deviation *= scale;
        strip.curves.iter_mut().for_each(|piece| place_piece(piece, scale, &place));
    }
    network
}

/// Moves a piece of a strip by a map that turns nothing.
fn place_piece(piece: &mut Piece, scale: f64, place: impl Fn([f64; 3]) -> [f64; 3]) {
    (piece.from, piece.to) = (place(piece.from), place(piece.to));
    piece.deviation *= scale;
    match &mut piece.shape {
        Shape::Line => {}
        Shape::Arc { round, .. } | Shape::Circle(round) => {
            (round.centre, round.radius) = (place(round.centre), round.radius * scale);
        }
        Shape::Ellipse { ellipse, .. } => {
            ellipse.centre = place(ellipse.centre);
            ellipse.major.iter_mut().for_each(|x| *x *= scale);
            ellipse.minor *= scale;
        }
        Shape::Spline(curve) => {
            curve.controls.iter_mut().for_each(|p| *p = place(*p));
            curve.knots.iter_mut().for_each(|t| *t *= scale);
        }
    }
    match &mut piece.sigma {
        None => {}
        Some(Sigma::Line { offset, .. }) => *offset *= scale,
        Some(Sigma::Round { radius, covariance, .. }) => {
            *radius *= scale;
            covariance.iter_mut().flatten().for_each(|c| *c *= scale * scale);
        }
        Some(Sigma::Ellipse { covariance, .. }) => {
            covariance.iter_mut().flatten().for_each(|c| *c *= scale * scale);
        }
    }
}

/// Equality of every bit but the signs of zeros and the payloads of NaNs, of which there are none.
#[track_caller]
fn same(a: &Network, b: &Network, what: &str) {
    let counts = |n: &Network| (n.strips.len(), n.nodes.len());
    assert_eq!(counts(a), counts(b), "{what}");
    assert_eq!(a.nodes, b.nodes, "{what}");
    for (i, (x, y)) in a.strips.iter().zip(&b.strips).enumerate() {
        assert_eq!(x, y, "{what}: strip {i}");
    }
}

fn shuffled(count: usize, seed: u64) -> Vec<u32> {
    let mut rng = Rng::new(seed);
    let mut order: Vec<u32> = (0..count as u32).collect();
    for i in (1..count).rev() {
        order.swap(i, rng.below(i as u64 + 1) as usize);
    }
    order
}

#[test]
fn clouds_of_these_tests_have_lines() {
    for Base { name, found, .. } in bases() {
        assert!(found.network.strips.len() >= 2, "{name}");
    }
}

#[test]
fn one_of_these_clouds_has_clutter_rows_and_two_spacings() {
    let result = &bases().last().unwrap().found;
    assert!(result.clutter.len() >= 12, "{}", result.clutter.len());
    assert!(result.report.points + result.clutter.len() < uneven().len() / 2, "{}", result.report.points);
}

#[test]
fn order_of_the_points_changes_the_numbering_alone() {
    for Base { name, points, found: first } in bases() {
        for seed in 1..=5 {
            let order = shuffled(points.len(), seed);
            let moved: Vec<[f64; 3]> = order.iter().map(|&i| points[i as usize]).collect();
            let result = found(&cloud(&moved));
            let network = renumbered(result.network.clone(), |s| order[s as usize]);
            same(&first.network, &network, &format!("{name}, order {seed}"));
            let (a, b) = (first.classes(), result.classes());
            assert!(order.iter().zip(&b).all(|(&i, &class)| a[i as usize] == class), "{name}, order {seed}");
        }
    }
}

#[test]
fn number_of_threads_changes_nothing() {
    for Base { name, points, .. } in bases() {
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| found(&cloud(points)))
        };
        let one = with(1);
        for threads in [2, 8] {
            let other = with(threads);
            same(&one.network, &other.network, &format!("{name}, {threads} threads"));
            assert_eq!(
                (one.classes(), &one.measure.score, &one.source),
                (other.classes(), &other.measure.score, &other.source),
                "{name}, {threads} threads"
            );
        }
    }
}

#[test]
fn threads_change_nothing_in_a_cloud_of_many_blocks() {
    let points = random_cube(1, 10_000).cloud;
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| found(&points).network)
    };
    let one = with(1);
    for threads in [2, 8] {
        same(&one, &with(threads), &format!("{threads} threads"));
    }
}

#[test]
fn dyadic_translation_moves_every_coordinate_by_just_that() {
    let f = f64::from(1 << 20);
    let offsets = [[1024.0; 3], [0.5, -3.25, 0.0], [f, -f, 0.5]];
    for Base { name, points, found: first } in bases() {
        for offset in offsets {
            let add = |p: [f64; 3]| [0, 1, 2].map(|k| p[k] + offset[k]);
            let back = |p: [f64; 3]| [0, 1, 2].map(|k| p[k] - offset[k]);
            let moved: Vec<[f64; 3]> = points.iter().map(|&p| add(p)).collect();
            let network = found(&cloud(&moved)).network;
            same(&first.network, &mapped(network, 1.0, back), &format!("{name} moved by {offset:?}"));
        }
    }
}

#[test]
fn powers_of_two_scale_every_coordinate_by_just_that() {
    for Base { name, points, found: first } in bases() {
        for exponent in [-100, 3, 100] {
            let scale = 2.0_f64.powi(exponent);
            let scaled: Vec<[f64; 3]> = points.iter().map(|p| p.map(|x| x * scale)).collect();
            let network = found(&cloud(&scaled)).network;
            let expected = mapped(first.network.clone(), scale, |p| p.map(|x| x * scale));
            same(&expected, &network, &format!("{name} times 2^{exponent}"));
        }
    }
}

/// A network as the truth for another one.
fn as_truth(network: &Network) -> Truth {
    let nodes = network.nodes.iter();
    let nodes = nodes.map(|n| TruthNode { position: n.position, kind: n.kind, degree: n.degree });
    let curves = network.strips.iter().map(|s| TruthCurve {
        kind: s.kind,
        closed: s.closed,
        start: s.start,
        end: s.end,
        points: s.points.clone(),
        fold_deg: vec![90.0; s.points.len()],
        fold: Fold::Convex,
    });
    Truth { nodes: nodes.collect(), curves: curves.collect(), weak_below_deg: 0.0 }
}

#[test]
fn rotation_turns_the_lines() {
    let (c, s) = (0.8, 0.6);
    let turn = |[x, y, z]: [f64; 3]| {
        let [x, y] = [c * x - s * y, s * x + c * y];
        [x, c * y - s * z, s * y + c * z]
    };
    for Base { name, points, found: first } in bases() {
        let turned: Vec<[f64; 3]> = points.iter().map(|&p| turn(p)).collect();
        let network = found(&cloud(&turned)).network;
        let truth = as_truth(&mapped(first.network.clone(), 1.0, turn));
        let score = evaluate::against(&network, &truth, first.report.spacing);
        assert!(score.at_1h.f1 >= 0.98, "{name}: {score:?}");
    }
}

#[test]
fn points_given_twice_are_merged_and_change_nothing() {
    for Base { name, points, found: first } in bases() {
        let extra = points.len() / 3;
        let doubled = [&points[..], &points[..extra], &points[..1]].concat();
        let result = found(&cloud(&doubled));
        let counted = (result.report.merged, result.report.points);
        assert_eq!(counted, (extra + 1, first.report.points), "{name}");
        same(&first.network, &result.network, name);
    }
}

#[test]
fn rows_that_are_not_finite_are_dropped_and_change_nothing() {
    let bad = [[f64::NAN; 3], [0.0, f64::INFINITY, 1.0], [1.0, 2.0, f64::NEG_INFINITY]];
    for Base { name, points, found: first } in bases() {
        let mut mixed = Vec::new();
        let mut number = Vec::new();
        for (i, &p) in points.iter().enumerate() {
            if i % 100 == 0 {
                mixed.push(bad[i / 100 % 3]);
                number.push(u32::MAX);
            }
            mixed.push(p);
            number.push(i as u32);
        }
        let result = found(&cloud(&mixed));
        assert_eq!(result.report.dropped, mixed.len() - points.len(), "{name}");
        same(&first.network, &renumbered(result.network.clone(), |s| number[s as usize]), name);
        let kept = result.classes().into_iter().zip(&number).filter(|&(_, &n)| n != u32::MAX);
        assert_eq!(kept.map(|(class, _)| class).collect::<Vec<_>>(), first.classes(), "{name}");
    }
}
