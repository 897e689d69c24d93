//! A test kind of layer: one flat colour over half of the canvas. It proves that a kind is one file and one line in the list.

use crate::attributes::system::Description;
use crate::document::Document;
use crate::grid::{Domain, Field, Grid};
use crate::points::fields::POINTS;
use crate::synth::error::LayerError;
use crate::synth::kind::{
    Advanced, Beneath, Described, Ending, Kind, Planned, Previewed, Request, Seen, Setting, Trial, Work,
};
use crate::synth::pattern::{AreaPattern, LayerPattern};
use crate::synth::report::LayerReport;
use crate::synth::watch::Stage;

/// Layers of one flat colour.
#[derive(Debug)]
pub struct Flat;

/// The name of layers that are of this kind.
pub const NAME: &str = "half of it is flat";

/// A description for the test; only its name is shown.
static SYSTEM: Description = Description { name: "flat", title: "Flat", ..POINTS };

/// A flat layer, planned or grown.
#[derive(Clone)]
pub struct FlatField(Field, Grid);

fn seen(steps: u64, FlatField(field, grid): &FlatField) -> Seen<'_> {
    let pattern = || AreaPattern::new(field);
    Seen {
        steps,
        grid: grid.size,
        canvas: grid.bounds_px().size,
        pattern: Box::new(move || Box::new(pattern())),
    }
}

impl Previewed for FlatField {
    fn seen(&self) -> Seen<'_> {
        seen(0, self)
    }
}

impl Kind for Flat {
    type Plan = FlatField;
    type Growth<'a> = (FlatField, u64);
    type Grown = FlatField;

    fn takes(document: &Document, index: usize) -> bool {
        document.layers[index].name == NAME
    }

    fn read(request: &Request) -> Result<FlatField, LayerError> {
        let cells = request.size.map(|side| side as usize);
        let grid = Grid { size: cells, cell: [1.0, 1.0], edges: request.document.edges };
        let value = |cell: usize| if cell % cells[0] < cells[0] / 2 { 1.0 } else { 0.0 };
        Ok(FlatField(Field::new(&grid, (0..grid.cells()).map(value).collect()), grid))
    }

    fn planned(plan: &FlatField) -> Planned {
        Planned { system: &SYSTEM, grid: plan.1 }
    }

    fn bytes(_plan: &FlatField, _size: [f64; 2], grid: [usize; 2]) -> f64 {
        4.0 * (grid[0] * grid[1]) as f64
    }

    fn seconds(plan: &FlatField) -> f64 {
        1e-6 * plan.1.cells() as f64
    }

    fn trial(plan: &FlatField, _seed: u64) -> Option<Trial> {
        Some(Trial { work: Work::Seconds(1.0), look: Box::new(plan.clone()) })
    }

    fn describe(_plan: &FlatField, request: &Request, notes: Vec<String>) -> Described {
        let text = format!("layer {}: one flat colour\n", request.index + 1);
        let json = serde_json::json!({"system": SYSTEM.name, "notes": notes});
        Described::new(text, notes, json)
    }

    fn no_morph(_document: &Document, _index: usize) -> Option<String> {
        Some("its layer is flat".to_owned())
    }

    fn begin<'a>(
        plan: FlatField,
        _beneath: &Beneath,
        _setting: Setting<'a>,
    ) -> Result<(FlatField, u64), LayerError> {
        Ok((plan, 0))
    }

    fn advance(growth: &mut (FlatField, u64), _budget: u64) -> Result<Advanced, LayerError> {
        growth.1 += 1;
        Ok(if growth.1 < 3 { Advanced::seen(1) } else { Advanced::done(1) })
    }

    fn progress(growth: &(FlatField, u64)) -> (Stage, f64) {
        (Stage::Grow, growth.1 as f64 / 3.0)
    }

    fn updates_in(_growth: &(FlatField, u64), _time: f64) -> u64 {
        1
    }

    fn seen<'s>(growth: &'s (FlatField, u64)) -> Option<Seen<'s>> {
        Some(seen(growth.1, &growth.0))
    }

    fn complete(growth: (FlatField, u64)) -> Option<FlatField> {
        Some(growth.0)
    }

    fn planned_of(grown: &FlatField) -> Planned {
        Self::planned(grown)
    }

    fn ending(_grown: &FlatField) -> Ending {
        Ending { steps: 3, settled: true }
    }

    fn pattern(grown: &FlatField) -> LayerPattern<'_> {
        Box::new(AreaPattern::new(&grown.0))
    }

    fn report(_grown: &FlatField, _document: &Document, _index: usize, report: &mut LayerReport) {
        report.notes = vec!["it is flat".to_owned()];
    }
}

