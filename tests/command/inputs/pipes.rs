//! Standard input and output, and pipes, which can be read only once.

use crate::outlines::bench::{Bench, SPOTS};
use assert_cmd::Command;
use std::process::Stdio;

const DRAWING: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" width="128" height="96"><circle cx="50" cy="50" r="9"/></svg>"#;
const TABLE: &str = "system,width,angle\nmeinhardt-stripes,8,20\n";

/// Runs `dapple` with these arguments and this input; returns stdout.
#[track_caller]
fn piped(bench: &Bench, arguments: &str, input: impl Into<Vec<u8>>) -> Vec<u8> {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    command.current_dir(bench.path("")).args(arguments.split_whitespace()).write_stdin(input);
    command.assert().success().get_output().stdout.clone()
}

#[test]
fn every_command_reads_standard_input_and_writes_to_standard_output() {
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.png");
    let picture = std::fs::read(bench.path("a.png")).unwrap();
    assert!(piped(&bench, "grow - -o -", SPOTS) == picture);
    assert!(piped(&bench, "grow - -o -", picture.clone()) == picture, "the picture holds its document");
    assert!(piped(&bench, "sheet - -o - --thumb 64", SPOTS).starts_with(b"\x89PNG"));
    assert!(piped(&bench, "film - -o - --side 32 --seconds 0.2 --fps 10", SPOTS).starts_with(b"GIF89a"));
    let text = |arguments: &str, input: &[u8]| String::from_utf8(piped(&bench, arguments, input)).unwrap();
    assert!(text("import - -o -", DRAWING.as_bytes()).starts_with("{\n  \"format\": \"dapple\""));
    assert!(text("lookup --batch - -o -", TABLE.as_bytes()).starts_with("system,width,angle,rate,"));
    assert!(text("check -", SPOTS.as_bytes()).contains("valid"));
    assert!(text("link -", SPOTS.as_bytes()).contains("#dapple1="));
    assert!(text("measure - --patches", &picture).contains("whole"));
    // Documents of version 1 are used, because they keep their marks; a tone does not.
    bench.write("tone.dapple", &SPOTS.replace("\"version\": 1", "\"version\": 2"));
    assert!(piped(&bench, "grow tone.dapple --tone - -o -", picture).starts_with(b"\x89PNG"));
}

#[test]
fn two_outputs_or_many_pictures_on_standard_output_are_refused() {
    let bench = Bench::new();
    bench.refuses("grow a.dapple -o - --report -", 2, &["found - twice"]);
    bench.refuses("grow a.dapple --variations 2 -o -", 2, &["standard output, which takes one picture"]);
    bench.write("a.svg", DRAWING);
    bench.refuses("import a.svg -o - --json", 2, &["standard output twice"]);
}

#[cfg(unix)]
#[test]
fn a_named_pipe_is_read_once_by_every_command() {
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.png");
    bench.write("in.svg", DRAWING);
    bench.write("in.csv", TABLE);
    std::process::Command::new("mkfifo").arg(bench.path("pipe")).status().unwrap();
    for (file, arguments) in [
        ("a.dapple", "grow pipe -o b.png -q"),
        ("a.dapple", "check pipe"),
        ("a.dapple", "grow pipe --variations 2 -o many -q"),
        ("a.png", "grow pipe -o c.png -q"),
        ("a.png", "measure pipe --patches"),
        ("in.svg", "import pipe -o b.dapple -q"),
        ("in.csv", "lookup --batch pipe -o b.csv"),
    ] {
        let mut feeds = std::process::Command::new("sh");
        feeds.current_dir(bench.path("")).args(["-c", &format!("cat {file} > pipe")]).stdout(Stdio::null());
        let mut feeds = feeds.spawn().unwrap();
        bench.does(arguments);
        assert!(feeds.wait().unwrap().success(), "{arguments}");
    }
    let document = bench.text("b.dapple");
    assert!(document.contains("\"name\": \"\""), "a pipe has no name: {document}");
    assert!(std::fs::read(bench.path("b.png")).unwrap() == std::fs::read(bench.path("a.png")).unwrap());
    std::process::Command::new("mkfifo").arg(bench.path("pipe.png")).status().unwrap();
    bench.refuses("grow a.dapple -o pipe.png", 1, &["neither a file nor a folder"]);
}
