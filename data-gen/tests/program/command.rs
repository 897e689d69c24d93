//! `data-gen` as users run it.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use assert_cmd::assert::OutputAssertExt;
use assert_cmd::cargo::cargo_bin;
use dapple::files::TrainingFolder;
use dapple_engine::learn::TrainingSet;
use dapple_engine::rd::System;
use serde_json::{Value, json};

fn data_gen(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(cargo_bin!("data-gen"));
    command.current_dir(folder).args(arguments.split_whitespace());
    command
}

fn text(bytes: Vec<u8>) -> String {
    String::from_utf8(bytes).unwrap()
}

/// The printed plan, with small patches of dense Meinhardt spots, `runs` in all, written as `my.json`.
fn edit_plan(folder: &Path, runs: u64) {
    let printed = data_gen(folder, "plan").assert().success().get_output().stdout.clone();
    let mut plan: Value = serde_json::from_slice(&printed).unwrap();
    let mut set = plan["sets"][3].clone();
    set["name"] = json!("meinhardt-spots-dense");
    set["runs"] = json!(runs);
    set["patch"]["grown"] = json!(12);
    set["patch"]["least"] = json!(9);
    set["sweep"]["area"]["range"] = json!([14, 30]);
    set["sweep"]["ratio"]["range"] = json!([12, 14]);
    plan["sets"] = json!([set]);
    std::fs::write(folder.join("my.json"), plan.to_string()).unwrap();
}

#[test]
fn a_changed_plan_is_swept_and_learnt_from() {
    let folder = tempfile::tempdir().unwrap();
    edit_plan(folder.path(), 40);
    let message =
        data_gen(folder.path(), "sweep --plan my.json -o my-sets").assert().success().get_output().clone();
    assert!(text(message.stdout).starts_with("meinhardt-spots-dense: 40 runs in "), "a summary");
    let set = TrainingSet::load(
        &TrainingFolder::new(folder.path().join("my-sets")),
        System::MEINHARDT_SPOTS.description(),
        &[],
    )
    .unwrap();
    assert!((30..=40).contains(&set.rows().len()));
    let (_, [low, high]) = set.reach().0[0];
    assert!(12.0 < low && low < 16.0 && 26.0 < high && high < 33.0, "areas {low} to {high}");
}

#[test]
fn a_killed_sweep_continues_to_the_same_bytes() {
    let folder = tempfile::tempdir().unwrap();
    edit_plan(folder.path(), 60);
    data_gen(folder.path(), "sweep --plan my.json -o whole").assert().success();
    let mut sweep = data_gen(folder.path(), "sweep --plan my.json -o killed --threads 2")
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let journal = folder.path().join("killed/sweep.journal");
    let lines = || std::fs::read_to_string(&journal).map_or(0, |text| text.lines().count());
    while lines() < 10 && sweep.try_wait().unwrap().is_none() {
        std::thread::yield_now();
    }
    sweep.kill().unwrap();
    sweep.wait().unwrap();
    let before = lines().saturating_sub(1);
    let message =
        data_gen(folder.path(), "sweep --plan my.json -o killed").assert().success().get_output().clone();
    let message = text(message.stdout);
    // (it may have ended before it could be killed, and the journal with it)
    assert!(
        before == 0 || message.contains(&format!("60 runs ({before} of them earlier)")),
        "{before}: {message}"
    );
    assert!(!journal.exists());
    for name in ["csv", "rejected.csv", "json"].map(|ending| format!("meinhardt-spots-dense.{ending}")) {
        let [whole, killed] =
            ["whole", "killed"].map(|part| std::fs::read(folder.path().join(part).join(&name)).unwrap());
        assert!(whole == killed, "{name}");
    }
}

#[test]
fn parts_are_merged_to_the_bytes_of_the_whole() {
    let folder = tempfile::tempdir().unwrap();
    edit_plan(folder.path(), 20);
    data_gen(folder.path(), "sweep --plan my.json -o whole").assert().success();
    for part in [2, 1] {
        let message = data_gen(folder.path(), &format!("sweep --plan my.json -o parts --shard {part}/2"))
            .assert()
            .success()
            .get_output()
            .clone();
        assert!(text(message.stdout).contains(&format!("sweep-{part}-of-2.journal")));
    }
    data_gen(folder.path(), "merge parts -o merged").assert().success();
    for name in ["csv", "rejected.csv", "json"].map(|ending| format!("meinhardt-spots-dense.{ending}")) {
        let [whole, merged] =
            ["whole", "merged"].map(|part| std::fs::read(folder.path().join(part).join(&name)).unwrap());
        assert!(whole == merged, "{name}");
    }
}

#[test]
fn errors_are_one_line_with_a_remedy() {
    let folder = tempfile::tempdir().unwrap();
    edit_plan(folder.path(), 5);
    let refuses = |arguments: &str, code: i32, words: &[&str]| {
        let output = data_gen(folder.path(), arguments).assert().code(code).get_output().clone();
        let said = text(output.stderr);
        assert!(words.iter().all(|word| said.contains(word)), "{said}");
        assert!(code == 2 || BufReader::new(said.as_bytes()).lines().count() == 1, "{said}");
    };
    refuses("sweep --plan my.json", 2, &["--output"]);
    refuses("sweep --shard 5/4", 2, &["5/4", "such as 3/16"]);
    refuses("sweep --runs 0", 2, &["0", "1..=1000000"]);
    refuses("sweep --plan no.json -o out", 1, &["no.json", "data-gen plan"]);
    refuses("sweep --plan my.json --set other -o out", 1, &["'other'", "meinhardt-spots-dense"]);
    refuses("merge . -o out", 1, &["no journal"]);
    let plan = std::fs::read_to_string(folder.path().join("my.json")).unwrap();
    std::fs::write(folder.path().join("torn.json"), &plan[..40]).unwrap();
    refuses("sweep --plan torn.json -o out", 1, &["torn.json", "line 1"]);
}
