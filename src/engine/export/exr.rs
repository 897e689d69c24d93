//! OpenEXR: named channels of 32-bit floating point, lossless ZIP compression.
//!
//! Technical Introduction to OpenEXR (Academy Software Foundation). A channel `layer.name` belongs to `layer`.

use std::io::{Seek, Write};
use std::ops::Range;

use exr::block::writer::ChunksWriter;
use exr::block::{BlockIndex, UncompressedBlock};
use exr::compression::Compression;
use exr::error::Error;
use exr::math::Vec2;
use exr::meta::BlockDescription;
use exr::meta::attribute::{ChannelDescription, LineOrder, SampleType, Text};
use exr::meta::header::Header;
use rayon::prelude::*;

use super::Stopped;

/// Rows of one compressed block.
const BLOCK_ROWS: usize = 16;
/// Bytes of one band of rows: enough for all threads, and compressed in less than half a second.
const BAND: usize = 8 << 20;

/// Writes `channels` of `size` px without holding them in memory: `fill` is called for band after band, from the top, and writes
/// the values of the given rows into one slice for each channel, in the order of `channels`. `dpi` is px an inch.
///
/// # Errors
/// The errors of `out` and `fill`; an invalid or repeated channel name; a side of 0 or of 2³¹ px.
pub fn write(
    out: impl Write + Seek,
    size: [usize; 2],
    channels: &[String],
    dpi: Option<f64>,
    mut fill: impl FnMut(Range<usize>, &mut [Vec<f32>]) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let [width, height] = size;
    // The format requires alphabetical order.
    let mut order: Vec<usize> = (0..channels.len()).collect();
    order.sort_by_key(|&channel| channels[channel].as_bytes());
    let header = header(size, channels, &order, dpi)?;
    let rows_a_band = (BAND / (4 * width * channels.len()).max(1)).max(1).next_multiple_of(BLOCK_ROWS);
    let mut stopped = None;
    let written = exr::block::write(out, [header].into_iter().collect(), true, |meta, chunks| {
        let mut planes = vec![Vec::new(); channels.len()];
        for top in (0..height).step_by(rows_a_band) {
            let rows = top..height.min(top + rows_a_band);
            planes.iter_mut().for_each(|plane| plane.resize(rows.len() * width, 0.0));
            if let Err(why) = fill(rows.clone(), &mut planes) {
                stopped = Some(why);
                return Err(Error::Aborted);
            }
            let blocks: Vec<_> = rows.clone().step_by(BLOCK_ROWS).collect();
            let compressed: Vec<_> = blocks
                .into_par_iter()
                .map(|first| {
                    let rows = first - top..(first + BLOCK_ROWS).min(rows.end) - top;
                    let index = BlockIndex {
                        layer: 0,
                        pixel_position: Vec2(0, first),
                        pixel_size: Vec2(width, rows.len()),
                        level: Vec2(0, 0),
                    };
                    let block = UncompressedBlock { index, data: block(rows, width, &order, &planes) };
                    Ok((first / BLOCK_ROWS, block.compress_to_chunk(&meta.headers)?))
                })
                .collect::<Result<_, Error>>()?;
            compressed.into_iter().try_for_each(|(index, chunk)| chunks.write_chunk(index, chunk))?;
        }
        Ok(())
    });
    match (stopped, written) {
        (Some(stopped), _) => Err(stopped),
        (None, written) => Ok(written.map_err(into_io)?),
    }
}

