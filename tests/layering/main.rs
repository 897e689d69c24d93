//! Checks the module structure (described at the head of `src/lib.rs`): which room may import from which, that there
//! are no circles within a room, what the engine must not use, where each external package may be used, which files may
//! be at the top of the tree, whether docs can be understood alone, and that no test sleeps.

mod circles;
mod docs;
mod kinds;
mod packages;
mod rooms;
mod scan;
mod sleeps;
mod sources;
mod systems;
mod texts;
mod walls;

use std::process::Command;

use sources::root;

/// Entries allowed at the top of the tree, besides dotfiles and licences.
const TOP: [&str; 15] = [
    "Cargo.toml",
    "Cargo.lock",
    "README.md",
    "CHANGELOG.md",
    "src",
    "data-gen",
    "training",
    "tests",
    "benches",
    "examples",
    "assets",
    "docs",
    "fuzz",
    "python",
    "web",
];

#[test]
fn the_top_of_the_tree_holds_only_what_belongs_there() {
    // Only files that git tracks are checked: users may keep pictures here.
    let listed = Command::new("git").args(["ls-files", "-z"]).current_dir(root()).output();
    let Some(listed) = listed.ok().filter(|output| output.status.success()) else {
        eprintln!("NOT CHECKED: no git, or no repository");
        return;
    };
    for file in String::from_utf8_lossy(&listed.stdout).split_terminator('\0') {
        let top = file.split('/').next().unwrap_or(file);
        let known = top.starts_with('.') || top.starts_with("LICENSE") || TOP.contains(&top);
        assert!(
            known,
            "{top} does not belong at the top; allowed are {}, licences, dotfiles",
            TOP.join(", ")
        );
    }
}
