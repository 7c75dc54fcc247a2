//! Whole scenes as stations survey them: occlusion, density that falls with the range, mixed returns, leaves and strays.
//!
//! Lines are compared with the scenes' edges as far as points lie there, at 1.5 spacings of the place. The plant was not looked at
//! while the method's values were chosen.

use crate::common;
use lineament::neighbors::{Found, Index, all_nearest};
use lineament::shapes::{Shape, Survey, Surveyed, farmyard, plant, room};
use lineament::surface::spacings;
use lineament::{Cloud, Frame, StripKind};

/// Distance at which a line lies on an edge, spacings of the place.
const NEAR: f64 = 1.5;
/// Distance between the places at which lines and edges are compared, metres.
const STEP: f64 = 0.02;

/// How well the lines of a survey agree with the edges of its scene.
#[derive(Debug)]
struct Score {
    /// Share of the creases' length on an edge.
    precision: f64,
    /// Share of the edges' length, where points are, that a line of any kind meets.
    recall: f64,
    /// Share of the clutter that was told, and of the surface that was taken for clutter.
    told: f64,
    lost: f64,
    strips: usize,
}

impl Score {
    fn f1(&self) -> f64 {
        2.0 * self.precision * self.recall / (self.precision + self.recall)
    }
}

/// The spacing of a cloud at any place.
struct Ground {
    frame: Frame,
    index: Index,
    spacing: Vec<f32>,
}

impl Ground {
    fn new(cloud: &Cloud) -> Ground {
        let local = Frame::localise(cloud).unwrap();
        let spacing = spacings(&local.positions, &all_nearest(&local.positions, 12));
        Ground { frame: local.frame, index: Index::build(&local.positions), spacing }
    }

    /// The spacing at a place and the distance to the nearest point.
    fn at(&self, place: [f64; 3]) -> [f64; 2] {
        let mut found: Vec<Found> = Vec::new();
        self.index.nearest(self.frame.to_local(place), 8, &mut found);
        let mut near: Vec<f32> = found.iter().map(|f| self.spacing[f.index as usize]).collect();
        near.sort_by(f32::total_cmp);
        [f64::from(near[near.len() / 2]), found[0].distance2.sqrt()].map(|d| self.frame.length_to_world(d))
    }
}

/// Places along a polyline.
fn places(points: &[[f64; 3]], closed: bool) -> Vec<[f64; 3]> {
    let next = points.iter().cycle().skip(1).take(points.len() - usize::from(!closed));
    let pieces = points.iter().zip(next).flat_map(|(a, b)| {
        let length = (0..3).map(|k| (b[k] - a[k]).powi(2)).sum::<f64>().sqrt();
        let count = (length / STEP).ceil().max(1.0);
        (0..count as usize).map(move |i| [0, 1, 2].map(|k| a[k] + (b[k] - a[k]) * i as f64 / count))
    });
    pieces.collect()
}

/// The share of places, of those that count, that pass; each counts once.
fn share(places: impl Iterator<Item = bool>) -> f64 {
    let (passed, all) = places.fold((0, 0), |(p, n), x| (p + usize::from(x), n + 1));
    f64::from(u32::try_from(passed).unwrap()) / f64::from(u32::try_from(all.max(1)).unwrap())
}

fn score(scene: &Shape, surveyed: &Surveyed) -> Score {
    let cloud = Cloud::new(surveyed.points.clone());
    let found = common::found(&cloud);
    let ground = Ground::new(&cloud);
    let edges = scene.network.index(STEP);
    let creases = found.network.strips.iter().filter(|s| s.kind == StripKind::Crease);
    let on_edge = creases
        .flat_map(|s| places(&s.points, s.closed))
        .map(|p| edges.distance(p) <= NEAR * ground.at(p)[0]);
    let lines: Vec<[f64; 3]> =
        found.network.strips.iter().flat_map(|s| places(&s.points, s.closed)).collect();
    let lines_cloud = Cloud::new(lines);
    let drawn = Frame::localise(&lines_cloud).unwrap();
    let nearest = Index::build(&drawn.positions);
    let met = |p: [f64; 3], reach: f64| {
        let mut near: Vec<Found> = Vec::new();
        nearest.nearest(drawn.frame.to_local(p), 1, &mut near);
        drawn.frame.length_to_world(near[0].distance2.sqrt()) <= reach
    };
    let seen = scene.network.curves.iter().filter(|c| c.kind == StripKind::Crease);
    let seen = seen
        .flat_map(|c| places(&c.points, c.closed))
        .map(|p| (p, ground.at(p)))
        .filter(|(_, [spacing, distance])| distance <= spacing);
    let mut told = vec![false; surveyed.points.len()];
    found.clutter.iter().for_each(|&i| told[i as usize] = true);
    let of =
        |clutter: bool| share(surveyed.clutter.iter().zip(&told).filter(|x| *x.0 == clutter).map(|x| *x.1));
    Score {
        precision: share(on_edge),
        recall: share(seen.map(|(p, [spacing, _])| met(p, NEAR * spacing))),
        told: of(true),
        lost: of(false),
        strips: found.network.strips.len(),
    }
}

#[test]
fn a_room_with_mixed_returns() {
    let survey = Survey {
        stations: &[[1.4, 0.9, 1.5], [5.2, 2.6, 1.6], [2.2, 3.8, 1.4]],
        step_deg: 1.0,
        elevation_deg: [-65.0, 75.0],
        noise: 0.002,
        reach: 30.0,
        mixed: 0.6,
        crowns: &[],
        strays: 0.002,
    };
    let scene = room();
    let score = score(&scene, &scene.survey(&survey, 3));
    assert!(score.f1() > 0.95 && score.lost < 0.001 && score.told > 0.9 && score.strips < 90, "{score:?}");
}

#[test]
fn a_farmyard_among_trees() {
    let survey = Survey {
        stations: &[[-9.0, -9.0, 1.8], [9.0, 8.0, 1.8], [8.5, -8.0, 9.0], [-9.0, 8.0, 9.0]],
        step_deg: 0.8,
        elevation_deg: [-60.0, 30.0],
        noise: 0.006,
        reach: 22.0,
        mixed: 0.5,
        crowns: &[([-8.0, 1.0, 3.5], 1.8, 1.2), ([2.0, 6.5, 3.0], 1.5, 1.0), ([7.0, -5.0, 2.6], 1.2, 0.8)],
        strays: 0.003,
    };
    let scene = farmyard();
    let score = score(&scene, &scene.survey(&survey, 5));
    assert!(score.f1() > 0.95 && score.lost < 0.001 && score.told > 0.75 && score.strips < 70, "{score:?}");
}

#[test]
fn a_plant_on_an_open_floor() {
    let survey = Survey {
        stations: &[[0.2, -4.5, 1.7], [-0.2, 4.6, 1.6], [5.0, -1.0, 4.0], [-5.2, -1.0, 1.9]],
        step_deg: 0.8,
        elevation_deg: [-60.0, 45.0],
        noise: 0.003,
        reach: 12.0,
        mixed: 0.5,
        crowns: &[],
        strays: 0.003,
    };
    let scene = plant();
    let score = score(&scene, &scene.survey(&survey, 8));
    assert!(score.f1() > 0.9 && score.lost < 0.005 && score.told > 0.9 && score.strips < 90, "{score:?}");
}
