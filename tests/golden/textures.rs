//! Documents for every system of [`System::ALL`], kind of edge and relation to a layer beneath, each with a picture of its
//! first steps. `kinds` has the other systems.
//!
//! `textures/NAME.dapple` is grown for a short time and painted; every px must equal that of `textures/NAME.png`. The
//! time is short because the last bit of the first step determines the final places of marks; `sheets` compares
//! attributes after long runs.
//!
//! Of the first four systems every combination has a document ([`COMPLETE`]). Of each later system those that
//! [`sample`] chooses are enough: every pair of system, kind of edge and relation to a layer beneath occurs once.

use crate::renew::{golden, kept, renew, renews};
use dapple::ReadFile;
use dapple::document::Edges;
use dapple::document::{After, Document};
use dapple_engine::rd::System;
use dapple_engine::synth::render::painting::Painting;
use dapple_engine::synth::{Growth, Options, Progress};
use std::collections::BTreeSet;
use std::io::Cursor;

/// Normalised time for which the top layer grows; spots settle after 15 to 20, stripes after 30.
const TIME: f64 = 2.0;

/// Systems for which every combination has a document. Other systems are sampled.
const COMPLETE: [&str; 4] = ["turing-spots", "meinhardt-spots", "meinhardt-stripes", "meinhardt-lines"];

/// Documents in addition to the combinations: several regions, marks that differ.
const MORE: [&str; 2] = ["regions-spots", "regions-stripes"];

/// Whether such a layer exists; `None` = a layer with nothing beneath it. A new `after` must be added here.
fn exists(after: Option<After>, system: System) -> bool {
    let system = system.description();
    match after {
        None | Some(After::Between | After::Near) => true,
        Some(After::Around | After::Net) => system.along_curves,
        Some(After::Inside) => system.fixed_places,
    }
}

/// The name of these edges in documents. A new kind must be added here, and to [`ALL_EDGES`].
fn word(edges: Edges) -> &'static str {
    match edges {
        Edges::Closed => "closed",
        Edges::Wrap => "wrap",
    }
}

const ALL_EDGES: [Edges; 2] = [Edges::Closed, Edges::Wrap];

/// A top layer.
#[derive(Clone, Copy)]
struct Case {
    after: Option<After>,
    system: System,
    edges: Edges,
}

impl Case {
    fn all() -> Vec<Self> {
        // What is near grows as what is between, and then some of its marks are removed: tests/command/grow/coat_shapes.rs.
        let named = After::NAMES.into_iter().map(|(_, after)| after).filter(|after| *after != After::Near);
        let ways = std::iter::once(None).chain(named.map(Some));
        let of_way = |after| System::ALL.into_iter().map(move |system| (after, system));
        let of_both = |(after, system)| ALL_EDGES.into_iter().map(move |edges| Self { after, system, edges });
        ways.flat_map(of_way).flat_map(of_both).collect()
    }

    fn name(&self) -> String {
        let after = self.after.map_or("alone", After::name);
        format!("{after}-{}-{}", self.system.name(), word(self.edges))
    }
}

/// The combinations that exist.
fn existing() -> Vec<Case> {
    Case::all().into_iter().filter(|case| exists(case.after, case.system)).collect()
}

/// Pairwise sampling: goes through the cases and takes each that adds a pair of (system, after), (system, edges) or
/// (after, edges) which neither those taken before nor `covered` have.
fn sample(cases: &[Case], covered: &[Case]) -> Vec<Case> {
    let mut pairs: BTreeSet<_> = covered.iter().flat_map(pairs_of).collect();
    let mut chosen = Vec::new();
    for case in cases {
        let before = pairs.len();
        pairs.extend(pairs_of(case));
        if pairs.len() > before {
            chosen.push(*case);
        }
    }
    chosen
}

