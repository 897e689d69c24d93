//! Plans of layers that a picture or Turing's growth drives.

mod growth;
mod pair_stripes;
mod system;

pub use pair_stripes::pair_model;
pub use system::ToneSystem;

use rayon::prelude::*;

use crate::attributes::regions::RegionGrid;
use crate::attributes::system::Family;
use crate::attributes::{AttributeMap, Attributes, Spots, Stripes};
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{Document, DocumentError, Drives, Kind, Tone};
use crate::grid::blur::gaussian;
use crate::grid::{Bounds, Domain, Grid};
use crate::photo::tone::{Constant, Frame, Gray, Tensors, directions_of, edges_of, ink, sampled};
use crate::rd::pairs::PairParameterField;
use crate::rd::{ParameterField, Parameters, System};
use crate::synth::drawn::sketch_targets::{marks, region_map};
use crate::synth::error::{LayerError, PlanError};
use crate::synth::marks::plan::Answers;
use crate::synth::marks::plan::setting::Setting;
use crate::synth::memory::{self, TooLarge};
use crate::synth::training::Training;

/// Number of wavelengths across the longer side if nothing is drawn: pictures are much easier to recognise with 56 than with 33
/// (`facts.md` V).
const WAVELENGTHS: f64 = 56.0;
/// The direction of lines if nothing is drawn, degrees: close to that of hatching by a right hand, and not parallel to an edge of
/// the canvas.
const HATCHING: f64 = 35.0;
/// Cells per wavelength, for stripes, and for spots and Turing's growth (`facts.md` V: 11.6 and 10).
const CELLS: [f64; 2] = [12.0, 10.0];
/// Cells per wavelength for pair stripes: the size of the pair is 2.2 cells, and 1.64 where lines are [finest](FINER).
const CELLS_OF_PAIRS: f64 = 15.0;
/// Largest ratio between the usual and the drawn marks; beyond it the grid is made for the drawn ones: five cells per wavelength
/// still hold a stripe.
const FINEST: f64 = 2.4;
/// Smallest cell, px: finer details cannot be seen on the canvas.
const SMALLEST: f64 = 0.35;
/// px of the tone per wavelength: thin lines of a tenth of it are two px wide.
const FINE: f64 = 20.0;
/// Range of the factor of wavelengths: from the first value in flat parts to the second where the gradient is [`DETAILED`] times
/// the usual one.
const FINER: [f64; 2] = [1.17, 0.75];
/// Gradient, relative to the usual one, from which on wavelengths are shortest, see [`FINER`].
const DETAILED: f64 = 1.5;
/// Range over which details are averaged, wavelengths: if wavelengths change faster, dislocations accumulate.
const AROUND: f64 = 1.0;
/// Largest factor by which the distance of spots is changed by the tone, up or down.
const DENSER: f64 = 1.8;
/// The share of ink of the usual spots: dots of half ink touch.
const USUAL_INK: f64 = 0.35;
/// Blur of tones before the cut, wavelengths: sharper edges leave fragments of lines.
const SOFT: f64 = 0.1;
/// The share of a spot's cell that it covers if its area is not drawn: the natural density of Meinhardt's system.
const PACKED: f64 = 0.122;
/// Nodes along the longer side at which wavelengths and directions of the drawn marks are computed.
const NODES: f64 = 32.0;

/// A layer that is ready to grow.
#[derive(Clone, Debug)]
pub struct TonePlan {
    /// The system.
    pub system: ToneSystem,
    /// The grid over the canvas, px.
    pub grid: Grid,
    /// The properties that follow the picture.
    pub drives: Drives,
    /// The usual distance from one mark to the next, px.
    pub wavelength: f64,
    /// Whether marks have a direction.
    pub directed: bool,
    /// The direction wanted at each cell, degrees, and how clear it is, 0..1.
    pub directions: Vec<(f64, f64)>,
    /// Distances ÷ the usual one at each cell.
    pub factors: Vec<f32>,
    /// Width and height of the tone, in px of the tone.
    pub fine: [usize; 2],
    /// The share of ink that is wanted at each px of the tone; empty if no picture drives the layer.
    pub tone: Vec<f32>,
    /// The parameter G of each cell; empty for systems without it.
    pub growth: Vec<f32>,
    /// Parameters of the usual marks, in cells; pair stripes have laws instead.
    usual: Option<Setting>,
}

/// The parameters of each cell.
pub enum ToneMaps {
    /// This system with these parameters.
    Of(System, ParameterField),
    /// One pair of morphogens.
    Pairs(PairParameterField),
}

/// The drawn attributes, or usual ones if nothing is drawn.
struct Drawn {
    system: ToneSystem,
    map: Option<AttributeMap>,
    usual: Attributes,
}

