//! Checks that one document and seed always give the same bytes, and that another seed gives other bytes.

use crate::grow::folder::{ASPECT, Folder, hexagon, spots, stripes};
use serde_json::{Value, json};
use std::path::Path;

/// Two regions, so that parameters differ from cell to cell.
fn graded() -> Value {
    let mut strokes = hexagon([60.0, 60.0], 30.0);
    for degrees in [70.0, 80.0] {
        let center = [150.0, 40.0 + degrees / 2.0];
        strokes.push(json!({"kind": "ellipse", "center": center, "radii": [8.0, 5.0], "angle": degrees}));
    }
    let mut document = spots();
    document["size"] = json!([200, 128]);
    document["regions"] = json!([2, 1]);
    document["layers"][0]["strokes"] = json!(strokes);
    document
}

fn without_seconds(mut report: Value) -> Value {
    assert!(report.as_object_mut().unwrap().remove("seconds").is_some());
    report
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let turing = {
        let mut document = spots();
        document["edges"] = json!("wrap");
        document["layers"][0]["system"] = json!("turing-spots");
        document
    };
    for document in [graded(), stripes(), turing] {
        let folder = Folder::with(&document);
        for threads in [1, 4] {
            folder.grow(&format!(
                "--threads {threads} --pattern p{threads}.png --labels l{threads}.png --report {threads}.json"
            ));
            std::fs::rename(folder.path("a.png"), folder.path(&format!("a{threads}.png"))).unwrap();
        }
        for name in ["a", "p", "l"] {
            let [one, four] = [1, 4].map(|threads| folder.bytes(&format!("{name}{threads}.png")));
            assert!(one == four, "{name} of {document}");
        }
        let [one, four] = ["1.json", "4.json"].map(|name| without_seconds(folder.json(name)));
        assert_eq!(one, four);
    }
}

#[test]
fn a_seed_changes_the_texture_and_defaults_to_that_of_the_document() {
    for mut document in [spots(), stripes()] {
        let folder = Folder::with(&document);
        let grown = |more: &str| {
            folder.grow(&format!("{more} --report r.json"));
            (folder.bytes("a.png"), folder.json("r.json")["seed"].as_u64().unwrap())
        };
        let (one, seed) = grown("");
        assert_eq!(seed, 1);
        let (two, seed) = grown("--seed 2");
        assert_eq!(seed, 2);
        assert!(one != two);
        assert!(grown("--seed 1").0 == one);
        document["seed"] = json!(2);
        folder.write("a.dapple", &document.to_string());
        assert!(grown("").0 == two);
    }
}

/// Copies the training sets of the repository into the folder `training`.
fn copy_training(folder: &Folder) {
    std::fs::create_dir(folder.path("training")).unwrap();
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("training");
    for entry in std::fs::read_dir(from).unwrap() {
        let path = entry.unwrap().path();
        std::fs::copy(&path, folder.path("training").join(path.file_name().unwrap())).unwrap();
    }
}

#[test]
fn training_sets_in_a_folder_are_those_built_in() {
    for document in [graded(), stripes()] {
        let folder = Folder::with(&document);
        copy_training(&folder);
        folder.grow("--report built_in.json");
        let built_in = folder.bytes("a.png");
        folder.grow("--report read.json --training training");
        assert!(folder.bytes("a.png") == built_in);
        let [built_in, read] = ["built_in.json", "read.json"].map(|name| without_seconds(folder.json(name)));
        assert_eq!(built_in, read);
    }
}

#[test]
fn a_folder_of_training_sets_replaces_the_built_in_ones() {
    let mut document = spots();
    document["layers"][0]["system"] = json!("meinhardt-spots");
    let folder = Folder::with(&document);
    // Only the runs of long spots, under another name.
    std::fs::create_dir(folder.path("my-sets")).unwrap();
    let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("training/meinhardt-spots-orientation.csv");
    let table = std::fs::read_to_string(from).unwrap();
    let (header, rows) = table.split_once('\n').unwrap();
    let column = header.split(',').position(|name| name == "aspect").unwrap();
    let long = |row: &&str| row.split(',').nth(column).unwrap().parse::<f64>().unwrap() < 0.45;
    let rows: Vec<&str> = rows.lines().filter(long).collect();
    folder.write("my-sets/meinhardt-spots-long.csv", &format!("{header}\n{}\n", rows.join("\n")));
    folder.write("my-sets/meinhardt-spots-long.rejected.csv", "not read\n");
    let predicted = |name: &str, more: &str| {
        folder.grow(&format!("--no-refine --report {name} {more}"));
        folder.json(name)["layers"][0]["regions"][0]["predicted"]["aspect"].as_f64().unwrap()
    };
    assert!((predicted("built_in.json", "") - ASPECT).abs() < 0.02);
    assert!(predicted("own.json", "--training my-sets") < 0.46);
    // Missing sets are not replaced by the built-in ones.
    folder.refuses(
        "lookup --system turing-spots --area 60 --aspect 0.6 --angle 0 --training my-sets",
        1,
        &["my-sets"],
    );
}

#[test]
fn a_damaged_training_set_is_reported_with_file_line_and_column() {
    let folder = Folder::with(&spots());
    copy_training(&folder);
    let name = "training/meinhardt-spots-size.csv";
    let whole = String::from_utf8(folder.bytes(name)).unwrap();
    let column = whole.lines().next().unwrap().split(',').position(|name| name == "aspect").unwrap();
    let mut lines: Vec<String> = whole.lines().map(str::to_owned).collect();
    let mut values: Vec<&str> = lines[6].split(',').collect();
    values[column] = "1.5";
    lines[6] = values.join(",");
    folder.write(name, &lines.join("\n"));
    let grow = "grow a.dapple -o a.png --training training";
    folder.refuses(grow, 1, &["meinhardt-spots-size.csv", "line 7", "column aspect", "'1.5'", "0.01 to 1"]);
    for set in ["narrow", "orientation", "size"] {
        std::fs::remove_file(folder.path(&format!("training/meinhardt-spots-{set}.csv"))).unwrap();
    }
    folder.refuses(grow, 1, &["training", "neither meinhardt-spots.csv nor meinhardt-spots-*.csv"]);
    folder.refuses("grow a.dapple -o a.png --training elsewhere", 1, &["elsewhere"]);
}
