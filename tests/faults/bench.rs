//! A temporary folder with a file of each kind that dapple reads, in which dapple is run.

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

/// A seamless tile of ellipses.
pub const DOCUMENT: &str = r#"{"format": "dapple", "version": 1, "size": [96, 96], "edges": "wrap", "seed": 1,
    "layers": [{"system": "meinhardt-spots", "strokes": [
        {"kind": "ellipse", "center": [30, 30], "radii": [8, 5], "angle": 30},
        {"kind": "ellipse", "center": [56, 36], "radii": [8, 5], "angle": 30},
        {"kind": "ellipse", "center": [40, 60], "radii": [8, 5], "angle": 30}]}]}"#;
const DRAWING: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" width="96" height="96">
    <ellipse cx="30" cy="30" rx="8" ry="5"/><ellipse cx="60" cy="40" rx="8" ry="5"/></svg>"#;
const QUESTIONS: &str = "system,width,angle\nmeinhardt-stripes,8,30\nmeinhardt-stripes,9,60\n";

/// A folder that is deleted when it is dropped.
pub struct Bench(TempDir);

impl Bench {
    /// A folder with `a.dapple`, `b.dapple` (another seed), `in.svg`, `in.csv`.
    pub fn new() -> Self {
        let bench = Self(tempfile::tempdir().unwrap());
        bench.write("a.dapple", DOCUMENT);
        bench.write("b.dapple", &DOCUMENT.replace("\"seed\": 1", "\"seed\": 2"));
        bench.write("in.svg", DRAWING);
        bench.write("in.csv", QUESTIONS);
        bench
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    pub fn folder(&self) -> &Path {
        self.0.path()
    }

    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).unwrap();
    }

    pub fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The command `dapple` with these arguments in the folder.
    pub fn command(&self, arguments: &str) -> Command {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
        command.current_dir(self.folder()).args(arguments.split_whitespace());
        command
    }

    /// The output of the command.
    pub fn run(&self, arguments: &str) -> (Option<i32>, String) {
        printed(&self.command(arguments).output().unwrap())
    }

    #[track_caller]
    pub fn does(&self, arguments: &str) {
        let (code, said) = self.run(arguments);
        assert_eq!(code, Some(0), "{arguments}: {said}");
    }

    /// Asserts that the command ends with this code and with one line that contains these words.
    #[track_caller]
    pub fn refuses(&self, arguments: &str, code: i32, words: &[&str]) {
        let (found, said) = self.run(arguments);
        assert_eq!(found, Some(code), "{arguments}: {said}");
        let errors: Vec<&str> = said.lines().filter(|line| line.starts_with("error: ")).collect();
        assert_eq!(errors.len(), 1, "{arguments}: {said}");
        assert!(words.iter().all(|word| said.contains(word)), "{arguments}: {words:?} in {said}");
        assert!(!said.contains("panicked"), "{said}");
    }
}

/// The exit code and the text on stderr.
pub fn printed(output: &Output) -> (Option<i32>, String) {
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// All files in a folder and its subfolders, by their paths within it.
pub fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    fn into(at: &Path, within: &str, found: &mut BTreeMap<String, Vec<u8>>) {
        for entry in fs::read_dir(at).into_iter().flatten().flatten() {
            let name = format!("{within}{}", entry.file_name().to_string_lossy());
            match entry.path().is_dir() {
                true => into(&entry.path(), &format!("{name}/"), found),
                // The file may have been renamed in the meantime.
                false => drop(fs::read(entry.path()).map(|bytes| found.insert(name, bytes))),
            }
        }
    }
    let mut found = BTreeMap::new();
    into(folder, "", &mut found);
    found
}

/// Whether this is the name of a file that is being written.
pub fn is_part(name: &str) -> bool {
    name.split('/').any(|part| part.starts_with(".dapple-") && part.ends_with(".part"))
}

/// Writes a line to stderr directly, because the test harness would hide it.
pub fn say(line: &str) {
    let _ = std::io::stderr().write_all(format!("{line}\n").as_bytes());
}
