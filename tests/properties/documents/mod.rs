//! Random documents with every kind of layer, system and option, both like those of users and with arbitrary values.
//!
//! Most are [`usual`](usual_document): the system is chosen first, and marks, options and what lies beneath suit it, in
//! proportion to the canvas. A few hold [anything](any_layer), of any size, whether or not it fits together.

mod marks;
mod options;
mod points;

use crate::{cases, on_large_stack};
use dapple_engine::attributes::system::Family;
use dapple_engine::document::layer_rules::{self, Beneath, Combination};
use dapple_engine::document::limits::MAX_REGIONS;
use dapple_engine::document::{
    After, AreaKind, Document, Edges, Growth, Kind, Layer, LayerOptions, LinkError, PairKind, Stroke,
    SystemChoice,
};
use dapple_engine::marks::Mark;
use marks::{Sizes, crossing_lines, strokes};
use options::{colours, maps, options, wild_maps, wild_options};
use points::{points, wild_points};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

/// One out of this number of documents is an arbitrary one.
const ANY: u32 = 16;
/// The least side of the canvases of arbitrary documents, px.
const LEAST: u32 = 8;

/// The parts of a layer apart from its system, its `after` and its marks.
fn rest(size: [u32; 2], sizes: Sizes) -> impl Strategy<Value = Layer> {
    let side = f64::from(size[0].min(size[1]));
    let usual = (0.03 * side).max(2.0)..(0.09 * side).max(4.0);
    let points = match sizes {
        Sizes::Any => points(4.0..30.0).boxed(),
        Sizes::Wild => wild_points(usual).boxed(),
        Sizes::Usual | Sizes::Small => points(usual).boxed(),
    };
    let (options, maps) =
        if sizes == Sizes::Wild { (wild_options(), wild_maps()) } else { (options(), maps()) };
    let options = prop_oneof![2 => Just(LayerOptions::default()), 3 => options];
    let chosen = ("\\PC{0,12}", any::<bool>(), any::<Option<u64>>());
    (chosen, prop::option::of(points), options, maps, prop::option::of(colours())).prop_map(
        |((name, visible, seed), points, options, maps, colours)| {
            let far_spacing = seed.map(|seed| 0.01 + (seed % 100_000) as f64);
            Layer { name, visible, seed, far_spacing, options, points, maps, colours, ..Layer::default() }
        },
    )
}

fn kind() -> impl Strategy<Value = Kind> {
    prop::sample::select(vec![Kind::Ellipse, Kind::Line])
}

/// A layer with any marks, system and `after`. Settings that the reader refuses are reset to their defaults.
fn any_layer(size: [u32; 2]) -> impl Strategy<Value = Layer> {
    kind().prop_flat_map(move |kind| {
        let system = prop::sample::select(all_systems());
        let of_kind: &[After] = match kind {
            Kind::Ellipse => &[After::Between, After::Inside],
            Kind::Line => &[After::Between, After::Around, After::Net],
        };
        let after = prop_oneof![
            5 => prop::sample::select(of_kind),
            1 => prop::sample::select(After::NAMES.map(|(_, after)| after).to_vec()),
        ];
        (system, after, strokes(size, kind, Sizes::Any), rest(size, Sizes::Any)).prop_map(
            move |(system, after, strokes, rest)| {
                let mut layer = Layer { system, after, strokes, ..rest };
                layer_rules::tidy(&mut layer, Some(kind));
                layer
            },
        )
    })
}

/// Every choice of a system.
fn all_systems() -> Vec<SystemChoice> {
    SystemChoice::names().into_iter().map(|(_, system)| system).collect()
}

/// The systems that a layer with this kind of marks may ask for.
fn systems(after: After, marks: Kind, is_lowest: bool) -> Vec<SystemChoice> {
    let layer = Layer { after, ..Layer::default() };
    let beneath = if is_lowest { Beneath::Nothing } else { Beneath::Grows(Kind::Ellipse) };
    let combination = Combination::new(&layer, Some(marks), beneath);
    let all = all_systems().into_iter();
    all.filter(|system| combination.against_system(*system).is_none()).collect()
}

