//! Lines over the surface: what lies before it solid, what is behind it faint and dashed.

use super::hidden::stretches;
use super::picture::{Colour, Picture, WHITE};
use super::slices::Page;
use super::stroke::Mask;
use super::style::{strip_colour, verdict_colour};
use crate::evaluate::{Stretch, Verdict};
use crate::network::{Network, StripKind};

/// Opacity of lines behind the surface.
pub(super) const HIDDEN_OPACITY: f32 = 0.45;
/// Width of lines that are right, in widths of a strip, so that the others stand out.
const RIGHT_WIDTH: f32 = 0.6;

/// Lines of one colour.
pub(super) struct Layer<'a> {
    pub colour: Colour,
    /// Width, in widths of a strip.
    pub width: f32,
    /// The lines, and whether each is closed.
    pub lines: Vec<(&'a [[f64; 3]], bool)>,
}

/// The strips of a network by their kind.
pub(super) fn strips(network: &Network) -> Vec<Layer<'_>> {
    let layer = |kind| {
        let lines = network.strips.iter().filter(|s| s.kind == kind);
        let lines = lines.map(|s| (s.points.as_slice(), s.closed)).collect();
        Layer { colour: strip_colour(kind), width: 1.0, lines }
    };
    [StripKind::Border, StripKind::Crease].map(layer).into()
}

/// Stretches of lines by the verdict on them, those that are right below the others.
pub(super) fn verdicts(stretches: &[Stretch]) -> Vec<Layer<'_>> {
    let layer = |verdict| {
        let lines = stretches.iter().filter(|s| s.verdict == verdict);
        let width = if verdict == Verdict::Right { RIGHT_WIDTH } else { 1.0 };
        let lines = lines.map(|s| (s.points.as_slice(), false)).collect();
        Layer { colour: verdict_colour(verdict), width, lines }
    };
    Verdict::ALL.map(layer).into()
}

/// Draws layers, each over those before it; `pen` is the width of a strip, pixels.
pub(super) fn draw(layers: &[Layer], page: &Page, pen: f32, picture: &mut Picture) {
    let mask = || Mask::new(picture.width, picture.height);
    let mut halo = mask();
    let mut masks: Vec<(Mask, Mask)> = layers.iter().map(|_| (mask(), mask())).collect();
    for (layer, (hidden, visible)) in layers.iter().zip(&mut masks) {
        let pen = layer.width * pen;
        for (points, closed) in &layer.lines {
            for stretch in stretches(&page.camera.line(points, *closed), page.surface, page.bias) {
                let points: Vec<[f32; 2]> =
                    stretch.points.iter().map(|p| p.map(|x| x / page.fine as f32)).collect();
                if stretch.visible {
                    halo.polyline(&points, 2.0 * pen);
                    visible.polyline(&points, pen);
                } else {
                    hidden.dashes(&points, 0.7 * pen, 3.0 * pen, 1.5 * pen);
                }
            }
        }
    }
    for (layer, (hidden, _)) in layers.iter().zip(&masks) {
        hidden.paint(picture, layer.colour, HIDDEN_OPACITY);
    }
    halo.paint(picture, WHITE, 0.75);
    for (layer, (_, visible)) in layers.iter().zip(&masks) {
        visible.paint(picture, layer.colour, 1.0);
    }
}
