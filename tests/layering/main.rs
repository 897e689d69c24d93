//! Holds the arrows of the house (the map is at the head of `src/lib.rs`): who may know whom, where each
//! outside package lives, what may stand at the top of the tree.

mod scan;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use scan::{Named, paths};

/// Words; each knows only the ones before it.
const GROUND: [&str; 3] = ["grid", "marks", "attributes"];
/// Know the ground, never each other.
const STEPS: [&str; 6] = ["sketch", "measure", "learn", "rd", "colour", "export"];
/// Knows ground and steps.
const THREAD: &str = "synth";
/// Know everything; nothing knows them, but that the command line opens the window.
const DOORS: [&str; 2] = ["cli", "app"];

/// Where each outside package may be named, by the beginning of the file's path. Tests beside the code may
/// name any.
const ADDRESSES: [(&str, &[&str]); 30] = [
    ("ab_glyph", &["src/cli/sheet/"]),
    ("bytemuck", &["src/rd/"]),
    ("clap", &["src/cli/", "data-gen/"]),
    ("clap_complete", &["src/cli/"]),
    ("clap_mangen", &["src/cli/"]),
    ("csv", &["src/learn/", "src/cli/"]),
    ("ctrlc", &["src/cli/", "data-gen/"]),
    ("dapple", &["src/main.rs", "data-gen/"]),
    ("directories", &["src/app/", "src/editor/"]),
    ("eframe", &["src/app/", "src/cli/", "src/main.rs"]),
    (WINDOW, &["src/app/", "src/cli/"]),
    ("egui_plot", &["src/app/cloud/"]),
    ("gif", &["src/export/"]),
    ("exr", &["src/export/", "src/app/exporting/sight.rs"]),
    (
        "image",
        &[
            "src/export/",
            "src/cli/measure.rs",
            "src/app/examples.rs",
            "src/app/exporting/",
            "src/app/reference.rs",
        ],
    ),
    ("indicatif", &["src/cli/", "data-gen/"]),
    ("kurbo", &["src/export/", "src/marks/", "src/sketch/"]),
    ("nalgebra", &["src/marks/", "src/learn/", "src/rd/"]),
    ("open", &["src/app/"]),
    ("palette", &["src/colour/"]),
    ("png", &["src/export/", "src/cli/measure.rs"]),
    ("rfd", &["src/app/chooser.rs"]),
    ("serde_json", &["src/synth/", "src/cli/", "src/learn/", "data-gen/"]),
    ("serde_path_to_error", &["data-gen/"]),
    ("spade", &["src/attributes/spacing.rs"]),
    ("strsim", &["src/document/", "src/cli/"]),
    ("sysinfo", &["src/synth/", "src/cli/"]),
    ("tempfile", &["src/export/"]),
    ("tiff", &["src/export/"]),
    ("usvg", &["src/sketch/svg.rs"]),
];
/// Packages that are as common as the language.
const EVERYWHERE: [&str; 6] = ["libm", "rand", "rand_pcg", "rayon", "serde", "thiserror"];

/// The window's package.
const WINDOW: &str = "egui";
/// Files in which that word may occur at all.
const WINDOW_FILES: [&str; 4] = ["src/app/", "src/cli/", "src/lib.rs", "src/main.rs"];

/// What may stand at the top of the tree, beside dotfiles and licences.
const TOP: [&str; 13] = [
    "Cargo.toml",
    "Cargo.lock",
    "README.md",
    "CHANGELOG.md",
    "src",
    "data-gen",
    "training",
    "tests",
    "benches",
    "examples",
    "assets",
    "docs",
    "fuzz",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Path (from the root, with `/`) and text of each source file of the program and of data-gen.
fn sources() -> Vec<(String, String)> {
    let mut files = Vec::new();
    let mut folders = vec![root().join("src"), root().join("data-gen/src")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("the source tree can be read") {
            let path = entry.expect("the source tree can be read").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                files.push((name_of(&path), fs::read_to_string(&path).expect("sources are UTF-8")));
            }
        }
    }
    files.sort();
    files
}

fn name_of(path: &Path) -> String {
    let parts = path.strip_prefix(root()).expect("below the root").iter();
    parts.map(|part| part.to_str().expect("names are UTF-8")).collect::<Vec<_>>().join("/")
}

/// `src/rd/turing.rs` → `["rd", "turing"]`; roots → `[]`.
fn module(file: &str) -> Vec<&str> {
    let inside = file.trim_start_matches("data-gen/").trim_start_matches("src/").trim_end_matches(".rs");
    let mut module: Vec<_> = inside.split('/').collect();
    if module.last() == Some(&"mod") || module == ["lib"] || module == ["main"] {
        module.pop();
    }
    module
}

