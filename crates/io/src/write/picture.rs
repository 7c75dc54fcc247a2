//! Pictures as PNG.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use lineament::apply::render::Picture;

use crate::error::Error;
use crate::output::Output;

/// Writes a picture to a file, whole or not at all. `path` must be none of `inputs`.
///
/// # Errors
/// Those of [`Output::create`], and a failed write.
pub fn write_picture(path: &Path, inputs: &[PathBuf], picture: &Picture) -> Result<(), Error> {
    Output::whole(path, inputs, |out| write_picture_to(out, picture))
}

/// Writes a picture to a stream.
///
/// # Errors
/// Those of the stream.
pub fn write_picture_to(out: &mut dyn Write, picture: &Picture) -> io::Result<()> {
    let mut encoder = png::Encoder::new(&mut *out, picture.width as u32, picture.height as u32);
    let color = if picture.alpha.is_some() { png::ColorType::Rgba } else { png::ColorType::Rgb };
    encoder.set_color(color);
    encoder.set_compression(png::Compression::Balanced);
    let mut writer = encoder.write_header()?;
    match &picture.alpha {
        None => writer.write_image_data(&picture.rgb)?,
        Some(alpha) => {
            let pixels = picture.rgb.chunks_exact(3).zip(alpha);
            let rgba: Vec<u8> = pixels.flat_map(|(rgb, &a)| [rgb[0], rgb[1], rgb[2], a]).collect();
            writer.write_image_data(&rgba)?;
        }
    }
    writer.finish()?;
    out.flush()
}