impl TonePlan {
    /// Reads layer `index` of a document named `source`, which a picture or a growth drives, on a canvas of `size` px.
    ///
    /// # Errors
    /// A rule of layers is broken: file, place, what is allowed; or a training set cannot be read; or it does not fit into memory.
    pub fn read(
        document: &Document,
        index: usize,
        source: &str,
        size: [f64; 2],
        (training, free): (&Training, Option<f64>),
    ) -> Result<Self, TonePlanError> {
        let drawn = Drawn::read(document, index, source, size)?;
        let canvas = Bounds { size, edges: document.edges };
        let mut plan = Self::bare(&drawn, canvas, training, free)?;
        let field = drawn.field(canvas);
        match &document.layers[index].tone {
            Some(tone) => plan.follow(tone, &field, size),
            None => plan.factors = plan.drawn_distances(&field),
        }
        if let Some(usual) = plan.system.usual_g() {
            plan.growth = growth::growth(&plan, document, index, usual);
            plan.directions = vec![(0.0, 0.0); plan.grid.cells()];
        }
        Ok(plan)
    }

    /// The plan for the drawn attributes, without a picture or a map.
    fn bare(
        drawn: &Drawn,
        canvas: Bounds,
        training: &Training,
        free: Option<f64>,
    ) -> Result<Self, TonePlanError> {
        let wavelength = wavelength_of(&drawn.usual);
        let grows = drawn.system.usual_g().is_some();
        let cells = match drawn.system {
            ToneSystem::PairStripes => CELLS_OF_PAIRS,
            ToneSystem::Of(_) => CELLS[usize::from(grows || !drawn.system.is_striped())],
        };
        let visible = wavelength.max(cells * SMALLEST);
        let side = |side: f64, per: f64| ((side * per / visible).round() as usize).max(8);
        let finest = drawn.finest().clamp(wavelength / FINEST, wavelength).max(cells * SMALLEST);
        let grid_size = canvas.size.map(|length| side(length, cells * (visible / finest).max(1.0)));
        let cell = [0, 1].map(|axis| canvas.size[axis] / grid_size[axis] as f64);
        let grid = Grid { size: grid_size, cell, edges: canvas.edges };
        let fine = canvas.size.map(|length| side(length, FINE));
        let needed = memory::needed_by_tone(drawn.system.needed(canvas.size, grid_size), grid_size, fine);
        memory::fits(needed, canvas.size, grid_size, free)?;
        let usual = match drawn.system {
            ToneSystem::PairStripes => None,
            ToneSystem::Of(system) if grows => Some(growth::setting(system, wavelength / grid.px_a_cell())),
            ToneSystem::Of(system) => {
                Some(Answers::new(training).ask(system, &drawn.usual, grid.px_a_cell())?.setting())
            }
        };
        let is_directed = drawn.system.is_striped() && !grows;
        let is_long = |setting: &Setting| setting.parameters.stretch < 1.0;
        Ok(Self {
            system: drawn.system,
            grid,
            drives: Drives { level: false, direction: false, spacing: false },
            wavelength,
            directed: is_directed || usual.as_ref().is_some_and(is_long),
            directions: Vec::new(),
            factors: Vec::new(),
            fine,
            tone: Vec::new(),
            growth: Vec::new(),
            usual,
        })
    }

    /// Lets the picture of `tone` drive the plan.
    fn follow(&mut self, tone: &Tone, drawn: &Field, canvas: [f64; 2]) {
        let Self { grid, fine, wavelength, .. } = *self;
        let picture = Gray { size: tone.image.size(), values: tone.image.values().to_vec() };
        let frame = Frame::covering(picture.size, canvas);
        let light = |px: usize| f32::from(picture.values[px]) / 255.0;
        let gray = sampled(&light, picture.size, &frame, grid.size);
        let tensors = edges_of(&gray, grid.size, wavelength / grid.px_a_cell(), grid.edges);
        let inks = ink(&picture, tone.equalise);
        let [white, black] = tone.range.map(|share| share as f32);
        let shares = |size| -> Vec<f32> {
            let ink = sampled(&|px| inks[px], picture.size, &frame, size);
            ink.into_iter().map(|ink| white + (black - white) * ink.clamp(0.0, 1.0)).collect()
        };
        self.drives = tone.drives;
        self.tone = gaussian(&shares(fine), fine, SOFT * FINE, grid.edges);
        self.factors = self.distances(&tensors, &shares(grid.size), drawn);
        self.directions = self.turned(tensors, drawn, tone.sketch);
    }

    /// Updates of one morphogen in one cell during a growth of pair stripes.
    #[must_use]
    pub fn updates_of_pair(&self) -> f64 {
        let least = self.factors.iter().copied().fold(f32::INFINITY, f32::min);
        let range = [least, self.factors.iter().copied().fold(0.0, f32::max)];
        self.updates_of_pair_between(range.map(f64::from))
    }

