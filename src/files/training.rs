//! Training sets in a folder.

use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use crate::learn::Folder;
use crate::machine::fs;
use crate::synth::Training;

/// A folder of training sets on the disk.
#[derive(Clone, Debug)]
pub struct TrainingFolder(PathBuf);

impl TrainingFolder {
    /// The folder `path`, which is read when its files are asked for.
    pub fn new(path: impl Into<PathBuf>) -> Self {
        Self(path.into())
    }
}

impl Folder for TrainingFolder {
    fn path(&self) -> &Path {
        &self.0
    }

    fn names(&self) -> io::Result<Vec<String>> {
        let mut names = Vec::new();
        for entry in fs::read_dir(&self.0)? {
            // Files whose names are not UTF-8 do not belong to a training set.
            names.extend(entry?.file_name().into_string());
        }
        Ok(names)
    }

    fn read(&self, name: &str) -> io::Result<Option<Vec<u8>>> {
        match fs::read(self.0.join(name)) {
            Ok(bytes) => Ok(Some(bytes)),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(error),
        }
    }
}

/// The training sets in `folder`; without one, the built-in ones.
#[must_use]
pub fn training(folder: Option<PathBuf>) -> Training {
    folder
        .map_or_else(Training::default, |folder| Training::from_folder(Box::new(TrainingFolder::new(folder))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_files_of_a_folder_are_named_and_read() {
        let at = tempfile::tempdir().unwrap();
        fs::write(at.path().join("a.csv"), "x").unwrap();
        let folder = TrainingFolder::new(at.path());
        assert_eq!(folder.names().unwrap(), ["a.csv"]);
        assert_eq!(folder.read("a.csv").unwrap(), Some(b"x".to_vec()));
        assert_eq!(folder.read("b.csv").unwrap(), None);
        let nowhere = TrainingFolder::new(at.path().join("nowhere"));
        assert_eq!(nowhere.names().unwrap_err().kind(), ErrorKind::NotFound);
    }
}
