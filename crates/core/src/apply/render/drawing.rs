//! A drawing: the shapes on a picture in the order of painting, before they are painted or written as vectors.
//!
//! Coordinates are pixels, x to the right, y down from the upper left corner.

pub(super) mod bar;
pub(super) mod cells;
pub(super) mod cover;
pub(super) mod letters;
pub(super) mod nodes;
pub(super) mod raster;
mod sharpen;
pub(super) mod silhouette;
#[cfg(test)]
mod tests;
mod trace;

use super::picture::Colour;

/// Shapes in layers, each over those before it, and texts over all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// Width of the sheet in pixels.
    pub width: usize,
    /// Height of the sheet in pixels.
    pub height: usize,
    /// Pixels for each unit of the scene, in all views.
    pub scale: f64,
    /// Whether the ground is transparent; otherwise it is white.
    pub transparent: bool,
    /// The shapes.
    pub layers: Vec<Layer>,
    /// Words on the sheet.
    pub texts: Vec<Text>,
}

/// Shapes of one colour, which cover a place once however many lie on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// What the shapes are, such as `crease` or `crease-hidden`.
    pub name: String,
    /// Red, green and blue from 0 to 1, in sRGB.
    pub colour: [f32; 3],
    /// From 0 to 1.
    pub opacity: f32,
    /// Whether it only lightens the shaded surface below lines: it belongs to no line drawing.
    pub halo: bool,
    /// Its shapes.
    pub shapes: Vec<Shape>,
}

/// A shape on the sheet.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A polyline with round ends and joints; closed if its last point is its first.
    Line {
        /// At least two.
        points: Vec<[f32; 2]>,
        /// Width in pixels.
        width: f32,
        /// Lengths of dashes and gaps; `None` for a solid line.
        dash: Option<[f32; 2]>,
    },
    /// A disc.
    Dot {
        /// Its middle.
        center: [f32; 2],
        /// Its radius.
        radius: f32,
    },
    /// A filled rectangle.
    Box {
        /// Its upper left corner.
        corner: [f32; 2],
        /// Its width and height.
        size: [f32; 2],
    },
}

/// A line of text.
#[derive(Clone, Debug, PartialEq)]
pub struct Text {
    /// The upper left corner of the first letter.
    pub corner: [f32; 2],
    /// Pixels for each dot of a letter; capitals are seven dots high, letters six apart.
    pub scale: usize,
    /// The words.
    pub text: String,
}

impl Layer {
    /// An opaque layer without shapes.
    pub(super) fn new(name: impl Into<String>, colour: Colour) -> Self {
        Self { name: name.into(), colour, opacity: 1.0, halo: false, shapes: Vec::new() }
    }
}

impl Shape {
    /// Moves it over the sheet.
    fn shift(&mut self, by: [f32; 2]) {
        let moved = |p: &mut [f32; 2]| *p = [p[0] + by[0], p[1] + by[1]];
        match self {
            Shape::Line { points, .. } => points.iter_mut().for_each(moved),
            Shape::Dot { center: at, .. } | Shape::Box { corner: at, .. } => moved(at),
        }
    }
}

impl Drawing {
    /// Takes the shapes of a smaller drawing to `corner` of this one, into the layers of the same name.
    pub(super) fn place(&mut self, part: Drawing, corner: [usize; 2]) {
        let by = corner.map(|x| x as f32);
        for mut layer in part.layers {
            layer.shapes.iter_mut().for_each(|s| s.shift(by));
            match self.layers.iter_mut().find(|l| l.name == layer.name) {
                Some(known) => known.shapes.extend(layer.shapes),
                None => self.layers.push(layer),
            }
        }
        for mut text in part.texts {
            text.corner = [text.corner[0] + by[0], text.corner[1] + by[1]];
            self.texts.push(text);
        }
    }
}
