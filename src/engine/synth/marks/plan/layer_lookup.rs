//! The second stage of a plan: the system, the size of a cell, and the parameters looked up for every place.

use std::borrow::Cow;

use rayon::prelude::*;

use crate::attributes::AttributeMap;
use crate::attributes::{Attributes, Polarity, Spots, Spread};
use crate::document::SystemChoice;
use crate::grid::{Domain, Grid};
use crate::learn::{Answer, Note, of_gaps};
use crate::marks::Path;
use crate::rd::{LinesAlongCurves, ParameterField, Parameters, Seeding, System};
use crate::synth::error::PlanError;
use crate::synth::marks::plan::answers::{Answers, Ask};
use crate::synth::marks::plan::asked::Asked;
use crate::synth::marks::plan::auto::choose_system;
use crate::synth::marks::plan::cell_corners::CellValues;
use crate::synth::marks::plan::cell_parameters::CellParameters;
use crate::synth::marks::plan::drawn_spots::DrawnSpot;
use crate::synth::marks::plan::free_spacing::free_spacing;
use crate::synth::marks::plan::lattice::Lattice;
use crate::synth::marks::plan::layer_grid::{finest_cell, grid_of};
use crate::synth::marks::plan::offset::Offset;
use crate::synth::marks::plan::offset_curves::CurveKind;
use crate::synth::marks::plan::spread_limits::limited;
use crate::synth::profile::{Section, during};
use crate::synth::training::Training;

/// The starting places of the marks of a layer, as far as the sketch determines them. They are known once the layers beneath have
/// grown.
#[derive(Clone, Debug)]
pub enum Start {
    /// At places chosen by the system, and at these drawn marks, if there are any.
    Free {
        /// Spots with parameters of their own.
        spots: Vec<DrawnSpot>,
        /// Lines and paths, px.
        lines: Vec<Path>,
    },
    /// At the places of the marks of the layer beneath.
    Inside,
    /// Along curves around the marks beneath, or between them.
    Curves {
        /// The kind of curves.
        kind: CurveKind,
        /// The laws of the system's lines along curves.
        laws: LinesAlongCurves,
        /// The share of each ring that is open, 0..1.
        broken: f64,
    },
}

impl Start {
    /// At places chosen by the system.
    pub const NATURAL: Self = Self::Free { spots: Vec::new(), lines: Vec::new() };
}

/// The largest area ÷ spacing² of the spots between drawn ones, whose places are uneven: at 0.32 a tenth of them merge, in an even
/// pattern none.
const DENSEST_AMONG_DRAWN: f64 = 0.25;

/// The parameters looked up for a layer.
#[derive(Clone, Debug)]
pub struct Lookup {
    /// The system.
    pub system: System,
    /// Whether the lines that grow are its stripes, or the gaps between them.
    pub polarity: Polarity,
    /// The wanted attributes by place, with free spacings filled in. Its canvas is the one that is grown.
    pub map: AttributeMap,
    /// The grid over the canvas.
    pub grid: Grid,
    /// Parameters (in cells) at every place.
    pub lattice: Lattice,
    /// The answer for each region, lengths in px but parameters in cells.
    pub answers: Vec<Answer>,
    /// Messages to the user by region, in addition to the notes of the answers.
    pub remarks: Vec<Vec<String>>,
    /// Irregularity of the outlines of its spots, 0..1; only Turing's spots can be irregular.
    pub irregular: f64,
    /// Initial state of stripes. Without noise they grow without a tensor.
    pub seeding: Seeding,
    /// Starting places of its marks.
    pub start: Start,
    /// Spread of the spots of each region: the wanted one, limited to the possible one.
    pub(super) spreads: Vec<Spread>,
}

/// Looks up the parameters of a layer with these wanted attributes. The canvas is that of `map`.
///
/// # Errors
/// The training set cannot be read, or does not take such attributes.
pub fn look_up(training: &Training, choice: SystemChoice, map: &AttributeMap) -> Result<Lookup, PlanError> {
    let mut map = map.clone();
    let answers = Answers::new(training);
    let system = match (choice, choice.system()) {
        (_, Some(system)) => system,
        (SystemChoice::Auto | SystemChoice::Stripes, None) => choose_system(&answers, training, &map)?,
        (SystemChoice::Of(other), None) => return Err(PlanError::Untrained { name: other.name }),
    };
    map.fill_free_spacing(|spots| free_spacing(training, system, spots));
    let limited = system.description().free_spacing && map.limit_density(DENSEST_AMONG_DRAWN);
    let polarity = if system.description().free_spacing { map.polarity() } else { Polarity::Positive };
    // On the grid of the growth, on which these questions are asked again.
    let cell = grid_of(&map, finest_cell((system, polarity), &map)).px_a_cell();
    let sparse = |wanted: &Attributes| Ok(answers.ask(system, &polarity.lines(wanted), cell)?.pitch() > 1.0);
    let sparse = map.samples().par_iter().map(sparse).collect::<Result<Vec<_>, PlanError>>()?.contains(&true);
    let answers = answers.among_sparse(sparse);
    let ask: Ask = &|wanted, cell| answers.ask(system, wanted, cell);
    let mut lookup = Lookup::new((system, polarity), map, Start::NATURAL, ask)?;
    if limited {
        lookup.remarks[0].push(placed_apart(&lookup.map));
    }
    Ok(lookup)
}

