//! Errors for programs and for terminals.

use crate::outlines::bench::Bench;
use assert_cmd::Command;
use serde_json::Value;

/// What a failed command writes to stderr.
#[track_caller]
fn failed(bench: &Bench, arguments: &[&str], code: i32) -> String {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    let output = command.current_dir(bench.path("")).args(arguments).assert().code(code).get_output().clone();
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn with_json_an_error_is_one_object() {
    let bench = Bench::new();
    bench.write("broken.dapple", "{\"format\": \"dapple\", \"version\": 2, \"size\": [9, NaN]}");
    // Ellipses that cover each other leave no ground.
    bench.write(
        "full.dapple",
        r#"{"format": "dapple", "version": 2, "size": [65536, 65536], "layers": [{"strokes": [{"kind": "ellipse", "center": [9, 9], "radii": [1, 1]}]}]}"#,
    );
    bench.write("page.jpg", "<!DOCTYPE html><html></html>");
    for (arguments, code, words) in [
        (&["check", "none.dapple", "--json"][..], 1, "none.dapple: cannot be read"),
        (&["check", "broken.dapple", "--json"], 1, "NaN"),
        (&["check", "full.dapple", "--json"], 1, "full.dapple"),
        (&["check", "a.dapple", "--set", "layers[4].seed=1", "--json"], 1, "layers: found the index 4"),
        (&["measure", "page.jpg", "--json"], 1, "a web page"),
        (&["import", "page.jpg", "-o", "b.dapple", "--json"], 1, "a web page"),
        (&["lookup", "--system", "stripes", "--json"], 2, "--system"),
        (&["lookup", "--system", "turing-spots", "--json"], 2, "it needs --area"),
        (&["measure", "--json"], 2, "required"),
        (&["bench", "--only", "nothing", "--json"], 2, "--only"),
    ] {
        let said = failed(&bench, arguments, code);
        let object: Value = serde_json::from_str(&said).unwrap_or_else(|_| panic!("{arguments:?}: {said}"));
        assert!(object["error"].as_str().is_some_and(|text| text.contains(words)), "{arguments:?}: {said}");
        assert_eq!(object["code"], code);
    }
}

#[test]
fn control_characters_in_names_of_files_are_escaped() {
    let bench = Bench::new();
    let said = failed(&bench, &["check", "a\u{1b}[2J\u{7}.dapple"], 1);
    assert!(
        said.contains("a\\u{1b}[2J\\u{7}.dapple") && !said.trim_end().contains(char::is_control),
        "{said:?}"
    );
}

#[test]
fn a_batch_names_no_picture_that_was_not_made() {
    let bench = Bench::new();
    bench.write("b.dapple", "{");
    let said = failed(&bench, &["grow", "a.dapple", "b.dapple", "-o", "out"], 1);
    assert!(!said.contains(".png") && said.contains("1 of 2 pictures were not grown"), "{said}");
}
