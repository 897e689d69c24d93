//! One region: what was asked for, what has grown, the parameters that were looked up, notes.

use egui::{Button, CollapsingHeader, Frame, Grid, Label, RichText, Ui, vec2};

use super::{error, named, sign};
use crate::app::action::Action;
use crate::app::result::{RegionResult, Verdict};
use crate::app::theme::Palette;
use crate::app::units::three_digits as digits;
use crate::attributes::{Attribute, Attributes};
use crate::editor::units::Ruler;
use crate::marks::axial;
use crate::synth::report::{RaggednessReport, RegionReport};

/// Shows a region of layer number `layer` of the finished document, or the whole canvas where its marks are free
/// (`is_free`). The sketch can be changed from here where the result `is_current`.
pub fn detail(
    ui: &mut Ui,
    ruler: Ruler,
    region: &RegionResult,
    layer: usize,
    is_current: bool,
    is_free: bool,
) -> Vec<Action> {
    let mut actions = Vec::new();
    let report = &region.report;
    let [column, row] = report.place;
    ui.horizontal_wrapped(|ui| {
        sign(ui, region.verdict);
        let name = format!("Region {}, {}", column + 1, row + 1);
        ui.strong(if is_free { "Whole canvas" } else { &name });
        ui.weak(region.verdict.name()).on_hover_text(region.verdict.help());
        if let Some(marks) = report.marks {
            ui.weak(format!("· {marks} measured")).on_hover_text("Number of whole spots that were measured");
        }
    });
    numbers(ui, ruler, region);
    if let Some(text) = why_asked(report, ruler, is_free) {
        ui.add(Label::new(RichText::new(text).small().weak()).wrap());
    }
    if !report.beyond.is_empty() {
        actions.extend(beyond(ui, ruler, region, layer, is_current));
    }
    let beyond: Vec<String> = report.beyond.iter().map(ToString::to_string).collect();
    for note in report.notes.iter().filter(|note| !beyond.contains(note)) {
        ui.add(Label::new(RichText::new(capital(note)).small().weak()).wrap());
    }
    parameters(ui, region);
    if report.predicted.is_some() {
        ui.add_space(2.0);
        let why = ui
            .button("Training data…")
            .on_hover_text("Shows the simulations from which these parameters were interpolated");
        if why.clicked() {
            actions.push(Action::Cloud(Some((layer, report.place))));
        }
    }
    actions
}

/// A row for each attribute: asked, grown, error.
fn numbers(ui: &mut Ui, ruler: Ruler, region: &RegionResult) {
    let report = &region.report;
    let asked = listed(&report.asked, report.directed);
    let got = report.got.map(|got| listed(&got, report.directed)).unwrap_or_default();
    Grid::new("numbers").num_columns(5).min_col_width(14.0).spacing(vec2(6.0, 5.0)).show(ui, |ui| {
        for (head, help) in [
            ("", ""),
            ("asked", "What your marks ask for, at the places where marks have grown"),
            ("grown", "What was measured in the grown texture"),
            ("error", "The difference between grown and asked"),
        ] {
            ui.label(RichText::new(head).small().weak()).on_hover_text(help);
        }
        ui.end_row();
        for (attribute, value) in &asked {
            // Round spots have no direction.
            if *attribute == Attribute::Angle
                && report.got.is_some()
                && report.error.iter().all(|(of, _)| *of != Attribute::Angle)
            {
                continue;
            }
            let (name, help) = named(*attribute);
            ui.label(name).on_hover_text(help);
            let wanted = asked_at_marks(report, *attribute).unwrap_or(*value);
            ui.label(number(ruler, *attribute, wanted));
            let found = got.iter().find(|(of, _)| of == attribute);
            ui.label(found.map_or("–".to_owned(), |(_, value)| number(ruler, *attribute, *value)));
            let off = report.error.iter().find(|(of, _)| of == attribute);
            ui.label(off.map_or("–".to_owned(), |(_, off)| error(*attribute, *off)));
            let verdict = off.and_then(|(_, off)| Verdict::for_error(*attribute, *off));
            sign(ui, verdict.unwrap_or(Verdict::Unknown));
            ui.end_row();
        }
        if let Some(RaggednessReport { asked, got }) = report.raggedness {
            let (name, help) = named(Attribute::Raggedness);
            ui.label(name).on_hover_text(help);
            ui.label(format!("{asked:.2}"));
            ui.label(got.map_or("–".to_owned(), |got| format!("{got:.2}")));
            ui.label(got.map_or("–".to_owned(), |got| error(Attribute::Raggedness, got / asked - 1.0)));
            ui.end_row();
        }
        if let Some((_, rms)) = report.error.iter().find(|(of, _)| *of == Attribute::AngleScatter) {
            let (name, help) = named(Attribute::AngleScatter);
            ui.label(name).on_hover_text(help);
            ui.label("");
            ui.label("");
            ui.label(format!("{rms:.0}°"));
            ui.end_row();
        }
    });
}