    /// px of the tone a wavelength.
    #[must_use]
    pub fn px_a_wavelength(&self) -> f64 {
        self.wavelength * self.fine[0] as f64 / (self.grid.size[0] as f64 * self.grid.cell[0])
    }

    /// px of the canvas a cell.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        self.grid.px_a_cell()
    }

    /// The drawn direction at each cell.
    fn drawn_directions(&self, drawn: &Field) -> Vec<(f64, f64)> {
        let direction = |cell: usize| (drawn.at(self.grid.center_px(cell)).1, 1.0);
        (0..self.grid.cells()).into_par_iter().map(direction).collect()
    }

    /// The drawn distances ÷ the usual one at each cell.
    fn drawn_distances(&self, drawn: &Field) -> Vec<f32> {
        let factor = |cell: usize| (drawn.at(self.grid.center_px(cell)).0 / self.wavelength) as f32;
        (0..self.grid.cells()).into_par_iter().map(factor).collect()
    }

    /// Directions at each cell: those of the picture where it has edges, and the drawn ones elsewhere.
    fn turned(&self, tensors: Tensors, drawn: &Field, sketch: f64) -> Vec<(f64, f64)> {
        let direction = |cell: usize| drawn.at(self.grid.center_px(cell)).1;
        if !self.drives.direction {
            return self.drawn_directions(drawn);
        }
        let cells = self.wavelength / self.px_a_cell();
        let constant = Constant { direction: &direction, share: sketch };
        directions_of(&tensors.spread(cells).plus(&constant))
    }

    /// Distances ÷ the usual one at each cell.
    fn distances(&self, tensors: &Tensors, tone: &[f32], drawn: &Field) -> Vec<f32> {
        let cells = self.grid.cells();
        let mut factors = self.drawn_distances(drawn);
        if !self.drives.spacing {
            return factors;
        }
        let sigma = AROUND * self.wavelength / self.px_a_cell();
        let driven: Vec<f32> = if self.system.is_striped() {
            let energies: Vec<f32> = (0..cells).map(|cell| tensors.energy(cell)).collect();
            let mean = tensors.mean_energy().max(f64::MIN_POSITIVE);
            let finer = |energy: f32| {
                let detail = ((f64::from(energy) / mean).sqrt() / DETAILED).min(1.0);
                (FINER[0] + detail * (FINER[1] - FINER[0])) as f32
            };
            gaussian(&energies, self.grid.size, sigma, self.grid.edges).into_iter().map(finer).collect()
        } else {
            let denser = |tone: f32| {
                let factor = (USUAL_INK / f64::from(tone).max(1e-3)).sqrt();
                factor.clamp(1.0 / DENSER, DENSER) as f32
            };
            gaussian(tone, self.grid.size, sigma, self.grid.edges).into_iter().map(denser).collect()
        };
        factors.iter_mut().zip(driven).for_each(|(factor, driven)| *factor *= driven);
        factors
    }

    /// The parameters of every cell.
    #[must_use]
    pub fn maps(&self) -> ToneMaps {
        match (self.system, &self.usual) {
            (ToneSystem::Of(system), Some(usual)) => ToneMaps::Of(system, self.parameters(usual)),
            _ => ToneMaps::Pairs(self.pair_maps()),
        }
    }

    /// Parameters of every cell, from those of the usual marks.
    fn parameters(&self, setting: &Setting) -> ParameterField {
        let usual = &setting.parameters;
        let of_cell = |((direction, _), factor): (&(f64, f64), &f32)| Parameters {
            rate: usual.rate as f32 / (factor * factor),
            ratio: usual.ratio.unwrap_or(1.0) as f32,
            stretch: usual.stretch as f32,
            direction: *direction as f32,
            pitch: setting.pitch as f32,
        };
        let parameters = self.directions.par_iter().zip(&self.factors).map(of_cell).collect();
        ParameterField { g: self.growth.clone(), ..ParameterField::new(self.grid, parameters) }
    }
}

