//! The same texture tomorrow: what was grown once grows again, whatever takes the steps, from documents of any age.
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
