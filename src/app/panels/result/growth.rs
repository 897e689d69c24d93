//! The result of a layer of Turing's growth.

use egui::Ui;

use crate::app::action::Action;
use crate::editor::units::Ruler;
use crate::synth::report::GrowthReport;

/// Shows the growth of a `layer` of the finished document, and offers the map of what grows at each.
pub fn growth(ui: &mut Ui, ruler: Ruler, report: &GrowthReport, layer: usize) -> Vec<Action> {
    let [low, high] = report.range;
    ui.label(format!("Growth from {low:.1} to {high:.1}"));
    ui.label(format!("Ink covers {:.0} %", 100.0 * report.ink));
    ui.label(format!("Marks are {} apart", ruler.length(report.wavelength)));
    ui.add_space(2.0);
    let help = "Shows what grows at each growth and decay, and where this layer lies";
    let asked = ui.button("Growth map…").on_hover_text(help).clicked();
    if asked { vec![Action::Cloud(Some((layer, [0, 0])))] } else { Vec::new() }
}
