//! What was asked and what has grown: all regions of the layer at hand in a table, one of them in detail.

mod detail;
mod table;

pub use detail::digits;

use egui::{RichText, Ui};

use crate::app::Window;
use crate::app::action::Action;
use crate::app::growth::Phase;
use crate::app::result::{self, LayerResult, Verdict};
use crate::app::theme::Palette;

/// Points a side of a mark between words.
const SIGN: f32 = 14.0;

/// Shows them.
pub fn result(ui: &mut Ui, window: &mut Window, actions: &mut Vec<Action>) {
    let layer = result::layer_of(&window.session, window.session.active_layer);
    let Some(outcome) = window.results.outcome().cloned() else {
        ui.weak(waiting(window));
        return;
    };
    let Some((index, of)) = layer.and_then(|layer| Some((layer, outcome.layers.get(layer)?))) else {
        ui.weak(if layer.is_some() { waiting(window) } else { "Nothing is drawn on this layer." });
        return;
    };
    let ruler = window.ruler();
    let current = window.results.of(window.growth.texture.as_ref()).is_some();
    ui.horizontal(|ui| {
        ui.strong(&of.name);
        ui.weak(of.system.name()).on_hover_text("The reaction-diffusion system that has grown it");
    });
    if !current {
        ui.label(RichText::new(waiting(window)).weak().small());
    }
    let grid = outcome.grown.document.regions.map(|n| n as usize);
    table::table(ui, of, &mut window.results.chosen);
    let place = shown(window, of, grid);
    ui.checkbox(&mut window.results.signs, "Marks in the regions' corners").on_hover_text(
        "A disc with a tick: met. A diamond with a wave: near. A triangle with an exclamation mark: missed. A ring: \
         nothing was measured.",
    );
    if let Some(region) = of.regions.iter().find(|region| region.report.place == place) {
        ui.separator();
        detail::detail(ui, ruler, region, index, current, actions);
    }
}

/// Why there is nothing to be seen, or only what was before.
fn waiting(window: &Window) -> &'static str {
    match window.growth.phase {
        Phase::Idle => "Nothing has grown yet.",
        Phase::Growing(..) if window.results.outcome().is_some() => {
            "Growing: these are the numbers of before."
        }
        Phase::Growing(..) => "Growing: the numbers come once it has settled.",
        Phase::Stopped => "Stopped: only what has settled is measured.",
        Phase::Settled(_) => "Measuring …",
        Phase::Failed(_) => "This cannot be grown.",
    }
}

/// The region under the pointer, else the chosen one, else the first of the worst.
fn shown(window: &Window, of: &LayerResult, grid: [usize; 2]) -> [usize; 2] {
    let size = window.session.document().size.map(f64::from);
    let under = window
        .canvas
        .pointer
        .or(window.texture.pointer)
        .filter(|at| (0..2).all(|axis| (0.0..size[axis]).contains(&at[axis])));
    if let Some(at) = under {
        return [0, 1].map(|axis| ((at[axis] / size[axis] * grid[axis] as f64) as usize).min(grid[axis] - 1));
    }
    let worst = of.regions.iter().rev().max_by_key(|region| region.verdict);
    let within = |place: &[usize; 2]| (0..2).all(|axis| place[axis] < grid[axis]);
    window.results.chosen.filter(within).or(worst.map(|region| region.report.place)).unwrap_or([0, 0])
}

/// A mark between words; `name` is what it says to who does not see it.
fn sign(ui: &mut Ui, verdict: Verdict) {
    let (rect, response) = ui.allocate_exact_size([SIGN, SIGN].into(), egui::Sense::hover());
    verdict.paint(ui.painter(), rect, Palette::of(ui.visuals()));
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, verdict.name()));
    response.on_hover_text(verdict.help());
}

/// What people read for an attribute, and what it is.
fn named(attribute: &str) -> (&'static str, &'static str) {
    match attribute {
        "area" => ("Area", "Mean area of the spots at their edge"),
        "aspect" => ("Aspect", "Minor ÷ major radius; 1 is round"),
        "angle" => ("Direction", "Mean direction of the major axes, or of the stripes, degrees"),
        "spacing" => ("Spacing", "Mean distance between neighbours"),
        "width" => ("Width", "Mean width of the stripes"),
        "wavelength" => ("Period", "From stripe to stripe"),
        "angle_rms" => ("Scatter", "How much the stripes' directions scatter about what was asked, degrees"),
        _ => ("", ""),
    }
}

/// An error as people read it.
fn error(attribute: &str, error: f64) -> String {
    // No minus before a zero.
    let signed = |value: f64, digits: usize, unit: &str| {
        let text = format!("{value:+.digits$}");
        let zero = text[1..].chars().all(|c| matches!(c, '0' | '.'));
        format!("{}{unit}", if zero { &text[1..] } else { &text })
    };
    match attribute {
        "aspect" => signed(error, 2, ""),
        "angle" | "angle_rms" => signed(error, 0, "°"),
        _ => signed(100.0 * error, 0, " %"),
    }
}

#[cfg(test)]
mod tests {
    use super::error;

    #[test]
    fn errors_are_short_and_signed() {
        let told =
            [("area", 0.034), ("area", -0.001), ("aspect", -0.051), ("angle", 7.4)].map(|(a, e)| error(a, e));
        assert_eq!(told, ["+3 %", "0 %", "-0.05", "+7°"]);
    }
}
