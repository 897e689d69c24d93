//! Colours from nature, chosen by eye on grown patterns; none was measured on an animal.
//!
//! All have the same structure. The ground darkens slightly towards the mark, and the mark towards its centre. Between 0.4 and
//! 0.6 an S-shaped easing crosses the mark's edge: halfway at 0.5, so that a mark looks as large as it is measured, and wide
//! enough to hide the px (a spot of radius 5 px has these values over about 1 px, one of 20 px over 4).

use super::{Bend, Gradient, Stop};

/// A named constant gradient.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Set {
    /// The animal or material.
    pub name: &'static str,
    /// The stops of its gradient, see [`Gradient::stops`].
    pub stops: [Stop; 4],
    /// The bends between them, see [`Gradient::bends`].
    pub bends: [Bend; 2],
}

/// The default colours of a document's layers: layer k has `BY_LAYER[k % 6]`.
///
/// All have the cheetah's ground: the last layer paints the ground of the whole canvas, and adding a layer must not change it.
/// The marks of different layers differ in lightness first, then in hue.
pub const BY_LAYER: [Set; 6] = [
    // The cheetah's spots: solid, near black, brown in the sun.
    set("cheetah", CREAM, [0x54331d, 0x2a180e]),
    // The reticulated giraffe's patches: liver chestnut.
    set("giraffe", CREAM, [0x9a5a2b, 0x74391a]),
    // The black of a leopard's rosettes.
    set("leopard", CREAM, [0x261e18, 0x120d0a]),
    // The filled centre of a jaguar's rosettes: ochre, darker than its ground.
    set("jaguar", CREAM, [0xc98a3c, 0xa66a22]),
    // A tortoiseshell cat's red.
    set("tortoiseshell", CREAM, [0xb5532a, 0x8c3715]),
    // The genet's washed-out flank spots: smoke.
    set("genet", CREAM, [0x8a7c6c, 0x655849]),
];

/// Whole coats with their own grounds, for documents with one layer.
pub const COATS: [Set; 7] = [
    // Plains zebra: off-white, and black that is brown in the light.
    set("zebra", [0xf7f2e8, 0xeae1d1], [0x2b2320, 0x120e0d]),
    // Bengal tiger: orange back, black stripes.
    set("tiger", [0xeba04e, 0xd8782a], [0x2c1a12, 0x120a08]),
    // Blue poison dart frog: azure with spots of blue-black.
    set("dart frog", [0x3f9be0, 0x1f6fc4], [0x12224d, 0x070d24]),
    // Seven-spot ladybird.
    set("ladybird", [0xd8352a, 0xb81d1a], [0x1f1614, 0x0b0808]),
    // Fallow deer in summer: white spots on chestnut.
    set("fallow deer", [0x8f5528, 0xa4672f], [0xf0e2c8, 0xfcf6e8]),
    // Whale shark: pale spots on slate blue.
    set("whale shark", [0x24404f, 0x32566a], [0xc9dcdc, 0xeff6f2]),
    // Arctic char: pink spots on olive green.
    set("arctic char", [0x47563c, 0x5a6644], [0xe79a84, 0xf6bfa6]),
];

/// The cheetah's ground: cream, tawny towards the spots.
const CREAM: [u32; 2] = [0xf4e3c1, 0xe8cd9a];

pub(super) const fn set(name: &'static str, ground: [u32; 2], mark: [u32; 2]) -> Set {
    let stops = [stop(0.0, ground[0]), stop(0.4, ground[1]), stop(0.6, mark[0]), stop(1.0, mark[1])];
    Set { name, stops, bends: [Bend([0.0, 0.0, 1.0, 1.0]), Bend([0.42, 0.0, 0.58, 1.0])] }
}

const fn stop(at: f32, rgb: u32) -> Stop {
    let [_, red, green, blue] = rgb.to_be_bytes();
    Stop::opaque(at, [red, green, blue])
}

impl Set {
    /// The gradient of the set.
    #[must_use]
    pub fn gradient(&self) -> Gradient {
        Gradient { stops: self.stops.to_vec(), bends: self.bends.to_vec() }
    }
}

impl Gradient {
    /// The default colours of the layer with this index (0 = the first).
    #[must_use]
    pub fn default_for_layer(layer: usize) -> Self {
        BY_LAYER[layer % BY_LAYER.len()].gradient()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Approximate perceived lightness.
    fn lightness([red, green, blue]: [u8; 3]) -> f64 {
        0.2126 * f64::from(red) + 0.7152 * f64::from(green) + 0.0722 * f64::from(blue)
    }

    #[test]
    fn every_set_is_valid_and_has_contrast() {
        for set in BY_LAYER.iter().chain(&COATS) {
            let gradient = set.gradient();
            assert!(gradient.is_valid(), "{}", set.name);
            let [ground, inside] = [0.3, 0.7].map(|v| lightness(gradient.colour(v)));
            assert!((ground - inside).abs() > 40.0, "{}: {ground} against {inside}", set.name);
        }
    }

    #[test]
    fn the_edge_of_a_mark_is_halfway_between_ground_and_mark() {
        for set in BY_LAYER.iter().chain(&COATS) {
            let [_, outside, inside, _] = set.stops;
            let straight = Gradient { stops: vec![outside, inside], bends: vec![] };
            assert_eq!(set.gradient().colour(0.5), straight.colour(0.5), "{}", set.name);
        }
    }

    #[test]
    fn another_layer_does_not_change_the_ground() {
        for layer in 1..12 {
            let [first, later] = [0, layer].map(|k| Gradient::default_for_layer(k).colour(0.0));
            assert_eq!(first, later, "layer {layer}");
            assert_ne!(Gradient::default_for_layer(layer), Gradient::default_for_layer(layer - 1));
        }
    }
}
