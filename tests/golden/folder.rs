//! A temporary folder for each growth, into which `dapple` writes.

use assert_cmd::Command;
use std::collections::BTreeMap;
use std::path::Path;
use tempfile::TempDir;

/// A folder that is deleted when it is dropped.
pub struct Folder(TempDir);

impl Folder {
    pub fn with(document: &str) -> Self {
        let folder = Self(tempfile::tempdir().unwrap());
        std::fs::write(folder.0.path().join("a.dapple"), document).unwrap();
        folder
    }

    /// Runs `dapple` with these arguments and this `solver`; returns its output.
    #[track_caller]
    pub fn dapple(&self, arguments: &str, solver: &str) -> Vec<u8> {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
        command.current_dir(self.0.path()).args(arguments.split_whitespace()).env("DAPPLE_SOLVER", solver);
        command.assert().success().get_output().stdout.clone()
    }

    /// The message with which `dapple` refuses these arguments with code 1.
    #[track_caller]
    pub fn refused(&self, arguments: &str) -> String {
        let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
        command.current_dir(self.0.path()).args(arguments.split_whitespace());
        String::from_utf8(command.assert().code(1).get_output().stderr.clone()).unwrap()
    }

    /// Every file in it and in its folders, by name.
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let mut files = BTreeMap::new();
        read(self.0.path(), "", &mut files);
        files
    }
}

fn read(folder: &Path, within: &str, files: &mut BTreeMap<String, Vec<u8>>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = format!("{within}{}", path.file_name().unwrap().to_str().unwrap());
        if path.is_dir() {
            read(&path, &format!("{name}/"), files);
        } else {
            files.insert(name, std::fs::read(&path).unwrap());
        }
    }
}
