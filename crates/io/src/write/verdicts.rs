//! Evaluated lines as an SVG drawing: what is right, what was missed and what is false, in groups of these names.

use super::encode::view::{best_view, frame};
use crate::error::Error;
use crate::output::Output;
use lineament::evaluate::{Stretch, Verdict};
use lineament::math::vec3::{dot, sub};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// The longest side of the drawing, and its margin, in millimetres.
const SIDE: f64 = 200.0;
const MARGIN: f64 = 5.0;
/// Colour and width of each verdict, in millimetres.
const STROKES: [(Verdict, &str, f64); 3] =
    [(Verdict::Right, "#4d5259", 0.25), (Verdict::Missed, "#d64d00", 0.5), (Verdict::False, "#0066cc", 0.5)];

/// Writes a drawing to a file, whole or not at all, seen along `view`, or from the best direction. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`Output::create`], and a failed write.
pub fn write_verdicts(
    path: &Path,
    inputs: &[PathBuf],
    stretches: &[Stretch],
    view: Option<[f64; 3]>,
) -> Result<(), Error> {
    Output::whole(path, inputs, |out| write(out, stretches, view))
}

fn write(out: &mut dyn Write, stretches: &[Stretch], view: Option<[f64; 3]>) -> io::Result<()> {
    let all: Vec<[f64; 3]> = stretches.iter().flat_map(|s| &s.points).copied().collect();
    let [right, up] = frame(view.unwrap_or_else(|| best_view(&all)));
    let origin = all.first().copied().unwrap_or_default();
    let flat = |p: &[f64; 3]| [dot(sub(*p, origin), right), -dot(sub(*p, origin), up)];
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for p in all.iter().map(flat) {
        low = [low[0].min(p[0]), low[1].min(p[1])];
        high = [high[0].max(p[0]), high[1].max(p[1])];
    }
    let sides = if all.is_empty() { [0.0; 2] } else { [high[0] - low[0], high[1] - low[1]] };
    let longest = sides[0].max(sides[1]);
    let scale = if longest > 0.0 { SIDE / longest } else { 1.0 };
    let [width, height] = sides.map(|side| side * scale + 2.0 * MARGIN);
    write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}mm\" height=\"{height:.3}mm\" "
    )?;
    writeln!(out, "viewBox=\"0 0 {width:.3} {height:.3}\">")?;
    writeln!(out, "<desc>Evaluated lines; one unit of the input is {scale:?} mm</desc>")?;
    for (verdict, colour, pen) in STROKES {
        write!(
            out,
            "<g id=\"{}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"{pen}\" ",
            verdict.name()
        )?;
        writeln!(out, "stroke-linejoin=\"round\" stroke-linecap=\"round\">")?;
        for stretch in stretches.iter().filter(|s| s.verdict == verdict) {
            write!(out, "<path d=\"")?;
            for (i, point) in stretch.points.iter().enumerate() {
                let [x, y] = flat(point);
                let (x, y) = ((x - low[0]) * scale + MARGIN, (y - low[1]) * scale + MARGIN);
                write!(out, "{}{x:.4},{y:.4}", if i == 0 { "M" } else { " L" })?;
            }
            writeln!(out, "\"/>")?;
        }
        writeln!(out, "</g>")?;
    }
    writeln!(out, "</svg>")
}
