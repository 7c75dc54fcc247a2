//! Sections as an SVG sheet in millimetres: the slices side by side at one scale, solid parts tinted, each over its position. Where curves
//! were fitted, arcs and circles are drawn as such and splines as the cubic curves of Bezier that they consist of.

use lineament::curve::BSpline;
use lineament::section::{Contour, CurvePiece, CurveShape, Section, Sections};
use std::io::{self, Write};

/// Width of a sheet or picture whose scale is not given, and the least of a slice's cell on it, millimetres.
const SIDE: f64 = 200.0;
const CELL: f64 = 30.0;
/// Free room around the curves, and room for the line of text below them, millimetres.
const MARGIN: f64 = 4.0;
const TEXT: f64 = 5.0;

/// The curves of a cell: their least corner and extent in the plane, and the millimetres for a unit.
struct Window {
    low: [f64; 2],
    extent: [f64; 2],
    scale: f64,
}

/// Writes all slices on one sheet; `millimetres` for a unit of the input, else as fits.
pub(super) fn write(out: &mut dyn Write, sections: &Sections, millimetres: Option<f64>) -> io::Result<()> {
    let n = sections.sections.len().max(1);
    let columns = (n as f64).sqrt().ceil() as usize;
    let window = Window::of(sections, (SIDE / columns as f64).max(CELL), millimetres);
    let [width, height] = window.cell();
    head(out, [columns as f64 * width, n.div_ceil(columns) as f64 * height], window.scale)?;
    for (k, section) in sections.sections.iter().enumerate() {
        let corner = [(k % columns) as f64 * width, (k / columns) as f64 * height];
        slice(out, sections, section, &window, corner)?;
    }
    writeln!(out, "</svg>")
}

/// Writes one slice alone.
pub(super) fn write_one(
    out: &mut dyn Write,
    sections: &Sections,
    plane: usize,
    millimetres: Option<f64>,
) -> io::Result<()> {
    let window = Window::of(sections, SIDE, millimetres);
    head(out, window.cell(), window.scale)?;
    if let Some(section) = sections.sections.get(plane) {
        slice(out, sections, section, &window, [0.0, 0.0])?;
    }
    writeln!(out, "</svg>")
}

fn head(out: &mut dyn Write, [width, height]: [f64; 2], scale: f64) -> io::Result<()> {
    write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}mm\" height=\"{height:.3}mm\" "
    )?;
    writeln!(out, "viewBox=\"0 0 {width:.3} {height:.3}\">")?;
    writeln!(out, "<desc>Sections; one unit of the input is {scale:?} mm</desc>")?;
    writeln!(out, "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>")
}

fn flat(sections: &Sections, p: [f64; 3]) -> [f64; 2] {
    let [x, y, _] = sections.frame.coordinates(p);
    [x, y]
}

impl Window {
    /// Of all slices alike; where no scale is given the curves fit a cell of this width, and as high.
    fn of(sections: &Sections, width: f64, millimetres: Option<f64>) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for &p in sections.contours().flat_map(|(_, contour)| &contour.points) {
            let p = flat(sections, p);
            for axis in 0..2 {
                low[axis] = low[axis].min(p[axis]);
                high[axis] = high[axis].max(p[axis]);
            }
        }
        let empty = low[0] > high[0];
        let extent = [0, 1].map(|a| if empty { 1.0 } else { (high[a] - low[a]).max(f64::MIN_POSITIVE) });
        let fitting = (width - 2.0 * MARGIN) / extent[0].max(extent[1]);
        Self { low: if empty { [0.0; 2] } else { low }, extent, scale: millimetres.unwrap_or(fitting) }
    }

    /// Width and height of a cell.
    fn cell(&self) -> [f64; 2] {
        let [x, y] = self.extent.map(|extent| extent * self.scale + 2.0 * MARGIN);
        [x.max(CELL), y + TEXT]
    }
}

fn slice(
    out: &mut dyn Write,
    sections: &Sections,
    section: &Section,
    window: &Window,
    corner: [f64; 2],
) -> io::Result<()> {
    let (s, [width, height]) = (window.scale, window.cell());
    let high = window.low[1] + window.extent[1];
    let left = corner[0] + 0.5 * (width - window.extent[0] * s);
    let place = |p: [f64; 3]| {
        let [x, y] = flat(sections, p);
        [left + (x - window.low[0]) * s, corner[1] + MARGIN + (high - y) * s]
    };
    write!(out, "<g id=\"slice_{:04}\"><path fill=\"#dfe8f2\" fill-rule=\"evenodd\" ", section.plane)?;
    write!(out, "stroke=\"#1f4e8c\" stroke-width=\"0.25\" d=\"")?;
    section.contours.iter().filter(|c| c.closed).try_for_each(|c| path(out, c, place))?;
    write!(out, "\"/><path fill=\"none\" stroke=\"#c0392b\" stroke-width=\"0.25\" d=\"")?;
    section.contours.iter().filter(|c| !c.closed).try_for_each(|c| path(out, c, place))?;
    write!(out, "\"/><text x=\"{:.3}\" y=\"{:.3}\" ", corner[0] + 2.0, corner[1] + height - 1.5)?;
    write!(out, "font-family=\"sans-serif\" font-size=\"2.8\">")?;
    write!(out, "{}: {}", section.plane, rounded(section.height - sections.zero.1))?;
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
        write!(out, "{command}{x:.4} {y:.4}")
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
    let radius_of = |centre: [f64; 3], to: [f64; 3]| {
        let ([x, y], [u, v]) = (place(centre), place(to));
        (x - u).hypot(y - v)
    };
    let radius = |centre| radius_of(centre, piece.from);
    match &piece.shape {
        CurveShape::Line => at(out, "L", piece.to),
        CurveShape::Arc { centre, sweep_deg, .. } => {
            let (r, large, forward) =
                (radius(*centre), u8::from(sweep_deg.abs() > 180.0), u8::from(*sweep_deg < 0.0));
            at(out, &format!("A{r:.4} {r:.4} 0 {large} {forward} "), piece.to)
        }
        CurveShape::Circle { centre, .. } => {
            let r = radius(*centre);
            let across = [0, 1, 2].map(|k| 2.0 * centre[k] - piece.from[k]);
            at(out, &format!("A{r:.4} {r:.4} 0 1 0 "), across)?;
            at(out, &format!("A{r:.4} {r:.4} 0 1 0 "), piece.to)
        }
        CurveShape::Ellipse { ellipse, sweep_deg } => {
            let [[x, y], [u, v]] = [ellipse.centre, ellipse.at(0.0)].map(place);
            let (a, turn) = ((u - x).hypot(v - y), (v - y).atan2(u - x).to_degrees());
            let b = radius_of(ellipse.centre, ellipse.at(std::f64::consts::FRAC_PI_2));
            // In two halves: the ends of a whole one are the same.
            let first = ellipse.angle(piece.from);
            let middle = ellipse.at(first + 0.5 * sweep_deg.to_radians());
            let forward = u8::from(*sweep_deg < 0.0);
            at(out, &format!("A{a:.4} {b:.4} {turn:.4} 0 {forward} "), middle)?;
            at(out, &format!("A{a:.4} {b:.4} {turn:.4} 0 {forward} "), piece.to)
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
