//! Sections as an SVG sheet: the slices side by side at one scale, solid parts tinted, each under its height. Where curves
//! were fitted, arcs and circles are drawn as such and splines as the cubic curves of Bezier that they consist of.

use lineament::curve::BSpline;
use lineament::section::{Contour, CurvePiece, CurveShape, Section, Sections};
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
    let at = |out: &mut dyn Write, command: &str, p: [f64; 3]| {
        let [x, y] = place(p);
        write!(out, "{command}{x:.2} {y:.2}")
    };
    if let Some(first) = contour.pieces.first() {
        at(out, "M", first.from)?;
        contour.pieces.iter().try_for_each(|piece| curve(out, piece, &at, &place))?;
    } else {
        for (k, &p) in contour.points.iter().enumerate() {
            at(out, if k == 0 { "M" } else { "L" }, p)?;
        }
    }
    write!(out, "{}", if contour.closed { "Z" } else { "" })
}

/// One fitted piece, from where the pen stands. The picture has its second axis down: a counter-clockwise curve runs
/// against the positive sweep of SVG.
fn curve(
    out: &mut dyn Write,
    piece: &CurvePiece,
    at: &impl Fn(&mut dyn Write, &str, [f64; 3]) -> io::Result<()>,
    place: &impl Fn([f64; 3]) -> [f64; 2],
) -> io::Result<()> {
    // Radii are drawn as far as their centres lie from the ends.
    let radius = |centre: [f64; 3]| {
        let ([x, y], [u, v]) = (place(centre), place(piece.from));
        (x - u).hypot(y - v)
    };
    match &piece.shape {
        CurveShape::Line => at(out, "L", piece.to),
        CurveShape::Arc { centre, sweep_deg, .. } => {
            let (r, large, forward) =
                (radius(*centre), u8::from(sweep_deg.abs() > 180.0), u8::from(*sweep_deg < 0.0));
            at(out, &format!("A{r:.3} {r:.3} 0 {large} {forward} "), piece.to)
        }
        CurveShape::Circle { centre, .. } => {
            let r = radius(*centre);
            let across = [0, 1, 2].map(|k| 2.0 * centre[k] - piece.from[k]);
            at(out, &format!("A{r:.3} {r:.3} 0 1 0 "), across)?;
            at(out, &format!("A{r:.3} {r:.3} 0 1 0 "), piece.to)
        }
        CurveShape::Spline(spline) => bezier(spline).iter().try_for_each(|[p, q, to]| {
            at(out, "C", *p)?;
            at(out, " ", *q)?;
            at(out, " ", *to)
        }),
    }
}

/// The cubic curves of a clamped cubic B-spline, each without its first point: every inner knot is inserted until it is
/// threefold (Boehm 1980).
fn bezier(spline: &BSpline) -> Vec<[[f64; 3]; 3]> {
    let (mut knots, mut controls) = (spline.knots.clone(), spline.controls.clone());
    let mut k = 4;
    while k + 4 < knots.len() {
        let u = knots[k];
        let held = knots[k..].iter().take_while(|&&x| x == u).count();
        for have in held..3 {
            insert(&mut knots, &mut controls, k + have - 1, u);
        }
        k += held.max(3);
    }
    controls.get(1..).unwrap_or_default().chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect()
}

/// Inserts a knot after the one at `last`, the last of those that are not greater.
fn insert(knots: &mut Vec<f64>, controls: &mut Vec<[f64; 3]>, last: usize, u: f64) {
    let new = |i: usize| {
        let share = (u - knots[i]) / (knots[i + 3] - knots[i]);
        [0, 1, 2].map(|a| (1.0 - share) * controls[i - 1][a] + share * controls[i][a])
    };
    // Where the knot stands `m` times already, `m` controls less change.
    let held = knots[..=last].iter().rev().take_while(|&&x| x == u).count();
    let changed: Vec<[f64; 3]> = (last - 2..=last - held).map(new).collect();
    controls.splice(last - 2..last - held, changed);
    knots.insert(last + 1, u);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splines_are_the_curves_they_are_drawn_as() {
        let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.5, 3.0, 3.0, 3.0, 3.0];
        let controls: Vec<[f64; 3]> =
            [[0.0, 0.0], [1.0, 2.0], [2.0, -1.0], [4.0, 1.0], [5.0, 5.0], [7.0, 0.0]]
                .map(|[x, y]| [x, y, 0.0])
                .into();
        let spline = BSpline { degree: 3, knots, controls, periodic: false };
        let pieces = bezier(&spline);
        assert_eq!(pieces.len(), 3);
        let mut from = spline.controls[0];
        for ([low, high], [p, q, to]) in [[0.0, 1.0], [1.0, 2.5], [2.5, 3.0]].into_iter().zip(pieces) {
            for t in [0.0, 0.3, 0.5, 1.0] {
                let s: f64 = 1.0 - t;
                let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
                let drawn =
                    [0, 1].map(|a| [from, p, q, to].iter().zip(weights).map(|(c, w)| c[a] * w).sum::<f64>());
                let wanted = spline.point(low + t * (high - low));
                assert!((drawn[0] - wanted[0]).hypot(drawn[1] - wanted[1]) < 1e-12, "{low} {t}");
            }
            from = to;
        }
    }
}
