//! A temporary folder with documents for each test, in which dapple is run.

use assert_cmd::Command;
use dapple_engine::grid::{Edges, Field};
use serde_json::{Value, json};
use std::path::PathBuf;
use tempfile::TempDir;

/// Area of each mark of [`hexagon`], px².
pub const AREA: f64 = 28.0 * std::f64::consts::PI;
/// Minor ÷ major radius of each mark of [`hexagon`].
pub const ASPECT: f64 = 4.0 / 7.0;
/// Distance between neighbours of [`hexagon`], px.
pub const SPACING: f64 = 26.0;

/// A folder that is deleted when it is dropped.
pub struct Folder(TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    /// A folder that holds this document as `a.dapple`.
    pub fn with(document: &Value) -> Self {
        let folder = Self::new();
        folder.write("a.dapple", &document.to_string());
        folder
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    pub fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Its entries, hidden files too, in order.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// `dapple` with these arguments, started in the folder.
    pub fn dapple(&self, arguments: &str) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
        command.current_dir(self.0.path()).args(arguments.split_whitespace());
        command
    }

    /// Grows `a.dapple` into `a.png`, with these further arguments; returns stderr.
    #[track_caller]
    pub fn grow(&self, more: &str) -> String {
        let output = self.dapple(&format!("grow a.dapple -o a.png {more}")).assert().success();
        let output = output.get_output();
        assert!(output.stdout.is_empty(), "stdout is for what is asked for");
        String::from_utf8(output.stderr.clone()).unwrap()
    }

    /// Asserts that `dapple` fails with this code and a message with these words, and leaves no file behind.
    #[track_caller]
    pub fn refuses(&self, arguments: &str, code: i32, words: &[&str]) {
        let before = self.names();
        let output = self.dapple(arguments).assert().code(code).get_output().clone();
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(message.starts_with("error: ") && message.trim_end().lines().count() == 1, "{message}");
        for word in words {
            assert!(message.contains(word), "{word} in {message}");
        }
        assert_eq!(self.names(), before);
    }

    pub fn json(&self, name: &str) -> Value {
        serde_json::from_slice(&self.bytes(name)).unwrap()
    }

    /// The output of `dapple measure --json` for a picture.
    #[track_caller]
    pub fn measured(&self, name: &str) -> Value {
        let output = self.dapple(&format!("measure {name} --json")).assert().success().get_output().clone();
        serde_json::from_slice(&output.stdout).unwrap()
    }

    /// A written 16-bit gray picture and its sides.
    pub fn gray16(&self, name: &str) -> ([usize; 2], Vec<u16>) {
        match image::open(self.path(name)).unwrap() {
            image::DynamicImage::ImageLuma16(gray) => (sides(gray.dimensions()), gray.into_raw()),
            other => panic!("{name} is {:?}", other.color()),
        }
    }

    /// A written 8-bit gray picture and its sides.
    pub fn gray8(&self, name: &str) -> ([usize; 2], Vec<u8>) {
        match image::open(self.path(name)).unwrap() {
            image::DynamicImage::ImageLuma8(gray) => (sides(gray.dimensions()), gray.into_raw()),
            other => panic!("{name} is {:?}", other.color()),
        }
    }

    /// A written pattern, read as a field of 1 px a cell.
    pub fn pattern(&self, name: &str, edges: Edges) -> Field {
        let ([width, height], values) = self.gray16(name);
        let values = values.into_iter().map(|value| f32::from(value) / 65535.0).collect();
        Field { width, height, cell: [1.0, 1.0], edges, values }
    }
}

fn sides((width, height): (u32, u32)) -> [usize; 2] {
    [width as usize, height as usize]
}

/// A document of one layer with these strokes.
pub fn document(size: [u32; 2], strokes: &Value) -> Value {
    json!({"format": "dapple", "version": 1, "size": size, "layers": [{"strokes": strokes}]})
}

/// An ellipse and its six neighbours, all equal: area [`AREA`], aspect [`ASPECT`], [`SPACING`] apart.
pub fn hexagon([x, y]: [f64; 2], angle: f64) -> Vec<Value> {
    let half = SPACING / 2.0;
    let row = SPACING * 0.75_f64.sqrt();
    let places =
        [[0.0, 0.0], [SPACING, 0.0], [-SPACING, 0.0], [half, row], [-half, row], [half, -row], [-half, -row]];
    let ellipse = |[dx, dy]: [f64; 2]| json!({"kind": "ellipse", "center": [x + dx, y + dy], "radii": [7.0, 4.0], "angle": angle});
    places.map(ellipse).to_vec()
}

/// A document of 128 × 128 px with long spots at 30°.
pub fn spots() -> Value {
    document([128, 128], &json!(hexagon([60.0, 60.0], 30.0)))
}

/// A document with two lines of width 6 at 27° and 33°.
pub fn stripes() -> Value {
    let line = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        json!({"kind": "line", "from": [20.0, 20.0], "to": [20.0 + 70.0 * cos, 20.0 + 70.0 * sin], "width": 6})
    };
    document([160, 128], &json!([line(27.0), line(33.0)]))
}
