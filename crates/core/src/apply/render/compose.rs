//! Puts a picture together: surface, dots, hidden lines, visible lines, outlines, nodes, caption.

use super::camera::{Camera, View};
use super::depth_buffer::DepthBuffer;
use super::drawing::cells::{Cell, cells};
use super::drawing::{Drawing, Text, bar, cover, nodes, raster, silhouette};
use super::lines;
use super::picture::Picture;
use super::scene::{Scene, Settings, Style};
use super::slices::{self, Page};
use super::style::LINE_BIAS;
use super::surfel::Projected;
use super::{best, caption, tone, triangles};
use crate::apply::shown::Shown;
use crate::error::Error;
use crate::parallel;

/// Pixels of the surface for each pixel of the picture, in either direction; their average gives smooth outlines.
const FINE: usize = 2;

/// Draws a scene. The picture depends on the scene and the settings only, not on the number of threads.
///
/// # Errors
/// Those of [`Settings::check`] and [`Scene::check`].
pub fn render(scene: &Scene, settings: &Settings) -> Result<Picture, Error> {
    let (drawing, mut picture) = sheet(scene, settings)?;
    raster::paint(&drawing, &mut picture);
    Ok(picture)
}

/// The shapes of a line drawing, for vectors: those that [`render`] paints with [`Style::Lines`].
///
/// # Errors
/// As [`render`].
pub fn draw(scene: &Scene, settings: &Settings) -> Result<Drawing, Error> {
    Ok(sheet(scene, &Settings { style: Style::Lines, ..settings.clone() })?.0)
}

/// The shapes of all views, and the surface below them.
fn sheet(scene: &Scene, settings: &Settings) -> Result<(Drawing, Picture), Error> {
    settings.check()?;
    scene.check()?;
    let (width, height) = (settings.width, settings.height);
    let cells = cells(settings.views.len(), width, height);
    let cameras: Vec<Camera> =
        settings.views.iter().zip(&cells).map(|(&view, cell)| aim(scene, settings, view, cell)).collect();
    let scale = cameras.iter().map(|c| c.scale).fold(f64::INFINITY, f64::min);
    let letter = (width.min(height) / 500).max(1);
    let mut drawing = Drawing {
        width,
        height,
        scale: scale / FINE as f64,
        transparent: settings.transparent,
        ..Drawing::default()
    };
    let mut picture = Picture::empty(width, height, settings.transparent);
    for ((mut camera, cell), &view) in cameras.into_iter().zip(&cells).zip(&settings.views) {
        camera.scale = scale;
        let (mut shapes, surface) = one(scene, settings, camera, cell);
        if cells.len() > 1 {
            let corner = [(6 * letter) as f32, (4 * letter) as f32];
            shapes.texts.push(Text { corner, scale: letter, text: view.name() });
        }
        drawing.place(shapes, cell.corner);
        if let Some(surface) = surface {
            picture.place(&surface, cell.corner);
        }
    }
    if settings.caption {
        caption::draw(scene, settings, &mut drawing, letter);
    }
    if let Some(unit) = &settings.scale_bar {
        bar::draw(&mut drawing, unit, letter);
    }
    Ok((drawing, picture))
}

/// One view: its shapes, and the shaded surface if it is drawn.
fn one(scene: &Scene, settings: &Settings, camera: Camera, cell: &Cell) -> (Drawing, Option<Picture>) {
    let [width, height] = cell.size;
    let (facets, surface) = surface(scene, &camera, [width * FINE, height * FINE]);
    let spacing = (scene.spacing * camera.scale) as f32;
    let pen = (width.min(height) as f32 / 420.0).clamp(1.5, 8.0);
    let page = Page { camera: &camera, surface: &surface, fine: FINE, bias: bias(spacing) };
    let mut drawing = Drawing { width, height, ..Drawing::default() };
    let picture = (settings.style == Style::Shaded).then(|| {
        let dots = if scene.mesh.is_some() { 0.0 } else { spacing };
        let fine = tone::shaded(&facets, &surface, dots);
        let tints = (!scene.tints.is_empty() && scene.mesh.is_none()).then_some(scene.tints);
        tone::averaged(&fine, &surface, tints, FINE, settings.transparent)
    });
    drawing.layers.push(slices::layer(scene.slices, &page, pen));
    let mut groups = scene.network.map_or(Vec::new(), |network| lines::strips(network, settings));
    groups.extend(lines::verdicts(scene.verdicts));
    let mut layers = lines::layers(&groups, &page, pen, settings);
    if settings.style == Style::Lines {
        let outlines = silhouette::lines(&surface, &facets, spacing.max(1.0));
        let outlines = cover::beside(outlines, &layers, &page, spacing / FINE as f32 + pen, pen);
        drawing.layers.push(outlines);
        cover::behind(&mut layers, width, height, pen.max(0.5 * spacing / FINE as f32));
    }
    drawing.layers.extend(layers.into_iter().filter(|l| !l.halo || picture.is_some()));
    if let Some(network) = scene.network {
        let nodes = nodes::layers(network, &page, pen, settings);
        drawing.layers.extend(nodes.into_iter().filter(|l| !l.halo || picture.is_some()));
    }
    drawing.layers.retain(|l| !l.shapes.is_empty());
    (drawing, picture)
}

/// The surface on a grid of pixels, with its facets: the triangles of the mesh, or the discs of the points.
fn surface(scene: &Scene, camera: &Camera, [width, height]: [usize; 2]) -> (Vec<Projected>, DepthBuffer) {
    match scene.mesh {
        Some(mesh) => triangles::draw(mesh, camera, width, height),
        None => {
            let facets =
                parallel::map(scene.surfels.len(), parallel::QUICK, |i| scene.surfels[i].project(camera));
            let surface = DepthBuffer::draw(&facets, width, height);
            (facets, surface)
        }
    }
}

/// The camera that sees the whole scene, on the grid of the fine surface.
fn aim(scene: &Scene, settings: &Settings, view: View, cell: &Cell) -> Camera {
    let from = match view {
        View::Best => best::direction(scene, settings),
        View::From(from) => from,
    };
    let [width, height] = cell.size.map(|side| (side * FINE) as f64);
    let strips = scene.network.into_iter().flat_map(|n| n.strips.iter().flat_map(|s| s.points.iter()));
    let lines = strips.chain(scene.slices.iter().flat_map(|slice| slice.points));
    let lines = lines.chain(scene.verdicts.iter().flat_map(|stretch| &stretch.points));
    let surface: Vec<[f64; 3]> = scene.surface().filter(|p| p.iter().all(|x| x.is_finite())).collect();
    let shown = Shown::around(&surface);
    let near = surface.into_iter().filter(|&p| shown.holds(p));
    let finite = near.chain(lines.copied().filter(|p| p.iter().all(|x| x.is_finite())));
    Camera::looking(from, settings.up).fitted(finite, width, height, 0.05 * width.min(height))
}

/// Greatest depth behind the surface at which a line still counts as visible, pixels of the fine grid.
fn bias(spacing: f32) -> f32 {
    LINE_BIAS as f32 * spacing + 2.0
}
