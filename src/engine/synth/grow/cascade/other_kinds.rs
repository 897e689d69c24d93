//! Layers of other kinds than spots and stripes of one system: pairs, patches and cells, lines of points, fields of points,
//! and what a picture or a growth drives.

use super::{Cascade, grow};
use crate::document::{Layer, LineKind, Points};
use crate::grid::Field;
use crate::rd::pairs::PairKind;
use crate::synth::grow::grow_cells::CellGrower;
use crate::synth::grow::grow_lines::LineGrower;
use crate::synth::grow::grow_pairs::PairGrower;
use crate::synth::grow::grow_patches::grow_patches;
use crate::synth::grow::grow_points::grow_points;
use crate::synth::grow::grow_tone::grow_tone;
use crate::synth::grow::layer::{GrowError, GrownLayer};
use crate::synth::grow::obstacles::obstacles;
use crate::synth::grow::snapshot::{Growing, Snapshot};
use crate::synth::grow::stripes_of_threads::stripes_of;
use crate::synth::grow::tone_growth::ToneGrowth;
use crate::synth::memory;
use crate::synth::options::Options;
use crate::synth::phases::{Phase, during};
use crate::synth::plan::areas::{AreaForm, AreaPlan, rows_of_cells};
use crate::synth::plan::error::PlanError;
use crate::synth::plan::pairs::PairPlan;
use crate::synth::plan::pairs::thread_map::ThreadMap;
use crate::synth::plan::point_fields::FieldPlan;
use crate::synth::plan::point_lines::LinePlan;
use crate::synth::plan::tone::TonePlan;
use crate::synth::watch::{Stage, Watch};

