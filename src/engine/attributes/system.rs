//! What is known of a system without its equations: its name, the attributes that it answers to, the
//! options that it takes, what it refuses, its training rows. The file of each system fills it in; `learn`, `document` and
//! the window read it.

use std::fmt;
use std::hash::{Hash, Hasher};

use super::Attribute;
use super::columns::{Column, SEED};
use super::coordinates::Coordinates;

/// The kind of marks that a system grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// Spots, drawn as ellipses.
    Spots,
    /// Stripes, drawn as lines.
    Stripes,
}

/// What a system grows a layer of, and so which part of the program grows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Spots or stripes of one reaction-diffusion system, whose parameters are looked up in training rows.
    Marks,
    /// Marks of several pairs of morphogens.
    Pairs,
    /// Marks with outlines of their own, each with its place.
    Areas,
    /// Lines of scattered points.
    Lines,
    /// A field of scattered points.
    Points,
    /// The pattern of a reaction whose growth varies over the canvas.
    Growth,
}

impl Family {
    /// Whether its marks follow from scattered places instead of a reaction that covers the canvas.
    #[must_use]
    pub const fn is_scattered(self) -> bool {
        matches!(self, Self::Areas | Self::Lines | Self::Points)
    }
}

/// How parameters are found for the attributes that are asked of a system.
#[derive(Clone, Copy, Debug)]
pub enum LookupBy {
    /// In training rows, each of one simulation.
    Rows,
    /// By a law, and by training rows that say in these coordinates how far it is off.
    Pairs(&'static Coordinates),
    /// By a law in closed form.
    Law,
    /// The attributes cannot be asked for.
    Nothing,
}

/// Keys of a layer, such as `options.gap`, `maps.area` or `points`, with one reason for all of them: a sentence without
/// its full stop.
#[derive(Clone, Copy, Debug)]
pub struct Keys {
    /// The keys, as they stand in documents.
    pub keys: &'static [&'static str],
    /// The reason.
    pub reason: &'static str,
}

/// A system as the rest of the program sees it. Two are equal where their names are.
#[derive(Clone, Copy)]
pub struct Description {
    /// Its name in documents, on the command line and of its training files.
    pub name: &'static str,
    /// Its name in the window.
    pub title: &'static str,
    /// Its name within a sentence.
    pub noun: &'static str,
    /// What it grows, in one sentence.
    pub help: &'static str,
    /// A small picture of what it grows, as a PNG; empty where there is none.
    pub picture: &'static [u8],
    /// What changes where it replaces the other system of its kind, in one sentence; `None` where it is no alternative.
    pub alternative: Option<&'static str>,
    /// What it grows a layer of.
    pub kind: Family,
    /// What it grows.
    pub marks: MarkKind,
    /// Whether it takes drawn marks of either kind, since it needs their width alone.
    pub either_marks: bool,
    /// Whether its marks have a direction.
    pub directed: bool,
    /// Whether it grows where nothing is drawn.
    pub grows_blank: bool,
    /// Why lines may be drawn beside its ellipses, and beside those of other systems not; `None` where they may not.
    pub lines_beside: Option<&'static str>,
    /// Why it grows the lowest layer alone; `None` where it grows any.
    pub lowest_alone: Option<&'static str>,
    /// Whether the distance of its marks (spacing of spots, wavelength of stripes) can be asked for. Otherwise it follows
    /// from their size.
    pub free_spacing: bool,
    /// Whether its spots can be irregular (option `irregular`).
    pub irregular: bool,
    /// Whether its stripes can begin from other seeds than noise (option `seeding`).
    pub seeding: bool,
    /// Whether its spots stand where they begin and nowhere else, as a layer `inside` another needs it.
    pub fixed_places: bool,
    /// Whether its lines stand along the curves that they begin along, as the layers `around` and `net` need it.
    pub along_curves: bool,
    /// Whether a picture can drive it: its marks can be cut at any level, and so have any share of their distance.
    pub tone: bool,
    /// The keys that a layer's `options` may have with it.
    pub option_keys: &'static [&'static str],
    /// Keys that no layer has but one with this system or another that lists them here; automatic has none of them.
    pub own_keys: &'static [Keys],
    /// Keys that it refuses, though layers of its kind of marks have them.
    pub refused_keys: &'static [Keys],
    /// How parameters are found for it.
    pub lookup: LookupBy,
    /// How far what it grows may be off after all corrections, as `learn` checks: median and 95th percentile, %, by
    /// attribute. Only of systems of pairs.
    pub grown_errors: &'static [(Attribute, [f64; 2])],
    /// The columns of its training files, after the seed.
    pub columns: &'static [Column],
    /// The training files that are compiled in.
    pub training: &'static [TrainingFile],
    /// The numbers of neighbours that cross validation chooses for the regressions of these files, in the order of
    /// `learn`; empty = chosen when they are read, which takes half of the time of the first lookup.
    pub neighbours: &'static [usize],
    /// How sizes scale with parameters.
    pub scaling: Scaling,
    /// The law of spots without neighbours; `None` where spots do not stand alone.
    pub isolated: Option<IsolatedSpots>,
}

