//! A temporary folder for each test.

use assert_cmd::Command;
use std::path::PathBuf;
use tempfile::TempDir;

/// Two long spots and a round one on a seamless canvas of 128 × 96 px.
pub const SPOTS: &str = r#"{"format": "dapple", "version": 1, "name": "a <b> & \"c\"", "size": [128, 96], "edges": "wrap",
    "layers": [{"name": "big spots", "strokes": [
        {"kind": "ellipse", "center": [30, 30], "radii": [9, 6], "angle": 30},
        {"kind": "ellipse", "center": [60, 34], "radii": [9, 6], "angle": 25},
        {"kind": "ellipse", "center": [44, 60], "radii": [8, 7], "angle": 35}]}]}"#;

/// A folder with that document as `a.dapple`.
pub struct Bench(TempDir);

impl Bench {
    pub fn new() -> Self {
        let bench = Self(tempfile::tempdir().unwrap());
        bench.write("a.dapple", SPOTS);
        bench
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn write(&self, name: &str, text: &str) {
        std::fs::write(self.path(name), text).unwrap();
    }

    pub fn text(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    fn dapple(&self, arguments: &str) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
        command.current_dir(self.0.path()).args(arguments.split_whitespace());
        command
    }

    /// Runs `dapple` with these arguments; returns stderr.
    #[track_caller]
    pub fn does(&self, arguments: &str) -> String {
        let output = self.dapple(arguments).assert().success().get_output().clone();
        String::from_utf8(output.stderr).unwrap()
    }

    /// Runs `dapple` with these arguments; asserts that stderr is empty and returns stdout.
    #[track_caller]
    pub fn prints(&self, arguments: &str) -> String {
        let output = self.dapple(arguments).assert().success().get_output().clone();
        assert!(output.stderr.is_empty());
        String::from_utf8(output.stdout).unwrap()
    }

    /// Asserts that `dapple` fails with this code and these words, and writes nothing.
    #[track_caller]
    pub fn refuses(&self, arguments: &str, code: i32, words: &[&str]) {
        let files = || std::fs::read_dir(self.0.path()).unwrap().count();
        let before = files();
        let output = self.dapple(arguments).assert().code(code).get_output().clone();
        let message = String::from_utf8(output.stderr).unwrap();
        for word in words {
            assert!(message.contains(word), "{word} in {message}");
        }
        assert_eq!(files(), before);
    }
}
