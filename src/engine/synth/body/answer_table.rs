//! Answers for all that is wanted on a surface. By the laws of scale only what does not change with the size needs rows of its own:
//! area ÷ spacing² and the aspect of spots, width ÷ wavelength of stripes.

use rayon::prelude::*;

use crate::attributes::{Attributes, Spots, Stripes};
use crate::learn::Answer;
use crate::rd::{Parameters, System, fineness, selling::MIN_STRETCH};
use crate::synth::body::choice::Choice;
use crate::synth::error::LayerError;
use crate::synth::marks::plan::around::law;
use crate::synth::marks::plan::{Answers, cell_for};
use crate::synth::training::Training;

/// px of the cells of the flat grids for which questions are asked: those on which such marks are grown on a canvas, where rows are
/// dense.
fn flat_cell(system: System, wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Spots(spots) => {
            (spots.area / system.definition().resolution.planned.asked_distance).sqrt()
        }
        Attributes::Stripes(_) => cell_for(system, wanted),
    }
}

/// Looks up marks on a flat grid of their own; the rate is that of cells of `cell` px. Lines along curves and areas follow laws.
///
/// # Errors
/// The training set cannot be read.
pub fn asked_on(
    training: &Training,
    choice: &Choice,
    wanted: &Attributes,
    cell: f64,
) -> Result<Answer, LayerError> {
    let system = choice.system;
    if let Some(form) = &choice.areas {
        return Ok(form.law(system, wanted, cell));
    }
    if choice.pair.is_some() {
        return Ok(Choice::no_parameters(wanted));
    }
    if let Some((kind, laws)) = choice.curves {
        return Ok(law(kind, &laws, wanted, cell));
    }
    let fine = flat_cell(system, wanted);
    let mut answer = Answers::new(training).ask(system, wanted, fine)?.predict();
    answer.parameters.rate *= (cell / fine) * (cell / fine);
    Ok(answer)
}

/// The parameters of an answer, with another direction.
#[must_use]
pub fn parameters(answer: &Answer, direction: f64) -> Parameters {
    let of = &answer.parameters;
    Parameters {
        rate: of.rate as f32,
        ratio: of.ratio.unwrap_or(1.0) as f32,
        stretch: of.stretch as f32,
        direction: direction as f32,
        pitch: answer.pitch as f32,
    }
}

/// Answers at even distances of what does not change with the size.
pub struct AnswerTable {
    system: System,
    /// Nodes along ln(area ÷ spacing²) or ln(width ÷ wavelength), and along the aspect.
    axes: [Axis; 2],
    /// By aspect, then density.
    nodes: Vec<Node>,
}

/// The answer at a node. On p cells a spacing area and aspect differ by factors 1 + k ÷ p².
struct Node {
    /// ln(rate · size).
    rate: f64,
    /// ln ratio.
    ratio: f64,
    /// ln stretch.
    stretch: f64,
    /// ln pitch.
    pitch: f64,
    level: f64,
    /// k of the area.
    area_by_cells: f64,
    /// k of the aspect.
    aspect_by_cells: f64,
}

/// Nodes at even distances.
#[derive(Clone, Copy)]
struct Axis {
    first: f64,
    step: f64,
    count: usize,
}

impl Axis {
    /// From the lowest of some values to the highest, at most `step` apart.
    fn over(values: impl Iterator<Item = f64>, step: f64) -> Self {
        let (low, high) =
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        let count = ((high - low) / step).ceil().max(0.0) as usize + 1;
        let step = if count > 1 { (high - low) / (count - 1) as f64 } else { 1.0 };
        Self { first: low, step, count }
    }

    fn node(&self, index: usize) -> f64 {
        self.first + self.step * index as f64
    }

    /// The nodes on both sides of a value, and the share of the second.
    fn around(&self, value: f64) -> ([usize; 2], f64) {
        let at = ((value - self.first) / self.step).clamp(0.0, (self.count - 1) as f64);
        let low = (at as usize).min(self.count.saturating_sub(2));
        ([low, (low + 1).min(self.count - 1)], at - low as f64)
    }
}

/// ln(area ÷ spacing²) of spots; ln(width ÷ wavelength) of stripes, 0 where the wavelength is free.
fn density(wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Spots(spots) => {
            let spacing = spots.spacing.unwrap_or(1.0);
            libm::log(spots.area / (spacing * spacing))
        }
        Attributes::Stripes(stripes) => {
            stripes.wavelength.map_or(0.0, |wavelength| libm::log(stripes.width / wavelength))
        }
    }
}

fn aspect(wanted: &Attributes) -> f64 {
    if let Attributes::Spots(spots) = wanted { spots.aspect } else { 1.0 }
}

/// The area of spots; the squared width of stripes.
fn size(wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Spots(spots) => spots.area,
        Attributes::Stripes(stripes) => stripes.width * stripes.width,
    }
}

/// Marks as large as `like`, with another density and aspect.
fn with(like: &Attributes, density: f64, aspect: f64) -> Attributes {
    match *like {
        Attributes::Spots(spots) => Attributes::Spots(Spots {
            aspect,
            angle: 0.0,
            spacing: Some((spots.area / libm::exp(density)).sqrt()),
            ..spots
        }),
        Attributes::Stripes(stripes) => {
            let wavelength = stripes.wavelength.map(|_| stripes.width / libm::exp(density));
            Attributes::Stripes(Stripes { angle: 0.0, wavelength, ..stripes })
        }
    }
}

