//! Drawings as pixels.

use super::{Drawing, Shape, letters};
use crate::apply::render::picture::Picture;
use crate::apply::render::stroke::Mask;

/// Paints the shapes and texts of a drawing over a picture of its size.
pub(in crate::apply::render) fn paint(drawing: &Drawing, picture: &mut Picture) {
    for layer in drawing.layers.iter().filter(|l| !l.shapes.is_empty()) {
        let mut mask = Mask::new(picture.width, picture.height);
        layer.shapes.iter().for_each(|shape| cover(shape, &mut mask));
        mask.paint(picture, layer.colour, layer.opacity, layer.halo);
    }
    for text in &drawing.texts {
        letters::write(picture, &text.text, text.corner.map(|x| x.max(0.0) as usize), text.scale);
    }
}

fn cover(shape: &Shape, mask: &mut Mask) {
    match shape {
        Shape::Line { points, width, dash: None } => mask.polyline(points, *width),
        Shape::Line { points, width, dash: Some([dash, gap]) } => mask.dashes(points, *width, *dash, *gap),
        Shape::Dot { center, radius } => mask.disc(*center, *radius),
        Shape::Box { corner, size } => mask.fill(*corner, *size),
    }
}
