//! The scene that is drawn, and the settings of the picture.

use super::camera::View;
use super::surfel::Surfel;
use crate::error::Error;
use crate::evaluate::Stretch;
use crate::math::vec3::norm;
use crate::network::Network;

/// Least and greatest side of a picture in pixels.
const SIDES: std::ops::RangeInclusive<usize> = 16..=16_384;

/// The contents of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The points, world frame.
    pub surfels: &'a [Surfel],
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
    /// The direction of view.
    pub view: View,
    /// The world direction that points up in the picture, of any length.
    pub up: [f64; 3],
    /// Width of the picture in pixels, 16 to 16,384.
    pub width: usize,
    /// Height of the picture in pixels, 16 to 16,384.
    pub height: usize,
    /// Whether a line of text explains the colours.
    pub caption: bool,
}

/// Extents of the points within which lines must lie: a stroke takes time and memory for its length in pixels.
const FAR: f64 = 1e4;

impl Scene<'_> {
    /// Checks that the lines lie near the points.
    ///
    /// # Errors
    /// [`Error::Parameter`] for a network or slices with a point farther from the points than ten thousand of their extents.
    pub fn check(&self) -> Result<(), Error> {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for surfel in self.surfels {
            for axis in 0..3 {
                low[axis] = low[axis].min(surfel.position[axis]);
                high[axis] = high[axis].max(surfel.position[axis]);
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
            Some(point) if !self.surfels.is_empty() => Err(Error::Parameter {
                key: "network".into(),
                value: format!("{point:?}"),
                expected: format!("lines of these points, which lie from {low:?} to {high:?}"),
            }),
            _ => Ok(()),
        }
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self { view: View::Best, up: [0.0, 0.0, 1.0], width: 1600, height: 1200, caption: true }
    }
}

impl Settings {
    /// Checks that a picture can be drawn with these settings.
    ///
    /// # Errors
    /// [`Error::Parameter`] if the width or height is outside its range, or `up` or the view has no direction.
    pub fn check(&self) -> Result<(), Error> {
        for (key, side) in [("width", self.width), ("height", self.height)] {
            if !SIDES.contains(&side) {
                let expected = format!("{} to {} pixels", SIDES.start(), SIDES.end());
                return Err(Error::Parameter { key: key.into(), value: side.to_string(), expected });
            }
        }
        let from = if let View::From(from) = self.view { from } else { [1.0; 3] };
        for (key, vector) in [("up", self.up), ("view", from)] {
            let length = norm(vector);
            if !(length.is_finite() && length > 0.0) {
                let expected = "a direction: three finite numbers, not all zero".into();
                return Err(Error::Parameter { key: key.into(), value: format!("{vector:?}"), expected });
            }
        }
        Ok(())
    }
}
