//! The kinds of finishes, and what each one's size means.

/// A material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Short or long hair.
    Fur,
    /// Overlapping round scales.
    FishScales,
    /// Keeled scales side by side.
    ReptileScales,
    /// Granular skin.
    Skin,
    /// Dyed leather.
    Leather,
    /// Cloth in plain weave.
    Cloth,
    /// Cloth in twill weave.
    Twill,
    /// Ink on paper.
    Ink,
    /// Halftone print.
    Print,
}

impl Kind {
    /// Their names in documents.
    pub const NAMES: [(&'static str, Self); 9] = [
        ("fur", Self::Fur),
        ("fish-scales", Self::FishScales),
        ("reptile-scales", Self::ReptileScales),
        ("skin", Self::Skin),
        ("leather", Self::Leather),
        ("cloth", Self::Cloth),
        ("twill", Self::Twill),
        ("ink", Self::Ink),
        ("print", Self::Print),
    ];

    /// Its name in documents.
    #[must_use]
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(_, kind)| *kind == self).map_or("", |(name, _)| name)
    }

    /// What [`Finish::size`] is the size of.
    #[must_use]
    pub fn measure(self) -> &'static str {
        match self {
            Self::Fur => "mean length of a hair",
            Self::FishScales | Self::ReptileScales => "width of a scale",
            Self::Skin | Self::Leather => "width of a grain",
            Self::Cloth | Self::Twill => "distance between two threads",
            Self::Ink => "length of the fibres of the paper",
            Self::Print => "distance between two dots of a screen",
        }
    }

    /// The size of a finish that states none, px of the document.
    #[must_use]
    pub fn usual_size(self) -> f64 {
        match self {
            Self::Fur | Self::Skin | Self::Ink => 10.0,
            Self::FishScales => 14.0,
            Self::ReptileScales => 16.0,
            Self::Leather => 9.0,
            Self::Cloth => 6.0,
            Self::Twill | Self::Print => 5.0,
        }
    }

    /// The usual height of the marks above the ground, px of the document: marks are the colour of hairs, scales, threads or ink and
    /// no higher than these; in skin they rise a little, and those of leather are embossed.
    #[must_use]
    pub fn relief(self) -> f64 {
        match self {
            Self::Leather => 6.0,
            Self::Skin => 1.0,
            Self::Fur | Self::FishScales | Self::ReptileScales => 0.0,
            Self::Cloth | Self::Twill | Self::Ink | Self::Print => 0.0,
        }
    }

    /// Factor of its tone, so that a gray picture keeps its mean: gaps between hairs, threads and scales, and what lies in the shade,
    /// make it darker by as much: measured at the usual sizes on a tile of 256 × 256 px. Ink and print mix colours with the paper and keep
    /// theirs.
    #[must_use]
    pub(super) fn exposure(self) -> f32 {
        match self {
            Self::Fur => 1.24,
            Self::FishScales => 1.07,
            Self::ReptileScales => 1.29,
            Self::Skin => 1.21,
            Self::Leather => 1.1,
            Self::Cloth => 1.38,
            Self::Twill => 1.34,
            Self::Ink | Self::Print => 1.0,
        }
    }

    /// Whether it can be on the surface of a model.
    ///
    /// # Errors
    /// It cannot: the reason.
    pub fn on_models(self) -> Result<(), &'static str> {
        match self {
            Self::Fur | Self::FishScales | Self::ReptileScales => Ok(()),
            Self::Skin | Self::Leather | Self::Ink => Ok(()),
            Self::Cloth | Self::Twill => {
                Err("its threads cross on a lattice, which no closed surface has without a seam")
            }
            Self::Print => Err("its dots lie on lattices, which no closed surface has without a seam"),
        }
    }

    /// How far its reflections are stretched across the flow, of 255; `None` if they have no direction. Of hair .7 of the most, which was
    /// not compared in a renderer.
    #[must_use]
    pub fn stretch(self) -> Option<u8> {
        (self == Self::Fur).then_some(180)
    }

    /// Whether the flow of a document changes it.
    #[must_use]
    pub fn has_flow(self) -> bool {
        matches!(self, Self::Fur | Self::FishScales | Self::ReptileScales)
    }
}

/// The finish of a texture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// The material.
    pub kind: Kind,
    /// The size of its parts, px of the document: what [`Kind::measure`] says.
    pub size: f64,
    /// Standard deviation of its tone, as a share of it, [`Self::MOTTLING`].
    pub mottle: f64,
}

impl Finish {
    /// The least and the greatest size, px.
    pub const SIZES: [f64; 2] = [2.0, 64.0];

    /// The least and the greatest mottling.
    pub const MOTTLING: [f64; 2] = [0.0, 0.3];

    /// A finish of the usual size, without mottling.
    #[must_use]
    pub fn new(kind: Kind) -> Self {
        Self { kind, size: kind.usual_size(), mottle: 0.0 }
    }
}
