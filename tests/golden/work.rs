//! What work is to be expected of a growth, against what it took: in cell updates, which are the same on any machine.

use crate::renew::golden;
use crate::textures::{document, names};
use dapple::document::Document;
use dapple::internals::synth::grow;
use dapple::internals::synth::plan::Targets;
use dapple::internals::synth::{Engine, Options, Training};

fn expected(document: &Document, name: &str) -> Vec<f64> {
    let mut beneath = None;
    let mut all = Vec::new();
    for index in 0..document.layers.len() {
        let size = document.size.map(f64::from);
        let targets = Targets::read(document, index, name, size, beneath.as_ref()).unwrap();
        let plan = targets.look_up(Training::built_in()).unwrap().rough(Vec::new());
        let engine = Engine::new(&plan, document.layer_seed(index));
        all.push(engine.updates_left());
        beneath = Some(plan.lookup);
    }
    all
}

fn took(document: &Document, name: &str) -> Vec<f64> {
    let options = Options { refine: Some(false), source: name, ..Options::default() };
    let grown = grow(document, &options).unwrap();
    grown
        .layers
        .iter()
        .map(|layer| layer.steps as f64 * (layer.plan.lookup.grid[0] * layer.plan.lookup.grid[1]) as f64)
        .collect()
}

/// `cargo test --test golden -- --ignored --nocapture work`: the ground of the shares in `src/synth/estimate.rs`.
#[test]
#[ignore = "tells how shares were found; takes minutes"]
fn updates_that_were_expected_and_taken_are_told() {
    let mut all: Vec<(String, Document)> =
        names().into_iter().map(|name| (name.clone(), document(&name))).collect();
    for name in
        ["zebra", "cheetah-run", "fallow-deer", "tiger", "poppy-seeds", "starry-sky", "dart-frog", "bongo"]
    {
        let path = golden("../../examples").join(format!("{name}.dapple"));
        all.push((name.to_owned(), Document::read(path).unwrap()));
    }
    for (name, document) in all {
        let (said, took) = (expected(&document, &name), took(&document, &name));
        let pairs: Vec<String> = said
            .iter()
            .zip(&took)
            .map(|(s, t)| format!("{:.1}/{:.1} = {:.2}", s / 1e6, t / 1e6, s / t))
            .collect();
        println!("{name}: {}", pairs.join(", "));
    }
}
