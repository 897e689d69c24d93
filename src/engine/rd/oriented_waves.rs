//! Initial waves of stripes on any domain: on a triangle surface they follow the field of directions.
//!
//! C(x) = Σᵢ (1 − r²)² cos(2π (x − xᵢ)·nᵢ/λᵢ + φᵢ) and S(x), the sum of ±sin(…), with r² = (along/A)² + (across/B)², as
//! [`gabor`](super::gabor) sums them on a grid. Here x − xᵢ is the displacement in the tangent plane of xᵢ.
//!
//! Lagae et al., "Procedural noise using sparse Gabor convolution", SIGGRAPH 2009, 2.4 (noise on surfaces).

use std::f64::consts::TAU;

use rand::{Rng, RngExt};
use rayon::prelude::*;

use super::gabor::{Kernels, LEADING};
use super::line_noise::{HEIGHT, Reach, Wavelength, fall};
use super::parameter_field::{ParameterField, Parameters};
use crate::grid::{Domain, Space, atan2, sin_cos_degrees};

/// A straight piece of a line along which a stripe should run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GuideSegment<P> {
    /// Its middle.
    pub middle: P,
    /// Its direction in the frame of the cell there, degrees.
    pub degrees: f64,
    /// Half of its length, cells.
    pub half: f64,
}

/// What the initial concentrations of stripes follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WaveValue {
    /// The height of the noise, of about unit variance.
    Height,
    /// The phase of the noise, −π..π: 0 along a crest, however low the noise is there.
    Phase,
}

/// How stripes of a system begin from waves on any domain.
#[derive(Clone, Copy, Debug)]
pub struct WaveStart {
    /// The kernels of the noise.
    pub kernels: Kernels,
    /// How far the waves follow guide segments.
    pub lead: Reach,
    /// The value that the concentrations follow.
    pub value: WaveValue,
    /// Writes the concentrations of some cells, one slice a chemical, from these values and their parameters.
    pub fill: fn(&mut [&mut [f32]], &[f32], &[Parameters]),
}

/// Shorter waves are taken to be as long, cells: cells do not show them, and the shorter waves are, the more of them there are.
const SHORTEST: f64 = 1.0;
/// A wave ends between these cosines of the angle between the normals of its middle and of a cell: 60° and 37°.
const AWAY: [f64; 2] = [0.5, 0.8];
/// Waves whose cells are found side by side. Not tuned.
const AT_ONCE: usize = 64;

/// The values of the waves of `start`, by cell. They follow the `guides`.
pub fn wave_values<D: Domain>(
    maps: &ParameterField<D>,
    wavelength: Wavelength,
    start: &WaveStart,
    guides: &[GuideSegment<D::Place>],
    rng: &mut impl Rng,
) -> Vec<f32> {
    let waves = random_waves(maps, wavelength, start.kernels, rng);
    let noise = summed(maps, &waves);
    let led = Led::new(maps, wavelength, guides, start.lead);
    // ∫ window² cos² = ½ (π/5) A·B, times density/λ².
    let Kernels { reach: [a, b], density } = start.kernels;
    let deviation = (0.5 * std::f64::consts::PI / 5.0 * a * b * density).sqrt();
    let value = |(cell, [_, cos, sin]): (usize, &[f64; 3])| {
        let (share, [guided_cos, guided_sin]) = led.at(cell);
        let value = match start.value {
            WaveValue::Height => (1.0 - share) * cos / deviation + HEIGHT * guided_cos,
            WaveValue::Phase => {
                atan2((1.0 - share) * sin + LEADING * guided_sin, (1.0 - share) * cos + LEADING * guided_cos)
            }
        };
        value as f32
    };
    noise.par_iter().enumerate().map(value).collect()
}

/// A plane wave about a place, in the frame of the cell there.
struct Wave<P> {
    at: P,
    cell: usize,
    /// The direction across the stripes, degrees, and as a unit vector.
    degrees: f64,
    across: [f64; 2],
    /// Length of the wave, cells.
    length: f64,
    /// How far it reaches, cells.
    far: f64,
    profile: Profile,
}

/// The shape of a wave.
enum Profile {
    /// Of the noise: its reach along and across, cells, and its phase as a share of a wave.
    Kernel { reach: [f64; 2], phase: f64 },
    /// Beside a guide segment of this half length, cells.
    Guide { half: f64, reach: Reach },
}

impl<P: Copy> Wave<P> {
    /// Weight, and weight times the cosine and the sine of the phase, at a displacement; `None` out of reach.
    fn at(&self, [x, y]: [f64; 2]) -> Option<[f64; 3]> {
        let [nx, ny] = self.across;
        let (across, along) = (x * nx + y * ny, x * ny - y * nx);
        let (weight, phase) = match self.profile {
            Profile::Kernel { reach: [a, b], phase } => {
                let window = 1.0 - (along / a) * (along / a) - (across / b) * (across / b);
                (window.max(0.0) * window.max(0.0), phase)
            }
            Profile::Guide { half, reach } => {
                let beyond = (along.abs() - half).max(0.0) / self.length;
                (fall(beyond, reach.beyond) * fall(across.abs() / self.length, reach.across), 0.0)
            }
        };
        let (sin, cos) = sin_cos_degrees(360.0 * (across / self.length + phase));
        (weight > 0.0).then_some([weight, weight * cos, weight * sin])
    }
}

