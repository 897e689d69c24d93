//! The report of each region of a layer of spots or stripes.

use crate::attributes::metric_field::MetricField;
use crate::attributes::{Attribute, Attributes, Spread, Stripes};
use crate::document::Document;
use crate::marks::axial;
use crate::measure::Spot;
use crate::rd::Seeding;
use crate::synth::marks::GrownMarks;
use crate::synth::marks::grow::measured::Measured;
use crate::synth::marks::plan::Plan;
use crate::synth::marks::plan::inside;
use crate::synth::report::drawn::{self, DrawnMark};
use crate::synth::report::pinned::{self, Stayed};
use crate::synth::report::region::{RaggednessReport, RegionReport};

/// The report of each region of a layer, row by row; `layer` is the grown layer `index` of `document`, and `drawn` tells how its
/// drawn marks have grown.
#[must_use]
pub fn regions(
    document: &Document,
    index: usize,
    layer: &GrownMarks,
    drawn: &[DrawnMark],
) -> Vec<RegionReport> {
    let plan = &layer.plan;
    let (layout, lines) = (plan.lookup.map.layout(), plan.lookup.system.is_striped());
    let stayed = pinned::stayed(&plan.lookup.map, drawn, lines);
    let mut remarks = plan.lookup.remarks.clone();
    if let (Some(places), Some(below)) = (plan.places(), index.checked_sub(1)) {
        let inside = inside::remarks(layout, places, layer.measured.spots(), &document.layers[below].name);
        remarks.iter_mut().zip(inside).for_each(|(remarks, inside)| remarks.extend(inside));
    }
    for (remarks, here) in remarks.iter_mut().zip(drawn::by_region(drawn, layout)) {
        remarks.extend(drawn::note(&here, lines.then_some("stripes")));
    }
    let half = half_grown_by_region(layer);
    remarks.iter_mut().zip(&half).for_each(|(remarks, places)| remarks.extend(half_grown_note(places)));
    let merged = merged(layer);
    let regions = remarks.into_iter().enumerate();
    let region = |(index, remarks): (usize, Vec<String>)| {
        let merged = merged.as_ref().map(|merged| merged[index]);
        region(layer, index, remarks, merged, stayed.get(index))
    };
    regions.map(region).collect()
}

fn region(
    layer: &GrownMarks,
    index: usize,
    remarks: Vec<String>,
    merged: Option<usize>,
    stayed: Option<&Stayed>,
) -> RegionReport {
    let Plan { lookup, corrections, .. } = &*layer.plan;
    let layout = lookup.map.layout();
    let place = layout.place(index);
    let answer = &lookup.answers[index];
    let mut notes: Vec<String> = answer.notes.iter().map(ToString::to_string).collect();
    notes.extend(remarks);
    notes.extend(corrections[index].note());
    let (marks, mut error) = errors(&layer.measured, index);
    let raggedness = layer.ragged.as_ref().map(|of| RaggednessReport { asked: of.asked, got: of.got[index] });
    error.extend(raggedness.and_then(|of| Some((Attribute::Raggedness, of.got? / of.asked - 1.0))));
    if lookup.seeding == Seeding::Initiators {
        // Lines along curves have no wanted direction.
        error.retain(|(attribute, _)| matches!(attribute, Attribute::Width | Attribute::Raggedness));
    }
    if marks == Some(0) {
        notes.push("no whole mark grew in this region: nothing was measured".to_owned());
    }
    if let Some(merged) = merged.filter(|merged| *merged > 0) {
        let are = if merged == 1 { "mark is" } else { "marks are" };
        notes.push(format!(
            "{merged} grown {are} two spots that grew together; draw them farther apart or smaller"
        ));
    }
    let map = lookup.map.without_surface();
    let asked = if map.is_modulated() || lookup.map.metric().is_some() && map.is_free() {
        map.of_region(place)
    } else {
        map.at(layout.center(place))
    };
    RegionReport {
        place,
        marks,
        merged,
        asked,
        polarity: lookup.polarity,
        directed: lookup.curve_kind().is_none(),
        parameters: parameters(layer, index),
        predicted: Some(answer.predicted),
        got: layer.measured.got(index).map(|got| got_on_surface(got, &asked, &error, lookup.map.metric())),
        raggedness,
        error,
        spread: spread(layer, place, index),
        kept: stayed.cloned(),
        beyond: answer.notes.iter().filter(|note| note.is_beyond()).cloned().collect(),
        notes,
    }
}

