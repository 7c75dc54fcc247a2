//! Sections as an SVG sheet: the slices side by side at one scale, solid parts tinted, each under its height.

use lineament::section::{Contour, Section, Sections};
use std::io::{self, Write};

/// Width of a slice's cell on a sheet, and of the picture of one slice, in pixels.
const CELL: f64 = 320.0;
const ALONE: f64 = 900.0;
/// Free room around the curves, as a share of the cell.
const MARGIN: f64 = 0.06;

/// Least corner and extent of the curves in the plane.
struct Window {
    low: [f64; 2],
    extent: [f64; 2],
}

/// Writes all slices on one sheet.
pub(super) fn write(out: &mut dyn Write, sections: &Sections) -> io::Result<()> {
    let n = sections.sections.len().max(1);
    let columns = (n as f64).sqrt().ceil() as usize;
    let window = window(sections, &sections.sections);
    let height = cell_height(&window, CELL);
    let size = [columns as f64 * CELL, n.div_ceil(columns) as f64 * height];
    head(out, size)?;
    for (k, section) in sections.sections.iter().enumerate() {
        let corner = [(k % columns) as f64 * CELL, (k / columns) as f64 * height];
        slice(out, sections, section, &window, corner, CELL)?;
    }
    writeln!(out, "</svg>")
}

/// Writes one slice alone.
pub(super) fn write_one(out: &mut dyn Write, sections: &Sections, plane: usize) -> io::Result<()> {
    let window = window(sections, &sections.sections);
    head(out, [ALONE, cell_height(&window, ALONE)])?;
    if let Some(section) = sections.sections.get(plane) {
        slice(out, sections, section, &window, [0.0, 0.0], ALONE)?;
    }
    writeln!(out, "</svg>")
}

fn head(out: &mut dyn Write, [width, height]: [f64; 2]) -> io::Result<()> {
    write!(out, "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.0}\" height=\"{height:.0}\" ")?;
    writeln!(out, "viewBox=\"0 0 {width:.1} {height:.1}\">")?;
    writeln!(out, "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>")
}

fn flat(sections: &Sections, p: [f64; 3]) -> [f64; 2] {
    let [x, y, _] = sections.frame.coordinates(p);
    [x, y]
}

fn window(sections: &Sections, of: &[Section]) -> Window {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for contour in of.iter().flat_map(|s| &s.contours) {
        for &p in &contour.points {
            let p = flat(sections, p);
            for axis in 0..2 {
                low[axis] = low[axis].min(p[axis]);
                high[axis] = high[axis].max(p[axis]);
            }
        }
    }
    if low[0] > high[0] {
        return Window { low: [0.0; 2], extent: [1.0; 2] };
    }
    Window { low, extent: [0, 1].map(|a| (high[a] - low[a]).max(f64::MIN_POSITIVE)) }
}

fn scale(window: &Window, cell: f64) -> f64 {
    (1.0 - 2.0 * MARGIN) * cell / window.extent[0].max(window.extent[1])
}

fn cell_height(window: &Window, cell: f64) -> f64 {
    window.extent[1] * scale(window, cell) + 2.0 * MARGIN * cell + 18.0
}

fn slice(
    out: &mut dyn Write,
    sections: &Sections,
    section: &Section,
    window: &Window,
    corner: [f64; 2],
    cell: f64,
) -> io::Result<()> {
    let s = scale(window, cell);
    let high = window.low[1] + window.extent[1];
    let place = |p: [f64; 3]| {
        let [x, y] = flat(sections, p);
        let left = corner[0] + 0.5 * (cell - window.extent[0] * s);
        [left + (x - window.low[0]) * s, corner[1] + MARGIN * cell + (high - y) * s]
    };
    write!(out, "<g id=\"slice_{:04}\"><path fill=\"#dfe8f2\" fill-rule=\"evenodd\" ", section.plane)?;
    write!(out, "stroke=\"#1f4e8c\" stroke-width=\"1\" d=\"")?;
    section.contours.iter().filter(|c| c.closed).try_for_each(|c| path(out, c, place))?;
    write!(out, "\"/><path fill=\"none\" stroke=\"#c0392b\" stroke-width=\"1\" d=\"")?;
    section.contours.iter().filter(|c| !c.closed).try_for_each(|c| path(out, c, place))?;
    let bottom = corner[1] + cell_height(window, cell) - 6.0;
    write!(out, "\"/><text x=\"{:.1}\" y=\"{bottom:.1}\" ", corner[0] + 8.0)?;
    write!(out, "font-family=\"sans-serif\" font-size=\"11\">")?;
    write!(out, "{}: {}", section.plane, rounded(section.height))?;
    if let Some(missing) = section.missing {
        write!(out, " ({})", missing.reason())?;
    }
    writeln!(out, "</text></g>")
}

fn rounded(height: f64) -> String {
    let text = format!("{height:.4}");
    text.trim_end_matches('0').trim_end_matches('.').into()
}

fn path(out: &mut dyn Write, contour: &Contour, place: impl Fn([f64; 3]) -> [f64; 2]) -> io::Result<()> {
    for (k, &p) in contour.points.iter().enumerate() {
        let [x, y] = place(p);
        write!(out, "{}{x:.2} {y:.2}", if k == 0 { "M" } else { "L" })?;
    }
    write!(out, "{}", if contour.closed { "Z" } else { "" })
}
