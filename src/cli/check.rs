//! `dapple check`: checks a document and lists its content.

mod areas;
mod maps;
mod point_fields;
mod point_lines;
mod tone;

use super::Error;
use crate::attributes::free::FreeMap;
use crate::attributes::{Attributes, Polarity, Spread, Stripes};
use crate::document::sketch_notes::notes_on;
use crate::document::{Document, Layer, Stroke};
use crate::files::ReadFile;
use crate::grid::Edges;
use crate::learn::Answer;
use crate::machine::free_memory;
use crate::synth::plan::layer_lookup::Start;
use crate::synth::plan::pairs::PairPlan;
use crate::synth::plan::raggedness::asked_raggedness;
use crate::synth::plan::{Lookup, Surroundings, Targets};
use crate::synth::report::drawn::expected_note;
use crate::synth::{Training, memory};
use serde_json::{Map, Value, json};
use std::fmt::Write;
use std::path::PathBuf;

/// Arguments of `dapple check`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The document
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    /// Print it as JSON
    #[arg(long)]
    pub json: bool,
}

/// Reads a document and prints its content, the planned growth, and attributes that cannot be reached.
///
/// # Errors
/// The document is invalid, or a training set cannot be read.
pub fn run(args: &Args) -> Result<(), Error> {
    let document = Document::read(&args.file)?;
    let source = args.file.display().to_string();
    let mut text = format!("{source}: valid\n{}", summary(&document));
    let notes = notes_on(&document);
    let training = Training::default();
    let mut beneath: Option<Lookup> = None;
    let mut layers = Vec::new();
    let size = document.size.map(f64::from);
    for (index, layer) in document.layers.iter().enumerate() {
        if let Some((reach, found)) = special(&document, index, &source, &training)? {
            text += &(reach + &maps::lines(layer));
            layers.push(maps::with_maps(found, layer));
            beneath = None;
            continue;
        }
        if let Some(kind) = document.pairs(index) {
            let rows = training.pairs(kind.description()).map_err(Error::step)?;
            let plan = PairPlan::read(&document, index, &source, size, rows)?;
            text += &(reach_of_pairs(&plan, index) + &maps::lines(layer));
            let too_large =
                memory::check_pairs(plan.threads.len(), size, plan.grid.size, Some(free_memory())).err();
            let too_large = too_large.map(|error| format!("cannot be grown on this machine: {error}"));
            let notes: Vec<String> = too_large.into_iter().chain(plan.notes.iter().cloned()).collect();
            for note in &notes {
                // Writing to a String cannot fail.
                let _ = writeln!(text, "  {note}");
            }
            layers.push(maps::with_maps(pairs_json(layer, &plan, &notes), layer));
            beneath = None;
            continue;
        }
        let targets = Targets::read(&document, index, &source, size, beneath.as_ref())?;
        let plan = targets.look_up(&training).map_err(|error| Error::grown(error.into()))?;
        text += &(reach(&plan, index) + &maps::lines(layer));
        let notes = notes_of(&plan, beneath.as_ref(), layer, size);
        for note in &notes {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "  {note}");
        }
        if args.json {
            layers.push(maps::with_maps(layer_json(layer, &plan, &notes), layer));
        }
        beneath = Some(plan);
    }
    for note in &notes {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{note}");
    }
    if args.json {
        let edges = if document.edges == Edges::Wrap { "wrap" } else { "closed" };
        let mut found = json!({"document": source, "valid": true, "name": document.name, "size": document.size,
            "regions": document.regions, "edges": edges, "seed": document.seed, "layers": layers, "sketch": notes});
        if let (None, Some(found)) = (document.regions, found.as_object_mut()) {
            found.remove("regions");
        }
        text = format!("{found:#}\n");
    }
    super::print(&text)
}

/// What the user should know of the growth planned for a layer, above the one `beneath`, on a canvas of `size` px.
fn notes_of(plan: &Lookup, beneath: Option<&Lookup>, layer: &Layer, size: [f64; 2]) -> Vec<String> {
    let too_large = memory::check(plan.system, size, plan.grid.size, Some(free_memory())).err();
    let mut notes: Vec<String> =
        too_large.iter().map(|error| format!("cannot be grown on this machine: {error}")).collect();
    notes.extend(beneath.and_then(|beneath| plan.expected_room(beneath)));
    // Of lines around marks, or between them, only the width counts.
    if plan.curve_kind().is_none() {
        notes.extend(plan.map.free().map(FreeMap::remarks).unwrap_or_default());
    }
    notes.extend(crowded(plan));
    notes.extend(ragged(plan, layer));
    notes
}

