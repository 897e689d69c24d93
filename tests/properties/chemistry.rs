//! Concentrations stay finite and non-negative for all answers of `learn` and for any other parameters; the verdict
//! finds a value that is not finite.

use crate::cases;
use dapple_engine::attributes::{Attributes, Spots, Stripes};
use dapple_engine::grid::{Edges, Field};
use dapple_engine::learn;
use dapple_engine::measure::{Reason, check_formed};
use dapple_engine::rd::{Growth, ParameterField, Parameters, System};
use dapple_engine::synth::Training;
use proptest::prelude::*;
use std::sync::LazyLock;

static TRAINING: LazyLock<Training> = LazyLock::new(Training::default);

/// Usual concentrations of the ground, and at the centre of a mark.
const USUAL: [f32; 2] = [0.0, 1.0];

fn cell_parameters(p: &learn::Parameters, pitch: f32) -> Parameters {
    Parameters {
        rate: p.rate as f32,
        ratio: p.ratio.unwrap_or(1.0) as f32,
        stretch: p.stretch as f32,
        direction: p.direction as f32,
        pitch,
    }
}

fn edges() -> impl Strategy<Value = Edges> {
    prop::sample::select(vec![Edges::Closed, Edges::Wrap])
}

/// A strategy for powers of ten with exponents in this range.
fn power(range: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    range.prop_map(|x| libm::pow(10.0, x))
}

/// Questions about a system, in cells: far beyond its training rows.
fn question(system: System) -> BoxedStrategy<Attributes> {
    let spacing = prop::option::of(power(-1.0..3.0));
    if system.is_striped() {
        (power(-2.0..4.0), 0.0..180.0, spacing)
            .prop_map(|(width, angle, wavelength)| Attributes::Stripes(Stripes { width, angle, wavelength }))
            .boxed()
    } else {
        (power(-1.0..5.0), 0.01..=1.0, 0.0..180.0, spacing)
            .prop_map(|(area, aspect, angle, spacing)| {
                Attributes::Spots(Spots { area, aspect, angle, spacing })
            })
            .boxed()
    }
}

fn asked() -> impl Strategy<Value = (System, Attributes)> {
    prop::sample::select(System::ALL.to_vec())
        .prop_flat_map(|system| question(system).prop_map(move |wanted| (system, wanted)))
}

/// Whether all concentrations are finite and non-negative.
fn sound(growth: &Growth) -> bool {
    growth.concentrations().iter().flatten().all(|value| value.is_finite() && *value >= 0.0)
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn concentrations_stay_finite_and_non_negative_for_any_answer(
        (system, wanted) in asked(),
        edges in edges(),
        [nx, ny] in [8..48_usize, 8..48_usize],
        seed in any::<u64>(),
    ) {
        let answer = TRAINING.set(system).unwrap().ask(&learn::InCells(wanted)).unwrap();
        let maps = ParameterField::uniform([nx, ny], edges, cell_parameters(&answer.parameters, answer.pitch as f32));
        let mut growth = Growth::new(system, &maps, seed);
        prop_assert!(sound(&growth), "at the beginning");
        for _ in 0..8 {
            growth.advance(100);
            prop_assert!(sound(&growth), "after {} steps of {:?}", growth.steps(), answer.parameters);
        }
    }
}

/// Arbitrary parameters: (system, parameters of a cell).
fn any_parameters() -> impl Strategy<Value = (System, Parameters)> {
    (
        prop::sample::select(System::ALL.to_vec()),
        // Cells: from marks that are too small for a grid to marks larger than it.
        power(0.0..2.0),
        power(-4.0..4.0),
        power(-2.0..0.0),
        -1e3..1e3_f64,
        power(-1.0..1.0),
    )
        .prop_map(|(system, spacing, ratio, stretch, direction, pitch)| {
            let unit = learn::Parameters { rate: 1.0, ratio: Some(ratio), stretch, direction, level: None };
            let own = system.spacing(&cell_parameters(&unit, pitch as f32)) / spacing;
            (system, cell_parameters(&learn::Parameters { rate: own * own, ..unit }, pitch as f32))
        })
}

proptest! {
    #![proptest_config(cases(60))]

    #[test]
    fn concentrations_stay_finite_and_non_negative_for_any_parameters(
        (system, p) in any_parameters(),
        edges in edges(),
        [nx, ny] in [4..24_usize, 4..24_usize],
        seed in any::<u64>(),
    ) {
        let mut growth = Growth::new(system, &ParameterField::uniform([nx, ny], edges, p), seed);
        for _ in 0..4 {
            growth.advance(50);
            prop_assert!(sound(&growth), "after {} steps of {:?}", growth.steps(), p);
        }
    }

    #[test]
    fn one_value_that_is_not_finite_is_reported_by_the_verdict(
        values in prop::collection::vec(0.0..=1.0_f32, 16..400),
        bad in prop::sample::select(vec![f32::NAN, f32::INFINITY, f32::NEG_INFINITY]),
        place in any::<prop::sample::Index>(),
    ) {
        let (width, place) = (values.len(), place.index(values.len()));
        let mut field = Field { width, height: 1, cell: [1.0, 1.0], edges: Edges::Wrap, values };
        prop_assert!(check_formed(&field, USUAL) != Err(Reason::NotFinite));
        field.values[place] = bad;
        prop_assert_eq!(check_formed(&field, USUAL), Err(Reason::NotFinite));
    }
}
