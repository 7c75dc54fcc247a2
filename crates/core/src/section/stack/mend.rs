//! Contours that a slice shows otherwise than both of its neighbours do: a slice along a face lacks the contours that end
//! or begin there, so that a hole in it lies in no outline, or shows them open.

use super::super::polyline::Polyline;
use super::super::result::{Contour, Sections};
use super::profile::Profile;

/// Share of an outline that a slice must show for it to be there.
const SHOWN: f64 = 0.6;
/// Slices to either side that tell whether a contour is a hole.
const BESIDE: usize = 3;
/// How far two outlines may lie apart to be one, in tolerances.
const SAME: f64 = 2.0;

/// Makes solid or hole of contours what the same outline is in slices below and above.
pub(super) fn sides(levels: &mut [Vec<Profile>], tolerance: f64) {
    let size = |q: &Profile, p: &Profile| (q.area.sqrt() - p.area.sqrt()).abs() <= SAME * 4.0 * tolerance;
    let other = |level: &[Profile], p: &Profile| {
        let like = |q: &Profile| size(q, p) && q.apart(p, [0.0; 2]).mean <= SAME * tolerance;
        level.iter().any(|q| q.hole != p.hole && like(q))
    };
    let mut turned = Vec::new();
    for (k, level) in levels.iter().enumerate() {
        let below = k.saturating_sub(BESIDE)..k;
        let above = k + 1..(k + 1 + BESIDE).min(levels.len());
        for (j, p) in level.iter().enumerate() {
            if below.clone().any(|l| other(&levels[l], p)) && above.clone().any(|l| other(&levels[l], p)) {
                turned.push((k, j));
            }
        }
    }
    for (k, j) in turned {
        levels[k][j].hole ^= true;
    }
}

/// Whether most of an outline lies on contours of a section, open ones included.
pub(super) fn shown(sections: &Sections, plane: usize, profile: &Profile) -> bool {
    let reach = (0.5 + 2.0 * sections.noise) * sections.spacing;
    let flat = |p: &[f64; 3]| {
        let [x, y, _] = sections.frame.coordinates(*p);
        [x, y]
    };
    let line = |c: &Contour| {
        let points: Vec<[f64; 2]> = c.points.iter().map(flat).collect();
        Polyline::new(&points, c.closed, sections.spacing)
    };
    let lines: Vec<Polyline> = sections.sections[plane].contours.iter().map(line).collect();
    let points: Vec<[f64; 2]> = profile.some(128).collect();
    let on = points
        .iter()
        .filter(|p| lines.iter().any(|l| l.off_within(**p, 2.0 * reach).is_some_and(|o| o <= reach)));
    on.count() as f64 >= SHOWN * points.len() as f64
}
