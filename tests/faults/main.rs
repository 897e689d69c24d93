//! Faults: kills, full disks, no permission to write, the same file twice, damaged training sets, a thousand documents.
//! `.ci/faults` runs the long versions; docs/faults.md describes the results.
#![cfg(unix)]

mod bench;
mod disk;
mod kills;
mod load;
mod mounts;
mod printing;
mod running;
mod same_file;
mod training;

#[cfg(feature = "app")]
#[expect(dead_code, reason = "it can do more than is asked of it here")]
#[path = "../window/hand.rs"]
mod hand;
#[cfg(feature = "app")]
mod window;
