//! Sweeps from a plan to files, with tiny patches.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tempfile::TempDir;

use crate::journal::{Journal, Part};
use crate::merge::merge;
use crate::plan::Plan;
use crate::shard::Shard;
use crate::sweep::{part, whole};

/// Patches of nine spots, some of which touch, and of six stripes: seven runs in all.
fn tiny() -> Value {
    let range =
        |range: [f64; 2], unit: &str| json!({"range": range, "unit": unit, "scale": "log", "why": "tiny"});
    let fixed =
        |value: f64, unit: &str| json!({"range": [value, value], "unit": unit, "scale": "linear", "why": ""});
    let any = json!({"range": [0, 180], "unit": "degrees", "scale": "linear", "why": ""});
    json!({"format": "dapple sweep plan", "version": 1, "sets": [
        {"name": "meinhardt-spots-mine", "system": "meinhardt-spots", "why": "", "runs": 5, "seed": 10,
         "patch": {"grown": 9, "least": 7, "unit": "spots", "why": ""},
         "sweep": {"area": range([14.0, 20.0], "cells"), "ratio": fixed(12.0, "Db/Da"),
                   "level": {"range": [0.02, 0.3], "unit": "of the peak", "scale": "linear", "why": ""},
                   "stretch": range([0.5, 1.0], "minor/major"), "direction": any}},
        {"name": "meinhardt-stripes", "system": "meinhardt-stripes", "why": "", "runs": 2, "seed": 20,
         "patch": {"grown": 6, "least": 4, "unit": "wavelengths", "why": ""},
         "sweep": {"width": range([3.0, 4.0], "cells"), "stretch": fixed(0.5, "minor/major"), "direction": any}},
    ]})
}

fn plan() -> Plan {
    Plan::from_json(&tiny()).unwrap()
}

fn folder() -> TempDir {
    tempfile::tempdir().unwrap()
}

/// The names and contents of all files in a folder.
fn files(folder: &Path) -> BTreeMap<String, String> {
    let read = |entry: std::io::Result<std::fs::DirEntry>| {
        let path = entry.unwrap().path();
        (path.file_name().unwrap().to_str().unwrap().to_owned(), std::fs::read_to_string(&path).unwrap())
    };
    std::fs::read_dir(folder).unwrap().map(read).collect()
}

/// What a plain sweep of [`tiny`] writes.
fn plain() -> BTreeMap<String, String> {
    let folder = folder();
    assert_eq!(whole(&plan(), folder.path()).unwrap(), 7);
    files(folder.path())
}

#[test]
fn a_sweep_writes_rows_rejected_runs_and_a_manifest_of_each_set_and_no_journal() {
    let files = plain();
    let names: Vec<&str> = files.keys().map(String::as_str).collect();
    let expected = ["mine.csv", "mine.json", "mine.rejected.csv"].map(|end| format!("meinhardt-spots-{end}"));
    let stripes = ["csv", "json", "rejected.csv"].map(|end| format!("meinhardt-stripes.{end}"));
    assert_eq!(names, [expected, stripes].concat());

    let rejected: Vec<&str> = files["meinhardt-spots-mine.rejected.csv"].lines().collect();
    assert_eq!(rejected[0], "seed,rate,ratio,stretch,direction,level,reason,detail");
    let accepted = files["meinhardt-spots-mine.csv"].lines().count() - 1;
    assert_eq!(accepted + rejected.len() - 1, 5);
    assert!((1..5).contains(&accepted), "some of each: {accepted}");
    assert!(rejected[1..].iter().all(|line| line.contains(",touching,\"merged: ")), "{rejected:?}");
    assert_eq!(files["meinhardt-stripes.rejected.csv"], "seed,rate,stretch,direction,reason,detail\n");
    let seeds: Vec<&str> =
        files["meinhardt-stripes.csv"].lines().map(|line| line.split(',').next().unwrap()).collect();
    assert_eq!(seeds, ["seed", "20", "21"]);
}

