//! The memory of a process does not grow with the number of documents.
//!
//! `DAPPLE_LOAD` is the number of documents (default 60).

use std::io::{BufRead, BufReader};
use std::process::Stdio;

use crate::bench::{Bench, say};

/// The growth of memory that is allowed, MB: allocators keep freed memory.
const SLACK: f64 = 12.0;

/// Resident memory of a process, MB.
fn memory(process: u32) -> Option<f64> {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS:"))?;
    line.split_whitespace().nth(1)?.parse::<f64>().ok().map(|kilobytes| kilobytes / 1024.0)
}

/// Documents of all systems, kinds of layer and edges, 64 to 128 px wide.
fn document(index: usize) -> String {
    let size = 64 + 16 * (index % 5);
    let edges = ["closed", "wrap"][index / 2 % 2];
    let angle = 17 * index % 180;
    let spots = |system: &str, [long, short]: [f64; 2]| {
        format!(
            r#"{{"system": "{system}", "strokes": [
                {{"kind": "ellipse", "center": [16, 16], "radii": [{long}, {short}], "angle": {angle}}},
                {{"kind": "ellipse", "center": [48, 30], "radii": [{long}, {short}], "angle": {angle}}}]}}"#
        )
    };
    let line = |system: &str, after: &str| {
        format!(
            r#"{{"system": "{system}", "after": "{after}", "strokes": [
                {{"kind": "line", "from": [10, 10], "to": [50, 40], "width": 3}}]}}"#
        )
    };
    let layers = match index % 6 {
        0 => spots("auto", [7.0, 5.0]),
        1 => line("meinhardt-stripes", "between"),
        2 => spots("turing-spots", [7.0, 5.0]),
        3 => [spots("meinhardt-spots", [6.0, 5.0]), line("auto", "around")].join(", "),
        4 => [spots("auto", [6.0, 5.0]), line("auto", "net")].join(", "),
        _ => [spots("auto", [7.0, 5.0]), spots("auto", [3.0, 2.5])].join(", "),
    };
    format!(
        r#"{{"format": "dapple", "version": 1, "size": [{size}, {size}], "edges": "{edges}", "seed": {index},
            "layers": [{layers}]}}"#
    )
}

#[cfg(target_os = "linux")]
#[test]
fn many_documents_in_one_batch_take_no_more_memory_than_few() {
    let many: usize = std::env::var("DAPPLE_LOAD").ok().and_then(|text| text.parse().ok()).unwrap_or(60);
    let bench = Bench::new();
    let mut command = bench.command("grow -o out");
    for index in 0..many {
        let name = format!("d{index}.dapple");
        bench.write(&name, &document(index));
        command.arg(name);
    }
    let mut child = command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().unwrap();
    // Many documents have notes, which are printed one after the other while the documents grow.
    let mut samples = Vec::new();
    let mut said = Vec::new();
    for line in BufReader::new(child.stderr.take().unwrap()).lines().map_while(Result::ok) {
        samples.extend(memory(child.id()));
        said.push(line);
    }
    // Documents that are refused because there is no room between their marks count too.
    assert!(matches!(child.wait().unwrap().code(), Some(0 | 1)), "{}", said.join("\n"));
    let grown = std::fs::read_dir(bench.path("out")).unwrap().count();
    assert!(samples.len() > many / 2 && grown > 2 * many / 3, "{grown} of {many}: {}", said.join("\n"));
    let most = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    let parts: Vec<f64> = samples.chunks(samples.len().div_ceil(10)).map(most).collect();
    let output: Vec<String> = parts.iter().map(|part| format!("{part:.0}")).collect();
    // Written directly to stderr, because docs/faults.md reports this number.
    say(&format!("{many} documents, {grown} grown: MB at most in each tenth: {}", output.join(" ")));
    let third = samples.len() / 3;
    let (first, last) = (most(&samples[..third]), most(&samples[2 * third..]));
    assert!(last <= first + SLACK, "it grew from {first:.1} to {last:.1} MB: {output:?}");
}

/// Grows repeatedly in one process, like the window.
#[cfg(target_os = "linux")]
#[ignore = "other tests of this process would be measured too: .ci/faults runs it alone"]
#[test]
fn repeated_growth_takes_no_more_memory() {
    use dapple::document::Document;
    use dapple_engine::synth::Growth;
    use dapple_engine::synth::Options;
    let (mut samples, mut grown) = (Vec::new(), 0);
    for index in 0..300 {
        let document = Document::parse(&document(index), "document").unwrap();
        // Some have no room for their second layer.
        grown += usize::from(Growth::begin(&document, &Options::default(), None).run().is_ok());
        samples.extend(memory(std::process::id()));
    }
    assert!(samples.len() == 300 && grown > 200, "{grown} of 300 have grown");
    let most = |part: &[f64]| part.iter().copied().fold(0.0, f64::max);
    let (first, last) = (most(&samples[..100]), most(&samples[200..]));
    say(&format!("300 growths in one process: {first:.0} MB at first, {last:.0} MB at last"));
    assert!(last <= first + SLACK, "it grew from {first:.1} to {last:.1} MB");
}