impl Description {
    /// A system of spots without a name, of which nothing can be asked: each description says what differs.
    pub const PLAIN: Self = Self {
        name: "",
        title: "",
        noun: "",
        help: "",
        picture: &[],
        alternative: None,
        kind: Family::Marks,
        marks: MarkKind::Spots,
        either_marks: false,
        directed: true,
        grows_blank: false,
        lines_beside: None,
        lowest_alone: None,
        free_spacing: false,
        irregular: false,
        seeding: false,
        fixed_places: false,
        along_curves: false,
        tone: false,
        option_keys: &[],
        own_keys: &[],
        refused_keys: &[],
        lookup: LookupBy::Nothing,
        grown_errors: &[],
        columns: &[],
        training: &[],
        neighbours: &[],
        scaling: Scaling { ratio: 0.0, level: 0.0 },
        isolated: None,
    };

    /// All columns of its training files, the seed first.
    pub fn all_columns(&self) -> impl Iterator<Item = &'static Column> + use<> {
        std::iter::once(&SEED).chain(self.columns)
    }

    /// Whether it grows stripes, not spots.
    #[must_use]
    pub const fn is_striped(&self) -> bool {
        matches!(self.marks, MarkKind::Stripes)
    }

    /// The coordinates in which its training rows are learnt; `None` where it is no system of pairs with such rows.
    #[must_use]
    pub const fn coordinates(&self) -> Option<&'static Coordinates> {
        if let LookupBy::Pairs(coordinates) = self.lookup { Some(coordinates) } else { None }
    }

    /// Whether a layer has this key with it and with few other systems.
    #[must_use]
    pub fn owns(&self, key: &str) -> bool {
        self.own_keys.iter().any(|own| own.keys.contains(&key))
    }
}

impl PartialEq for Description {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Description {}

impl Hash for Description {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl fmt::Debug for Description {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// The small picture of what the system of this name grows.
#[cfg(not(feature = "late-assets"))]
macro_rules! picture {
    ($name:literal) => {
        include_bytes!(concat!(env!("OUT_DIR"), "/", $name, ".png"))
    };
}
/// None: the program loads it.
#[cfg(feature = "late-assets")]
macro_rules! picture {
    ($name:literal) => {
        &[]
    };
}
pub(crate) use picture;

/// A training file that is compiled in.
#[derive(Debug)]
pub struct TrainingFile {
    /// Its name, without `.csv`.
    pub name: &'static str,
    /// Its rows, as `build.rs` writes them.
    pub rows: &'static [u8],
}

/// Exponents of the laws of scale: size² · rate = K · e^(`level` · (l₀ − level)) ÷ ratio^`ratio`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scaling {
    /// By how much ln size² falls from ln ratio to ln ratio.
    pub ratio: f64,
    /// By how much ln area falls from level to level.
    pub level: f64,
}

/// The law of spots that stand too far apart to feel each other: see `learn::isolated_spots` for its formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IsolatedSpots {
    /// R, the ratio at which they are grown.
    pub ratio: f64,
    /// The highest level at which they are read.
    pub highest_level: f64,
    /// The lowest.
    pub lowest_level: f64,
    /// K: area · rate at level ½.
    pub area: f64,
    /// k: the exponent of the level.
    pub foot: f64,
    /// How neighbours shrink them.
    pub crowding: Crowding,
    /// S: the system's own distance of places × √rate.
    pub spacing: f64,
    /// d₁: spacing ÷ distance of the places, of round spots.
    pub round: f64,
    /// d₂: how much more it is for each (ln aspect)².
    pub by_stretch: f64,
    /// The pitch from which on a spot counts as alone.
    pub alone: f64,
    /// The pitch below which neighbours merge.
    pub merging: f64,
    /// Half widths of the 90 % intervals.
    pub intervals: Intervals,
}

/// How neighbours at q pitches more than 1 shrink a spot: by the share c · e^(−a·q − b·q²) of its area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crowding {
    /// The share at pitch 1.
    pub c: f64,
    /// How fast it falls at first.
    pub a: f64,
    /// How fast it falls farther away.
    pub b: f64,
}

/// Half widths of 90 % intervals of spots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intervals {
    /// Of the area, relative.
    pub area: f64,
    /// Of the aspect, relative.
    pub aspect: f64,
    /// Of the spacing, relative.
    pub spacing: f64,
    /// Of the angle, degrees.
    pub angle: f64,
}
