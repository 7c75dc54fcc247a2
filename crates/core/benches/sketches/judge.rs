//! A section beside the drawing of its part.

use crate::parts::Part;
use lineament::section::{Contour, CurvePiece, CurveShape, Sections};
use lineament::shapes::{Edge, Outline};

/// What became of a section.
#[derive(Debug)]
pub struct Verdict {
    /// Whether the right edges came out, in their order.
    pub exact: bool,
    /// What came out: a letter a piece.
    #[allow(dead_code, reason = "printed")]
    pub kinds: String,
    /// Distances of the parameters from the true ones, spacings; none unless exact.
    pub offs: Vec<f64>,
    /// Distances of open ends, spacings; none unless exact.
    pub ends: Vec<f64>,
}

/// Least sweep of an arc whose centre and radius are compared, degrees.
const QUARTER_DEG: f64 = 89.0;

/// Compares a section with the outlines of its part, turned by `(cosine, sine)`.
pub fn judge(part: &Part, sections: &Sections, (c, s): (f64, f64)) -> Verdict {
    let contours = &sections.sections[0].contours;
    let kinds: Vec<String> = contours.iter().map(kinds).collect();
    let kinds = kinds.join(" ");
    if part.aslant {
        return Verdict { exact: kinds == "e", kinds, offs: Vec::new(), ends: Vec::new() };
    }
    let back = |p: [f64; 3]| [c * p[0] + s * p[1], c * p[1] - s * p[0]];
    let (mut offs, mut open) = (Vec::new(), Vec::new());
    let mut exact = contours.len() == part.outlines.len();
    for outline in &part.outlines {
        // The contour that has the outline's edges at the least distances.
        let own = contours.iter().filter_map(|contour| Some((matched(outline, contour, &back)?, contour)));
        match own.min_by(|a, b| sum(&a.0).total_cmp(&sum(&b.0))) {
            Some((own, contour)) => {
                offs.extend(own.into_iter().map(|o| o / sections.spacing));
                if !contour.closed {
                    open.extend(ends(outline, contour, &back).into_iter().map(|o| o / sections.spacing));
                }
            }
            None => exact = false,
        }
    }
    // Beyond two spacings these are not the same edges.
    exact &= offs.iter().all(|&o| o < 2.0);
    if !exact {
        (offs, open) = (Vec::new(), Vec::new());
    }
    Verdict { exact, kinds, offs, ends: open }
}

fn sum(offs: &[f64]) -> f64 {
    offs.iter().sum()
}

fn kinds(contour: &Contour) -> String {
    let kinds: String = contour.pieces.iter().map(|p| &p.shape.name()[..1]).collect();
    let circle = contour.pieces.iter().any(|p| p.shape.name() == "circle");
    let kinds = if circle { kinds.replace('c', "o") } else { kinds };
    format!("{}{kinds}", if contour.closed { "" } else { "-" })
}

/// The distances of a contour's pieces from the edges of an outline, over all starts and both ways the least; `None` where kinds or
/// number differ.
fn matched(outline: &Outline, contour: &Contour, back: &dyn Fn([f64; 3]) -> [f64; 2]) -> Option<Vec<f64>> {
    let n = outline.len();
    if n != contour.pieces.len() {
        return None;
    }
    let tried = |start: usize, forward: bool| {
        let mut offs = Vec::new();
        for (k, edge) in outline.iter().enumerate() {
            let i = if forward { (start + k) % n } else { (start + 2 * n - k) % n };
            offs.extend(off(edge, &contour.pieces[i], forward, back)?);
        }
        Some(offs)
    };
    let all = (0..n).flat_map(|start| [(start, true), (start, false)]);
    all.filter_map(|(start, forward)| tried(start, forward)).min_by(|a, b| sum(a).total_cmp(&sum(b)))
}

/// Distances of the open ends.
fn ends(outline: &Outline, contour: &Contour, back: &dyn Fn([f64; 3]) -> [f64; 2]) -> Vec<f64> {
    let n = contour.pieces.len();
    let found = [back(contour.pieces[0].from), back(contour.pieces[n - 1].to)];
    let truth = [outline[0].at(0.0), outline[n - 1].at(1.0)];
    let nearest = |t: &[f64; 2]| found.iter().map(|f| gap(*f, *t)).fold(f64::INFINITY, f64::min);
    truth.iter().map(nearest).collect()
}

fn off(
    edge: &Edge,
    piece: &CurvePiece,
    forward: bool,
    back: &dyn Fn([f64; 3]) -> [f64; 2],
) -> Option<Vec<f64>> {
    let [from, to] = if forward { [piece.from, piece.to] } else { [piece.to, piece.from] }.map(back);
    match (edge, &piece.shape) {
        (Edge::Line([a, b]), CurveShape::Line) => {
            let length = gap(*a, *b);
            let way = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
            let across = |p: [f64; 2]| ((p[0] - a[0]) * way[1] - (p[1] - a[1]) * way[0]).abs();
            let along = (to[0] - from[0]) * way[0] + (to[1] - from[1]) * way[1];
            Some(vec![across(from), across(to), if along > 0.0 { 0.0 } else { length }])
        }
        (Edge::Arc { centre, radius, sweep, .. }, CurveShape::Arc { centre: c, radius: r, sweep_deg }) => {
            let [from_off, to_off] = [from, to].map(|p| (gap(p, *centre) - radius).abs());
            if sweep.abs() * 360.0 < QUARTER_DEG {
                return Some(vec![from_off, to_off]);
            }
            let turned = (sweep_deg.abs() - sweep.abs() * 360.0).abs().to_radians() * radius;
            // Tangent points are known along the curve to a few spacings only.
            Some(vec![gap(back(*c), *centre), (r - radius).abs(), turned * 0.1])
        }
        (Edge::Arc { centre, radius, sweep, .. }, CurveShape::Circle { centre: c, radius: r })
            if sweep.abs() == 1.0 =>
        {
            Some(vec![gap(back(*c), *centre), (r - radius).abs()])
        }
        _ => None,
    }
}

fn gap(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
