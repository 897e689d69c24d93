//! The programs in `examples/` run and write their files.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Each program with the files that it writes.
const PROGRAMS: [(&str, &[&str]); 7] = [
    ("film", &["spots.gif"]),
    ("grow", &["tile-petals.png"]),
    ("lookup", &[]),
    ("measure", &[]),
    ("outlines", &["leaves.svg"]),
    ("progress", &[]),
    ("sketch", &["rosettes.png", "rosettes.dapple"]),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Builds the examples (`cargo test --workspace` has built them already); returns their folder.
fn built() -> PathBuf {
    let test = std::env::current_exe().expect("a test is a file");
    let profile = test.ancestors().nth(2).expect("it is in a folder of its profile");
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| env!("CARGO").into()));
    // Built for the whole workspace, like the tests. Without data-gen, a dependency of the engine would have other
    // features, so that everything that uses it would be built again.
    cargo
        .args(["build", "--workspace", "--examples", "--offline", "--locked", "--quiet"])
        .current_dir(root());
    if profile.ends_with("release") {
        cargo.arg("--release");
    }
    let output = cargo.output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    profile.join("examples")
}

#[test]
fn every_program_is_run_here() {
    let files = fs::read_dir(root().join("examples")).expect("the examples are there");
    let mut names: Vec<String> = files
        .map(|file| file.expect("readable").path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "rs"))
        .map(|path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned())
        .collect();
    names.sort();
    assert_eq!(names, PROGRAMS.map(|(name, _)| name));
}

#[test]
fn every_program_runs_and_writes_its_files() {
    let programs = built();
    let folder = tempfile::tempdir().unwrap();
    for (name, files) in PROGRAMS {
        let mut program = Command::new(programs.join(name).with_extension(std::env::consts::EXE_EXTENSION));
        if name == "grow" {
            program.arg(root().join("examples/tile-petals.dapple"));
        }
        let output = program.current_dir(folder.path()).output().unwrap();
        assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
        for file in files {
            let written = fs::metadata(folder.path().join(file));
            let size = written.unwrap_or_else(|_| panic!("{name} wrote no {file}")).len();
            assert!(size > 100, "{name}: {file} has {size} bytes");
        }
    }
    // The library and the command line write the same picture.
    let mut grow = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    grow.args(["grow", "rosettes.dapple", "-o", "again.png", "--quiet"]).current_dir(folder.path());
    assert!(grow.status().unwrap().success());
    let [one, other] = ["rosettes.png", "again.png"].map(|name| fs::read(folder.path().join(name)).unwrap());
    assert!(one == other, "the example sketch and dapple grow write different pictures");
}
