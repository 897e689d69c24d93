//! GIF 89a: one palette for all frames; each frame holds only the px that change.
//!
//! CompuServe, "Graphics Interchange Format, version 89a" (1990); repetition by Netscape's extension.

use std::borrow::Cow;
use std::collections::HashMap;
use std::io::{self, Write};

use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::{COLOURS, Film, Show};
use crate::export::Stopped;

/// The index of an unchanged px.
const UNCHANGED: u8 = COLOURS as u8;

/// Writes the frames that `play` passes to its argument.
pub fn write(
    out: impl Write,
    film: &Film,
    play: impl FnOnce(Show) -> Result<(), Stopped>,
) -> Result<(), Stopped> {
    let side = |px: usize| {
        u16::try_from(px).map_err(|_| io::Error::other(format!("a GIF cannot hold a side of {px} px")))
    };
    let [width, height] = [side(film.size[0])?, side(film.size[1])?];
    let mut colours = Colours::new(&film.palette);
    let mut encoder = Encoder::new(out, width, height, &colours.table()).map_err(into_io)?;
    if !film.once {
        encoder.set_repeat(Repeat::Infinite).map_err(into_io)?;
    }
    let (mut index, mut before) = (0, Vec::new());
    play(&mut |rgb| {
        let now: Vec<u8> = rgb.chunks_exact(3).map(|px| colours.nearest([px[0], px[1], px[2]])).collect();
        let (at, size) = changed(&before, &now, film.size);
        let px = |x: usize, y: usize| {
            let i = y * film.size[0] + x;
            if before.get(i) == Some(&now[i]) { UNCHANGED } else { now[i] }
        };
        let part = (at[1]..at[1] + size[1]).flat_map(|y| (at[0]..at[0] + size[0]).map(move |x| (x, y)));
        let part: Vec<u8> = part.map(|(x, y)| px(x, y)).collect();
        let frame = Frame {
            delay: film.hundredths(index),
            dispose: DisposalMethod::Keep,
            transparent: Some(UNCHANGED),
            left: at[0] as u16,
            top: at[1] as u16,
            width: size[0] as u16,
            height: size[1] as u16,
            buffer: Cow::Owned(part),
            ..Frame::default()
        };
        encoder.write_frame(&frame).map_err(into_io)?;
        (index, before) = (index + 1, now);
        Ok(())
    })?;
    encoder.into_inner().map_err(into_io)?;
    Ok(())
}

/// Corner and size of the smallest rectangle with all px that differ; a single px if none differ.
fn changed(before: &[u8], now: &[u8], [width, height]: [usize; 2]) -> ([usize; 2], [usize; 2]) {
    if before.len() != now.len() {
        return ([0, 0], [width, height]);
    }
    let (mut low, mut high) = ([width, height], [0, 0]);
    for (i, _) in before.iter().zip(now).enumerate().filter(|(_, (a, b))| a != b) {
        for (axis, at) in [i % width, i / width].into_iter().enumerate() {
            (low[axis], high[axis]) = (low[axis].min(at), high[axis].max(at + 1));
        }
    }
    if high == [0, 0] { ([0, 0], [1, 1]) } else { (low, [high[0] - low[0], high[1] - low[1]]) }
}

/// The palette, and the nearest palette index of each colour found so far.
struct Colours {
    palette: Vec<[u8; 3]>,
    found: HashMap<[u8; 3], u8>,
}

impl Colours {
    fn new(palette: &[[u8; 3]]) -> Self {
        let palette = palette.iter().copied().take(COLOURS).collect();
        Self { palette, found: HashMap::new() }
    }

    /// All 256 entries of the file's colour table.
    fn table(&self) -> Vec<u8> {
        let mut table = self.palette.concat();
        table.resize(3 * 256, 0);
        table
    }

    fn nearest(&mut self, colour: [u8; 3]) -> u8 {
        let palette = &self.palette;
        *self.found.entry(colour).or_insert_with(|| {
            let far = |other: &[u8; 3]| {
                // The eye is most sensitive to green and least to blue.
                let parts = [0, 1, 2].map(|i| i32::from(other[i]) - i32::from(colour[i]));
                3 * parts[0] * parts[0] + 6 * parts[1] * parts[1] + parts[2] * parts[2]
            };
            let nearest = palette.iter().enumerate().min_by_key(|(_, other)| far(other));
            nearest.map_or(0, |(index, _)| index as u8)
        })
    }
}

fn into_io(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        other => io::Error::other(other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_changed_px_are_written() {
        let before = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0];
        let mut now = before;
        (now[5], now[10]) = (1, 1);
        assert_eq!(changed(&before, &now, [4, 3]), ([1, 1], [2, 2]));
        assert_eq!(changed(&before, &before, [4, 3]), ([0, 0], [1, 1]));
        assert_eq!(changed(&[], &now, [4, 3]), ([0, 0], [4, 3]));
    }

    #[test]
    fn a_colour_of_the_palette_is_kept() {
        let palette: Vec<[u8; 3]> = (0..255).map(|k| [k, 255 - k, k / 2]).collect();
        let mut colours = Colours::new(&palette);
        for (index, colour) in palette.iter().enumerate() {
            assert_eq!(usize::from(colours.nearest(*colour)), index);
        }
    }
}