/// The note that spots between drawn ones have been placed farther apart.
fn placed_apart(map: &AttributeMap) -> String {
    let samples = map.samples();
    let apart = samples.iter().filter_map(|wanted| match wanted {
        Attributes::Spots(spots) => Some((spots.area / DENSEST_AMONG_DRAWN).sqrt()),
        Attributes::Stripes(_) => None,
    });
    let nearest = apart.fold(f64::INFINITY, f64::min);
    format!(
        "in places spots are drawn so close together that others between them would merge: those are placed farther apart, their centres at least {nearest:.0} px from each other"
    )
}

/// Looks up the parameters of a layer on a grid of about `cell` px a cell, whether or not that suits the marks; no spacing of `map`
/// may be free.
///
/// # Errors
/// The training set cannot be read, or does not take such attributes.
pub fn look_up_on(
    training: &Training,
    (system, polarity): (System, Polarity),
    map: &AttributeMap,
    cell: f64,
) -> Result<Lookup, PlanError> {
    let answers = Answers::new(training);
    let ask: Ask = &|wanted, cell| answers.ask(system, wanted, cell);
    Lookup::on_cells((system, polarity), map.clone(), cell, Start::NATURAL, ask)
}

/// An answer about the lines that grow, converted to the stripes that are wanted.
pub(super) fn of_marks(polarity: Polarity, answer: Answer) -> Answer {
    match polarity {
        Polarity::Positive => answer,
        Polarity::Negative => answer.of_gaps(),
    }
}

/// The remarks of an answer about the lines that grow, converted to the stripes that are wanted.
pub(super) fn notes_of_marks(polarity: Polarity, asked: &Asked) -> Vec<Note> {
    match polarity {
        Polarity::Positive => asked.notes(),
        Polarity::Negative => of_gaps(asked.notes()),
    }
}

impl Lookup {
    /// Looks up the attributes of `map`; none of its spacings may be free.
    pub(super) fn new(
        grown: (System, Polarity),
        map: AttributeMap,
        start: Start,
        ask: Ask,
    ) -> Result<Self, PlanError> {
        let cell = finest_cell(grown, &map);
        Self::on_cells(grown, map, cell, start, ask)
    }

    fn on_cells(
        (system, polarity): (System, Polarity),
        map: AttributeMap,
        cell: f64,
        start: Start,
        ask: Ask,
    ) -> Result<Self, PlanError> {
        let wanted = map.of_regions();
        let grid = grid_of(&map, cell);
        let cell = grid.px_a_cell();

        let answer = |wanted| Ok(of_marks(polarity, ask(&polarity.lines(wanted), cell)?.predict()));
        let answers = wanted.par_iter().map(answer).collect::<Result<Vec<_>, PlanError>>()?;
        let mut remarks = vec![Vec::new(); wanted.len()];
        let mut spreads = vec![Spread::ZERO; wanted.len()];
        for (index, (_, region)) in map.regions().enumerate() {
            if let Attributes::Spots(spots) = &wanted[index] {
                let limited = limited(system, spots, &region.spread, map.spread_is_given());
                spreads[index] = limited.spread;
                remarks[index] = limited.notes;
            }
        }
        let lattice =
            Lattice::looked_up((&map, polarity), cell, &vec![Offset::default(); wanted.len()], ask)?;
        let (irregular, seeding) = (0.0, Seeding::Noise);
        Ok(Self {
            system,
            polarity,
            map,
            grid,
            lattice,
            answers,
            remarks,
            irregular,
            seeding,
            start,
            spreads,
        })
    }

