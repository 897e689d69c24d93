//! Checks that the engine asks the system for nothing: no files, clock, processes, environment, threads of its own,
//! network or terminal.
//!
//! It reads bytes and writes to any writer; its caller provides memory limits, clocks and threads. The shell in turn
//! takes time and threads from one folder.

use crate::packages::{OF_THE_COMMAND_LINE, OF_THE_WINDOW, assert_without, dependencies};
use crate::scan::{Scan, scan, words};
use crate::sources::{ENGINE, is_test, module, sources};

/// Paths that the engine may not name. A path stands for all paths that begin with it.
const FORBIDDEN: [&[&str]; 15] = [
    &["std", "fs"],
    &["std", "process"],
    &["std", "env"],
    &["std", "thread"],
    &["std", "net"],
    &["std", "os"],
    &["std", "io", "stdin"],
    &["std", "io", "stdout"],
    &["std", "io", "stderr"],
    &["image", "open"],
    &["image", "ImageReader", "open"],
    &["rayon", "ThreadPoolBuilder"],
    &["rayon", "spawn"],
    &["tempfile"],
    &["sysinfo"],
];
/// The only item of `std::time` that it may name: a length of time.
const TIME: &str = "Duration";
/// Words that it may not use: macros that write to the terminal, and methods by which a path asks the disk.
const WORDS: [&str; 12] = [
    "println",
    "eprintln",
    "eprint",
    "dbg",
    "is_dir",
    "is_file",
    "is_symlink",
    "try_exists",
    "canonicalize",
    "read_dir",
    "symlink_metadata",
    "rustix",
];
/// Packages that it may not depend on.
const PACKAGES: [&str; 6] = ["tempfile", "sysinfo", "rustix", "web_time", "dapple", "num_cpus"];

/// The folder of the shell that asks the system for the time, for threads and for files.
const MACHINE: &str = "src/machine/";
/// Paths that only that folder may name.
const OF_THE_MACHINE: [&[&str]; 3] =
    [&["std", "thread"], &["rayon", "ThreadPoolBuilder"], &["rayon", "spawn"]];
/// Paths that only that folder may name in rooms that are also built for a browser, where files are kept in memory.
const OF_SYSTEMS: [&[&str]; 4] =
    [&["std", "fs"], &["tempfile"], &["image", "open"], &["image", "ImageReader", "open"]];

/// Whether a path is one of `forbidden` or begins with it, or asks for the time.
fn is_forbidden(path: &[String], forbidden: &[&[&str]]) -> bool {
    let is = |forbidden: &&[&str]| {
        path.len() >= forbidden.len() && path.iter().zip(forbidden.iter()).all(|(a, b)| a == b)
    };
    let of_time = path.len() > 1 && path[..2] == ["std", "time"];
    forbidden.iter().any(is) || of_time && path.get(2).is_none_or(|name| name != TIME)
}

/// The forbidden paths and words of a file of the engine. Tests beside the code may use anything.
fn complaints(file: &str, source: &str) -> Vec<String> {
    if is_test(&module(file)) {
        return Vec::new();
    }
    // The code after the first of these lines is only for tests.
    let program = source.lines().position(|line| line.contains("#[cfg(test)]")).unwrap_or(usize::MAX);
    let of_words = words(source)
        .filter(|(line, word)| *line <= program && WORDS.contains(&word.as_str()))
        .map(|(line, word)| format!("{file}:{line}: `{word}`"));
    forbidden_paths(file, source, &FORBIDDEN).into_iter().chain(of_words).collect()
}

/// The paths of a file that are `forbidden` or ask for the time. Tests beside the code may use anything.
fn forbidden_paths(file: &str, source: &str, forbidden: &[&[&str]]) -> Vec<String> {
    let module = module(file);
    if is_test(&module) {
        return Vec::new();
    }
    let Scan { paths, bound } = scan(source, &module);
    // A name that the file imports is replaced by its path.
    let full = |path: &[String]| -> Vec<String> {
        let imported = paths.iter().find(|named| {
            named.path.len() > 1 && named.path[0] != "crate" && named.path.last() == Some(&path[0])
        });
        match imported.filter(|_| !bound.contains_key(&path[0])) {
            Some(named) => named.path.iter().chain(&path[1..]).cloned().collect(),
            None => path.to_vec(),
        }
    };
    let is_forbidden =
        |path: &[String]| is_forbidden(path, forbidden) || is_forbidden(&full(path), forbidden);
    paths
        .iter()
        .filter(|named| !named.in_tests && is_forbidden(&named.path))
        .map(|named| format!("{file}:{}: `{}`", named.line, named.path.join("::")))
        .collect()
}

