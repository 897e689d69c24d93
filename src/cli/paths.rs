//! Checks that no output overwrites an input.

use super::Error;
use crate::files::is_pipe;
use std::path::{Path, PathBuf};

/// Refuses to overwrite the input file, which is called `name` in the usage.
///
/// # Errors
///
/// [`Error::WriteOver`].
pub fn check_apart(name: &str, input: &Path, output: &Path) -> Result<(), Error> {
    // `-` means standard input or standard output, which are not the same file.
    if same_place(input, output) && !is_pipe(input) {
        let (name, file) = (name.to_owned(), output.to_owned());
        return Err(Error::WriteOver { name, output: "--output", file });
    }
    Ok(())
}

/// Refuses to write into the folder of the training sets, where the file would be read as training data.
///
/// # Errors
/// [`Error::Usage`] with the file's name.
pub fn check_not_in_training(training: Option<&Path>, output: &Path) -> Result<(), Error> {
    let folder_of = |path: &Path| resolved(path).parent().map(Path::to_owned);
    if training.is_some_and(|training| folder_of(output) == folder_of(&training.join("any"))) {
        return Err(Error::Usage(format!(
            "--output: found {}, a file in the folder of --training; allowed: another folder",
            output.display()
        )));
    }
    Ok(())
}

/// Whether two paths lead to the same file, for example `a.png` and `./a.png`.
pub fn same_place(a: &Path, b: &Path) -> bool {
    resolved(a) == resolved(b)
}

/// The absolute path without links; the file need not exist.
fn resolved(path: &Path) -> PathBuf {
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    path.canonicalize().unwrap_or_else(|_| folder.join(path.file_name().unwrap_or_default()))
}
