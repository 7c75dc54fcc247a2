//! Line drawings as SVG: true vectors, a group for each layer.

use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use lineament::apply::render::{Drawing, Layer, Shape, Text};

use crate::error::Error;
use crate::output::Output;

/// Writes a drawing to a file as SVG, whole or not at all. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`Output::create`], and a failed write.
pub fn write_drawing(path: &Path, inputs: &[PathBuf], drawing: &Drawing) -> Result<(), Error> {
    Output::whole(path, inputs, |out| write_drawing_to(out, drawing))
}

/// Writes a drawing to a stream as SVG.
///
/// # Errors
/// Those of the stream.
pub fn write_drawing_to(out: &mut dyn Write, drawing: &Drawing) -> io::Result<()> {
    let Drawing { width, height, scale, .. } = drawing;
    write!(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" ")?;
    writeln!(out, "viewBox=\"0 0 {width} {height}\">")?;
    writeln!(out, "<desc>Line drawing; one unit of the input is {scale:?} px</desc>")?;
    if !drawing.transparent {
        writeln!(out, "<rect id=\"ground\" width=\"{width}\" height=\"{height}\" fill=\"#ffffff\"/>")?;
    }
    drawing.layers.iter().try_for_each(|layer| group(out, layer))?;
    writeln!(out, "<g id=\"words\" fill=\"#404550\" font-family=\"monospace\">")?;
    drawing.texts.iter().try_for_each(|text| words(out, text))?;
    writeln!(out, "</g>\n</svg>")?;
    out.flush()
}

fn group(out: &mut dyn Write, layer: &Layer) -> io::Result<()> {
    let [r, g, b] = layer.colour.map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8);
    write!(out, "<g id=\"{}\" color=\"#{r:02x}{g:02x}{b:02x}\" ", layer.name)?;
    write!(out, "fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\"")?;
    if layer.opacity < 1.0 {
        write!(out, " opacity=\"{}\"", layer.opacity)?;
    }
    writeln!(out, ">")?;
    layer.shapes.iter().try_for_each(|shape| writeln!(out, "{}", element(shape)))?;
    writeln!(out, "</g>")
}

fn element(shape: &Shape) -> String {
    match shape {
        Shape::Line { points, width, dash } => {
            let dash = dash.map_or(String::new(), |[dash, gap]| {
                format!(" stroke-dasharray=\"{} {}\"", short(dash), short(gap))
            });
            let width = short(*width);
            format!("<path stroke=\"currentColor\" stroke-width=\"{width}\"{dash} d=\"{}\"/>", path(points))
        }
        Shape::Dot { center: [x, y], radius } => {
            let [x, y, r] = [x, y, radius].map(|v| short(*v));
            format!("<circle fill=\"currentColor\" cx=\"{x}\" cy=\"{y}\" r=\"{r}\"/>")
        }
        Shape::Box { corner: [x, y], size: [width, height] } => {
            let [x, y, width, height] = [x, y, width, height].map(|v| short(*v));
            format!("<rect fill=\"currentColor\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"/>")
        }
    }
}

fn path(points: &[[f32; 2]]) -> String {
    let closed = points.len() > 2 && points.first() == points.last();
    let drawn = if closed { &points[..points.len() - 1] } else { points };
    let mut path = String::new();
    for (i, &[x, y]) in drawn.iter().enumerate() {
        // Writing to a text cannot fail.
        let _ = write!(path, "{}{},{}", if i == 0 { "M" } else { " L" }, short(x), short(y));
    }
    path + if closed { " Z" } else { "" }
}

/// Hundredths of a pixel.
fn short(value: f32) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_string()
}

/// A text in letters as wide as those of pictures, six dots from one to the next.
fn words(out: &mut dyn Write, Text { corner: [x, y], scale, text }: &Text) -> io::Result<()> {
    let (base, size) = (y + 7.0 * *scale as f32, 10 * scale);
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    writeln!(out, "<text x=\"{}\" y=\"{}\" font-size=\"{size}\">{text}</text>", short(*x), short(base))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_are_paths_circles_and_rectangles() {
        let line = |points: &[[f32; 2]], dash| Shape::Line { points: points.into(), width: 1.5, dash };
        let open = element(&line(&[[0.0, 1.25], [3.0, 4.0]], Some([4.5, 3.0])));
        assert!(open.contains("stroke-dasharray=\"4.5 3\"") && open.contains("d=\"M0,1.25 L3,4\""), "{open}");
        let closed = element(&line(&[[0.0, 0.0], [3.0, 0.0], [0.0, 3.0], [0.0, 0.0]], None));
        assert!(closed.contains("d=\"M0,0 L3,0 L0,3 Z\"") && !closed.contains("dash"), "{closed}");
        let dot = element(&Shape::Dot { center: [1.0, 2.0], radius: 3.0 });
        assert!(dot.contains("cx=\"1\" cy=\"2\" r=\"3\""), "{dot}");
    }
}