#[test]
fn a_manifest_lists_columns_units_ranges_plan_counts_and_the_command() {
    let files = plain();
    let manifest: Value = serde_json::from_str(&files["meinhardt-spots-mine.json"]).unwrap();
    assert_eq!(manifest["set"], "meinhardt-spots-mine");
    assert_eq!(manifest["system"], "meinhardt-spots");
    assert_eq!(manifest["dapple"], env!("CARGO_PKG_VERSION"));
    assert_eq!(manifest["seeds"], json!({"first": 10, "last": 14}));
    let counts = &manifest["counts"];
    let touching = counts["rejected"]["touching"].as_u64().unwrap();
    assert_eq!(counts["runs"], 5);
    assert_eq!(counts["accepted"].as_u64().unwrap() + touching, 5);
    assert_eq!(counts["rejected"].as_object().unwrap().len(), 7);

    let table: Vec<Vec<&str>> =
        files["meinhardt-spots-mine.csv"].lines().map(|line| line.split(',').collect()).collect();
    let columns = manifest["columns"].as_array().unwrap();
    let names: Vec<&str> = columns.iter().map(|column| column["name"].as_str().unwrap()).collect();
    assert_eq!(names, table[0]);
    let area = names.iter().position(|name| *name == "area").unwrap();
    assert_eq!(columns[area]["unit"], "cells");
    let mut areas: Vec<f64> = table[1..].iter().map(|row| row[area].parse().unwrap()).collect();
    areas.sort_by(f64::total_cmp);
    assert_eq!(columns[area]["range"], json!([areas[0], areas[areas.len() - 1]]));

    // The plan in the manifest makes the same files.
    assert!(manifest["command"].as_str().unwrap().contains("--plan PLAN.json"));
    let again = folder();
    whole(&Plan::from_json(&manifest["plan"]).unwrap(), again.path()).unwrap();
    let expected = files.iter().filter(|(name, _)| name.starts_with("meinhardt-spots-mine"));
    assert!(self::files(again.path()).iter().eq(expected));
}

#[test]
fn the_manifest_of_a_built_in_set_names_the_command_that_makes_it() {
    let plan = Plan::built_in().unwrap();
    let command = |plan: &Plan| {
        let manifest = crate::manifest::manifest(plan, &plan.sets[0], &[]).unwrap();
        manifest["command"].as_str().unwrap().to_owned()
    };
    let sweep = "cargo run --release -p data-gen -- sweep --set turing-spots-orientation";
    assert_eq!(command(&plan), sweep);
    assert_eq!(command(&plan.clone().chosen(&[], Some(30)).unwrap()), format!("{sweep} --runs 30"));
}

#[test]
fn an_interrupted_sweep_continues_and_repeats_no_run() {
    let whole_files = plain();
    let folder = folder();
    let journal = folder.path().join("sweep.journal");
    // The state that a killed sweep leaves: some lines, the last one incomplete.
    part(&plan(), folder.path(), Shard::WHOLE).unwrap();
    let full = std::fs::read_to_string(&journal).unwrap();
    let lines: Vec<&str> = full.lines().collect();
    assert_eq!(lines.len(), 8);
    for (whole_lines, torn, left) in [(8, "", 0), (8, "meinhardt-st", 0), (6, &lines[6][..9], 2), (1, "", 7)]
    {
        let text = lines[..whole_lines].join("\n") + "\n" + torn;
        std::fs::write(&journal, &text).unwrap();
        assert_eq!(part(&plan(), folder.path(), Shard::WHOLE).unwrap(), left, "{whole_lines} {torn}");
        let kept = std::fs::read_to_string(&journal).unwrap();
        assert!(kept.starts_with(&(lines[..whole_lines].join("\n") + "\n")));
        assert_eq!(kept.lines().count(), 8);
    }
    // Incomplete first line: nothing was run yet.
    std::fs::write(&journal, &lines[0][..20]).unwrap();
    assert_eq!(whole(&plan(), folder.path()).unwrap(), 7);
    assert_eq!(files(folder.path()), whole_files);
}

