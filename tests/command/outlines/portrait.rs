//! Portraits for plotters: the drawing of the SVG has the tone of the picture.

use crate::outlines::bench::Bench;
use dapple::ReadFile;
use dapple::document::Document;
use dapple_engine::synth::Training;
use dapple_engine::synth::tone::grown::compared;
use dapple_engine::synth::tone::plan::TonePlan;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg;
use std::path::Path;

/// Correlation and mean difference, after blurring by half a wavelength and by one.
type Errors = [(f64, f64); 2];

/// px of the raster for each px of the tone, along each side. Where the edges of two strokes share a px, less is
/// visible than both strokes cover together.
const FINER: usize = 4;

/// The drawing of an example's SVG: its errors compared with the tone that is asked for, and the distances that the pen
/// moves without drawing, mm, in the order of the file and in the order in which the paths were found.
fn drawn(name: &str, style: &str) -> (Errors, [f64; 2]) {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("examples/{name}.dapple"));
    let document = Document::read(file).unwrap();
    let bench = Bench::new();
    bench.write("a.dapple", &document.to_json());
    bench.does(&format!("grow a.dapple -o a.svg --report r.json {style}"));
    let size = document.size.map(f64::from);
    let plan = TonePlan::read(&document, 0, name, size, (&Training::default(), None)).unwrap();
    let tree = usvg::Tree::from_str(&bench.text("a.svg"), &usvg::Options::default()).unwrap();
    let [width, height] = plan.fine;
    let mut pixmap = Pixmap::new((FINER * width) as u32, (FINER * height) as u32).unwrap();
    let scale = [width as f32 / tree.size().width(), height as f32 / tree.size().height()];
    let scale = Transform::from_scale(FINER as f32 * scale[0], FINER as f32 * scale[1]);
    resvg::render(&tree, scale, &mut pixmap.as_mut());
    let row = |y: usize| &pixmap.pixels()[FINER * width * y..][..FINER * width];
    let ink: Vec<f32> = (0..width * height)
        .map(|px| {
            let (x, y) = (FINER * (px % width), FINER * (px / width));
            let alpha = |y: usize| row(y)[x..x + FINER].iter().map(|px| u32::from(px.alpha())).sum::<u32>();
            (y..y + FINER).map(alpha).sum::<u32>() as f32 / (255 * FINER * FINER) as f32
        })
        .collect();
    let errors = [0.5, 1.0].map(|blur| {
        let sigma = blur * plan.px_a_wavelength();
        let (correlation, difference) = compared(&ink, &plan.tone, plan.fine, sigma, plan.grid.edges);
        (correlation.expect("the tone varies"), difference)
    });
    let report: serde_json::Value = serde_json::from_str(&bench.text("r.json")).unwrap();
    let ways = ["pen_up", "pen_up_unordered"].map(|key| report["outlines"][key].as_f64().unwrap());
    println!("{name} {style}: {errors:.4?}, pen up {ways:.0?} mm");
    (errors, ways)
}

fn has_the_tone(name: &str, [near, far]: Errors) {
    assert!(near.0 >= 0.985 && far.0 >= 0.995, "{name}: {near:?} {far:?}");
    assert!(near.1 <= 0.02 && far.1 <= 0.01, "{name}: {near:?} {far:?}");
}

#[test]
fn the_filled_outlines_of_a_portrait_have_its_tone() {
    has_the_tone("portrait", drawn("portrait", "").0);
}

#[test]
fn the_hatch_of_a_portrait_has_its_tone_with_a_pen_of_this_width() {
    has_the_tone("portrait", drawn("portrait", "--style hatch:0.25:45 --pen 0.3").0);
}

#[test]
fn stipples_have_the_tone_and_ordering_reduces_the_pen_travel_to_a_tenth() {
    let (errors, [ordered, found]) = drawn("stipples", "");
    has_the_tone("stipples", errors);
    assert!(ordered < 0.1 * found, "{ordered} of {found} mm");
}
