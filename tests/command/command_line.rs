//! The command line itself, through the real binary: exit codes, usage, and closed pipes.

use assert_cmd::Command;
use serde_json::{Value, json};
use std::process::Stdio;

const DOCUMENT: &str = r#"{"format": "dapple", "version": 1, "size": [64, 64], "layers": [
    {"strokes": [{"kind": "ellipse", "center": [32, 32], "radii": [8, 5], "angle": 30}]}]}"#;

fn dapple() -> Command {
    Command::new(assert_cmd::cargo::cargo_bin!("dapple"))
}

/// Asserts exit code 2, nothing on stdout, and a message with these words.
#[track_caller]
fn used_wrongly(arguments: &[&str], words: &[&str]) {
    let output = dapple().args(arguments).assert().code(2).get_output().clone();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(output.stdout.is_empty());
    assert!(message.starts_with("error: "), "{message}");
    for word in words {
        assert!(message.contains(word), "{word} in {message}");
    }
}

#[test]
fn help_names_the_commands() {
    let output = dapple().arg("--help").assert().success().get_output().clone();
    let help = String::from_utf8(output.stdout).unwrap();
    for command in ["grow", "lookup", "measure", "check", "bench"] {
        assert!(help.contains(command), "{help}");
    }
    dapple().arg("--version").assert().success();
}

/// There is no display in this test.
#[cfg(all(target_os = "linux", feature = "app"))]
#[test]
fn without_a_display_one_line_says_which_commands_work() {
    for arguments in [&[][..], &["cheetah.dapple"]] {
        let mut dapple = dapple();
        for variable in ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"] {
            dapple.env_remove(variable);
        }
        let output = dapple.args(arguments).assert().code(1).get_output().clone();
        let message = String::from_utf8(output.stderr).unwrap();
        assert!(message.contains("display") && message.contains("dapple grow"), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
    }
}

#[test]
fn a_link_holds_a_document_and_grows_in_place_of_a_file() {
    let folder = tempfile::tempdir().unwrap();
    let (file, [one, other]) =
        (folder.path().join("a.dapple"), ["1.png", "2.png"].map(|name| folder.path().join(name)));
    std::fs::write(&file, DOCUMENT).unwrap();
    let output = dapple()
        .arg("link")
        .arg(&file)
        .args(["--site", "https://a.example/"])
        .assert()
        .success()
        .get_output()
        .clone();
    let link = String::from_utf8(output.stdout).unwrap();
    assert!(link.starts_with("https://a.example/#dapple1=") && link.lines().count() == 1, "{link}");
    dapple().arg("grow").arg(&file).arg("-o").arg(&one).assert().success();
    dapple().arg("grow").arg(link.trim()).arg("-o").arg(&other).assert().success();
    let [one, other] = [one, other].map(|path| std::fs::read(path).unwrap());
    assert!(one == other, "other bytes");
    let output = dapple().args(["check", link.trim()]).assert().success().get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("the link: valid"), "{text}");
    used_wrongly(&["grow", link.trim(), link.trim(), "-o", "folder"], &["found a link"]);
}

#[test]
fn an_unknown_command_is_a_usage_error() {
    used_wrongly(&["gorw"], &["gorw", "grow"]);
    used_wrongly(&["gorw", "a.dapple", "-o", "a.png"], &["gorw", "grow"]);
    used_wrongly(&["check"], &["<FILE>"]);
}

#[test]
fn values_out_of_range_are_usage_errors() {
    let grow = |rest: &[&str], words: &[&str]| {
        used_wrongly(&[&["grow", "a.dapple", "-o", "a.png"], rest].concat(), words);
    };
    grow(&["--size", "0x10"], &["--size", "0x10", "1 to 65536"]);
    grow(&["--size", "4096x"], &["--size", "4096x"]);
    grow(&["--scale", "0"], &["--scale", "1 to 64"]);
    grow(&["--threads", "0"], &["--threads", "1 to 1024"]);
    grow(&["--seed", "-1"], &["-1"]);
    grow(&["--layer", "1"], &["--pattern"]);
    grow(&["--labels", "a.png"], &["--labels", "--output", "a.png"]);
    used_wrongly(&["grow", "a.dapple"], &["--output"]);
}

