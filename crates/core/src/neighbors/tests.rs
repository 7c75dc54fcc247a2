use super::*;
use crate::math::vec3;
use riemannian::Scratch;

/// Numbers from 0 to 1, the same each time.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn point(&mut self) -> [f64; 3] {
        [self.next(), self.next(), self.next()]
    }

    fn cloud(seed: u64, n: usize, mut make: impl FnMut(&mut Random) -> [f64; 3]) -> Vec<[f64; 3]> {
        let mut random = Random(seed);
        (0..n).map(|_| make(&mut random)).collect()
    }
}

fn lattice(n: usize, step: f64) -> Vec<[f64; 3]> {
    let at = |i: usize| [i % n, i / n % n, i / n / n].map(|x| x as f64 * step);
    (0..n * n * n).map(at).collect()
}

fn plane(n: usize, step: f64) -> Vec<[f64; 3]> {
    (0..n * n).map(|i| [(i % n) as f64 * step, (i / n) as f64 * step, 0.3]).collect()
}

fn moved(mut points: Vec<[f64; 3]>, by: f64) -> Vec<[f64; 3]> {
    let mut random = Random(5);
    points.iter_mut().for_each(|p| *p = p.map(|x| x + by * random.next()));
    points
}

/// Clouds in which a search can go wrong, by name.
fn clouds() -> Vec<(&'static str, Vec<[f64; 3]>)> {
    let volume = Random::cloud(1, 700, Random::point);
    let surface = Random::cloud(2, 900, |r| [r.next() * 30.0, r.next() * 30.0, 0.0]);
    let line = Random::cloud(3, 400, |r| [r.next(); 3]);
    let clusters = Random::cloud(4, 800, |r| {
        let centre = (r.next() * 4.0).floor();
        r.point().map(|x| centre * 1e4 + x * 10_f64.powf(-3.0 * centre))
    });
    let repeated = Random::cloud(6, 600, |r| r.point().map(|x| (x * 4.0).floor()));
    let mut outlier = volume.clone();
    outlier.push([-1e6, 3e5, 1e6]);
    let far = volume.iter().map(|p| p.map(|x| x + 1e7)).collect();
    let tiny = volume.iter().map(|p| p.map(|x| x * 1e-140)).collect();
    vec![
        ("surface", surface),
        ("line", line),
        ("clusters", clusters),
        ("repeated", repeated),
        ("outlier", outlier),
        ("far", far),
        ("tiny", tiny),
        ("same", vec![[0.1; 3]; 100]),
        ("lattice of exact steps", lattice(9, 1.0)),
        ("lattice of rounded steps", lattice(9, 0.1)),
        ("plane of exact steps", plane(30, 1.0)),
        ("plane of rounded steps", plane(30, 0.1)),
        ("almost a lattice", moved(lattice(9, 1.0), 1e-13)),
        ("almost a plane lattice", moved(plane(30, 0.1), 1e-9)),
        ("volume", volume),
    ]
}

/// Everything by (distance, index) from a place, without `but`.
fn sorted(points: &[[f64; 3]], from: [f64; 3], but: Option<usize>) -> Vec<Found> {
    let others = (0..points.len()).filter(|&j| Some(j) != but);
    let mut all: Vec<Found> =
        others.map(|j| Found { distance2: vec3::distance2(points[j], from), index: j as u32 }).collect();
    all.sort_unstable_by(Found::order);
    all
}

fn brute(points: &[[f64; 3]], k: usize) -> Neighbors {
    let k = k.min(points.len().saturating_sub(1));
    let list = |i: usize| sorted(points, points[i], Some(i)).into_iter().take(k).map(|f| f.index).collect();
    let lists: Vec<Vec<u32>> = (0..points.len()).map(list).collect();
    Neighbors { offsets: (0..=points.len() as u64).map(|i| i * k as u64).collect(), indices: lists.concat() }
}

fn canonical(points: Vec<[f64; 3]>) -> Vec<[f64; 3]> {
    crate::Frame::localise(&points.into()).unwrap().positions
}

#[test]
fn lists_are_those_of_brute_force_by_all_instructions() {
    for (name, points) in clouds() {
        for points in [canonical(points.clone()), points] {
            let all = brute(&points, 40);
            for k in [1, 7, 8, 13, 16, 24, 40] {
                let expected = Neighbors {
                    offsets: (0..=points.len() as u64).map(|i| i * k.min(points.len() - 1) as u64).collect(),
                    indices: (0..points.len()).flat_map(|i| all.of(i).iter().copied().take(k)).collect(),
                };
                for instructions in [Instructions::Detected, Instructions::Narrow, Instructions::Baseline] {
                    let lists = all_nearest_with(&points, k, instructions);
                    assert!(lists == expected, "{name}, k {k}, {instructions:?}");
                }
            }
        }
    }
}

#[test]
fn few_points_have_all_others_as_neighbours() {
    for n in [0, 1, 2, 3, 15, 16, 17, 31, 33] {
        let points = Random::cloud(n, n as usize, Random::point);
        for k in [0, 1, 2, 16, 33] {
            assert_eq!(all_nearest(&points, k), brute(&points, k), "n {n} k {k}");
        }
    }
}

