//! Lines over the surface: what lies before it solid, what is behind it as the settings say.

use super::drawing::{Layer, Shape};
use super::hidden::stretches;
use super::picture::{Colour, WHITE};
use super::scene::{Color, Hidden, Settings, Style};
use super::slices::Page;
use super::style::{BLACK, ramp, strip_colour, verdict_colour};
use crate::evaluate::{Stretch, Verdict};
use crate::math::vec3::distance;
use crate::network::{Network, Strip, StripKind};

/// Opacity of lines behind the surface.
pub(super) const HIDDEN_OPACITY: f32 = 0.45;
/// Width of dashes and of the gaps between them, in widths of the line; dashes are three widths long, and their round ends reach
/// into the gaps.
const DASHED_WIDTH: f32 = 0.7;
const DASH_GAP: f32 = 2.2;
/// Width of lines that are right, in widths of a strip, so that the others stand out.
const RIGHT_WIDTH: f32 = 0.6;

/// Lines of one colour.
pub(super) struct Group<'a> {
    pub name: String,
    pub colour: Colour,
    /// Width, in widths of a strip.
    pub width: f32,
    /// The lines, and whether each is closed.
    pub lines: Vec<(&'a [[f64; 3]], bool)>,
}

/// Width of a border in a line drawing, in widths of a strip: told from a crease without colours too.
const BORDER_WIDTH: f32 = 1.5;
/// Number of colours of the confidence.
const STEPS: usize = 5;

/// The strips of a network by their kind, or by what the settings colour them by.
pub(super) fn strips<'a>(network: &'a Network, settings: &Settings) -> Vec<Group<'a>> {
    let drawn = settings.style == Style::Lines;
    let mut groups = Vec::new();
    for kind in [StripKind::Rounded, StripKind::Border, StripKind::Crease] {
        let width = if drawn && kind == StripKind::Border { BORDER_WIDTH } else { 1.0 };
        let steps = if settings.color == Color::Confidence { STEPS } else { 1 };
        groups.extend((0..steps).map(|step| {
            let (name, colour) = match settings.color {
                Color::Kind => (kind.name().into(), strip_colour(kind)),
                Color::Ink => (kind.name().into(), BLACK),
                Color::Confidence => {
                    let low = step as f64 / STEPS as f64;
                    (format!("{}-confidence-{low:.1}", kind.name()), ramp((low + 0.5 / STEPS as f64) as f32))
                }
            };
            let at = |s: &Strip| ((s.confidence * STEPS as f64) as usize).min(STEPS - 1);
            let lines = network.strips.iter().filter(|s| s.kind == kind && (steps == 1 || at(s) == step));
            let lines = lines.map(|s| (s.points.as_slice(), s.closed)).collect();
            Group { name, colour, width, lines }
        }));
    }
    groups
}

/// Stretches of lines by the verdict on them, those that are right below the others.
pub(super) fn verdicts(stretches: &[Stretch]) -> Vec<Group<'_>> {
    let group = |verdict: Verdict| {
        let lines = stretches.iter().filter(|s| s.verdict == verdict);
        let width = if verdict == Verdict::Right { RIGHT_WIDTH } else { 1.0 };
        let lines = lines.map(|s| (s.points.as_slice(), false)).collect();
        Group { name: verdict.name().into(), colour: verdict_colour(verdict), width, lines }
    };
    Verdict::ALL.map(group).into()
}

/// The layers of groups, each over those before it, hidden lines below all others; `pen` is the width of a strip, pixels.
pub(super) fn layers(groups: &[Group], page: &Page, pen: f32, settings: &Settings) -> Vec<Layer> {
    let (mut hidden, mut visible) = (Vec::new(), Vec::new());
    let mut halo = Layer { opacity: 0.75, halo: true, ..Layer::new("halo", WHITE) };
    let drawn = settings.style == Style::Lines;
    for group in groups {
        let pen = group.width * pen;
        let mut seen = Layer::new(&group.name, group.colour);
        let mut behind = Layer::new(format!("{}-hidden", group.name), group.colour);
        behind.opacity = if drawn { 1.0 } else { HIDDEN_OPACITY };
        for (points, closed) in &group.lines {
            for stretch in stretches(&page.camera.line(points, *closed), page.surface, page.bias) {
                let points: Vec<[f32; 2]> =
                    stretch.points.iter().map(|p| p.map(|x| x / page.fine as f32)).collect();
                let shape = |points, share, dash| Shape::Line { points, width: share * pen, dash };
                if stretch.visible || settings.hidden == Hidden::Solid {
                    halo.shapes.push(shape(points.clone(), 2.0, None));
                    seen.shapes.push(shape(points, 1.0, None));
                } else if settings.hidden == Hidden::Dashed {
                    behind.shapes.push(shape(points, DASHED_WIDTH, Some([3.0 * pen, DASH_GAP * pen])));
                }
            }
        }
        hidden.push(behind);
        visible.push(seen);
    }
    hidden.push(halo);
    hidden.append(&mut visible);
    hidden
}

/// Segments across the extent of lines without points, at most: the tolerance for lines that lie on a mesh follows from the length of a
/// segment, and straight lines may have few.
const SEGMENTS: f64 = 60.0;

/// The spacing of a [`Scene`](super::Scene) of lines without points, over a mesh of these `(V, 3)` vertices if there are some: the mean
/// length of the segments, or less where these are long.
pub fn lines_spacing(network: &Network, vertices: &[[f64; 3]]) -> f64 {
    let lines = || network.strips.iter().flat_map(|s| s.points.windows(2));
    let lengths = lines().map(|w| distance(w[0], w[1]));
    let mean = lengths.sum::<f64>() / lines().count().max(1) as f64;
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for p in network.strips.iter().flat_map(|s| &s.points).chain(vertices) {
        low = [0, 1, 2].map(|c| low[c].min(p[c]));
        high = [0, 1, 2].map(|c| high[c].max(p[c]));
    }
    let extent = if low[0] <= high[0] { distance(low, high) } else { 0.0 };
    mean.min(extent / SEGMENTS)
}
