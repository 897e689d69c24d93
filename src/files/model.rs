//! Models in files.

use std::io::Read;
use std::path::Path;

use sha2::{Digest, Sha256};

use super::input::input;
use crate::document::{Body, BodySource, DocumentError, Problem, limits};

/// The file of a model.
#[derive(Clone, Debug)]
pub struct ModelFile {
    /// The bytes of the file.
    pub bytes: Vec<u8>,
    /// Whether the file has changed since the document was made.
    pub is_changed: bool,
}

/// Reads the model `body` of the document in the file `document`; `None` if it is built in. The file `instead`, if there is one, is
/// read in place of the one that the document names.
///
/// # Errors
/// The file does not exist, cannot be read, or is too large. The error names the place in the document, what was found,
/// and what is allowed.
pub fn read_model(
    document: &Path,
    body: &Body,
    instead: Option<&Path>,
) -> Result<Option<ModelFile>, DocumentError> {
    let (path, sha256) = match (instead, &body.source) {
        (Some(path), _) => (path.to_owned(), None),
        (None, BodySource::BuiltIn(_)) => return Ok(None),
        (None, BodySource::File { path, sha256 }) => {
            (document.parent().unwrap_or(Path::new("")).join(path), *sha256)
        }
    };
    let refused = |found: String| {
        let allowed = "a model (.obj, .ply, .stl, .glb or .gltf): put it beside the document, or name it with --model FILE";
        Problem::new("model.file", found, allowed).in_file(&document.display().to_string())
    };
    let mut bytes = Vec::new();
    let shown = path.display();
    let read = input(&path).and_then(|file| file.take(limits::MAX_FILE + 1).read_to_end(&mut bytes));
    read.map_err(|error| refused(format!("{shown}, which cannot be read ({error})")))?;
    if bytes.len() as u64 > limits::MAX_FILE {
        return Err(refused(format!("{shown}, which has more than {} MB", limits::MAX_FILE >> 20)));
    }
    let is_changed = sha256.is_some_and(|before| before != <[u8; 32]>::from(Sha256::digest(&bytes)));
    Ok(Some(ModelFile { bytes, is_changed }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    fn of_file(sha256: Option<[u8; 32]>) -> Body {
        Body::new(BodySource::File { path: "a.obj".to_owned(), sha256 })
    }

    #[test]
    fn a_model_is_found_beside_its_document_and_a_change_is_noticed() {
        let folder = tempfile::tempdir().unwrap();
        let document = folder.path().join("a.dapple");
        fs::write(folder.path().join("a.obj"), "v 0 0 0").unwrap();
        let digest = Sha256::digest("v 0 0 0").into();
        for (sha256, is_changed) in [(None, false), (Some(digest), false), (Some([0; 32]), true)] {
            let model = read_model(&document, &of_file(sha256), None).unwrap().expect("a file");
            assert_eq!((model.bytes.as_slice(), model.is_changed), (&b"v 0 0 0"[..], is_changed));
        }
        let built_in = Body::new(BodySource::BuiltIn("egg"));
        assert!(read_model(&document, &built_in, None).unwrap().is_none());
    }

    #[test]
    fn a_missing_model_is_an_error_and_another_file_can_be_named() {
        let folder = tempfile::tempdir().unwrap();
        let document = folder.path().join("b.dapple");
        let error = read_model(&document, &of_file(None), None).unwrap_err().to_string();
        assert!(
            error.contains("b.dapple: model.file: found ") && error.contains("a.obj, which cannot be read"),
            "{error}"
        );
        assert!(error.ends_with("name it with --model FILE"), "{error}");
        let other = folder.path().join("other.obj");
        fs::write(&other, "v 1 1 1").unwrap();
        let model = read_model(&document, &of_file(Some([0; 32])), Some(&other)).unwrap().expect("a file");
        assert_eq!((model.bytes.as_slice(), model.is_changed), (&b"v 1 1 1"[..], false));
    }
}
