//! A document that is written and read keeps all of its content.

use dapple::document::Document;

/// Document → JSON → document.
pub fn comes_back(document: &Document) {
    let text = document.to_json();
    let read = Document::parse(&text, "own.dapple").expect("what is written is read");
    assert_eq!(read, *document);
    assert_eq!(read.to_json(), text, "what is read is written as it was");
    document.check("own.dapple").expect("what was read is valid");
}
