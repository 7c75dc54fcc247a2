//! The scene that is drawn, and the settings of the picture.

use super::camera::View;
use super::surfel::Surfel;
use crate::error::Error;
use crate::evaluate::Stretch;
use crate::math::vec3::norm;
use crate::network::Network;

/// Least and greatest side of a picture in pixels.
const SIDES: std::ops::RangeInclusive<usize> = 16..=16_384;

/// Most views on one sheet.
const MOST_VIEWS: usize = 16;

/// The contents of a picture.
#[derive(Clone, Copy, Debug, Default)]
pub struct Scene<'a> {
    /// The points, world frame.
    pub surfels: &'a [Surfel],
    /// Colours of the surface, one for each surfel: red, green and blue from 0 to 1. Empty for a white one.
    pub tints: &'a [[f32; 3]],
    /// A mesh that is the surface in place of the points, world frame, if any.
    pub mesh: Option<Triangles<'a>>,
    /// The lines to draw over them, world frame, if any.
    pub network: Option<&'a Network>,
    /// The outlines of its sections to draw over them, world frame, if any.
    pub slices: &'a [Slice<'a>],
    /// What was found rightly, missed, or found falsely, to draw over them, world frame, if lines were evaluated.
    pub verdicts: &'a [Stretch],
    /// Mean distance of neighbouring points, in the unit of the points. Lines up to 2.5 spacings below the surface
    /// still count as visible.
    pub spacing: f64,
}

/// A mesh of triangles.
#[derive(Clone, Copy, Debug)]
pub struct Triangles<'a> {
    /// `(V, 3)` f64, world frame.
    pub vertices: &'a [[f64; 3]],
    /// `(T, 3)` vertices of each triangle, in either sense.
    pub triangles: &'a [[u32; 3]],
}

/// The outline of a section.
#[derive(Clone, Copy, Debug)]
pub struct Slice<'a> {
    /// The number of its plane.
    pub plane: usize,
    /// Its points in order, world frame.
    pub points: &'a [[f64; 3]],
    /// Whether the last point is joined to the first.
    pub closed: bool,
}

/// The settings of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The directions of view, one at least: those of several stand on one sheet, all of one scale.
    pub views: Vec<View>,
    /// The surface with its lines, or the lines alone.
    pub style: Style,
    /// What becomes of lines behind the surface.
    pub hidden: Hidden,
    /// What the colours of lines tell.
    pub color: Color,
    /// Whether the ground is transparent instead of white.
    pub transparent: bool,
    /// A scale bar, and the unit that it names (empty for none); `None` for no bar.
    pub scale_bar: Option<String>,
    /// The world direction that points up in the picture, of any length.
    pub up: [f64; 3],
    /// Width of the picture in pixels, 16 to 16,384.
    pub width: usize,
    /// Height of the picture in pixels, 16 to 16,384.
    pub height: usize,
    /// Whether a line of text explains the colours.
    pub caption: bool,
}

/// What is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Style {
    /// The shaded surface, lines and nodes over it.
    #[default]
    Shaded,
    /// A line drawing: lines, the outlines of the surface, and peaks.
    Lines,
}

/// What becomes of lines behind the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hidden {
    /// They are left out.
    None,
    /// They are thinner and dashed.
    #[default]
    Dashed,
    /// They are drawn as if nothing hid them.
    Solid,
}

/// What the colours of lines tell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Color {
    /// Crease or border.
    #[default]
    Kind,
    /// The confidence in the line, from violet (0) to yellow (1).
    Confidence,
    /// Nothing: they are black.
    Ink,
}

/// Extents of the points within which lines must lie: a stroke takes time and memory for its length in pixels.
const FAR: f64 = 1e4;

