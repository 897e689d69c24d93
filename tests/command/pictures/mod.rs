//! Pictures in every format, materials, and the document in a PNG: through the real binary, read by other readers.

mod formats;
mod material;
mod restored;
mod seams;

use assert_cmd::Command;
use serde_json::{Value, json};
use std::path::PathBuf;
use tempfile::TempDir;

/// A folder that is deleted when it is dropped, with `a.dapple` in it.
struct Folder(TempDir);

impl Folder {
    fn with(document: &Value) -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        std::fs::write(folder.path("a.dapple"), document.to_string()).unwrap();
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn bytes(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn picture(&self, name: &str) -> image::DynamicImage {
        image::open(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.0.path()).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    fn dapple(&self, arguments: &str) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
        command.current_dir(self.0.path()).args(arguments.split_whitespace());
        command
    }

    #[track_caller]
    fn does(&self, arguments: &str) {
        self.dapple(arguments).assert().success();
    }

    /// Asserts that `dapple` fails with a message of one line that contains these words, and leaves no file behind.
    #[track_caller]
    fn refuses(&self, arguments: &str, code: i32, words: &[&str]) {
        let before = self.names();
        let output = self.dapple(arguments).assert().code(code).get_output().clone();
        let message = String::from_utf8(output.stderr).unwrap();
        for word in words {
            assert!(message.contains(word), "{word} in {message}");
        }
        assert_eq!(self.names(), before);
    }
}

/// A seamless document of long spots, white to black.
fn tile() -> Value {
    let spot =
        |x: f64, y: f64| json!({"kind": "ellipse", "center": [x, y], "radii": [8.0, 5.0], "angle": 30});
    json!({"format": "dapple", "version": 1, "name": "a tile", "size": [120, 96], "edges": "wrap", "layers": [
        {"name": "dots", "strokes": [spot(40.0, 40.0), spot(66.0, 42.0), spot(52.0, 63.0)],
         "colours": {"stops": [{"at": 0, "colour": "#ffffff"}, {"at": 1, "colour": "#000000"}]}}]})
}
