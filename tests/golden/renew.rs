//! Reads golden files, or rewrites them on request.

use std::path::{Path, PathBuf};

/// The path of a golden file.
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

/// The content of a golden text file, with unified line ends: git may have checked it out with those of the platform.
pub fn text(path: &Path) -> String {
    let text = std::fs::read_to_string(path);
    text.unwrap_or_else(|error| panic!("{}: {error}; REGENERATE=1 writes it", path.display()))
        .replace("\r\n", "\n")
}

/// Compares a golden text with the newly computed one, line by line.
#[track_caller]
pub fn same_lines(name: &str, fresh: &str) {
    let file = golden(name);
    let stored = if renews() { std::fs::read_to_string(&file).unwrap_or_default() } else { text(&file) };
    let [old, new] = [stored.as_str(), fresh].map(|text| text.lines().collect::<Vec<_>>());
    let differ: Vec<String> = (0..old.len().max(new.len()))
        .filter(|line| old.get(*line) != new.get(*line))
        .map(|line| {
            format!("stored {}\n grown {}", old.get(line).unwrap_or(&""), new.get(line).unwrap_or(&""))
        })
        .collect();
    if renews() && !differ.is_empty() {
        return renew(name, fresh.as_bytes(), &format!("changed\n{}", differ.join("\n")));
    }
    assert!(
        differ.is_empty(),
        "{} lines of tests/golden/{name} differ:\n{}\nIf that is meant: REGENERATE=1",
        differ.len(),
        differ.join("\n")
    );
}

/// The 64-bit FNV-1a hash of the bytes of the values, least significant byte first; then five of the values, among them
/// the first and the last, as bits and as numbers.
pub fn bits(values: &[f32]) -> String {
    let last = values.len() - 1;
    let few = [0, last / 4, last / 2, last / 4 * 3, last].map(|at| bits_of(values[at]));
    format!("{:016x} {}", fnv(values), few.join(" "))
}

/// One value as bits and as a number.
pub fn bits_of(value: f32) -> String {
    format!("{:08x}={value:e}", value.to_bits())
}

/// The 64-bit FNV-1a hash of the bytes of the values, least significant byte first.
pub fn fnv(values: &[f32]) -> u64 {
    let bytes = values.iter().flat_map(|value| value.to_bits().to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Writes a differing picture to a file for inspection; returns its path.
pub fn kept(name: &str, bytes: &[u8]) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("golden");
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    std::fs::write(&path, bytes).unwrap();
    path.display().to_string()
}
