//! Compares growth on triangulations of the animal by the whole program, from the file to the report.

use dapple_engine::attributes::Attribute;
use dapple_engine::document::{Body, BodySource, Document, Layer, Stroke};
use dapple_engine::synth::Options;
use dapple_engine::synth::body::{BodyGrowth, BodyReport};

use super::mean;
use super::triangulations::{Triangulation, VERTICES, decimated, four};

/// The longest side of the animal, px of the sketch.
const PX: f64 = 900.0;
/// Distance of round spots, px.
const SPACING: f64 = 40.0;
/// Radius of the spots, px (area 141 px²).
const RADIUS: f64 = 6.7;

/// Round spots on a model in a file; the model's longest side is this number of px.
fn document(px: f64, seed: u64) -> Document {
    let at = |i: i32| {
        let shift = 0.5 * f64::from(i / 5 % 2);
        [60.0 + SPACING * (f64::from(i % 5) + shift), 60.0 + SPACING * 0.75_f64.sqrt() * f64::from(i / 5)]
    };
    let layer = Layer::new((0..25).map(|i| Stroke::ellipse(at(i), [RADIUS; 2], 0.0)));
    let source = BodySource::File { path: "animal.obj".to_owned(), sha256: None };
    let model = Some(Body { px, ..Body::new(source) });
    Document { model, seed, ..Document::new([320, 320]).with_layer(layer) }
}

fn grown(triangulation: &Triangulation, px: f64, seed: u64) -> Result<BodyReport, String> {
    let (document, obj) = (document(px, seed), triangulation.obj());
    let growth = BodyGrowth::begin(&document, Some(obj.as_bytes()), &Options::default());
    let grown = growth.map_err(|error| error.to_string())?.run().map_err(|error| error.to_string())?;
    Ok(grown.report("animal", 0.0))
}

/// Prints the result on each triangulation: the means over all seeds.
pub fn table(seeds: u64) -> Result<(), String> {
    crate::say(
        "| triangulation | polygons | spots of those laid | area before the level | area | spacing | aspect |",
    )?;
    crate::say("|---|---|---|---|---|---|---|")?;
    for triangulation in four(VERTICES)?.iter().chain(&decimated()?) {
        let reports =
            (1..=seeds).map(|seed| grown(triangulation, PX, seed)).collect::<Result<Vec<BodyReport>, _>>()?;
        let regions = || reports.iter().map(|report| &report.layers[0].regions[0]);
        let error = |attribute: Attribute| {
            mean(regions().map(|region| region.error.get(&attribute).copied().unwrap_or(f64::NAN)))
        };
        let before = mean(regions().map(|region| region.size_before_level.unwrap_or(f64::NAN)));
        let spots: Vec<String> = reports
            .iter()
            .map(|report| &report.layers[0])
            .map(|layer| format!("{}/{}", layer.spots.unwrap_or(0), layer.laid.unwrap_or(0)))
            .collect();
        crate::say(&format!(
            "| {} | {} | {} | {:+.2} % | {:+.2} % | {:+.2} % | {:+.3} |",
            triangulation.name,
            triangulation.polygons(),
            spots.join(" "),
            100.0 * before,
            100.0 * error(Attribute::Area),
            100.0 * error(Attribute::Spacing),
            error(Attribute::Aspect),
        ))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use dapple_engine::synth::body::AnchorReport;

    #[test]
    fn the_same_spots_grow_on_every_triangulation() {
        let all = four(16_000.0).expect("an animal");
        let reports: Vec<BodyReport> =
            all.iter().map(|triangulation| grown(triangulation, 0.7 * PX, 1).expect("it grows")).collect();
        let first = &reports[0].layers[0];
        for (name, report) in all.iter().map(|triangulation| triangulation.name).zip(&reports) {
            let layer = &report.layers[0];
            let apart = |of: fn(&AnchorReport) -> f64| (of(&layer.regions[0]) - of(&first.regions[0])).abs();
            assert_eq!(layer.laid, layer.spots);
            assert!(
                layer.spots.unwrap_or(0).abs_diff(first.spots.unwrap_or(0)) <= 1,
                "{name}: {:?} and {:?}, on {} and {} px²",
                layer.spots,
                first.spots,
                report.model.area,
                reports[0].model.area
            );
            let area = apart(|region| region.size_before_level.expect("whole spots"));
            let spacing = apart(|region| region.error[&Attribute::Spacing]);
            assert!(area < 0.01 && spacing < 0.02, "{name}: area {area}, spacing {spacing}: {layer:?}");
        }
    }
}
