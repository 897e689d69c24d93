//! Documents grow the same textures as before: with every solver, and from documents of every version.
//!
//! `REGENERATE=1 cargo test --test golden -- --nocapture` rewrites what has changed, and prints it; docs/golden.md
//! says when that is right.

mod bytes;
mod folder;
mod renew;
mod sheets;
mod steps;
mod textures;
mod versions;
