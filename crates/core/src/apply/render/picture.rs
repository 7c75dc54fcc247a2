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
    /// `(height, width)` bytes, 0 where the ground shows through; `None` if the ground is white.
    pub alpha: Option<Vec<u8>>,
}

/// A colour as red, green and blue from 0 to 1, in sRGB.
pub(super) type Colour = [f32; 3];

pub(super) const WHITE: Colour = [1.0; 3];

impl Picture {
    /// A white picture, or a transparent one.
    pub(super) fn empty(width: usize, height: usize, transparent: bool) -> Self {
        let alpha = transparent.then(|| vec![0; width * height]);
        Self { width, height, rgb: vec![255; 3 * width * height], alpha }
    }

    /// Lays `colour` over pixel `index` with this opacity, 0 to 1.
    pub(super) fn blend(&mut self, index: usize, colour: Colour, opacity: f32) {
        if let Some(alpha) = &mut self.alpha {
            let old = f32::from(alpha[index]) / 255.0;
            let new = opacity + old * (1.0 - opacity);
            alpha[index] = to_byte(new);
            // The share of the colour in what is seen there.
            return self.mix(index, colour, if new > 0.0 { opacity / new } else { 0.0 });
        }
        self.mix(index, colour, opacity);
    }

    /// Mixes `colour` into pixel `index`, which lets as much of the ground through as before.
    pub(super) fn lighten(&mut self, index: usize, colour: Colour, opacity: f32) {
        self.mix(index, colour, opacity);
    }

    fn mix(&mut self, index: usize, colour: Colour, share: f32) {
        for (byte, new) in self.rgb[3 * index..3 * index + 3].iter_mut().zip(colour) {
            let old = f32::from(*byte) / 255.0;
            *byte = to_byte(old + (new - old) * share);
        }
    }

    /// Copies a smaller picture to `corner` of this one; what lies outside is cut off.
    pub(super) fn place(&mut self, part: &Picture, [x, y]: [usize; 2]) {
        let wide = part.width.min(self.width.saturating_sub(x));
        for row in 0..part.height.min(self.height.saturating_sub(y)) {
            let (from, to) = (row * part.width, (y + row) * self.width + x);
            self.rgb[3 * to..3 * (to + wide)].copy_from_slice(&part.rgb[3 * from..3 * (from + wide)]);
            if let (Some(own), Some(other)) = (&mut self.alpha, &part.alpha) {
                own[to..to + wide].copy_from_slice(&other[from..from + wide]);
            }
        }
    }
}

/// A value from 0 to 1 as a byte; values outside are clipped.
pub(super) fn to_byte(value: f32) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn on_a_transparent_ground_half_a_colour_is_that_colour_half_opaque() {
        let mut picture = Picture::empty(2, 1, true);
        picture.blend(0, [1.0, 0.0, 0.0], 0.5);
        assert_eq!((&picture.rgb[..3], &picture.alpha), (&[255, 0, 0][..], &Some(vec![128, 0])));
        picture.lighten(1, [0.0; 3], 1.0);
        assert_eq!(picture.alpha, Some(vec![128, 0]));
    }
}