fn pairs_of(case: &Case) -> [[&'static str; 2]; 3] {
    let [system, edges] = [case.system.name(), word(case.edges)];
    let after = case.after.map_or("alone", After::name);
    [[system, after], [system, edges], [after, edges]]
}

/// The combinations that have a golden document.
fn golden_cases() -> Vec<Case> {
    let (complete, later): (Vec<Case>, Vec<Case>) =
        existing().into_iter().partition(|case| COMPLETE.contains(&case.system.name()));
    let sampled = sample(&later, &complete);
    complete.into_iter().chain(sampled).collect()
}

/// The names of the golden documents.
pub fn names() -> Vec<String> {
    golden_cases().iter().map(Case::name).chain(MORE.map(str::to_owned)).collect()
}

#[test]
fn a_sample_has_every_pair_and_is_smaller_than_the_product() {
    let all = existing();
    let sample = sample(&all, &[]);
    let pairs = |cases: &[Case]| -> BTreeSet<[&str; 2]> { cases.iter().flat_map(pairs_of).collect() };
    assert_eq!(pairs(&sample), pairs(&all));
    assert!(sample.len() < all.len(), "{} of {}", sample.len(), all.len());
}

/// The golden document of this name.
pub fn document(name: &str) -> Document {
    Document::read(golden(&format!("textures/{name}.dapple"))).unwrap()
}

#[test]
fn every_trained_system_edge_and_kind_of_layer_has_its_document_picture_and_sheet() {
    let files = |name: String| ["dapple", "json", "png"].map(|ending| format!("{name}.{ending}"));
    let wanted: BTreeSet<String> = names().into_iter().flat_map(files).collect();
    let entries = std::fs::read_dir(golden("textures")).unwrap();
    let there = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    assert!(
        renews() || wanted == there,
        "without: {:?}; left over: {:?}",
        &wanted - &there,
        &there - &wanted
    );
}

#[test]
fn each_document_is_what_its_name_says() {
    for case in golden_cases() {
        let (name, document) = (case.name(), document(&case.name()));
        let top = document.layers.last().unwrap();
        assert_eq!(top.system.name(), case.system.name(), "{name}");
        assert_eq!(document.edges, case.edges, "{name}");
        assert_eq!(document.layers.len(), if case.after.is_some() { 2 } else { 1 }, "{name}");
        assert!(case.after.is_none_or(|after| top.after == after), "{name}");
    }
}

#[test]
fn a_texture_without_a_document_is_refused() {
    for case in Case::all().into_iter().filter(|case| !exists(case.after, case.system)) {
        let (name, after) = (case.name(), case.after.unwrap());
        let like = golden_cases().into_iter().find(|like| like.after == case.after);
        let mut like = document(&like.unwrap().name());
        let top = like.layers.last_mut().unwrap();
        top.system = dapple::document::SystemChoice::Of(case.system.description());
        let text = like.to_json();
        let error = match Document::parse(&text, &name) {
            Err(error) => error.to_string(),
            Ok(document) => {
                let grown =
                    Growth::begin(&document, &Options { source: &name, ..Options::default() }, None).run();
                grown.err().unwrap_or_else(|| panic!("{name} grew")).to_string()
            }
        };
        assert!(error.contains("system") && error.contains("auto"), "{name} with {}: {error}", after.name());
    }
}

/// Red, green, blue of each px after the top layer has grown for [`TIME`].
fn young(name: &str) -> ([usize; 2], Vec<u8>) {
    let document = document(name);
    let size = document.size.map(|side| side as usize);
    let options = Options { refine: Some(false), source: name, ..Options::default() };
    let mut growth = Growth::begin(&document, &options, None).filmed();
    loop {
        let budget = growth.updates_in(TIME);
        assert_ne!(growth.advance(budget).unwrap(), Progress::Done, "{name} was not seen");
        let look = growth.snapshot().filter(|look| look.beneath.len() + 1 == document.layers.len());
        if let Some(look) = look {
            return (size, Painting::growing(&document, &look, size).rgb());
        }
    }
}

fn png([width, height]: [usize; 2], rgb: &[u8]) -> Vec<u8> {
    let picture = image::RgbImage::from_raw(width as u32, height as u32, rgb.to_vec()).unwrap();
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, image::ImageFormat::Png).unwrap();
    bytes.into_inner()
}

/// The number of px that differ, and the largest difference; `None` if none differ.
fn differ(stored: Option<&image::RgbImage>, [width, height]: [usize; 2], rgb: &[u8]) -> Option<String> {
    let Some(stored) = stored else { return Some("is new".to_owned()) };
    if stored.dimensions() != (width as u32, height as u32) {
        return Some(format!("{:?} px have become {width} × {height}", stored.dimensions()));
    }
    let pairs = stored.as_raw().chunks_exact(3).zip(rgb.chunks_exact(3));
    let off = pairs.map(|(a, b)| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0));
    let off: Vec<u8> = off.filter(|off| *off > 0).collect();
    let most = off.iter().max()?;
    Some(format!("{} of {} px differ, by {most} of 255 at most", off.len(), width * height))
}

/// Compares a picture with `FOLDER/NAME.png`, or renews that file; returns the difference.
pub fn compare_picture(folder: &str, name: &str, size: [usize; 2], rgb: &[u8]) -> Option<String> {
    let file = format!("{folder}/{name}.png");
    let stored = image::open(golden(&file)).ok().map(|picture| picture.to_rgb8());
    let what = differ(stored.as_ref(), size, rgb)?;
    if renews() {
        renew(&file, &png(size, rgb), &what);
        return None;
    }
    let grown = kept(&format!("{name}.png"), &png(size, rgb));
    Some(format!("tests/golden/{file}: {what}; {grown} has what grew"))
}

/// Grows each document for a short time; returns the differences.
fn compare(names: &[String]) -> Vec<String> {
    let compared = names.iter().filter_map(|name| {
        let (size, rgb) = young(name);
        compare_picture("textures", name, size, &rgb)
    });
    compared.collect()
}

#[test]
fn young_textures_have_the_stored_px() {
    let wrong = compare(&names());
    assert!(wrong.is_empty(), "{}\nIf that is meant: REGENERATE=1", wrong.join("\n"));
}
