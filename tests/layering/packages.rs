//! Where each external package may be used, and which packages a build contains.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use crate::scan::scan;
use crate::sources::{ENGINE, module, root, sources};

/// The paths, or beginnings of paths, in which each external package may be named. Tests inside source files may name
/// any package.
pub const ADDRESSES: [(&str, &[&str]); 44] = [
    ("ab_glyph", &["src/cli/sheet/"]),
    (
        "base64",
        &["src/engine/document/tone.rs", "src/engine/document/link.rs", "src/engine/surface/model/gltf/"],
    ),
    ("bevy_mikktspace", &["src/engine/export/bake/tangents.rs"]),
    ("bytemuck", &["src/engine/rd/"]),
    ("clap", &["src/cli/", "data-gen/"]),
    ("clap_complete", &["src/cli/"]),
    ("clap_mangen", &["src/cli/"]),
    ("csv", &["src/engine/learn/", "src/cli/"]),
    ("ctrlc", &["src/cli/"]),
    ("dapple", &["src/main.rs", "data-gen/"]),
    ("dapple_engine", &["src/lib.rs", "data-gen/"]),
    ("directories", &["src/app/platform/desktop.rs"]),
    ("eframe", &["src/app/"]),
    ("egui", &["src/app/"]),
    ("egui_plot", &["src/app/cloud/"]),
    ("gif", &["src/engine/export/"]),
    ("exr", &["src/engine/export/", "src/app/exporting/preview_images.rs"]),
    (
        "image",
        &[
            "src/engine/export/",
            "src/engine/photo/decode",
            "src/engine/photo/opaque.rs",
            "src/engine/synth/import/measured_picture.rs",
            "src/app/asset.rs",
            "src/app/exporting/",
            "src/app/canvas/reference.rs",
            // The clipboard of a browser takes PNG.
            "src/app/platform/browser.rs",
        ],
    ),
    ("gltf", &["src/engine/surface/model/gltf"]),
    ("indicatif", &["src/cli/", "data-gen/"]),
    ("kurbo", &["src/engine/export/"]),
    ("libc", &["src/machine/memory.rs"]),
    ("miniz_oxide", &["src/engine/document/link.rs", "src/engine/sketch/svg/text.rs"]),
    (
        "nalgebra",
        &[
            "src/engine/marks/",
            "src/engine/learn/",
            "src/engine/photo/light.rs",
            "src/engine/points/roughened.rs",
        ],
    ),
    ("open", &["src/app/platform/desktop.rs"]),
    ("palette", &["src/engine/colour/", "src/engine/export/downscale.rs"]),
    ("ply_rs_bw", &["src/engine/surface/model/ply"]),
    ("png", &["src/engine/export/", "data-gen/"]),
    ("rfd", &["src/app/platform/desktop/"]),
    ("rustix", &["src/machine/"]),
    (
        "serde_json",
        &[
            "src/engine/data_set/",
            "src/engine/document/",
            "src/engine/export/body/glb.rs",
            "src/editor/",
            "src/cli/",
            "src/engine/learn/",
            "src/engine/synth/",
            "data-gen/",
        ],
    ),
    ("serde_path_to_error", &["data-gen/"]),
    ("smallvec", &["src/engine/points/"]),
    ("sha2", &["src/files/model.rs"]),
    (
        "spade",
        &[
            "src/engine/attributes/spacing/delaunay.rs",
            "src/engine/grid/triangulation.rs",
            "src/engine/points/delaunay.rs",
        ],
    ),
    ("strsim", &["src/engine/document/"]),
    ("svgtypes", &["src/app/panels/colour/"]),
    ("sysinfo", &["src/machine/", "src/cli/"]),
    ("tempfile", &["src/machine/"]),
    ("tiff", &["src/engine/export/", "src/engine/photo/decode"]),
    ("usvg", &["src/engine/sketch/svg"]),
    ("uvunwrap", &["src/engine/export/bake/unwrap.rs"]),
    ("web_time", &["src/machine/"]),
    ("zip", &["src/machine/browser/"]),
];
/// Packages that may be used everywhere.
const EVERYWHERE: [&str; 7] = ["libm", "multiversion", "rand", "rand_pcg", "rayon", "serde", "thiserror"];

/// The manifests, and where the sources of their packages are.
const MANIFESTS: [(&str, &str); 3] =
    [("Cargo.toml", "src/"), ("src/engine/Cargo.toml", ENGINE), ("data-gen/Cargo.toml", "data-gen/src/")];

