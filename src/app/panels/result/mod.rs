//! The tab for results: what was asked for and what has grown, all regions of the active layer in a table, one in
//! detail.

mod beyond;
mod detail;
mod growth;
mod mark;
mod signs;
mod table;
mod threads;

pub use mark::mark_result;
pub use signs::{Signs, paint_signs};

use egui::{Label, RichText, Ui};

use crate::app::action::Action;
use crate::app::growth::{Growth, GrowthState};
use crate::app::result::{self, LayerResult, Results, Verdict};
use crate::app::theme::Palette;
use crate::attributes::Attribute;
use crate::editor::session::Session;
use crate::editor::units::Ruler;

/// Side of a sign in text, points.
const SIGN: f32 = 14.0;

/// What is chosen in the tab.
#[derive(Clone, Copy, Debug)]
pub struct ResultPanel {
    /// The region that is shown in detail, (column, row).
    pub chosen: Option<[usize; 2]>,
    /// Whether each region has a sign in its corner, on sketch and texture.
    pub signs: bool,
}

impl Default for ResultPanel {
    fn default() -> Self {
        Self { chosen: None, signs: true }
    }
}

/// What the tab shows.
pub struct ResultState<'a> {
    /// The open document.
    pub session: &'a Session,
    /// The growth.
    pub growth: &'a Growth,
    /// The results of the latest texture.
    pub results: &'a Results,
    /// The position of the pointer over sketch or texture, px of the canvas.
    pub pointer: Option<[f64; 2]>,
    /// How lengths are shown.
    pub ruler: Ruler,
}

/// Shows the results of the active layer.
pub fn result(ui: &mut Ui, state: &ResultState, panel: &mut ResultPanel) -> Vec<Action> {
    let layer = result::finished_layer(state.session, state.session.active_layer);
    let Some(outcome) = state.results.outcome() else {
        ui.weak(waiting(state));
        return Vec::new();
    };
    let Some((index, of_layer)) = layer.and_then(|layer| Some((layer, outcome.layers.get(layer)?))) else {
        ui.weak(if layer.is_some() { waiting(state) } else { "Nothing is drawn on this layer." });
        return Vec::new();
    };
    let is_current = state.results.for_texture(state.growth.texture.as_ref()).is_some();
    ui.horizontal(|ui| {
        ui.strong(&of_layer.name);
        ui.weak(of_layer.system.name).on_hover_text("The reaction-diffusion system of this layer");
    });
    if !is_current {
        ui.label(RichText::new(waiting(state)).weak().small());
    }
    let (grid, is_free) = (outcome.grown.document.region_grid(), outcome.grown.document.regions.is_none());
    lost(ui, of_layer, is_current);
    if of_layer.threads.is_empty() {
        notes(ui, of_layer);
    }
    if !of_layer.threads.is_empty() {
        threads::threads(ui, state.ruler, of_layer);
        return Vec::new();
    }
    if let Some(report) = &of_layer.growth {
        return growth::growth(ui, state.ruler, report, index);
    }
    table::table(ui, of_layer, is_free, &mut panel.chosen);
    let place = region(state, of_layer, grid, panel.chosen);
    let label = if is_free { "A sign in the corner" } else { "Signs in the regions' corners" };
    ui.checkbox(&mut panel.signs, label).on_hover_text(
        "Disc with a tick: reached. Diamond with a wave: close. Triangle with an exclamation mark: missed. Ring: nothing \
         was measured.",
    );
    let Some(region) = of_layer.regions.iter().find(|region| region.report.place == place) else {
        return Vec::new();
    };
    ui.separator();
    detail::detail(ui, state.ruler, region, index, is_current, is_free)
}

/// Notes on the whole layer.
fn notes(ui: &mut Ui, layer: &LayerResult) {
    for note in &layer.notes {
        ui.add(Label::new(RichText::new(note).small().weak()).wrap());
    }
}

/// How many drawn marks did not grow. They are hollow in the sketch while the sketch is the one that has grown
/// (`is_current`).
fn lost(ui: &mut Ui, layer: &LayerResult, is_current: bool) {
    let (lost, all) = (layer.lost(), layer.drawn.len());
    if lost == 0 {
        return;
    }
    ui.horizontal_top(|ui| {
        sign(ui, Verdict::Missed);
        let marks = if all == 1 { "drawn mark" } else { "drawn marks" };
        let hollow = if is_current { ": dashed outlines in the sketch" } else { "" };
        ui.add(Label::new(format!("{lost} of {all} {marks} did not grow{hollow}")).wrap())
            .on_hover_text("Point at a dashed outline to see why it did not grow");
    });
}