/// Marks that this system grows.
fn suited_strokes(
    size: [u32; 2],
    system: SystemChoice,
    kind: Kind,
    sizes: Sizes,
) -> BoxedStrategy<Vec<Stroke>> {
    let usual = strokes(size, kind, sizes);
    match (system.pairs(), system.areas(), system.kind()) {
        // Threads of at least two directions.
        (Some(PairKind::Weave | PairKind::Maze), ..) => crossing_lines(size, sizes).boxed(),
        (_, Some(AreaKind::Polygons), _) => {
            let lines = prop_oneof![3 => Just(Vec::new()), 1 => strokes(size, Kind::Line, sizes)];
            (usual, lines).prop_map(|(cells, lines)| [cells, lines].concat()).boxed()
        }
        // No marks have to be drawn.
        (.., Some(Family::Points | Family::Growth)) => prop_oneof![1 => Just(Vec::new()), 2 => usual].boxed(),
        _ => usual,
    }
}

/// A layer with this system, and settings that it allows.
fn suited_layer(
    size: [u32; 2],
    after: After,
    system: SystemChoice,
    kind: Kind,
    sizes: Sizes,
) -> impl Strategy<Value = Layer> {
    (suited_strokes(size, system, kind, sizes), rest(size, sizes)).prop_map(move |(strokes, rest)| {
        let mut layer = Layer { system, after, strokes, ..rest };
        layer_rules::tidy(&mut layer, Some(kind));
        layer
    })
}

/// The lowest layer, with any system. If there is a layer above, half of these layers are spots.
fn lowest_layer(size: [u32; 2], is_covered: bool, sizes: Sizes) -> impl Strategy<Value = Layer> {
    let system = prop::sample::select(all_systems());
    let any = (system, kind()).prop_map(|(system, kind)| (system, system.grows().unwrap_or(kind)));
    let mut spots = systems(After::Between, Kind::Ellipse, true);
    spots.retain(|system| *system == SystemChoice::Auto || system.system().is_some());
    let spots = prop::sample::select(spots).prop_map(|system| (system, Kind::Ellipse));
    prop_oneof![1 => any, u32::from(is_covered) => spots]
        .prop_flat_map(move |(system, kind)| suited_layer(size, After::Between, system, kind, sizes))
}

/// A layer above another.
fn upper_layer(size: [u32; 2], sizes: Sizes) -> impl Strategy<Value = Layer> {
    let after = prop_oneof![
        3 => Just(After::Between),
        2 => prop::sample::select(After::NAMES.map(|(_, after)| after).to_vec()),
    ];
    (after, kind()).prop_flat_map(move |(after, kind)| {
        let kind = after.grows().unwrap_or(kind);
        prop::sample::select(systems(after, kind, false))
            .prop_flat_map(move |system| suited_layer(size, after, system, kind, sizes))
    })
}

/// What lies beneath layer `index`.
fn beneath(document: &Document, index: usize) -> Beneath {
    let Some(below) = index.checked_sub(1) else { return Beneath::Nothing };
    let layer = &document.layers[below];
    if layer.is_driven() {
        Beneath::Tone
    } else if layer.is_of_points() {
        Beneath::Areas
    } else if document.pairs(below).is_some() {
        Beneath::Pairs
    } else {
        let grows = Combination::new(layer, marks_of(layer), Beneath::Unknown).grows();
        grows.map_or(Beneath::Unknown, Beneath::Grows)
    }
}

/// The kind of the marks of a layer, with freehand strokes fitted.
fn marks_of(layer: &Layer) -> Option<Kind> {
    let marks = layer.strokes.iter().filter_map(Stroke::mark);
    Kind::of_layer(marks.map(|mark: Mark| Kind::from(&mark)))
}

/// Resets settings that are not allowed with the layers beneath to their defaults.
fn fitted(mut document: Document) -> Document {
    for index in 0..document.layers.len() {
        let (beneath, marks) = (beneath(&document, index), marks_of(&document.layers[index]));
        let layer = &mut document.layers[index];
        if Combination::new(layer, marks, beneath).against_after(layer.after).is_some() {
            layer.after = After::Between;
        }
        if Combination::new(layer, marks, beneath).against_system(layer.system).is_some() {
            layer.system = SystemChoice::Auto;
        }
        if !layer.system.takes_lines_beside() {
            // A freehand stroke can be fitted by another kind of mark than the one from which it was made.
            layer.strokes.retain(|stroke| stroke.mark().as_ref().map(Kind::from) == marks);
        }
        layer_rules::tidy(layer, marks);
    }
    document
}

/// Sets the relations of layers: the lowest has none beneath it, and those above scattered points grow between them.
fn with_relations(mut layers: Vec<Layer>) -> Vec<Layer> {
    for index in 0..layers.len() {
        if index == 0 || layers[index - 1].is_of_points() {
            layers[index].after = After::Between;
        }
    }
    layers
}

