//! What is drawn stays where it was drawn.

use dapple::attributes::regions::RegionMap;
use dapple::field::Edges;
use dapple::marks::{Ellipse, Mark};
use dapple::measure::{self, Spot};
use dapple::synth::keep::{keep, off};
use dapple::synth::plan::plan;
use dapple::synth::recipe::{Document, SystemChoice};
use dapple::synth::{Engine, GrownLayer, Measured, Options, Training, Watch, grow, settle};

fn grown(document: &Document) -> GrownLayer {
    grow(document, "test", &Training::default(), Options::default(), &Watch::NOBODY).unwrap().layers.remove(0)
}

fn spots(layer: &GrownLayer) -> &[Spot] {
    let Measured::Spots { marks, .. } = &layer.measured else { panic!("spots were drawn") };
    marks
}

/// What grows of `marks` among spots of 300 px² that are so near and so long, at 30°, on a canvas of 12 spacings.
fn among(system: SystemChoice, packing: f64, aspect: f64, edges: Edges, marks: &dyn Fn(f64) -> Vec<Mark>) -> Vec<f64> {
    let spacing = (300.0 / packing).sqrt();
    let ellipse = |x: f64| Mark::Ellipse(Ellipse::of([x, 200.0], 300.0, aspect, 30.0));
    let drawn = [ellipse(200.0), ellipse(200.0 + spacing)];
    let map = RegionMap::of(&drawn, [12.0 * spacing; 2], [1, 1], edges).unwrap();
    let mut plan = plan(&Training::default(), system, &map).unwrap();
    keep(&mut plan, &marks(spacing));
    let mut engine = Engine::new(&plan, 1);
    settle(&mut engine, &Watch::NOBODY).unwrap();
    let size = (12.0 * spacing) as usize;
    let pattern = engine.look(&plan, size, size);
    off(&plan, &measure::spots(&pattern, 0.5))
}

fn told(what: &str, mut all: Vec<f64>) {
    let lost = all.iter().filter(|off| **off > 0.25).count();
    let n = all.len();
    if n == 0 {
        println!("{what}: none");
        return;
    }
    all.sort_by(f64::total_cmp);
    println!("{what}: kept {n}, off {lost}, median {:.3}, 90 % {:.3}, worst {:.2}", all[n/2], all[n*9/10], all[n-1]);
}

#[test]
#[ignore = "prints a table"]
fn a_table_of_pairs() {
    for (system, packing, aspect) in [(SystemChoice::TuringSpots, 0.22, 0.9), (SystemChoice::TuringSpots, 0.22, 0.5)] {
#[cfg(any())]
 for (packing, aspect) in [(0.12, 0.95), (0.12, 0.5), (0.05, 0.8), (0.2, 0.8), (0.2, 0.5)] {}
        for way in [0.0f64, 90.0] {
            for apart in [0.45, 0.5, 0.55, 0.6, 0.65, 0.7, 0.8] {
                let marks = |spacing: f64| {
                    let (s, c) = (30.0 + way).to_radians().sin_cos();
                    let (across, along) = way.to_radians().sin_cos();
                    let longer = (aspect * along * along + across * across / aspect).sqrt();
                    let pair = |k: i32| {
                        let at = [k % 3, k / 3].map(|v| (2.0 + 4.0 * f64::from(v)) * spacing);
                        let half = 0.5 * apart * spacing / longer;
                        [-half, half].map(|h| Mark::Ellipse(Ellipse::of([at[0] + h * c, at[1] + h * s], 300.0, aspect, 30.0)))
                    };
                    (0..9).flat_map(pair).collect()
                };
                told(&format!("packing {packing} aspect {aspect} way {way} apart {apart}"), among(system, packing, aspect, Edges::Wrap, &marks));
            }
        }
    }
}

#[test]
#[ignore = "prints a table"]
fn a_table_of_edges() {
    for (system, packing, aspect, turned) in [(SystemChoice::TuringSpots, 0.22, 0.9, 0.0), (SystemChoice::TuringSpots, 0.22, 0.5, 0.0)] {
#[cfg(any())]
for (packing, aspect, turned) in [(0.12, 0.95, 0.0), (0.12, 0.5, 0.0), (0.12, 0.5, 90.0), (0.05, 0.8, 0.0), (0.2, 0.8, 0.0)] {}
        for away in [0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45] {
            let marks = |spacing: f64| {
                (1..=4).map(|k| {
                    Mark::Ellipse(Ellipse::of([away * spacing, f64::from(k) * 2.4 * spacing], 300.0, aspect, 30.0 + 0.0 * turned))
                }).collect()
            };
            told(&format!("packing {packing} aspect {aspect} away {away}"), among(system, packing, aspect, Edges::Closed, &marks));
        }
    }
}

#[test]
#[ignore = "prints a table"]
fn a_table_of_lines() {
    let training = Training::default();
    for name in ["line-stripes", "mackerel", "sand-ripples", "sloping-lines", "tiger", "tile-waves", "wood-grain", "zebra"] {
        for keeps in [true, false] {
            let mut document = Document::read(format!("examples/{name}.dapple")).unwrap();
            document.layers[0].options.keep = Some(keeps);
            let mut grown = grow(&document, "test", &training, Options::default(), &Watch::NOBODY).unwrap();
            let layer = &mut grown.layers[0];
            let marks = dapple::synth::drawn::marks(&document, 0, "").unwrap();
            let size = document.size.map(|side| side as usize);
            let pattern = layer.pattern().field(size[0], size[1]);
            let mut plan = layer.plan.clone();
            keep(&mut plan, &marks);
            let mut covered = dapple::synth::keep::covered(&plan, &pattern);
            covered.sort_by(f64::total_cmp);
            let good = covered.iter().filter(|share| **share >= 0.9).count();
            let Measured::Stripes(errors) = &layer.measured else { panic!() };
            let mean = |value: &dyn Fn(&measure::StripeErrors) -> Option<f64>| {
                let all: Vec<f64> = errors.iter().filter_map(value).map(f64::abs).collect();
                all.iter().sum::<f64>() / all.len() as f64
            };
            println!("{name} keep {keeps}: {good} of {} good, least {:.2}, mean {:.2}; |angle| {:.2}, rms {:.2}, settled {} steps {}", covered.len(), covered[0], covered.iter().sum::<f64>() / covered.len() as f64, mean(&|e| e.angle), mean(&|e| e.angle_rms), layer.settled, layer.steps);
        }
    }
}
