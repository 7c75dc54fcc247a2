//! What a stage says that it reads: where a part of a cloud says that a value is known, it is that of the whole cloud.

use super::{penalty, plan, stairs};
use crate::frame::Frame;
use crate::method;
use crate::neighbors::Neighbors;
use crate::prepare::Prepared;
use crate::reach::Known;
use crate::resolution::Resolution;
use crate::shapes::Rng;
use crate::surface::reach::{LocalKnown, Whole, of_spacings};
use crate::surface::{Local, evened, spacings};
use crate::tile::guests::Guests;
use crate::tile::part::Part;
use crate::tile::set::Set;

/// The middle tile of a cloud with some margin, and the whole cloud.
fn part_and_whole(points: &[[f64; 3]], margin: f64) -> [Set; 2] {
    let plan = plan(points, 2500, 0.5);
    let frame = Frame::of_points(points).unwrap().frame;
    let middle = &plan.tiles()[plan.tiles().len() / 2];
    let sets = [margin, 1e9].map(|m| {
        Set::all(&Part::gather(&plan, middle, frame, (m, &Guests::default()), &points).unwrap(), 12)
    });
    assert!(sets[0].positions.len() < sets[1].positions.len() * 3 / 4);
    sets
}

/// Compares what is `of` each point where it is known; the number of points where it is not known and differs.
fn agree<T: PartialEq>(sets: &[Set; 2], known: &Known, of: impl Fn(usize, usize) -> T) -> usize {
    let [part, whole] = sets;
    let place = |i: usize| whole.source.iter().position(|s| *s == part.source[i]).unwrap();
    let (mut sure, mut differ) = (0, 0);
    for i in 0..part.source.len() {
        let same = of(0, i) == of(1, place(i));
        assert!(same || !known.0[i], "point {} of {}", i, part.source.len());
        sure += usize::from(known.0[i]);
        differ += usize::from(!same);
    }
    assert!(sure > part.source.len() / 5, "{sure} of {}", part.source.len());
    differ
}

fn named(set: &Set, list: &[u32]) -> Vec<u32> {
    list.iter().map(|&j| set.source[j as usize]).collect()
}

#[test]
fn lists_and_rows_are_known_where_nothing_nearer_is_missing() {
    let sets = part_and_whole(&stairs(14, 0.6), 26.0);
    let list = |s: usize, i: usize| named(&sets[s], sets[s].nearest.of(i));
    assert!(agree(&sets, &sets[0].lists, list) > 0);
    let [(part, rows), (whole, all)] = [0, 1].map(|s| sets[s].graph());
    let row = |s: usize, i: usize| named(&sets[s], [&part, &whole][s].of(i));
    assert!(agree(&sets, &rows, row) > 0);
    assert!(all.0.iter().all(|known| *known));
}

#[test]
fn spacings_crowds_and_kept_points_are_known_where_what_they_read_is() {
    let mut points = stairs(14, 0.6);
    let mut rng = Rng::new(4);
    let mut leaf = |at: f64, r: f64| at + r * (rng.uniform() + rng.uniform() - 1.0);
    points.extend((0..1500).map(|_| [leaf(220.0, 100.0), leaf(8.0, 8.0), leaf(16.0, 12.0)]));
    let sets = part_and_whole(&points, 50.0);
    let mean = Resolution { spacing: 1.1, noise: 0.05 };
    let local = [0, 1].map(|s| Local::new(&sets[s].positions, &sets[s].nearest, mean));
    let ground = sets[0].ground();
    let known = LocalKnown::new(&ground, &sets[0].nearest, &sets[0].lists, &local[0]);
    let spacing = [0, 1].map(|s| spacings(&sets[s].positions, &sets[s].nearest));
    let of = of_spacings(&sets[0].nearest, &sets[0].lists);
    assert!(agree(&sets, &of, |s, i| spacing[s][i].to_bits()) > 0);
    assert!(agree(&sets, &known.apart, |s, i| local[s].apart[i].to_bits()) == 0);
    let marks = |s: usize, i: usize| {
        let (links, touches) =
            crate::surface::links(&sets[s].positions, &sets[s].nearest, &local[s].marks, i);
        (local[s].marks.crowd[i], local[s].marks.deep[i], named(&sets[s], &links), touches)
    };
    assert!(agree(&sets, &known.crowd, marks) > 0);
    // Crowds are judged elsewhere; here all of them are clutter.
    let judged = [0, 1].map(|s| local[s].judged(&sets[s].positions, &sets[s].nearest, &local[s].marks.crowd));
    let whole = Whole { widest: 0.0, far: Vec::new(), long: f64::INFINITY };
    let kept = known.kept(&ground, &sets[0].nearest, &local[0], &judged[0], &whole);
    agree(&sets, &kept, |s, i| judged[s].clutter[i]);
}

/// The measure of each point and its candidates, to the bit.
fn measured(set: &Set, graph: Neighbors) -> (Prepared, Vec<String>) {
    let resolution = Resolution { spacing: 1.1, noise: 0.05 };
    let spacing = evened(&spacings(&set.positions, &set.nearest), resolution);
    let points = (set.positions.clone(), set.source.clone());
    let frame = Frame { offset: [0.0; 3], scale: 1.0 };
    let cloud = Prepared::of_part(frame, points, graph, (resolution, spacing), set.source.len());
    let measure = method::detect(&cloud, &penalty());
    let candidate =
        |p: &crate::Penalties, i: usize| p.points.binary_search(&(i as u32)).map(|c| p.row(c)).ok();
    let of = |i: usize| {
        let m = &measure;
        format!(
            "{} {} {:?} {:?} {:?}",
            m.density[i],
            m.score[i],
            m.normal[i],
            candidate(&m.crease, i),
            candidate(&m.border, i)
        )
    };
    let values = (0..set.source.len()).map(of).collect();
    (cloud, values)
}

#[test]
fn the_measure_is_known_where_all_is_within_the_steps_that_the_detector_says() {
    let sets = part_and_whole(&stairs(14, 0.6), 44.0);
    let graphs = [0, 1].map(|s| sets[s].graph());
    let known = graphs[0].1.and(&of_spacings(&sets[0].nearest, &sets[0].lists));
    let row = |s: usize, i: usize| named(&sets[s], graphs[s].0.of(i));
    let place = |i: usize| sets[1].source.iter().position(|s| *s == sets[0].source[i]).unwrap();
    // What is known is far less than what happens to be right.
    let right = Known::of(sets[0].source.len(), |i| known.0[i] || row(0, i) == row(1, place(i)));
    let [(cloud, own), (_, all)] = [0, 1].map(|s| measured(&sets[s], graphs[s].0.clone()));
    let values = |s: usize, i: usize| [&own, &all][s][i].clone();
    let steps = method::steps(&cloud, &penalty());
    assert!(steps == 8 && agree(&sets, &known.steps(&cloud.graph, steps - 1), values) > 0);
    let wrong = |steps: usize| {
        let near = right.clone().steps(&cloud.graph, steps);
        (0..own.len()).filter(|&i| near.0[i] && own[i] != all[place(i)]).count()
    };
    // Fewer steps would not do, and as many as the detector says do even at the rim.
    assert_eq!((wrong(0) > 0, wrong(2) > 0, wrong(steps - 1)), (true, true, 0), "{:?}", [wrong(0), wrong(2)]);
}
