//! Checks that kinds of layer are distinguished in only one file: the list of the kinds.

use crate::sources::sources;

/// The list of the kinds.
const LIST: &str = "src/engine/synth/layer.rs";
/// The enums that the list defines.
const ENUMS: [&str; 4] = ["LayerKind::", "LayerPlan::", "LayerGrowth::", "GrownLayer::"];
/// The folders of the kinds, and the files in which each of their names may occur.
const KINDS: [(&str, &str); 6] = [
    ("Tone", "src/engine/synth/tone/"),
    ("Pairs", "src/engine/synth/pairs/"),
    ("Areas", "src/engine/synth/areas/"),
    ("Lines", "src/engine/synth/lines/"),
    ("Points", "src/engine/synth/points/"),
    ("Marks", "src/engine/synth/marks/"),
];
/// Calls that ask a document for the kind of a layer.
const ASKED: [&str; 5] = [".pairs(index)", ".is_driven()", ".areas()", ".point_lines()", ".point_field()"];
/// Files that work on plans and on grown layers of any kind.
const ASKING_NOTHING: [&str; 9] = [
    "src/engine/synth/growth",
    "src/engine/synth/estimate.rs",
    "src/engine/synth/memory.rs",
    "src/engine/synth/layer_report.rs",
    "src/engine/synth/render/",
    "src/cli/check",
    "src/cli/grow",
    "src/app/growth/",
    "src/app/result/",
];

/// The code of a file without its comments and its tests.
fn code(source: &str) -> String {
    let code = source.split("#[cfg(test)]").next().unwrap_or_default();
    code.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// The variants of the kinds that a file names.
fn told_apart(source: &str) -> Vec<String> {
    let code = code(source);
    let named = |(kind, _): &(&str, &str)| ENUMS.map(|of| format!("{of}{kind}"));
    KINDS.iter().flat_map(named).filter(|name| code.contains(name.as_str())).collect()
}

#[test]
fn no_file_but_the_list_distinguishes_kinds_of_layer() {
    for (file, source) in sources().iter().filter(|(file, _)| file.starts_with("src/") && file != LIST) {
        assert_eq!(told_apart(source), [""; 0], "{file}: ask the plan or the grown layer instead");
    }
}

#[test]
fn files_that_work_on_layers_of_any_kind_do_not_ask_for_their_kind() {
    let mut seen = 0;
    for (file, source) in sources() {
        if ASKING_NOTHING.iter().any(|place| file.starts_with(place)) {
            let code = code(&source);
            let found: Vec<_> = ASKED.iter().filter(|asked| code.contains(**asked)).collect();
            assert!(found.is_empty(), "{file} asks {found:?}: let the kind of layer answer instead");
            seen += 1;
        }
    }
    assert!(seen >= ASKING_NOTHING.len(), "have files been renamed?");
}

#[test]
fn each_kind_of_layer_is_a_folder_and_one_line_of_the_list() {
    let all = sources();
    let (_, list) = all.iter().find(|(file, _)| file == LIST).expect("the list of the kinds");
    for (kind, folder) in KINDS {
        assert!(all.iter().any(|(file, _)| file == &format!("{folder}mod.rs")), "{folder} is missing");
        let lines = list.lines().filter(|line| line.trim_start().starts_with(&format!("{kind}: ")));
        assert_eq!(lines.count(), 1, "{kind}");
    }
}

#[test]
fn the_check_itself_finds_a_kind_that_is_distinguished() {
    let found = told_apart("fn f(l: &GrownLayer) -> bool { matches!(l, GrownLayer::Marks(_)) }");
    assert_eq!(found, ["GrownLayer::Marks"]);
    assert_eq!(
        told_apart("// GrownLayer::Marks\n#[cfg(test)] mod tests { use GrownLayer::Pairs; }"),
        [""; 0]
    );
}
