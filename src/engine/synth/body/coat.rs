//! The colours of all layers on a model: linear light for one pattern value a layer, and one number for each map that changes colours only.

use std::sync::LazyLock;

use crate::colour::{Gradient, Ground, linear_light};
use crate::document::{Colours, Document, Layer, MapKey};
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
    /// The colours of pattern values at even distances: sRGB.
    colours: Vec<[u8; 3]>,
    /// Their light.
    light: Vec<[f32; 3]>,
    /// Whether it is painted.
    is_visible: bool,
    /// Whether its marks keep the layers above away.
    covers: bool,
    /// Which value is the number of its map of colours, and whether that multiplies; `None` without one.
    map: Option<(usize, bool)>,
    /// Which value is the share of the second colour of the ground, and that colour; `None` without a map of it.
    ground: Option<(usize, Ground)>,
}

/// Steps of the table between ground and the middle of a mark.
const STEPS: usize = 4_096;

impl Coat {
    /// The colours of all layers.
    #[must_use]
    pub fn new(document: &Document) -> Self {
        let mut mapped = document.layers.len();
        let mut next = || {
            mapped += 1;
            mapped - 1
        };
        let of_layer = |(index, layer): (usize, &Layer)| {
            let map = multiplies(document, index).map(|multiplies| (next(), multiplies));
            let own = layer.colours.as_ref().map(Colours::painted);
            let gradient = own.unwrap_or_else(|| Gradient::default_for_layer(index));
            let ground = layer.maps.get(MapKey::Ground).map(|_| {
                let second = layer.colours.as_ref().map_or(Colours::GROUND, |colours| colours.ground);
                (next(), Ground::new(&gradient, second))
            });
            let is_replaced = is_replaced(document, index);
            let colours = table(&gradient);
            Painted {
                light: colours.iter().map(|colour| colour.map(light_of)).collect(),
                colours,
                is_visible: layer.visible && !is_replaced,
                covers: !is_replaced,
                map,
                ground,
            }
        };
        Self { layers: document.layers.iter().enumerate().map(of_layer).collect() }
    }

    /// Whether the ground of a layer has a second colour.
    #[must_use]
    pub fn has_second_ground(&self) -> bool {
        self.layers.iter().any(|layer| layer.ground.is_some())
    }

    /// How many layers it has.
    #[must_use]
    pub fn layers(&self) -> usize {
        self.layers.len()
    }

    /// The values of bare ground where no map varies colours, and its second colour has the share `second`.
    #[must_use]
    pub fn unvaried(&self, second: f32) -> Vec<f32> {
        let numbers = self.layers.iter().flat_map(|layer| {
            let colour = layer.map.map(|(_, multiplies)| f32::from(u8::from(multiplies)));
            colour.into_iter().chain(layer.ground.as_ref().map(|_| second))
        });
        std::iter::repeat_n(0.0, self.layers.len()).chain(numbers).collect()
    }

    /// The light of each vertex, from the patterns of all layers by vertex, and then the numbers of maps that change colours only.
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
        let step = (value.clamp(0.0, 1.0) * STEPS as f32 + 0.5) as usize;
        match &self.ground {
            Some((number, ground)) => {
                let share = values.get(*number).copied().unwrap_or(0.0);
                ground.tinted(self.colours[step], value, share).map(light_of)
            }
            None => self.light[step],
        }
    }
}

fn table(gradient: &Gradient) -> Vec<[u8; 3]> {
    gradient.colours((0..=STEPS).map(|step| step as f32 / STEPS as f32))
}

/// The linear light of a channel of sRGB.
fn light_of(code: u8) -> f32 {
    static CODES: LazyLock<[f32; 256]> = LazyLock::new(linear_light);
    CODES[usize::from(code)]
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
