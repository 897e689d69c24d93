//! Golden files: read, or rewritten on request.

use std::path::{Path, PathBuf};

/// Where the golden files are.
pub fn golden(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests", "golden", name].iter().collect()
}

/// Whether the golden files are to be rewritten.
pub fn renews() -> bool {
    std::env::var_os("REGENERATE").is_some_and(|value| value == "1")
}

/// Writes a golden file, and prints the changes.
pub fn renew(name: &str, bytes: &[u8], changed: &str) {
    std::fs::write(golden(name), bytes).unwrap();
    println!("tests/golden/{name}: {changed}");
}

/// The content of a golden text file; git may have checked it out with the line ends of the platform.
pub fn text(path: &Path) -> String {
    let text = std::fs::read_to_string(path);
    text.unwrap_or_else(|error| panic!("{}: {error}; REGENERATE=1 writes it", path.display()))
        .replace("\r\n", "\n")
}

/// Writes the differing picture for inspection; returns its path.
pub fn kept(name: &str, bytes: &[u8]) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    std::fs::write(&path, bytes).unwrap();
    path.display().to_string()
}