/// By cell, the sums of [`Wave::at`] over the waves within whose reach it lies. The sine of a wave that points to the other side of
/// the stripes counts negative: directions across are axial.
fn summed<D: Domain>(maps: &ParameterField<D>, waves: &[Wave<D::Place>]) -> Vec<[f64; 3]> {
    let domain = &maps.domain;
    let of_wave = |wave: &Wave<D::Place>| {
        let near = domain.near(wave.at, wave.far, 0..domain.cells());
        let value = |(cell, displacement): (usize, [f64; 2])| {
            // Where the surface has turned away, its tangent plane says nothing.
            let faces = ((domain.facing(cell, wave.cell) - AWAY[0]) / (AWAY[1] - AWAY[0])).clamp(0.0, 1.0);
            if faces == 0.0 {
                return None;
            }
            let [weight, cos, sin] = wave.at(displacement)?.map(|value| faces * value);
            let across =
                f64::from(maps.parameters[cell].direction) + 90.0 + domain.transport_angle(cell, wave.cell);
            let same = libm::cos((across - wave.degrees).to_radians()) >= 0.0;
            Some((cell, [weight, cos, if same { sin } else { -sin }]))
        };
        near.filter_map(value).collect::<Vec<_>>()
    };
    let mut sums = vec![[0.0; 3]; domain.cells()];
    for some in waves.chunks(AT_ONCE) {
        // All waves are added in their order, so that the sums do not depend on the number of threads.
        for values in some.par_iter().map(of_wave).collect::<Vec<_>>() {
            for (cell, value) in values {
                sums[cell].iter_mut().zip(value).for_each(|(sum, value)| *sum += value);
            }
        }
    }
    sums
}

/// Waves at random places: as many for each square of their own wavelength.
fn random_waves<D: Domain>(
    maps: &ParameterField<D>,
    wavelength: Wavelength,
    Kernels { reach, density }: Kernels,
    rng: &mut impl Rng,
) -> Vec<Wave<D::Place>> {
    let lengths: Vec<f64> = maps.parameters.par_iter().map(|p| wavelength(p).max(SHORTEST)).collect();
    let [least, longest] = [f64::min as fn(f64, f64) -> f64, f64::max]
        .map(|pick| lengths.iter().copied().reduce(pick).unwrap_or(SHORTEST));
    // Waves are also placed beyond closed edges, so that the noise does not fade there.
    let space = maps.domain.space(reach[0] * longest);
    let throws = (space.points(density) / (least * least)).ceil() as usize;
    let mut waves = Vec::new();
    for _ in 0..throws {
        let at = space.to_domain(space.random(rng));
        let (keep, phase) = (rng.random::<f64>(), rng.random::<f64>());
        let cell = maps.domain.cell_at(at);
        let length = lengths[cell];
        if keep * length * length <= least * least {
            let reach = reach.map(|reach| reach * length);
            let profile = Profile::Kernel { reach, phase };
            waves.push(wave(at, cell, f64::from(maps.parameters[cell].direction), length, reach[0], profile));
        }
    }
    waves
}

/// A wave of stripes that run along `direction`, degrees in the frame of `cell`.
fn wave<P>(at: P, cell: usize, direction: f64, length: f64, far: f64, profile: Profile) -> Wave<P> {
    let degrees = direction + 90.0;
    let (sin, cos) = sin_cos_degrees(degrees);
    Wave { at, cell, degrees, across: [cos, sin], length, far, profile }
}

/// The waves beside guide segments, by cell; empty without any.
struct Led(Vec<[f64; 3]>);

impl Led {
    fn new<D: Domain>(
        maps: &ParameterField<D>,
        wavelength: Wavelength,
        guides: &[GuideSegment<D::Place>],
        reach: Reach,
    ) -> Self {
        if guides.is_empty() {
            return Self(Vec::new());
        }
        let of_guide = |guide: &GuideSegment<D::Place>| {
            let cell = maps.domain.cell_at(guide.middle);
            let length = wavelength(&maps.parameters[cell]).max(SHORTEST);
            let far = guide.half + (reach.beyond[1] + reach.across[1]) * length;
            let profile = Profile::Guide { half: guide.half, reach };
            wave(guide.middle, cell, guide.degrees, length, far, profile)
        };
        let waves: Vec<Wave<D::Place>> = guides.iter().map(of_guide).collect();
        Self(summed(maps, &waves))
    }

    /// The share of the noise that is replaced at a cell, and the cosine and sine that replace it.
    fn at(&self, cell: usize) -> (f64, [f64; 2]) {
        let [weight, cos, sin] = self.0.get(cell).copied().unwrap_or_default();
        (weight.min(1.0), [cos, sin].map(|part| part / weight.max(1.0)))
    }
}

/// Waves that run outwards from places to which `away` is the distance of each cell, cells: cos 2π d/λ.
#[must_use]
pub fn waves_from<D: Domain>(maps: &ParameterField<D>, wavelength: Wavelength, away: &[f64]) -> Vec<f32> {
    let value = |(p, away): (&Parameters, &f64)| {
        let turns = away / wavelength(p).max(SHORTEST);
        if turns.is_finite() { libm::cos(TAU * turns) as f32 } else { 0.0 }
    };
    maps.parameters.par_iter().zip(away).map(value).collect()
}