/// What would grow on layer `index`, for people and as JSON, if a picture drives it, or scattered points make
/// it.
fn special(
    document: &Document,
    index: usize,
    source: &str,
    training: &Training,
) -> Result<Option<(String, Value)>, Error> {
    let layer = &document.layers[index];
    match layer.is_driven() {
        true => tone::checked(document, index, source, training).map(Some),
        false if layer.areas().is_some() => areas::checked(document, index, source, training).map(Some),
        false => match layer.point_lines() {
            Some(kind) => point_lines::checked(document, index, kind, source).map(Some),
            None => match layer.point_field() {
                Some(points) => point_fields::checked(document, index, points, source).map(Some),
                None => Ok(None),
            },
        },
    }
}

/// How ragged edges will be, where they are to be roughened.
fn ragged(plan: &Lookup, layer: &Layer) -> Option<String> {
    let raggedness = asked_raggedness(&plan.map, &layer.options)?;
    Some(format!("its edges will be roughened to a raggedness of {raggedness:.2}"))
}

/// The drawn spots that are too near to others of their layer.
fn crowded(plan: &Lookup) -> Option<String> {
    let Start::Free { spots, .. } = &plan.start else { return None };
    if spots.is_empty() {
        return None;
    }
    let alone = plan.clone().uncorrected().lay_out(Surroundings::default(), 0).ok()?;
    expected_note(&alone)
}

/// What would be grown on a layer, and for each region that has marks what was asked and what is expected.
fn layer_json(layer: &Layer, plan: &Lookup, notes: &[String]) -> Value {
    let layout = plan.map.layout();
    let raggedness = asked_raggedness(&plan.map, &layer.options);
    let region = |(index, answer): (usize, &Answer)| {
        let place = layout.place(index);
        let of_region = plan.map.region(place);
        let (marks, spread) = (of_region.marks, &of_region.spread);
        let notes = answer.notes.iter().map(ToString::to_string).chain(plan.remarks[index].iter().cloned());
        (marks > 0).then(|| {
            let mut region = json!({"region": place, "marks": marks, "asked": asked(plan, place),
                "spread": spread, "predicted": answer.predicted, "coverage": answer.coverage.to_string(),
                "notes": notes.collect::<Vec<_>>()});
            if let Some(raggedness) = raggedness {
                region["raggedness"] = json!(raggedness);
            }
            region
        })
    };
    let regions: Vec<Value> = plan.answers.iter().enumerate().filter_map(region).collect();
    json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible,
        "drawn": drawn(layer), "system": plan.system.name(), "inverted": plan.polarity == Polarity::Negative, "cell": plan.px_a_cell(),
        "grid": plan.grid.size, "regions": regions, "notes": notes})
}

/// What is asked of a region as a whole.
fn asked(plan: &Lookup, place: [usize; 2]) -> Attributes {
    if plan.map.is_modulated() {
        plan.map.of_region(place)
    } else {
        plan.map.at(plan.map.layout().center(place))
    }
}

/// How many strokes of each kind were drawn.
fn drawn(layer: &Layer) -> Map<String, Value> {
    counts(layer).into_iter().map(|(name, n)| (name.replace(' ', "_"), json!(n))).collect()
}

/// What pairs would grow on a layer, and what was asked of each direction.
fn pairs_json(layer: &Layer, plan: &PairPlan, notes: &[String]) -> Value {
    let threads = plan.threads.iter();
    let threads = threads.map(|threads| json!({"lines": threads.lines.len(), "asked": threads.mean()}));
    json!({"name": layer.name, "after": layer.after.name(), "visible": layer.visible, "drawn": drawn(layer),
        "system": plan.kind().description().name, "cell": plan.px_a_cell(), "grid": plan.grid.size,
        "threads": threads.collect::<Vec<_>>(), "notes": notes})
}

/// What pairs would grow, and what was asked of each direction.
fn reach_of_pairs(plan: &PairPlan, index: usize) -> String {
    let [nx, ny] = plan.grid.size;
    let name = plan.kind().description().name;
    let mut text =
        format!("layer {}: grown by {name} on {nx} × {ny} cells of {:.2} px\n", index + 1, plan.px_a_cell());
    for threads in &plan.threads {
        let Stripes { width, angle, wavelength } = threads.mean();
        let apart = wavelength.unwrap_or_default();
        let lines = threads.lines.len();
        let plural = if lines == 1 { "" } else { "s" };
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "  threads {width:.1} px wide at {angle:.0}°, {apart:.1} px apart, by {lines} line{plural}"
        );
    }
    text
}

