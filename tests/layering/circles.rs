//! Checks that there is no circle of imports within a room.
//!
//! Of two modules with the same parent, each with everything below it, only one may import from the other, directly or
//! through further such modules. A parent and the modules below it may import from each other. Re-exports are
//! resolved: an import of `crate::synth::Engine` is one from the file that defines it.

use std::collections::{BTreeMap, VecDeque};

use crate::scan::{Scan, scan};
use crate::sources::{is_test, module, sources};

/// The stages of `synth`: each imports only from the ones before it.
const STAGES: [&str; 13] = [
    "passes", "report", "kind", "marks", "pairs", "areas", "lines", "points", "tone", "body", "layer",
    "growth", "render",
];

/// The module path of a file, below the crate's root.
type Module = Vec<String>;

/// The imports between the modules of one parent: from → to → the places of the imports.
type Imports = BTreeMap<String, BTreeMap<String, Vec<String>>>;

/// The sources of each crate, and whether its top modules are rooms. The imports between rooms are checked by `rooms`.
const CRATES: [(&str, bool); 2] = [("src/", true), ("data-gen/src/", false)];

/// Every circle below a room, for every parent; empty where there is none. Only one circle is listed for each parent
/// and first module.
pub fn circles(files: &[(String, String)]) -> Vec<String> {
    let mut circles = Vec::new();
    for (parent, imports) in CRATES.iter().flat_map(|source| House::new(files, *source).imports()) {
        let mut seen: Vec<Vec<&str>> = Vec::new();
        for start in imports.keys() {
            if let Some(circle) = shortest_circle(&imports, start) {
                let mut members = circle.clone();
                members.sort_unstable();
                if !seen.contains(&members) {
                    circles.push(output(&parent, &imports, &circle));
                    seen.push(members);
                }
            }
        }
    }
    circles
}

/// The files of the program, without its tests.
struct House {
    files: BTreeMap<Module, (String, Scan)>,
    has_rooms: bool,
}

impl House {
    fn new(files: &[(String, String)], (source, has_rooms): (&str, bool)) -> Self {
        // `main.rs` is a separate crate, from which nothing can be imported.
        let is_of_crate = |file: &str| file.strip_prefix(source).is_some_and(|file| file != "main.rs");
        let program = files.iter().filter(|(file, _)| is_of_crate(file) && !is_test(&module(file)));
        let scanned = program.map(|(file, source)| {
            let module = module(file);
            (module.iter().map(|&name| name.to_owned()).collect(), (file.clone(), scan(source, &module)))
        });
        Self { files: scanned.collect(), has_rooms }
    }

    /// The imports between neighbouring modules, by their parent.
    fn imports(&self) -> BTreeMap<Module, Imports> {
        let mut all: BTreeMap<Module, Imports> = BTreeMap::new();
        for (from, (file, scan)) in &self.files {
            for named in scan.paths.iter().filter(|named| !named.in_tests && named.path[0] == "crate") {
                let Some(to) = self.resolve(&named.path[1..], 0) else { continue };
                let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
                // Imports between rooms are checked by `rooms`; imports between a parent and its modules are allowed.
                if shared == 0 && self.has_rooms || shared == from.len() || shared == to.len() {
                    continue;
                }
                let neighbours = all.entry(from[..shared].to_vec()).or_default();
                let imported = neighbours.entry(from[shared].clone()).or_default();
                let place = format!("{file}:{}: `{}`", named.line, named.path.join("::"));
                imported.entry(to[shared].clone()).or_default().push(place);
            }
        }
        all
    }

    /// The module of the file that defines `path` (below the root); `None` if this is not a file of the program.
    fn resolve(&self, path: &[String], depth: usize) -> Option<Module> {
        let known = (0..=path.len()).rev().find(|&end| self.files.contains_key(&path[..end]))?;
        let (_, scan) = &self.files[&path[..known]];
        let re_exported = path.get(known).and_then(|name| scan.bound.get(name));
        // This is a name that refers to itself (an inline module), or a circle of re-exports.
        match re_exported.filter(|full| full[1..] != path[..=known] && depth < 16) {
            Some(full) => {
                let path: Vec<String> = full[1..].iter().chain(&path[known + 1..]).cloned().collect();
                self.resolve(&path, depth + 1)
            }
            None => Some(path[..known].to_vec()),
        }
    }
}

/// The shortest way from `start` along imports back to `start`.
fn shortest_circle<'a>(imports: &'a Imports, start: &'a str) -> Option<Vec<&'a str>> {
    let mut came_from: BTreeMap<&str, &str> = BTreeMap::new();
    let mut queue = VecDeque::from([start]);
    while let Some(module) = queue.pop_front() {
        for next in imports.get(module).into_iter().flat_map(BTreeMap::keys) {
            if next == start {
                let mut circle = vec![module];
                while circle[circle.len() - 1] != start {
                    circle.push(came_from[circle[circle.len() - 1]]);
                }
                circle.reverse();
                return Some(circle);
            }
            if !came_from.contains_key(next.as_str()) {
                came_from.insert(next, module);
                queue.push_back(next);
            }
        }
    }
    None
}

fn output(parent: &Module, imports: &Imports, circle: &[&str]) -> String {
    let next = circle.iter().cycle().skip(1);
    let steps = circle.iter().zip(next).map(|(from, to)| {
        let places = &imports[*from][*to];
        let more = if places.len() > 1 { format!(" and {} more", places.len() - 1) } else { String::new() };
        format!("\n    {from} → {to}: {}{more}", places[0])
    });
    let round = [circle, &circle[..1]].concat().join(" → ");
    format!("{}: {round}{}", parent.join("/"), steps.collect::<String>())
}

