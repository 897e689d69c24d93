//! Every kind of output has the same bytes with any number of threads and any solver that this machine has.

use crate::folder::Folder;
use dapple_engine::rd::Solver;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// A document whose spots change from region to region, with rings around them and stripes between, at closed edges. It
/// has enough cells for four bands.
fn closed() -> String {
    let ellipse = |x: f64, y: f64, r: [f64; 2], angle: f64| json!({"kind": "ellipse", "center": [x, y], "radii": r, "angle": angle});
    let spots = [
        ellipse(40.0, 50.0, [11.0, 8.0], 20.0),
        ellipse(86.0, 52.0, [11.0, 8.0], 20.0),
        ellipse(63.0, 92.0, [11.0, 8.0], 20.0),
        ellipse(160.0, 50.0, [10.0, 9.0], 70.0),
        ellipse(205.0, 52.0, [10.0, 9.0], 70.0),
        ellipse(182.0, 90.0, [10.0, 9.0], 70.0),
    ];
    let line = |from: [f64; 2], to: [f64; 2], width: f64| json!({"kind": "line", "from": from, "to": to, "width": width});
    json!({"format": "dapple", "version": 1, "size": [240, 110], "regions": [2, 1], "layers": [
        {"strokes": spots},
        {"after": "around", "options": {"broken": 0.3}, "strokes": [line([20.0, 20.0], [60.0, 20.0], 3.0)]},
        {"after": "between", "strokes": [line([20.0, 90.0], [90.0, 100.0], 4.0), line([150.0, 105.0], [200.0, 90.0], 4.0)]},
    ]})
    .to_string()
}

/// A document of irregular spots with Turing's three fields, with small spots inside, on a seamless canvas.
fn wrap() -> String {
    json!({"format": "dapple", "version": 1, "size": [150, 150], "edges": "wrap", "seed": 9, "layers": [
        {"options": {"irregular": 0.6}, "strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [11, 9]}]},
        {"after": "inside", "strokes": [{"kind": "ellipse", "center": [60, 60], "radii": [4, 3], "angle": 30}]},
    ]})
    .to_string()
}

/// Commands that write the outputs of a document. The first one writes everything that was grown, concentrations too;
/// the others write more kinds of files.
const COMMANDS: [&str; 6] = [
    "grow a.dapple -o a.png --pattern p.png --labels l.png --concentrations c.exr --svg o.svg --dxf o.dxf \
     --material m --report r.json",
    "grow a.dapple -o a.exr --pattern p.exr --no-refine",
    "grow a.dapple -o a.webp --transparent --no-refine --svg h.svg --style hatch:2 --report n.json",
    "grow a.dapple -o a.tif --depth 16 --pattern p.tif --layer 1 --size 150x170 --no-refine",
    "film a.dapple -o f.gif --seconds 0.3 --fps 10 --side 64 --no-refine",
    "film a.dapple -o f.png --seconds 0.3 --fps 10 --side 64 --no-refine",
];

/// The files that `commands` write for the document, with the durations removed.
fn outputs(document: &str, commands: &[&str], threads: usize, solver: &str) -> BTreeMap<String, Vec<u8>> {
    let folder = Folder::with(document);
    for command in commands {
        let printed = folder.dapple(&format!("{command} --threads {threads} --quiet"), solver);
        assert!(printed.is_empty());
    }
    let mut files = folder.files();
    for name in ["r.json", "n.json"] {
        let Some(report) = files.get(name) else { continue };
        let mut report: Value = serde_json::from_slice(report).unwrap();
        assert!(report.as_object_mut().unwrap().remove("seconds").is_some());
        files.insert(name.to_owned(), report.to_string().into_bytes());
    }
    files
}

/// Asserts that the outputs equal those of `as_usual`.
#[track_caller]
fn same(as_usual: &BTreeMap<String, Vec<u8>>, others: &BTreeMap<String, Vec<u8>>, who: &str) {
    let differ: Vec<&String> = as_usual
        .iter()
        .filter(|(name, bytes)| others.get(*name) != Some(*bytes))
        .map(|(name, _)| name)
        .collect();
    assert!(differ.is_empty() && as_usual.len() == others.len(), "{who}: other bytes in {differ:?}");
}

/// Compares the outputs with those of one thread and the fastest solver: the outputs of all `commands` for other
/// numbers of threads, and those of the first command for other solvers. Returns the names of the files.
fn any_threads_and_solvers(document: &str, commands: &[&str]) -> Vec<String> {
    let as_usual = outputs(document, commands, 1, "");
    for threads in [2, 4] {
        same(&as_usual, &outputs(document, commands, threads, ""), &format!("{threads} threads"));
    }
    let solvers = Solver::available();
    for (k, solver) in solvers.iter().enumerate() {
        let others = outputs(document, &COMMANDS[..1], 1 + k % 2, solver.name());
        let made_by_both = as_usual.iter().filter(|(name, _)| others.contains_key(*name));
        same(
            &made_by_both.map(|(name, bytes)| (name.clone(), bytes.clone())).collect(),
            &others,
            solver.name(),
        );
    }
    println!("the same bytes by {:?}", solvers.into_iter().map(Solver::name).collect::<Vec<_>>());
    as_usual.into_keys().collect()
}

#[test]
fn a_closed_texture_of_three_layers_has_the_same_bytes_by_any_threads_and_solver() {
    any_threads_and_solvers(&closed(), &COMMANDS[..1]);
}

#[test]
fn a_seamless_texture_of_irregular_spots_has_the_same_bytes_by_any_threads_and_solver() {
    let made = any_threads_and_solvers(&wrap(), &COMMANDS);
    for ending in ["png", "exr", "webp", "tif", "svg", "dxf", "json", "gif", "gltf"] {
        assert!(made.iter().any(|name| name.ends_with(&format!(".{ending}"))), "no .{ending}");
    }
}

#[test]
fn the_requested_solver_takes_the_steps() {
    let folder = Folder::with("");
    for solver in Solver::available() {
        let shown =
            folder.dapple("bench --quick --json --size 32 --only turing-spots/isotropic", solver.name());
        let shown: Value = serde_json::from_slice(&shown).unwrap();
        assert_eq!(shown["machine"]["instructions"], json!(solver.name()));
    }
    let output = assert_cmd::Command::new(assert_cmd::cargo::cargo_bin!("dapple"))
        .args(["check", "a.dapple"])
        .env("DAPPLE_SOLVER", "abacus")
        .assert()
        .code(2)
        .get_output()
        .clone();
    let message = String::from_utf8(output.stderr).unwrap();
    assert!(["DAPPLE_SOLVER", "abacus", "plain"].iter().all(|word| message.contains(word)), "{message}");
}