impl Cascade<'_> {
    /// Plans layer `index`, if it is of another kind than spots and stripes of one system. Returns whether it is.
    pub(super) fn plan_of_other_kind(&self, index: usize, layer: &Layer) -> Result<bool, GrowError> {
        if layer.is_driven() {
            self.plan_tone(index)?;
        } else if self.document.pairs(index).is_some() {
            self.plan_pairs(index)?;
        } else if layer.areas().is_some() {
            self.plan_areas(index)?;
        } else if let Some(kind) = layer.point_lines() {
            self.plan_lines(index, kind)?;
        } else if let Some(points) = layer.point_field() {
            self.plan_points(index, points)?;
        } else {
            return Ok(false);
        }
        Ok(true)
    }

    /// Grows layer `index`, if it is of another kind than spots and stripes of one system.
    pub(super) fn layer_of_other_kind(
        &self,
        index: usize,
        beneath: &[GrownLayer],
        seen: &mut dyn FnMut(&Snapshot),
    ) -> Option<Result<GrownLayer, GrowError>> {
        let layer = &self.document.layers[index];
        if layer.is_driven() {
            return Some(self.tone_layer(index, beneath, seen));
        }
        if self.document.pairs(index).is_some() {
            return Some(self.pair_layer(index, beneath, seen));
        }
        if layer.areas().is_some() {
            return Some(self.area_layer(index, beneath, seen));
        }
        if let Some(kind) = layer.point_lines() {
            return Some(self.line_layer(index, kind, beneath, seen));
        }
        layer.point_field().map(|points| self.point_layer(index, points, beneath, seen))
    }

    /// Plans layer `index`, which a system of pairs grows.
    fn plan_pairs(&self, index: usize) -> Result<PairPlan, GrowError> {
        let size = self.options.size.unwrap_or(self.document.size).map(f64::from);
        let kind = self.document.pairs(index).unwrap_or(PairKind::Weave);
        let rows = self.options.training.pairs(kind.description()).map_err(PlanError::Training)?;
        let plan = PairPlan::read(self.document, index, self.options.source, size, rows)?;
        memory::check_pairs(plan.threads.len(), size, plan.grid.size, self.options.memory)?;
        Ok(plan)
    }

    /// Grows layer `index` by a system of pairs.
    fn pair_layer(
        &self,
        index: usize,
        beneath: &[GrownLayer],
        seen: &mut dyn FnMut(&Snapshot),
    ) -> Result<GrownLayer, GrowError> {
        self.options.watch.step(Stage::Plan, 0.0)?;
        let mut plan = during(Phase::LookUp, || self.plan_pairs(index))?;
        plan.obstacles =
            during(Phase::LayOut, || obstacles(self.document, beneath, plan.grid.size, &|_| false));
        let mut seen = |growing: Growing, steps| seen(&Snapshot { beneath, growing, steps });
        let Self { document, options, every } = *self;
        let stripes = |threads: &ThreadMap, [nx, ny]: [usize; 2]| {
            let document = stripes_of(document, threads, document.layer_seed(index), index);
            let watch = Watch { progress: &|_, _| {}, cancelled: options.watch.cancelled };
            let options = Options { concentrations: false, refine: Some(true), watch, ..options };
            Ok(grow(&document, &options)?.layers[0].pattern().field(nx, ny))
        };
        let corrects = self.corrects();
        let (layer, seed) = (index + 1, document.layer_seed(index));
        let grower = PairGrower { layer, seed, options, every, corrects, stripes: &stripes };
        Ok(GrownLayer::Pairs(Box::new(grower.grow(plan, &mut seen)?)))
    }

    /// Plans layer `index`, on which patches or cells grow.
    fn plan_areas(&self, index: usize) -> Result<AreaPlan, GrowError> {
        let size = self.options.size.unwrap_or(self.document.size).map(f64::from);
        let rows = rows_of_cells(self.document, index, self.options.training).map_err(PlanError::Training)?;
        let plan = AreaPlan::read(self.document, index, self.options.source, size, rows)?;
        memory::check_areas(plan.kind(), size, plan.grid.size, self.options.memory)?;
        Ok(plan)
    }

    /// Grows the patches or cells of layer `index`.
    fn area_layer(
        &self,
        index: usize,
        beneath: &[GrownLayer],
        seen: &mut dyn FnMut(&Snapshot),
    ) -> Result<GrownLayer, GrowError> {
        let watch = self.options.watch;
        watch.step(Stage::Plan, 0.0)?;
        let mut plan = during(Phase::LookUp, || self.plan_areas(index))?;
        plan.obstacles =
            during(Phase::LayOut, || obstacles(self.document, beneath, plan.grid.size, &|_| false));
        let mut seen = |plan: &AreaPlan, field: &Field, steps: u64| {
            seen(&Snapshot { beneath, growing: Growing::Areas(plan, field), steps });
        };
        let (layer, seed) = (index + 1, self.document.layer_seed(index));
        let grown = match plan.form.clone() {
            AreaForm::Patches(form) => {
                grow_patches(plan, &form, layer, seed, &watch, self.every.is_some(), &mut seen)?
            }
            AreaForm::Cells(form) => {
                let corrects = self.corrects();
                CellGrower { layer, seed, watch, corrects }.grow(&plan, &form, &mut seen)?
            }
        };
        Ok(GrownLayer::Areas(Box::new(grown)))
    }

    /// Plans the streaks or cracks of layer `index`.
    fn plan_lines(&self, index: usize, kind: LineKind) -> Result<LinePlan, GrowError> {
        let size = self.options.size.unwrap_or(self.document.size).map(f64::from);
        let plan = LinePlan::read(self.document, index, kind, self.options.source, size)?;
        memory::check_lines(size, plan.grid.size, self.options.memory)?;
        Ok(plan)
    }

    /// Grows the streaks or cracks of layer `index`.
    fn line_layer(
        &self,
        index: usize,
        kind: LineKind,
        beneath: &[GrownLayer],
        seen: &mut dyn FnMut(&Snapshot),
    ) -> Result<GrownLayer, GrowError> {
        let watch = self.options.watch;
        watch.step(Stage::Plan, 0.0)?;
        let mut plan = during(Phase::LookUp, || self.plan_lines(index, kind))?;
        plan.obstacles =
            during(Phase::LayOut, || obstacles(self.document, beneath, plan.grid.size, &|_| false));
        let mut seen = |field: &Field| {
            seen(&Snapshot { beneath, growing: Growing::Lines(&plan, field), steps: 0 });
        };
        let (seed, corrects) = (self.document.layer_seed(index), self.corrects());
        let filmed = self.every.is_some();
        let grower = LineGrower { layer: index + 1, seed, watch, corrects, filmed };
        let grown = grower.grow(&plan, &mut seen)?;
        Ok(GrownLayer::Lines(Box::new(grown)))
    }

    /// Plans the field of `points` of layer `index`.
    fn plan_points(&self, index: usize, points: Points) -> Result<FieldPlan, GrowError> {
        let size = self.options.size.unwrap_or(self.document.size).map(f64::from);
        let plan = FieldPlan::read(self.document, index, points, self.options.source, size)?;
        memory::check_points(plan.expected_points(), size, plan.grid.size, self.options.memory)?;
        Ok(plan)
    }

    /// Grows the field of `points` of layer `index`.
    fn point_layer(
        &self,
        index: usize,
        points: Points,
        beneath: &[GrownLayer],
        seen: &mut dyn FnMut(&Snapshot),
    ) -> Result<GrownLayer, GrowError> {
        let watch = self.options.watch;
        watch.step(Stage::Plan, 0.0)?;
        let mut plan = during(Phase::LookUp, || self.plan_points(index, points))?;
        plan.obstacles =
            during(Phase::LayOut, || obstacles(self.document, beneath, plan.grid.size, &|_| false));
        let mut seen = |plan: &FieldPlan, field: &Field, steps: u64| {
            seen(&Snapshot { beneath, growing: Growing::Points(plan, field), steps });
        };
        let seed = self.document.layer_seed(index);
        let grown = grow_points(plan, index + 1, seed, &watch, self.every.is_some(), &mut seen)?;
        Ok(GrownLayer::Points(Box::new(grown)))
    }

    /// Plans layer `index`, which a picture or a growth drives.
    fn plan_tone(&self, index: usize) -> Result<TonePlan, GrowError> {
        let Options { source, training, memory, .. } = self.options;
        let size = self.options.size.unwrap_or(self.document.size).map(f64::from);
        Ok(TonePlan::read(self.document, index, source, size, (training, memory))?)
    }

    /// Grows layer `index`, which a picture or a growth drives.
    fn tone_layer(
        &self,
        index: usize,
        beneath: &[GrownLayer],
        seen: &mut dyn FnMut(&Snapshot),
    ) -> Result<GrownLayer, GrowError> {
        self.options.watch.step(Stage::Plan, 0.0)?;
        let plan = during(Phase::LookUp, || self.plan_tone(index))?;
        let mut seen = |plan: &TonePlan, growth: &ToneGrowth| {
            seen(&Snapshot { beneath, growing: Growing::Tone(plan, growth), steps: growth.steps() });
        };
        let seed = self.document.layer_seed(index);
        let grown = grow_tone(plan, index + 1, seed, &self.options, self.every, &mut seen)?;
        Ok(GrownLayer::Tone(Box::new(grown)))
    }
}
