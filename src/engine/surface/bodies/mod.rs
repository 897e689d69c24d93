//! Bodies.
use super::model::Model;
/// x
pub const BODIES: [&str; 1] = ["x"];
/// x
pub fn built_in(_: &str) -> Option<Model> {
    None
}