/// Why there are no results, or only those of the earlier texture.
fn waiting(state: &ResultState) -> &'static str {
    match state.growth.state {
        GrowthState::Idle => "Nothing has grown yet.",
        GrowthState::Growing(..) if state.results.outcome().is_some() => {
            "Growing; numbers are from the previous texture."
        }
        GrowthState::Growing(..) => "Growing; numbers follow when it is finished.",
        GrowthState::Stopped => "Stopped; only a finished texture is measured.",
        GrowthState::Settled(_) => "Measuring …",
        GrowthState::Failed(_) => "This cannot be grown.",
    }
}

/// The region under the pointer, else the chosen one, else the first of those with the worst result.
fn region(
    state: &ResultState,
    layer: &LayerResult,
    grid: [usize; 2],
    chosen: Option<[usize; 2]>,
) -> [usize; 2] {
    let size = state.session.document().size.map(f64::from);
    let on_canvas = |at: &[f64; 2]| (0..2).all(|axis| (0.0..size[axis]).contains(&at[axis]));
    if let Some(at) = state.pointer.filter(on_canvas) {
        return [0, 1].map(|axis| ((at[axis] / size[axis] * grid[axis] as f64) as usize).min(grid[axis] - 1));
    }
    let worst = layer.regions.iter().rev().max_by_key(|region| region.verdict);
    let exists = |place: &[usize; 2]| (0..2).all(|axis| place[axis] < grid[axis]);
    chosen.filter(exists).or(worst.map(|region| region.report.place)).unwrap_or([0, 0])
}

/// A sign in text.
fn sign(ui: &mut Ui, verdict: Verdict) {
    let (rect, response) = ui.allocate_exact_size([SIGN, SIGN].into(), egui::Sense::hover());
    verdict.paint(ui.painter(), rect, Palette::current(ui.visuals()));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, verdict.name()));
    response.on_hover_text(verdict.help());
}

/// The label of an attribute, and its tooltip.
fn named(attribute: Attribute) -> (&'static str, &'static str) {
    match attribute {
        Attribute::Area => ("Area", "Mean area of the spots"),
        Attribute::Aspect => ("Aspect", "Minor ÷ major radius; 1 is round"),
        Attribute::Angle => ("Direction", "Mean direction of the major axes, or of the stripes, degrees"),
        Attribute::Spacing => ("Spacing", "Mean distance between neighbours"),
        Attribute::Width => ("Width", "Mean width of the stripes"),
        Attribute::Wavelength => ("Period", "From stripe to stripe"),
        Attribute::Raggedness => (
            "Raggedness",
            "(Contour ÷ contour of the ellipse with the same area, aspect and direction)²; 1 is smooth",
        ),
        Attribute::AngleScatter => (
            "Scatter",
            "How far the directions of the stripes deviate from the direction that was asked for, degrees",
        ),
        _ => ("", ""),
    }
}

/// An error as text: per cent, a difference, or degrees.
fn error(attribute: Attribute, error: f64) -> String {
    // No minus before a zero.
    let signed = |value: f64, digits: usize, unit: &str| {
        let text = format!("{value:+.digits$}");
        let zero = text[1..].chars().all(|c| matches!(c, '0' | '.'));
        format!("{}{unit}", if zero { &text[1..] } else { &text })
    };
    match attribute {
        Attribute::Aspect => signed(error, 2, ""),
        Attribute::Angle | Attribute::AngleScatter => signed(error, 0, "°"),
        _ => signed(100.0 * error, 0, " %"),
    }
}

#[cfg(test)]
mod tests {
    use super::error;
    use crate::attributes::Attribute;

    #[test]
    fn errors_have_a_sign_and_few_digits() {
        let shown = [
            (Attribute::Area, 0.034),
            (Attribute::Area, -0.001),
            (Attribute::Aspect, -0.051),
            (Attribute::Angle, 7.4),
        ]
        .map(|(a, e)| error(a, e));
        assert_eq!(shown, ["+3 %", "0 %", "-0.05", "+7°"]);
    }
}
