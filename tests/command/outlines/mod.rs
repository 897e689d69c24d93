//! Outlines of grown textures: their area, how other libraries read them, and the command line that writes them.

pub mod bench;
mod files;
mod grown;
mod import;
mod portrait;
