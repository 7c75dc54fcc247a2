//! Lines of any source against each other: types, graphs, published measures, stretches, marks.

use crate::check::perfect::perfect;
use crate::evaluate::*;
use crate::shapes;

fn line(points: &[[f64; 3]]) -> Line {
    Line { kind: LineKind::Crease, closed: false, points: points.to_vec() }
}

fn square(side: f64) -> Lines {
    let corners = [[0.0, 0.0, 0.0], [side, 0.0, 0.0], [side, side, 0.0], [0.0, side, 0.0]];
    let lines = (0..4).map(|i| line(&[corners[i], corners[(i + 1) % 4]])).collect();
    Lines { lines, ..Lines::default() }
}

#[test]
fn a_truth_against_itself_has_no_error_in_any_figure() {
    for shape in [shapes::bracket(), shapes::brick(), shapes::sheet_with_hole()] {
        let lines = Lines::from(&perfect(&shape.network));
        let found = score(&lines, &lines, &Scoring { tolerances: &[1e-9], ..Scoring::new(0.05) });
        assert_eq!(found.at[0].1.f1, 1.0, "{}", shape.name);
        assert_eq!([found.to_truth.max, found.from_truth.max], [0.0; 2]);
        assert_eq!(found.types.unwrap().right, 1.0);
        assert_eq!(found.chamfer, Some(Chamfer { cd: 0.0, hd: 0.0, hausdorff: 0.0 }));
        let Wireframe { corners, edges, offset } = found.wireframe;
        assert_eq!([corners.f1, edges.f1, offset], [1.0, 1.0, 0.0]);
        assert_eq!(found.topology[0], found.topology[1]);
        assert_eq!(found.junctions_hit[0], found.junctions_hit[1]);
        let all = stretches(&lines, &lines, &Scoring::new(0.05), 1e-9);
        assert!(all.iter().all(|s| s.verdict == Verdict::Right));
    }
}

#[test]
fn the_graph_of_lines_has_their_nodes_loops_and_cycles() {
    let mut lines = square(1.0);
    lines.lines.push(line(&[[1.0, 1.0, 0.0], [2.0, 2.0, 0.0]]));
    let ring = vec![[5.0, 0.0, 0.0], [6.0, 0.0, 0.0], [5.0, 1.0, 0.0]];
    lines.lines.push(Line { closed: true, ..line(&ring) });
    let found = score(&lines, &lines, &Scoring::new(0.1)).topology[0];
    let expected = Topology { lines: 6, components: 2, closed_loops: 1, junctions: 1, ends: 1, cycles: 2 };
    assert_eq!(found, expected);
}

#[test]
fn types_count_by_the_length_that_was_met() {
    let straight =
        |x: f64, kind| TypedCurve { kind, radius: None, points: vec![[x, 0.0, 0.0], [x + 3.0, 0.0, 0.0]] };
    let known = Lines {
        curves: vec![
            straight(0.0, CurveKind::Line),
            straight(10.0, CurveKind::Line),
            straight(20.0, CurveKind::Line),
        ],
        ..Lines::default()
    };
    let found = Lines {
        curves: vec![straight(0.0, CurveKind::Line), straight(10.0, CurveKind::Spline)],
        ..Lines::default()
    };
    let types = Types::of(&found, &known, 0.1).unwrap();
    assert_eq!(types.right, 0.5);
    assert_eq!([types.lengths[0][0], types.lengths[0][3]], [121, 121]);
    assert!(types.radius_error.is_nan());
}

#[test]
fn where_curves_meet_the_one_of_the_right_type_is_met() {
    let curve = |kind, from: f64| {
        let points = vec![[from, 0.0, 0.0], [from + 1.0, 0.0, 0.0]];
        TypedCurve { kind, radius: None, points }
    };
    let lines = Lines {
        curves: vec![curve(CurveKind::Spline, 0.0), curve(CurveKind::Line, 1.0)],
        ..Lines::default()
    };
    assert_eq!(Types::of(&lines, &lines, 0.1).unwrap().right, 1.0);
}

