//! A network as an SVG drawing in millimetres: an orthographic view from a given direction, or from the best one.

use super::context::NetworkContext;
use crate::write::encode::polyline::Polylines;
use crate::write::encode::view::{best_view, frame};
use lineament::math::vec3::{dot, sub};
use lineament::{Network, StripKind};
use std::io::{self, Write};

/// The longest side of a drawing whose scale is not given, and its margin, in millimetres.
const SIDE: f64 = 200.0;
const MARGIN: f64 = 5.0;

/// Writes a path for each strip, in groups by kind, and a dot for each node.
pub(super) fn write(out: &mut dyn Write, network: &Network, context: &NetworkContext) -> io::Result<()> {
    let Polylines { vertices, paths } = Polylines::of(network);
    let [right, up] = frame(context.view.unwrap_or_else(|| best_view(&vertices)));
    let origin = vertices.first().copied().unwrap_or_default();
    let flat: Vec<[f64; 2]> =
        vertices.iter().map(|&v| [dot(sub(v, origin), right), -dot(sub(v, origin), up)]).collect();
    let limit =
        |axis: usize, pick: fn(f64, f64) -> f64| flat.iter().map(|p| p[axis]).reduce(pick).unwrap_or(0.0);
    let (low, high) = ([0, 1].map(|a| limit(a, f64::min)), [0, 1].map(|a| limit(a, f64::max)));
    let longest = (high[0] - low[0]).max(high[1] - low[1]);
    let fitting = if longest > 0.0 { SIDE / longest } else { 1.0 };
    let scale = context.millimetres.unwrap_or(fitting);
    let [width, height] = [0, 1].map(|a| (high[a] - low[a]) * scale + 2.0 * MARGIN);
    let place = |i: usize| [0, 1].map(|a| (flat[i][a] - low[a]) * scale + MARGIN);
    write!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}mm\" height=\"{height:.3}mm\" "
    )?;
    writeln!(out, "viewBox=\"0 0 {width:.3} {height:.3}\">")?;
    writeln!(out, "<desc>Feature lines; one unit of the input is {scale:?} mm</desc>")?;
    let kinds = [
        (StripKind::Crease, "crease", "#c81414"),
        (StripKind::Border, "border", "#1440c8"),
        (StripKind::Rounded, "rounded", "#8040a0"),
    ];
    let shown = |kind| kind != StripKind::Rounded || network.strips.iter().any(|s| s.kind == kind);
    for (kind, name, colour) in kinds.into_iter().filter(|k| shown(k.0)) {
        write!(out, "<g id=\"{name}\" fill=\"none\" stroke=\"{colour}\" stroke-width=\"0.35\" ")?;
        writeln!(out, "stroke-linejoin=\"round\" stroke-linecap=\"round\">")?;
        let strips = network.strips.iter().zip(&paths).enumerate();
        for (id, (strip, path)) in strips.filter(|(_, (strip, path))| strip.kind == kind && path.len() > 1) {
            let drawn = if strip.closed { &path[..path.len() - 1] } else { path };
            write!(out, "<path id=\"strip-{id}\" d=\"")?;
            for (i, &vertex) in drawn.iter().enumerate() {
                let [x, y] = place(vertex);
                write!(out, "{}{x:.4},{y:.4}", if i == 0 { "M" } else { " L" })?;
            }
            writeln!(out, "{}\"/>", if strip.closed { " Z" } else { "" })?;
        }
        writeln!(out, "</g>")?;
    }
    writeln!(out, "<g id=\"nodes\" fill=\"#202020\">")?;
    for node in 0..network.nodes.len() {
        let [x, y] = place(node);
        writeln!(out, "<circle id=\"node-{node}\" cx=\"{x:.4}\" cy=\"{y:.4}\" r=\"0.6\"/>")?;
    }
    writeln!(out, "</g>\n</svg>")
}
