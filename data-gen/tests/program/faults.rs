//! Sweeps that are killed, on full disks, with their output closed.
//!
//! `DAPPLE_KILLS` says how many kills (4), `DAPPLE_SEED` which (1).
#![cfg(unix)]

#[path = "../../../tests/faults/running.rs"]
mod running;

use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use serde_json::{Value, json};
use tempfile::TempDir;

use running::Running;

const RUNS: u64 = 24;

/// Time between two looks at what is being written.
const BETWEEN: Duration = Duration::from_micros(50);

fn data_gen(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("data-gen"));
    command.current_dir(folder).args(arguments.split_whitespace());
    command
}

/// A folder with a plan of small patches, `my.json`.
fn bench() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let printed = data_gen(folder.path(), "plan").output().unwrap();
    let mut plan: Value = serde_json::from_slice(&printed.stdout).unwrap();
    let mut set = plan["sets"][3].clone();
    set["name"] = json!("meinhardt-spots-dense");
    set["runs"] = json!(RUNS);
    set["patch"]["grown"] = json!(12);
    set["patch"]["least"] = json!(9);
    set["sweep"]["area"]["range"] = json!([14, 30]);
    set["sweep"]["ratio"]["range"] = json!([12, 14]);
    plan["sets"] = json!([set]);
    fs::write(folder.path().join("my.json"), plan.to_string()).unwrap();
    folder
}

fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let read =
        |entry: fs::DirEntry| Some((entry.file_name().into_string().ok()?, fs::read(entry.path()).ok()?));
    entries.filter_map(read).collect()
}

fn number(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// The exit code and the text on stderr.
fn message(command: &mut Command) -> (Option<i32>, String) {
    let output = command.output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[test]
fn a_sweep_that_is_killed_repeatedly_gives_the_same_bytes() {
    let (kills, seed) = (number("DAPPLE_KILLS", 4), number("DAPPLE_SEED", 1));
    let bench = bench();
    let began = Instant::now();
    assert_eq!(message(&mut data_gen(bench.path(), "sweep --plan my.json -o whole --threads 2")).0, Some(0));
    let whole_time = began.elapsed();
    let whole = files(&bench.path().join("whole"));
    let killed = bench.path().join("killed");
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let (mut done, mut sweeps, mut writing) = (0, 0, 0);
    while done < kills {
        let mut sweep = data_gen(bench.path(), "sweep --plan my.json -o killed --threads 2");
        let mut sweep = Running::start(sweep.stderr(Stdio::null()));
        let is_part = |name: &String| name.ends_with(".part");
        let ending = done % 3 == 2;
        // Every third kill comes while the sweep writes its files.
        while ending && !files(&killed).keys().any(is_part) && !sweep.ends_within(BETWEEN) {}
        let most = if ending { Duration::from_millis(8) } else { whole_time.mul_f64(0.7) };
        sweep.ends_within(most.mul_f64(random.random_range(0.0..1.0)));
        sweep.child.kill().unwrap();
        let status = sweep.child.wait().unwrap();
        let there = files(&killed);
        for (name, bytes) in &whole {
            assert!(there.get(name).is_none_or(|found| found == bytes), "{name} is damaged");
        }
        if status.signal() == Some(9) {
            done += 1;
            writing += u64::from(there.keys().any(is_part));
        } else {
            assert!(status.success());
            assert!(there == whole, "after {done} kills: {:?}", there.keys());
            sweeps += 1;
            fs::remove_dir_all(&killed).unwrap();
        }
    }
    let (code, said) = message(&mut data_gen(bench.path(), "sweep --plan my.json -o killed"));
    assert_eq!(code, Some(0), "{said}");
    assert!(files(&killed) == whole);
    // Written past the test harness, because it is the reported result.
    say(&format!(
        "sweep: {done} kills, {writing} while writing the files; {} sweeps came to the same bytes",
        sweeps + 1
    ));
}

#[test]
fn a_closed_or_full_output_does_not_panic() {
    let bench = bench();
    for arguments in ["plan", "sweep --plan my.json -o a", "merge a -o b"] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        if arguments.starts_with("merge") {
            let part = "sweep --plan my.json -o a --shard 1/1";
            assert_eq!(message(data_gen(bench.path(), part).stdout(Stdio::null())).0, Some(0));
        }
        let mut piped = data_gen(bench.path(), arguments);
        let ran = piped.stdout(writer).stderr(Stdio::piped()).spawn().unwrap().wait_with_output().unwrap();
        let said = String::from_utf8(ran.stderr).unwrap();
        assert!(ran.status.success() && said.is_empty(), "{arguments}: {said}");
        let Ok(full) = fs::File::options().write(true).open("/dev/full") else { return };
        let ran = data_gen(bench.path(), arguments).stdout(full).output().unwrap();
        let said = String::from_utf8(ran.stderr).unwrap();
        assert_eq!(ran.status.code(), Some(1), "{arguments}: {said}");
        assert!(said.starts_with("error: standard output: cannot be written"), "{arguments}: {said}");
    }
}

/// Mounts a file system of 1 MB in memory, or reports past the test harness that this is not permitted.
fn mounted(folder: &Path) -> bool {
    fs::create_dir(folder).unwrap();
    let mut mount = Command::new("mount");
    let output = mount.args(["-t", "tmpfs", "-o", "size=1m", "tmpfs"]).arg(folder).output();
    let mounted = output.is_ok_and(|output| output.status.success());
    assert!(mounted || std::env::var_os("DAPPLE_MUST_MOUNT").is_none(), "mount is not permitted");
    if !mounted {
        say("SKIPPED: mount is not permitted; run it as root");
    }
    mounted
}

#[test]
fn a_sweep_on_a_full_disk_is_reported_and_continues_once_there_is_room() {
    let bench = bench();
    let out = bench.path().join("out");
    if !mounted(&out) {
        return;
    }
    let mut filler = fs::File::create(out.join("filler")).unwrap();
    while filler.write_all(&[7; 4096]).is_ok() {}
    let sweep = "sweep --plan my.json -o out --threads 2";
    let mut outcomes = Vec::new();
    // There is no room at all; room for the journal's first lines; room for the journal, but not for the files.
    for blocks in [0, 1, 2, 3] {
        let length = filler.metadata().unwrap().len();
        filler.set_len(length - 4096 * blocks.min(1)).unwrap();
        let (code, said) = message(&mut data_gen(bench.path(), sweep));
        outcomes.push((code, said));
    }
    drop(filler);
    fs::remove_file(out.join("filler")).unwrap();
    let (code, said) = message(&mut data_gen(bench.path(), sweep));
    let found = files(&out);
    let _ = Command::new("umount").arg("-l").arg(&out).status();
    for (code, said) in &outcomes {
        assert!(
            *code == Some(0) || *code == Some(1) && said.contains("out") && said.lines().count() == 1,
            "{outcomes:?}"
        );
    }
    assert_eq!(outcomes[0].0, Some(1), "{outcomes:?}");
    assert_eq!(code, Some(0), "{said}");
    assert_eq!(message(&mut data_gen(bench.path(), "sweep --plan my.json -o whole")).0, Some(0));
    assert!(found == files(&bench.path().join("whole")), "{:?}", found.keys());
}

/// Writes a line to stderr directly: the test harness would hide it.
fn say(line: &str) {
    let _ = std::io::stderr().write_all(format!("{line}\n").as_bytes());
}
