//! Plans of fields of points → what grows.

use rayon::prelude::*;

use crate::grid::{Domain, Field};
use crate::points::fields::PointField;
use crate::points::level::{level_of_share_beside, relevel_smoothly};
use crate::synth::grow::areas::AreaPattern;
use crate::synth::grow::layer::GrowError;
use crate::synth::grow::point_fields::GrownPoints;
use crate::synth::grow::snapshot::FILM_STAGES;
use crate::synth::phases::{Phase, during};
use crate::synth::plan::point_fields::FieldPlan;
use crate::synth::watch::{Stage, Watch};

/// The level of the edge.
const EDGE: f32 = 0.5;
/// What is not told apart from flat.
const FLAT: f32 = 1e-4;

/// Times that the level is set: each takes away what the share shown was off.
const ROUNDS: usize = 4;
/// A share that is right within this needs no other round.
const CLOSE: f64 = 2e-4;
/// A grid of fewer cells is looked at between them, too.
const FEW: usize = 300_000;
/// Rows that are looked at together.
const ROWS: usize = 32;

/// Grows layer number `layer` (1 = the lowest) as planned. Where it is `filmed`, `seen` gets the field as its points appear.
pub(super) fn grow_points(
    plan: FieldPlan,
    layer: usize,
    seed: u64,
    watch: &Watch,
    filmed: bool,
    seen: &mut dyn FnMut(&FieldPlan, &Field, u64),
) -> Result<GrownPoints, GrowError> {
    watch.step(Stage::Plan, 1.0)?;
    if !plan.obstacles.is_empty() && plan.obstacles.iter().all(|taken| *taken) {
        return Err(GrowError::NoRoom { layer });
    }
    let blocked = during(Phase::LayOut, || plan.blocked());
    let is_blocked = |at: [f64; 2]| {
        let cell = plan.grid.cell_at(plan.grid.to_cells(plan.canvas().inside(at)));
        blocked.get(cell).is_some_and(|taken| *taken)
    };
    let distance = |at: [f64; 2]| plan.distance(at);
    let dark = |at: [f64; 2]| plan.dark(at);
    let points = PointField {
        grid: plan.grid,
        distance: &distance,
        distances: plan.distances,
        labelling: plan.labelling(&dark),
        nearest: plan.is_sharp(),
        axis: plan.points.axis,
        strength: plan.points.shift,
        shift: plan.shift(),
        octaves: plan.points.octaves,
        fold: plan.points.fold,
        blocked: if blocked.is_empty() { None } else { Some(&is_blocked) },
        seed,
    };
    watch.step(Stage::Grow, 0.0)?;
    let mut stage = 0;
    let mut each = |field: &Field| {
        stage += 1;
        seen(&plan, field, stage);
    };
    let (mut field, count) =
        during(Phase::Steps, || points.grow(if filmed { FILM_STAGES } else { 1 }, &mut each));
    let [low, high] =
        field.values.iter().fold([1.0f32, 0.0], |[low, high], value| [low.min(*value), high.max(*value)]);
    if high - low < FLAT {
        return Err(GrowError::Flat { layer });
    }
    watch.step(Stage::Refine, 0.0)?;
    let share = during(Phase::Measure, || match plan.share {
        Some(wanted) => levelled(&mut field, wanted, &plan.obstacles),
        None => shown(&field, &plan.obstacles),
    });
    seen(&plan, &field, stage + 1);
    Ok(GrownPoints { plan, field, points: count, share })
}

/// Moves the level of a field until what it shows beside the cells that are `taken` is the `wanted` share. Gives the share.
fn levelled(field: &mut Field, wanted: f64, taken: &[bool]) -> f64 {
    let mut asked = wanted;
    let mut best: Option<(f64, Field)> = None;
    for _ in 0..ROUNDS {
        let mut with = field.clone();
        relevel_smoothly(&mut with, level_of_share_beside(field, asked.clamp(0.0, 1.0), taken));
        let got = shown(&with, taken);
        if best.as_ref().is_none_or(|(before, _)| (got - wanted).abs() < (before - wanted).abs()) {
            best = Some((got, with));
        }
        if (got - wanted).abs() < CLOSE {
            break;
        }
        asked += wanted - got;
    }
    let Some((share, with)) = best else { return 0.0 };
    *field = with;
    share
}

/// The share of the pattern of a field that is above the edge, beside the cells that are `taken`: as it is seen, between its cells too, where a
/// spline runs through them.
fn shown(field: &Field, taken: &[bool]) -> f64 {
    let times = if field.values.len() < FEW { 2 } else { 1 };
    let [width, height] = [times * field.width, times * field.height];
    let pattern = AreaPattern::new(field);
    let count = |band: usize| {
        let rows = band * ROWS..height.min((band + 1) * ROWS);
        let values = pattern.rows(rows.clone(), width, height);
        values.iter().enumerate().fold([0, 0], |[above, free], (index, value)| {
            let (x, y) = (index % width / times, (rows.start + index / width) / times);
            let is_free = !taken.get(y * field.width + x).is_some_and(|taken| *taken);
            [above + usize::from(is_free && *value >= EDGE), free + usize::from(is_free)]
        })
    };
    let bands = (0..height.div_ceil(ROWS)).into_par_iter().map(count);
    let [above, free] = bands.reduce(|| [0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
    above as f64 / free.max(1) as f64
}
