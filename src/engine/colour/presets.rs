//! Colours to choose from, by animal and by material.
//!
//! Each preset has a source, which is shown with it. No coat was measured: the animals' colours were chosen by eye from
//! descriptions of their coats. Bare metals have measured reflectances.

use super::sets::{BY_LAYER, COATS, Set, set};

/// A colour set to choose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preset {
    /// Its name and colours.
    pub set: Set,
    /// Its group.
    pub group: Group,
    /// The usual kind of marks, for its thumbnail.
    pub marking: Marking,
    /// The source of its colours.
    pub source: &'static str,
}

/// A group of presets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Coats, skins, wings.
    Animal,
    /// Metal, stone, wood, clay.
    Material,
}

/// Spots or stripes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marking {
    /// Spots.
    Spots,
    /// Stripes.
    Stripes,
}

use Group::{Animal, Material};
use Marking::{Spots, Stripes};

const fn animal(set: Set, marking: Marking, source: &'static str) -> Preset {
    Preset { set, group: Animal, marking, source }
}

const fn material(
    name: &'static str,
    ground: [u32; 2],
    mark: [u32; 2],
    marking: Marking,
    source: &'static str,
) -> Preset {
    Preset { set: set(name, ground, mark), group: Material, marking, source }
}

/// All of them, the animals first.
pub const PRESETS: [Preset; 27] = [
    animal(
        BY_LAYER[0],
        Spots,
        "By eye: solid, nearly black spots on cream to tawny (Acinonyx jubatus). Not measured.",
    ),
    animal(
        BY_LAYER[2],
        Spots,
        "By eye: black of the rosettes on cream to tawny (Panthera pardus). Not measured.",
    ),
    animal(BY_LAYER[3], Spots, "By eye: ochre inside the rosettes, on cream (Panthera onca). Not measured."),
    animal(BY_LAYER[1], Spots, "By eye: liver-chestnut patches on cream (Giraffa reticulata). Not measured."),
    animal(BY_LAYER[4], Spots, "By eye: the red of a tortoiseshell cat, on cream. Not measured."),
    animal(BY_LAYER[5], Spots, "By eye: smoky flank spots on cream (Genetta genetta). Not measured."),
    animal(
        COATS[0],
        Stripes,
        "By eye: off-white, and black that is brown in the light (Equus quagga). Not measured.",
    ),
    animal(COATS[1], Stripes, "By eye: orange back, black stripes (Panthera tigris). Not measured."),
    animal(
        COATS[2],
        Spots,
        "By eye: azure with blue-black spots (Dendrobates tinctorius \"azureus\"). Not measured.",
    ),
    animal(
        COATS[3],
        Spots,
        "By eye: black spots on red wing cases (Coccinella septempunctata). Not measured.",
    ),
    animal(COATS[4], Spots, "By eye: white spots on chestnut, summer coat (Dama dama). Not measured."),
    animal(COATS[5], Spots, "By eye: pale spots on slate blue (Rhincodon typus). Not measured."),
    animal(COATS[6], Spots, "By eye: pink spots on olive green (Salvelinus alpinus). Not measured."),
    animal(
        set("angelfish", [0x1f3f8f, 0x2350a8], [0xe8c53a, 0xf6e07a]),
        Stripes,
        "By eye: yellow stripes on blue (emperor angelfish, Pomacanthus imperator). Not measured.",
    ),
    material("copper", [0xfad1c2, 0xe9a98d], [0x6a9c86, 0x4f8f7c], Spots, COPPER),
    material("gold", [0x2a2320, 0x1d1816], [0xe8b95a, 0xffdb91], Stripes, GOLD),
    material("silver", [0xfaf7f2, 0xd9d4cb], [0x6a6258, 0x3c3732], Spots, SILVER),
    material("iron", [0xc4c7c7, 0xa3a09b], [0x9a4f24, 0x6e3014], Spots, IRON),
    material(
        "marble",
        [0xf4f2ee, 0xe4e1dc],
        [0x9b9ca0, 0x74767c],
        Stripes,
        "By eye: grey veins in white marble. Not measured.",
    ),
    material(
        "malachite",
        [0x0f6b4f, 0x1b8a63],
        [0x6cc79a, 0xa9e2c0],
        Stripes,
        "By eye: light and dark green bands. Not measured.",
    ),
    material(
        "lapis",
        [0x1d3f94, 0x26509f],
        [0xc9a75a, 0xe3cc8c],
        Spots,
        "By eye: lapis lazuli with specks of pyrite. Not measured.",
    ),
    material(
        "agate",
        [0xe9d3b8, 0xd9a877],
        [0xa34f2a, 0x74301a],
        Stripes,
        "By eye: banded carnelian agate. Not measured.",
    ),
    material(
        "oak",
        [0xd9b98a, 0xc79d66],
        [0x9a6b3c, 0x7a4f28],
        Stripes,
        "By eye: early and late wood of oak. Not measured.",
    ),
    material(
        "birch",
        [0xf1ede4, 0xdfd8cb],
        [0x4a423b, 0x2a2521],
        Stripes,
        "By eye: bark with dark lenticels. Not measured.",
    ),
    material(
        "terracotta",
        [0xcf7d52, 0xc06b42],
        [0x5a2c1d, 0x43201a],
        Stripes,
        "By eye: dark slip on fired clay. Not measured.",
    ),
    material(
        "delft",
        [0xf3f5f4, 0xdbe3ea],
        [0x34559c, 0x1c3a7c],
        Spots,
        "By eye: cobalt on white tin glaze. Not measured.",
    ),
    material(
        "leather",
        [0x8a5230, 0x75431f],
        [0x4a2814, 0x34190c],
        Spots,
        "By eye: grain of tanned cowhide. Not measured.",
    ),
];

