//! The outlines of sections on a picture: thin, and only where they lie before the surface, as a stack of them has more line than a
//! picture has room for.

use super::camera::Camera;
use super::depth_buffer::DepthBuffer;
use super::drawing::{Layer, Shape};
use super::hidden::stretches;
use super::scene::Slice;
use super::style::SLICE_COLOUR;

/// Width of an outline, in widths of a strip.
const WIDTH: f32 = 0.5;
/// Where a stack is dense the shades of the surface show through.
const OPACITY: f32 = 0.7;

/// What is known of the picture when lines are drawn on it.
pub(super) struct Page<'a> {
    pub camera: &'a Camera,
    pub surface: &'a DepthBuffer,
    /// Pixels of the surface for each pixel of the picture.
    pub fine: usize,
    /// Greatest depth behind the surface at which a line still counts as visible, pixels of the surface.
    pub bias: f32,
}

/// The outlines; `pen` is the width of a strip, pixels.
pub(super) fn layer(slices: &[Slice], page: &Page, pen: f32) -> Layer {
    let mut layer = Layer { opacity: OPACITY, ..Layer::new("slice", SLICE_COLOUR) };
    for slice in slices {
        let line = page.camera.line(slice.points, slice.closed);
        for stretch in stretches(&line, page.surface, page.bias).iter().filter(|s| s.visible) {
            let points = stretch.points.iter().map(|p| p.map(|x| x / page.fine as f32)).collect();
            layer.shapes.push(Shape::Line { points, width: WIDTH * pen, dash: None });
        }
    }
    layer
}

#[cfg(test)]
mod tests {
    use super::super::{Scene, Settings, View, render, surfels};
    use super::*;
    use crate::shapes;

    #[test]
    fn outlines_are_seen_before_the_surface_and_not_behind_it() {
        let (surfels, spacing) = surfels(&shapes::cube_386().cloud).unwrap();
        let settings = Settings {
            views: vec![View::From([0.0, 0.0, 1.0])],
            width: 200,
            height: 200,
            caption: false,
            ..Settings::default()
        };
        let (low, high) = surfels.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), s| {
            (low.min(s.position[2]), high.max(s.position[2]))
        });
        let drawn = |slices: &[Slice]| {
            render(&Scene { surfels: &surfels, slices, spacing, ..Scene::default() }, &settings).unwrap().rgb
        };
        let bare = drawn(&[]);
        let green = |z: f64| {
            let points = [-0.2, 0.2].map(|x| [x, 0.1, z]);
            let rgb = drawn(&[Slice { plane: 0, points: &points, closed: false }]);
            let pixels = rgb.chunks_exact(3).zip(bare.chunks_exact(3));
            pixels.filter(|(p, bare)| p != bare && p[1] > p[0].saturating_add(10)).count()
        };
        assert!(green(high) > 40, "{}", green(high));
        assert_eq!(green(low), 0);
    }
}
