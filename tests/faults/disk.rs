//! A full disk, no permission to write, no folder: the message gives the remedy, the exit code is 1, and existing files
//! stay.

use std::fs;

use crate::bench::{Bench, files, printed, say};
use crate::mounts::Mounted;

/// All commands that write, with `OUT` for the folder that they write into.
const WRITERS: [&str; 21] = [
    "grow a.dapple -o OUT/a.png",
    "grow a.dapple -o OUT/a.png --depth 16",
    "grow a.dapple -o OUT/a.tif",
    "grow a.dapple -o OUT/a.exr",
    "grow a.dapple -o OUT/a.jpg",
    "grow a.dapple -o OUT/a.webp",
    "grow a.dapple -o OUT/a.svg",
    "grow a.dapple -o OUT/a.dxf",
    "grow a.dapple -o here.png --pattern OUT/p.png",
    "grow a.dapple -o here.png --labels OUT/l.png",
    "grow a.dapple -o here.png --concentrations OUT/c.exr",
    "grow a.dapple -o here.png --report OUT/r.json",
    "grow a.dapple -o here.png --material OUT/m",
    "film a.dapple -o OUT/f.gif --seconds 0.2 --fps 10",
    "film a.dapple -o OUT/f.png --seconds 0.2 --fps 10",
    "film a.dapple -o OUT/frames --seconds 0.2 --fps 10",
    "sheet a.dapple b.dapple -o OUT/s.png --thumb 32",
    "import in.svg -o OUT/i.dapple",
    "lookup --batch in.csv -o OUT/t.csv",
    "learn --no-simulation --targets 1 --system meinhardt-stripes -o OUT/e.csv",
    "man -o OUT",
];
/// The names of the files that they write there.
const NAMES: [&str; 17] = [
    "a.png", "a.tif", "a.exr", "a.jpg", "a.webp", "a.svg", "a.dxf", "p.png", "l.png", "c.exr", "r.json",
    "f.gif", "f.png", "s.png", "i.dapple", "t.csv", "e.csv",
];

/// Writes a file of each name, to check later that it is unchanged.
fn write_old(bench: &Bench) {
    for name in NAMES {
        bench.write(&format!("out/{name}"), "old");
    }
    bench.write("out/dapple-grow.1", "old");
    fs::create_dir(bench.path("out/m")).unwrap();
    bench.write("out/m/a_Height.png", "old");
}

/// Runs all writers. Asserts that each fails with these words, and changes nothing in the folder or outside it.
fn all_refuse(bench: &Bench, words: &[&str]) {
    let (before, beside) = (files(&bench.path("out")), bench.path("here.png"));
    for writer in WRITERS {
        bench.refuses(&writer.replace("OUT", "out"), 1, words);
        assert!(!beside.exists(), "{writer}: all or none");
    }
    let after = files(&bench.path("out"));
    assert_eq!(after.keys().collect::<Vec<_>>(), before.keys().collect::<Vec<_>>());
    assert!(after == before);
}

#[test]
fn a_full_disk_is_reported_and_loses_nothing() {
    let bench = Bench::new();
    let Some(mounted) = Mounted::on(&bench.path("out")) else { return };
    write_old(&bench);
    mounted.fill(0);
    all_refuse(&bench, &["the disk is full; free some space, or choose another folder"]);
    // With many documents, each one has its own message.
    let (code, said) = bench.run("grow a.dapple b.dapple -o out");
    assert_eq!((code, said.matches("the disk is full").count()), (Some(1), 2), "{said}");
    assert_eq!(bench.bytes("out/a.png"), b"old");
}

