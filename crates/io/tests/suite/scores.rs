//! Scores of lines against the truths of the evaluation data: the figures that its own scoring gives.

use crate::common::shared;
use lineament::evaluate::{LineKind, Score, Scoring, score};
use lineament_io::{ReadOptions, read, read_lines, read_marks};

/// What the scoring of the evaluation data says of a truth without every third line, the others moved by about a spacing.
struct Figures {
    item: &'static str,
    at_1h: [f64; 3],
    at_2h: [f64; 3],
    to_truth: [f64; 3],
    from_truth: [f64; 3],
    length: f64,
    curves_found: [usize; 2],
    /// Components, loops, junctions, ends, cycles and lines of either side.
    topology: [[usize; 6]; 2],
}

const FIGURES: [Figures; 2] = [
    Figures {
        item: "blunt_steps_20k_n10",
        at_1h: [0.9990939977349943, 0.7601351351351351, 0.8633854871900378],
        at_2h: [1.0, 0.7898648648648648, 0.8825972064930163],
        to_truth: [0.6985983447915061, 0.9898810676025693, 1.0295630140986975],
        from_truth: [3.199174354242223, 22.977014283467422, 29.18606015001614],
        length: 987.3102797413508,
        curves_found: [24, 37],
        topology: [[12, 0, 1, 25, 0, 26], [1, 0, 22, 0, 12, 37]],
    },
    Figures {
        item: "nist_ctc01_60k_n10",
        at_1h: [0.9075139392866626, 0.627165377929629, 0.7417332289869009],
        at_2h: [1.0, 0.7074267218126237, 0.8286466561348078],
        to_truth: [0.670866681352178, 1.0153445935203056, 1.029563014098705],
        from_truth: [3.9010162777245188, 14.928189135961478, 28.34521730737346],
        length: 2138.644967665062,
        curves_found: [45, 88],
        topology: [[52, 16, 0, 72, 16, 72], [27, 24, 40, 14, 43, 94]],
    },
];

#[test]
fn scores_are_those_of_the_evaluation_data() {
    for figures in FIGURES {
        let Some(item) = shared(&format!("cad/{}", figures.item)) else { continue };
        let truth = read_lines(&item.join("truth.json"), 30.0).unwrap();
        let spacing = truth.spacing.unwrap();
        let cloud = read(&item.join("cloud.ply"), &ReadOptions::default()).unwrap().cloud;
        let labels = read_marks(&item.join("labels.u8")).unwrap();
        let aside = cloud.positions.iter().zip(&labels).filter(|(_, label)| **label == 3.0);
        let ignored: Vec<[f64; 3]> = aside.map(|(p, _)| *p).collect();
        let mut found = truth.lines.clone();
        let mut number = 0..;
        found.lines.retain(|_| number.next().unwrap() % 3 != 0);
        let kept = (0..truth.lines.lines.len()).filter(|i| i % 3 != 0);
        for (i, line) in kept.zip(&mut found.lines) {
            line.kind = LineKind::Crease;
            let shift = [0.4, -0.3, 0.9 * (i % 2) as f64].map(|s| s * spacing);
            line.points.iter_mut().for_each(|p| *p = std::array::from_fn(|a| p[a] + shift[a]));
        }
        check(
            &figures,
            &score(&found, &truth.lines, &Scoring { ignored: &ignored, ..Scoring::new(spacing) }),
        );
        let itself = score(&truth.lines, &truth.lines, &Scoring::new(spacing));
        assert_eq!([itself.at_1h.f1, itself.wireframe.edges.f1], [1.0; 2], "{}", figures.item);
        assert_eq!([itself.to_truth.max, itself.from_truth.max, itself.chamfer.unwrap().hd], [0.0; 3]);
        assert!(itself.types.is_none_or(|t| t.right == 1.0), "{}: {:?}", figures.item, itself.types);
    }
}

fn check(figures: &Figures, found: &Score) {
    let near = |what: &str, a: [f64; 3], b: [f64; 3]| {
        let apart = (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-6, "{}, {what}: {a:?} where {b:?} was expected", figures.item);
    };
    let shares = |h: lineament::evaluate::Hits| [h.precision, h.recall, h.f1];
    let distances = |d: lineament::evaluate::Distances| [d.mean, d.p95, d.max];
    near("within one spacing", shares(found.at_1h), figures.at_1h);
    near("within two spacings", shares(found.at_2h), figures.at_2h);
    near("to the truth", distances(found.to_truth), figures.to_truth);
    near("from the truth", distances(found.from_truth), figures.from_truth);
    near("length", [found.length_spacings; 3], [figures.length; 3]);
    assert_eq!(found.curves_found, figures.curves_found, "{}", figures.item);
    assert_eq!(found.junctions_hit[0], found.junctions_hit[1], "{}", figures.item);
    let counts =
        found.topology.map(|t| [t.components, t.closed_loops, t.junctions, t.ends, t.cycles, t.lines]);
    assert_eq!(counts, figures.topology, "{}", figures.item);
}
