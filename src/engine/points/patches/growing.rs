//! The growth of patches as a value that is advanced step by step.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::kept;
use super::mending::Labelled;
use super::outlines::Outlines;
use super::{CRAMPED, GrownPatches, Patches, Rules, Wanted, clamped, reach};
use crate::grid::Field;
use crate::points::appearance::Appearance;
use crate::points::delaunay::Delaunay;
use crate::points::extent::Extent;
use crate::points::level::relevel_at;

/// Patches that grow.
#[derive(Default)]
pub struct PatchGrowth {
    state: State,
}

/// The finished steps.
#[derive(Default)]
enum State {
    #[default]
    Nothing,
    /// The centres are laid.
    Laid { laid: Vec<[f64; 2]>, rng: Pcg64Mcg },
    /// The fine points are laid.
    Scattered { laid: Vec<[f64; 2]>, graph: Box<Delaunay>, noise: Vec<f64>, rng: Pcg64Mcg },
    /// The points appear; the number of the next stage.
    Appearing { grown: GrownPatches, shown: Box<Shown>, stage: usize },
    /// All patches are grown.
    Grown(GrownPatches),
}

/// The points, in the order in which they appear.
struct Shown {
    graph: Delaunay,
    values: Vec<f32>,
    appearance: Appearance,
    /// The field of the points that have appeared.
    field: Option<Field>,
}

impl PatchGrowth {
    /// Does the next step. Returns whether all is done.
    ///
    /// If `stages` is above 1, the points then appear in `stages` − 1 stages, from the centres of the patches outward: see
    /// [`PatchGrowth::appearing`].
    pub fn advance(&mut self, patches: &Patches, stages: usize) -> bool {
        let extent = Extent::from(patches.grid.bounds_px());
        let frame = reach(&extent, patches.wanted);
        self.state = match std::mem::take(&mut self.state) {
            State::Nothing => {
                let mut rng = Pcg64Mcg::seed_from_u64(patches.seed);
                let kept = Outlines::new(patches.kept.iter(), &extent);
                let laid = patches.laid(&kept, frame, &mut rng);
                State::Laid { laid, rng }
            }
            State::Laid { laid, mut rng } => {
                let (graph, noise) = patches.scattered(&extent, frame, &laid, &mut rng);
                State::Scattered { laid, graph: Box::new(graph), noise, rng }
            }
            State::Scattered { laid, graph, noise, mut rng } => {
                labelled(patches, &laid, *graph, noise, stages, &mut rng)
            }
            State::Appearing { grown, mut shown, stage } if stage < stages => {
                let values = shown.appearance.at(&shown.values, stage as f64 / stages as f64);
                let mut field = patches.spread(&shown.graph, &values);
                relevel_at(&mut field, grown.level);
                let mut field = clamped(field);
                kept::put(
                    &mut field,
                    &Outlines::new(patches.kept.iter(), &extent),
                    stage as f64 / stages as f64,
                );
                shown.field = Some(field);
                State::Appearing { grown, shown, stage: stage + 1 }
            }
            State::Appearing { grown, .. } | State::Grown(grown) => State::Grown(grown),
        };
        matches!(self.state, State::Grown(_))
    }

    /// The field of the points that have appeared, and the number of its stage, 1 = the first.
    #[must_use]
    pub fn appearing(&self) -> Option<(usize, &Field)> {
        let State::Appearing { shown, stage, .. } = &self.state else { return None };
        Some((stage - 1, shown.field.as_ref()?))
    }

    /// The grown patches; `None` before all is done.
    #[must_use]
    pub fn complete(self) -> Option<GrownPatches> {
        if let State::Grown(grown) = self.state { Some(grown) } else { None }
    }
}

/// The points claimed by the patches, and the field of their labels.
fn labelled(
    patches: &Patches,
    laid: &[[f64; 2]],
    graph: Delaunay,
    noise: Vec<f64>,
    stages: usize,
    rng: &mut Pcg64Mcg,
) -> State {
    let extent = Extent::from(patches.grid.bounds_px());
    let kept = Outlines::new(patches.kept.iter(), &extent);
    let shape = |wanted: &Wanted| wanted.shape(patches.detail);
    let taken = patches.taken(&graph, &kept);
    let rules = Rules::new(&patches.asked(&graph, laid.len(), rng), &shape, noise);
    let mut labelled: Labelled = Patches::labelled(&graph, &taken, laid.len(), &rules);
    let (mut claimed, mut inside) = (vec![0.0; laid.len()], vec![0.0; laid.len()]);
    for (point, owner) in labelled.owner.iter().enumerate() {
        if let Some(patch) = owner {
            claimed[*patch as usize] += graph.area(point);
            inside[*patch as usize] += graph.area_inside(point);
        }
    }
    // For a patch that is cut by the border, the share of its area inside; for a cramped one, the claimed area.
    let share_inside = |patch: usize| if claimed[patch] > 0.0 { inside[patch] / claimed[patch] } else { 0.0 };
    let reached = |patch: usize| rules.areas[patch].min(claimed[patch] / CRAMPED);
    let covered: f64 = (0..laid.len()).map(|patch| reached(patch) * share_inside(patch)).sum();
    let share = covered / (extent.size[0] * extent.size[1]);
    let (mut field, level) = patches.interpolated(&graph, &mut labelled, share);
    kept::put(&mut field, &kept, 1.0);
    let on_canvas: Vec<usize> = (0..laid.len()).filter(|patch| extent.contains(laid[*patch])).collect();
    let cramped = |patch: &&usize| claimed[**patch] < CRAMPED * rules.areas[**patch];
    let grown = GrownPatches {
        field,
        level,
        cramped: on_canvas.iter().filter(cramped).count(),
        centers: on_canvas.iter().map(|patch| laid[*patch]).collect(),
    };
    if stages <= 1 {
        return State::Grown(grown);
    }
    let appearance = Appearance::along(&graph, &labelled.values, &(0..laid.len()).collect::<Vec<_>>());
    let shown = Shown { graph, values: labelled.values, appearance, field: None };
    State::Appearing { grown, shown: Box::new(shown), stage: 1 }
}