#[test]
fn a_disk_that_fills_up_while_a_file_is_written_loses_nothing() {
    let bench = Bench::new();
    let Some(mounted) = Mounted::on(&bench.path("out")) else { return };
    write_old(&bench);
    // There is room for the beginning of each file.
    mounted.fill(1);
    let before = files(&bench.path("out"));
    for writer in [
        "grow a.dapple -o OUT/a.png --size 256x256 --scale 2",
        "grow a.dapple -o OUT/a.tif",
        "grow a.dapple -o OUT/a.exr",
        "grow a.dapple -o OUT/a.webp",
        "grow a.dapple -o OUT/a.svg --size 768x768",
        "grow a.dapple -o here.png --material OUT/m",
        "film a.dapple -o OUT/f.png --seconds 1 --fps 10 --side 256",
        "film a.dapple -o OUT/frames --seconds 1 --fps 10 --side 256",
        "man -o OUT",
    ] {
        bench.refuses(&writer.replace("OUT", "out"), 1, &["the disk is full; free some space"]);
        assert!(files(&bench.path("out")) == before, "{writer}");
    }
    assert!(!bench.path("here.png").exists());
}

#[test]
fn a_read_only_folder_is_reported_and_loses_nothing() {
    let bench = Bench::new();
    let Some(mounted) = Mounted::on(&bench.path("out")) else { return };
    write_old(&bench);
    mounted.protect();
    all_refuse(&bench, &["is not permitted; choose another folder"]);
    bench.refuses(
        "grow a.dapple b.dapple -o out/new",
        1,
        &["out", "is not permitted; choose another folder"],
    );
}

#[test]
fn a_folder_of_another_user_is_reported_and_loses_nothing() {
    let bench = Bench::new();
    fs::create_dir(bench.path("out")).unwrap();
    write_old(&bench);
    let open = |name: &str, mode: u32| {
        let mode: fs::Permissions = std::os::unix::fs::PermissionsExt::from_mode(mode);
        fs::set_permissions(bench.path(name), mode).unwrap();
    };
    open("", 0o777);
    open("out", 0o555);
    open("out/m", 0o555);
    let before = files(&bench.path("out"));
    for writer in WRITERS {
        let command = bench.command(&writer.replace("OUT", "out"));
        // Permissions do not apply to root.
        let mut nobody = std::process::Command::new("setpriv");
        nobody.args(["--reuid=65534", "--regid=65534", "--clear-groups"]);
        nobody.current_dir(bench.folder()).arg(command.get_program()).args(command.get_args());
        let ran = nobody.output().ok().map(|output| printed(&output));
        let Some((code, said)) = ran.filter(|(_, said)| !said.contains("setpriv:")) else {
            assert!(std::env::var_os("DAPPLE_MUST_MOUNT").is_none(), "setpriv is not permitted");
            say("SKIPPED a folder of somebody else: setpriv is not permitted; run it as root");
            return;
        };
        assert_eq!(code, Some(1), "{writer}: {said}");
        assert!(said.contains("is not permitted; choose another folder"), "{writer}: {said}");
        assert!(!bench.path("here.png").exists(), "{writer}");
    }
    assert!(files(&bench.path("out")) == before);
    open("out", 0o755);
    open("out/m", 0o755);
}

#[test]
fn a_missing_folder_is_reported() {
    let bench = Bench::new();
    for writer in WRITERS {
        let writer = writer.replace("OUT/", "no/way/").replace("OUT", "no");
        bench.refuses(&writer, 1, &["folder 'no", "does not exist; create it first, or choose another"]);
        assert!(!bench.path("here.png").exists() && !bench.path("no").exists(), "{writer}");
    }
}

#[test]
fn a_file_in_the_place_of_a_folder_is_reported() {
    let bench = Bench::new();
    bench.write("file", "old");
    for writer in WRITERS {
        let (code, said) = bench.run(&writer.replace("OUT", "file"));
        assert!(matches!(code, Some(1 | 2)) && said.contains("file"), "{writer}: {code:?}: {said}");
    }
    bench.refuses("grow a.dapple b.dapple -o file/out", 1, &["file/out", "folder 'file' does not exist"]);
    assert_eq!(bench.bytes("file"), b"old");
}