#[test]
fn an_incomplete_lookup_is_a_usage_error() {
    used_wrongly(&["lookup"], &["--system"]);
    used_wrongly(&["lookup", "--system", "auto"], &["turing-spots"]);
    used_wrongly(&["lookup", "--system", "turing-spots"], &["--area"]);
    used_wrongly(
        &["lookup", "--system", "turing-spots", "--area", "nan", "--aspect", "1"],
        &["nan", "above 0"],
    );
    let stripes =
        ["lookup", "--system", "meinhardt-stripes", "--area", "9", "--aspect", "1", "--angle", "-5"];
    used_wrongly(&stripes, &["--width"]);
    let of = |system, duty| ["lookup", "--system", system, "--width", "9", "--angle", "1", "--duty", duty];
    used_wrongly(&of("meinhardt-stripes", "0.3"), &["--duty", "allowed: 0.5", "Meinhardt's lines"]);
    used_wrongly(&of("meinhardt-lines", "0.1"), &["--duty", "from 0.18 to 0.82"]);
    used_wrongly(&["lookup", "--batch", "in.csv"], &["--output"]);
    used_wrongly(&["lookup", "--batch", "in.csv", "-o", "out.csv", "--width", "5"], &["--width"]);
}

/// The answer of `dapple lookup --json` with these arguments.
fn looked_up(arguments: &str) -> Value {
    let output = dapple().args(["lookup", "--json"]).args(arguments.split_whitespace()).assert().success();
    serde_json::from_slice(&output.get_output().stdout).unwrap()
}

#[test]
fn systems_of_pairs_are_looked_up_direction_by_direction() {
    let number = |answer: &Value, of: &str, name: &str| answer[of][name].as_f64().unwrap_or(f64::NAN);
    let weave = looked_up("--system weave --width 6 --angle 10 --duty 0.3 --across 100 --across 55,4,0.2");
    assert_eq!(weave["coverage"], "inside", "{weave}");
    let sizes = ["size 1", "size 2", "size 3"].map(|name| number(&weave, "parameters", name));
    assert!(sizes.iter().all(|size| (0.5..4.0).contains(size)), "{weave}");
    assert!((sizes[0] / sizes[1] - 1.0).abs() < 0.01 && sizes[2] < sizes[0], "{weave}");
    assert_eq!((number(&weave, "asked", "period 3"), number(&weave, "asked", "angle 2")), (20.0, 100.0));
    let [low, high] = [0, 1].map(|end| weave["interval"]["width 1"][end].as_f64().unwrap());
    assert!(low < 6.0 && 6.0 < high, "{weave}");
    let cells = looked_up("--system cells --area 900 --aspect 0.7 --angle 0 --gap 5");
    assert!(number(&cells, "parameters", "distance") > 30.0 && cells["coverage"] == "inside", "{cells}");
    let dots = looked_up("--system stucco --width 5 --decay 0.8");
    let worms = looked_up("--system stucco --width 5 --decay 0.1");
    // Dots that are as wide as worms are farther apart.
    let [dots, worms] = [&dots, &worms].map(|of| number(of, "parameters", "size"));
    assert!(dots > 1.1 * worms, "{dots} {worms}");
    let maze = looked_up("--system maze --width 5 --angle 0 --across 90 --long 40");
    assert!((0.9..1.1).contains(&number(&maze, "parameters", "level")), "{maze}");
    assert_eq!(maze["coverage"], "inside", "right angles are at the end of the rows: {maze}");
    let thin = looked_up("--system pair-stripes --width 2 --angle 30 --duty 0.18");
    assert!(number(&thin, "parameters", "size") > 0.0, "{thin}");
}