#[test]
fn the_engine_uses_no_files_clock_processes_threads_or_terminal() {
    let sources = sources();
    let engine = sources.iter().filter(|(file, _)| file.starts_with(ENGINE));
    let complaints: Vec<String> = engine.flat_map(|(file, source)| complaints(file, source)).collect();
    assert!(complaints.is_empty(), "this belongs to the shell:\n{}", complaints.join("\n"));
}

#[test]
fn rooms_for_a_browser_take_their_files_from_machine() {
    let sources = sources();
    let rooms = ["src/files/", "src/editor/", "src/app/"];
    let shell = sources.iter().filter(|(file, _)| rooms.iter().any(|room| file.starts_with(room)));
    let complaints: Vec<String> =
        shell.flat_map(|(file, source)| forbidden_paths(file, source, &OF_SYSTEMS)).collect();
    assert!(complaints.is_empty(), "take crate::machine::fs:\n{}", complaints.join("\n"));
    for source in ["use std::fs;", "fn f() { std::fs::read(x); }", "use tempfile::TempDir;"] {
        assert_eq!(forbidden_paths("src/files/save.rs", source, &OF_SYSTEMS).len(), 1, "{source}");
    }
}

#[test]
fn the_shell_takes_time_and_threads_from_machine() {
    let sources = sources();
    let shell = sources.iter().filter(|(file, _)| {
        file.starts_with("src/") && !file.starts_with(ENGINE) && !file.starts_with(MACHINE)
    });
    let complaints: Vec<String> =
        shell.flat_map(|(file, source)| forbidden_paths(file, source, &OF_THE_MACHINE)).collect();
    assert!(complaints.is_empty(), "this belongs to {MACHINE}:\n{}", complaints.join("\n"));
    for source in ["use std::thread;", "use std::time::SystemTime;", "use rayon::ThreadPoolBuilder;"] {
        assert_eq!(forbidden_paths("src/app/window.rs", source, &OF_THE_MACHINE).len(), 1, "{source}");
    }
}

#[test]
fn the_engine_depends_on_no_package_of_the_shell() {
    let named = dependencies("src/engine/Cargo.toml");
    let found = named.iter().find(|name| PACKAGES.contains(&name.as_str()));
    assert_eq!(found, None, "src/engine/Cargo.toml names a package of the shell");
    let forbidden = [&PACKAGES[..3], &OF_THE_WINDOW, &OF_THE_COMMAND_LINE].concat();
    assert_without(&["-p", "dapple-engine"], &["dapple-engine", "rayon"], &forbidden);
}

#[test]
fn each_kind_of_forbidden_use_is_found() {
    let trespasses = [
        "use std::fs;",
        "use std::{fs::File, io};",
        "fn f() { std::process::id(); }",
        "use std::time::{Duration, Instant};",
        "use std::time;",
        "use std::time::Duration; fn f() { let t = ::std::time::Instant::now(); }",
        "fn f() { std::env::temp_dir(); }",
        "use std::io; fn f() { io::stdout().flush(); }",
        "use std::io::{self, Write, stderr};",
        "use rayon::ThreadPoolBuilder;",
        "use image::ImageReader; fn f() { ImageReader::open(x); }",
        "fn f() { println!(\"a\"); }",
        "fn f(path: &Path) -> bool { path.is_dir() }",
        "use sysinfo::System;",
        "use std::fs; #[cfg(test)] mod tests { use std::env; }",
    ];
    for source in trespasses {
        let found = complaints("src/engine/rd/mod.rs", source);
        assert!(found.len() == 1, "{source}: {found:?}");
    }
}

#[test]
fn allowed_code_passes() {
    let allowed = [
        "use std::time::Duration; fn f(now: fn() -> Duration) -> Duration { now() + Duration::ZERO }",
        "use std::io::{self, Write}; fn f(out: impl Write) -> io::Result<()> { io::sink().flush() }",
        "use std::path::Path; fn f(path: &Path) { path.display(); }",
        "#[cfg(test)] mod tests { use std::fs; fn f() { println!(\"a\"); } }",
        "//! std::fs::read\nconst A: &str = \"std::fs::read\";",
        "fn f() { rayon::scope(|_| ()) }",
    ];
    for source in allowed {
        assert_eq!(complaints("src/engine/rd/mod.rs", source), [""; 0], "{source}");
    }
    assert_eq!(complaints("src/engine/rd/x_tests.rs", "use std::fs;"), [""; 0]);
}