mod tests {
    use super::*;
    use crate::document::{Layer, Stroke};
    use crate::synth::estimate::{Needs, Task};
    use crate::synth::growth::{Growth, Progress};
    use crate::synth::layer::{LayerKind, LayerPlan};
    use crate::synth::layer_report::report;
    use crate::synth::options::{Machine, Options};
    use crate::synth::render::painting::Painting;
    use crate::synth::training::Training;
    use std::time::Duration;

    /// A flat layer above spots.
    fn document() -> Document {
        let spots = [[30.0, 30.0], [58.0, 34.0]].map(|center| Stroke::ellipse(center, [8.0, 5.0], 30.0));
        let flat =
            Layer { name: NAME.to_owned(), ..Layer::new([Stroke::ellipse([20.0, 20.0], [9.0, 9.0], 0.0)]) };
        Document::new([96, 80]).with_layer(Layer::new(spots)).with_layer(flat)
    }

    #[test]
    fn a_kind_of_one_file_and_one_line_is_planned_and_checked() {
        let document = document();
        assert_eq!(LayerKind::of(&document, 1), LayerKind::Flat);
        let (training, beneath) = (Training::built_in(), None);
        let request = Request {
            document: &document,
            index: 1,
            source: "",
            size: [96.0, 80.0],
            training,
            memory: None,
            beneath,
        };
        let plan = LayerPlan::read(&request).expect("a plan");
        assert_eq!(plan.planned().grid.size, [96, 80]);
        assert!(plan.fits(&Request { memory: Some(10.0), ..request }).is_err());
        assert!((plan.seconds() - 96.0 * 80.0 * 1e-6).abs() < 1e-12);
        let said = plan.describe(&request, vec!["a note".to_owned()]);
        assert_eq!((said.text.as_str(), said.notes.len()), ("layer 2: one flat colour\n", 1));
        assert_eq!(said.json["system"], "flat");
        let machine = Machine { memory: None, clock: || Duration::ZERO };
        let document = Document { layers: document.layers[1..].to_vec(), ..document.clone() };
        let task = Task { document: &document, size: [96, 80], source: "", scale: 1, machine };
        assert_eq!(Needs::estimate(&task, training).expect("an estimate").seconds, 1.0);
    }

    #[test]
    fn a_kind_of_one_file_and_one_line_is_grown_painted_and_reported() {
        let document = document();
        let mut growth = Growth::begin(&document, &Options::default(), None);
        let mut steps = Vec::new();
        while growth.advance(1).expect("it grows") != Progress::Done {
            if let Some(look) = growth.snapshot().filter(|look| look.beneath.len() == 1) {
                steps.push(look.growing.steps);
                assert_eq!(Painting::growing(&document, &look, [96, 80]).rgb().len(), 3 * 96 * 80);
            }
        }
        steps.dedup();
        assert_eq!(steps, [0, 1, 2, 3]);
        let grown = growth.complete().expect("it has grown");
        assert_eq!(grown.pattern(1).expect("a pattern").get(10, 10), 1.0);
        let report = report(&document, "", &grown, 0.0);
        assert_eq!(
            (report.layers[1].system, &report.layers[1].notes[..]),
            ("flat", &["it is flat".to_owned()][..])
        );
    }
}
