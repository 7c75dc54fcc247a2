//! Colours of the points on a picture.

use lineament::apply::render::Surfel;
use lineament::patch::NO_PATCH;
use lineament::{Class, Extraction};

use crate::args::PointColor;

/// Points on no line, or on no patch.
const PLAIN: [f32; 3] = [1.0; 3];
/// Clutter.
const CLUTTER: [f32; 3] = [0.66, 0.45, 0.85];
/// Turn of the hue from patch to patch: the golden section of the circle, so that neighbours in number differ.
const TURN: f32 = 0.618_034;

/// The colour of each surfel.
pub fn of(color: PointColor, found: &Extraction, surfels: &[Surfel]) -> Vec<[f32; 3]> {
    let of_point: Vec<[f32; 3]> = match color {
        PointColor::Class => found.classes().into_iter().map(class).collect(),
        PointColor::Score => found.scores().into_iter().map(score).collect(),
        PointColor::Patch => found.patch_labels().into_iter().map(patch).collect(),
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

fn class(class: Class) -> [f32; 3] {
    match class {
        Class::Smooth => PLAIN,
        Class::Crease => [0.95, 0.35, 0.20],
        Class::Border => [0.25, 0.60, 0.98],
        Class::Corner => [0.10, 0.75, 0.55],
        Class::Clutter => CLUTTER,
    }
}

/// White to red; white where there is no score.
fn score(score: f32) -> [f32; 3] {
    let share = if score.is_finite() { score.clamp(0.0, 1.0) } else { 0.0 };
    [1.0 - 0.1 * share, 1.0 - 0.75 * share, 1.0 - 0.85 * share]
}

/// A pale hue for each patch.
fn patch(label: u32) -> [f32; 3] {
    if label == NO_PATCH {
        return PLAIN;
    }
    let hue = (label as f32 * TURN).fract() * 6.0;
    [0.0, 4.0, 2.0].map(|shift| {
        let share = (((hue + shift) % 6.0 - 3.0).abs() - 1.0).clamp(0.0, 1.0);
        0.55 + 0.45 * share
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patches_of_neighbouring_numbers_have_different_colours() {
        let apart = |a: u32, b: u32| {
            let (a, b) = (patch(a), patch(b));
            (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f32::max)
        };
        assert!((0..30).all(|i| apart(i, i + 1) > 0.2 && apart(i, i + 2) > 0.1));
        assert_eq!((patch(NO_PATCH), score(f32::NAN)), (PLAIN, PLAIN));
    }
}