#[test]
fn radii_are_judged_on_circles_of_the_right_type() {
    let arc = |radius: f64| {
        let at = |i: u32| [f64::from(i) * 0.1, 0.0, 0.0];
        TypedCurve { kind: CurveKind::Circle, radius: Some(radius), points: (0..11).map(at).collect() }
    };
    let [found, known] = [2.02, 2.0].map(|r| Lines { curves: vec![arc(r)], ..Lines::default() });
    assert!((Types::of(&found, &known, 0.1).unwrap().radius_error - 0.01).abs() < 1e-12);
}

#[test]
fn chamfer_and_hausdorff_are_those_of_the_box_of_two() {
    // The square is moved by a tenth of its side along its normal: 0.2 where the box has a side of 2.
    let known = square(4.0);
    let mut found = square(4.0);
    found.lines.iter_mut().flat_map(|l| &mut l.points).for_each(|p| p[2] += 0.4);
    let Chamfer { cd, hd, hausdorff } = Chamfer::of(&found, &known).unwrap();
    assert!((cd - 2.0 * 0.04).abs() < 1e-12 && (hd - 0.2).abs() < 1e-12 && (hausdorff - 0.2).abs() < 1e-12);
    // One side missing: its middle is 1 away, where the other direction finds all.
    let part = Lines { lines: known.lines[..3].to_vec(), ..Lines::default() };
    let missing = Chamfer::of(&part, &known).unwrap();
    assert!((missing.hausdorff - 1.0).abs() < 1e-9 && (missing.hd - 0.5).abs() < 1e-9);
    assert_eq!(Chamfer::of(&Lines::default(), &known), None);
    // Samples as far apart as a speck asks for would be more than memory holds.
    assert_eq!(Chamfer::of(&known, &square(1e-12)), None);
}

#[test]
fn corners_are_paired_one_to_one_and_edges_need_both() {
    let known = square(1.0);
    let mut found = square(1.0);
    // A second corner beside one of the four makes one corner and one edge too many.
    found.lines.push(line(&[[0.0, 0.06, 0.0], [1.0, 1.0, 0.0]]));
    let Wireframe { corners, edges, offset } = score(&found, &known, &Scoring::new(0.05)).wireframe;
    assert_eq!([corners.precision, corners.recall], [4.0 / 5.0, 1.0]);
    assert_eq!([edges.precision, edges.recall, offset], [4.0 / 5.0, 1.0, 0.0]);
    // Two found at one tolerance from both of two known: all are paired, though each is nearest to the same.
    let pair = |a: f64, b: f64| Lines {
        lines: vec![line(&[[a, 0.0, 0.0], [0.0, 9.0, 0.0]]), line(&[[b, 0.0, 0.0], [0.0, -9.0, 0.0]])],
        ..Lines::default()
    };
    let both = score(&pair(0.0, 0.9), &pair(0.8, 1.6), &Scoring::new(0.5)).wireframe;
    assert_eq!(both.corners.f1, 1.0);
}

#[test]
fn what_is_missed_and_what_is_false_are_stretches_of_their_length() {
    let known = Lines { lines: vec![line(&[[0.0; 3], [10.0, 0.0, 0.0]])], ..Lines::default() };
    let found = Lines {
        lines: vec![line(&[[0.0; 3], [6.0, 0.0, 0.0]]), line(&[[0.0, 5.0, 0.0], [2.0, 5.0, 0.0]])],
        ..Lines::default()
    };
    let all = stretches(&found, &known, &Scoring::new(0.1), 1.0);
    let lengths: Vec<(Verdict, usize, f64)> = all.iter().map(|s| (s.verdict, s.line, s.length)).collect();
    assert_eq!(lengths.len(), 3);
    let near = |i: usize, verdict, line, length: f64| {
        assert!(lengths[i].0 == verdict && lengths[i].1 == line, "{lengths:?}");
        assert!((lengths[i].2 - length).abs() < 0.05, "{lengths:?}");
    };
    near(0, Verdict::Right, 0, 6.0);
    near(1, Verdict::False, 1, 2.0);
    near(2, Verdict::Missed, 0, 3.9);
}

