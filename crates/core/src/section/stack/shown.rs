//! Whether a slice shows an outline though it has no such closed contour: a slice along a face shows some contours open.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::profile::Profile;
use crate::curve::polyline::Polyline;
use crate::section::result::{Contour, Sections};

/// Share of an outline that a slice must show for it to be there.
const SHOWN: f64 = 0.6;

/// The open contours of sections, as they are asked for. Closed ones tell of other outlines: a block that a slot parts in two
/// shows most of its own in those of its halves.
pub(super) struct Shown<'a> {
    sections: &'a Sections,
    lines: RefCell<BTreeMap<usize, Vec<Polyline>>>,
}

impl<'a> Shown<'a> {
    pub(super) fn new(sections: &'a Sections) -> Self {
        Self { sections, lines: RefCell::default() }
    }

    /// Whether most of an outline lies on open contours of a plane.
    pub(super) fn holds(&self, plane: usize, profile: &Profile) -> bool {
        let reach = (0.5 + 2.0 * self.sections.noise) * self.sections.spacing;
        let mut known = self.lines.borrow_mut();
        let lines = known.entry(plane).or_insert_with(|| self.lines(plane));
        let points: Vec<[f64; 2]> = profile.some(128).collect();
        let near =
            |p: [f64; 2]| lines.iter().any(|l| l.off_within(p, 2.0 * reach).is_some_and(|o| o <= reach));
        points.iter().filter(|&&p| near(p)).count() as f64 >= SHOWN * points.len() as f64
    }

    fn lines(&self, plane: usize) -> Vec<Polyline> {
        let flat = |p: &[f64; 3]| {
            let [x, y, _] = self.sections.frame.coordinates(*p);
            [x, y]
        };
        let line = |c: &Contour| {
            let points: Vec<[f64; 2]> = c.points.iter().map(flat).collect();
            Polyline::new(&points, false, self.sections.spacing)
        };
        self.sections.sections[plane].contours.iter().filter(|c| !c.closed).map(line).collect()
    }
}
