//! Outlines of what has grown: their area, how other libraries read them, and the command line that writes them.

mod bench;
mod files;
mod grown;
mod import;
