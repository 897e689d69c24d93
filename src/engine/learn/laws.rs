//! Rows computed from the laws of scale instead of simulations, so that the regression is tested against known values.
//! Noise as measured on patches of 60 spots.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;

use super::{InCells, Parameters, Row};
use crate::attributes::columns::{self, Column};
use crate::attributes::system::{
    Crowding, Description, Intervals, IsolatedSpots, MarkKind, Scaling, TrainingFile,
};
use crate::attributes::{Attributes, Spots, Stripes};
use crate::marks::axial;

/// Descriptions of systems for tests, similar to those of the program; `learn` may not import `rd`.
const fn system(
    name: &'static str,
    marks: MarkKind,
    columns: &'static [Column],
    training: &'static [TrainingFile],
) -> Description {
    Description {
        name,
        title: name,
        marks,
        free_spacing: true,
        columns,
        training,
        scaling: Scaling { ratio: 1.0, level: 2.85 },
        ..Description::PLAIN
    }
}

macro_rules! file {
    ($name:literal) => {
        TrainingFile { name: $name, rows: include_bytes!(concat!(env!("OUT_DIR"), "/", $name, ".rows")) }
    };
}

/// Spots whose spacing follows from their size.
pub(super) static TURING: Description = Description {
    free_spacing: false,
    ..system(
        "turing-spots",
        MarkKind::Spots,
        &columns::SPOTS,
        &[file!("turing-spots-narrow"), file!("turing-spots-orientation"), file!("turing-spots-size")],
    )
};
/// Spots of any spacing, also isolated ones.
pub(super) static MEINHARDT: Description = Description {
    isolated: Some(ISOLATED),
    ..system(
        "meinhardt-spots",
        MarkKind::Spots,
        &columns::SPOTS,
        &[
            file!("meinhardt-spots-narrow"),
            file!("meinhardt-spots-orientation"),
            file!("meinhardt-spots-size"),
        ],
    )
};
/// Stripes as wide as their gaps.
pub(super) static STRIPES: Description = Description {
    free_spacing: false,
    ..system(
        "meinhardt-stripes",
        MarkKind::Stripes,
        &columns::STRIPES,
        &[file!("meinhardt-stripes-orientation"), file!("meinhardt-stripes-width")],
    )
};
/// Stripes of any wavelength.
pub(super) static LINES: Description = Description {
    scaling: Scaling { ratio: 0.74, level: 0.0 },
    ..system("meinhardt-lines", MarkKind::Stripes, &columns::LINES, &[file!("meinhardt-lines")])
};
/// All of them.
pub(super) static SYSTEMS: [&Description; 4] = [&TURING, &MEINHARDT, &STRIPES, &LINES];

/// A law of isolated spots in round numbers, similar to that of Meinhardt's spots.
pub(super) const ISOLATED: IsolatedSpots = IsolatedSpots {
    ratio: 15.0,
    highest_level: 0.5,
    lowest_level: 0.25,
    area: 200.0,
    foot: 1.0,
    crowding: Crowding { c: 0.4, a: 1.3, b: 1.5 },
    spacing: 36.0,
    round: 1.0,
    by_stretch: -0.02,
    alone: 1.6,
    merging: 1.0,
    intervals: Intervals { area: 0.01, aspect: 0.01, angle: 1.0, spacing: 0.03 },
};

/// Scatter of area (relative), spacing (relative), aspect, angle (degrees, at aspect 0.5).
#[derive(Clone, Copy)]
pub(super) struct Noise(pub f64, pub f64, pub f64, pub f64);

/// No scatter: the laws themselves.
pub(super) const EXACT: Noise = Noise(0.0, 0.0, 0.0, 0.0);
/// The scatter of Meinhardt spots.
pub(super) const MEASURED: Noise = Noise(0.01, 0.015, 0.004, 0.3);

/// area·rate of Turing spots: 5.7, less for small ones (facts A).
pub(super) fn turing_law(area: f64) -> f64 {
    6.0 * (1.0 - 2.2 / area)
}

