//! Checks that documents grow the same textures as before: with every system and every solver, and from documents of
//! every version.
//!
//! `REGENERATE=1 cargo test --test golden -- --nocapture` rewrites changed files and prints the changes;
//! docs/golden.md says when to do so.

mod bytes;
mod data_set;
mod folder;
mod kinds;
mod renew;
mod sheets;
mod steps;
mod textures;
mod versions;
