use super::*;
use dapple_engine::synth::drawn::sketch_targets;

#[test]
fn a_sketch_does_not_depend_on_the_others() {
    let once = sketch(SEED, 5).unwrap();
    assert_eq!(once, sketch(SEED, 5).unwrap());
    assert_ne!(once.layers, sketch(SEED, 6).unwrap().layers);
    assert_ne!(once.layers, sketch(SEED + 1, 5).unwrap().layers);
}

#[test]
fn a_hundred_sketches_are_valid_documents_within_the_ranges() {
    let mut counts = [0; 3];
    for index in 0..100 {
        let sketch = sketch(SEED, index).unwrap();
        sketch.check(&sketch.name).unwrap();
        assert!(within(&sketch), "{index}");
        let map = sketch_targets::region_map(&sketch, 0, &sketch.name).unwrap();
        let stripes = matches!(sketch.layers[0].strokes[0], Stroke::Line(_));
        for (place, region) in map.regions() {
            let allowed = if stripes { 3..=6 } else { 5..=12 };
            assert!(allowed.contains(&region.marks), "{index} {place:?}: {}", region.marks);
        }
        counts[0] += u32::from(stripes);
        counts[1] += u32::from(sketch.edges == Edges::Wrap);
        counts[2] += u32::from(map.layout().len() == 9);
    }
    assert_eq!(counts[0], 25);
    assert!((5..=15).contains(&counts[1]) && counts[2] > 0, "{counts:?}");
}

#[test]
fn a_sketch_beyond_the_ranges_is_reported() {
    let good = sketch(SEED, 0).unwrap();
    let mut larger = good.clone();
    for stroke in &mut larger.layers[0].strokes {
        if let Stroke::Ellipse(ellipse) = stroke {
            ellipse.radii = ellipse.radii.map(|radius| 10.0 * radius);
        }
    }
    assert!(within(&good) && !within(&larger));
    let mut empty = good;
    empty.layers[0].strokes.clear();
    assert!(!within(&empty));
}
