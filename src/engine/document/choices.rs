//! The named choices of a document.

use crate::attributes::system::Description;
use crate::document::{AreaKind, LineKind, Seeding};
use crate::marks::Mark;
use crate::points::fields::POINTS;
use crate::rd::System;
use crate::rd::pairs::PairKind;

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
    /// That of a layer whose strokes are of these `kinds`: of ellipses, where there are any. Lines beside them part cells.
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

/// The reaction-diffusion system that is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SystemChoice {
    /// The one that reaches the marks' attributes best: lines → stripes, ellipses → spots.
    #[default]
    Auto,
    /// As [`Self::Auto`], but lines that cross stay stripes.
    Stripes,
    /// This one.
    Of(System),
    /// A system of pairs of morphogens.
    Pairs(PairKind),
    /// Patches or cells.
    Areas(AreaKind),
    /// Streaks or cracks.
    Lines(LineKind),
    /// A field of points.
    Points,
    /// Turing's system with a growth that varies.
    Growth,
}

impl SystemChoice {
    /// How many there are: `auto`, `stripes`, `points` and `turing-growth` beside the systems of several kinds.
    const COUNT: usize =
        4 + System::ALL.len() + PairKind::ALL.len() + AreaKind::ALL.len() + LineKind::ALL.len();

    /// All of them with their names in documents and on the command line.
    pub const NAMES: [(&'static str, Self); Self::COUNT] = {
        const SYSTEMS: usize = System::ALL.len();
        const GENERAL: usize = 2;
        const AREAS: usize = GENERAL + SYSTEMS + PairKind::ALL.len();
        let mut names = [("auto", Self::Auto); Self::COUNT];
        names[1] = ("stripes", Self::Stripes);
        names[Self::COUNT - 2] = (POINTS.name, Self::Points);
        names[Self::COUNT - 1] = (System::with_growth().name(), Self::Growth);
        let mut index = 0;
        while index < SYSTEMS {
            let system = System::ALL[index];
            names[GENERAL + index] = (system.name(), Self::Of(system));
            index += 1;
        }
        let mut index = 0;
        while index < PairKind::ALL.len() {
            let kind = PairKind::ALL[index];
            names[GENERAL + SYSTEMS + index] = (kind.description().name, Self::Pairs(kind));
            index += 1;
        }
        let mut index = 0;
        while index < AreaKind::ALL.len() {
            let kind = AreaKind::ALL[index];
            names[AREAS + index] = (kind.description().name, Self::Areas(kind));
            index += 1;
        }
        let mut index = 0;
        while index < LineKind::ALL.len() {
            let kind = LineKind::ALL[index];
            names[AREAS + AreaKind::ALL.len() + index] = (kind.description().name, Self::Lines(kind));
            index += 1;
        }
        names
    };

    /// The system that training rows are looked up for; `None` of those that leave it open, systems of pairs, and
    /// what scattered points make.
    #[must_use]
    pub fn system(self) -> Option<System> {
        if let Self::Of(system) = self { Some(system) } else { None }
    }

    /// The system of pairs.
    #[must_use]
    pub fn pairs(self) -> Option<PairKind> {
        if let Self::Pairs(kind) = self { Some(kind) } else { None }
    }

    /// What is known of the system; `None` of those that leave it open.
    #[must_use]
    pub fn description(self) -> Option<&'static Description> {
        match self {
            Self::Auto | Self::Stripes => None,
            Self::Of(system) => Some(system.description()),
            Self::Pairs(kind) => Some(kind.description()),
            Self::Areas(kind) => Some(kind.description()),
            Self::Lines(kind) => Some(kind.description()),
            Self::Points => Some(&POINTS),
            Self::Growth => Some(System::with_growth().description()),
        }
    }

    /// Whether lines may lie beside the ellipses of a layer: those that part cells.
    #[must_use]
    pub fn takes_lines_beside(self) -> bool {
        self == Self::Areas(AreaKind::Cells)
    }

    /// Whether the system is chosen and has this property.
    #[must_use]
    pub fn is_known(self, property: impl FnOnce(&Description) -> bool) -> bool {
        self.description().is_some_and(property)
    }

    /// Whether a system with this property can be taken: any can with [`Self::Auto`].
    #[must_use]
    pub fn allows(self, property: impl Fn(&Description) -> bool) -> bool {
        match self {
            Self::Stripes => {
                System::ALL.iter().any(|system| system.is_striped() && property(system.description()))
            }
            _ => self.description().is_none_or(property),
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Stripes => "stripes",
            _ => self.description().map_or("auto", |system| system.name),
        }
    }

    /// The kind of marks that it grows; `None` = the layer's own.
    #[must_use]
    pub fn grows(self) -> Option<Kind> {
        match self {
            Self::Stripes => Some(Kind::Line),
            // Blotches and worms are as wide as marks of either kind.
            Self::Pairs(PairKind::Stucco) | Self::Growth => None,
            _ => {
                self.description().map(|system| if system.is_striped() { Kind::Line } else { Kind::Ellipse })
            }
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
    /// As it comes.
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
