//! The threads of each direction of a weave: what was asked for, what has grown.

use egui::{Grid, RichText, Ui, vec2};

use super::detail::{listed, number};
use super::{error, named, sign};
use crate::app::result::{LayerResult, Verdict};
use crate::attributes::{Attribute, Attributes, Stripes};
use crate::editor::units::Ruler;
use crate::synth::report::ThreadErrors;
use crate::synth::report::ThreadReport;

/// Shows a block for each direction, then the notes.
pub fn threads(ui: &mut Ui, ruler: Ruler, layer: &LayerResult) {
    for (index, threads) in layer.threads.iter().enumerate() {
        ui.add_space(4.0);
        let lines = if threads.lines == 1 { "line" } else { "lines" };
        ui.horizontal(|ui| {
            sign(ui, verdict(threads));
            ui.strong(format!("Threads at {:.0}°", threads.asked.angle));
            ui.weak(format!("· {} {lines} drawn", threads.lines));
        });
        Grid::new(("threads", index)).num_columns(4).min_col_width(14.0).spacing(vec2(6.0, 5.0)).show(
            ui,
            |ui| {
                for head in ["", "asked", "grown", "error"] {
                    ui.label(RichText::new(head).small().weak());
                }
                ui.end_row();
                for (attribute, value) in of(&threads.asked) {
                    let (name, help) = named(attribute);
                    ui.label(name).on_hover_text(help);
                    ui.label(number(ruler, attribute, value));
                    let got = threads.got.iter().flat_map(of).find(|(of, _)| *of == attribute);
                    ui.label(got.map_or("–".to_owned(), |(_, value)| number(ruler, attribute, value)));
                    let off = errors(threads).into_iter().find(|(of, _)| *of == attribute);
                    ui.label(off.map_or("–".to_owned(), |(_, off)| error(attribute, off)));
                    ui.end_row();
                }
            },
        );
    }
    super::notes(ui, layer);
}

fn of(threads: &Stripes) -> Vec<(Attribute, f64)> {
    listed(&Attributes::Stripes(*threads), true)
}

fn errors(threads: &ThreadReport) -> Vec<(Attribute, f64)> {
    let named = |errors: &ThreadErrors| {
        [
            (Attribute::Width, errors.width),
            (Attribute::Wavelength, errors.wavelength),
            (Attribute::Angle, errors.angle),
        ]
    };
    threads.error.iter().flat_map(named).collect()
}

/// How well threads reach the attributes that were asked for: the verdict on the worst one.
fn verdict(threads: &ThreadReport) -> Verdict {
    if threads.got.is_none() {
        return Verdict::Missed;
    }
    let each = errors(threads).into_iter().filter_map(|(attribute, off)| Verdict::for_error(attribute, off));
    each.max().unwrap_or(Verdict::Unknown)
}
