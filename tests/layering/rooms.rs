//! Which room may import from which, and words that may occur in one place only.

use crate::packages::ADDRESSES;
use crate::scan::{Named, scan, words};
use crate::sources::{ENGINE, module, sources};

/// The base: basic types; each room imports only from the ones before it.
const BASE: [&str; 4] = ["grid", "surface", "marks", "attributes"];
/// These rooms import from the base, not from each other.
const STEPS: [&str; 8] = ["sketch", "measure", "learn", "rd", "points", "colour", "export", "finish"];
/// The pipeline: these rooms import from base and steps, and each only from the ones before it.
const PIPELINE: [&str; 4] = ["photo", "document", "synth", "data_set"];
/// The rooms of the shell below the entry points. They import from the engine; each only from the ones before it.
const SHELL: [&str; 3] = ["machine", "files", "editor"];
/// The entry points import from everything. Nothing imports from them, except that the command line opens the window.
const ENTRY_POINTS: [&str; 2] = ["cli", "app"];

/// The package of the window.
const WINDOW: &str = "egui";
/// The only files in which the name of that package may occur.
const WINDOW_FILES: [&str; 4] = ["src/app/", "src/cli/", "src/lib.rs", "src/main.rs"];

fn may_know(room: &str, other: &str) -> bool {
    let place = |rooms: &[&str], name| rooms.iter().position(|&room| room == name);
    let base = BASE.contains(&other);
    let below_pipeline = base || STEPS.contains(&other);
    let engine = below_pipeline || PIPELINE.contains(&other);
    let below_doors = engine || SHELL.contains(&other);
    match room {
        _ if room == other => true,
        _ if BASE.contains(&room) => base && place(&BASE, other) < place(&BASE, room),
        _ if STEPS.contains(&room) => base,
        _ if PIPELINE.contains(&room) => {
            below_pipeline || PIPELINE.contains(&other) && place(&PIPELINE, other) < place(&PIPELINE, room)
        }
        _ if SHELL.contains(&room) => {
            engine || SHELL.contains(&other) && place(&SHELL, other) < place(&SHELL, room)
        }
        "cli" => below_doors || other == "app",
        "app" => below_doors,
        _ => false,
    }
}

/// The forbidden paths in `file`.
fn complaints(file: &str, source: &str) -> Vec<String> {
    let module = module(file);
    let wrong = |named: &Named| -> Option<String> {
        let first = named.path[0].as_str();
        let second = named.path.get(1).map_or("", String::as_str);
        let in_data_gen = file.starts_with("data-gen/");
        if first == "crate" {
            let room = module.first()?;
            return (!in_data_gen && !may_know(room, second))
                .then(|| format!("{room} must not import from {second}"));
        }
        if first == "dapple" && ENTRY_POINTS.contains(&second) == in_data_gen {
            return Some(format!("{second} is not for {file}"));
        }
        let (_, places) = ADDRESSES.iter().find(|(package, _)| *package == first)?;
        let at_home = named.in_tests || places.iter().any(|place| file.starts_with(place));
        (!at_home).then(|| format!("{first} may only be used in {}", places.join(", ")))
    };
    let output = |named: &Named| {
        Some(format!("{file}:{}: `{}`: {}", named.line, named.path.join("::"), wrong(named)?))
    };
    scan(source, &module).paths.iter().filter_map(output).collect()
}

