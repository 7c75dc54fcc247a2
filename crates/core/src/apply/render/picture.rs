//! A picture in memory.

/// Rows of pixels from the top, three bytes for each pixel: red, green, blue (sRGB).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Number of pixels in a row.
    pub width: usize,
    /// Number of rows.
    pub height: usize,
    /// `(height, width, 3)` bytes.
    pub rgb: Vec<u8>,
}

/// A colour as red, green and blue from 0 to 1, in sRGB.
pub(super) type Colour = [f32; 3];

pub(super) const WHITE: Colour = [1.0; 3];

impl Picture {
    /// Lays `colour` over pixel `index` with this opacity, 0 to 1.
    pub(super) fn blend(&mut self, index: usize, colour: Colour, opacity: f32) {
        for (byte, new) in self.rgb[3 * index..3 * index + 3].iter_mut().zip(colour) {
            let old = f32::from(*byte) / 255.0;
            *byte = to_byte(old + (new - old) * opacity);
        }
    }
}

/// A value from 0 to 1 as a byte; values outside are clipped.
pub(super) fn to_byte(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}