#[test]
fn a_lookup_of_pairs_says_what_was_asked_and_the_nearest_that_can_grow() {
    let number = |answer: &Value, of: &str, name: &str| answer[of][name].as_f64().unwrap_or(f64::NAN);
    // No period was asked for.
    let weave = looked_up("--system weave --width 6 --angle 10 --across 100,4,0.2");
    let asked: Vec<&String> = weave["asked"].as_object().unwrap().keys().collect();
    assert_eq!(asked, ["width 1", "angle 1", "width 2", "period 2", "angle 2"], "{weave}");
    assert!(
        weave["notes"].to_string().contains("period 1") && weave["notes"].to_string().contains("21.43 px"),
        "{weave}"
    );
    let maze = looked_up("--system maze --width 6 --angle 0 --duty 0.2 --across 90 --long 40");
    assert_eq!([number(&maze, "asked", "long"), number(&maze, "asked", "period 2")], [40.0, 30.0]);
    assert!((number(&maze, "predicted", "width 1") - 9.6).abs() < 0.01, "{maze}");
    assert!(maze["coverage"] == "outside" && maze["notes"].to_string().contains("9.6 px wide"), "{maze}");
    let dense = looked_up("--system weave --width 6 --angle 0 --duty 0.8 --across 90");
    assert!(dense["coverage"] == "outside" && number(&dense, "predicted", "period 1") > 12.0, "{dense}");
    assert!(dense["notes"].to_string().contains("at least 12 px apart"), "{dense}");
    assert_eq!(looked_up("--system stucco --width 5 --decay 0.3")["asked"]["decay"], 0.3);
    // Directions that differ by 25° count as two in a maze.
    looked_up("--system maze --width 6 --angle 0 --across 25");
    used_wrongly(&["lookup", "--system", "stucco", "--width", "1e-30"], &["--width", "from 1e-6 to 1e12"]);
    used_wrongly(&["lookup", "--system", "stucco", "--width", "1e-6"], &["found 5e-7", "from 0.01"]);
    used_wrongly(&["lookup", "--system", "stucco", "--width", "1e6"], &["--width", "at most 4096 px"]);
}

#[test]
fn a_lookup_of_pairs_that_lacks_or_has_too_much_is_a_usage_error() {
    let weave = ["lookup", "--system", "weave", "--width", "6", "--angle", "1"];
    used_wrongly(&weave, &["--across", "one to four"]);
    used_wrongly(&[&weave[..], &["--across", "11"]].concat(), &["--across", "count as one"]);
    let cells = ["lookup", "--system", "cells", "--area", "9", "--aspect", "1", "--angle", "0"];
    used_wrongly(&[&cells[..], &["--raggedness", "2"]].concat(), &["--raggedness", "patches"]);
    let stripes = ["lookup", "--system", "meinhardt-stripes", "--width", "9", "--angle", "1"];
    used_wrongly(&[&stripes[..], &["--across", "90"]].concat(), &["--across", "weave and maze"]);
    used_wrongly(&[&stripes[..], &["--across", "90,x"]].concat(), &["'x'"]);
}

#[test]
fn patches_streaks_and_cracks_are_looked_up_by_their_laws() {
    let patches =
        |more: &str| looked_up(&format!("--system patches --area 900 --aspect 0.7 --angle 20 {more}"));
    let [smooth, ragged] = ["--spacing 60", "--spacing 60 --raggedness 1.5"].map(patches);
    assert_eq!((&smooth["coverage"], &ragged["coverage"]), (&"inside".into(), &"inside".into()));
    let sigma = |of: &Value| of["parameters"]["sigma"].as_f64().unwrap();
    assert!(sigma(&smooth) == 0.0 && sigma(&ragged) > 0.15, "{ragged}");
    assert!((ragged["predicted"]["raggedness"].as_f64().unwrap() - 1.5).abs() < 0.01, "{ragged}");
    let dense = patches("--spacing 25");
    assert!(
        dense["coverage"] == "outside" && dense["notes"][0].as_str().unwrap().contains("72 %"),
        "{dense}"
    );
    let cracks = looked_up("--system cracks --width 6 --duty 0.2");
    assert!((cracks["predicted"]["share"].as_f64().unwrap() - 0.36).abs() < 1e-9, "{cracks}");
    assert!(
        cracks["asked"]["angle"].is_null() && cracks["parameters"]["mesh"].as_f64().unwrap() > 20.0,
        "{cracks}"
    );
    let streaks = looked_up("--system streaks --width 6 --angle 30");
    assert!((streaks["predicted"]["wavelength"].as_f64().unwrap() - 15.0).abs() < 1e-9, "{streaks}");
    used_wrongly(&["lookup", "--system", "streaks", "--width", "6"], &["--angle"]);
    used_wrongly(&["lookup", "--system", "points"], &["points", "patches"]);
    let spots = ["lookup", "--system", "turing-spots", "--area", "90", "--aspect", "1", "--angle", "0"];
    used_wrongly(&[&spots[..], &["--raggedness", "1.2"]].concat(), &["--raggedness", "patches"]);
}

