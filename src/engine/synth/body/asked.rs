//! What a layer asks for on a model, before places are known.

use crate::attributes::{Attributes, Spots, Spread, Stripes};
use crate::document::{Body, BodyEllipse, BodyMark, Document, Layer, LayerOptions};
use crate::marks::axial;
use crate::synth::body::area_form::AreaForm;
use crate::synth::body::choice::Choice;
use crate::synth::body::pair_form::PairForm;
use crate::synth::body::refusals;
use crate::synth::drawn::sketch_targets::region_map;
use crate::synth::error::LayerError;
use crate::synth::marks::plan::free_spacing;
use crate::synth::marks::plan::spread_limits::limited;
use crate::synth::training::Training;

/// What a layer asks for.
#[derive(Clone, Debug)]
pub struct Asked {
    /// The index of the layer.
    pub layer: usize,
    /// What grows it.
    pub choice: Choice,
    /// The pair of its stripes with tips; `None` of other marks.
    pub pair: Option<PairForm>,
    /// What each region asks for, row by row, or the whole sketch; none where nothing is drawn on the canvas.
    pub regions: Vec<Attributes>,
    /// How much the spots of each region vary.
    pub spreads: Vec<Spread>,
    /// What of this spread cannot be reached.
    pub notes: Vec<String>,
    /// Whether nothing says how far apart spots are: their spacing follows their area.
    pub is_free: bool,
    /// Columns of regions.
    pub columns: usize,
    /// What the marks on the model ask for. The angles of ellipses count from the projected axis of the model. Paths turn the directions
    /// of the sketch, so that its stripes run along them.
    pub marks: Vec<Attributes>,
}

impl Asked {
    /// Reads what layer `index` of a document asks for; `drawn` is the spacing of each mark on the model where its neighbours say it.
    ///
    /// # Errors
    /// A stroke that is no mark, or a system that does not grow it: file, place, value, what is allowed.
    pub fn read(
        document: &Document,
        index: usize,
        body: &Body,
        drawn: &[Option<f64>],
        source: &str,
        training: &Training,
    ) -> Result<Self, LayerError> {
        let layer = &document.layers[index];
        let pinned = document.regions.filter(|_| !body.pins.is_empty()).unwrap_or([1, 1]);
        let (mut regions, mut asked_spreads, mut is_given) = (Vec::new(), Vec::new(), false);
        let sketch = Document { regions: Some(pinned), ..document.clone() };
        let mut pair = None;
        if let Some((form, of_regions)) = PairForm::read(&sketch, index, source, training)? {
            (pair, regions) = (Some(form), of_regions);
        } else if !layer.strokes.is_empty() {
            let map = region_map(&sketch, index, source)?;
            regions = map.of_regions();
            asked_spreads = map.regions().map(|(_, region)| region.spread).collect();
            is_given = map.spread_is_given();
        }
        let angle = regions.first().map_or(0.0, Attributes::angle);
        let marks: Vec<Attributes> = layer.on_model.iter().map(|mark| of_mark(mark, layer, angle)).collect();
        let all: Vec<Attributes> = regions.iter().chain(&marks).copied().collect();
        let areas = AreaForm::of(document, index, &all);
        let undrawn = areas.filter(|_| all.is_empty()).and_then(|form| form.undrawn());
        regions.extend(undrawn);
        asked_spreads.resize(regions.len(), Spread::ZERO);
        let all: Vec<Attributes> = regions.iter().chain(&marks).copied().collect();
        let refused = || refusals::system(layer, index).in_file(source);
        let choice = if pair.is_some() { Choice::of_pair_stripes() } else { Choice::new(layer, &all, areas) };
        let choice = choice.ok_or_else(refused)?;
        let is_free =
            all.iter().all(|wanted| wanted.distance().is_none()) && drawn.iter().all(Option::is_none);
        let regions: Vec<Attributes> =
            regions.into_iter().map(|one| filled(training, &choice, one, None)).collect();
        let usual = regions.first().and_then(Attributes::distance);
        let spaced = |(own, mark): (usize, Attributes)| {
            let spacing = drawn.get(own).copied().flatten().or(usual);
            filled(training, &choice, mark, spacing)
        };
        let marks = marks.into_iter().enumerate().map(spaced).collect();
        let (spreads, mut notes) = possible(&choice, &regions, &asked_spreads, is_given);
        notes.extend(pair.iter().flat_map(|form| form.notes.clone()));
        Ok(Self {
            layer: index,
            choice,
            pair,
            marks,
            regions,
            spreads,
            notes,
            is_free,
            columns: pinned[0] as usize,
        })
    }