/// The packages that a manifest names as dependencies, in the spelling of code; those for tests are left out.
pub fn dependencies(manifest: &str) -> Vec<String> {
    let text = fs::read_to_string(root().join(manifest)).expect("the manifest can be read");
    let mut section = "";
    let mut names = Vec::new();
    for line in text.lines() {
        if line.starts_with('[') {
            section = line.trim();
        }
        let table = section.ends_with("dependencies]") && !section.contains("dev-");
        let named = line.split_once(['=', '.']).filter(|_| table && !line.starts_with(['#', '[']));
        names.extend(named.map(|(name, _)| name.trim().replace('-', "_")));
    }
    names
}

#[test]
fn every_dependency_is_named_in_its_package() {
    let sources = sources();
    for (manifest, folder) in MANIFESTS {
        // The engine lies within the program's folder.
        let inside = |file: &str| file.starts_with(folder) && (folder == ENGINE || !file.starts_with(ENGINE));
        let named: BTreeSet<String> = sources
            .iter()
            .filter(|(file, _)| inside(file))
            .flat_map(|(file, source)| scan(source, &module(file)).paths)
            .map(|named| named.path[0].clone())
            .collect();
        for name in dependencies(manifest) {
            assert!(named.contains(&name), "{manifest}: no source of the package names {name}");
        }
    }
}

#[test]
fn every_package_has_a_list_of_places() {
    for (manifest, _) in MANIFESTS {
        for name in dependencies(manifest) {
            let known =
                EVERYWHERE.contains(&name.as_str()) || ADDRESSES.iter().any(|(package, _)| *package == name);
            assert!(known, "{manifest}: give {name} an address in tests/layering");
        }
    }
}

#[test]
fn every_place_of_a_package_is_used() {
    let sources = sources();
    for (package, places) in ADDRESSES {
        for place in places {
            let mut there = sources.iter().filter(|(file, _)| file.starts_with(place));
            let used = there.any(|(file, source)| {
                scan(source, &module(file)).paths.iter().any(|named| named.path[0] == package)
            });
            assert!(used, "{package} is not used in {place}: take the address away");
        }
    }
}

/// The names of all packages in a build; `None` if cargo cannot be run.
fn packages(build: &[&str]) -> Option<Vec<String>> {
    let cargo = std::env::var_os("CARGO").map_or_else(|| PathBuf::from(env!("CARGO")), PathBuf::from);
    let tree = ["tree", "-e", "normal,build", "--prefix", "none", "--offline", "--locked"];
    let output = Command::new(cargo).args(tree).args(build).current_dir(root()).output();
    let Ok(output) = output else {
        eprintln!("NOT CHECKED: cargo cannot be run");
        return None;
    };
    assert!(output.status.success(), "cargo tree: {}", String::from_utf8_lossy(&output.stderr));
    let tree = String::from_utf8_lossy(&output.stdout);
    let names = tree.lines().filter_map(|line| line.split(' ').next());
    Some(names.map(str::to_owned).collect())
}

/// Packages of the window.
pub const OF_THE_WINDOW: [&str; 8] = ["egui", "eframe", "epaint", "winit", "wgpu", "glow", "rfd", "open"];
/// Packages of the command line.
pub const OF_THE_COMMAND_LINE: [&str; 4] = ["clap", "ctrlc", "indicatif", "ab_glyph"];

#[track_caller]
pub fn assert_without(build: &[&str], needed: &[&str], forbidden: &[&str]) {
    let Some(packages) = packages(build) else { return };
    for name in needed {
        assert!(packages.iter().any(|package| package == name), "{build:?} lacks {name}: {packages:?}");
    }
    for name in forbidden {
        let part = format!("{name}_");
        let minus = format!("{name}-");
        let brought = packages
            .iter()
            .find(|package| *package == name || package.starts_with(&part) || package.starts_with(&minus));
        assert_eq!(brought, None, "{build:?} brings {name} along");
    }
}

#[test]
fn data_gen_builds_without_the_window() {
    assert_without(&["-p", "data-gen"], &["data-gen", "dapple", "clap"], &OF_THE_WINDOW);
}

#[test]
fn the_command_line_builds_without_the_window() {
    let build = ["-p", "dapple", "--no-default-features", "--features", "cli"];
    assert_without(&build, &["dapple", "clap"], &OF_THE_WINDOW);
}

#[test]
fn the_library_alone_contains_no_command_line_and_no_window() {
    let build = ["-p", "dapple", "--no-default-features"];
    assert_without(&build, &["dapple", "rayon"], &[&OF_THE_WINDOW[..], &OF_THE_COMMAND_LINE].concat());
}