/// The output of `dapple bench --quick --json` with these arguments.
fn benched(arguments: &[&str]) -> Value {
    let output = dapple().args(["bench", "--quick", "--json"]).args(arguments).assert().success();
    assert!(output.get_output().stderr.is_empty());
    serde_json::from_slice(&output.get_output().stdout).unwrap()
}

#[test]
fn bench_json_has_the_rates_of_each_case_and_size() {
    let printed = benched(&["--size", "64,48", "--threads", "2", "--only", "aspect-0.5"]);
    assert!(printed["machine"]["processor"].is_string() && printed["machine"]["cores"].is_u64(), "{printed}");
    let instructions = printed["machine"]["instructions"].as_str().unwrap();
    assert!(["avx512", "avx2", "neon", "baseline"].contains(&instructions));
    assert_eq!((&printed["threads"], &printed["pictures"]), (&json!(2), &json!([])));
    assert!(printed["load"]["before"].is_f64() || cfg!(not(target_os = "linux")));
    let kernels = printed["kernels"].as_array().unwrap();
    let names: Vec<String> =
        kernels.iter().map(|k| format!("{} {} {}", k["system"], k["diffusion"], k["size"])).collect();
    let expected = ["turing-spots", "meinhardt-spots", "meinhardt-stripes"]
        .map(|system| [64, 48].map(|size| format!("\"{system}\" \"aspect-0.5\" {size}")));
    assert_eq!(names, expected.concat());
    for kernel in kernels {
        for rate in ["plain", "fast_one_thread", "fast_all_threads", "fast_over_plain", "all_over_one"] {
            assert!(kernel[rate].as_f64().unwrap() > 0.0, "{rate}: {kernel}");
        }
    }
}

#[test]
fn bench_times_documents_until_their_pictures_are_written() {
    let printed = benched(&["--only", "picture/ladybird"]);
    let [picture] = &printed["pictures"].as_array().unwrap()[..] else { panic!("{printed}") };
    assert_eq!((&picture["document"], &picture["size"]), (&json!("ladybird"), &json!([512, 512])));
    assert!(picture["seconds"].as_f64().unwrap() > 0.0);
    assert_eq!(printed["kernels"], json!([]));
}

#[test]
fn bench_without_json_prints_a_table() {
    let arguments = ["bench", "--quick", "--size", "32", "--only", "turing-spots/isotropic"];
    let output = dapple().args(arguments).assert().success().get_output().clone();
    let table = String::from_utf8(output.stdout).unwrap();
    for word in ["load", "turing-spots", "isotropic", "32²", "fast/plain"] {
        assert!(table.contains(word), "{table}");
    }
}

#[test]
fn a_bench_without_cases_is_a_usage_error() {
    used_wrongly(&["bench", "--size", "0"], &["--size", "16 to 4096"]);
    used_wrongly(&["bench", "--size", "64,100000"], &["--size", "100000", "16 to 4096"]);
    used_wrongly(&["bench", "--size", "64x64"], &["--size", "64x64", "16 to 4096"]);
    used_wrongly(&["bench", "--threads", "0"], &["--threads", "1 to 1024"]);
    used_wrongly(&["bench", "--only", "zebra-spots"], &["--only", "zebra-spots", "turing-spots/isotropic"]);
}

#[test]
fn a_closed_pipe_is_no_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.dapple");
    std::fs::write(&path, DOCUMENT).unwrap();
    for arguments in [vec!["--help".into()], vec!["check".into(), path.into_os_string()]] {
        let mut child = std::process::Command::new(assert_cmd::cargo::cargo_bin!("dapple"))
            .args(arguments)
            .stdout(closed_pipe())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let mut message = String::new();
        std::io::Read::read_to_string(child.stderr.as_mut().unwrap(), &mut message).unwrap();
        assert_eq!((child.wait().unwrap().code(), message.as_str()), (Some(0), ""));
    }
}

/// A pipe whose reading end is closed.
fn closed_pipe() -> std::io::PipeWriter {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    writer
}
