//! Documents that cannot be grown are refused at once, in one line, and nothing is written.

use crate::grow::folder::{Folder, document, spots};
use serde_json::json;

#[test]
fn a_missing_layer_is_a_usage_error() {
    let folder = Folder::with(&spots());
    folder.refuses("grow a.dapple -o a.png --pattern p.png --layer 2", 2, &["--layer", "2", "1 to 1"]);
}

#[test]
fn the_document_is_not_overwritten() {
    let folder = Folder::with(&spots());
    let before = folder.bytes("a.dapple");
    std::fs::create_dir(folder.path("sub")).unwrap();
    for arguments in [
        "grow a.dapple -o a.dapple",
        "grow a.dapple -o a.png --report a.dapple",
        "grow a.dapple -o a.png --report ./a.dapple",
        "grow ./a.dapple -o a.png --report sub/../a.dapple",
        "grow a.dapple -o a.png --pattern ./a.png",
        "grow a.dapple -o a.png --pattern p.png --labels sub/../p.png",
    ] {
        folder.refuses(arguments, 2, &["found", "two files"]);
    }
    assert!(folder.bytes("a.dapple") == before);
}

#[cfg(unix)]
#[test]
fn the_document_is_not_overwritten_through_another_name() {
    let folder = Folder::with(&spots());
    std::os::unix::fs::symlink("a.dapple", folder.path("link.json")).unwrap();
    folder.refuses("grow a.dapple -o a.png --report link.json", 2, &["link.json", "two files"]);
}

#[test]
fn a_missing_folder_is_reported_before_anything_is_written() {
    let folder = Folder::with(&spots());
    folder.refuses("grow a.dapple -o no/a.png", 1, &["no/a.png", "does not exist"]);
    for option in ["--pattern no/p.png", "--labels no/l.png", "--report no/r.json"] {
        folder.refuses(&format!("grow a.dapple -o a.png {option}"), 1, &["no/", "does not exist"]);
    }
    folder.refuses("grow a.dapple -o a.gif", 1, &["a.gif", ".png"]);
    folder.refuses("grow a.dapple -o . --labels l.png", 1, &["folder"]);
    folder.refuses("grow b.dapple -o a.png", 1, &["b.dapple", "read"]);
}

#[test]
fn a_growth_beyond_the_free_memory_is_refused_with_the_numbers() {
    let dot = json!([{"kind": "ellipse", "center": [5, 5], "radii": [0.5, 0.5], "angle": 0}]);
    let folder = Folder::with(&document([300, 300], &dot));
    let before = folder.names();
    let arguments = "grow a.dapple -o a.png --size 65536x65536";
    let mut command = folder.dapple(arguments);
    // Without the check this would take hours.
    let output = command.timeout(std::time::Duration::from_secs(60)).assert().code(1).get_output().clone();
    let message = String::from_utf8(output.stderr).unwrap();
    for word in ["65536×65536 px", "cells", "GB", "--size"] {
        assert!(message.contains(word), "{word} in {message}");
    }
    assert_eq!(folder.names(), before);
}

/// The limit of the address space is for this process alone.
#[cfg(target_os = "linux")]
#[test]
fn a_growth_beyond_the_process_s_own_limit_is_refused_with_the_numbers() {
    let folder = Folder::with(&spots());
    let program = assert_cmd::cargo::cargo_bin!("dapple").display().to_string();
    let limited = |size: &str| {
        let line =
            format!("ulimit -v 700000; '{program}' grow a.dapple -o a.png --threads 2 --quiet --size {size}");
        std::process::Command::new("sh").args(["-c", &line]).current_dir(folder.path("")).output().unwrap()
    };
    let refused = limited("8192x8192");
    let message = String::from_utf8(refused.stderr).unwrap();
    assert_eq!(refused.status.code(), Some(1), "{message}");
    assert!(message.contains("GB are free") && message.lines().count() == 1, "{message}");
    let grown = limited("256x256");
    assert_eq!(grown.status.code(), Some(0), "{}", String::from_utf8_lossy(&grown.stderr));
}

#[test]
fn a_stroke_that_is_neither_ellipse_nor_line_is_reported_with_its_place() {
    let ellipse = json!({"kind": "ellipse", "center": [50, 50], "radii": [6, 6], "angle": 0});
    let line = json!({"kind": "freehand", "points": [[10, 10], [30, 12], [60, 14]], "width": 5});
    let folder = Folder::with(&document([100, 100], &json!([ellipse, line])));
    folder.refuses("grow a.dapple -o a.png", 1, &["a.dapple", "layers[0].strokes[1]"]);
    let folder = Folder::with(&{
        let mut document = document([100, 100], &json!([line]));
        document["layers"][0]["system"] = json!("turing-spots");
        document
    });
    folder.refuses("grow a.dapple -o a.png", 1, &["a.dapple", "turing-spots"]);
}