/// A canvas of this size, with these layers.
fn canvas(size: [u32; 2], layers: impl Strategy<Value = Vec<Layer>>) -> impl Strategy<Value = Document> {
    let regions = prop::option::of((1..=3_u32, 1..=3_u32).prop_map(<[u32; 2]>::from));
    let edges = prop::sample::select(vec![Edges::Closed, Edges::Wrap]);
    let chosen = ("\\PC{0,12}", regions, edges, any::<u64>(), any::<bool>());
    (chosen, layers).prop_map(move |((name, regions, edges, seed, refine), layers)| {
        let growth = Growth { refine };
        Document { name, size, regions, edges, seed, growth, layers, ..Document::default() }
    })
}

/// Random sides in this range, small ones more often: from 50 to 100 px as often as from 100 to 200.
fn sides([low, high]: [u32; 2]) -> impl Strategy<Value = [u32; 2]> {
    let [low, high] = [low, high].map(f64::from);
    let side = move || (0.0..=1.0_f64).prop_map(move |share| (low * (high / low).powf(share)).round() as u32);
    (side(), side()).prop_map(<[u32; 2]>::from)
}

/// A document whose parts suit each other.
fn usual_document(range: [u32; 2], layers: usize) -> impl Strategy<Value = Document> {
    let document = (sides(range), 1..=layers).prop_flat_map(|(size, count)| {
        let upper = prop::collection::vec(upper_layer(size, Sizes::Small), count - 1);
        let layers = (lowest_layer(size, count > 1, Sizes::Usual), upper);
        canvas(size, layers.prop_map(|(lowest, upper)| [vec![lowest], upper].concat()))
    });
    document.prop_map(fitted)
}

/// A document whose parts suit each other, with numbers from the whole allowed range, on a canvas of up to `most` px.
pub fn wild_document(most: u32, layers: usize) -> impl Strategy<Value = Document> {
    let document = (sides([1, most]), 1..=layers).prop_flat_map(|(size, count)| {
        let upper = prop::collection::vec(upper_layer(size, Sizes::Wild), count - 1);
        let layers = (lowest_layer(size, count > 1, Sizes::Wild), upper);
        let layers = layers.prop_map(|(lowest, upper)| [vec![lowest], upper].concat());
        let most = size.map(|side| side.min(MAX_REGIONS));
        let regions = (1..=most[0], 1..=most[1]).prop_map(<[u32; 2]>::from);
        (canvas(size, layers), prop::option::weighted(0.1, regions))
    });
    document.prop_map(|(document, regions)| {
        let few = document.regions.map(|few| [0, 1].map(|axis| few[axis].min(document.size[axis])));
        let mut document = Document { regions: regions.or(few), ..document };
        document.layers.iter_mut().for_each(|layer| layer.far_spacing = None);
        fitted(document)
    })
}

/// An arbitrary document.
fn any_document_of([_, high]: [u32; 2], layers: usize) -> impl Strategy<Value = Document> {
    let size = (LEAST..=high, LEAST..=high).prop_map(<[u32; 2]>::from);
    size.prop_flat_map(move |size| {
        let layers = (prop::collection::vec(any_layer(size), 1..=layers), prop::bool::weighted(0.9));
        let layers = layers.prop_map(|(layers, usual)| if usual { with_relations(layers) } else { layers });
        canvas(size, layers)
    })
}

/// A document on a canvas with sides in this range, with at most this number of layers; not every one is valid.
pub fn any_document(sides: [u32; 2], layers: usize) -> impl Strategy<Value = Document> {
    prop_oneof![
        ANY - 1 => usual_document(sides, layers),
        1 => any_document_of(sides, layers),
    ]
}

/// A valid document.
pub fn document(sides: [u32; 2], layers: usize) -> impl Strategy<Value = Document> {
    any_document(sides, layers).prop_filter("is valid", |document| document.check("x").is_ok())
}

#[test]
fn a_document_of_any_layers_and_options_is_read_as_it_was_written() {
    on_large_stack(|| {
        let outcome = TestRunner::new(cases(200)).run(&document([8, 2_000], 3), |document| {
            let text = document.to_json();
            let read = Document::parse(&text, "x").unwrap();
            prop_assert_eq!(&read, &document);
            prop_assert_eq!(read.to_json(), text);
            match document.fragment() {
                Ok(fragment) => prop_assert_eq!(Document::from_link(&fragment).unwrap(), document),
                Err(error) => prop_assert!(!matches!(error, LinkError::Document(_)), "{}", error),
            }
            Ok(())
        });
        outcome.unwrap_or_else(|error| panic!("{error}"));
    });
}
