//! The scale bar.

use super::letters::{ADVANCE, HEIGHT};
use super::{Drawing, Layer, Shape, Text};

use crate::apply::render::style::INK;

/// Greatest length of the bar as a share of the width of the sheet.
const SHARE: f64 = 0.2;

/// Draws a bar of a round length in the lower right corner, with that length and `unit`.
pub(in crate::apply::render) fn draw(drawing: &mut Drawing, unit: &str, scale: usize) {
    let Some(length) = round_length(SHARE * drawing.width as f64 / drawing.scale) else { return };
    let pixels = (length * drawing.scale) as f32;
    let dot = scale as f32;
    let (right, y) = (drawing.width as f32 - 6.0 * dot, drawing.height as f32 - 6.0 * dot);
    let tick = 3.0 * dot;
    let mut layer = Layer::new("scale-bar", INK);
    let lines = [
        [[right - pixels, y], [right, y]],
        [[right - pixels, y - tick], [right - pixels, y]],
        [[right, y - tick], [right, y]],
    ];
    layer.shapes.extend(lines.map(|ends| Shape::Line { points: ends.into(), width: dot, dash: None }));
    let text = format!("{} {unit}", number(length)).trim().to_string();
    let wide = (text.chars().count() * ADVANCE * scale) as f32;
    let corner = [(right - 0.5 * (pixels + wide)).min(right - wide), y - tick - (HEIGHT * scale) as f32];
    drawing.layers.push(layer);
    drawing.texts.push(Text { corner, scale, text });
}

/// The greatest of 1, 2 and 5 times a power of ten that is not more than `most`.
fn round_length(most: f64) -> Option<f64> {
    let power = most.log10().floor();
    // Read from text, so that the length is the number nearest to its decimal name.
    let steps = [5, 2, 1].into_iter().map(|step| format!("{step}e{power}").parse::<f64>());
    steps.flatten().find(|&step| step > 0.0 && step <= most)
}

fn number(length: f64) -> String {
    if (1e-4..1e6).contains(&length) { format!("{length}") } else { format!("{length:e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lengths_are_round_and_not_too_long() {
        let cases = [(1.0, 1.0), (1.99, 1.0), (4.99, 2.0), (9.0, 5.0), (0.31, 0.2), (7e-5, 5e-5), (3e8, 2e8)];
        for (most, length) in cases {
            assert_eq!(round_length(most), Some(length));
        }
        for none in [0.0, f64::NAN, f64::INFINITY, -1.0] {
            assert_eq!(round_length(none), None);
        }
    }

    #[test]
    fn the_bar_is_as_long_as_it_says() {
        let mut drawing = Drawing { width: 1000, height: 800, scale: 12.5, ..Drawing::default() };
        draw(&mut drawing, "mm", 2);
        let Shape::Line { points, .. } = &drawing.layers[0].shapes[0] else { panic!("no bar") };
        assert_eq!(drawing.texts[0].text, "10 mm");
        assert!((points[1][0] - points[0][0] - 125.0).abs() < 1e-3);
    }
}
