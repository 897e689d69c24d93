//! `dapple learn` through the real binary: the table of errors.

use assert_cmd::Command;
use std::collections::BTreeSet;
use std::path::Path;

fn learn(arguments: &[&str], folder: &Path) -> std::process::Output {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    command.current_dir(folder).arg("learn").args(arguments).assert().get_output().clone()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The cells of a table, its header first.
fn table(path: &Path) -> Vec<Vec<String>> {
    let text = std::fs::read_to_string(path).unwrap();
    text.lines().map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

/// The values of a column, each once.
fn distinct(table: &[Vec<String>], column: usize) -> BTreeSet<&str> {
    table[1..].iter().map(|line| line[column].as_str()).collect()
}

#[test]
fn errors_in_parameters_are_listed_for_every_system_and_method_and_fall_with_more_rows() {
    let folder = tempfile::tempdir().unwrap();
    let output = learn(&["--no-simulation", "-o", "table.csv"], folder.path());
    assert!(output.status.success() && output.stderr.is_empty(), "{}", text(&output.stderr));
    for word in ["turing-spots", "nearest neighbour", "scale law", "LWR", "direction °"] {
        assert!(text(&output.stdout).contains(word), "{word} in {}", text(&output.stdout));
    }
    let table = table(&folder.path().join("table.csv"));
    let columns = [
        "system",
        "errors",
        "method",
        "rows",
        "all",
        "quantity",
        "unit",
        "count",
        "median",
        "p95",
        "median_bound",
        "p95_bound",
        "verdict",
    ];
    assert_eq!(table[0], columns);
    assert!(table.iter().all(|line| line.len() == columns.len()));
    assert_eq!(
        distinct(&table, 0).into_iter().collect::<Vec<_>>(),
        [
            "cells",
            "maze",
            "meinhardt-lines",
            "meinhardt-spots",
            "meinhardt-stripes",
            "pair-stripes",
            "stucco",
            "turing-spots",
            "weave"
        ]
    );
    assert_eq!(distinct(&table, 1).into_iter().collect::<Vec<_>>(), ["parameters"]);
    let expected = ["LWR", "law alone", "nearest neighbour", "scale law"];
    assert_eq!(distinct(&table, 2).into_iter().collect::<Vec<_>>(), expected);
    assert!(distinct(&table, 3).is_superset(&["30", "100", "300"].into()));

    let median = |method: &str, rows: &str| -> f64 {
        let wanted = ["meinhardt-spots", "parameters", method, rows];
        let line = table.iter().find(|line| line[..4] == wanted && line[5] == "rate");
        line.unwrap()[8].parse().unwrap()
    };
    assert!(median("LWR", "300") < median("LWR", "30"));
    assert!(median("LWR", "300") < 0.5 * median("nearest neighbour", "300"));
    assert!(median("LWR", "300") < median("scale law", "300"));
}

#[test]
fn new_growths_are_compared_with_the_bounds() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = ["--targets", "1", "--system", "turing-spots", "--seed", "3", "-o", "table.csv"];
    let output = learn(&arguments, folder.path());
    assert!(output.status.success() && output.stderr.is_empty(), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    assert!(
        printed.contains("random targets that were grown") && printed.contains("allowed 1.5 / 5 %"),
        "{printed}"
    );
    let table = table(&folder.path().join("table.csv"));
    let grown: Vec<&Vec<String>> = table.iter().filter(|line| line[1] == "grown").collect();
    let methods: BTreeSet<&str> = grown.iter().map(|line| line[2].as_str()).collect();
    assert_eq!(methods, ["LWR", "LWR + refinement", "scale law"].into());
    let refined = |quantity: &str| {
        grown.iter().find(|line| line[2] == "LWR + refinement" && line[4] == "true" && line[5] == quantity)
    };
    // The level corrects the area to a tenth of a per cent.
    let area = refined("area").unwrap();
    assert!(area[8].parse::<f64>().unwrap() < 0.2 && area[12] == "ok", "{area:?}");
    assert_eq!(refined("failed").unwrap()[7..], ["0", "", "", "", "", "ok"]);
}

#[test]
fn the_factors_on_the_laws_of_pairs_are_learnt() {
    let folder = tempfile::tempdir().unwrap();
    let output = learn(&["--no-simulation", "-o", "table.csv"], folder.path());
    assert!(output.status.success(), "{}", text(&output.stderr));
    let table = table(&folder.path().join("table.csv"));
    for system in ["weave", "maze", "pair-stripes", "stucco", "cells"] {
        let median = |method: &str| -> f64 {
            let line = table.iter().find(|line| line[0] == system && line[2] == method && line[5] == "size");
            line.unwrap()[8].parse().unwrap()
        };
        assert!(
            median("LWR") < 0.5 * median("law alone"),
            "{system}: {} {}",
            median("LWR"),
            median("law alone")
        );
        assert!(median("LWR") <= 1.02 * median("nearest neighbour"), "{system}");
    }
}

#[test]
fn targets_of_pairs_are_grown_by_the_law_and_with_the_learnt_factors() {
    let folder = tempfile::tempdir().unwrap();
    let output = learn(&["--targets", "3", "--system", "stucco", "-o", "table.csv"], folder.path());
    assert!(output.status.success() && output.stderr.is_empty(), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("allowed 6 / 15 %"), "{}", text(&output.stdout));
    let table = table(&folder.path().join("table.csv"));
    let median = |method: &str| -> f64 {
        let line = table.iter().find(|line| line[1] == "grown" && line[2] == method && line[5] == "width");
        line.unwrap()[8].parse().unwrap()
    };
    assert!(median("LWR") < median("law alone") && median("LWR + refinement") < 1.0);
}

#[test]
fn json_has_the_numbers_of_the_table() {
    let folder = tempfile::tempdir().unwrap();
    let output = learn(
        &["--no-simulation", "--targets", "20", "--system", "meinhardt-stripes", "--json", "-o", "table.csv"],
        folder.path(),
    );
    assert!(output.status.success() && output.stderr.is_empty(), "{}", text(&output.stderr));
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let printed = json["outcomes"].as_array().unwrap().iter().flat_map(|outcome| {
        let quantities = outcome["quantities"].as_object().unwrap().iter();
        quantities.map(move |(quantity, errors)| {
            let word = |key: &str| outcome[key].as_str().unwrap().to_owned();
            let number = |key: &str| format!("{:.5}", errors[key].as_f64().unwrap());
            let rows = outcome["rows"].to_string();
            let names = [word("system"), word("errors"), word("method"), rows, outcome["all"].to_string()];
            let numbers = [errors["count"].to_string(), number("median"), number("p95")];
            let unit = errors["unit"].as_str().unwrap().to_owned();
            [&names[..], &[quantity.clone(), unit], &numbers[..]].concat()
        })
    });
    let table: Vec<Vec<String>> =
        table(&folder.path().join("table.csv"))[1..].iter().map(|line| line[..10].to_vec()).collect();
    assert_eq!(printed.collect::<Vec<_>>(), table);
    assert!(table.len() > 12);
}

#[test]
fn a_folder_without_sets_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let output = learn(&["--no-simulation", "--training", "."], folder.path());
    assert_eq!(output.status.code(), Some(1));
    assert!(text(&output.stderr).contains("turing-spots"), "{}", text(&output.stderr));
    assert_eq!(learn(&["--targets", "0"], folder.path()).status.code(), Some(2));
}