    /// Answers to further questions, in the way in which those of its regions were answered.
    pub(super) fn answers_of<'t>(&self, training: &'t Training) -> Answers<'t> {
        Answers::new(training).among_sparse(self.answers.iter().any(|answer| answer.pitch > 1.0))
    }

    /// The kind of curves along which its lines run, if they do.
    #[must_use]
    pub fn curve_kind(&self) -> Option<CurveKind> {
        match self.start {
            Start::Curves { kind, .. } => Some(kind),
            Start::Free { .. } | Start::Inside => None,
        }
    }

    /// The lines that have to grow for the wanted attributes of each region; other marks unchanged.
    #[must_use]
    pub fn wanted_lines(&self) -> Vec<Attributes> {
        self.wanted().iter().map(|wanted| self.polarity.lines(wanted)).collect()
    }

    /// The wanted attributes at the centre of each region.
    #[must_use]
    pub fn wanted(&self) -> Vec<Attributes> {
        self.map.of_regions()
    }

    /// px a cell; cells are nearly square.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        self.grid.px_a_cell()
    }

    /// A point of the grid, cells, on the canvas, px.
    #[must_use]
    pub fn to_px(&self, at: [f64; 2]) -> [f64; 2] {
        self.grid.to_px(at)
    }

    /// Points of the grid, cells, on the canvas, px.
    #[must_use]
    pub fn all_to_px(&self, at: &[[f64; 2]]) -> Vec<[f64; 2]> {
        at.iter().map(|at| self.to_px(*at)).collect()
    }

    /// Points of the canvas, px, on the grid, cells.
    #[must_use]
    pub fn all_to_cells(&self, at: &[[f64; 2]]) -> Vec<[f64; 2]> {
        at.iter().map(|at| self.grid.to_cells(*at)).collect()
    }

    /// The spread of the spots of region `index`.
    #[must_use]
    pub fn spread(&self, index: usize) -> Spread {
        self.spreads[index]
    }

    /// The spots wanted at a point, px.
    pub(super) fn spots_at(&self, point: [f64; 2]) -> Spots {
        match self.map.at(point) {
            Attributes::Spots(spots) => spots,
            Attributes::Stripes(_) => unreachable!("only spots vary and are pinned one by one"),
        }
    }

    /// The spread of the spots wanted at a point, px.
    pub(super) fn spread_at(&self, point: [f64; 2]) -> Spread {
        let corners = self.map.layout().corners(point);
        corners
            .iter()
            .fold(Spread::ZERO, |sum, &(i, weight)| sum.with(&self.spread(i), |sum, one| sum + weight * one))
    }

    /// Interpolates values of the regions of `map` at a point, px.
    #[must_use]
    pub fn between_regions(&self, values: &[f64], point: [f64; 2]) -> f64 {
        self.map.layout().corners(point).iter().map(|&(i, weight)| weight * values[i]).sum()
    }

    /// Parameters of every cell. `pitch` is the distance at which marks begin ÷ the system's own distance, by region of `map`;
    /// `obstacles` are the cells taken by marks beneath, empty = none.
    #[must_use]
    pub fn maps(&self, pitch: &[f64], obstacles: &[bool]) -> ParameterField {
        let grid = self.grid;
        let maps = if self.lattice.nodes.len() == 1 && pitch.len() == 1 {
            let parameters = self.with_tensor_of_seeding(self.lattice.nodes[0].parameters(pitch[0]));
            ParameterField::new(grid, vec![parameters; grid.cells()])
        } else {
            during(Section::Parameters, || self.by_cell(pitch))
        };
        ParameterField { obstacles: obstacles.to_vec(), is_curved: self.map.metric().is_some(), ..maps }
    }

    /// Parameters that differ from cell to cell.
    fn by_cell(&self, pitch: &[f64]) -> ParameterField {
        let cells = CellParameters::new(&self.lattice, &self.grid);
        let pitches = self.at_cells(pitch);
        let mut parameters = Parameters::unwritten(self.grid.cells());
        let part = self.grid.part();
        parameters.par_chunks_mut(part).enumerate().for_each(|(index, part_of_all)| {
            cells.write(index * part, &pitches, |_, node| node, part_of_all);
            if self.seeding != Seeding::Noise {
                part_of_all.iter_mut().for_each(|p| *p = self.with_tensor_of_seeding(*p));
            }
        });
        ParameterField::new(self.grid, parameters)
    }

    /// Values of the regions, interpolated at each cell.
    pub(super) fn at_cells<'a>(&self, values: &'a [f64]) -> CellValues<'a> {
        CellValues::new(self.map.layout(), &self.grid, values)
    }

    /// `maps`, made with a pitch of 1 in all regions, converted to another `pitch`.
    #[must_use]
    pub fn repitched<'a>(&self, maps: &'a ParameterField, pitch: &[f64]) -> Cow<'a, ParameterField> {
        if pitch.iter().all(|pitch| *pitch == 1.0) {
            return Cow::Borrowed(maps);
        }
        Cow::Owned(self.repitch(maps.clone(), pitch))
    }

    /// `maps`, made with a pitch of 1 in all regions, converted to another `pitch` by region, without a copy.
    #[must_use]
    pub fn repitch(&self, mut maps: ParameterField, pitch: &[f64]) -> ParameterField {
        if pitch.iter().all(|pitch| *pitch == 1.0) {
            return maps;
        }
        let factors = self.at_cells(pitch);
        let scale = |(y, row): (usize, &mut [Parameters])| {
            let factor = factors.row(y);
            row.iter_mut().enumerate().for_each(|(x, p)| p.pitch *= factor(x) as f32);
        };
        let rows = maps.parameters.par_chunks_mut(self.grid.size[0]).enumerate();
        during(Section::Parameters, || rows.for_each(scale));
        maps
    }

    /// Parameters without a tensor if the seeding determines the direction of stripes.
    fn with_tensor_of_seeding(&self, p: Parameters) -> Parameters {
        if self.seeding == Seeding::Noise { p } else { Parameters { stretch: 1.0, ..p } }
    }
}