#[test]
fn rooms_import_only_from_the_rooms_that_the_map_allows() {
    let sources = sources();
    let complaints: Vec<_> = sources.iter().flat_map(|(file, source)| complaints(file, source)).collect();
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

#[test]
fn every_source_file_is_in_a_room_of_the_map() {
    for (file, _) in sources().iter().filter(|(file, _)| file.starts_with("src/")) {
        let rooms: &[&[&str]] =
            if file.starts_with(ENGINE) { &[&BASE, &STEPS, &PIPELINE] } else { &[&SHELL, &ENTRY_POINTS] };
        let known = |room: &&str| rooms.iter().any(|rooms| rooms.contains(room));
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

/// Where `unsafe` may stand: in the solvers, and where the allocator is asked to give memory back.
const UNSAFE: [&str; 2] = ["src/engine/rd/", "src/machine/memory.rs"];

#[test]
fn unsafe_code_is_only_in_the_solvers_and_where_memory_is_given_back() {
    let safe = |file: &str| !UNSAFE.iter().any(|place| file.starts_with(place));
    for (file, source) in sources().iter().filter(|(file, _)| safe(file)) {
        let line = words(source).find(|(_, word)| word == "unsafe").map(|(line, _)| line);
        assert_eq!(line, None, "{file}: `unsafe` stands in {} only", UNSAFE.join(", "));
    }
}

mod the_scan_itself {
    use super::*;

    /// The paths, each as one word; `dapple` paths are made up.
    fn named(file: &str, source: &str) -> Vec<String> {
        scan(source, &module(file)).paths.iter().map(|named| named.path.join("::")).collect()
    }

    #[test]
    fn groups_are_expanded_and_self_and_super_are_followed() {
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
        assert_eq!(named("src/engine/rd/x.rs", source), expected);
        let inline = "mod tests { use super::*; mod deep { fn f() { super::super::super::up::g() } } } fn k() { super::y::z() }";
        assert_eq!(
            named("src/engine/rd/x.rs", inline),
            ["crate::rd::x::*", "crate::rd::up::g", "crate::rd::y::z"]
        );
    }

    #[test]
    fn paths_in_expressions_are_found() {
        let source = "fn f(x: &crate::learn::Row) -> Vec<crate::rd::P> { $crate::synth::g::<::spade::Q>(x.crate_learn) }";
        assert_eq!(
            named("src/engine/grid/field.rs", source),
            ["crate::learn::Row", "crate::rd::P", "crate::synth::g", "spade::Q"]
        );
    }

    #[test]
    fn comments_strings_and_characters_are_skipped() {
        let source = r####"
            //! crate::app::A
            /* crate::app::B /* crate::app::C */ crate::app::D */
            const S: &str = "crate::app::E \" crate::app::F";
            const R: &str = r#"crate::app::G " crate::app::H"#;
            const Q: [char; 3] = ['"', '\'', '\u{22}'];
            fn f<'a>(x: &'a str) -> &'a str { crate::grid::g(x, b"crate::app::I", br"crate::app::J\") }
        "####;
        assert_eq!(named("src/engine/rd/mod.rs", source), ["crate::grid::g"]);
    }

    #[test]
    fn finds_each_kind_of_forbidden_import() {
        let trespasses = [
            ("src/engine/colour/mod.rs", "use crate::export::png;"),
            ("src/engine/colour/deep/x.rs", "fn f() { super::super::super::export::g() }"),
            ("src/engine/learn/mod.rs", "use super::{grid, synth::cascade};"),
            ("src/engine/marks/fit.rs", "use crate::{grid::Field, attributes::Attributes};"),
            ("src/engine/grid/field.rs", "fn f() -> crate::marks::Marks { todo!() }"),
            ("src/engine/synth/mod.rs", "mod tests { use crate::cli; }"),
            ("src/engine/synth/mod.rs", "use crate::editor::History;"),
            ("src/engine/document/mod.rs", "use crate::synth::Grown;"),
            ("src/engine/synth/mod.rs", "use crate::files::save;"),
            ("src/engine/export/mod.rs", "use crate::machine::clock;"),
            ("src/machine/mod.rs", "use crate::files::save;"),
            ("src/files/mod.rs", "use crate::editor::task;"),
            ("src/editor/mod.rs", "use crate::app::Window;"),
            ("src/app/mod.rs", "use crate::cli::grow;"),
            ("src/engine/rd/mod.rs", "use super::*;"),
            ("src/engine/rd/mod.rs", "use crate as root;"),
            ("src/engine/measure/mod.rs", "use image::DynamicImage;"),
            ("src/engine/measure/mod.rs", "fn f() { ::png::Decoder::new(x) }"),
            ("src/engine/attributes/mod.rs", "pub use spade;"),
            ("src/cli/grow.rs", "use dapple_engine::synth;"),
            ("src/main.rs", "fn main() { dapple::rd::run() }"),
            ("data-gen/src/main.rs", "use dapple::{rd, cli};"),
        ];
        for (file, source) in trespasses {
            assert_eq!(complaints(file, source).len(), 1, "{file}: {source}: {:?}", complaints(file, source));
        }
    }

    #[test]
    fn allowed_imports_pass() {
        let allowed = [
            (
                "src/engine/attributes/spacing/delaunay.rs",
                "use crate::marks::Ellipse; use spade::Triangulation;",
            ),
            (
                "src/engine/rd/turing/fast.rs",
                "use super::super::diffusion; use crate::{grid::Field, rd::explicit};",
            ),
            (
                "src/engine/synth/mod.rs",
                "use crate::{learn, rd, colour, export, sketch, measure, attributes};",
            ),
            ("src/engine/document/mod.rs", "use crate::{marks::Mark, rd::System};"),
            ("src/machine/clock.rs", "use crate::synth::Machine;"),
            (
                "src/files/save.rs",
                "use crate::{export::ExportError, machine}; use crate::machine::temporary::NamedTempFile;",
            ),
            ("src/machine/temporary.rs", "use tempfile::NamedTempFile;"),
            ("src/editor/history.rs", "use crate::{attributes, document::Document, files, synth::Grown};"),
            ("src/cli/grow.rs", "use crate::{app, export::png, synth}; fn f() { png::write() }"),
            ("src/engine/export/mod.rs", "pub mod png; pub use save::save; mod save;"),
            (
                "src/engine/learn/x.rs",
                "#[cfg(test)] mod tests { use super::*; fn f() { tempfile::tempdir() } }",
            ),
            ("src/main.rs", "fn main() { dapple::cli::main() }"),
            ("data-gen/src/sweep.rs", "use crate::anything; use dapple::{rd, measure};"),
        ];
        for (file, source) in allowed {
            assert_eq!(complaints(file, source), [""; 0], "{file}");
        }
    }
}