#[test]
fn the_files_are_the_same_for_any_number_of_threads_and_parts_in_any_order() {
    let expected = plain();
    for threads in [1, 3] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        let folder = folder();
        pool.install(|| whole(&plan(), folder.path())).unwrap();
        assert_eq!(files(folder.path()), expected, "{threads} threads");
    }
    let folders = [folder(), folder()];
    let ran: Vec<u64> = [3, 1, 2]
        .map(|number| {
            part(&plan(), folders[number % 2].path(), Shard { part: number as u64, of: 3 }).unwrap()
        })
        .into();
    assert_eq!(ran, [1, 3, 3]);
    let paths: Vec<PathBuf> = folders.iter().map(|folder| folder.path().to_owned()).collect();
    for order in [paths.clone(), paths.into_iter().rev().collect()] {
        let output = folder();
        let printed = merge(&order, output.path()).unwrap();
        assert!(printed[0].starts_with("meinhardt-spots-mine: 5 runs: "), "{printed:?}");
        assert_eq!(files(output.path()), expected);
    }
}

#[test]
fn missing_or_duplicate_parts_are_not_merged() {
    let [one, two, output] = [folder(), folder(), folder()];
    let path = |folder: &TempDir| folder.path().to_owned();
    let refused = |folders: &[PathBuf], words: &[&str]| {
        let error = merge(folders, output.path()).unwrap_err();
        assert!(words.iter().all(|word| error.contains(word)), "{error}");
        assert!(files(output.path()).is_empty());
    };
    refused(&[path(&one)], &["no journal"]);
    part(&plan(), one.path(), Shard { part: 1, of: 2 }).unwrap();
    refused(&[path(&one)], &["part 2/2 is missing", "--shard 2/2"]);
    refused(&[path(&one), path(&one)], &["both part 1/2"]);
    part(&plan(), two.path(), Shard { part: 2, of: 2 }).unwrap();
    let journal = two.path().join("sweep-2-of-2.journal");
    let full = std::fs::read_to_string(&journal).unwrap();
    // A run is missing, and half of its line is there.
    std::fs::write(&journal, &full[..full.len() - 5]).unwrap();
    refused(&[path(&one), path(&two)], &["sweep-2-of-2.journal", "2 of 3 runs", "start that part again"]);
    // A run is there twice.
    let last = full.lines().last().unwrap();
    std::fs::write(&journal, format!("{full}{last}\n")).unwrap();
    refused(&[path(&one), path(&two)], &["line 5", "twice"]);
    std::fs::write(&journal, full.replace(",accepted,", ",accepter,")).unwrap();
    refused(&[path(&one), path(&two)], &["line", "damaged"]);
    std::fs::write(&journal, &full).unwrap();
    merge(&[path(&one), path(&two)], output.path()).unwrap();
    // A part of another plan.
    let mut other = tiny();
    other["sets"][0]["seed"] = json!(40);
    std::fs::remove_file(&journal).unwrap();
    part(&Plan::from_json(&other).unwrap(), two.path(), Shard { part: 2, of: 2 }).unwrap();
    let error = merge(&[path(&one), path(&two)], output.path()).unwrap_err();
    assert!(error.contains("meinhardt-spots-mine.seed is 40 there, 10 here"), "{error}");
}

#[test]
fn a_journal_of_another_plan_is_refused_and_kept() {
    let folder = folder();
    let begun = plan().chosen(&["meinhardt-stripes".to_owned()], None).unwrap();
    part(&begun, folder.path(), Shard::WHOLE).unwrap();
    let before = files(folder.path());
    let refused = |plan: &Plan, words: &[&str]| {
        let error = whole(plan, folder.path()).unwrap_err();
        assert!(words.iter().all(|word| error.contains(word)), "{error}");
        assert!(error.contains("delete this file") && error.contains("-o"), "{error}");
        assert_eq!(files(folder.path()), before);
    };
    refused(&begun.clone().chosen(&[], Some(3)).unwrap(), &["meinhardt-stripes.runs is 2 there, 3 here"]);
    refused(&plan(), &["has meinhardt-stripes there, meinhardt-spots-mine, meinhardt-stripes here"]);
    std::fs::write(folder.path().join("sweep.journal"), "something else\n").unwrap();
    let error = whole(&begun, folder.path()).unwrap_err();
    assert!(error.contains("not the journal of a sweep"), "{error}");
}

