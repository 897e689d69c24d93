//! Standard output and standard error that are full or closed.

use std::fs::File;
use std::process::Stdio;

use crate::bench::{Bench, printed};

/// All commands that print.
const PRINTERS: [&str; 14] = [
    "--help",
    "grow --help",
    "--version",
    "check a.dapple",
    "check a.dapple --json",
    "measure a.png",
    "measure a.png --json",
    "grow a.dapple -o b.png --report - --quiet",
    "lookup --system meinhardt-stripes --width 9 --angle 5",
    "lookup --system meinhardt-stripes --width 9 --angle 5 --json",
    "learn --no-simulation --targets 1 --system meinhardt-stripes",
    "completions bash",
    "man",
    "man grow",
];

#[test]
fn a_full_standard_output_is_an_error_in_one_line() {
    let Ok(full) = File::options().write(true).open("/dev/full") else { return };
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.png");
    for printer in PRINTERS {
        let mut command = bench.command(printer);
        let (code, said) = printed(&command.stdout(full.try_clone().unwrap()).output().unwrap());
        assert_eq!(code, Some(1), "{printer}: {said}");
        // With --json an error is one object.
        let begins = if printer.contains("--json") { "{\"error\":\"" } else { "error: " };
        let cannot = format!("{begins}standard output: cannot be written");
        assert!(said.starts_with(&cannot), "{printer}: {said}");
        assert_eq!(said.lines().count(), 1, "{printer}: {said}");
    }
}

#[test]
fn a_closed_pipe_is_no_error_for_any_command() {
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.png");
    for printer in PRINTERS {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let (code, said) = printed(&bench.command(printer).stdout(writer).output().unwrap());
        assert_eq!((code, said.as_str()), (Some(0), ""), "{printer}");
    }
    assert_eq!(bench.bytes("b.png"), bench.bytes("a.png"));
}

#[test]
fn a_closed_standard_error_is_no_error() {
    let bench = Bench::new();
    for (arguments, code) in
        [("grow a.dapple -o a.png", 0), ("import in.svg -o i.dapple", 0), ("check no.dapple", 1), ("gorw", 2)]
    {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let status = bench.command(arguments).stdout(Stdio::null()).stderr(writer).status().unwrap();
        assert_eq!(status.code(), Some(code), "{arguments}");
    }
}

/// The environment names a display that does not exist.
#[cfg(all(target_os = "linux", feature = "app"))]
#[test]
fn a_missing_display_is_reported_with_the_remedy() {
    let bench = Bench::new();
    for (variable, value) in [("DISPLAY", ":9876"), ("WAYLAND_DISPLAY", "wayland-9876")] {
        let mut command = bench.command("a.dapple");
        for other in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            command.env_remove(other);
        }
        command.env("XDG_RUNTIME_DIR", bench.folder()).env("HOME", bench.folder());
        let (code, said) = printed(&command.env(variable, value).output().unwrap());
        assert_eq!(code, Some(1), "{said}");
        assert!(
            said.contains("could not be opened") && said.contains("dapple grow FILE -o OUT.png"),
            "{said}"
        );
        assert!(!said.contains("panicked") && !said.contains(".rs"), "{said}");
    }
}
