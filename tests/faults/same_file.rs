//! Inputs are not overwritten, and two outputs do not go into one file, however the file is named.

use std::fs;
use std::os::unix::fs::symlink;

use crate::bench::Bench;

#[test]
fn an_input_is_not_overwritten() {
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.png");
    fs::create_dir(bench.path("sub")).unwrap();
    symlink("a.png", bench.path("link.png")).unwrap();
    symlink("../a.png", bench.path("sub/far.png")).unwrap();
    symlink(".", bench.path("here")).unwrap();
    symlink("in.svg", bench.path("link.dapple")).unwrap();
    let before = crate::bench::files(bench.folder());
    let absolute = bench.path("a.png").display().to_string();
    for other in ["a.png", "./a.png", "sub/../a.png", "link.png", "sub/far.png", "here/a.png", &absolute] {
        for command in [
            "grow a.png -o OTHER",
            "grow OTHER -o a.png",
            "grow a.png -o c.png --pattern OTHER",
            "grow a.png -o c.png --labels OTHER",
            "grow a.png -o c.png --report OTHER",
            "grow b.dapple -o a.png --report OTHER",
            "grow b.dapple --svg c.svg --pattern a.png --labels OTHER",
            "film a.png -o OTHER",
            "film b.dapple --to a.png -o OTHER",
            "sheet b.dapple a.png -o OTHER",
        ] {
            bench.refuses(&command.replace("OTHER", other), 2, &["twice", "two files"]);
        }
    }
    for command in
        ["lookup --batch in.csv -o ./in.csv", "import in.svg -o link.dapple", "import in.svg -o in.svg"]
    {
        bench.refuses(command, 2, &["twice", "two files"]);
    }
    assert!(crate::bench::files(bench.folder()) == before);
}

#[test]
fn a_file_with_two_names_is_not_overwritten_through_the_other_name() {
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.png");
    fs::hard_link(bench.path("a.png"), bench.path("hard.png")).unwrap();
    let before = bench.bytes("a.png");
    bench.does("grow a.png -o hard.png --seed 9");
    assert!(bench.bytes("a.png") == before && bench.bytes("hard.png") != before);
}

#[test]
fn a_map_of_a_material_and_a_picture_do_not_share_a_file() {
    let bench = Bench::new();
    fs::create_dir(bench.path("m")).unwrap();
    for name in ["a_Height.png", "a_BaseColor.png", "../m/a_ID.png"] {
        let output = format!("grow a.dapple --material m -o m/{name}");
        bench.refuses(&output, 2, &["--material and --output", "twice", "two files"]);
    }
    bench.refuses("grow a.dapple --material m --report m/a.gltf", 2, &["--material and --report"]);
    bench.does("grow a.dapple --material m -o m/a.png --report m/a.json");
}

#[test]
fn documents_of_a_batch_do_not_share_a_file() {
    let bench = Bench::new();
    fs::create_dir(bench.path("sub")).unwrap();
    fs::copy(bench.path("a.dapple"), bench.path("sub/a.dapple")).unwrap();
    fs::copy(bench.path("a.dapple"), bench.path("a+.dapple")).unwrap();
    bench.refuses("grow a.dapple sub/a.dapple -o out", 2, &["whose pictures would have the same name"]);
    bench.refuses(
        "grow a.dapple a+.dapple -o out --material m",
        2,
        &["whose pictures would have the same name"],
    );
    bench.refuses(
        "grow a.dapple b.dapple -o out --concentrations c.exr",
        2,
        &["--concentrations", "one FILE"],
    );
    bench.refuses("grow a.dapple -o out --variations 2 --material m", 2, &["--material", "--variations"]);
    assert!(!bench.path("out").exists() && !bench.path("m").exists());
    // A picture that holds its document is grown into its own folder.
    bench.does("grow a.dapple -o c.png");
    let before = bench.bytes("c.png");
    bench.refuses("grow b.dapple c.png -o . --seed 7", 2, &["c.png twice", "two files"]);
    assert!(bench.bytes("c.png") == before && !bench.path("b.png").exists());
}

#[test]
fn nothing_is_written_into_the_folder_of_training_sets() {
    let bench = Bench::new();
    fs::create_dir(bench.path("sets")).unwrap();
    bench.write("sets/meinhardt-stripes.csv", "old");
    for command in [
        "learn --no-simulation --training sets -o sets/meinhardt-stripes.csv",
        "lookup --batch in.csv --training ./sets -o sets/new.csv",
    ] {
        bench.refuses(command, 2, &["in the folder of --training", "another folder"]);
    }
    assert_eq!(bench.bytes("sets/meinhardt-stripes.csv"), b"old");
}
