//! Options that have no effect on the files that are written are reported.

use crate::grow::folder::{Folder, document};
use serde_json::json;

fn folder() -> Folder {
    let spots = json!([{"kind": "ellipse", "center": [12, 12], "radii": [4, 3], "angle": 30}]);
    Folder::with(&document([24, 24], &spots))
}

#[test]
fn an_option_without_effect_on_a_format_is_reported() {
    let folder = folder();
    for (line, option) in [
        ("grow a.dapple -o a.png --quality 50", "--quality"),
        ("grow a.dapple -o out --variations 2 --quality 50", "--quality"),
        ("grow a.dapple -o a.jpg --no-document", "--no-document"),
        ("grow a.dapple -o a.exr --depth 16", "--depth"),
        ("grow a.dapple -o a.dxf --ground", "--ground"),
        ("grow a.dapple -o a.dxf --style stroke --pen 1", "--pen"),
        ("grow a.dapple -o a.svg --transparent", "--transparent"),
        ("film a.dapple -o frames --seconds 0.2 --fps 10 --once", "--once"),
        ("film a.dapple -o f.gif --seconds 0.2 --fps 10 --once --hold 2", "--hold"),
    ] {
        let said = folder.dapple(line).assert().success().get_output().stderr.clone();
        let said = String::from_utf8(said).unwrap();
        let notes = said.lines().filter(|line| line.contains("has no effect"));
        let notes: Vec<&str> = notes.collect();
        assert!(notes.len() == 1 && notes[0].starts_with(&format!("note: {option} ")), "{line}: {said}");
        std::fs::remove_dir_all(folder.path("frames")).unwrap_or_default();
    }
}

#[test]
fn an_option_with_an_effect_is_not_reported() {
    let folder = folder();
    for line in [
        "grow a.dapple -o a.jpg --quality 50",
        "grow a.dapple -o a.png --no-document --depth 16 --transparent",
        "grow a.dapple --material m --depth 16 --transparent",
        "grow a.dapple --svg a.svg --dxf a.dxf --ground --style stroke --pen 1",
        "grow a.dapple --dxf a.dxf --style hatch:2 --pen 1",
        "film a.dapple -o f.gif --seconds 0.2 --fps 10 --hold 0.1",
        "film a.dapple -o f.png --seconds 0.2 --fps 10 --once",
    ] {
        let said = folder.dapple(line).assert().success().get_output().stderr.clone();
        assert!(!String::from_utf8_lossy(&said).contains("has no effect"), "{line}");
    }
}
