use super::*;

/// Numbers from 0 to 1, the same each time.
fn random(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Random places on a 2^-20 lattice in the unit square, so that dyadic motions are exact.
fn surface(n: usize) -> Vec<[f64; 3]> {
    let mut next = random(3);
    let mut dyadic = || (next() * 1048576.0).floor() / 1048576.0;
    (0..n).map(|_| [dyadic(), dyadic(), 0.25]).collect()
}

fn localise(points: &[[f64; 3]]) -> Localised {
    Frame::localise(&Cloud::new(points.to_vec())).unwrap()
}

fn mapped(points: &[[f64; 3]], f: impl Fn(f64) -> f64) -> Vec<[f64; 3]> {
    points.iter().map(|p| p.map(&f)).collect()
}

/// Each canonical point lies where its source does, each input point has the canonical point of its place, and all
/// are distinct.
fn check(points: &[[f64; 3]], local: &Localised) {
    let exact = |a: [f64; 3], b: [f64; 3]| {
        let reach =
            (0..3).map(|a| b[a].abs().max(local.frame.offset[a].abs())).fold(f64::MIN_POSITIVE, f64::max);
        (0..3).all(|i| (a[i] - b[i]).abs() <= 4.0 * f64::EPSILON * reach)
    };
    let canonical = local.canonical();
    assert_eq!(canonical.len(), points.len());
    assert_eq!(local.source.len(), local.positions.len());
    assert_eq!(points.len(), local.positions.len() + local.dropped + local.merged());
    for (c, (&p, &s)) in local.positions.iter().zip(&local.source).enumerate() {
        assert!(exact(local.frame.to_world(p), points[s as usize]));
        assert_eq!(canonical[s as usize], c as u32);
    }
    for (i, &c) in canonical.iter().enumerate().filter(|(_, c)| **c != u32::MAX) {
        assert!(exact(local.frame.to_world(local.positions[c as usize]), points[i]));
        assert!(local.source[c as usize] as usize <= i);
    }
    let mut sorted = local.positions.clone();
    sorted.sort_by(|a, b| a.partial_cmp(b).unwrap());
    assert!(sorted.windows(2).all(|w| w[0] != w[1]));
}

#[test]
fn order_of_the_input_does_not_matter() {
    let mut points = surface(5000);
    let first = localise(&points);
    check(&points, &first);
    let mut next = random(1);
    for i in (1..points.len()).rev() {
        points.swap(i, (next() * (i + 1) as f64) as usize);
    }
    let second = localise(&points);
    check(&points, &second);
    assert_eq!((first.frame, &first.positions), (second.frame, &second.positions));
}

#[test]
fn dyadic_motions_leave_the_local_bits() {
    let points = surface(3000);
    let still = localise(&points);
    for offset in [1.0, -4096.0, 8388608.5, 12345678.0] {
        assert_eq!(localise(&mapped(&points, |x| x + offset)).positions, still.positions);
    }
    for exponent in [-900, -30, -1, 1, 30, 300] {
        let factor = 2_f64.powi(exponent);
        let scaled = localise(&mapped(&points, |x| x * factor));
        assert_eq!(scaled.positions, still.positions);
        assert_eq!(scaled.frame.scale, still.frame.scale * factor);
    }
}

#[test]
fn threads_do_not_matter() {
    let mut points = surface(60_000);
    points.extend_from_within(..500);
    points[77][1] = f64::NAN;
    let cloud = Cloud::new(points);
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| Frame::localise(&cloud).unwrap())
    };
    let one = run(1);
    check(&cloud.positions, &one);
    assert!([2, 4, 8].into_iter().all(|threads| run(threads) == one));
}

#[test]
fn non_finite_points_are_dropped_and_duplicates_merged() {
    let nan = [f64::NAN, 0.0, 0.0];
    let points = [
        nan,
        [1.0, 2.0, 0.0],
        [0.0; 3],
        [1.0, 2.0, -0.0],
        [1.0, f64::INFINITY, 0.0],
        [-0.0; 3],
        [1.0, 2.0, 0.0],
    ];
    let local = localise(&points);
    assert_eq!((local.dropped, local.merged(), local.positions.len()), (2, 3, 2));
    assert_eq!(local.source, [2, 1]);
    assert_eq!(local.canonical(), [u32::MAX, 1, 0, 1, u32::MAX, 0, 1]);
    assert!(local.positions.iter().flatten().all(|x| x.is_sign_positive()));
    assert!(local.frame.offset.iter().all(|x| x.is_sign_positive()));
}