/// Why the area or the width that is asked for is not the mean of the drawn ones; `None` where both are about the same.
fn why_asked(report: &RegionReport, ruler: Ruler, is_free: bool) -> Option<String> {
    /// A smaller relative difference is not explained.
    const SMALL: f64 = 0.03;
    let (attribute, drawn) = match &report.asked {
        Attributes::Spots(spots) => (Attribute::Area, spots.area),
        Attributes::Stripes(stripes) => (Attribute::Width, stripes.width),
    };
    let asked = asked_at_marks(report, attribute)?;
    let [drawn_text, asked_text] = [drawn, asked].map(|value| number(ruler, attribute, value));
    let drawn_where = if is_free { "Your marks have" } else { "The centre of the region has" };
    let what = if attribute == Attribute::Area { "spots" } else { "stripes" };
    ((asked / drawn - 1.0).abs() > SMALL).then(|| {
        format!(
            "{drawn_where} a mean {attribute} of {drawn_text}. Sizes change from place to place, and more {what} fit where \
             they are small, so the mean asked for at the grown {what} is {asked_text}."
        )
    })
}

/// The mean of what was asked for at the measured marks; `None` where none was measured.
fn asked_at_marks(report: &RegionReport, attribute: Attribute) -> Option<f64> {
    let got = listed(&report.got?, report.directed);
    let (_, got) = *got.iter().find(|(of, _)| *of == attribute)?;
    let (_, off) = *report.error.iter().find(|(of, _)| *of == attribute)?;
    Some(match attribute {
        Attribute::Aspect => got - off,
        Attribute::Angle => axial(got - off),
        _ => got / (1.0 + off),
    })
}

/// What cannot be reached, and a button that changes the marks to the most similar ones that can be grown.
fn beyond(
    ui: &mut Ui,
    ruler: Ruler,
    region: &RegionResult,
    layer: usize,
    is_current: bool,
) -> Option<Action> {
    let mut action = None;
    let palette = Palette::current(ui.visuals());
    let frame = Frame::NONE.inner_margin(8.0).corner_radius(6.0).stroke((1.0, palette.wrong));
    frame.show(ui, |ui| {
        ui.horizontal(|ui| {
            sign(ui, Verdict::Missed);
            ui.strong("Cannot be reached");
        });
        for note in &region.report.beyond {
            let text = super::beyond::in_words(note, &region.report.asked, ruler);
            ui.add(Label::new(RichText::new(text).small()).wrap());
        }
        match &region.reach {
            Some(reach) => {
                let button = Button::new("Draw what can be reached").min_size(vec2(190.0, 26.0));
                let help = format!("Changes the marks of this region: {}. Can be undone.", reach.text);
                if ui.add_enabled(is_current, button).on_hover_text(help).clicked() {
                    action = Some(Action::Reach(layer, region.report.place));
                }
                ui.label(RichText::new(capital(&reach.text)).small().weak());
            }
            None => {
                ui.weak("Searching for the most similar marks that can be grown …");
            }
        }
    });
    action
}

fn parameters(ui: &mut Ui, region: &RegionResult) {
    let header = CollapsingHeader::new("Parameters found").id_salt("parameters");
    header.show(ui, |ui| {
        Grid::new("parameters").num_columns(2).min_col_width(72.0).spacing(vec2(10.0, 4.0)).show(ui, |ui| {
            for (name, value) in &region.report.parameters {
                let (shown, help) = parameter(name);
                ui.label(shown).on_hover_text(help);
                let text = if *name == "direction" { format!("{value:.0}°") } else { digits(*value) };
                ui.label(text);
                ui.end_row();
            }
        });
    });
}

/// The label of a parameter, and its tooltip.
pub fn parameter(name: &str) -> (&str, &str) {
    match name {
        "rate" => (
            "Rate",
            "Reaction rate ÷ √(Da·Db), 1/cell², where Da and Db are the diffusion of the two substances: \
             faster reactions give smaller marks",
        ),
        "ratio" => ("Ratio", "Db ÷ Da: diffusion of the inhibitor ÷ diffusion of the activator"),
        "stretch" => ("Stretch", "Minor ÷ major axis of the diffusion: below 1 marks are elongated"),
        "direction" => ("Direction", "Long axis of the diffusion, degrees"),
        "level" => ("Level", "Where the edge of a mark lies, as a share of the highest concentration nearby"),
        "pitch" => ("Pitch", "Spacing of the spots ÷ the spacing that the system gives by itself"),
        "sigma" => (
            "Noise",
            "Random part of the distance that decides to which patch a point belongs: standard deviation of \
             its logarithm",
        ),
        "points" => ("Points", "Number of points in a patch"),
        "cell" => ("Cell", "Size of a cell of the simulation's grid, px"),
        other => (other, ""),
    }
}

/// The attributes that apply, in order.
pub(super) fn listed(attributes: &Attributes, directed: bool) -> Vec<(Attribute, f64)> {
    let applies = |(attribute, _): &(Attribute, f64)| {
        directed || *attribute != Attribute::Angle || matches!(attributes, Attributes::Spots(_))
    };
    attributes.listed().into_iter().filter(applies).collect()
}

pub(super) fn number(ruler: Ruler, attribute: Attribute, value: f64) -> String {
    match attribute {
        Attribute::Area => ruler.area(value),
        Attribute::Aspect => format!("{value:.2}"),
        Attribute::Angle => format!("{value:.0}°"),
        _ => ruler.length(value),
    }
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
