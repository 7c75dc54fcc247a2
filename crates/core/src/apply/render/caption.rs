//! The caption under a picture: the meaning of the colours, with counts.

use super::picture::{Colour, Picture};
use super::scene::Scene;
use super::style::{SLICE_COLOUR, node_colour, strip_colour, verdict_colour};
use crate::evaluate::Verdict;
use crate::network::{Network, NodeKind, StripKind};

const TEXT: Colour = [0.25, 0.27, 0.30];
/// Columns and rows of a letter; the last two rows are below the line.
const LETTER: [usize; 2] = [5, 9];

/// Writes the caption into the lower left corner.
pub(super) fn draw(scene: &Scene, picture: &mut Picture) {
    let scale = (picture.width.min(picture.height) / 500).max(1);
    let mut x = 6 * scale;
    let y = picture.height.saturating_sub((LETTER[1] + 5) * scale);
    for (text, swatch) in entries(scene) {
        if let Some(colour) = swatch {
            fill(picture, [x, y + scale], [6 * scale, 6 * scale], colour);
            x += 9 * scale;
        }
        x += write(picture, &text, [x, y], scale) + 10 * scale;
    }
}

/// The texts, each with the colour before it.
fn entries(scene: &Scene) -> Vec<(String, Option<Colour>)> {
    let points = scene.surfels.len();
    let mut entries = Vec::new();
    if points > 0 || scene.verdicts.is_empty() {
        entries.push((counted(points, "point"), None));
    }
    if let Some(network) = scene.network {
        for kind in [StripKind::Crease, StripKind::Border] {
            let count = network.strips.iter().filter(|s| s.kind == kind).count();
            entries.push((counted(count, kind.name()), Some(strip_colour(kind))));
        }
        entries.extend(node_entries(network));
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

fn node_entries(network: &Network) -> impl Iterator<Item = (String, Option<Colour>)> {
    let kinds = [NodeKind::Junction, NodeKind::Corner, NodeKind::End, NodeKind::Apex];
    let counts = kinds.map(|kind| (kind, network.count(kind)));
    let met = counts.into_iter().filter(|&(_, count)| count > 0);
    met.map(|(kind, count)| {
        let name = if kind == NodeKind::Apex && count > 1 { "apice" } else { kind.name() };
        (counted(count, name), Some(node_colour(kind)))
    })
}

fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}

/// Writes letters from `[x, y]`, the upper left corner; returns their width.
fn write(picture: &mut Picture, text: &str, [x, y]: [usize; 2], scale: usize) -> usize {
    let advance = (LETTER[0] + 1) * scale;
    for (i, letter) in text.chars().enumerate() {
        for (row, bits) in glyph(letter).into_iter().enumerate() {
            for column in (0..LETTER[0]).filter(|c| bits >> (LETTER[0] - 1 - c) & 1 == 1) {
                let corner = [x + i * advance + column * scale, y + row * scale];
                fill(picture, corner, [scale, scale], TEXT);
            }
        }
    }
    text.chars().count() * advance
}

fn fill(picture: &mut Picture, [x, y]: [usize; 2], [width, height]: [usize; 2], colour: Colour) {
    for row in y..(y + height).min(picture.height) {
        for column in x..(x + width).min(picture.width) {
            picture.blend(row * picture.width + column, colour, 1.0);
        }
    }
}

/// Rows of a letter, five bits each, the leftmost the highest. Digits and the letters that captions use; others blank.
#[rustfmt::skip]
fn glyph(letter: char) -> [u8; 9] {
    match letter {
        '0' => [0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110, 0, 0],
        '1' => [0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110, 0, 0],
        '2' => [0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111, 0, 0],
        '3' => [0b01110, 0b10001, 0b00001, 0b00110, 0b00001, 0b10001, 0b01110, 0, 0],
        '4' => [0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010, 0, 0],
        '5' => [0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110, 0, 0],
        '6' => [0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110, 0, 0],
        '7' => [0b11111, 0b00001, 0b00010, 0b00100, 0b00100, 0b01000, 0b01000, 0, 0],
        '8' => [0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110, 0, 0],
        '9' => [0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100, 0, 0],
        'a' => [0, 0, 0b01110, 0b00001, 0b01111, 0b10001, 0b01111, 0, 0],
        'b' => [0b10000, 0b10000, 0b11110, 0b10001, 0b10001, 0b10001, 0b11110, 0, 0],
        'c' => [0, 0, 0b01110, 0b10000, 0b10000, 0b10001, 0b01110, 0, 0],
        'd' => [0b00001, 0b00001, 0b01111, 0b10001, 0b10001, 0b10001, 0b01111, 0, 0],
        'e' => [0, 0, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110, 0, 0],
        'f' => [0b00110, 0b01001, 0b01000, 0b11100, 0b01000, 0b01000, 0b01000, 0, 0],
        'g' => [0, 0, 0b01111, 0b10001, 0b10001, 0b10001, 0b01111, 0b00001, 0b01110],
        'h' => [0b10000, 0b10000, 0b10110, 0b11001, 0b10001, 0b10001, 0b10001, 0, 0],
        'i' => [0b00100, 0, 0b01100, 0b00100, 0b00100, 0b00100, 0b01110, 0, 0],
        'j' => [0b00010, 0, 0b00110, 0b00010, 0b00010, 0b00010, 0b00010, 0b10010, 0b01100],
        'l' => [0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110, 0, 0],
        'm' => [0, 0, 0b11010, 0b10101, 0b10101, 0b10101, 0b10101, 0, 0],
        'n' => [0, 0, 0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0, 0],
        'o' => [0, 0, 0b01110, 0b10001, 0b10001, 0b10001, 0b01110, 0, 0],
        'p' => [0, 0, 0b11110, 0b10001, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000],
        'r' => [0, 0, 0b10110, 0b11001, 0b10000, 0b10000, 0b10000, 0, 0],
        's' => [0, 0, 0b01111, 0b10000, 0b01110, 0b00001, 0b11110, 0, 0],
        't' => [0b01000, 0b01000, 0b11110, 0b01000, 0b01000, 0b01001, 0b00110, 0, 0],
        'u' => [0, 0, 0b10001, 0b10001, 0b10001, 0b10011, 0b01101, 0, 0],
        'x' => [0, 0, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001, 0, 0],
        _ => [0; 9],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_a_caption_has_a_glyph() {
        let words = [
            "points",
            "creases",
            "borders",
            "junctions",
            "corners",
            "ends",
            "apices",
            "slices",
            "right",
            "missed",
            "false",
            "0123456789",
        ];
        for letter in words.concat().chars() {
            assert_ne!(glyph(letter), [0; 9], "{letter}");
        }
    }
}
