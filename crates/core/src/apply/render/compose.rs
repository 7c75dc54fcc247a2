//! Puts a picture together: surface, dots, hidden lines, visible lines, nodes, caption.

use super::camera::{Camera, View};
use super::depth_buffer::DepthBuffer;
use super::hidden::is_visible;
use super::lines::{self, HIDDEN_OPACITY};
use super::picture::{Picture, WHITE};
use super::scene::{Scene, Settings};
use super::slices::{self, Page};
use super::stroke::Mask;
use super::style::{LINE_BIAS, node_colour};
use super::{best, caption, tone};
use crate::error::Error;
use crate::network::{Network, NodeKind};
use crate::parallel;

/// Pixels of the surface for each pixel of the picture, in either direction; their average gives smooth outlines.
const FINE: usize = 2;

/// Draws a scene. The picture depends on the scene and the settings only, not on the number of threads.
///
/// # Errors
/// Those of [`Settings::check`].
pub fn render(scene: &Scene, settings: &Settings) -> Result<Picture, Error> {
    settings.check()?;
    scene.check()?;
    let camera = aim(scene, settings);
    let projected =
        parallel::map(scene.surfels.len(), parallel::QUICK, |i| scene.surfels[i].project(&camera));
    let surface = DepthBuffer::draw(&projected, settings.width * FINE, settings.height * FINE);
    let spacing = (scene.spacing * camera.scale) as f32;
    let fine = tone::shaded(&projected, &surface, spacing);
    let mut picture = tone::averaged(&fine, settings.width, settings.height, FINE);
    let pen = (settings.width.min(settings.height) as f32 / 420.0).clamp(1.5, 8.0);
    let page = Page { camera: &camera, surface: &surface, fine: FINE, bias: bias(spacing) };
    slices::draw(scene.slices, &page, pen, &mut picture);
    if let Some(network) = scene.network {
        lines::draw(&lines::strips(network), &page, pen, &mut picture);
        draw_nodes(network, &camera, &surface, spacing, pen, &mut picture);
    }
    if !scene.verdicts.is_empty() {
        lines::draw(&lines::verdicts(scene.verdicts), &page, pen, &mut picture);
    }
    if settings.caption {
        caption::draw(scene, &mut picture);
    }
    Ok(picture)
}

/// The camera that sees the whole scene, on the grid of the fine surface.
fn aim(scene: &Scene, settings: &Settings) -> Camera {
    let from = match settings.view {
        View::Best => best::direction(scene, settings),
        View::From(from) => from,
    };
    let [width, height] = [settings.width, settings.height].map(|side| (side * FINE) as f64);
    let strips = scene.network.into_iter().flat_map(|n| n.strips.iter().flat_map(|s| s.points.iter()));
    let lines = strips.chain(scene.slices.iter().flat_map(|slice| slice.points));
    let lines = lines.chain(scene.verdicts.iter().flat_map(|stretch| &stretch.points));
    let all = scene.surfels.iter().map(|s| s.position).chain(lines.copied());
    let finite = all.filter(|p| p.iter().all(|x| x.is_finite()));
    Camera::looking(from, settings.up).fitted(finite, width, height, 0.05 * width.min(height))
}

/// Greatest depth behind the surface at which a line still counts as visible, pixels of the fine grid.
fn bias(spacing: f32) -> f32 {
    LINE_BIAS as f32 * spacing + 2.0
}

fn draw_nodes(
    network: &Network,
    camera: &Camera,
    surface: &DepthBuffer,
    spacing: f32,
    pen: f32,
    picture: &mut Picture,
) {
    let bias = bias(spacing);
    for seen in [false, true] {
        for kind in [NodeKind::Junction, NodeKind::Corner, NodeKind::End, NodeKind::Apex] {
            let size = if kind == NodeKind::End { 0.75 * pen } else { pen };
            let mut rim = Mask::new(picture.width, picture.height);
            let mut dots = Mask::new(picture.width, picture.height);
            for node in network.nodes.iter().filter(|n| n.kind == kind) {
                let at = camera.project(node.position);
                if is_visible(at, surface, bias) == seen {
                    let center = [at[0] / FINE as f32, at[1] / FINE as f32];
                    rim.disc(center, if seen { 1.75 * size } else { 0.0 });
                    dots.disc(center, if seen { 1.3 * size } else { 0.9 * size });
                }
            }
            rim.paint(picture, WHITE, if seen { 1.0 } else { 0.0 });
            dots.paint(picture, node_colour(kind), if seen { 1.0 } else { HIDDEN_OPACITY });
        }
    }
}