impl AnswerTable {
    /// Steps of the density and of the aspect. A test holds what is interpolated against what is looked up.
    const STEPS: [f64; 2] = [0.1, 0.04];

    /// The answers that all these marks need, on cells of `cell` px.
    ///
    /// # Errors
    /// The training set cannot be read.
    pub fn new(
        training: &Training,
        choice: &Choice,
        wanted: &[Attributes],
        cell: f64,
    ) -> Result<Self, LayerError> {
        let densities = Axis::over(wanted.iter().map(density), Self::STEPS[0]);
        let aspects = Axis::over(wanted.iter().map(aspect), Self::STEPS[1]);
        let usual = wanted.first().copied();
        let node = |index: usize| {
            let (aspect, density) =
                (aspects.node(index / densities.count), densities.node(index % densities.count));
            let usual = usual.ok_or(LayerError::NoPattern)?;
            Node::new(training, choice, &with(&usual, density, aspect), cell)
        };
        let nodes = (0..densities.count * aspects.count)
            .into_par_iter()
            .map(node)
            .collect::<Result<_, LayerError>>()?;
        Ok(Self { system: choice.system, axes: [densities, aspects], nodes })
    }

    /// Parameters and level of marks.
    #[must_use]
    pub fn at(&self, wanted: &Attributes) -> (Parameters, f32) {
        let [densities, aspects] = self.axes;
        let ((columns, x), (rows, y)) = (densities.around(density(wanted)), aspects.around(aspect(wanted)));
        let node = |row: usize, column: usize| &self.nodes[row * densities.count + column];
        let mix = |of: fn(&Node) -> f64| {
            let of_row = |row: usize| {
                let [first, second] = columns.map(|column| of(node(row, column)));
                first + x * (second - first)
            };
            of_row(rows[0]) + y * (of_row(rows[1]) - of_row(rows[0]))
        };
        let parameters = Parameters {
            rate: (libm::exp(mix(|node| node.rate)) / size(wanted)) as f32,
            ratio: libm::exp(mix(|node| node.ratio)) as f32,
            stretch: 1.0,
            direction: wanted.angle() as f32,
            pitch: libm::exp(mix(|node| node.pitch)) as f32,
        };
        let p = self.system.spacing(&Parameters { pitch: 1.0, ..parameters });
        let factor = |k: f64| (1.0 + k / (p * p)).clamp(0.5, 1.5);
        let stretch = (libm::exp(mix(|node| node.stretch)) / factor(mix(|node| node.aspect_by_cells)))
            .clamp(f64::from(MIN_STRETCH), 1.0);
        // At a lower level spots are larger, as much as the cells make them smaller.
        let level = mix(|node| node.level)
            * libm::pow(factor(mix(|node| node.area_by_cells)), -1.0 / self.system.definition().level_slope);
        (Parameters { stretch: stretch as f32, ..parameters }, level as f32)
    }
}

impl Node {
    fn new(training: &Training, choice: &Choice, wanted: &Attributes, cell: f64) -> Result<Self, LayerError> {
        let system = choice.system;
        let answer = asked_on(training, choice, wanted, cell)?;
        let of = &answer.parameters;
        let level = of.level.unwrap_or(0.5);
        let own = Parameters { pitch: 1.0, ..parameters(&answer, 0.0) };
        let p = system.spacing(&own);
        let fine = fineness(system, f64::from(own.ratio), p, f64::from(own.stretch));
        let factor = |of: f64| (of - 1.0) * p * p;
        // The flat grid has made them smaller, too, which its rows make up for.
        let finer = p * cell / flat_cell(system, wanted);
        let flat = 1.0 + factor(fine.smooth) / (finer * finer);
        Ok(Self {
            rate: libm::log(of.rate * size(wanted)),
            ratio: libm::log(of.ratio.unwrap_or(1.0)),
            stretch: libm::log(of.stretch),
            pitch: libm::log(answer.pitch),
            level: level * libm::pow(flat, 1.0 / system.definition().level_slope),
            area_by_cells: factor(fine.smooth),
            aspect_by_cells: factor(fine.aspect),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_interpolated_between_nodes_is_about_what_is_looked_up() {
        let training = Training::built_in();
        let spots = |area: f64, aspect: f64| {
            Attributes::Spots(Spots { area, aspect, angle: 0.0, spacing: Some(40.0) })
        };
        let lines = |width: f64| Attributes::Stripes(Stripes { width, angle: 0.0, wavelength: Some(40.0) });
        let cases = [
            (
                System::MEINHARDT_SPOTS,
                vec![spots(110.0, 0.5), spots(190.0, 0.95)],
                vec![spots(127.0, 0.61), spots(150.0, 0.73), spots(171.0, 0.88)],
            ),
            (System::MEINHARDT_LINES, vec![lines(9.0), lines(15.0)], vec![lines(10.0), lines(13.0)]),
        ];
        for (system, wanted, asked) in cases {
            let choice = Choice::of(system);
            let table = AnswerTable::new(training, &choice, &wanted, 3.0).expect("answers");
            for wanted in asked {
                let (found, _) = table.at(&wanted);
                let answer = asked_on(training, &choice, &wanted, 3.0).expect("an answer");
                let exact = parameters(&answer, 0.0);
                for (name, found, exact) in
                    [("rate", found.rate, exact.rate), ("ratio", found.ratio, exact.ratio)]
                {
                    assert!((found / exact - 1.0).abs() < 0.01, "{name}: {found} for {exact} of {wanted:?}");
                }
            }
        }
    }
}
