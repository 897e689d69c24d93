//! Frames → a film: [GIF](gif) or [APNG](apng). One frame is held at a time.

pub mod apng;
pub mod gif;
mod median_cut;

pub use median_cut::median_cut;

use super::Stopped;

/// The file name endings of films.
pub const FORMATS: [&str; 3] = ["gif", "png", "apng"];
/// Colours in a GIF: one of the 256 indices means an unchanged px.
pub const COLOURS: usize = 255;

/// The format of a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Graphics Interchange Format, version 89a: 255 colours for all frames, durations in hundredths of a second.
    Gif,
    /// Animated PNG (PNG Specification, third edition): all colours.
    Apng,
    /// `frame-0001.png`, … in a folder.
    Folder,
}

/// The properties of a film.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Width and height of a frame, px; at most 65,535 in a GIF.
    pub size: [usize; 2],
    /// Number of frames.
    pub frames: usize,
    /// Frames a second, 1..1000.
    pub fps: u16,
    /// Extra seconds for the last frame before the film repeats.
    pub hold: f64,
    /// Whether it stops at the last frame instead of repeating.
    pub once: bool,
    /// Up to [`COLOURS`] colours, for a GIF.
    pub palette: Vec<[u8; 3]>,
}

impl Film {
    /// Duration of frame `index` in hundredths of a second. Rounding errors do not accumulate.
    fn hundredths(&self, index: usize) -> u16 {
        let begins = |frame: usize| (100.0 * frame as f64 / f64::from(self.fps)).round();
        let shown = begins(index + 1) - begins(index);
        let held = if index + 1 == self.frames { 100.0 * self.hold } else { 0.0 };
        // The longest duration in a GIF.
        (shown + held).round().min(65_535.0) as u16
    }
}

/// Receives a frame: red, green, blue for each px.
pub type Show<'a> = &'a mut dyn FnMut(&[u8]) -> Result<(), Stopped>;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_errors_do_not_accumulate() {
        let film = Film { size: [1, 1], frames: 31, fps: 30, hold: 2.0, once: false, palette: vec![] };
        let shown: Vec<u16> = (0..30).map(|frame| film.hundredths(frame)).collect();
        assert_eq!((shown[0], shown[1], shown.iter().sum::<u16>()), (3, 4, 100));
        assert_eq!(film.hundredths(30), 203);
    }
}
