//! What is known of a reaction-diffusion system without its equations: its name, the attributes that it answers to, the
//! options that it takes, its training rows. The file of each system fills it in; `learn` and
//! `document` read it.

use super::columns::{Column, SEED};

/// The kind of marks that a system grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// Spots, drawn as ellipses.
    Spots,
    /// Stripes, drawn as lines.
    Stripes,
}

/// A reaction-diffusion system as the rest of the program sees it.
#[derive(Debug)]
pub struct Description {
    /// Its name in documents, on the command line and of its training files.
    pub name: &'static str,
    /// Its name in the window.
    pub title: &'static str,
    /// What it grows, in one sentence.
    pub help: &'static str,
    /// What changes where it replaces the other system of its kind, in one sentence; `None` where it is no alternative.
    pub alternative: Option<&'static str>,
    /// What it grows.
    pub marks: MarkKind,
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
    /// All columns of its training files, the seed first.
    pub fn all_columns(&self) -> impl Iterator<Item = &'static Column> + use<> {
        std::iter::once(&SEED).chain(self.columns)
    }

    /// Does it grow stripes, not spots?
    #[must_use]
    pub const fn is_striped(&self) -> bool {
        matches!(self.marks, MarkKind::Stripes)
    }
}

/// A training file that is compiled in.
#[derive(Debug)]
pub struct TrainingFile {
    /// Its name, without `.csv`.
    pub name: &'static str,
    /// Its rows, as `training/compile.rs` writes them.
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
    /// Highest and lowest level at which they are read.
    pub levels: [f64; 2],
    /// K: area · rate at level ½.
    pub area: f64,
    /// k: the exponent of the level.
    pub foot: f64,
    /// c, a, b: how neighbours shrink them.
    pub crowding: [f64; 3],
    /// S: the system's own distance of places × √rate.
    pub spacing: f64,
    /// d₁, d₂: spacing ÷ distance of the places.
    pub edges: [f64; 2],
    /// Pitches from which a spot counts as alone, and below which neighbours merge.
    pub pitches: [f64; 2],
    /// Half widths of the 90 % intervals.
    pub intervals: Intervals,
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
