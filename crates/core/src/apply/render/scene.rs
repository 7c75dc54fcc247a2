//! What is drawn and how.

use super::camera::View;
use super::surfel::Surfel;
use crate::error::Error;
use crate::math::vec3::norm;
use crate::network::Network;

/// Pixels that a side of a picture may have.
const SIDES: std::ops::RangeInclusive<usize> = 16..=16_384;

/// What a picture shows.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The points, world frame.
    pub surfels: &'a [Surfel],
    /// The lines to draw over them, world frame, if any.
    pub network: Option<&'a Network>,
    /// Mean distance of neighbouring points, in the unit of the points. Lines up to 2.5 spacings below the surface
    /// still count as visible.
    pub spacing: f64,
}

/// How a picture is taken.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Where the eye is.
    pub view: View,
    /// The world direction that points up in the picture, of any length.
    pub up: [f64; 3],
    /// Width of the picture in pixels, 16 to 16,384.
    pub width: usize,
    /// Height of the picture in pixels, 16 to 16,384.
    pub height: usize,
    /// Whether a line of text says what the colours mean.
    pub caption: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { view: View::Best, up: [0.0, 0.0, 1.0], width: 1600, height: 1200, caption: true }
    }
}

impl Settings {
    /// Whether a picture can be taken with these.
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
