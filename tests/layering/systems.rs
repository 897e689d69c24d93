//! Checks that reaction-diffusion systems are named only in their own files. Other code asks for properties of a
//! system.

use crate::sources::{is_test, module, sources};

/// Files that may name systems: each system's own, the list of all, and lists of cases to measure.
const MAY_NAME: [&str; 5] = [
    "src/engine/rd/systems/",
    "src/engine/document/systems.rs",
    "src/engine/rd/benchmark.rs",
    "data-gen/src/tables/",
    "data-gen/src/route.rs",
];

/// The lines of a file that name a system, counted from 1; tests and comments are left out.
fn named(source: &str) -> Vec<usize> {
    let program = source.split("#[cfg(test)]").next().unwrap_or(source);
    let names = |line: &str| {
        let after = line.split("System::").skip(1);
        let mut words = after.map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next());
        words.any(|word| {
            let word = word.unwrap_or_default();
            word.len() > 1 && word.chars().all(|c| c.is_ascii_uppercase() || c == '_') && word != "ALL"
        })
    };
    let lines = program.lines().enumerate();
    lines
        .filter(|(_, line)| !line.trim_start().starts_with("//") && names(line))
        .map(|(at, _)| at + 1)
        .collect()
}

#[test]
fn systems_are_named_in_their_own_files_alone() {
    let mut complaints = Vec::new();
    for (file, source) in sources() {
        if !MAY_NAME.iter().any(|place| file.starts_with(place)) && !is_test(&module(&file)) {
            complaints.extend(named(&source).into_iter().map(|line| format!("{file}:{line}")));
        }
    }
    assert!(complaints.is_empty(), "ask for a property of the system instead:\n{}", complaints.join("\n"));
}

#[test]
fn a_name_is_found_and_other_items_are_not() {
    assert_eq!(named("if system == System::TURING_SPOTS {\n}\n"), [1]);
    assert!(named("// System::TURING_SPOTS\nSystem::ALL.len() + System::named(name)\n").is_empty());
    assert!(named("#[cfg(test)]\nSystem::TURING_SPOTS").is_empty());
}