impl Scene<'_> {
    /// Checks that the lines lie near the points, and that tints and triangles fit them.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a triangle without its vertices, for tints of another number than the points, and for a network or slices with a point farther from the points than ten thousand of their extents.
    pub fn check(&self) -> Result<(), Error> {
        if let Some(odd) = self.mesh.and_then(|mesh| mesh.odd()) {
            let expected = "vertices that the mesh has".into();
            return Err(Error::Parameter { key: "mesh".into(), value: format!("{odd:?}"), expected });
        }
        if !self.tints.is_empty() && self.tints.len() != self.surfels.len() {
            let (value, expected) = (self.tints.len().to_string(), format!("{}", self.surfels.len()));
            return Err(Error::Parameter { key: "tints".into(), value, expected });
        }
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for position in self.surface() {
            for axis in 0..3 {
                low[axis] = low[axis].min(position[axis]);
                high[axis] = high[axis].max(position[axis]);
            }
        }
        let reach = FAR * (0..3).map(|a| high[a] - low[a]).fold(self.spacing, f64::max);
        let far = |p: &&[f64; 3]| !(0..3).all(|a| low[a] - reach <= p[a] && p[a] <= high[a] + reach);
        let lines = self.network.into_iter().flat_map(|network| {
            let strips = network.strips.iter().flat_map(|strip| &strip.points);
            strips.chain(network.nodes.iter().map(|node| &node.position))
        });
        let lines = lines.chain(self.slices.iter().flat_map(|slice| slice.points));
        let mut points = lines.chain(self.verdicts.iter().flat_map(|stretch| &stretch.points));
        match points.find(far) {
            Some(point) if self.surface().next().is_some() => Err(Error::Parameter {
                key: "network".into(),
                value: format!("{point:?}"),
                expected: format!("lines of these points, which lie from {low:?} to {high:?}"),
            }),
            _ => Ok(()),
        }
    }
}

impl<'a> Scene<'a> {
    /// The places of the surface: those of the points, and the vertices of the mesh.
    pub(super) fn surface(&self) -> impl Iterator<Item = [f64; 3]> + use<'a> {
        let vertices = self.mesh.map_or(&[][..], |mesh| mesh.vertices);
        self.surfels.iter().map(|s| s.position).chain(vertices.iter().copied())
    }
}

impl Triangles<'_> {
    /// A triangle with a vertex that there is not.
    fn odd(&self) -> Option<[u32; 3]> {
        self.triangles.iter().copied().find(|t| t.iter().any(|&v| v as usize >= self.vertices.len()))
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            views: vec![View::Best],
            style: Style::Shaded,
            hidden: Hidden::Dashed,
            color: Color::Kind,
            transparent: false,
            scale_bar: None,
            up: [0.0, 0.0, 1.0],
            width: 1600,
            height: 1200,
            caption: true,
        }
    }
}

impl Settings {
    /// Checks that a picture can be drawn with these settings.
    ///
    /// # Errors
    /// [`Error::Parameter`] if the width or height is outside its range, `up` or a view has no direction, or there are
    /// no views or more than 16.
    pub fn check(&self) -> Result<(), Error> {
        for (key, side) in [("width", self.width), ("height", self.height)] {
            if !SIDES.contains(&side) {
                let expected = format!("{} to {} pixels", SIDES.start(), SIDES.end());
                return Err(Error::Parameter { key: key.into(), value: side.to_string(), expected });
            }
        }
        if !(1..=MOST_VIEWS).contains(&self.views.len()) {
            let (value, expected) = (self.views.len().to_string(), format!("1 to {MOST_VIEWS} views"));
            return Err(Error::Parameter { key: "views".into(), value, expected });
        }
        let from = |view: &View| if let View::From(from) = view { *from } else { [1.0; 3] };
        let views = self.views.iter().map(|view| ("view", from(view)));
        for (key, vector) in [("up", self.up)].into_iter().chain(views) {
            let length = norm(vector);
            if !(length.is_finite() && length > 0.0) {
                let expected = "a direction: three finite numbers, not all zero".into();
                return Err(Error::Parameter { key: key.into(), value: format!("{vector:?}"), expected });
            }
        }
        Ok(())
    }
}
