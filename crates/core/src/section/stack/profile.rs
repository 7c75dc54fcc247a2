//! Closed contours in the coordinates of the slices, measured for comparison.

use crate::curve::circle::Circle;
use crate::curve::polygon;
use crate::curve::polyline::Polyline;
use crate::math::vec2::{along, sub};
use crate::parallel;
use crate::section::result::Sections;

/// Most points of a contour that comparisons look at, about evenly along it.
const POINTS: usize = 512;
/// Neighbouring points of a comparison that make a stretch: one alone may be a rounded corner.
const STRETCH: usize = 4;
/// A stretch this far off, in tolerances, is a change of the outline, however small its share.
const CHANGED: f64 = 5.0;

/// A closed contour as the stack compares it; lengths in world units.
#[derive(Clone, Debug)]
pub(super) struct Profile {
    /// Plane and index in its section.
    pub id: (usize, usize),
    /// Along the axis.
    pub height: f64,
    /// In the slice frame.
    pub outline: Polyline,
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
    pub round: Option<Circle>,
    /// Median angle between the wall and the axis, degrees.
    pub draft_deg: f64,
    /// The angle that nine tenths of the wall stay under.
    pub steepest_deg: f64,
}

/// The distance between two outlines.
#[derive(Clone, Copy, Debug)]
pub(super) struct Apart {
    /// Mean distance, the larger of both ways.
    pub mean: f64,
    /// A distance that some stretch of an outline keeps throughout.
    pub stretch: f64,
}

/// The planes ascending by height.
pub(super) fn order(sections: &Sections) -> Vec<usize> {
    let mut order: Vec<usize> = (0..sections.sections.len()).collect();
    order.sort_by(|&a, &b| sections.heights[a].total_cmp(&sections.heights[b]).then(a.cmp(&b)));
    order
}

/// The closed contours of each plane.
pub(super) fn levels(sections: &Sections, order: &[usize], tolerance: f64) -> Vec<Vec<Profile>> {
    parallel::map(order.len(), parallel::TASK, |k| {
        let plane = order[k];
        let contours = sections.sections[plane].contours.iter().enumerate();
        contours.filter(|(_, c)| c.closed).map(|(i, _)| profile(sections, plane, i, tolerance)).collect()
    })
}

fn profile(sections: &Sections, plane: usize, index: usize, tolerance: f64) -> Profile {
    let contour = &sections.sections[plane].contours[index];
    let flat = |p: &[f64; 3]| {
        let [x, y, _] = sections.frame.coordinates(*p);
        [x, y]
    };
    let points: Vec<[f64; 2]> = contour.points.iter().map(flat).collect();
    let extent = polygon::measure(&points, true);
    Profile {
        id: (plane, index),
        height: sections.heights[plane],
        hole: contour.depth % 2 == 1,
        area: extent.area.abs(),
        signed_area: extent.area,
        length: extent.length,
        centroid: extent.centroid,
        round: round(&points, tolerance),
        draft_deg: contour.draft_deg.unwrap_or(0.0),
        steepest_deg: contour.steepest_deg,
        outline: Polyline::new(&points, true, sections.spacing),
    }
}

fn round(points: &[[f64; 2]], tolerance: f64) -> Option<Circle> {
    let round = Circle::fit(points)?;
    let offs: Vec<f64> = points.iter().map(|&p| round.off(p)).collect();
    let mean = offs.iter().sum::<f64>() / offs.len() as f64;
    let off = apart(offs.iter().chain(offs.iter().take(STRETCH)).copied());
    // Eight points are the least for which round and square differ.
    let enough = points.len() >= 8 && round.radius > 4.0 * mean;
    (enough && mean <= tolerance && off.stretch <= 4.0 * tolerance).then_some(round)
}

impl Profile {
    /// At most about `most` of its points, evenly.
    pub(super) fn some(&self, most: usize) -> impl Iterator<Item = [f64; 2]> {
        let points = self.outline.points();
        points.iter().step_by(points.len().div_ceil(most).max(1)).copied()
    }

    /// The distance between the two outlines, the second moved by `shift`.
    pub(super) fn apart(&self, other: &Profile, shift: [f64; 2]) -> Apart {
        let back = shift.map(|x| -x);
        let there = apart(self.some(POINTS).map(|p| other.outline.off(along(p, back, 1.0))));
        let here = apart(other.some(POINTS).map(|p| self.outline.off(along(p, shift, 1.0))));
        Apart { mean: there.mean.max(here.mean), stretch: there.stretch.max(here.stretch) }
    }

    /// The shift that lays another profile's centroid on this one's.
    pub(super) fn onto(&self, other: &Profile) -> [f64; 2] {
        sub(self.centroid, other.centroid)
    }

    /// Mean distance of the wall outward from that of `low`: the area between them over their mean length.
    pub(super) fn beyond(&self, low: &Profile) -> f64 {
        2.0 * (self.area - low.area) / (self.length + low.length)
    }

    /// Points of the outline, for a comparison.
    pub(super) fn sample(&self) -> impl Iterator<Item = [f64; 2]> {
        self.some(POINTS)
    }
}

fn apart(offs: impl Iterator<Item = f64>) -> Apart {
    let (mut sum, mut count, mut stretch) = (0.0, 0.0, 0.0f64);
    let mut last = [0.0; STRETCH];
    for (k, off) in offs.enumerate() {
        last[k % STRETCH] = off;
        sum += off;
        count += 1.0;
        stretch = stretch.max(last.iter().copied().fold(f64::INFINITY, f64::min));
    }
    Apart { mean: if count > 0.0 { sum / count } else { 0.0 }, stretch }
}

impl Apart {
    /// Whether outlines so far apart are one within the tolerance, nowhere changed.
    pub(super) fn same(&self, tolerance: f64) -> bool {
        self.mean <= tolerance && self.stretch <= CHANGED * tolerance
    }
}
