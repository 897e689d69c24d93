//! Training folders that are damaged, from another version, or incomplete.

use std::fs;
use std::path::Path;

use crate::bench::Bench;

const LOOKUP: &str = "lookup --system meinhardt-stripes --width 9 --angle 5 --training sets";
const SET: &str = "sets/meinhardt-stripes-width";

/// A test folder with the sets of Meinhardt's stripes as data-gen wrote them.
fn bench() -> Bench {
    let bench = Bench::new();
    fs::create_dir(bench.path("sets")).unwrap();
    for ending in ["csv", "rejected.csv", "json"] {
        let name = format!("meinhardt-stripes-width.{ending}");
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join("training").join(&name);
        fs::copy(from, bench.path("sets").join(&name)).unwrap();
    }
    bench
}

fn text(bench: &Bench, ending: &str) -> String {
    String::from_utf8(bench.bytes(&format!("{SET}.{ending}"))).unwrap()
}

#[test]
fn a_damaged_table_is_reported_with_the_place_of_the_damage() {
    let bench = bench();
    bench.does(LOOKUP);
    let whole = text(&bench, "csv");
    let says = |table: &str, words: &[&str]| {
        bench.write(&format!("{SET}.csv"), table);
        bench.refuses(LOOKUP, 1, &[&["meinhardt-stripes-width"], words].concat());
    };
    let line = |number: usize| whole.lines().take(number).map(str::len).sum::<usize>() + number;
    says("", &["line 1", "the column 'seed' is missing", "the columns are"]);
    says(&whole[..line(50) + 20], &["line 51"]);
    says(&whole[..line(1)], &["0 rows", "1500"]);
    // Cut between two lines, or within the last number: only the manifest shows that something is missing.
    says(&whole[..line(50)], &["holds 49 rows, and 1500 were written", "sweep again"]);
    says(&whole.replace("stretch", "strecth"), &["line 1", "'strecth' is unknown"]);
    let first = whole.lines().nth(1).unwrap();
    let (before, last) = first.rsplit_once(',').unwrap();
    says(&whole.replace(first, &format!("{before},NaN")), &["line 2", "column direction: 'NaN'"]);
    says(&whole.replace(first, &format!("{before},{last},1")), &["line 2"]);
    says("\0\u{1}\u{2}", &["line 1"]);
    fs::write(bench.path(&format!("{SET}.csv")), [0xff, 0xfe, 0, 1]).unwrap();
    bench.refuses(LOOKUP, 1, &["meinhardt-stripes-width.csv", "line 1"]);
}

#[test]
fn a_damaged_manifest_or_one_of_another_version_is_reported() {
    let bench = bench();
    let whole = text(&bench, "json");
    let says = |manifest: &str, words: &[&str]| {
        bench.write(&format!("{SET}.json"), manifest);
        bench.refuses(LOOKUP, 1, &[&["meinhardt-stripes-width.json", "sweep again"], words].concat());
    };
    says("", &["damaged", "line 1"]);
    says(&whole[..whole.len() / 2], &["damaged", "line"]);
    says("{}", &["format", "dapple training set"]);
    says(&whole.replace("dapple training set", "dapple"), &["format: found \"dapple\""]);
    says(&whole.replacen("\"version\": 1", "\"version\": 2", 1), &["version: found 2", "newer", "up to 1"]);
    says(
        &whole.replacen("\"version\": 1", "\"version\": \"one\"", 1),
        &["version: found \"one\"", "allowed"],
    );
    says(&whole.replacen("\"accepted\"", "\"taken\"", 1), &["counts.accepted"]);
    // Rows without a manifest are used.
    fs::remove_file(bench.path(&format!("{SET}.json"))).unwrap();
    bench.does(LOOKUP);
}

#[test]
fn a_folder_with_only_the_needed_sets_is_enough_and_a_missing_set_is_named() {
    let bench = bench();
    let grow = "grow a.dapple -o a.png --training sets";
    bench.refuses(
        grow,
        1,
        &["sets: holds no rows of meinhardt-spots", "it has rows of meinhardt-stripes", "add the missing"],
    );
    bench.write("a.dapple", &stripes());
    bench.does(grow);
    bench.refuses(
        &grow.replace("sets", "no-sets"),
        1,
        &["no-sets", "cannot be read", "as data-gen writes them"],
    );
    bench.refuses(&grow.replace("sets", "in.csv"), 1, &["in.csv", "cannot be read"]);
    fs::create_dir(bench.path("empty")).unwrap();
    bench.refuses(&grow.replace("sets", "empty"), 1, &["empty", "it has rows of no system"]);
}

/// A document of stripes that names its system.
fn stripes() -> String {
    r#"{"format": "dapple", "version": 1, "size": [96, 96], "layers": [{"system": "meinhardt-stripes",
        "strokes": [{"kind": "line", "from": [10, 10], "to": [80, 60], "width": 8}]}]}"#
        .to_owned()
}
