//! Anchors: what is wanted around places of a surface.

use crate::attributes::{Attributes, Spots};
use crate::document::{Body, BodyEllipse, BodyMark, Document, DocumentError, Pin};
use crate::marks::axial;
use crate::surface::{Surface, SurfacePoint};
use crate::synth::body::placed::Scale;
use crate::synth::body::refusals::system;
use crate::synth::drawn::sketch_targets::region_map;
use crate::synth::marks::plan::free_spacing;
use crate::synth::training::Training;

/// What is wanted around a place of a surface.
#[derive(Clone, Debug)]
pub struct Anchor {
    /// Where.
    pub place: SurfacePoint,
    /// What is wanted; the spacing is filled in. The angle counts from +x of the sketch.
    pub wanted: Spots,
    /// What says so.
    pub origin: Origin,
}

/// What an anchor comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The whole sketch, which holds everywhere.
    Sketch,
    /// A pin of the model, by its index, and the region that it pins.
    Pin(usize, [u32; 2]),
    /// A mark on the model, by its index.
    Mark(usize),
}

/// What a layer asks for on a model, before places are known.
#[derive(Clone, Debug)]
pub struct Asked {
    /// What each region asks for, row by row, or the whole sketch; none where nothing is drawn on the canvas.
    pub regions: Vec<Spots>,
    /// Columns of regions.
    pub columns: usize,
    /// What the marks on the model ask for. Their angles count from the projected axis of the model.
    pub marks: Vec<Spots>,
}

impl Asked {
    /// Reads what the only layer of a document asks for; `drawn` is the spacing of each mark on the model where its neighbours say it.
    ///
    /// # Errors
    /// A stroke that is no mark: file, place, value, what is allowed.
    pub fn read(
        document: &Document,
        body: &Body,
        drawn: &[Option<f64>],
        source: &str,
        training: &Training,
    ) -> Result<Self, DocumentError> {
        let layer = &document.layers[0];
        let pinned = document.regions.filter(|_| !body.pins.is_empty()).unwrap_or([1, 1]);
        let mut regions = Vec::new();
        if !layer.strokes.is_empty() {
            let sketch = Document { regions: Some(pinned), ..document.clone() };
            let map = region_map(&sketch, 0, source)?;
            regions = map.of_regions().iter().filter_map(spots).map(|one| filled(training, one)).collect();
        }
        let usual = regions.first().and_then(|one| one.spacing);
        let spacing = |own: usize| drawn.get(own).copied().flatten().or(usual);
        let marks = ellipses(&layer.on_model)
            .enumerate()
            .map(|(own, (_, mark))| filled(training, of_mark(mark, spacing(own))));
        Ok(Self { marks: marks.collect(), regions, columns: pinned[0] as usize })
    }

    /// All that is asked for.
    pub fn all(&self) -> impl Iterator<Item = &Spots> {
        self.regions.iter().chain(&self.marks)
    }

    fn of_region(&self, [column, row]: [u32; 2]) -> Option<Spots> {
        self.regions.get(row as usize * self.columns + column as usize).copied()
    }
}

/// The ellipses among marks on a model, by their index.
pub fn ellipses(marks: &[BodyMark]) -> impl Iterator<Item = (usize, &BodyEllipse)> {
    marks.iter().enumerate().filter_map(|(index, mark)| match mark {
        BodyMark::Ellipse(one) => Some((index, one)),
        BodyMark::Path { .. } => None,
    })
}

/// Where a mark is on a surface.
#[must_use]
pub fn place_of(mark: &BodyEllipse, surface: &Surface, scale: &Scale) -> SurfacePoint {
    let at = scale.to_px(mark.at);
    match mark.normal {
        Some(normal) => surface.closest_facing(at, normal),
        None => surface.closest(at),
    }
}

fn spots(attributes: &Attributes) -> Option<Spots> {
    if let Attributes::Spots(spots) = attributes { Some(*spots) } else { None }
}

/// With the spacing that the system has by itself where it is free.
fn filled(training: &Training, spots: Spots) -> Spots {
    let spacing = spots.spacing.unwrap_or_else(|| free_spacing(training, system(), &spots));
    Spots { spacing: Some(spacing), ..spots }
}

fn of_mark(mark: &BodyEllipse, spacing: Option<f64>) -> Spots {
    let [along, across] = mark.radii;
    let (aspect, angle) =
        (along.min(across) / along.max(across), if along < across { mark.angle + 90.0 } else { mark.angle });
    Spots { area: std::f64::consts::PI * along * across, aspect, angle: axial(angle), spacing }
}

/// The anchors on a surface: pins and marks on the model; the sketch itself where it has neither.
#[must_use]
pub fn anchors(
    asked: &Asked,
    document: &Document,
    body: &Body,
    surface: &Surface,
    scale: &Scale,
) -> Vec<Anchor> {
    let pin = |(index, pin): (usize, &Pin)| {
        let wanted = asked.of_region(pin.region)?;
        Some(Anchor {
            place: surface.closest(scale.to_px(pin.at)),
            wanted,
            origin: Origin::Pin(index, pin.region),
        })
    };
    let mut anchors: Vec<Anchor> = body.pins.iter().enumerate().filter_map(pin).collect();
    for ((index, mark), wanted) in ellipses(&document.layers[0].on_model).zip(&asked.marks) {
        let place = place_of(mark, surface, scale);
        anchors.push(Anchor { place, wanted: *wanted, origin: Origin::Mark(index) });
    }
    if let (true, Some(wanted)) = (anchors.is_empty(), asked.regions.first()) {
        // Where it stands does not matter: there is no other.
        anchors.push(Anchor { place: surface.place_of(0), wanted: *wanted, origin: Origin::Sketch });
    }
    anchors
}
