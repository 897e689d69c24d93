//! Many documents at once, completions and manual pages, through the real binary.

use assert_cmd::Command;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

fn dapple() -> Command {
    Command::new(assert_cmd::cargo::cargo_bin!("dapple"))
}

fn document(folder: &Path, name: &str) -> PathBuf {
    let path = folder.join(format!("{name}.dapple"));
    let text = r#"{"format": "dapple", "version": 1, "size": [64, 64], "layers": [
        {"strokes": [{"kind": "ellipse", "center": [32, 32], "radii": [8, 5], "angle": 30}]}]}"#;
    fs::write(&path, text).unwrap();
    path
}

/// The names in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn one_document_that_fails_does_not_stop_the_others() {
    let folder = TempDir::new().unwrap();
    let [a, c] = ["a", "c"].map(|name| document(folder.path(), name));
    let broken = folder.path().join("b.dapple");
    fs::write(&broken, "{").unwrap();
    let out = folder.path().join("out");
    let run = dapple().arg("grow").args([&a, &broken, &c]).arg("-o").arg(&out).assert().code(1);
    let message = String::from_utf8(run.get_output().stderr.clone()).unwrap();
    assert!(message.contains("1 of 3 pictures were not grown") && message.contains("b.dapple"), "{message}");
    assert_eq!(names(&out), ["a.png", "c.png"]);
}

#[test]
fn a_picture_of_a_batch_equals_the_one_that_its_document_grows_alone() {
    let folder = TempDir::new().unwrap();
    let [a, b] = ["a", "b"].map(|name| document(folder.path(), name));
    let (out, alone) = (folder.path().join("out"), folder.path().join("alone.png"));
    dapple().arg("grow").args([&a, &b]).arg("-o").arg(&out).assert().success();
    dapple().arg("grow").arg(&b).arg("-o").arg(&alone).assert().success();
    assert!(fs::read(out.join("b.png")).unwrap() == fs::read(alone).unwrap());
}

#[test]
fn variations_are_pictures_of_several_seeds_and_a_sheet_of_all() {
    let folder = TempDir::new().unwrap();
    let (a, out) = (document(folder.path(), "a"), folder.path().join("out"));
    let seeds = ["--variations", "3", "--seed", "5", "--quiet"];
    dapple().arg("grow").arg(&a).arg("-o").arg(&out).args(seeds).assert().success();
    assert_eq!(names(&out), ["a-5.png", "a-6.png", "a-7.png", "a-sheet.png"]);
    let [first, second] = ["a-5.png", "a-6.png"].map(|name| fs::read(out.join(name)).unwrap());
    assert!(first != second);
    let sheet = image::open(out.join("a-sheet.png")).unwrap();
    assert!(sheet.width() > 256 && sheet.height() > 256);
}

#[test]
fn options_that_write_one_file_are_refused_for_several_documents() {
    let folder = TempDir::new().unwrap();
    let [a, b] = ["a", "b"].map(|name| document(folder.path(), name));
    let there = folder.path().join("a.png");
    let refused = |arguments: &[&str], word: &str| {
        let run = dapple().arg("grow").args([&a, &b]).args(arguments).assert().code(2);
        let message = String::from_utf8(run.get_output().stderr.clone()).unwrap();
        assert!(message.contains(word), "{message}");
    };
    refused(&["-o", there.to_str().unwrap()], "a folder");
    refused(&["-o", "out", "--pattern", "p.png"], "--pattern");
    refused(&["-o", "out", "--variations", "2"], "--variations");
    refused(&["-o", "out", a.to_str().unwrap()], "the same file");
    assert_eq!(names(folder.path()), ["a.dapple", "b.dapple"]);
}

#[test]
fn a_report_and_a_check_are_printed_as_json() {
    let folder = TempDir::new().unwrap();
    let a = document(folder.path(), "a");
    let json = |command: &mut Command| -> serde_json::Value {
        serde_json::from_slice(&command.assert().success().get_output().stdout).unwrap()
    };
    let output = folder.path().join("a.png");
    let report = json(dapple().arg("grow").arg(&a).args(["--report", "-", "-o"]).arg(&output));
    assert_eq!(report["size"], serde_json::json!([64, 64]));
    let check = json(dapple().arg("check").arg(&a).arg("--json"));
    let region = &check["layers"][0]["regions"][0];
    assert!((region["asked"]["area"].as_f64().unwrap() - 40.0 * std::f64::consts::PI).abs() < 1e-9);
    assert_eq!(check["layers"][0]["system"], report["layers"][0]["system"]);
    assert_eq!(check["layers"][0]["grid"], report["layers"][0]["grid"]);
    // The printed text has the same numbers.
    let printed = dapple().arg("check").arg(&a).assert().success().get_output().stdout.clone();
    let printed = String::from_utf8(printed).unwrap();
    let (number, grid) = (|value: &serde_json::Value| value.as_f64().unwrap(), &check["layers"][0]["grid"]);
    for shown in [
        format!("spots of {:.0} px²", number(&region["asked"]["area"])),
        format!("{} × {} cells of {:.2} px", grid[0], grid[1], number(&check["layers"][0]["cell"])),
        format!(
            "1. {}: {} ellipse",
            check["layers"][0]["name"].as_str().unwrap(),
            check["layers"][0]["drawn"]["ellipse"]
        ),
        region["coverage"].as_str().unwrap().to_owned(),
    ] {
        assert!(printed.contains(&shown), "{shown} in {printed}");
    }
}

