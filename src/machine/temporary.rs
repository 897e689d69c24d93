//! Temporary files and folders, which are deleted when they are dropped.

pub use tempfile::{Builder, NamedTempFile, TempDir};
