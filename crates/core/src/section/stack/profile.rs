//! Closed contours in the coordinates of the slices, measured for comparison.

use super::super::nest;
use super::super::primitive::Round;
use super::super::result::Sections;
use super::super::vec2::{along, sub};

/// A closed contour as the stack compares it; lengths in world units.
#[derive(Clone, Debug)]
pub(super) struct Profile {
    /// Plane and index in its section.
    pub id: (usize, usize),
    /// Along the axis.
    pub height: f64,
    /// In the slice frame.
    pub points: Vec<[f64; 2]>,
    /// Whether it is a hole.
    pub hole: bool,
    /// Positive.
    pub area: f64,
    /// Signed as the contour runs: counter-clockwise for solid, clockwise for holes.
    pub signed_area: f64,
    /// Length.
    pub length: f64,
    /// Centroid of the area.
    pub centroid: [f64; 2],
    /// The circle it is, if it is one.
    pub round: Option<Round>,
}

/// The closed contours of each plane, planes ascending by height.
pub(super) fn levels(sections: &Sections, tolerance: f64) -> Vec<Vec<Profile>> {
    let mut order: Vec<usize> = (0..sections.sections.len()).collect();
    order.sort_by(|&a, &b| sections.heights[a].total_cmp(&sections.heights[b]).then(a.cmp(&b)));
    let level = |plane: usize| {
        let contours = sections.sections[plane].contours.iter().enumerate();
        contours.filter(|(_, c)| c.closed).map(|(i, _)| profile(sections, plane, i, tolerance)).collect()
    };
    order.into_iter().map(level).collect()
}

fn profile(sections: &Sections, plane: usize, index: usize, tolerance: f64) -> Profile {
    let contour = &sections.sections[plane].contours[index];
    let flat = |p: &[f64; 3]| {
        let [x, y, _] = sections.frame.coordinates(*p);
        [x, y]
    };
    let points: Vec<[f64; 2]> = contour.points.iter().map(flat).collect();
    let extent = nest::measure(&points, true);
    Profile {
        id: (plane, index),
        height: sections.heights[plane],
        hole: contour.depth % 2 == 1,
        area: extent.area.abs(),
        signed_area: extent.area,
        length: extent.length,
        centroid: extent.centroid,
        round: round(&points, tolerance),
        points,
    }
}

fn round(points: &[[f64; 2]], tolerance: f64) -> Option<Round> {
    let round = Round::fit(points)?;
    let offs: Vec<f64> = points.iter().map(|&p| round.off(p)).collect();
    let mean = offs.iter().sum::<f64>() / offs.len() as f64;
    let worst = offs.iter().copied().fold(0.0, f64::max);
    // Eight points are the least for which round and square differ.
    let enough = points.len() >= 8 && round.radius > 4.0 * mean;
    (enough && mean <= tolerance && worst <= 4.0 * tolerance).then_some(round)
}

impl Profile {
    /// Mean distance of the two outlines from each other, the second moved by `shift`, the larger of both ways.
    pub(super) fn apart(&self, other: &Profile, shift: [f64; 2]) -> f64 {
        let moved: Vec<[f64; 2]> = other.points.iter().map(|&p| along(p, shift, 1.0)).collect();
        let there = nest::apart(&self.points, &moved, true).0;
        there.max(nest::apart(&moved, &self.points, true).0)
    }

    /// The shift that lays another profile's centroid on this one's.
    pub(super) fn onto(&self, other: &Profile) -> [f64; 2] {
        sub(self.centroid, other.centroid)
    }
}