#[test]
fn every_command_has_completions_and_a_manual_page() {
    let folder = TempDir::new().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell"] {
        let run = dapple().args(["completions", shell]).assert().success();
        let script = String::from_utf8(run.get_output().stdout.clone()).unwrap();
        assert!(script.contains("film") && script.contains("variations"), "{shell}");
    }
    dapple().args(["man", "-o"]).arg(folder.path()).assert().success();
    let pages = names(folder.path());
    assert!(
        pages.contains(&"dapple.1".to_owned()) && pages.contains(&"dapple-grow.1".to_owned()),
        "{pages:?}"
    );
    let page = dapple().args(["man", "grow"]).assert().success().get_output().stdout.clone();
    assert!(page == fs::read(folder.path().join("dapple-grow.1")).unwrap());
    assert!(String::from_utf8(page).unwrap().contains("\\-\\-variations"));
    dapple().args(["man", "gorw"]).assert().code(2);
    for page in pages {
        assert!(fs::read(folder.path().join(&page)).unwrap().is_ascii(), "{page}");
    }
}

/// The output of a program if it is installed and succeeds with these arguments. `None` if it is not installed, which
/// is reported on stderr.
fn told_by(program: &str, arguments: &[&str]) -> Option<(bool, String)> {
    let Ok(output) = std::process::Command::new(program).args(arguments).output() else {
        let _ = std::io::stderr().write_all(format!("SKIPPED: there is no {program} here\n").as_bytes());
        return None;
    };
    let shown = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
    Some((output.status.success(), shown.concat()))
}

#[test]
fn troff_and_mandoc_have_no_warnings_about_the_pages() {
    let folder = TempDir::new().unwrap();
    dapple().args(["man", "-o"]).arg(folder.path()).assert().success();
    for name in names(folder.path()) {
        let page = folder.path().join(&name);
        let page = page.to_str().unwrap();
        // With -T only warnings are printed, without the page.
        if let Some((_, shown)) = told_by("groff", &["-man", "-ww", "-z", page]) {
            assert_eq!(shown, "", "{name}");
        }
        if let Some((fine, shown)) = told_by("mandoc", &["-Tlint", "-Werror", page]) {
            assert!(fine, "{name}: {shown}");
        }
    }
}

#[test]
fn bash_completes_commands_options_and_values() {
    let folder = TempDir::new().unwrap();
    let script = folder.path().join("dapple.bash");
    let run = dapple().args(["completions", "bash"]).assert().success();
    fs::write(&script, &run.get_output().stdout).unwrap();
    let completed = |line: &[&str], last: &str| {
        let words = line.join(" ");
        let asked = format!(
            "source '{}'; COMP_WORDS=({words} '{last}'); COMP_CWORD={}; _dapple dapple '{last}' {}; echo \"${{COMPREPLY[@]}}\"",
            script.display(),
            line.len(),
            line[line.len() - 1]
        );
        told_by("bash", &["-c", &asked])
    };
    let Some((fine, shown)) = completed(&["dapple"], "gr") else { return };
    assert!(fine && shown.trim() == "grow", "{shown}");
    for (line, last, found) in [
        (&["dapple", "grow"][..], "--vari", "--variations"),
        (&["dapple", "film"], "--fp", "--fps"),
        (&["dapple", "completions"], "fi", "fish"),
    ] {
        let (fine, shown) = completed(line, last).unwrap();
        assert!(fine && shown.split_whitespace().any(|word| word == found), "{line:?} {last}: {shown}");
    }
}

#[test]
fn zsh_and_fish_read_their_completions() {
    let folder = TempDir::new().unwrap();
    for shell in ["zsh", "fish"] {
        let script = folder.path().join(shell);
        let run = dapple().args(["completions", shell]).assert().success();
        fs::write(&script, &run.get_output().stdout).unwrap();
        if let Some((fine, shown)) = told_by(shell, &["-n", script.to_str().unwrap()]) {
            assert!(fine && shown.is_empty(), "{shell}: {shown}");
        }
    }
}
