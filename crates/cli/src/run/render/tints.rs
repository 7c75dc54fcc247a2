//! Colours of the points on a picture.

use lineament::Extraction;
use lineament::apply::render::{Surfel, class_tint, patch_tint, score_tint};

use crate::args::PointColor;

/// Points that are not there.
const PLAIN: [f32; 3] = [1.0; 3];

/// The colour of each surfel.
pub fn of(color: PointColor, found: &Extraction, surfels: &[Surfel]) -> Vec<[f32; 3]> {
    let of_point: Vec<[f32; 3]> = match color {
        PointColor::Class => found.classes().into_iter().map(class_tint).collect(),
        PointColor::Score => found.scores().into_iter().map(score_tint).collect(),
        PointColor::Patch => found.patch_labels().into_iter().map(patch_tint).collect(),
    };
    surfels.iter().map(|s| of_point.get(s.source as usize).copied().unwrap_or(PLAIN)).collect()
}

/// What the colours mean, in a sentence.
pub fn legend(color: PointColor, found: &Extraction) -> String {
    match color {
        PointColor::Class => "points: creases red, borders blue, corners green, clutter violet".into(),
        PointColor::Score => "points: score from white (0) to red (1)".into(),
        PointColor::Patch => {
            let count = found.patches.as_ref().map_or(0, |p| p.patches.len());
            format!("points: {count} patches in different colours")
        }
    }
}