/// The grown attributes, on the surface if there is one. Spots are measured there; for stripes the attributes follow from those
/// `asked` for and the relative errors.
fn got_on_surface(
    got: Attributes,
    asked: &Attributes,
    errors: &[(Attribute, f64)],
    surface: Option<&MetricField>,
) -> Attributes {
    let (Some(_), Attributes::Stripes(got_flat), Attributes::Stripes(asked)) = (surface, got, asked) else {
        return got;
    };
    let error = |of: Attribute| errors.iter().find(|(one, _)| *one == of).map_or(0.0, |(_, error)| *error);
    let wavelength = got_flat.wavelength.and(asked.wavelength);
    Attributes::Stripes(Stripes {
        width: asked.width * (1.0 + error(Attribute::Width)),
        wavelength: wavelength.map(|wavelength| wavelength * (1.0 + error(Attribute::Wavelength))),
        angle: axial(asked.angle + error(Attribute::Angle)),
    })
}

/// By region, the places of half-grown marks, px.
fn half_grown_by_region(layer: &GrownMarks) -> Vec<Vec<[f64; 2]>> {
    let layout = layer.plan.lookup.map.layout();
    let mut places = vec![Vec::new(); layout.len()];
    layer.half_grown.iter().for_each(|at| places[layout.index(layout.region_of(*at))].push(*at));
    places
}

/// A note that names the `places` of half-grown marks; `None` if there are none.
fn half_grown_note(places: &[[f64; 2]]) -> Option<String> {
    let named: Vec<String> =
        places.iter().take(drawn::NAMED).map(|[x, y]| format!("({x:.0}, {y:.0})")).collect();
    let more = match places.len().saturating_sub(drawn::NAMED) {
        0 => String::new(),
        more => format!(" and {more} more places"),
    };
    let what = "the pattern stays between ground and mark";
    (!places.is_empty())
        .then(|| format!("{what} at {}{more}; with another seed such places lie elsewhere", named.join(", ")))
}

/// By region, the number of whole spots that are two merged ones; `None` for stripes.
fn merged(layer: &GrownMarks) -> Option<Vec<usize>> {
    let Measured::Spots { .. } = &layer.measured else { return None };
    let layout = layer.plan.lookup.map.layout();
    let mut merged = vec![0; layout.len()];
    merged_spots(layer).iter().for_each(|place| merged[layout.index(layout.region_of(*place))] += 1);
    Some(merged)
}

/// The centres of the whole spots of a layer that are two merged ones, px; none for stripes.
#[must_use]
pub fn merged_spots(layer: &GrownMarks) -> Vec<[f64; 2]> {
    let merged = layer.measured.merged_spots(&layer.plan);
    // Ragged spots fill as little of their ellipses as merged ones, but are not twice as large.
    let is_large = |spot: &&Spot| match layer.plan.lookup.map.at(spot.ellipse.center) {
        Attributes::Spots(wanted) => layer.ragged.is_none() || spot.ellipse.area() > TWICE * wanted.area,
        Attributes::Stripes(_) => true,
    };
    merged.filter(is_large).map(|spot| spot.ellipse.center).collect()
}

/// Least area of two merged spots, relative to that of one.
const TWICE: f64 = 1.6;

fn parameters(layer: &GrownMarks, index: usize) -> Vec<(&'static str, f64)> {
    let lookup = &layer.plan.lookup;
    let answer = &lookup.answers[index];
    let mut named = answer.parameters.named();
    for (name, value) in &mut named {
        if *name == "level" {
            *value *= layer.correction[index];
        }
    }
    // The pitch at which its spots were placed ÷ the system's own.
    if answer.pitch > 1.0 {
        named.push(("pitch", answer.pitch));
    }
    if lookup.curve_kind().is_some() {
        named.retain(|(name, _)| *name != "direction");
    }
    named.push(("cell", lookup.px_a_cell()));
    named
}

/// The asked and the grown spread of the spots of a region; `None` if no spread was asked for.
fn spread(layer: &GrownMarks, place: [usize; 2], index: usize) -> Option<(Spread, Option<Spread>)> {
    let asked = layer.plan.lookup.map.region(place).spread;
    if asked.is_zero() {
        return None;
    }
    let got = match &layer.measured {
        Measured::Spots { errors, .. } => errors[index].spread,
        Measured::Stripes(_) => None,
    };
    Some((asked, got))
}

/// The number of whole marks that were measured (for spots), and their errors by attribute.
fn errors(measured: &Measured, index: usize) -> (Option<usize>, Vec<(Attribute, f64)>) {
    let (marks, named) = match measured {
        Measured::Spots { errors, .. } => {
            let e = &errors[index];
            (
                Some(e.marks),
                [
                    (Attribute::Area, e.area),
                    (Attribute::Aspect, e.aspect),
                    (Attribute::Angle, e.angle),
                    (Attribute::Spacing, e.spacing),
                ],
            )
        }
        Measured::Stripes(errors) => {
            let e = &errors[index];
            let named = [
                (Attribute::Width, e.width),
                (Attribute::Wavelength, e.wavelength),
                (Attribute::Angle, e.angle),
                (Attribute::AngleScatter, e.angle_rms),
            ];
            (None, named)
        }
    };
    (marks, named.into_iter().filter_map(|(attribute, value)| Some((attribute, value?))).collect())
}