#[test]
fn what_lies_beside_points_that_are_left_out_counts_neither_way() {
    let known = square(1.0);
    let mut found = square(1.0);
    found.lines.push(line(&[[0.5, 0.5, 0.0], [0.5, 0.5, 0.2]]));
    let plain = score(&found, &known, &Scoring::new(0.05)).at_1h.precision;
    let ignored: Vec<[f64; 3]> = (0..=20).map(|i| [0.5, 0.5, f64::from(i) * 0.01]).collect();
    let scoring = Scoring { ignored: &ignored, ..Scoring::new(0.05) };
    assert!(plain < 1.0);
    assert_eq!(score(&found, &known, &scoring).at_1h.precision, 1.0);
}

#[test]
fn rounded_edges_count_with_their_radius() {
    let edge = |radius: f64| {
        let points = vec![[0.0; 3], [3.0, 0.0, 0.0]];
        Lines {
            rounded: vec![RoundedEdge { radius, turn_deg: 90.0, closed: false, points }],
            ..Lines::default()
        }
    };
    let at = |radius| Rounded::of(&edge(radius), &edge(0.3), 0.1).unwrap();
    assert_eq!(at(0.32), Rounded { precision: 1.0, recall: 1.0 });
    assert_eq!(at(0.5), Rounded { precision: 0.0, recall: 0.0 });
    assert!(Rounded::of(&edge(0.3), &Lines::default(), 0.1).is_none());
}

#[test]
fn marks_are_judged_in_each_reading_of_the_labels() {
    let labels = [1, 1, 2, 2, 3, 0, 0, 0];
    let found = marks(&[true, false, true, false, true, true, false, false], &labels);
    // 1 against 0 and 2, without 3.
    let MarkScore { precision, recall, accuracy, mcc, .. } = found[0];
    assert_eq!([precision, recall, accuracy], [1.0 / 3.0, 0.5, 4.0 / 7.0]);
    assert!((mcc - (1.0 * 3.0 - 2.0 * 1.0) / (3.0f64 * 2.0 * 5.0 * 4.0).sqrt()).abs() < 1e-12);
    assert_eq!([found[1].precision, found[2].precision, found[3].precision], [2.0 / 3.0, 0.5, 0.25]);
    assert_eq!(marks(&[false; 8], &labels)[0].mcc, 0.0);
    assert_eq!(marks(&labels.map(|l| l == 1), &labels)[0].mcc, 1.0);
}

#[test]
fn a_line_counts_by_its_length_however_densely_it_is_written() {
    let known = Lines { lines: vec![line(&[[0.0; 3], [10.0, 0.0, 0.0]])], ..Lines::default() };
    let row = |count: u32, length: f64, y: f64| {
        let at = |i: u32| [length * f64::from(i) / f64::from(count), y, 0.0];
        line(&(0..=count).map(at).collect::<Vec<_>>())
    };
    for (right, wrong) in [(1, 1), (1, 1000), (4000, 1), (4000, 1000)] {
        let lines = vec![row(right, 10.0, 0.0), row(wrong, 1.0, 5.0)];
        let found = Lines { lines, ..Lines::default() };
        let score = score(&found, &known, &Scoring::new(0.1));
        assert!((score.at_1h.precision - 10.0 / 11.0).abs() < 0.002, "{right} {wrong} {score:?}");
        assert!((score.length_spacings - 110.0).abs() < 1e-6);
        // The same the other way round: the line of one is missed.
        let back = recall_of(&known, &found);
        assert!((back - 10.0 / 11.0).abs() < 0.002, "{right} {wrong} {back}");
    }
}

fn recall_of(found: &Lines, known: &Lines) -> f64 {
    score(found, known, &Scoring::new(0.1)).at_1h.recall
}