fn may_know(room: &str, other: &str) -> bool {
    let ground = |name| GROUND.iter().position(|&word| word == name);
    let is_step = STEPS.contains(&other);
    let words = ground(other).is_some();
    match room {
        _ if room == other => true,
        _ if ground(room).is_some() => words && ground(other) < ground(room),
        _ if STEPS.contains(&room) => words,
        THREAD => words || is_step,
        "cli" => words || is_step || other == THREAD || other == "app",
        "app" => words || is_step || other == THREAD,
        _ => false,
    }
}

/// What is wrong with the paths that `file` names.
fn complaints(file: &str, source: &str) -> Vec<String> {
    let module = module(file);
    let wrong = |named: &Named| -> Option<String> {
        let first = named.path[0].as_str();
        let second = named.path.get(1).map_or("", String::as_str);
        let in_data_gen = file.starts_with("data-gen/");
        if first == "crate" {
            let room = module.first()?;
            return (!in_data_gen && !may_know(room, second))
                .then(|| format!("{room} must not know {second}"));
        }
        if first == "dapple" && DOORS.contains(&second) == in_data_gen {
            return Some(format!("{second} is not for {file}"));
        }
        let (_, places) = ADDRESSES.iter().find(|(package, _)| *package == first)?;
        let at_home = named.in_tests || places.iter().any(|place| file.starts_with(place));
        (!at_home).then(|| format!("{first} lives only in {}", places.join(", ")))
    };
    let found = paths(source, &module);
    let told = |named: &Named| {
        Some(format!("{file}:{}: `{}`: {}", named.line, named.path.join("::"), wrong(named)?))
    };
    found.iter().filter_map(told).collect()
}

#[test]
fn rooms_know_only_what_the_map_allows() {
    let sources = sources();
    assert!(sources.len() > 15, "the scan found only {} files", sources.len());
    let complaints: Vec<_> = sources.iter().flat_map(|(file, source)| complaints(file, source)).collect();
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

#[test]
fn every_source_file_is_in_a_room_of_the_map() {
    for (file, _) in sources().iter().filter(|(file, _)| file.starts_with("src/")) {
        let known = |room: &&str| {
            GROUND.contains(room) || STEPS.contains(room) || DOORS.contains(room) || *room == THREAD
        };
        let module = module(file);
        assert!(
            module.first().is_none_or(known),
            "{file} is in no room of the map at the head of src/lib.rs"
        );
    }
}

#[test]
fn the_window_is_named_only_where_it_opens() {
    for (file, source) in sources() {
        let may = WINDOW_FILES.iter().any(|place| file.starts_with(place));
        let line = source.lines().position(|line| line.to_lowercase().contains(WINDOW));
        if let (false, Some(line)) = (may, line) {
            panic!("{file}:{}: the word {WINDOW} belongs to {}", line + 1, WINDOW_FILES.join(", "));
        }
    }
}

#[test]
fn every_package_has_an_address() {
    for manifest in ["Cargo.toml", "data-gen/Cargo.toml"] {
        let text = fs::read_to_string(root().join(manifest)).expect("the manifest can be read");
        let mut section = "";
        for line in text.lines() {
            if line.starts_with('[') {
                section = line.trim();
            }
            let table = section.ends_with("dependencies]") && !section.contains("dev-");
            let Some((name, _)) =
                line.split_once(['=', '.']).filter(|_| table && !line.starts_with(['#', '[']))
            else {
                continue;
            };
            let name = name.trim().replace('-', "_");
            let known =
                EVERYWHERE.contains(&name.as_str()) || ADDRESSES.iter().any(|(package, _)| *package == name);
            assert!(known, "{manifest}: give {name} an address in tests/layering");
        }
    }
}

#[test]
fn data_gen_builds_without_the_window() {
    let cargo = std::env::var_os("CARGO").map_or_else(|| PathBuf::from(env!("CARGO")), PathBuf::from);
    let tree = ["tree", "-p", "data-gen", "-e", "normal,build", "--prefix", "none", "--offline", "--locked"];
    let Ok(output) = Command::new(cargo).args(tree).current_dir(root()).output() else {
        eprintln!("cargo is not here: not looked at");
        return;
    };
    let (tree, said) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "cargo tree: {said}");
    let packages: Vec<_> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(packages.contains(&"data-gen") && packages.contains(&"dapple"), "{tree}");
    for package in packages {
        let window = [WINDOW, "eframe", "epaint", "winit", "wgpu", "glow"]
            .iter()
            .any(|name| package.starts_with(name));
        assert!(!window, "data-gen pulls {package} in");
    }
}

