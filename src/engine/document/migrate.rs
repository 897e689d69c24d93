//! Versions: an older document is migrated step by step, a newer one is refused.

mod free_marks;

use crate::document::node::Node;
use crate::document::{DocumentError, Problem};
use serde_json::{Value, json};

/// Changes a document of one version into one of the next. Values that it does not know are left to the reader, which refuses them.
type Migration = fn(Value) -> Value;

/// `MIGRATIONS[i]` turns version i + 1 into version i + 2. Append new ones; never change an old one.
const MIGRATIONS: &[Migration] = &[free_marks::migrate];

/// The version that is read and written.
pub(super) const NEWEST: u64 = MIGRATIONS.len() as u64 + 1;

/// The document in the newest version.
pub(super) fn to_newest(document: Value, file: &str) -> Result<Value, DocumentError> {
    through(MIGRATIONS, document, file)
}

fn through(migrations: &[Migration], mut document: Value, file: &str) -> Result<Value, DocumentError> {
    let known = migrations.len() as u64 + 1;
    let version = version(&Node::root(&document)).map_err(|problem| problem.in_file(file))?;
    if version > known {
        return Err(DocumentError::Newer { file: file.to_owned(), version, known });
    }
    for (next, migrate) in (2..).zip(migrations).skip(version as usize - 1) {
        document = migrate(document);
        if let Some(object) = document.as_object_mut() {
            object.insert("version".to_owned(), json!(next));
        }
    }
    Ok(document)
}

/// The version of the document, which must have the format `dapple`.
fn version(root: &Node) -> Result<u64, Problem> {
    root.need("format", "\"dapple\"")?.choice(&[("dapple", ())])?;
    root.need("version", &format!("a whole number, now {NEWEST}"))?.whole(1, u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pretends that version 1 had `seeds`, a list, and version 2 the first of it as `seed`.
    fn one_seed(mut document: Value) -> Value {
        if let Some(seeds) = document.as_object_mut().and_then(|object| object.remove("seeds")) {
            document["seed"] = seeds[0].clone();
        }
        document
    }

    /// Pretends that version 3 gave every document a name.
    fn named(mut document: Value) -> Value {
        document["name"] = json!("nameless");
        document
    }

    #[test]
    fn an_older_document_goes_through_every_step_after_it() {
        let old = json!({"format": "dapple", "version": 1, "seeds": [5, 6]});
        let new = through(&[one_seed, named], old, "x").unwrap();
        assert_eq!(new, json!({"format": "dapple", "version": 3, "seed": 5, "name": "nameless"}));
        let old = json!({"format": "dapple", "version": 2, "seed": 5});
        let new = through(&[one_seed, named], old, "x").unwrap();
        assert_eq!(new, json!({"format": "dapple", "version": 3, "seed": 5, "name": "nameless"}));
    }

    #[test]
    fn the_newest_document_is_left_as_it_is() {
        let document = json!({"format": "dapple", "version": 3, "seeds": 1});
        assert_eq!(through(&[one_seed, named], document.clone(), "x").unwrap(), document);
    }

    #[test]
    fn a_newer_document_is_refused() {
        let error = through(&[one_seed], json!({"format": "dapple", "version": 3}), "x").unwrap_err();
        assert!(matches!(error, DocumentError::Newer { version: 3, known: 2, .. }), "{error}");
    }
}