/// The reason why a layer that a picture drives cannot be planned.
#[derive(Debug, thiserror::Error)]
pub enum TonePlanError {
    /// The strokes cannot be grown: file, place, value, what is allowed.
    #[error(transparent)]
    Document(#[from] DocumentError),
    /// Its parameters could not be looked up.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The layer does not fit into memory.
    #[error(transparent)]
    TooLarge(#[from] TooLarge),
}

impl From<TonePlanError> for LayerError {
    fn from(error: TonePlanError) -> Self {
        match error {
            TonePlanError::Document(error) => Self::Document(error),
            TonePlanError::Plan(error) => Self::Plan(error),
            TonePlanError::TooLarge(error) => Self::TooLarge(error),
        }
    }
}

impl Drawn {
    fn read(document: &Document, index: usize, source: &str, size: [f64; 2]) -> Result<Self, DocumentError> {
        let layer = &document.layers[index];
        let marks = marks(document, index, source)?;
        let kind = marks.first().map(Kind::from);
        let below = match index.checked_sub(1) {
            None => Beneath::Nothing,
            // The kind of the layer beneath does not matter: none is allowed.
            Some(_) => Beneath::Grows(Kind::Line),
        };
        if let Some(problem) = Combination::new(layer, kind, below).problem(&format!("layers[{index}]")) {
            return Err(problem.in_file(source));
        }
        let spots = match layer.system.description() {
            Some(system) => !system.is_striped(),
            None => kind == Some(Kind::Ellipse),
        };
        let system = System::first(|system| system.tone && system.is_striped() != spots);
        let system = match layer.system.kind() {
            Some(Family::Pairs) => ToneSystem::PairStripes,
            Some(Family::Growth) => ToneSystem::Of(System::with_growth()),
            _ => ToneSystem::Of(system.unwrap_or(System::ALL[0])),
        };
        if kind.is_none() {
            let longer = document.size[0].max(document.size[1]);
            let wavelength = f64::from(longer) / WAVELENGTHS;
            let usual = if spots {
                let area = PACKED * wavelength * wavelength;
                Attributes::Spots(Spots { area, aspect: 1.0, angle: HATCHING, spacing: Some(wavelength) })
            } else {
                Attributes::Stripes(Stripes { width: 0.5 * wavelength, angle: HATCHING, wavelength: None })
            };
            return Ok(Self { system, map: None, usual });
        }
        let map = region_map(document, index, source)?.resized(size);
        let usual = usual(&map);
        Ok(Self { system, map: Some(map), usual })
    }

    /// The smallest distance of marks that is wanted anywhere, px.
    fn finest(&self) -> f64 {
        let all = self.map.as_ref().map_or_else(|| vec![self.usual], AttributeMap::samples);
        all.iter().map(wavelength_of).fold(f64::INFINITY, f64::min)
    }

    /// Wavelengths and directions over the canvas.
    fn field(&self, canvas: Bounds) -> Field {
        let longer = canvas.size[0].max(canvas.size[1]);
        let nodes = canvas.size.map(|side| (NODES * side / longer).ceil() as usize);
        let grid = if self.map.is_some() { nodes } else { [1, 1] };
        let layout = RegionGrid { size: canvas.size, grid, edges: canvas.edges };
        let node = |index: usize| {
            let point = layout.center(layout.place(index));
            let wanted = self.map.as_ref().map_or(self.usual, |map| map.at(point));
            let double = (2.0 * angle_of(&wanted)).to_radians();
            [wavelength_of(&wanted), libm::cos(double), libm::sin(double)]
        };
        Field { nodes: (0..layout.len()).into_par_iter().map(node).collect(), layout }
    }
}

/// Wavelengths and directions at the nodes of a grid over the canvas.
struct Field {
    layout: RegionGrid,
    /// Wavelength, px, and the cosine and sine of twice the direction.
    nodes: Vec<[f64; 3]>,
}

impl Field {
    /// Wavelength, px, and direction, degrees, at a point, px.
    fn at(&self, point: [f64; 2]) -> (f64, f64) {
        let corners = self.layout.corners(point);
        let mixed = |part: usize| -> f64 {
            corners.iter().map(|(node, weight)| weight * self.nodes[*node][part]).sum()
        };
        (mixed(0), 0.5 * libm::atan2(mixed(2), mixed(1)).to_degrees())
    }
}

/// The usual attributes of a map: means over the canvas.
fn usual(map: &AttributeMap) -> Attributes {
    let all = map.samples();
    let count = all.len().max(1) as f64;
    let mean = |of: &dyn Fn(&Attributes) -> f64| all.iter().map(of).sum::<f64>() / count;
    let wavelength = mean(&wavelength_of);
    let area = mean(&|wanted| if let Attributes::Spots(spots) = wanted { spots.area } else { 0.0 });
    let aspect = mean(&|wanted| if let Attributes::Spots(spots) = wanted { spots.aspect } else { 1.0 });
    match all.first() {
        Some(Attributes::Spots(_)) => {
            Attributes::Spots(Spots { area, aspect, angle: 0.0, spacing: Some(wavelength) })
        }
        _ => Attributes::Stripes(Stripes { width: 0.5 * wavelength, angle: 0.0, wavelength: None }),
    }
}

/// The distance from one mark to the next, px.
fn wavelength_of(wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Spots(spots) => spots.spacing.unwrap_or_else(|| (spots.area / PACKED).sqrt()),
        Attributes::Stripes(stripes) => stripes.wavelength.unwrap_or(2.0 * stripes.width),
    }
}

fn angle_of(wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Spots(spots) => spots.angle,
        Attributes::Stripes(stripes) => stripes.angle,
    }
}
