//! All texts of the window and of the command line in one list, to be read at once: `cargo test --test layering texts`
//! writes it to `target/tmp/texts.txt`. The test also checks that they contain no words that only a developer of dapple
//! would understand.

use std::fs;
use std::path::{Path, PathBuf};

/// Folders whose string literals users read.
const FOLDERS: [&str; 10] = [
    "src/app",
    "src/cli",
    "src/editor",
    "src/engine/attributes/free",
    "src/engine/document",
    "src/engine/learn",
    "src/engine/sketch",
    "src/engine/synth/marks/report",
    "src/engine/synth/pairs",
    "src/engine/synth/report",
];

/// Words and phrases that a stranger does not understand at first sight, and what to write instead.
const UNCLEAR: [(&str, &str); 26] = [
    ("in the middle of the canvas", "at centre"),
    ("sketch the next", "start the next"),
    ("take the layer", "select layer"),
    ("swap back", "swap with previous"),
    ("swap on", "swap with next"),
    ("take this stop", "remove this stop"),
    ("more texture", "larger canvas"),
    ("way for the pen", "pen travel"),
    ("what should go", "erase"),
    ("the numbers of before", "numbers from the previous texture"),
    ("thaw", "unfreeze"),
    ("at hand", "active"),
    ("what dapple sees", "analysis of the sketch"),
    ("one over the other", "texture over the sketch"),
    ("inside dapple", "an error in dapple"),
    ("is there already", "already exists"),
    ("forget these", "clear this list"),
    ("this system packs", "too small for spots of this size"),
    ("; growing at", "which grows instead"),
    ("beyond what this system", "cannot be grown together"),
    ("take this file away", "remove this file"),
    ("stands there", "is there"),
    ("expected sizes", "sizes and directions between marks"),
    ("lowest, auto", "automatic"),
    ("with their moments", "of the ellipses fitted to the marks"),
    ("share as drawn", "stripe width as drawn"),
];

/// The Rust files below a folder, without tests, in order.
fn sources(folder: &Path, files: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    entries.sort();
    for path in entries {
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        if path.is_dir() && name != "tests" {
            sources(&path, files);
        } else if name.ends_with(".rs") && name != "tests.rs" {
            files.push(path);
        }
    }
}

/// The string literals of Rust code, in order; comments are left out.
fn literals(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut left = code;
    while let Some(start) = left.find(['"', '/', '\'']) {
        let rest = &left[start..];
        left = if rest.starts_with("//") {
            &rest[rest.find('\n').unwrap_or(rest.len())..]
        } else if let Some(after) = rest.strip_prefix("'\"'").or(rest.strip_prefix("'\\\"'")) {
            after
        } else if let Some(text) = rest.strip_prefix('"') {
            let (literal, after) = until_quote(text);
            found.push(literal);
            after
        } else {
            &rest[1..]
        };
    }
    found
}

/// A literal up to its closing quote, and what follows. Lines that are continued are joined.
fn until_quote(text: &str) -> (String, &str) {
    let mut literal = String::new();
    let mut letters = text.char_indices();
    while let Some((at, letter)) = letters.next() {
        match letter {
            '"' => return (literal, &text[at + 1..]),
            '\\' => match letters.next() {
                Some((next, '\n')) => {
                    let blanks = text[next + 1..].chars().take_while(|letter| letter.is_whitespace()).count();
                    letters.by_ref().take(blanks).for_each(|_| {});
                }
                Some((_, escaped)) => literal.push(escaped),
                None => break,
            },
            _ => literal.push(letter),
        }
    }
    (literal, "")
}

/// Whether a literal is a text that a user reads, not a name or a format.
fn is_text(literal: &str) -> bool {
    let words =
        literal.split_whitespace().filter(|word| word.chars().filter(|c| c.is_alphabetic()).count() > 1);
    words.count() > 1 || (literal.starts_with(char::is_uppercase) && literal.chars().all(char::is_alphabetic))
}

/// Every text with the file that holds it.
fn texts() -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = Vec::new();
    FOLDERS.iter().for_each(|folder| sources(&root.join(folder), &mut files));
    let of_file = |file: PathBuf| {
        let code = fs::read_to_string(&file).unwrap();
        let code = code.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default().to_owned();
        let file = file.strip_prefix(root).unwrap().to_owned();
        let texts = literals(&code).into_iter().filter(|literal| is_text(literal));
        texts.map(move |text| (file.clone(), text)).collect::<Vec<_>>()
    };
    files.into_iter().flat_map(of_file).collect()
}

#[test]
fn all_texts_are_listed_and_none_is_jargon() {
    let texts = texts();
    assert!(texts.len() > 700, "only {} texts were found", texts.len());
    let is_there = |text: &str| texts.iter().any(|(_, found)| found == text);
    for text in ["Freeze layer and start the next", "Add ellipse at centre", "Nothing has grown yet."] {
        assert!(is_there(text), "{text}");
    }
    let list: Vec<String> = texts.iter().map(|(file, text)| format!("{}: {text}", file.display())).collect();
    fs::write(Path::new(env!("CARGO_TARGET_TMPDIR")).join("texts.txt"), list.join("\n")).unwrap();
    for (file, text) in &texts {
        for (phrase, instead) in UNCLEAR {
            let is_unclear = text.to_lowercase().contains(phrase);
            assert!(!is_unclear, "{}: {text:?}: instead of {phrase:?}: {instead:?}", file.display());
        }
    }
}

#[test]
fn literals_are_found_as_rust_reads_them() {
    let code = "// \"no text\"\nlet a = '\"'; f(\"one \\\n    line\", \"a \\\"quote\\\"\");";
    assert_eq!(literals(code), ["one line", "a \"quote\""]);
}
