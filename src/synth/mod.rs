//! The thread: a document in, a grown texture out.

pub mod recipe;
