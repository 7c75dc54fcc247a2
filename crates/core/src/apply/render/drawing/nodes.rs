//! The nodes of a network as dots, those behind the surface faint.

use super::{Layer, Shape};
use crate::apply::render::hidden::is_visible;
use crate::apply::render::lines::HIDDEN_OPACITY;
use crate::apply::render::picture::WHITE;
use crate::apply::render::scene::{Hidden, Settings, Style};
use crate::apply::render::slices::Page;
use crate::apply::render::style::node_colour;
use crate::network::{Network, NodeKind};

/// The layers of nodes. A line drawing has the peaks alone, as its lines show where they meet.
pub(in crate::apply::render) fn layers(
    network: &Network,
    page: &Page,
    pen: f32,
    settings: &Settings,
) -> Vec<Layer> {
    let all = [NodeKind::Junction, NodeKind::Corner, NodeKind::End, NodeKind::Apex];
    let kinds = if settings.style == Style::Lines { &all[3..] } else { &all[..] };
    let mut layers = Vec::new();
    for seen in [false, true] {
        if !seen && settings.hidden == Hidden::None {
            continue;
        }
        for &kind in kinds {
            let size = if kind == NodeKind::End { 0.75 * pen } else { pen };
            let name = format!("{}{}", kind.name(), if seen { "" } else { "-hidden" });
            let mut rim = Layer { halo: true, ..Layer::new(format!("{name}-rim"), WHITE) };
            let mut dots = Layer::new(name, node_colour(kind));
            let solid = seen || settings.hidden == Hidden::Solid;
            dots.opacity = if solid { 1.0 } else { HIDDEN_OPACITY };
            for node in network.nodes.iter().filter(|n| n.kind == kind) {
                let at = page.camera.project(node.position);
                if is_visible(at, page.surface, page.bias) == seen {
                    let center = [at[0] / page.fine as f32, at[1] / page.fine as f32];
                    let radius = if seen { 1.3 * size } else { 0.9 * size };
                    rim.shapes.extend(seen.then_some(Shape::Dot { center, radius: 1.75 * size }));
                    dots.shapes.push(Shape::Dot { center, radius });
                }
            }
            layers.extend([rim, dots]);
        }
    }
    layers
}