#[test]
fn blocks_bring_the_same_lists_in_order() {
    let points = Random::cloud(8, 3 * BLOCK + 5, Random::point);
    let lists = all_nearest(&points, 12);
    let blocks = nearest_blocks(&points, 12, |first, lists| (first, lists.to_vec()));
    assert_eq!(blocks.iter().map(|b| b.0).collect::<Vec<_>>(), [0, BLOCK, 2 * BLOCK, 3 * BLOCK]);
    assert_eq!(blocks.into_iter().flat_map(|b| b.1).collect::<Vec<_>>(), lists.indices);
}

#[test]
fn threads_do_not_matter() {
    let points = canonical(Random::cloud(9, 20_000, |r| [r.next(), r.next(), 0.0]));
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let lists = all_nearest(&points, 10);
            let graph = riemannian::graph(&points, &lists);
            (lists, graph)
        })
    };
    let one = run(1);
    assert!([2, 4, 8].into_iter().all(|threads| run(threads) == one));
}

#[test]
fn queries_anywhere_find_what_brute_force_finds() {
    for (name, points) in clouds() {
        let index = Index::build(&points);
        let mut random = Random(10);
        let mut out = Vec::new();
        for i in 0..60 {
            let on = points[(random.next() * points.len() as f64) as usize];
            let query = if i % 2 == 0 { on } else { vec3::add_scaled(on, random.point(), 0.7) };
            let all = sorted(&points, query, None);
            index.nearest(query, 9, &mut out);
            assert_eq!(out, all[..9], "{name}");
            let radius = all[20].distance2.sqrt();
            index.within(query, radius, &mut out);
            let inside = all.partition_point(|f| f.distance2 <= radius * radius);
            assert_eq!(out, all[..inside], "{name}");
            for most in [inside, inside + 5, inside / 2] {
                let whole = most >= inside;
                out.clear();
                assert_eq!(index.around_at_most(query, radius, most, |f| out.push(f)), whole, "{name}");
                out.sort_unstable_by(Found::order);
                assert_eq!(out.len(), most.min(inside), "{name}");
                assert!(!whole || out == all[..inside], "{name}");
            }
        }
    }
}

#[test]
fn an_empty_index_finds_nothing() {
    let index = Index::build(&[]);
    let mut out = vec![Found { distance2: 0.0, index: 0 }];
    index.nearest([0.0; 3], 3, &mut out);
    assert!(out.is_empty() && index.is_empty());
    index.within([0.0; 3], f64::INFINITY, &mut out);
    assert!(out.is_empty());
}

#[test]
fn coordinates_without_distance_do_no_harm() {
    let odd = [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, -1e300, 0.0, 1.0];
    let points = Random::cloud(11, 500, |r| r.point().map(|x| odd[(x * 7.0) as usize] * x));
    for instructions in [Instructions::Detected, Instructions::Narrow, Instructions::Baseline] {
        let lists = all_nearest_with(&points, 16, instructions);
        assert!(lists.len() == 500 && lists.indices.iter().all(|&j| j < 500));
    }
}

#[test]
fn graph_is_the_union_by_distance_symmetric_but_for_strays() {
    for (name, points) in clouds() {
        let lists = all_nearest(&points, 10);
        let graph = riemannian::graph(&points, &lists);
        for (i, &p) in points.iter().enumerate() {
            let last = lists.of(i)[lists.of(i).len() - 1];
            let reach = 64.0 * vec3::distance2(p, points[last as usize]);
            let listed =
                |j: usize| lists.of(j).contains(&(i as u32)) && vec3::distance2(p, points[j]) <= reach;
            let edge = |j: usize| lists.of(i).contains(&(j as u32)) || listed(j);
            let expected: Vec<u32> =
                sorted(&points, p, Some(i)).iter().map(|f| f.index).filter(|&j| edge(j as usize)).collect();
            assert_eq!(graph.of(i), expected, "{name} {i}");
        }
    }
}

#[test]
fn a_stray_point_is_listed_by_none() {
    let mut points = Random::cloud(13, 400, Random::point);
    points.push([1e5; 3]);
    let lists = all_nearest(&points, 10);
    let graph = riemannian::graph(&points, &lists);
    assert_eq!(graph.of(400), lists.of(400));
    assert!((0..400).all(|i| !graph.of(i).contains(&400)));
}

#[test]
fn graph_of_nothing_is_empty() {
    assert!(riemannian::graph(&[], &all_nearest(&[], 10)).is_empty());
    assert_eq!(riemannian::graph(&[[0.0; 3]], &all_nearest(&[[0.0; 3]], 10)).of(0), [0; 0]);
}

#[test]
fn hops_are_rings_of_the_graph_distance() {
    let points = Random::cloud(12, 800, |r| [r.next(), r.next(), 0.0]);
    let graph = riemannian::graph(&points, &all_nearest(&points, 6));
    let mut scratch = Scratch::default();
    for i in (0..points.len()).step_by(37) {
        let mut distance = vec![usize::MAX; points.len()];
        distance[i] = 0;
        for d in 0..5 {
            for j in (0..points.len()).filter(|&j| distance[j] == d).collect::<Vec<_>>() {
                graph.of(j).iter().for_each(|&l| distance[l as usize] = distance[l as usize].min(d + 1));
            }
        }
        for depth in 0..=5 {
            let found = graph.hops(i, depth, &mut scratch).to_vec();
            assert!(found.windows(2).all(|w| distance[w[0] as usize] <= distance[w[1] as usize]));
            let mut found: Vec<u32> = found;
            found.sort_unstable();
            let inside = |&j: &u32| (1..=depth).contains(&distance[j as usize]);
            assert_eq!(found, (0..points.len() as u32).filter(inside).collect::<Vec<_>>());
        }
    }
}
