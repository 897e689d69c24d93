//! The document while somebody works on it: selection, undo, layers. It knows no window toolkit.

pub mod history;
pub mod lock;
pub mod selection;
