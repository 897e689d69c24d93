//! Maps that vary colours and marks on small bodies.

use crate::document::{Body, BodySource, Colours, Document, LayerMap, MapKey, MapSource, ToneImage};
use crate::synth::Options;
use crate::synth::body::BodyGrowth;
use crate::synth::body::coat::Coat;
use crate::synth::body::kinds_tests::{grown, on, spots};

/// A flat plate in the plane of x and y, 2 × 1, whose texture covers it once.
const PLATE: &str =
    "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

fn picture(key: MapKey, range: [f64; 2]) -> (MapKey, LayerMap) {
    // Black on the left, white on the right.
    let image = ToneImage::new([2, 1], vec![0, 255]).expect("two px");
    (key, LayerMap { source: MapSource::Image { image, factor: true }, range })
}

fn on_plate(key: MapKey, range: [f64; 2]) -> Document {
    let (key, map) = picture(key, range);
    let source = BodySource::File { path: "plate.obj".to_owned(), sha256: None };
    let document = on("sphere", 300.0, vec![spots(6.0, 19.0).with_map(key, map)]);
    Document { model: Some(Body { px: 300.0, ..Body::new(source) }), ..document }
}

#[test]
fn a_picture_on_the_texture_coordinates_of_a_model_varies_its_spots() {
    let document = on_plate(MapKey::Area, [0.6, 1.4]);
    let growth = BodyGrowth::begin(&document, Some(PLATE.as_bytes()), &Options::default()).expect("a model");
    let grown = growth.run().expect("it grows");
    let spots = grown.layers[0].levelled.measured.spots.iter().filter(|spot| spot.whole);
    let surface = grown.layers[0].plan.surface();
    let (mut left, mut right) = (Vec::new(), Vec::new());
    for spot in spots {
        let x = surface.position(spot.place)[0];
        // Away from the middle, where brightness changes.
        match x {
            x if x < -75.0 => left.push(spot.area),
            x if x > 75.0 => right.push(spot.area),
            _ => {}
        }
    }
    let mean = |areas: &[f64]| areas.iter().sum::<f64>() / areas.len() as f64;
    let ratio = mean(&right) / mean(&left);
    assert!(left.len() > 4 && right.len() > 4 && (ratio / (1.4 / 0.6) - 1.0).abs() < 0.2, "{ratio}");
}

#[test]
fn a_picture_needs_texture_coordinates() {
    let (key, map) = picture(MapKey::Area, [0.6, 1.4]);
    let document = on("shell", 110.0, vec![spots(6.0, 19.0).with_map(key, map)]);
    let growth = BodyGrowth::begin(&document, None, &Options::default()).expect("a model");
    let error = growth.run().err().expect("refused").to_string();
    assert!(
        error.contains("layers[0].maps.area.image") && error.contains("no texture coordinates"),
        "{error}"
    );
}

#[test]
fn noise_varies_the_colours_of_ground_and_marks_and_not_the_marks() {
    let layer = spots(7.0, 24.0);
    let colours = Colours::new([(0.0, [0, 0, 0]), (1.0, [255, 255, 255])]);
    let layer = crate::document::Layer { colours: Some(colours), ..layer };
    let map = LayerMap { source: MapSource::Noise { size: 30.0, octaves: 1 }, range: [0.0, 1.0] };
    let [plain, varied] = [layer.clone(), layer.with_map(MapKey::Colour, map)]
        .map(|layer| grown(&on("sphere", 110.0, vec![layer])));
    assert!(plain.layers[0].levelled.pattern == varied.layers[0].levelled.pattern);
    let lights = |body: &crate::synth::body::GrownBody| Coat::new(&body.document).lights(&body.painted());
    let ground = |body: &crate::synth::body::GrownBody| {
        let pattern = &body.layers[0].levelled.pattern;
        let all: Vec<f32> = lights(body)
            .iter()
            .zip(pattern)
            .filter(|(_, value)| **value < 0.02)
            .map(|(light, _)| light[0])
            .collect();
        all.iter().copied().fold(0.0, f32::max) - all.iter().copied().fold(1.0, f32::min)
    };
    assert!(ground(&plain) < 0.01 && ground(&varied) > 0.1, "{} {}", ground(&plain), ground(&varied));
}