#[test]
fn few_points_pass() {
    assert_eq!(localise(&[]).positions, [[0.0; 3]; 0]);
    let one = localise(&[[5.0, -7.0, 1e9]]);
    assert_eq!((one.positions.as_slice(), one.frame.scale), ([[0.0; 3]].as_slice(), 1.0));
    assert_eq!(one.frame.to_world([0.0; 3]), [5.0, -7.0, 1e9]);
    assert_eq!(localise(&[[3.0; 3]; 40]).merged(), 39);
    let two = localise(&[[0.0; 3], [1.0; 3]]);
    assert_eq!(two.positions.len(), 2);
    let nowhere = localise(&[[f64::NAN; 3]; 4]);
    assert_eq!((nowhere.dropped, nowhere.positions.len()), (4, 0));
}

#[test]
fn scale_is_near_the_spacing_of_a_grid() {
    for (nx, ny, nz) in [(4000, 1, 1), (200, 150, 1), (1000, 6, 1), (30, 25, 20)] {
        for step in [1e-9, 0.013, 1.0, 777.0, 1e9] {
            let at = |i: usize| [i % nx, i / nx % ny, i / nx / ny].map(|x| x as f64 * step);
            let points: Vec<[f64; 3]> = (0..nx * ny * nz).map(at).collect();
            let ratio = localise(&points).frame.scale / step;
            assert!((0.4..=2.5).contains(&ratio), "{nx} {ny} {nz} {step} {ratio}");
        }
    }
}

#[test]
fn an_outlier_leaves_scale_and_order_of_the_others() {
    let points = surface(3000);
    let alone = localise(&points);
    // The last ones are numbers that stand for no value, beyond what a single code tells apart.
    for far in [3e6, 1e19, 1e30, 3.4e38, 1e140] {
        let mut points = points.clone();
        points.push([far, far / 2.0, far / 3.0]);
        let with = localise(&points);
        check(&points, &with);
        let ratio = with.frame.scale / alone.frame.scale;
        assert!((0.4..=2.5).contains(&ratio), "{ratio}");
        let step = |l: &Localised| {
            let length = |w: &[[f64; 3]]| crate::math::vec3::distance(w[0], w[1]).min(100.0);
            l.positions.windows(2).map(length).sum::<f64>() * l.frame.scale
        };
        assert!(step(&with) < 3.0 * step(&alone), "{} {}", step(&with), step(&alone));
    }
}

/// On all axes or on one, above or below, one point or two fifths of them.
#[test]
fn numbers_that_stand_for_no_value_leave_the_others_where_they_are() {
    let points = surface(3000);
    let alone = localise(&points);
    for none in [-3.4e38, -f64::MAX, 1e300, -1e20] {
        for far in [[none; 3], [0.5, 0.5, none], [none, 0.25, 0.5]] {
            for count in [1, 2000] {
                let points = [vec![far; count], points.clone()].concat();
                let with = localise(&points);
                check(&points, &with);
                assert_eq!((with.frame, &with.positions), (alone.frame, &alone.positions), "{far:?}");
                assert_eq!((with.dropped, with.beyond), (count, count));
            }
        }
    }
    // Far, but not so far that f64 could not hold both.
    let far = localise(&[vec![[-1e9, 0.5, 0.5]], points].concat());
    assert_eq!((far.dropped, far.beyond), (0, 0));
}

#[test]
fn extreme_sizes_pass_or_are_refused() {
    let points = surface(500);
    for factor in [1e-320, 1e-310, 1e-300, 1e-9, 1e9, 1e140] {
        let scaled = mapped(&points, |x| x * factor);
        let local = localise(&scaled);
        check(&scaled, &local);
        assert!(local.positions.iter().flatten().all(|x| x.is_finite()));
    }
    let flat = mapped(&points, |x| x + 1e7);
    check(&flat, &localise(&flat));
    let wide = Frame::localise(&Cloud::new(vec![[0.0, -1e300, 0.0], [0.0, 1e300, 0.0]]));
    assert_eq!(wide, Err(Error::Extent { axis: 1, min: -1e300, max: 1e300 }));
    let infinite = Frame::localise(&Cloud::new(vec![[f64::MIN, 0.0, 0.0], [f64::MAX, 0.0, 0.0]]));
    assert!(matches!(infinite, Err(Error::Extent { axis: 0, .. })));
}