    /// These marks, as far apart as those of the layer beneath, inside which they stand.
    #[must_use]
    pub fn spaced_as(mut self, outer: &Self) -> Self {
        let spacing = outer.all().find_map(Attributes::distance);
        let all = self.regions.iter_mut().chain(&mut self.marks);
        for (index, wanted) in all.enumerate() {
            if let Attributes::Spots(spots) = wanted {
                spots.spacing = outer.regions.get(index).and_then(Attributes::distance).or(spacing);
            }
        }
        self
    }

    /// All that is asked for.
    pub fn all(&self) -> impl Iterator<Item = &Attributes> {
        self.regions.iter().chain(&self.marks)
    }

    /// What a region asks for, and how much its spots vary.
    pub(super) fn of_region(&self, [column, row]: [u32; 2]) -> Option<(Attributes, Spread)> {
        let index = row as usize * self.columns + column as usize;
        Some((*self.regions.get(index)?, self.spreads.get(index).copied().unwrap_or(Spread::ZERO)))
    }
}

/// The spread that the spots of each region can have, and notes on what they cannot.
fn possible(
    choice: &Choice,
    regions: &[Attributes],
    asked: &[Spread],
    is_given: bool,
) -> (Vec<Spread>, Vec<String>) {
    let (mut spreads, mut notes) = (Vec::new(), Vec::new());
    for (wanted, asked) in regions.iter().zip(asked) {
        let Attributes::Spots(spots) = wanted else { continue };
        if let Some(form) = &choice.areas {
            spreads.push(form.possible(*asked));
            continue;
        }
        let possible = limited(choice.system, spots, asked, is_given);
        spreads.push(possible.spread);
        notes.extend(possible.notes);
    }
    notes.dedup();
    (spreads, notes)
}

/// With the spacing of spots: their own, one that is given, or the one that the system has by itself.
fn filled(training: &Training, choice: &Choice, wanted: Attributes, given: Option<f64>) -> Attributes {
    let Attributes::Spots(spots) = wanted else { return wanted };
    if let Some(form) = &choice.areas {
        return Attributes::Spots(form.filled(Spots { spacing: spots.spacing.or(given), ..spots }));
    }
    let system = choice.system;
    let free = || free_spacing(training, system, &spots);
    let spacing = if system.description().free_spacing { spots.spacing.or(given) } else { None };
    Attributes::Spots(Spots { spacing: Some(spacing.unwrap_or_else(free)), ..spots })
}

/// What a mark asks for; stripes that run along paths have this `angle`.
fn of_mark(mark: &BodyMark, layer: &Layer, angle: f64) -> Attributes {
    match mark {
        BodyMark::Ellipse(ellipse) => Attributes::Spots(of_ellipse(ellipse)),
        BodyMark::Path { width, .. } => {
            let known = layer.system.system();
            let duty = layer.options.duty.given().filter(|duty| *duty != LayerOptions::DUTY);
            let is_free = known.map(|system| system.description().free_spacing);
            let wavelength = match (is_free, duty) {
                (Some(false), _) | (None, None) => None,
                (_, duty) => Some(width / duty.unwrap_or(LayerOptions::DUTY)),
            };
            Attributes::Stripes(Stripes { width: *width, angle, wavelength })
        }
    }
}

fn of_ellipse(mark: &BodyEllipse) -> Spots {
    let [along, across] = mark.radii;
    let (aspect, angle) =
        (along.min(across) / along.max(across), if along < across { mark.angle + 90.0 } else { mark.angle });
    Spots { area: std::f64::consts::PI * along * across, aspect, angle: axial(angle), spacing: None }
}
