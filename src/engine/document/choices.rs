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
    /// The kind of a layer with strokes of these `kinds`: ellipses if there is any. Lines beside ellipses are the lines between
    /// cells.
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

/// The initial states of stripes, with their names in documents.
pub const SEEDINGS: [(&str, Seeding); 3] =
    [("noise", Seeding::Noise), ("segments", Seeding::Segments), ("initiators", Seeding::Initiators)];

/// Rule that tells which threads of a weave lie over the others where they cross, by the numbers i and j of the two threads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Over {
    /// All threads have the same height.
    #[default]
    Level,
    /// Plain weave, one over, one under: over where i + j is even.
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

/// Position of the marks of a layer relative to the marks beneath.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum After {
    /// The layer keeps away from them, as on a cheetah.
    #[default]
    Between,
    /// The layer keeps away from them, and is the rarer the farther away from them it is, like the specks at the edges of a cow's patches.
    Near,
    /// The layer rings them, like a leopard's rosettes.
    Around,
    /// The layer fills the space between them with a connected web, as on a giraffe.
    Net,
    /// The layer grows a smaller mark at the place of each mark beneath, which is not shown itself.
    Inside,
}

impl After {
    /// All choices with their names in documents.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("between", Self::Between),
        ("near", Self::Near),
        ("around", Self::Around),
        ("net", Self::Net),
        ("inside", Self::Inside),
    ];

    /// Whether it grows in the space that the marks beneath leave, at places of its own.
    #[must_use]
    pub fn keeps_away(self) -> bool {
        matches!(self, Self::Between | Self::Near)
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        name_in(&Self::NAMES, self)
    }

    /// The kind of marks that it grows; `None` = the layer's own.
    #[must_use]
    pub fn grows(self) -> Option<Kind> {
        match self {
            Self::Between | Self::Near => None,
            Self::Around | Self::Net => Some(Kind::Line),
            Self::Inside => Some(Kind::Ellipse),
        }
    }
}

/// All these names.
pub(super) fn names<T>(choices: &[(&'static str, T)]) -> Vec<&'static str> {
    choices.iter().map(|(name, _)| *name).collect()
}

/// The name of `one` among these.
pub fn name_in<T: Copy + PartialEq>(names: &[(&'static str, T)], one: T) -> &'static str {
    names.iter().find(|(_, other)| *other == one).map_or("", |(name, _)| name)
}
