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
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Balanced);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&picture.rgb)?;
    writer.finish()?;
    out.flush()
}
