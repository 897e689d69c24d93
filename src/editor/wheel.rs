//! What the wheel of a mouse, or two fingers on a touchpad, do over sketch and texture.

use serde::{Deserialize, Serialize};

/// What the wheel does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Wheel {
    /// It moves the view; with Ctrl it zooms.
    #[default]
    Pan,
    /// It zooms.
    Zoom,
}
