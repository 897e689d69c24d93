//! The named choices of a document.

use crate::document::Seeding;
use crate::marks::Mark;

/// The kind of a layer's marks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Spots.
    Ellipse,
    /// Stripes.
    Line,
}

impl From<&Mark> for Kind {
    fn from(mark: &Mark) -> Self {
        match mark {
            Mark::Ellipse(_) => Self::Ellipse,
            Mark::Line(_) | Mark::Path(_) => Self::Line,
        }
    }
}

impl Kind {
    /// The kind of a layer whose strokes are of these `kinds`: ellipses, where there are any. Lines beside them part cells.
    #[must_use]
    pub fn of_layer(kinds: impl IntoIterator<Item = Self>) -> Option<Self> {
        kinds.into_iter().reduce(|kind, other| if other == Self::Ellipse { other } else { kind })
    }

    /// Its name in a document.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Ellipse => "ellipse",
            Self::Line => "line",
        }
    }
}

/// What stripes begin from, with its names in documents.
pub const SEEDINGS: [(&str, Seeding); 3] =
    [("noise", Seeding::Noise), ("segments", Seeding::Segments), ("initiators", Seeding::Initiators)];

/// Which threads of a weave lie over the others where they cross, by the numbers i and j of the two threads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Over {
    /// Neither: all are as high.
    #[default]
    Level,
    /// One over, one under: i + j is even.
    Plain,
    /// Two over, one under: i + j is no multiple of three less one.
    Twill21,
    /// Two over, two under.
    Twill22,
    /// Random.
    Random,
}

impl Over {
    /// All choices with their names in documents.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("level", Self::Level),
        ("plain", Self::Plain),
        ("twill-2/1", Self::Twill21),
        ("twill-2/2", Self::Twill22),
        ("random", Self::Random),
    ];
}

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
