//! The plot of the cloud.

use egui::{Id, Ui, vec2};
use egui_plot::{
    Corner, GridInput, GridMark, HoverPosition, Legend, MarkerShape, Plot, PlotPoints, Points as Dots,
    log_grid_spacer,
};

use super::points::{Axis, Points, is_logarithmic};
use crate::app::theme::Palette;
use crate::app::units::three_digits as digits;

/// Number of sizes in which neighbours are drawn.
const SIZES: usize = 6;

/// Plots two quantities of `points`. Each new `question` resets the visible range.
pub fn plot(ui: &mut Ui, points: &Points, axes: [Axis; 2], question: u64) {
    let palette = Palette::current(ui.visuals());
    let at = |row: &[f64]| axes.map(|axis| scaled(axis, points.value(row, axis)));
    let dots = |name: &str, rows: Vec<[f64; 2]>| {
        let there: Vec<_> = rows.into_iter().filter(|at| at.iter().all(|x| x.is_finite())).collect();
        Dots::new(name, PlotPoints::from(there))
    };
    let all = dots("Examples", points.rows.iter().map(|row| at(row)).collect());
    let mut shown = vec![all.radius(1.4).color(ui.visuals().weak_text_color().gamma_multiply(0.6))];
    for size in 0..SIZES {
        let [low, high] = [size, size + 1].map(|step| step as f64 / SIZES as f64);
        let inside = |weight: f64| (low < weight || size == 0) && weight <= high;
        let rows = points.neighbours.iter().filter(|(_, weight)| inside(*weight)).map(|(row, _)| at(row));
        let radius = 2.0 + 3.6 * ((low + high) / 2.0).sqrt() as f32;
        // The legend shows the largest size for all.
        let larger = points.neighbours.iter().any(|(_, weight)| *weight > high);
        let name = if larger { "" } else { "Neighbours, by weight" };
        if size > 0 && !points.neighbours.iter().any(|(_, weight)| inside(*weight)) {
            continue;
        }
        shown.push(dots(name, rows.collect()).radius(radius).color(palette.edge));
    }
    let one =
        |name, row: &[f64], shape, colour| dots(name, vec![at(row)]).shape(shape).radius(8.0).color(colour);
    if points.nearest != points.asked {
        shown.push(one("Nearest that can be reached", &points.nearest, MarkerShape::Diamond, palette.accent));
    }
    if let Some(got) = &points.got {
        shown.push(one("Grown", got, MarkerShape::Square, palette.axis).radius(5.0));
    }
    shown.push(one("Asked", &points.asked, MarkerShape::Cross, palette.wrong));
    let label = |position: &HoverPosition| match position {
        HoverPosition::NearDataPoint { plot_name, position, .. } => {
            let [x, y] = [(0, position.x), (1, position.y)].map(|(axis, value)| {
                format!("{}: {}", points.title(axes[axis]), digits(unscaled(axes[axis], value)))
            });
            let name = if plot_name.is_empty() { "Neighbour" } else { plot_name };
            Some(format!("{name}\n{x}\n{y}"))
        }
        HoverPosition::Elsewhere { .. } => None,
    };
    let [x, y] = axes;
    Plot::new((question, axes))
        .id(Id::unique("cloud's plot").with((question, axes)))
        .min_size(vec2(260.0, 240.0))
        .x_axis_label(points.title(x))
        .y_axis_label(points.title(y))
        .x_axis_formatter(move |mark: GridMark, _: &_| digits(unscaled(x, mark.value)))
        .y_axis_formatter(move |mark: GridMark, _: &_| digits(unscaled(y, mark.value)))
        .x_grid_spacer(move |input| spacer(x, input))
        .y_grid_spacer(move |input| spacer(y, input))
        .label_formatter(label)
        .legend(Legend::default().position(Corner::LeftBottom))
        .show(ui, |plot| shown.into_iter().for_each(|dots| plot.points(dots)));
}

fn spacer(axis: Axis, input: GridInput) -> Vec<GridMark> {
    if !is_logarithmic(axis) {
        return log_grid_spacer(10)(input);
    }
    // Lines at 1, 2 and 5 of each decade.
    let (low, high) = input.bounds;
    let decades = (low.floor() as i32)..=(high.ceil() as i32);
    let marks = decades.flat_map(|decade| {
        [(1.0f64, 0.4), (2.0, 0.15), (5.0, 0.15)]
            .map(|(digit, step_size)| GridMark { value: f64::from(decade) + digit.log10(), step_size })
    });
    marks.filter(|mark| (low..=high).contains(&mark.value)).collect()
}

fn scaled(axis: Axis, value: f64) -> f64 {
    if is_logarithmic(axis) { value.log10() } else { value }
}

fn unscaled(axis: Axis, value: f64) -> f64 {
    if is_logarithmic(axis) { 10f64.powf(value) } else { value }
}
