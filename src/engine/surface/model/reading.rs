//! Reads a model from the bytes of a file, whose format is recognised by its first bytes.

use super::{Model, ModelError, foreign, gltf, obj, ply, stl};

/// Reads a model from the bytes of an OBJ, PLY, STL, glTF or GLB file; `name` is the file's, for messages.
///
/// # Errors
/// Another format, a file that does not follow its format, a model without faces: file, place, what was found, what is allowed.
pub fn read_model(bytes: &[u8], name: &str) -> Result<Model, ModelError> {
    if bytes.starts_with(b"glTF") || bytes.trim_ascii_start().starts_with(b"{") {
        gltf::read_gltf(bytes, name)
    } else if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") {
        ply::read_ply(bytes, name)
    } else if stl::is_stl(bytes) {
        stl::read_stl(bytes, name)
    } else if let Some(found) = foreign::format(bytes) {
        Err(ModelError::OtherFormat { file: name.to_owned(), found })
    } else {
        obj::read_obj(bytes, name)
    }
}

#[cfg(test)]
pub mod tests;
