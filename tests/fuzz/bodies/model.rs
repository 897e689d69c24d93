//! Models: what is read has finite bounds and triangles of its vertices, and is made a manifold or refused.

use dapple_engine::surface::{Mesh, prepare, read_model};

use crate::refusal::assert_readable;

const FILE: &str = "bad.model";
/// More triangles are not prepared: damage can repeat lines.
const MOST: usize = 5_000;

/// Whatever `bytes` are, they are a model or none.
pub fn holds(bytes: &[u8]) {
    let model = match read_model(bytes, FILE) {
        Ok(model) => model,
        Err(error) => return assert_readable(&error.to_string(), FILE),
    };
    match model.mesh(&[]) {
        Ok(mesh) if mesh.faces.len() <= MOST => is_prepared(&mesh),
        Ok(_) => {}
        Err(error) => assert!(!error.to_string().contains(char::is_control), "{error:?}"),
    }
}

fn is_prepared(mesh: &Mesh) {
    let has_corners = |mesh: &Mesh| mesh.faces.iter().flatten().all(|c| (*c as usize) < mesh.positions.len());
    assert!(has_corners(mesh), "a corner that is no vertex");
    // What cannot be prepared says so.
    let Ok((whole, repairs)) = prepare(mesh) else { return };
    assert!(has_corners(&whole) && !whole.faces.is_empty());
    assert!(whole.positions.iter().flatten().all(|x| x.is_finite()), "{:?}", repairs.notes());
    assert!(whole.area() > 0.0 && whole.area().is_finite(), "{}", whole.area());
}
