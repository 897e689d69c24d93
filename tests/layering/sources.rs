//! The source files of the engine, the program and data-gen.

use std::fs;
use std::path::{Path, PathBuf};

/// The repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Path (from the root, with `/`) and text of each source file of the engine, the program and data-gen, without build scripts: these
/// run on the machine that builds.
pub fn sources() -> Vec<(String, String)> {
    let mut files = files_in(&["src", "data-gen/src"]);
    files.retain(|(path, _)| !path.ends_with("/build.rs"));
    files
}

/// Path (from the root, with `/`) and text of each Rust file in these folders.
pub fn files_in(folders: &[&str]) -> Vec<(String, String)> {
    let mut files = Vec::new();
    let mut folders: Vec<PathBuf> = folders.iter().map(|folder| root().join(folder)).collect();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("the source tree can be read") {
            let path = entry.expect("the source tree can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                files.push((name_of(&path), fs::read_to_string(&path).expect("sources are UTF-8")));
            }
        }
    }
    assert!(files.len() > 15, "only {} source files were found", files.len());
    files.sort();
    files
}

fn name_of(path: &Path) -> String {
    let parts = path.strip_prefix(root()).expect("below the root").iter();
    parts.map(|part| part.to_str().expect("names are UTF-8")).collect::<Vec<_>>().join("/")
}

/// The folder of the engine's sources.
pub const ENGINE: &str = "src/engine/";

/// The module path of a file: `src/rd/turing.rs` → `["rd", "turing"]`; the roots → `[]`. The rooms of the engine and
/// those of the shell have one list of names: the shell re-exports the engine's rooms under their names, so that
/// `crate::rd` is the same in both.
pub fn module(file: &str) -> Vec<&str> {
    let inside =
        file.trim_start_matches("data-gen/").trim_start_matches("src/").trim_start_matches("engine/");
    let inside = inside.trim_end_matches(".rs");
    let mut module: Vec<_> = inside.split('/').collect();
    if module.last() == Some(&"mod") || module == ["lib"] || module == ["main"] {
        module.pop();
    }
    module
}

/// Whether a module holds tests only: one called `tests` or `…_tests`, or one inside such a module.
pub fn is_test(module: &[&str]) -> bool {
    module.iter().any(|name| *name == "tests" || name.ends_with("_tests"))
}
