//! Animated PNG: the acTL chunk gives the number of frames, fcTL chunks their durations.
//!
//! PNG Specification, third edition (W3C), 11.3.6 "Animation".

use std::io::{self, Write};

use png::{BitDepth, ColorType, Compression, Encoder, EncodingError, Filter, SrgbRenderingIntent};

use super::{Film, Show};
use crate::export::Stopped;

/// Writes the frames that `play` passes to its argument.
pub fn write(
    out: impl Write,
    film: &Film,
    play: impl FnOnce(Show) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let count = |n: usize| u32::try_from(n).map_err(|_| io::Error::other(format!("a PNG cannot hold {n}")));
    let mut encoder = Encoder::new(out, count(film.size[0])?, count(film.size[1])?);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    encoder.set_filter(Filter::Paeth);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    encoder.set_animated(count(film.frames)?, u32::from(film.once)).map_err(into_io)?;
    encoder.set_frame_delay(1, film.fps).map_err(into_io)?;
    let mut writer = encoder.write_header().map_err(into_io)?;
    let mut index = 0;
    play(&mut |rgb| {
        index += 1;
        if index == film.frames && film.hold > 0.0 {
            writer.set_frame_delay(film.hundredths(index - 1), 100).map_err(into_io)?;
        }
        Ok(writer.write_image_data(rgb).map_err(into_io)?)
    })?;
    Ok(writer.finish().map_err(into_io)?)
}

fn into_io(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
