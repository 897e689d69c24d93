//! Golden files: read, or renewed on purpose.

use std::path::{Path, PathBuf};

/// Where the golden files are.
pub fn golden(name: &str) -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests", "golden", name].iter().collect()
}

/// Are the golden files to be written anew?
pub fn renews() -> bool {
    std::env::var_os("REGENERATE").is_some_and(|value| value == "1")
}

/// Writes a golden file, and prints what is new in it.
pub fn renew(name: &str, bytes: &[u8], changed: &str) {
    std::fs::write(golden(name), bytes).unwrap();
    println!("tests/golden/{name}: {changed}");
}

/// What a golden text holds; git may have checked it out with the line ends of the platform.
pub fn text(path: &Path) -> String {
    let text = std::fs::read_to_string(path);
    text.unwrap_or_else(|error| panic!("{}: {error}; REGENERATE=1 writes it", path.display()))
        .replace("\r\n", "\n")
}

/// Keeps what has grown instead, for a look; gives where.
pub fn kept(name: &str, bytes: &[u8]) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    std::fs::write(&path, bytes).unwrap();
    path.display().to_string()
}