/// What would be grown, and for each region what was asked and what cannot be met.
fn reach(plan: &Lookup, index: usize) -> String {
    let layout = plan.map.layout();
    let [nx, ny] = plan.grid.size;
    let mut text = format!(
        "layer {}: {}grown by {} on {nx} × {ny} cells of {:.2} px\n",
        index + 1,
        if plan.polarity == Polarity::Negative { "gaps between its stripes " } else { "" },
        plan.system.name(),
        plan.px_a_cell()
    );
    let mut empty = 0;
    for (region, answer) in plan.answers.iter().enumerate() {
        let [column, row] = layout.place(region);
        if plan.map.region([column, row]).marks == 0 {
            empty += 1;
            continue;
        }
        let wanted = asked(plan, [column, row]);
        // Writing to a String cannot fail.
        let varied = varied(&plan.map.region([column, row]).spread);
        let _ = writeln!(
            text,
            "  region [{column}, {row}]: {}{varied}; {}",
            described(&wanted, plan.curve_kind().is_some()),
            answer.coverage
        );
        for note in &answer.notes {
            let _ = writeln!(text, "    {note}");
        }
        for remark in &plan.remarks[region] {
            let _ = writeln!(text, "    {remark}");
        }
    }
    if empty > 0 {
        let _ = writeln!(text, "  regions without marks, which take their nearest neighbour's: {empty}");
    }
    text
}

fn described(wanted: &Attributes, bent: bool) -> String {
    match wanted {
        Attributes::Spots(spots) => {
            let spacing = spots.spacing.map(|spacing| format!(", {spacing:.1} px apart")).unwrap_or_default();
            format!(
                "spots of {:.0} px², aspect {:.2} at {:.0}°{spacing}",
                spots.area, spots.aspect, spots.angle
            )
        }
        Attributes::Stripes(stripes) if bent => format!("lines {:.1} px wide", stripes.width),
        Attributes::Stripes(stripes) => {
            let apart = stripes.wavelength.map(|apart| format!(", {apart:.1} px apart")).unwrap_or_default();
            format!("stripes {:.1} px wide at {:.0}°{apart}", stripes.width, stripes.angle)
        }
    }
}

/// Such as `, varied: area by 0.12, angle by 8°`; empty if all marks are alike.
fn varied(spread: &Spread) -> String {
    let part = |(name, value): (&str, f64)| match name {
        "angle" => (value >= 0.05).then(|| format!("angle by {value:.1}°")),
        _ => (value >= 0.0005).then(|| format!("{name} by {value:.3}")),
    };
    let parts: Vec<String> = spread.named().into_iter().filter_map(part).collect();
    if parts.is_empty() { String::new() } else { format!(", varied: {}", parts.join(", ")) }
}

fn summary(document: &Document) -> String {
    let mut text = String::new();
    let [width, height] = document.size;
    let edges = if document.edges == Edges::Wrap { "wrap" } else { "closed" };
    // Writing to a String cannot fail.
    let _ = writeln!(text, "name:    {}", printable(&document.name));
    let _ = writeln!(text, "size:    {width} × {height} px, edges {edges}");
    let _ = match document.regions {
        Some([columns, rows]) => writeln!(text, "regions: {columns} × {rows}"),
        None => writeln!(text, "regions: none, each mark says what is wanted around it"),
    };
    let _ = writeln!(text, "layers:  {}", document.layers.len());
    for (i, layer) in document.layers.iter().enumerate() {
        let name = printable(&layer.name);
        let hidden = if layer.visible { "" } else { ", hidden" };
        let (system, after) = (layer.system.name(), layer.after.name());
        let _ = writeln!(text, "  {}. {name}: {} ({system}, {after}{hidden})", i + 1, marks(layer));
    }
    text
}

/// Such as `12 ellipses, 1 freehand stroke`.
fn marks(layer: &Layer) -> String {
    let counted =
        counts(layer).into_iter().map(|(name, n)| format!("{n} {name}{}", if n == 1 { "" } else { "s" }));
    let drawn = counted.collect::<Vec<_>>().join(", ");
    if drawn.is_empty() { "nothing drawn".to_owned() } else { drawn }
}

/// The number of drawn strokes of each kind, without kinds that do not occur.
fn counts(layer: &Layer) -> Vec<(&'static str, usize)> {
    let name = |stroke: &Stroke| match stroke {
        Stroke::Ellipse(_) => "ellipse",
        Stroke::Line(_) => "line",
        Stroke::Path(_) => "path",
        Stroke::Freehand { .. } => "freehand stroke",
        Stroke::Outline(_) => "outline",
    };
    let count = |kind| layer.strokes.iter().filter(|stroke| name(stroke) == kind).count();
    let names = ["ellipse", "line", "path", "freehand stroke", "outline"];
    names.into_iter().map(|kind| (kind, count(kind))).filter(|(_, n)| *n > 0).collect()
}

/// A name with control characters replaced.
fn printable(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { '�' } else { c }).collect()
}