/// The area that a law area·rate = k(area) gives, by fixed point.
pub(super) fn area_of(rate: f64, law: impl Fn(f64) -> f64) -> f64 {
    (0..60).fold(50.0, |area: f64, _| law(area.max(3.0)) / rate)
}

/// area·rate of Meinhardt spots with Db/Da = `ratio` (facts B: 215 at 10, 127 at 15, 44 at 50, at rate s/g).
pub(super) fn meinhardt_law(area: f64, ratio: f64) -> f64 {
    127.0 * libm::pow(ratio / 15.0, -1.0) * (1.0 - 1.2 / area)
}

/// area/spacing² of Meinhardt spots (facts B: 0.150 at 10, 0.094 at 15, 0.029 at 50).
pub(super) fn meinhardt_density(ratio: f64) -> f64 {
    0.094 * libm::pow(ratio / 15.0, -1.0)
}

/// The angle measured for a direction: the grid pulls it towards the axes, more for small spots.
pub(super) fn pulled(direction: f64, area: f64) -> f64 {
    axial(direction - 40.0 / area * libm::sin((4.0 * direction).to_radians()))
}

fn uniform(rng: &mut Pcg64, low: f64, high: f64) -> f64 {
    low + (high - low) * rng.random::<f64>()
}

/// A sum of uniforms with standard deviation 1: near enough to normal.
fn scatter(rng: &mut Pcg64) -> f64 {
    (0..12).map(|_| rng.random::<f64>()).sum::<f64>() - 6.0
}

/// `n` rows of a Turing set: ratio and level constant, aspect never above 0.88.
pub(super) fn turing(n: u64, Noise(by_area, by_spacing, by_aspect, by_angle): Noise) -> Vec<Row> {
    (0..n)
        .map(|seed| {
            let rng = &mut Pcg64::seed_from_u64(seed);
            let rate = libm::exp(uniform(rng, libm::log(0.03), libm::log(0.3)));
            let (stretch, direction) = (uniform(rng, 0.3, 1.0), uniform(rng, 0.0, 180.0));
            let area = area_of(rate, turing_law);
            let spacing = 2.1 * area.sqrt();
            let (w, floor) = (libm::log(stretch), libm::log(0.88));
            let aspect = libm::exp(-(w * w + floor * floor).sqrt());
            Row {
                seed,
                extent: 60.0,
                evenness: 0.05,
                attributes: InCells(Attributes::Spots(Spots {
                    area: area * (1.0 + by_area * scatter(rng)),
                    aspect: aspect * (1.0 + by_aspect * scatter(rng)),
                    // The mean direction of a patch of isotropic spots is random.
                    angle: axial(pulled(direction, area) + by_angle * scatter(rng) / (1.03 - stretch)),
                    spacing: Some(spacing * (1.0 + by_spacing * scatter(rng))),
                })),
                parameters: Parameters { rate, ratio: Some(1.0 / 3.8), stretch, direction, level: Some(0.5) },
            }
        })
        .collect()
}

/// `n` rows of a Meinhardt set: the ratio from 10 to 100.
pub(super) fn meinhardt(n: u64, Noise(by_area, by_spacing, by_aspect, by_angle): Noise) -> Vec<Row> {
    (0..n)
        .map(|seed| {
            let rng = &mut Pcg64::seed_from_u64(1_000_000 + seed);
            let ratio = libm::exp(uniform(rng, libm::log(10.0), libm::log(100.0)));
            let wanted = libm::exp(uniform(rng, libm::log(20.0), libm::log(200.0)));
            let rate = meinhardt_law(wanted, ratio) / wanted;
            let (stretch, direction) = (uniform(rng, 0.3, 1.0), uniform(rng, 0.0, 180.0));
            let area = area_of(rate, |area| meinhardt_law(area, ratio));
            let spacing = (area / meinhardt_density(ratio)).sqrt();
            Row {
                seed,
                extent: 60.0,
                evenness: 0.05,
                attributes: InCells(Attributes::Spots(Spots {
                    area: area * (1.0 + by_area * scatter(rng)),
                    aspect: (0.99 * stretch * (1.0 + by_aspect * scatter(rng))).min(1.0),
                    angle: axial(pulled(direction, 4.0 * area) + by_angle * scatter(rng)),
                    spacing: Some(spacing * (1.0 + by_spacing * scatter(rng))),
                })),
                parameters: Parameters { rate, ratio: Some(ratio), stretch, direction, level: Some(0.5) },
            }
        })
        .collect()
}

