//! The system that is requested for a layer.

use crate::attributes::system::{Description, Family, LookupBy};
use crate::document::systems::SYSTEMS;
use crate::document::{AreaKind, Kind, LineKind};
use crate::rd::System;
use crate::rd::pairs::PairKind;

/// The system that is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SystemChoice {
    /// The one that reaches the marks' attributes best: lines → stripes, ellipses → spots.
    #[default]
    Auto,
    /// Chosen like [`Self::Auto`], but lines that cross stay stripes.
    Stripes,
    /// A particular one of [`SYSTEMS`].
    Of(&'static Description),
}

impl SystemChoice {
    /// All choices with their names in documents and on the command line.
    #[must_use]
    pub fn names() -> Vec<(&'static str, Self)> {
        let open = [Self::Auto, Self::Stripes].into_iter();
        open.chain(SYSTEMS.iter().copied().map(Self::Of)).map(|choice| (choice.name(), choice)).collect()
    }

    /// The choice of this name.
    ///
    /// ```
    /// use dapple_engine::document::SystemChoice;
    ///
    /// let spots = SystemChoice::named("meinhardt-spots").unwrap();
    /// assert_eq!(spots.name(), "meinhardt-spots");
    /// assert!(SystemChoice::named("unknown").is_none());
    /// ```
    #[must_use]
    pub fn named(name: &str) -> Option<Self> {
        Self::names().into_iter().find(|(of, _)| *of == name).map(|(_, choice)| choice)
    }

    /// The description of the system; `None` for the choices that leave the system open.
    #[must_use]
    pub const fn description(self) -> Option<&'static Description> {
        if let Self::Of(system) = self { Some(system) } else { None }
    }

    /// The family of the system; `None` for the choices that leave the system open.
    #[must_use]
    pub fn kind(self) -> Option<Family> {
        self.description().map(|system| system.kind)
    }

    /// The system that training rows are looked up for; `None` for the choices that leave the system open, systems of pairs, and
    /// systems of scattered points.
    #[must_use]
    pub fn system(self) -> Option<System> {
        let system = self.description().filter(|system| matches!(system.lookup, LookupBy::Rows))?;
        System::named(system.name)
    }

    /// The system that grows stripes where the user names none: one that grows any wavelength if a duty or a wavelength is given
    /// (`has_duty`), otherwise one whose wavelength follows from the width. `None` if there is no such system.
    #[must_use]
    pub fn system_of_stripes(has_duty: bool) -> Option<System> {
        System::first(|system| system.is_striped() && system.free_spacing == has_duty)
    }

    /// The choice, with [`Self::Stripes`] replaced by the [`Self::system_of_stripes`].
    #[must_use]
    pub fn with_stripes_chosen(self, has_duty: bool) -> Self {
        match (self, Self::system_of_stripes(has_duty)) {
            (Self::Stripes, Some(system)) => Self::Of(system.description()),
            _ => self,
        }
    }

    /// The system of pairs, if it is one.
    #[must_use]
    pub fn pairs(self) -> Option<PairKind> {
        PairKind::of(self.description()?)
    }

    /// The kind of areas that it grows, if any.
    #[must_use]
    pub fn areas(self) -> Option<AreaKind> {
        AreaKind::of(self.description()?)
    }

    /// The kind of lines that it grows from points, if any.
    #[must_use]
    pub fn lines(self) -> Option<LineKind> {
        LineKind::of(self.description()?)
    }

    /// Whether lines may lie beside the ellipses of a layer.
    #[must_use]
    pub fn takes_lines_beside(self) -> bool {
        self.is_known(|system| system.lines_beside.is_some())
    }

    /// Whether the system is chosen and has this property.
    #[must_use]
    pub fn is_known(self, property: impl FnOnce(&Description) -> bool) -> bool {
        self.description().is_some_and(property)
    }

    /// Whether a system with this property can be chosen; [`Self::Auto`] can choose any.
    #[must_use]
    pub fn allows(self, property: impl Fn(&Description) -> bool) -> bool {
        match self {
            Self::Auto => true,
            Self::Stripes => {
                System::ALL.iter().any(|system| system.is_striped() && property(system.description()))
            }
            Self::Of(system) => property(system),
        }
    }

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::Stripes => "stripes",
            Self::Of(system) => system.name,
        }
    }

    /// Its name in the window.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Auto => "Automatic",
            Self::Stripes => "Stripes",
            Self::Of(system) => system.title,
        }
    }

    /// What it grows, in one sentence.
    #[must_use]
    pub const fn help(self) -> &'static str {
        match self {
            Self::Auto => {
                "The system that matches the drawn marks best: lines grow stripes, lines that cross grow a weave, \
                 ellipses grow spots, outlines and dense ellipses grow patches or cells"
            }
            Self::Stripes => {
                "Stripes of the system that matches the drawn lines best, also where lines cross"
            }
            Self::Of(system) => system.help,
        }
    }

    /// A small picture of the pattern that it grows, as a PNG; empty where the system is open.
    #[must_use]
    pub const fn picture(self) -> &'static [u8] {
        match self {
            Self::Auto => &[],
            Self::Stripes => crate::attributes::system::picture!("stripes"),
            Self::Of(system) => system.picture,
        }
    }

    /// The kind of marks that it grows; `None` = the layer's own.
    #[must_use]
    pub fn grows(self) -> Option<Kind> {
        match self {
            Self::Auto => None,
            Self::Stripes => Some(Kind::Line),
            Self::Of(system) if system.either_marks => None,
            Self::Of(system) => Some(if system.is_striped() { Kind::Line } else { Kind::Ellipse }),
        }
    }
}
