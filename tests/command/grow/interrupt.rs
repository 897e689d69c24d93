//! Ctrl-C: the program stops soon and leaves nothing behind.

use crate::grow::folder::{Folder, spots};
use crate::grow::running::Running;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Time limit: a program that does not end fails the test.
const DEADLINE: Duration = Duration::from_secs(60);

/// Time between two checks of the progress.
const BETWEEN: Duration = Duration::from_millis(2);

fn start(folder: &Folder, arguments: &str) -> Running {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("dapple"));
    command.current_dir(folder.path("")).args(arguments.split_whitespace());
    Running::start(command.stderr(Stdio::piped()))
}

/// Waits until `so_far` is true; the program must not have ended before.
#[track_caller]
fn wait_until(running: &Running, mut so_far: impl FnMut(u32) -> bool) {
    let started = Instant::now();
    while !so_far(running.child.id()) {
        assert!(!running.ends_within(BETWEEN), "it ended before it could be interrupted");
        assert!(started.elapsed() < DEADLINE, "it never came so far");
    }
}

/// Sends Ctrl-C, waits for the end, and returns exit code and message.
#[track_caller]
fn interrupt(mut running: Running) -> (Option<i32>, String) {
    // The `kill` that is built into the shell, because the program of that name may be missing.
    let sent =
        Command::new("sh").args(["-c", &format!("kill -INT {}", running.child.id())]).status().unwrap();
    assert!(sent.success());
    if !running.ends_within(DEADLINE) {
        running.child.kill().unwrap();
        panic!("it did not heed Ctrl-C");
    }
    let output = running.child.wait_with_output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

/// Whether the program has set its handler and then worked for a while. Only Linux reports this.
#[cfg(target_os = "linux")]
fn is_growing(id: u32) -> bool {
    let read = |name: &str| std::fs::read_to_string(format!("/proc/{id}/{name}")).unwrap_or_default();
    let status = read("status");
    let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    let caught = caught.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    // Fields after the name of the program, which is in brackets. The twelfth is the CPU time, in hundredths of a
    // second.
    let stat = read("stat");
    let worked =
        stat.rsplit(')').next().and_then(|rest| rest.split_whitespace().nth(11)?.parse::<u64>().ok());
    caught & 2 != 0 && worked.is_some_and(|ticks| ticks >= 50)
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_growth_leaves_nothing_behind() {
    let folder = Folder::with(&spots());
    let running = start(
        &folder,
        "grow a.dapple -o a.png --quiet --size 2048x2048 --threads 2 --pattern p.png --labels l.png --report r.json",
    );
    wait_until(&running, is_growing);
    assert_eq!(interrupt(running), (Some(130), "error: interrupted\n".to_owned()));
    assert_eq!(folder.names(), ["a.dapple"]);
}

/// The planning of a large canvas runs for long without checking the flag.
#[cfg(target_os = "linux")]
#[test]
fn a_growth_that_is_interrupted_while_it_is_planned_ends_too() {
    let folder = Folder::with(&spots());
    let running = start(&folder, "grow a.dapple -o a.png --quiet --size 6000x6000 --threads 2");
    wait_until(&running, is_growing);
    assert_eq!(interrupt(running), (Some(130), "error: interrupted\n".to_owned()));
    assert_eq!(folder.names(), ["a.dapple"]);
}

/// Whether the folder holds this number of unfinished files.
fn is_writing(folder: &Folder, files: usize) -> bool {
    folder.names().iter().filter(|name| name.ends_with(".part")).count() >= files
}

#[cfg(target_os = "linux")]
#[test]
fn an_interrupted_batch_leaves_no_empty_folder() {
    let folder = Folder::with(&spots());
    let batch = "grow a.dapple -o new/pictures --variations 2 --quiet --size 2048x2048 --threads 2";
    let running = start(&folder, batch);
    wait_until(&running, is_growing);
    assert!(folder.path("new/pictures").is_dir());
    assert_eq!(interrupt(running), (Some(130), "error: interrupted\n".to_owned()));
    assert_eq!(folder.names(), ["a.dapple"]);
}

#[test]
fn an_interrupted_material_leaves_no_empty_folder() {
    let folder = Folder::with(&spots());
    let running = start(&folder, "grow a.dapple --material maps --quiet --scale 32");
    wait_until(&running, |_| folder.path("maps").is_dir());
    assert_eq!(interrupt(running), (Some(130), "error: interrupted\n".to_owned()));
    assert_eq!(folder.names(), ["a.dapple"]);
}

#[test]
fn a_growth_interrupted_while_it_writes_leaves_nothing_behind() {
    let folder = Folder::with(&spots());
    let running = start(&folder, "grow a.dapple -o a.png --quiet --scale 64");
    wait_until(&running, |_| is_writing(&folder, 1));
    assert_eq!(interrupt(running), (Some(130), "error: interrupted\n".to_owned()));
    assert_eq!(folder.names(), ["a.dapple"]);
}

#[test]
fn a_growth_interrupted_between_two_pictures_leaves_neither() {
    let folder = Folder::with(&spots());
    let running = start(&folder, "grow a.dapple -o a.png --quiet --scale 48 --pattern p.png");
    wait_until(&running, |_| is_writing(&folder, 2));
    assert_eq!(interrupt(running), (Some(130), "error: interrupted\n".to_owned()));
    assert_eq!(folder.names(), ["a.dapple"]);
}

#[test]
fn an_earlier_picture_is_kept_when_a_growth_is_interrupted() {
    let folder = Folder::with(&spots());
    folder.write("a.png", "not a picture, but mine");
    let running = start(&folder, "grow a.dapple -o a.png --quiet --scale 64");
    wait_until(&running, |_| is_writing(&folder, 1));
    assert_eq!(interrupt(running).0, Some(130));
    assert_eq!(folder.bytes("a.png"), b"not a picture, but mine");
    assert_eq!(folder.names(), ["a.dapple", "a.png"]);
}
