//! The commands in the guides must be valid: the command line parses every one of them.

use super::parsed;
use std::fs;
use std::path::Path;

/// Each guide's path and text.
fn guides() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = ["docs", "examples", "training", "benches", "data-gen"].map(|name| root.join(name));
    let inside = folders.iter().filter_map(|folder| fs::read_dir(folder).ok()).flatten().flatten();
    let mut paths: Vec<_> = inside.map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "md"));
    paths.push(root.join("README.md"));
    paths.sort();
    let read = |path: &Path| fs::read_to_string(path).unwrap();
    paths.iter().map(|path| (path.display().to_string(), read(path))).collect()
}

/// The dapple commands in a guide's fenced blocks and in the first column of its tables, without shell syntax. Patterns such as
/// `[--json]` or `FILE…` are left out.
fn commands(text: &str) -> Vec<String> {
    let (mut found, mut fenced) = (Vec::new(), false);
    for line in text.lines() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        } else if fenced {
            found.push(line.trim());
        } else if let Some(cell) = line.strip_prefix("| ").and_then(|row| row.split(" | ").next()) {
            found.extend(cell.split('`').skip(1).step_by(2));
        }
    }
    let ours = |line: &str| {
        let line = line.split(['#', '|', ';', '>', '&']).next().unwrap_or_default().trim();
        let rest = line.strip_prefix("cargo run --release -- ").or_else(|| line.strip_prefix("dapple "))?;
        let whole = !rest.contains(['[', '…', '(', '"', '$']);
        whole.then(|| rest.to_owned())
    };
    found.into_iter().filter_map(ours).collect()
}

#[test]
fn every_command_in_the_guides_is_valid() {
    let mut tried = 0;
    for (guide, text) in guides() {
        for command in commands(&text) {
            // The name of a command alone is not an example of its use.
            if !command.contains(' ') {
                continue;
            }
            let words = std::iter::once("dapple").chain(command.split_whitespace());
            if let Err(error) = parsed(words.map(Into::into).collect()) {
                assert_eq!(error.exit_code(), 0, "{guide}: dapple {command}\n{error}");
            }
            tried += 1;
        }
    }
    assert!(tried > 10, "only {tried} commands were found");
}
