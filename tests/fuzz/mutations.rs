//! The seeds of a fuzz target, and mutations of them: kinds of damage that libFuzzer makes as well.

use proptest::prelude::*;
use proptest::sample::Index;
use std::path::{Path, PathBuf};

/// A kind of damage to a file.
#[derive(Clone, Debug)]
enum Damage {
    /// A byte is replaced.
    Byte(Index, u8),
    /// Some bytes are lost.
    Cut(Index, usize),
    /// Some bytes are repeated.
    Repeat(Index, usize, usize),
    /// A word of the dictionary is inserted.
    Word(Index, Index),
    /// The rest is replaced by that of another seed.
    Splice(Index, Index, Index),
}

/// The seeds and the words of a target.
pub struct Seeds {
    /// Name and bytes of each seed, sorted by name.
    pub files: Vec<(String, Vec<u8>)>,
    words: Vec<Vec<u8>>,
}

impl Seeds {
    /// The seeds of `target`, from the folder of the fuzz targets.
    pub fn for_target(folder: &Path, target: &str) -> Self {
        let entries = std::fs::read_dir(folder.join("corpus").join(target)).expect("the target has seeds");
        let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a seed").path()).collect();
        paths.sort();
        assert!(!paths.is_empty(), "{target} has no seeds");
        let named =
            |path: &PathBuf| (path.display().to_string(), std::fs::read(path).expect("a seed is read"));
        let dictionary = folder.join("dictionaries").join(format!("{target}.dict"));
        let words = std::fs::read_to_string(dictionary).expect("the target has a dictionary");
        let words = words.lines().filter_map(|line| line.strip_prefix('"')?.strip_suffix('"')).map(unescaped);
        Self { files: paths.iter().map(named).collect(), words: words.collect() }
    }

    /// A strategy for damaged seeds.
    pub fn damaged(&self) -> impl Strategy<Value = Vec<u8>> {
        let damage = prop_oneof![
            3 => (any::<Index>(), any::<u8>()).prop_map(|(at, byte)| Damage::Byte(at, byte)),
            2 => (any::<Index>(), 1..40_usize).prop_map(|(at, length)| Damage::Cut(at, length)),
            1 => (any::<Index>(), 1..40_usize, 1..200_usize).prop_map(|(at, length, n)| Damage::Repeat(at, length, n)),
            3 => (any::<Index>(), any::<Index>()).prop_map(|(at, word)| Damage::Word(at, word)),
            1 => (any::<Index>(), any::<Index>(), any::<Index>()).prop_map(|(other, a, b)| Damage::Splice(other, a, b)),
        ];
        (any::<Index>(), prop::collection::vec(damage, 1..6)).prop_map(|(seed, damages)| {
            let mut bytes = seed.get(&self.files).1.clone();
            damages.iter().for_each(|damage| self.damage(&mut bytes, damage));
            bytes
        })
    }

    fn damage(&self, bytes: &mut Vec<u8>, damage: &Damage) {
        let at = |index: &Index| index.index(bytes.len() + 1);
        match damage {
            Damage::Byte(index, byte) => match at(index) {
                at if at < bytes.len() => bytes[at] = *byte,
                _ => bytes.push(*byte),
            },
            Damage::Cut(index, length) => {
                let from = at(index);
                let to = (from + length).min(bytes.len());
                bytes.drain(from..to);
            }
            Damage::Repeat(index, length, n) => {
                let from = at(index);
                let to = (from + length).min(bytes.len());
                let more = bytes[from..to].repeat(*n);
                bytes.splice(to..to, more);
            }
            Damage::Word(index, word) => {
                let at = at(index);
                bytes.splice(at..at, word.get(&self.words).iter().copied());
            }
            Damage::Splice(other, from, to) => {
                let other = &other.get(&self.files).1;
                let rest = &other[to.index(other.len() + 1)..];
                bytes.truncate(at(from));
                bytes.extend_from_slice(rest);
            }
        }
    }
}

/// A word as dictionaries of libFuzzer write it: `\xNN`, `\"`, `\\`.
fn unescaped(word: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut rest = word.as_bytes();
    while let [first, after @ ..] = rest {
        rest = match (first, after) {
            (b'\\', [b'x', high, low, after @ ..]) => {
                let digits = [*high, *low];
                let digits = std::str::from_utf8(&digits).expect("hexadecimal digits");
                bytes.push(u8::from_str_radix(digits, 16).expect("hexadecimal digits"));
                after
            }
            (b'\\', [escaped, after @ ..]) => {
                bytes.push(*escaped);
                after
            }
            _ => {
                bytes.push(*first);
                after
            }
        };
    }
    bytes
}