#[test]
fn the_top_of_the_tree_holds_only_what_belongs_there() {
    // What git keeps: a picture that someone grew here is his.
    let listed = Command::new("git").args(["ls-files", "-z"]).current_dir(root()).output();
    let Some(listed) = listed.ok().filter(|output| output.status.success()) else {
        eprintln!("no git, or no repository: not looked at");
        return;
    };
    for file in String::from_utf8_lossy(&listed.stdout).split_terminator('\0') {
        let top = file.split('/').next().unwrap_or(file);
        let known = top.starts_with('.') || top.starts_with("LICENSE") || TOP.contains(&top);
        assert!(
            known,
            "{top} does not belong at the top; allowed are {}, licences, dotfiles",
            TOP.join(", ")
        );
    }
}

mod the_scan_itself {
    use super::*;

    /// The paths, each as one word; `dapple` paths are made up.
    fn named(file: &str, source: &str) -> Vec<String> {
        paths(source, &module(file)).iter().map(|named| named.path.join("::")).collect()
    }

    #[test]
    fn spreads_groups_and_follows_self_and_super() {
        let source = "use crate::{a, b::{self, c as d}, e::*};\nuse super::{super::f, g};\nuse self::h;";
        let expected = [
            "crate::a",
            "crate::b",
            "crate::b::c",
            "crate::e::*",
            "crate::f",
            "crate::rd::g",
            "crate::rd::x::h",
        ];
        assert_eq!(named("src/rd/x.rs", source), expected);
        let inline = "mod tests { use super::*; mod deep { fn f() { super::super::super::up::g() } } } fn k() { super::y::z() }";
        assert_eq!(named("src/rd/x.rs", inline), ["crate::rd::x::*", "crate::rd::up::g", "crate::rd::y::z"]);
    }

    #[test]
    fn sees_paths_in_running_code() {
        let source = "fn f(x: &crate::learn::Row) -> Vec<crate::rd::P> { $crate::synth::g::<::spade::Q>(x.crate_learn) }";
        assert_eq!(
            named("src/field.rs", source),
            ["crate::learn::Row", "crate::rd::P", "crate::synth::g", "spade::Q"]
        );
    }

    #[test]
    fn passes_over_comments_strings_and_characters() {
        let source = r####"
            //! crate::app::A
            /* crate::app::B /* crate::app::C */ crate::app::D */
            const S: &str = "crate::app::E \" crate::app::F";
            const R: &str = r#"crate::app::G " crate::app::H"#;
            const Q: [char; 3] = ['"', '\'', '\u{22}'];
            fn f<'a>(x: &'a str) -> &'a str { crate::field::g(x, b"crate::app::I", br"crate::app::J\") }
        "####;
        assert_eq!(named("src/rd/mod.rs", source), ["crate::field::g"]);
    }

    #[test]
    fn catches_each_kind_of_trespass() {
        let trespasses = [
            ("src/colour/mod.rs", "use crate::export::png;"),
            ("src/colour/deep/x.rs", "fn f() { super::super::super::export::g() }"),
            ("src/learn/mod.rs", "use super::{field, synth::cascade};"),
            ("src/marks/fit.rs", "use crate::{field::Field, attributes::Attributes};"),
            ("src/field.rs", "fn f() -> crate::marks::Marks { todo!() }"),
            ("src/synth/mod.rs", "mod tests { use crate::cli; }"),
            ("src/app/mod.rs", "use crate::cli::grow;"),
            ("src/rd/mod.rs", "use super::*;"),
            ("src/rd/mod.rs", "use crate as root;"),
            ("src/measure/mod.rs", "use image::DynamicImage;"),
            ("src/measure/mod.rs", "fn f() { ::png::Decoder::new(x) }"),
            ("src/attributes/mod.rs", "pub use spade;"),
            ("src/main.rs", "fn main() { dapple::rd::run() }"),
            ("data-gen/src/main.rs", "use dapple::{rd, cli};"),
        ];
        for (file, source) in trespasses {
            assert_eq!(complaints(file, source).len(), 1, "{file}: {source}: {:?}", complaints(file, source));
        }
    }

    #[test]
    fn lets_what_is_allowed_pass() {
        let allowed = [
            ("src/attributes/spacing.rs", "use crate::marks::Ellipse; use spade::Triangulation;"),
            (
                "src/rd/turing/fast.rs",
                "use super::super::diffusion; use crate::{field::Field, rd::explicit};",
            ),
            ("src/synth/mod.rs", "use crate::{learn, rd, colour, export, sketch, measure, attributes};"),
            ("src/cli/grow.rs", "use crate::{app, export::png, synth}; fn f() { png::write() }"),
            ("src/export/mod.rs", "pub mod png; pub use save::save; mod save;"),
            ("src/learn/x.rs", "#[cfg(test)] mod tests { use super::*; fn f() { tempfile::tempdir() } }"),
            ("src/main.rs", "fn main() { dapple::cli::main() }"),
            ("data-gen/src/sweep.rs", "use crate::anything; use dapple::{rd, measure};"),
        ];
        for (file, source) in allowed {
            assert_eq!(complaints(file, source), [""; 0], "{file}");
        }
    }
}
