//! The documents of `examples/` as links.

use std::fs;
use std::path::{Path, PathBuf};

use dapple::ReadFile;
use dapple::document::link::{SHORT, is_link};
use dapple::document::{Document, LinkError};

/// All documents below a folder.
fn below(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            below(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "dapple") {
            found.push(path);
        }
    }
}

fn has_picture(document: &Document) -> bool {
    document.to_json().contains("\"png\":")
}

#[test]
fn nine_of_ten_examples_without_a_picture_fit_into_a_short_link_and_every_link_holds_its_document() {
    let mut paths = Vec::new();
    below(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples"), &mut paths);
    let mut lengths = Vec::new();
    for path in paths {
        let document = Document::read(&path).unwrap();
        let name = path.display();
        let fragment = match document.fragment() {
            Ok(fragment) => fragment,
            Err(LinkError::TooLong { .. } | LinkError::TooLarge) if has_picture(&document) => continue,
            Err(error) => panic!("{name}: {error}"),
        };
        let link = format!("https://dapple.example/?view{fragment}");
        assert!(is_link(&link), "{name}");
        assert_eq!(Document::from_link(&link).unwrap(), document, "{name}");
        if !has_picture(&document) {
            lengths.push(fragment.len());
        }
    }
    lengths.sort_unstable();
    let short = lengths.iter().filter(|length| **length <= SHORT).count();
    let [least, median, most] = [0, lengths.len() / 2, lengths.len() - 1].map(|place| lengths[place]);
    println!("{short} of {}: {least} to {most} characters, median {median}", lengths.len());
    assert!(lengths.len() > 100, "{}", lengths.len());
    assert!(10 * short >= 9 * lengths.len(), "{short} of {}", lengths.len());
}
