//! A log of the times of frames and growths, for measurements: `DAPPLE_TRACE=FILE` turns it on; one line a frame.

use std::io::{BufWriter, Write};
use std::time::Duration;

use crate::machine::clock::Instant;
use crate::machine::fs::File;

/// Writes the log where it is turned on.
pub struct Trace {
    out: Option<BufWriter<File>>,
    began: Instant,
    place: Option<([f32; 2], f32)>,
    marks: usize,
    /// The dialog that was logged last, and that of the last frame.
    dialog: [&'static str; 2],
}

impl Trace {
    /// Writes to the file that `DAPPLE_TRACE` names.
    #[must_use]
    pub fn asked() -> Self {
        let file = std::env::var_os("DAPPLE_TRACE").and_then(|path| File::create(path).ok());
        Self { out: file.map(BufWriter::new), began: Instant::now(), place: None, marks: 0, dialog: [""; 2] }
    }

    /// Logs a frame: the time of the window's own code, the time of the whole frame in seconds, whether something grew.
    pub fn frame(&mut self, own: Duration, all: Option<f32>, growing: bool) {
        let all = all.map_or(0.0, |seconds| 1e3 * seconds);
        self.line(&format!("frame,{:.3},{all:.3},{}", 1e3 * own.as_secs_f64(), u8::from(growing)));
    }

    /// Logs an event and how long it took.
    pub fn event(&mut self, what: &str, took: Duration) {
        self.line(&format!("{what},{:.3}", 1e3 * took.as_secs_f64()));
    }

    /// Logs the position of the canvas: its upper left corner on the screen, points, and points a px.
    pub fn canvas(&mut self, corner: [f32; 2], zoom: f32) {
        if self.out.is_some() && self.place != Some((corner, zoom)) {
            self.place = Some((corner, zoom));
            self.line(&format!("canvas,{:.2},{:.2},{zoom:.5}", corner[0], corner[1]));
        }
    }

    /// Logs the number of marks.
    pub fn marks(&mut self, marks: usize) {
        if self.out.is_some() && self.marks != marks {
            self.marks = marks;
            self.line(&format!("marks,{marks}"));
        }
    }

    /// Logs which dialog is open, or `none`, once it has been open for two frames and handles keys. Returns whether the
    /// second of these frames is still to come.
    pub fn dialog(&mut self, open: &'static str) -> bool {
        let [logged, last] = self.dialog;
        self.dialog[1] = open;
        if self.out.is_none() || logged == open {
            return false;
        }
        if last == open {
            self.dialog[0] = open;
            self.line(&format!("dialog,{open}"));
        }
        last != open
    }

    fn line(&mut self, line: &str) {
        if let Some(out) = &mut self.out {
            // A log that cannot be written must not disturb the program.
            let _ = writeln!(out, "{:.3},{line}", 1e3 * self.began.elapsed().as_secs_f64());
            if !line.starts_with("frame") {
                let _ = out.flush();
            }
        }
    }
}