#[test]
fn no_circle_of_imports_within_a_room() {
    let circles = circles(&sources());
    assert!(circles.is_empty(), "\n{}\n", circles.join("\n"));
}

#[test]
fn the_stages_of_synth_import_only_from_those_before_them() {
    let all = House::new(&sources(), CRATES[0]).imports();
    let stage = |name: &str| STAGES.iter().position(|stage| *stage == name);
    let mut found = 0;
    for (from, imports) in &all[&vec!["synth".to_owned()]] {
        for (to, places) in imports {
            if let (Some(a), Some(b)) = (stage(from), stage(to)) {
                assert!(b < a, "{from} must not import from {to}:\n    {}", places.join("\n    "));
                found += 1;
            }
        }
    }
    assert!(found > 0, "no stage imports from another: have they been renamed?");
}

mod the_check_itself {
    use super::*;

    fn found(files: &[(&str, &str)]) -> Vec<String> {
        circles(
            &files
                .iter()
                .map(|(file, source)| ((*file).to_owned(), (*source).to_owned()))
                .collect::<Vec<_>>(),
        )
    }

    /// The first lines of each complaint: the importing modules.
    fn in_short(files: &[(&str, &str)]) -> Vec<String> {
        found(files).iter().map(|circle| circle.lines().next().unwrap().to_owned()).collect()
    }

    #[test]
    fn a_circle_is_printed_with_the_places_of_its_imports() {
        let files = [
            ("src/rd/a.rs", "use super::b::B;"),
            ("src/rd/b.rs", "\nfn f() { crate::rd::c::g() }"),
            ("src/rd/c.rs", "use crate::rd::a;"),
        ];
        let expected = "rd: a → b → c → a\n    a → b: src/rd/a.rs:1: `crate::rd::b::B`\n    \
                        b → c: src/rd/b.rs:2: `crate::rd::c::g`\n    c → a: src/rd/c.rs:1: `crate::rd::a`";
        assert_eq!(found(&files), [expected]);
    }

    #[test]
    fn re_exports_aliases_and_modules_imported_by_name_are_followed() {
        let re_exported = [
            ("src/rd/mod.rs", "mod a; mod b; pub use a::A; pub(crate) use self::b::deep::{B as C};"),
            ("src/rd/a.rs", "use super::C;"),
            ("src/rd/b/mod.rs", "pub mod deep;"),
            ("src/rd/b/deep.rs", "fn f(_: crate::rd::A) {}"),
        ];
        assert_eq!(in_short(&re_exported), ["rd: a → b → a"]);
        let by_name = [
            ("src/rd/mod.rs", "pub mod a; pub mod b;"),
            ("src/rd/a.rs", "use super::super::rd; fn f() { rd::b::g() }"),
            ("src/rd/b.rs", "use crate::{rd as here}; fn g() { here::a::f() }"),
        ];
        assert_eq!(in_short(&by_name), ["rd: a → b → a"]);
        let chain = [
            ("src/rd/mod.rs", "mod a; mod b; pub use b::B;"),
            ("src/rd/a.rs", "use super::B; pub struct A;"),
            ("src/rd/b.rs", "pub use self::inner::B; mod inner { pub struct B(crate::rd::a::A); }"),
        ];
        assert_eq!(in_short(&chain), ["rd: a → b → a"]);
    }

    #[test]
    fn circles_between_folders_and_below_them_are_found() {
        let between = [
            ("src/synth/plan/a.rs", "use crate::synth::grow::x::X;"),
            ("src/synth/plan/b.rs", ""),
            ("src/synth/grow/x.rs", ""),
            ("src/synth/grow/y.rs", "use crate::synth::plan::b::B;"),
        ];
        assert_eq!(in_short(&between), ["synth: grow → plan → grow"]);
        let below =
            [("src/synth/plan/a.rs", "use super::b::B;"), ("src/synth/plan/b.rs", "use super::a::A;")];
        assert_eq!(in_short(&below), ["synth/plan: a → b → a"]);
    }

    #[test]
    fn circles_between_the_top_modules_of_data_gen_which_has_no_rooms_are_found() {
        let files = [
            ("data-gen/src/lib.rs", "mod a; mod b; use a::A;"),
            ("data-gen/src/main.rs", "fn main() { data_gen::main() }"),
            ("data-gen/src/a.rs", "use crate::b;"),
            ("data-gen/src/b.rs", "use super::a;"),
        ];
        assert_eq!(in_short(&files), [": a → b → a"]);
    }

    #[test]
    fn imports_of_parents_their_modules_tests_and_other_rooms_pass() {
        let allowed = [
            ("src/rd/mod.rs", "pub mod a; pub mod b; pub use a::A; use crate::grid::G; fn f() { b::g() }"),
            ("src/rd/a.rs", "use super::f; use super::b; mod tests { use super::*; }"),
            ("src/rd/b.rs", "use super::f; #[cfg(test)] mod tests { use crate::rd::a::A; }"),
            ("src/rd/b/deep.rs", "use super::g; use crate::rd::f;"),
            ("src/rd/b/tests.rs", "use crate::rd::a;"),
            ("src/rd/b_tests.rs", "use crate::rd::a; fn f() { super::a::h() }"),
            ("src/grid/mod.rs", "use crate::rd::a;"),
        ];
        assert_eq!(found(&allowed), [""; 0]);
    }
}
