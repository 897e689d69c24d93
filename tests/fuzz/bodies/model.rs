//! Fuzz body for models: a model that is read has finite bounds and triangles of its own vertices, and becomes a
//! manifold or is refused.

use dapple_engine::surface::{Mesh, prepare, read_model};

use crate::refusal::assert_readable;

const FILE: &str = "bad.model";
/// Models with more triangles are not prepared: damage can repeat lines many times.
const MOST: usize = 5_000;

/// `bytes` are a model, or are refused.
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
    // A model that cannot be prepared gives the reason.
    let Ok((whole, repairs)) = prepare(mesh) else { return };
    assert!(has_corners(&whole) && !whole.faces.is_empty());
    assert!(whole.positions.iter().flatten().all(|x| x.is_finite()), "{:?}", repairs.notes());
    assert!(whole.area() > 0.0 && whole.area().is_finite(), "{}", whole.area());
}
