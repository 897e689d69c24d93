//! The verdict on grown patterns: those that are not a texture are rejected with the right reason.

use dapple_engine::grid::{Edges, Field, Grid};
use dapple_engine::learn::Parameters;
use dapple_engine::measure::{self, Reason};
use dapple_engine::rd::{self, ParameterField, System};
use dapple_engine::synth::{Engine, ProbePatch, Sample, Watch};

/// The number of spots (or of wavelengths along a side) that is asked for, and the least number for a training row.
const ORDERED: f64 = 24.0;
const LEAST: f64 = 20.0;

const SPOTS: Parameters =
    Parameters { rate: 4.0, ratio: Some(12.0), stretch: 1.0, direction: 30.0, level: Some(0.5) };
const STRIPES: Parameters =
    Parameters { rate: 45.0, ratio: None, stretch: 0.5, direction: 30.0, level: None };

fn patch(system: System, parameters: Parameters) -> ProbePatch {
    ProbePatch { system, parameters, extent: ORDERED, seed: 5 }
}

/// Grows a patch to the end and judges it.
fn judged(patch: ProbePatch) -> Result<Sample, Reason> {
    let (marks, settled) = patch.grow(&Watch::NONE).unwrap();
    patch.judge(&marks, settled, LEAST)
}

#[track_caller]
fn rejected(patch: ProbePatch, kind: &str) -> Reason {
    let reason = judged(patch).expect_err("this is no texture");
    assert_eq!(reason.kind(), kind, "{reason}");
    assert!(Reason::KINDS.contains(&reason.kind()));
    reason
}

#[test]
fn well_grown_patches_are_accepted() {
    for stretch in [1.0, 0.4] {
        let spots = Parameters { stretch, ..SPOTS };
        judged(patch(System::MEINHARDT_SPOTS, spots)).unwrap();
        let turing = Parameters { rate: 0.1, ratio: Some(3.8), level: Some(0.35), ..spots };
        judged(patch(System::TURING_SPOTS, turing)).unwrap();
    }
    judged(patch(System::MEINHARDT_STRIPES, STRIPES)).unwrap();
}

#[test]
fn spots_whose_inhibitor_reaches_too_little_do_not_form() {
    rejected(patch(System::MEINHARDT_SPOTS, Parameters { ratio: Some(6.0), ..SPOTS }), "no-pattern");
}

#[test]
fn spots_read_at_too_low_a_level_touch() {
    let low = Parameters { level: Some(0.06), ..SPOTS };
    rejected(patch(System::MEINHARDT_SPOTS, low), "touching");
}

#[test]
fn stripes_are_not_accepted_as_spots_nor_spots_as_stripes() {
    let stripes = patch(System::MEINHARDT_STRIPES, STRIPES);
    let (marks, settled) = stripes.grow(&Watch::NONE).unwrap();
    let spots = patch(System::MEINHARDT_SPOTS, SPOTS);
    assert_eq!(spots.judge(&marks, settled, LEAST).unwrap_err().kind(), "touching");
    let (marks, settled) = spots.grow(&Watch::NONE).unwrap();
    assert!(stripes.judge(&marks, settled, LEAST).is_err());
}

#[test]
fn spots_that_are_slightly_too_dense_merge() {
    rejected(patch(System::MEINHARDT_SPOTS, Parameters { ratio: Some(8.0), ..SPOTS }), "touching");
}

#[test]
fn stripes_that_lost_their_direction_are_a_labyrinth() {
    // With 1.3 cells per stripe, the grid determines the direction of the stripes.
    let reason =
        rejected(patch(System::MEINHARDT_STRIPES, Parameters { rate: 1000.0, ..STRIPES }), "touching");
    assert!(matches!(reason, Reason::NoDirection { .. }), "{reason}");
}

#[test]
fn a_patch_that_is_too_small_holds_too_few_marks() {
    let spots = ProbePatch { extent: 12.0, ..patch(System::MEINHARDT_SPOTS, SPOTS) };
    let reason = rejected(spots, "too-few");
    assert_eq!(reason, Reason::TooFew { marks: 12, least: 20 });
    let message = reason.to_string();
    assert!(["12", "20"].iter().all(|number| message.contains(number)), "{message}");
    let stripes = ProbePatch { extent: 6.0, ..patch(System::MEINHARDT_STRIPES, STRIPES) };
    rejected(stripes, "too-few");
}

#[test]
fn spots_of_a_few_cells_are_too_small_for_the_grid() {
    rejected(patch(System::MEINHARDT_SPOTS, Parameters { rate: 40.0, ..SPOTS }), "too-small");
}

#[test]
fn spots_under_rates_that_vary_are_too_irregular() {
    let [nx, ny] = [160, 160];
    let output = |rate: f32| rd::Parameters { rate, ratio: 12.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
    let parameters = (0..nx * ny).map(|cell| {
        let across = (cell % nx) as f32 / nx as f32;
        output(2.0 + 8.0 * (2.0 * across - 1.0).abs())
    });
    let maps = ParameterField::new(Grid::unit([nx, ny], Edges::Wrap), parameters.collect());
    let mut engine = Engine::from_maps(System::MEINHARDT_SPOTS, maps, 5);
    assert!(engine.settle(&Watch::NONE).unwrap());
    let verdict = patch(System::MEINHARDT_SPOTS, SPOTS).judge(&engine.marks(), true, LEAST);
    assert_eq!(verdict.unwrap_err().kind(), "irregular");
}

#[test]
fn diverged_concentrations_are_reported() {
    // Spots of half a cell: in a cell without b nothing consumes a.
    let turing = Parameters { rate: 10.0, ratio: Some(3.8), level: Some(0.35), ..SPOTS };
    rejected(patch(System::TURING_SPOTS, turing), "left-range");
    // NaN is reported, too.
    let spots = patch(System::MEINHARDT_SPOTS, SPOTS);
    let (mut marks, settled) = spots.grow(&Watch::NONE).unwrap();
    marks.values[100] = f32::NAN;
    assert_eq!(spots.judge(&marks, settled, LEAST), Err(Reason::NotFinite));
    assert_eq!(Reason::NotFinite.kind(), "left-range");
}

#[test]
fn a_growth_stopped_early_is_unsettled() {
    let spots = patch(System::MEINHARDT_SPOTS, SPOTS);
    let side = spots.side();
    let output = rd::Parameters { rate: 4.0, ratio: 12.0, stretch: 1.0, direction: 30.0, pitch: 1.0 };
    let maps = ParameterField::uniform([side, side], Edges::Wrap, output);
    let mut engine = Engine::from_maps(System::MEINHARDT_SPOTS, maps, 5);
    engine.advance((side * side) as u64 * 20);
    assert!(engine.growing());
    assert_eq!(spots.judge(&engine.marks(), engine.settled(), LEAST), Err(Reason::Unsettled));
    // A diverged pattern is reported as diverged, not as unsettled.
    let high = Field::flat(side, side, Edges::Wrap, 9.0);
    assert_eq!(spots.judge(&high, false, LEAST).unwrap_err().kind(), "left-range");
    assert!(measure::check_formed(&engine.marks(), [0.0, 1.0]).is_ok());
}