#[test]
fn two_sweeps_do_not_write_one_journal() {
    let folder = folder();
    let (_journal, _) = Journal::open(folder.path(), Shard::WHOLE, &plan()).unwrap();
    let error = whole(&plan(), folder.path()).unwrap_err();
    assert!(error.contains("another sweep is writing it"), "{error}");
    assert!(Part::read(&folder.path().join("sweep.journal")).unwrap().records.is_empty());
}

/// Asserts that [`tiny`] with this change is refused with these words.
#[track_caller]
fn wrong(change: impl Fn(&mut Value), words: &[&str]) {
    let mut plan = tiny();
    change(&mut plan);
    let error = Plan::parse(&plan.to_string(), "my.json").unwrap_err();
    assert!(error.starts_with("my.json: ") && words.iter().all(|word| error.contains(word)), "{error}");
}

const FIRST: &str = "set 'meinhardt-spots-mine', ";

#[test]
fn an_invalid_range_is_reported_with_set_key_value_and_the_allowed_range() {
    let area = |key: &'static str, value: Value| {
        move |plan: &mut Value| plan["sets"][0]["sweep"]["area"][key] = value.clone()
    };
    wrong(area("range", json!([0.5, 20])), &[FIRST, "sweep.area.range: 0.5 is not from 1 to 2000"]);
    wrong(area("range", json!([20, 14])), &[FIRST, "sweep.area.range", "20 is more than 14"]);
    wrong(area("range", json!("large")), &[FIRST, "sweep.area.range", "large"]);
    wrong(area("range", json!([20])), &[FIRST, "sweep.area.range", "2"]);
    wrong(area("unit", json!("px")), &[FIRST, "sweep.area.unit: it is 'cells', not 'px'"]);
    wrong(area("scale", json!("cubic")), &[FIRST, "sweep.area.scale", "`cubic`", "`log`"]);
    wrong(area("share", json!(0.5)), &[FIRST, "sweep.area.share", "level"]);
    wrong(|plan| plan["sets"][0]["sweep"]["sise"] = json!({}), &[FIRST, "sweep", "`sise`", "`area`"]);
    wrong(
        |plan| plan["sets"][1]["sweep"]["area"] = plan["sets"][0]["sweep"]["area"].clone(),
        &["has no area"],
    );
    let without_level = |plan: &mut Value| {
        plan["sets"][0]["sweep"].as_object_mut().unwrap().remove("level");
    };
    wrong(without_level, &[FIRST, "sweep.level: it is missing"]);
    let both = |plan: &mut Value| plan["sets"][0]["sweep"]["ratio"]["range"] = json!([12, 20]);
    wrong(both, &[FIRST, "sweep.level.share: it is missing"]);
    let mut turing = Plan::built_in().unwrap();
    turing.sets[0].sweep.ratio.as_mut().unwrap().range = [3.8, 8.0];
    let error = Plan::from_json(&serde_json::to_value(&turing).unwrap()).unwrap_err();
    assert!(error.contains("sweep.ratio.range: 8 is not 3.8"), "{error}");
}

