//! Parameters → field: reaction and diffusion.

mod coefficients;
mod compensate;
mod decay_noise;
mod diffusion;
mod explicit;
mod gabor;
mod growth;
mod initial_conditions;
mod kinetics;
mod line_noise;
mod local_warp;
mod maps;
mod nuclei;
mod plane;
mod problem;
mod prolongation;
mod runs;
mod seeding;
pub mod selling;
mod shepard;
mod simd_step;
mod solver;
mod systems;
mod vector;
mod wavefront;

pub use growth::Growth;
pub use initial_conditions::{InitialConditions, initial_marks, nuclei, with_obstacle_state};
pub use line_noise::GuideLine;
pub use local_warp::LocalWarp;
pub use maps::{GuideCurves, Maps, Parameters};
pub use nuclei::{Hindrance, PinnedSpot, Places, adjust_to_walls, placeable, relax_places};
pub use prolongation::prolongate;
pub use seeding::Seeding;
pub use shepard::interpolate_parameters;
pub use solver::Solver;
pub use wavefront::{Instructions, Tiling};

use systems::{meinhardt_lines, meinhardt_spots, meinhardt_stripes, turing_spots};

/// The reaction-diffusion systems.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum System {
    /// Two chemicals; packed spots of any size.
    TuringSpots,
    /// Two chemicals; spots of any size and any spacing.
    MeinhardtSpots,
    /// Five chemicals; stripes.
    MeinhardtStripes,
    /// Two chemicals; thin stripes on wide ground.
    MeinhardtLines,
}

impl System {
    /// The decay constant that scales normalised time (`facts.md` 0): T = decay · rate · time.
    fn decay(self) -> f32 {
        match self {
            Self::TuringSpots => 1.0,
            Self::MeinhardtSpots | Self::MeinhardtLines => meinhardt_spots::P2,
            Self::MeinhardtStripes => meinhardt_stripes::K_AB,
        }
    }

    /// The largest dt·s at which the reactions alone stay stable (`facts.md` A, B, C).
    fn reaction_limit(self) -> f32 {
        match self {
            Self::TuringSpots => 0.045,
            Self::MeinhardtSpots | Self::MeinhardtLines => 1.0,
            Self::MeinhardtStripes => 4.0,
        }
    }
}

impl System {
    /// All of them.
    pub const ALL: [Self; 4] =
        [Self::TuringSpots, Self::MeinhardtSpots, Self::MeinhardtStripes, Self::MeinhardtLines];

    /// What its chemicals are called in its equations, in the order of [`Growth::concentrations`].
    #[must_use]
    pub fn chemicals(self) -> &'static [&'static str] {
        if self == Self::MeinhardtStripes { &["a", "b", "c", "d", "e"] } else { &["a", "b"] }
    }

    /// Does it grow stripes, and not spots?
    #[must_use]
    pub fn is_striped(self) -> bool {
        matches!(self, Self::MeinhardtStripes | Self::MeinhardtLines)
    }

    /// Concentrations of obstacle cells: they keep marks away.
    fn obstacle_state(self) -> &'static [f32] {
        match self {
            Self::TuringSpots => &turing_spots::OBSTACLE,
            Self::MeinhardtSpots => &meinhardt_spots::OBSTACLE,
            Self::MeinhardtStripes => &meinhardt_stripes::OBSTACLE,
            Self::MeinhardtLines => &meinhardt_lines::OBSTACLE,
        }
    }

    /// The name in documents and of the training set.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::TuringSpots => "turing-spots",
            Self::MeinhardtSpots => "meinhardt-spots",
            Self::MeinhardtStripes => "meinhardt-stripes",
            Self::MeinhardtLines => "meinhardt-lines",
        }
    }

    /// Cells that a spot covers at half its peak, or the squared width of a stripe: how finely the grid shows it.
    #[must_use]
    pub fn cells(self, p: &Parameters) -> f64 {
        let rate = f64::from(p.rate);
        match self {
            Self::TuringSpots => turing_spots::AREA / rate,
            Self::MeinhardtSpots => meinhardt_spots::area(p.ratio) / rate,
            Self::MeinhardtStripes => {
                0.25 * meinhardt_stripes::WAVELENGTH * meinhardt_stripes::WAVELENGTH / rate
            }
            Self::MeinhardtLines => {
                let width = meinhardt_lines::width(p.ratio);
                width * width / rate
            }
        }
    }

    /// Distance at which spots begin, or the wavelength of stripes, cells.
    #[must_use]
    pub fn spacing(self, p: &Parameters) -> f64 {
        let own = match self {
            Self::TuringSpots => turing_spots::SPACING,
            Self::MeinhardtSpots => meinhardt_spots::spacing(p.ratio),
            Self::MeinhardtStripes => meinhardt_stripes::WAVELENGTH,
            Self::MeinhardtLines => meinhardt_lines::wavelength(p.ratio),
        };
        f64::from(p.pitch) * own / f64::from(p.rate).sqrt()
    }
}
