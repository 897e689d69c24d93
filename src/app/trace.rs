//! How long frames and growths took, for whoever asks by `DAPPLE_TRACE=FILE`: one line a frame.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::time::{Duration, Instant};

/// Writes it down, if somebody asked.
pub struct Trace {
    out: Option<BufWriter<File>>,
    began: Instant,
    place: Option<([f32; 2], f32)>,
    marks: usize,
}

impl Trace {
    /// To the file that `DAPPLE_TRACE` names.
    #[must_use]
    pub fn asked() -> Self {
        let file = std::env::var_os("DAPPLE_TRACE").and_then(|path| File::create(path).ok());
        Self { out: file.map(BufWriter::new), began: Instant::now(), place: None, marks: 0 }
    }

    /// A frame: our own work, all of it with drawing by the toolkit, whether something grew.
    pub fn frame(&mut self, own: Duration, all: Option<f32>, growing: bool) {
        let all = all.map_or(0.0, |seconds| 1e3 * seconds);
        self.line(&format!("frame,{:.3},{all:.3},{}", 1e3 * own.as_secs_f64(), u8::from(growing)));
    }

    /// Something happened, and how long it took.
    pub fn event(&mut self, what: &str, took: Duration) {
        self.line(&format!("{what},{:.3}", 1e3 * took.as_secs_f64()));
    }

    /// Where the canvas is now: its corner, and points on the screen a px.
    pub fn canvas(&mut self, corner: [f32; 2], zoom: f32) {
        if self.out.is_some() && self.place != Some((corner, zoom)) {
            self.place = Some((corner, zoom));
            self.line(&format!("canvas,{:.2},{:.2},{zoom:.5}", corner[0], corner[1]));
        }
    }

    /// How many marks there are now.
    pub fn marks(&mut self, marks: usize) {
        if self.out.is_some() && self.marks != marks {
            self.marks = marks;
            self.line(&format!("marks,{marks}"));
        }
    }

    fn line(&mut self, line: &str) {
        if let Some(out) = &mut self.out {
            // A trace that cannot be written must not disturb what is traced.
            let _ = writeln!(out, "{:.3},{line}", 1e3 * self.began.elapsed().as_secs_f64());
            if !line.starts_with("frame") {
                let _ = out.flush();
            }
        }
    }
}