#[test]
fn an_invalid_set_is_reported_with_name_key_value_and_the_allowed_values() {
    let set = |key: &'static str, value: Value| move |plan: &mut Value| plan["sets"][0][key] = value.clone();
    wrong(set("runs", json!("many")), &[FIRST, "runs", "many"]);
    wrong(set("runs", json!(0)), &[FIRST, "runs: 0 is not from 1 to 1000000"]);
    wrong(set("system", json!("voronoi")), &[FIRST, "system", "voronoi", "turing-spots"]);
    wrong(set("system", json!("turing-spots")), &[FIRST, "name", "turing-spots-MORE"]);
    wrong(set("name", json!("meinhardt-spots-../x")), &["name", "small letters"]);
    wrong(set("seed", json!(17)), &["seeds", "'meinhardt-spots-mine'", "17 to 21"]);
    wrong(
        |plan| plan["sets"][0]["patch"]["least"] = json!(10),
        &[FIRST, "patch.least: 10 is not from 1 to 9"],
    );
    let large = |plan: &mut Value| {
        plan["sets"][0]["sweep"]["area"]["range"] = json!([14, 2_000]);
        plan["sets"][0]["patch"]["grown"] = json!(9_999);
    };
    wrong(large, &[FIRST, "cells along a side", "4096"]);
    wrong(|plan| plan["sets"] = json!([]), &["no sets"]);
    wrong(|plan| plan["version"] = json!(2), &["version 2 is newer than 1"]);
    wrong(|plan| plan["format"] = json!("dapple"), &["no plan of a sweep"]);
    let error = plan().chosen(&["meinhardt-spots".to_owned()], None).unwrap_err();
    assert!(
        error.contains("no set is called 'meinhardt-spots'; the plan has meinhardt-spots-mine"),
        "{error}"
    );
}

#[test]
fn a_set_can_be_made_longer_without_changing_its_first_runs() {
    let set = &Plan::built_in().unwrap().sets[3];
    let longer = &Plan::built_in().unwrap().chosen(&[], Some(9_000)).unwrap().sets[3];
    for index in [0, 1, 17, 3_999] {
        assert_eq!(set.parameters_of(index), longer.parameters_of(index));
        assert_eq!(set.seed_of(index), longer.seed_of(index));
    }
}

#[test]
fn the_built_in_plan_has_the_fourteen_sets_and_as_many_runs_as_the_paper() {
    let plan = Plan::built_in().unwrap();
    let names: Vec<&str> = plan.sets.iter().map(|set| set.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "turing-spots-orientation",
            "turing-spots-size",
            "turing-spots-narrow",
            "meinhardt-spots-orientation",
            "meinhardt-spots-size",
            "meinhardt-spots-narrow",
            "meinhardt-stripes-width",
            "meinhardt-stripes-orientation",
            "meinhardt-lines",
            "weave",
            "maze",
            "pair-stripes",
            "stucco",
            "cells"
        ]
    );
    // Phan & Grimm (2006) ran 15,600.
    assert!(plan.sets[..9].iter().map(|set| set.runs).sum::<u64>() >= 15_600);
    let least = |system: &str| match system {
        "weave" => 8.0,
        "maze" => 16.0,
        "pair-stripes" => 20.0,
        "stucco" => 12.0,
        "meinhardt-stripes" => 20.0,
        "meinhardt-lines" => 18.0,
        _ => 60.0,
    };
    assert!(plan.sets.iter().all(|set| set.patch.least >= least(set.system.name())));
}

#[test]
fn the_readme_beside_the_files_lists_sets_columns_and_reasons() {
    let readme = include_str!("../../training/README.md");
    let plan = Plan::built_in().unwrap();
    let columns = plan.sets.iter().flat_map(|set| set.system.description().all_columns());
    let names = plan.sets.iter().map(|set| set.name.as_str()).chain(columns.map(|column| column.name));
    let reasons: Vec<&str> = crate::verdicts::reasons().collect();
    for name in names.chain(reasons) {
        assert!(readme.contains(&format!("| `{name}` |")), "{name}");
    }
}

/// Found by fuzzing: text from a plan or a journal was quoted without escaping.
#[test]
fn quoted_text_of_a_plan_is_escaped_and_shortened() {
    let long = "x".repeat(100_000);
    let escaped = "\u{7f}".repeat(100_000);
    for name in ["\u{1b}[2J", "turing-spots-\u{7f}", long.as_str(), escaped.as_str()] {
        let mut plan = tiny();
        plan["sets"][0]["name"] = json!(name);
        let error = Plan::parse(&plan.to_string(), "my.json").unwrap_err();
        assert!(error.starts_with("my.json: ") && error.len() < 1_000, "{error}");
        assert!(!error.contains(char::is_control), "{error:?}");
    }
}

#[test]
fn the_commands_are_well_formed() {
    <crate::Command as clap::CommandFactory>::command().debug_assert();
}
