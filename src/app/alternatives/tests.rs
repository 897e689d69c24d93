use super::*;
use crate::attributes::Spread;
use crate::document::{Colours, SpreadChoice, Stop, Stroke, SystemChoice};
use crate::marks::{Ellipse, Line};
use crate::rd::System;
use crate::synth::Growth;
use crate::synth::Options;

fn spot(center: [f64; 2]) -> Stroke {
    Stroke::Ellipse(Ellipse { center, radii: [12.0, 9.0], angle: 20.0 })
}

fn document(strokes: Vec<Stroke>) -> Document {
    let layers = vec![Layer { name: "spots".to_owned(), strokes, ..Layer::default() }];
    Document { size: [120, 120], layers, ..Document::default() }
}

fn texture(document: &Document) -> Texture {
    let grown = Growth::begin(document, &Options::default(), None).run().unwrap();
    Texture { document: Arc::new(document.clone()), grown: Arc::new(grown) }
}

fn painted() -> Option<Colours> {
    let stop = |at, colour| Stop::opaque(at, colour);
    Some(Colours { stops: vec![stop(0.0, [9, 9, 9]), stop(1.0, [200, 9, 9])], ..Colours::new([]) })
}

#[test]
fn other_colours_are_taken_over_without_growing_anything() {
    let drawn = document(vec![spot([60.0, 60.0])]);
    let texture = texture(&drawn);
    let mut all = Alternatives::new(Arc::default());
    all.compare(&texture, 0);
    let count = all.all.len();
    let ids: Vec<u64> = all.all.iter().map(|one| one.id).collect();
    all.all[1].grown = Some(Arc::clone(&texture.grown));
    all.all[1].picture = Some(Arc::default());
    assert!(!all.all[1].is_wanted());

    let mut other = drawn;
    other.layers[0].colours = painted();
    all.compare(&Texture { document: Arc::new(other), ..texture }, 0);
    assert_eq!(all.all.iter().map(|one| one.id).collect::<Vec<_>>(), ids);
    assert_eq!(all.all.len(), count);
    assert!(all.all.iter().all(|one| one.document.layers[0].colours == painted()));
    assert!(all.all[1].is_wanted() && all.all[1].grown.is_some());
}

#[test]
fn other_marks_have_other_alternatives() {
    let mut all = Alternatives::new(Arc::default());
    all.compare(&texture(&document(vec![spot([60.0, 60.0])])), 0);
    let before: Vec<u64> = all.all.iter().map(|one| one.id).collect();
    all.compare(&texture(&document(vec![spot([50.0, 60.0])])), 0);
    assert!(all.all.iter().all(|one| !before.contains(&one.id)));
}

#[test]
fn layers_with_seeds_of_their_own_get_others_too() {
    let mut drawn = document(vec![spot([60.0, 60.0])]);
    drawn.layers[0].seed = Some(7);
    let seeds = variants(&drawn, 0);
    let of = |name: &str| seeds.iter().find(|one| one.name == name).unwrap().document.layers[0].seed;
    assert_eq!([of("Seed 2"), of("Seed 3")], [Some(8), Some(9)]);
}

#[test]
fn stripes_have_other_seeds_alone() {
    let line = Line { from: [10.0, 60.0], to: [110.0, 60.0], width: 8.0 };
    let drawn = document(vec![Stroke::Line(line)]);
    let names: Vec<String> = variants(&drawn, 0).into_iter().map(|one| one.name).collect();
    assert_eq!(names, ["Seed 2", "Seed 3", "Seed 4", "Seed 5"]);
}

#[test]
fn marks_that_vary_have_an_alternative_without_variation() {
    let mut drawn = document(vec![spot([60.0, 60.0])]);
    let spread = Spread { area: 0.3, ..Spread::ZERO };
    drawn.layers[0].options.spread = SpreadChoice::Given(spread);
    let all = variants(&drawn, 0);
    let of = |name: &str| all.iter().find(|one| one.name == name).unwrap().document.layers[0].options.spread;
    assert_eq!(of("Uniform"), SpreadChoice::Given(Spread::ZERO));
    let SpreadChoice::Given(looser) = of("Varied") else { panic!() };
    assert!(looser.area > 0.3 && looser.angle > 0.0);
    // All alternatives can be read again.
    for one in &all {
        Document::parse(&one.document.to_json(), &one.name).unwrap();
    }
}

#[test]
fn a_layer_without_marks_is_kept() {
    let mut drawn = document(vec![spot([60.0, 60.0])]);
    drawn.layers.insert(0, Layer::default());
    drawn.layers[1].name.clear();
    let mut session = Session::open(drawn.clone(), None);
    let mut other = session.finished();
    other.seed = 5;
    other.layers[0].system = SystemChoice::Of(System::TURING_SPOTS.description());
    put(&mut session, &other);
    assert_eq!(session.finished(), other);
    assert_eq!(session.document().layers.len(), 2);
    assert!(session.document().layers[1].name.is_empty());
    session.undo();
    assert_eq!(*session.document(), drawn);
}

#[test]
fn another_document_replaces_the_sketch_as_a_whole() {
    let mut session = Session::open(document(vec![spot([60.0, 60.0])]), None);
    let other = document(vec![spot([30.0, 60.0]), spot([90.0, 60.0])]);
    put(&mut session, &other);
    assert_eq!(*session.document(), other);
}

#[test]
fn grown_textures_that_take_too_much_memory_are_dropped_starred_ones_first() {
    let drawn = document(vec![spot([60.0, 60.0])]);
    // Three of these take more than the memory of all.
    let mut large = Arc::into_inner(texture(&drawn).grown).unwrap();
    large.size = [800, 800];
    let large = Arc::new(large);
    let mut all = Alternatives::new(Arc::default());
    all.compare(&texture(&drawn), 0);
    all.all.truncate(3);
    all.all[2].kept = true;
    all.taken = Some(all.all[1].id);
    for one in &mut all.all {
        (one.grown, one.picture) = (Some(Arc::clone(&large)), Some(Arc::default()));
    }
    all.limit_memory();
    let is_grown = |all: &Alternatives| all.all.iter().map(|one| one.grown.is_some()).collect::<Vec<_>>();
    assert_eq!(is_grown(&all), [true, true, false], "the original and the open one stay");
    assert!(all.is_complete(), "its picture stays, and it is not grown before it is opened");
}