/// Factor of the size of Meinhardt spots at this level (facts B: 1.5 at 0.35, 2.5 at 0.2).
pub(super) fn size_by_level(level: f64) -> f64 {
    libm::exp(2.8 * (0.5 - level))
}

/// `n` rows of a Meinhardt set in which high densities are reached by the level: of ten rows seven have ratios from 12 at
/// level 0.5, three have the ratio 12 at levels from 0.27.
pub(super) fn meinhardt_by_level(n: u64, noise: Noise) -> Vec<Row> {
    let mut rows = meinhardt(n, noise);
    for row in &mut rows {
        let rng = &mut Pcg64::seed_from_u64(3_000_000 + row.seed);
        let level = if row.seed % 10 < 3 { uniform(rng, 0.27, 0.5) } else { 0.5 };
        let (InCells(Attributes::Spots(spots)), Some(old)) = (&mut row.attributes, row.parameters.ratio)
        else {
            continue;
        };
        let ratio = if level < 0.5 { 12.0 } else { old.max(12.0) };
        // The same area in cells at another ratio and level: rate and spacing follow.
        row.parameters.rate *= old / ratio * size_by_level(level);
        spots.spacing = spots.spacing.map(|spacing| spacing * (ratio / old / size_by_level(level)).sqrt());
        row.parameters.ratio = Some(ratio);
        row.parameters.level = Some(level);
    }
    rows
}

/// width²·rate of stripes (facts C: wavelength 81·√Da at kab 0.04, so (40.5)²·0.04 = 65.6, less when thin).
pub(super) fn stripe_law(width: f64) -> f64 {
    65.6 * (1.0 - 1.5 / (width * width))
}

/// `n` rows of a stripe set: stretch constant, widths 3 to 20.
pub(super) fn stripes(n: u64, Noise(by_width, _, _, by_angle): Noise) -> Vec<Row> {
    (0..n)
        .map(|seed| {
            let rng = &mut Pcg64::seed_from_u64(2_000_000 + seed);
            let width = libm::exp(uniform(rng, libm::log(3.0), libm::log(20.0)));
            let direction = uniform(rng, 0.0, 180.0);
            Row {
                seed,
                extent: 10.0,
                evenness: 0.95,
                attributes: InCells(Attributes::Stripes(Stripes {
                    width: width * (1.0 + by_width * scatter(rng)),
                    angle: axial(pulled(direction, 3.0 * width) + by_angle * scatter(rng)),
                    wavelength: None,
                })),
                parameters: Parameters {
                    rate: stripe_law(width) / (width * width),
                    ratio: None,
                    stretch: 0.5,
                    direction,
                    level: None,
                },
            }
        })
        .collect()
}

/// Stripe ÷ period of lines, by Db/Da.
pub(super) fn line_duty(ratio: f64) -> f64 {
    0.5 * libm::pow(ratio / 10.3, -0.93)
}

/// `n` rows of a set of lines: stretch constant, widths 3 to 9, ratios 10.3 to 30.
pub(super) fn lines(n: u64, Noise(by_width, by_wavelength, _, by_angle): Noise) -> Vec<Row> {
    let mut rows = stripes(n, Noise(by_width, by_wavelength, 0.0, by_angle));
    for row in &mut rows {
        let rng = &mut Pcg64::seed_from_u64(4_000_000 + row.seed);
        let ratio = uniform(rng, 10.3, 30.0);
        let InCells(Attributes::Stripes(stripes)) = &mut row.attributes else { continue };
        stripes.wavelength = Some(stripes.width / line_duty(ratio) * (1.0 + by_wavelength * scatter(rng)));
        row.parameters.rate *= libm::pow(ratio / 10.3, -0.7);
        row.parameters.ratio = Some(ratio);
    }
    rows
}
