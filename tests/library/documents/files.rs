//! Files, and the command that checks them.

use super::*;
use dapple::{ReadFile, WriteFile};

#[test]
fn a_file_that_cannot_be_read_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let error = Document::read(folder.path()).unwrap_err();
    assert!(matches!(error, DocumentError::Folder { .. }), "{error}");
    let missing = folder.path().join("missing.dapple");
    let error = Document::read(&missing).unwrap_err();
    assert!(error.to_string().contains("missing.dapple: cannot be read"), "{error}");
}

#[test]
fn a_file_that_is_not_utf8_is_refused_with_the_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("latin.dapple");
    std::fs::write(&path, b"{\n \"name\": \"J\xe4ger\"}").unwrap();
    let message = Document::read(&path).unwrap_err().to_string();
    assert!(
        message.ends_with("line 2, column 12: found the byte 0xe4; allowed: JSON text in UTF-8"),
        "{message}"
    );
    let wide: Vec<u8> =
        std::iter::once(0xfeff).chain("{}".encode_utf16()).flat_map(u16::to_le_bytes).collect();
    std::fs::write(&path, wide).unwrap();
    let message = Document::read(&path).unwrap_err().to_string();
    assert!(message.contains("looks like UTF-16"), "{message}");
}

#[test]
fn a_written_file_is_read_back_and_nothing_is_left_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dapple");
    let mut document = accepted(&least());
    document.write(&path).unwrap();
    document.seed = 9;
    document.write(&path).unwrap();
    assert_eq!(Document::read(&path).unwrap(), document);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_document_that_could_not_be_read_back_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dapple");
    let mut document = accepted(&least());
    document.write(&path).unwrap();
    let before = std::fs::read(&path).unwrap();
    document.layers[0].strokes = vec![Stroke::Ellipse(Ellipse::from_area([f64::NAN, 5.0], 9.0, 1.0, 0.0))];
    let message = document.write(&path).unwrap_err().to_string();
    assert!(message.contains("layers[0].strokes[0].center[0]: found null"), "{message}");
    assert_eq!(std::fs::read(&path).unwrap(), before);
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_document_is_written_in_readable_form() {
    let mut document = accepted(&least());
    document.layers[0].colours =
        Some(Colours { stops: vec![Stop::opaque(0.5, [1, 2, 255])], ..Colours::new([]) });
    let expected = r##"{
  "format": "dapple",
  "version": 2,
  "name": "",
  "size": [512, 256],
  "edges": "closed",
  "seed": 1,
  "dpi": 300,
  "growth": {"refine": true},
  "layers": [
    {
      "name": "layer 1",
      "system": "auto",
      "after": "between",
      "visible": true,
      "strokes": [
        {"kind": "ellipse", "center": [64, 64], "radii": [12, 6], "angle": 30}
      ],
      "options": {},
      "colours": {
        "stops": [
          {"at": 0.5, "colour": "#0102ff"}
        ],
        "bends": []
      }
    }
  ]
}
"##;
    assert_eq!(document.to_json(), expected);
}

fn check(path: &std::path::Path) -> assert_cmd::assert::Assert {
    Command::new(assert_cmd::cargo::cargo_bin!("dapple")).arg("check").arg(path).assert()
}

#[test]
fn check_prints_the_content_of_a_valid_document() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dapple");
    accepted(&with("/name", json!("cheetah"))).write(&path).unwrap();
    let output = check(&path).success().get_output().clone();
    let shown = String::from_utf8(output.stdout).unwrap();
    for words in ["a.dapple: valid", "cheetah", "512 × 256 px", "layer 1", "1 ellipse"] {
        assert!(shown.contains(words), "{words} in {shown}");
    }
    assert!(output.stderr.is_empty());
}

#[test]
fn check_refuses_with_one_message_and_exit_code_1() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dapple");
    let zero = with("/layers/0/strokes/0/radii", json!([0, 6])).to_string();
    let nan = least().to_string().replace("[12,", "[NaN,");
    let newer = with("/version", json!(3)).to_string();
    let deep = "[".repeat(100_000);
    for bad in [zero.as_str(), &nan, &newer, &deep, "", "{}", "\u{feff}"] {
        std::fs::write(&path, bad).unwrap();
        refused_by_the_command(&path);
    }
    std::fs::write(&path, b"\xff\xfe{").unwrap();
    refused_by_the_command(&path);
    refused_by_the_command(folder.path());
    refused_by_the_command(&folder.path().join("missing.dapple"));
}

fn refused_by_the_command(path: &std::path::Path) {
    let output = check(path).code(1).get_output().clone();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.stdout.is_empty());
    assert!(message.starts_with(&format!("error: {}", path.display())), "{message}");
    assert_eq!(message.lines().count(), 1, "{message}");
}
