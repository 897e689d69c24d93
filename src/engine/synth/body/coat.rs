//! The colours of all layers on a model: linear light for one pattern value a layer, and one number for each map of colours.

use crate::colour::{Gradient, linear_light};
use crate::document::{Colours, Document, Layer};
use crate::synth::body::maps::multiplies;
use crate::synth::drawn::is_replaced;
use crate::synth::drawn::maps::place_by;
use crate::synth::pattern::EDGE;

/// The colours of a document, for pattern values.
pub struct Coat {
    layers: Vec<Painted>,
}

/// How a layer is painted.
struct Painted {
    /// The light of pattern values at even distances.
    light: Vec<[f32; 3]>,
    /// Whether it is painted.
    is_visible: bool,
    /// Whether its marks keep the layers above away.
    covers: bool,
    /// Which value is the number of its map of colours, and whether that multiplies; `None` without one.
    map: Option<(usize, bool)>,
}

/// Steps of the table between ground and the middle of a mark.
const STEPS: usize = 4_096;

impl Coat {
    /// The colours of all layers.
    #[must_use]
    pub fn new(document: &Document) -> Self {
        let mut mapped = document.layers.len();
        let of_layer = |(index, layer): (usize, &Layer)| {
            let map = multiplies(document, index).map(|multiplies| {
                mapped += 1;
                (mapped - 1, multiplies)
            });
            let own = layer.colours.as_ref().map(Colours::gradient);
            let is_replaced = is_replaced(document, index);
            Painted {
                light: table(&own.unwrap_or_else(|| Gradient::default_for_layer(index))),
                is_visible: layer.visible && !is_replaced,
                covers: !is_replaced,
                map,
            }
        };
        Self { layers: document.layers.iter().enumerate().map(of_layer).collect() }
    }

    /// How many layers it has.
    #[must_use]
    pub fn layers(&self) -> usize {
        self.layers.len()
    }

    /// The values of bare ground where no map varies colours.
    #[must_use]
    pub fn unvaried(&self) -> Vec<f32> {
        let numbers = self
            .layers
            .iter()
            .filter_map(|layer| layer.map)
            .map(|(_, multiplies)| f32::from(u8::from(multiplies)));
        std::iter::repeat_n(0.0, self.layers.len()).chain(numbers).collect()
    }

    /// The light of each vertex, from the patterns of all layers by vertex, and then the numbers of maps of colours.
    #[must_use]
    pub fn lights(&self, patterns: &[Vec<f32>]) -> Vec<[f32; 3]> {
        let vertices = patterns.first().map_or(0, Vec::len);
        let at = |vertex: usize| patterns.iter().map(|pattern| pattern[vertex]).collect::<Vec<f32>>();
        (0..vertices).map(|vertex| self.light(&at(vertex))).collect()
    }

    /// The light for one pattern value a layer: that of the highest visible layer that was free to grow there. Over the marks of a hidden
    /// layer it is the ground of the highest visible one.
    #[must_use]
    pub fn light(&self, values: &[f32]) -> [f32; 3] {
        let covered =
            self.layers.iter().zip(values).position(|(layer, value)| layer.covers && *value >= EDGE);
        let free = self.layers.len().min(covered.map_or(usize::MAX, |covered| covered + 1));
        let top = self.layers[..free].iter().rposition(|layer| layer.is_visible);
        match top {
            Some(layer) => self.layers[layer].of(values[layer], values),
            None => {
                let ground = self.layers.iter().rfind(|layer| layer.is_visible).or(self.layers.last());
                ground.map_or([1.0; 3], |layer| layer.of(0.0, values))
            }
        }
    }
}

impl Painted {
    fn of(&self, value: f32, values: &[f32]) -> [f32; 3] {
        let value = match self.map {
            Some((number, multiplies)) => {
                values.get(number).map_or(value, |by| place_by(value, *by, multiplies))
            }
            None => value,
        };
        self.light[(value.clamp(0.0, 1.0) * STEPS as f32 + 0.5) as usize]
    }
}

fn table(gradient: &Gradient) -> Vec<[f32; 3]> {
    let codes = linear_light();
    let values = (0..=STEPS).map(|step| step as f32 / STEPS as f32);
    let colours = gradient.colours(values);
    colours.into_iter().map(|colour| colour.map(|code| codes[usize::from(code)])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_marks_of_a_lower_layer_are_painted_over_the_ground_of_a_higher_one() {
        let two = |visible: bool| {
            let mut document =
                Document::new([100, 100]).with_layer(Layer::default()).with_layer(Layer::default());
            for (layer, colours) in document.layers.iter_mut().zip([
                Colours::new([(0.0, [10, 10, 10]), (1.0, [50, 50, 50])]),
                Colours::new([(0.0, [100, 100, 100]), (1.0, [200, 200, 200])]),
            ]) {
                layer.colours = Some(colours);
            }
            document.layers[0].visible = visible;
            Coat::new(&document)
        };
        let code = |code: u8| linear_light()[usize::from(code)];
        let shown = two(true);
        // Ground of the higher one, its marks, the marks of the lower one.
        let cases = [([0.0, 0.0], 100), ([0.0, 1.0], 200), ([1.0, 0.0], 50)];
        for (values, expected) in cases {
            assert_eq!(shown.light(&values), [code(expected); 3], "{values:?}");
        }
        assert_eq!(two(false).light(&[1.0, 0.0]), [code(100); 3]);
    }
}
