//! The caption under a picture: the meaning of the colours, with counts.

use super::drawing::letters::{ADVANCE, HEIGHT};
use super::drawing::{Drawing, Layer, Shape, Text};
use super::picture::Colour;
use super::scene::{Color, Scene, Settings, Style};
use super::style::{SLICE_COLOUR, node_colour, ramp, strip_colour, verdict_colour};
use crate::evaluate::Verdict;
use crate::network::{Network, NodeKind, StripKind};

/// Writes the caption into the lower left corner; `scale` is the pixels of a dot of a letter.
pub(super) fn draw(scene: &Scene, settings: &Settings, drawing: &mut Drawing, scale: usize) {
    let mut x = 6 * scale;
    let y = drawing.height.saturating_sub((HEIGHT + 5) * scale);
    for (i, (text, swatch)) in entries(scene, settings).into_iter().enumerate() {
        if let Some(colour) = swatch {
            let mut layer = Layer::new(format!("swatch-{i}"), colour);
            let corner = [x as f32, (y + scale) as f32];
            layer.shapes.push(Shape::Box { corner, size: [(6 * scale) as f32; 2] });
            drawing.layers.push(layer);
            x += 9 * scale;
        }
        let corner = [x as f32, y as f32];
        x += (text.chars().count() * ADVANCE + 10) * scale;
        drawing.texts.push(Text { corner, scale, text });
    }
}

/// The texts, each with the colour before it.
fn entries(scene: &Scene, settings: &Settings) -> Vec<(String, Option<Colour>)> {
    let points = scene.surfels.len();
    let mut entries = Vec::new();
    let alone = scene.verdicts.is_empty() && scene.network.is_none() && scene.mesh.is_none();
    if points > 0 || alone {
        entries.push((counted(points, "point"), None));
    }
    if let Some(network) = scene.network {
        for kind in [StripKind::Crease, StripKind::Border, StripKind::Rounded] {
            let count = network.strips.iter().filter(|s| s.kind == kind).count();
            if kind == StripKind::Rounded && count == 0 {
                continue;
            }
            let swatch = (settings.color == Color::Kind).then(|| strip_colour(kind));
            let name = if kind == StripKind::Rounded { "rounded edge" } else { kind.name() };
            entries.push((counted(count, name), swatch));
        }
        if settings.color == Color::Confidence {
            let steps = [("confidence 0", 0.1), ("0.5", 0.5), ("1", 0.9)];
            entries.extend(steps.map(|(text, at)| (text.to_string(), Some(ramp(at)))));
        }
        let drawn = |kind| settings.style == Style::Shaded || kind == NodeKind::Apex;
        entries.extend(node_entries(network, drawn));
    }
    let planes = scene.slices.chunk_by(|a, b| a.plane == b.plane).count();
    if planes > 0 {
        entries.push((counted(planes, "slice"), Some(SLICE_COLOUR)));
    }
    if !scene.verdicts.is_empty() {
        entries.extend(Verdict::ALL.map(|verdict| {
            let count = scene.verdicts.iter().filter(|s| s.verdict == verdict).count();
            (format!("{count} {}", verdict.name()), Some(verdict_colour(verdict)))
        }));
    }
    entries
}

fn node_entries(
    network: &Network,
    drawn: impl Fn(NodeKind) -> bool,
) -> impl Iterator<Item = (String, Option<Colour>)> {
    let kinds = [NodeKind::Junction, NodeKind::Corner, NodeKind::End, NodeKind::Apex];
    let counts = kinds.map(|kind| (kind, network.count(kind)));
    let met = counts.into_iter().filter(move |&(kind, count)| count > 0 && drawn(kind));
    met.map(|(kind, count)| {
        let name = if kind == NodeKind::Apex && count > 1 { "apice" } else { kind.name() };
        (counted(count, name), Some(node_colour(kind)))
    })
}

fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
