//! The named choices of a document.

use crate::document::Seeding;

/// The kind of a layer's marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Spots.
    Ellipse,
    /// Stripes.
    Line,
}

impl Kind {
    /// Its name in a document.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ellipse => "ellipse",
            Self::Line => "line",
        }
    }
}

/// The reaction-diffusion system that is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SystemChoice {
    /// The one that reaches the marks' attributes best: lines → stripes, ellipses → spots.
    #[default]
    Auto,
    /// Turing's spots.
    TuringSpots,
    /// Meinhardt's spots.
    MeinhardtSpots,
    /// Meinhardt's stripes.
    MeinhardtStripes,
    /// Meinhardt's lines: thin stripes on wide ground.
    MeinhardtLines,
}

impl SystemChoice {
    /// All choices with their names in documents and on the command line.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("auto", Self::Auto),
        ("turing-spots", Self::TuringSpots),
        ("meinhardt-spots", Self::MeinhardtSpots),
        ("meinhardt-stripes", Self::MeinhardtStripes),
        ("meinhardt-lines", Self::MeinhardtLines),
    ];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_in(&Self::NAMES, self)
    }

    /// The kind of marks that it grows; `None` = the layer's own.
    #[must_use]
    pub fn grows(self) -> Option<Kind> {
        match self {
            Self::Auto => None,
            Self::TuringSpots | Self::MeinhardtSpots => Some(Kind::Ellipse),
            Self::MeinhardtStripes | Self::MeinhardtLines => Some(Kind::Line),
        }
    }

    /// The keys of `options` that it takes.
    #[must_use]
    pub fn option_keys(self) -> &'static [&'static str] {
        match self {
            Self::Auto => &["spread", "keep", "duty", "irregular", "seeding"],
            Self::TuringSpots | Self::MeinhardtSpots => &["spread", "keep", "irregular"],
            Self::MeinhardtStripes => &["keep", "duty", "seeding"],
            Self::MeinhardtLines => &["keep", "duty"],
        }
    }
}

/// What stripes begin from, with its names in documents.
pub const SEEDINGS: [(&str, Seeding); 3] =
    [("noise", Seeding::Noise), ("segments", Seeding::Segments), ("initiators", Seeding::Initiators)];

/// How a layer meets the marks of the layers beneath it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum After {
    /// It keeps away from them, as on a cheetah.
    #[default]
    Between,
    /// It rings them, as a leopard's rosettes.
    Around,
    /// It fills the space between them with a connected web, as on a giraffe.
    Net,
    /// A smaller mark at each place of the layer beneath, which itself is not shown.
    Inside,
}

impl After {
    /// All choices with their names in documents.
    pub const NAMES: [(&'static str, Self); 4] =
        [("between", Self::Between), ("around", Self::Around), ("net", Self::Net), ("inside", Self::Inside)];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_in(&Self::NAMES, self)
    }

    /// The kind of marks that it grows; `None` = the layer's own.
    #[must_use]
    pub fn grows(self) -> Option<Kind> {
        match self {
            Self::Between => None,
            Self::Around | Self::Net => Some(Kind::Line),
            Self::Inside => Some(Kind::Ellipse),
        }
    }
}

/// The name of `one` among these.
pub fn name_in<T: Copy + PartialEq>(names: &[(&'static str, T)], one: T) -> &'static str {
    names.iter().find(|(_, other)| *other == one).map_or("", |(name, _)| name)
}
