//! Maps: what a layer asks for varies by a picture or by noise, and grows so.

use dapple::internals::grid::Field;
use dapple::internals::measure::{Target, spot_errors, stripe_errors};
use dapple::maps::{LayerMap, MapKey, MapSource};
use dapple::tone::ToneImage;
use dapple::{Document, GrownMarks, Layer, Options, Stroke};

/// Parts of the canvas that are measured, from left to right.
const PARTS: usize = 4;

/// A ramp from black on the left to white on the right.
fn ramp() -> ToneImage {
    ToneImage::new([256, 1], (0..=255).collect()).expect("256 px")
}

fn by_picture(factor: bool, range: [f64; 2]) -> LayerMap {
    LayerMap { source: MapSource::Image { image: ramp(), factor }, range }
}

/// Spots of 314 px², 34 px apart.
fn spots() -> Layer {
    let at = |x: f64, y: f64| Stroke::ellipse([256.0 + x, 256.0 + y], [12.6, 7.9], 20.0);
    let row = 34.0 * 0.75f64.sqrt();
    Layer::new([at(0.0, 0.0), at(34.0, 0.0), at(17.0, row), at(-17.0, row)])
}

/// Stripes 8 px wide along x.
fn stripes() -> Layer {
    Layer::new([Stroke::line([100.0, 256.0], [400.0, 256.0], 8.0)])
}

fn grown(layer: Layer) -> (GrownMarks, Field) {
    let document = Document::new([512, 512]).with_layer(layer);
    let grown = dapple::internals::synth::grow(&document, &Options::default()).expect("it grows");
    let marks = grown.layers[0].marks().expect("marks").clone();
    let field = marks.pattern().field(1024, 1024);
    let field = Field { cell: [0.5, 0.5], ..field };
    (marks, field)
}

/// Calls `measure` with the parts of the canvas.
fn by_part<T>(marks: &GrownMarks, measure: impl Fn(&Target) -> T) -> T {
    let part = |[x, _]: [f64; 2]| ((x / 512.0 * PARTS as f64) as usize).min(PARTS - 1);
    marks.plan.on_canvas(|target| measure(&Target { regions: PARTS, region_of: &part, ..*target }))
}

#[test]
fn explore() {
    let all = [
        ("area", spots().with_map(MapKey::Area, by_picture(false, [150.0, 500.0]))),
        ("area factor", spots().with_map(MapKey::Area, by_picture(true, [0.4, 1.5]))),
        ("spacing", spots().with_map(MapKey::Spacing, by_picture(false, [28.0, 50.0]))),
        ("direction", spots().with_map(MapKey::Direction, by_picture(false, [0.0, 90.0]))),
        ("aspect", spots().with_map(MapKey::Aspect, by_picture(false, [0.45, 1.0]))),
    ];
    for (name, layer) in all {
        let now = std::time::Instant::now();
        let (marks, _) = grown(layer);
        let errors = by_part(&marks, |target| spot_errors(marks.measured.spots(), target));
        println!("{name} {:?}", now.elapsed());
        for of in errors {
            println!(
                "  {} wanted {:.2?} got {:.2?}: {:.3?} {:.3?} {:.3?} {:.2?}",
                of.marks, of.wanted, of.got, of.area, of.spacing, of.aspect, of.angle
            );
        }
    }
    let all = [
        ("direction", stripes().with_map(MapKey::Direction, by_picture(true, [0.0, 90.0]))),
        ("spacing", stripes().with_map(MapKey::Spacing, by_picture(false, [12.0, 24.0]))),
        ("duty", stripes().with_map(MapKey::Duty, by_picture(false, [0.25, 0.5]))),
        (
            "duty spacing",
            stripes()
                .with_map(MapKey::Duty, by_picture(false, [0.25, 0.4]))
                .with_map(MapKey::Spacing, by_picture(false, [16.0, 30.0])),
        ),
        ("wide duty", stripes().with_map(MapKey::Duty, by_picture(false, [0.5, 0.75]))),
    ];
    for (name, layer) in all {
        let now = std::time::Instant::now();
        let (marks, field) = grown(layer);
        let errors = by_part(&marks, |target| stripe_errors(&field, 0.5, target));
        println!(
            "{name} {:?} {:?} {}",
            now.elapsed(),
            marks.plan.lookup.polarity,
            marks.plan.lookup.system.name()
        );
        for of in errors {
            println!(
                "  wanted {:.2?} got {:.2?}: {:.3?} {:.3?} {:.2?} {:.2?}",
                of.wanted, of.got, of.width, of.wavelength, of.angle, of.angle_rms
            );
        }
    }
}
