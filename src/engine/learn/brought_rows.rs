//! Training rows that are not compiled in: the program supplies them all at once, in the file `all.pack` of `build.rs`.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use crate::attributes::system::TrainingFile;

/// The rows of each file, by its name.
static BROUGHT: OnceLock<BTreeMap<String, Vec<u8>>> = OnceLock::new();

/// Supplies the rows of all files; only the first call has an effect.
pub fn bring_rows(pack: &[u8]) {
    BROUGHT.get_or_init(|| unpacked(pack));
}

/// The rows of a file, compiled in or supplied.
pub(super) fn rows_of(file: &'static TrainingFile) -> &'static [u8] {
    let brought = || BROUGHT.get()?.get(file.name).map(Vec::as_slice);
    if file.rows.is_empty() { brought().unwrap_or_default() } else { file.rows }
}

/// Reads, for each file, a line `NAME BYTES` and this number of bytes. Incomplete files are left out.
fn unpacked(mut pack: &[u8]) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    while let Some(end) = pack.iter().position(|byte| *byte == b'\n') {
        let head = str::from_utf8(&pack[..end]).ok().and_then(|line| line.split_once(' '));
        let Some((name, bytes)) = head.and_then(|(name, bytes)| Some((name, bytes.parse::<usize>().ok()?)))
        else {
            break;
        };
        let Some((file, rest)) = pack[end + 1..].split_at_checked(bytes) else { break };
        files.insert(name.to_owned(), file.to_vec());
        pack = rest;
    }
    files
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::learn::laws::{MEINHARDT, TURING};

    /// The file that the build script has packed.
    const PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/all.pack"));

    #[test]
    fn the_pack_holds_the_rows_that_are_compiled_in() {
        let files = unpacked(PACK);
        for file in TURING.training.iter().chain(MEINHARDT.training) {
            assert!(files[file.name] == file.rows, "{}", file.name);
        }
    }

    #[test]
    fn a_truncated_pack_holds_its_complete_files() {
        let files = unpacked(b"a 2\nxyb 9\nxy");
        assert_eq!(files.into_iter().collect::<Vec<_>>(), [("a".to_owned(), b"xy".to_vec())]);
        assert!(unpacked(b"a b\nxy").is_empty() && unpacked(b"").is_empty());
    }
}