const COPPER: &str = "The bare metal: its reflectance at normal incidence, sRGB 0.98, 0.82, 0.76 (N. Hoffman, Physically-Based \
                      Shading, SIGGRAPH 2010 course, table 1). Its shade and the verdigris: by eye.";
const GOLD: &str = "The brightest: the reflectance of gold at normal incidence, sRGB 1.00, 0.86, 0.57 (N. Hoffman, \
                    Physically-Based Shading, SIGGRAPH 2010 course, table 1). Its shade and the black lacquer: by eye.";
const SILVER: &str = "The bare metal: its reflectance at normal incidence, sRGB 0.98, 0.97, 0.95 (N. Hoffman, Physically-Based \
                      Shading, SIGGRAPH 2010 course, table 1). The tarnish: by eye.";
const IRON: &str = "The bare metal: its reflectance at normal incidence, sRGB 0.77, 0.78, 0.78 (N. Hoffman, Physically-Based \
                    Shading, SIGGRAPH 2010 course, table 1). The rust: by eye.";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_is_valid_and_has_its_own_name_and_a_source() {
        for (index, preset) in PRESETS.iter().enumerate() {
            assert!(preset.set.gradient().is_valid(), "{}", preset.set.name);
            assert!(preset.source.ends_with('.') && preset.source.len() > 30, "{}", preset.set.name);
            let twin = PRESETS[..index].iter().any(|other| other.set.name == preset.set.name);
            assert!(!twin, "{} is there twice", preset.set.name);
        }
    }

    #[test]
    fn bare_metals_have_the_reflectances_that_are_quoted() {
        let quoted = [
            ("copper", 0, [0.98, 0.82, 0.76]),
            ("gold", 3, [1.00, 0.86, 0.57]),
            ("silver", 0, [0.98, 0.97, 0.95]),
            ("iron", 0, [0.77, 0.78, 0.78]),
        ];
        for (name, stop, reflectance) in quoted {
            let preset = PRESETS.iter().find(|preset| preset.set.name == name).unwrap();
            let expected = reflectance.map(|channel: f64| (255.0 * channel).round() as u8);
            assert_eq!(preset.set.stops[stop].colour, expected, "{name}");
            for channel in reflectance {
                assert!(preset.source.contains(&format!("{channel:.2}")), "{name}: {}", preset.source);
            }
        }
    }

    #[test]
    fn a_source_says_whether_colours_were_measured() {
        for preset in PRESETS {
            let honest = preset.source.contains("Not measured") ^ preset.source.contains("SIGGRAPH");
            assert!(honest, "{}: {}", preset.set.name, preset.source);
        }
    }
}
