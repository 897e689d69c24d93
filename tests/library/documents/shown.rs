//! The documents in the guides are valid.

use super::*;

/// The blocks of JSON in a guide.
fn blocks(text: &str) -> impl Iterator<Item = &str> {
    text.split("```json\n").skip(1).filter_map(|rest| rest.split("```").next())
}

#[test]
fn the_documents_in_the_guides_are_valid() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = vec![root.join("README.md")];
    paths.extend(std::fs::read_dir(root.join("docs")).unwrap().map(|entry| entry.unwrap().path()));
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    let mut valid = 0;
    for path in paths {
        let text = std::fs::read_to_string(&path).unwrap();
        for block in blocks(&text).filter(|block| block.contains(r#""format""#)) {
            let document = Document::parse(block, &path.display().to_string());
            valid += usize::from(document.map_err(|error| panic!("{error}")).is_ok());
        }
    }
    assert!(valid > 0, "no guide shows a document");
}