/// The head of the file.
fn header(size: [usize; 2], names: &[String], order: &[usize], dpi: Option<f64>) -> Result<Header, Stopped> {
    let other = |what: String| std::io::Error::other(what);
    if size.iter().any(|side| !(1..i32::MAX as usize).contains(side)) {
        return Err(other(format!("OpenEXR cannot hold a picture of {}×{} px", size[0], size[1])).into());
    }
    let mut channels = Vec::new();
    for &channel in order {
        let name = &names[channel];
        let text = Text::new_or_none(name).filter(|_| (1..256).contains(&name.len()));
        let name = text.ok_or_else(|| other(format!("'{name}' is not a valid OpenEXR channel name")))?;
        if channels.last().is_some_and(|last: &ChannelDescription| last.name == name) {
            return Err(other(format!("two channels have the name '{name}'")).into());
        }
        let sampling = Vec2(1, 1);
        let sample_type = SampleType::F32;
        channels.push(ChannelDescription { name, sample_type, quantize_linearly: false, sampling });
    }
    let name = Text::new_or_none("dapple").unwrap_or_default();
    let header = Header::new(name, (size[0], size[1]), channels.into_iter().collect());
    let mut header =
        header.with_encoding(Compression::ZIP16, BlockDescription::ScanLines, LineOrder::Increasing);
    header.own_attributes.horizontal_density = dpi.map(|dpi| dpi as f32);
    Ok(header)
}

/// The bytes of a block: row by row, and in each row channel by channel.
fn block(rows: Range<usize>, width: usize, order: &[usize], planes: &[Vec<f32>]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(4 * rows.len() * width * order.len());
    for y in rows {
        for &channel in order {
            for value in &planes[channel][y * width..(y + 1) * width] {
                bytes.extend_from_slice(&value.to_ne_bytes());
            }
        }
    }
    bytes
}

fn into_io(error: Error) -> std::io::Error {
    match error {
        Error::Io(error) => error,
        other => std::io::Error::other(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use exr::prelude::{ReadChannels, ReadLayers, read};

    #[test]
    fn channels_are_read_back_exactly() {
        let size = [37, 3001];
        let value =
            |channel: usize, x: usize, y: usize| ((channel + 1) * (x * x + 31 * y)) as f32 / 977.0 - 3.0;
        let names = ["substrate", "activator", "a.b"].map(str::to_owned);
        let mut bytes = std::io::Cursor::new(Vec::new());
        write(&mut bytes, size, &names, Some(300.0), |rows, planes| {
            for (channel, plane) in planes.iter_mut().enumerate() {
                for (row, y) in plane.chunks_mut(size[0]).zip(rows.clone()) {
                    row.iter_mut().enumerate().for_each(|(x, out)| *out = value(channel, x, y));
                }
            }
            Ok(())
        })
        .unwrap();
        let reading = read().no_deep_data().largest_resolution_level().all_channels();
        let reading = reading.first_valid_layer().all_attributes();
        let image = reading.from_buffered(std::io::Cursor::new(bytes.into_inner())).unwrap();
        let layer = image.layer_data;
        assert_eq!((layer.size.0, layer.size.1), (37, 3001));
        assert_eq!(layer.attributes.horizontal_density, Some(300.0));
        for (channel, name) in names.iter().enumerate() {
            let found = layer.channel_data.list.iter().find(|found| found.name.to_string() == *name).unwrap();
            let values: Vec<f32> = found.sample_data.values_as_f32().collect();
            assert_eq!(values.len(), 37 * 3001);
            assert!(values.iter().enumerate().all(|(i, v)| *v == value(channel, i % 37, i / 37)), "{name}");
        }
    }

    #[test]
    fn unsupported_channels_are_an_error() {
        let refused = |size, names: &[&str], fill: fn() -> Result<(), Stopped>| {
            let names: Vec<String> = names.iter().map(|name| (*name).to_owned()).collect();
            write(std::io::Cursor::new(Vec::new()), size, &names, None, |_, _| fill())
        };
        assert!(refused([2, 2], &["a", "b", "a"], || Ok(())).unwrap_err().to_string().contains("'a'"));
        assert!(refused([2, 0], &["a"], || Ok(())).is_err());
        assert!(matches!(refused([2, 2], &["a"], || Err(Stopped::Cancelled)), Err(Stopped::Cancelled)));
    }
}
