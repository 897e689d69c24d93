//! What is particular to patches, cells and fields of points on a surface: their raggedness or lines, the distances and meshes that follow,
//! and the laws by which their places are laid.

use crate::attributes::system::Description;
use crate::attributes::{Attributes, Spots, Spread};
use crate::document::{After, AreaKind, Document, RaggedChoice, Stroke};
use crate::grid::Bounds;
use crate::learn::{self, Answer};
use crate::marks::Mark;
use crate::points::discs::POINTS_A_SQUARE;
use crate::points::fields::POINTS;
use crate::points::patches::{Patches, Wanted};
use crate::rd::System;
use crate::rd::pairs::polygons::widest_gap;
use crate::synth::areas::plan::patches::{MOST_COVERAGE, USUAL_COVERAGE};
use crate::synth::areas::plan::polygons::{LearntFactors, PolygonForm, USUAL, drawn_gap};
use crate::synth::areas::plan::shapes;
use crate::synth::body::point_form::PointForm;

/// The form of areas on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AreaForm {
    /// Patches of scattered points.
    Patches(PatchForm),
    /// Cells with lines of this width, px, between them.
    Cells(f64),
    /// A field of points.
    Points(PointForm),
}

/// Vertices across a line between cells, and across the side of a cell.
const CELLS: [f64; 2] = [3.0, 12.0];
/// Vertices a distance of the points of patches.
const PATCHES: f64 = 2.5;
/// D_b/Dₐ of the system by whose law places are laid; it cancels out.
const RATIO: f64 = 15.0;

impl AreaForm {
    /// The form of the areas of layer `index` of a document, whose marks are `wanted`; `None` where it asks for others.
    #[must_use]
    pub fn of(document: &Document, index: usize, wanted: &[Attributes]) -> Option<Self> {
        let layer = &document.layers[index];
        if layer.after != After::Between {
            return None;
        }
        if let Some(points) = layer.point_field() {
            return Some(Self::Points(PointForm::new(document, &points, wanted)));
        }
        let marks: Vec<Mark> = layer.strokes.iter().filter_map(Stroke::mark).collect();
        let options = &layer.options;
        Some(match document.areas(index)? {
            AreaKind::Patches => {
                let ragged = match options.ragged {
                    RaggedChoice::Given(sigma) => Ragged::Given(sigma),
                    RaggedChoice::Drawn => Ragged::Drawn(mean_raggedness(&layer.strokes, &marks)),
                };
                Self::Patches(PatchForm { ragged, detail: options.detail })
            }
            AreaKind::Polygons => {
                let canvas = Bounds { size: document.size.map(f64::from), edges: document.edges };
                let smallest = wanted.iter().filter_map(side).fold(f64::INFINITY, f64::min);
                let gap = options.gap.given().or_else(|| drawn_gap(&marks, &canvas));
                Self::Cells(gap.unwrap_or(USUAL * smallest).min(widest_gap(smallest)))
            }
        })
    }

    /// The spread that such areas can have, where this one is asked for: cells have none of their own.
    #[must_use]
    pub fn possible(&self, asked: Spread) -> Spread {
        match self {
            Self::Patches(_) => asked,
            Self::Cells(_) | Self::Points(_) => Spread::ZERO,
        }
    }

    /// The description of what grows.
    #[must_use]
    pub fn description(&self) -> &'static Description {
        match self {
            Self::Patches(_) => AreaKind::Patches.description(),
            Self::Cells(_) => AreaKind::Polygons.description(),
            Self::Points(_) => &POINTS,
        }
    }

    /// What is wanted where nothing is drawn; `None` of areas that need marks.
    #[must_use]
    pub fn undrawn(&self) -> Option<Attributes> {
        if let Self::Points(form) = self { form.undrawn() } else { None }
    }

    /// What is wanted, with the spacing that such areas have or need.
    #[must_use]
    pub fn filled(&self, wanted: Spots) -> Spots {
        let spacing = match self {
            Self::Patches(_) => {
                let of = |coverage: f64| Wanted::spacing_of_coverage(wanted.area, coverage);
                wanted.spacing.unwrap_or_else(|| of(USUAL_COVERAGE)).max(of(MOST_COVERAGE))
            }
            Self::Cells(gap) => cells(*gap).wanted(&wanted).spacing,
            Self::Points(form) => return form.filled(wanted),
        };
        Spots { spacing: Some(spacing), ..wanted }
    }

    /// px a cell of the surface that suits these areas.
    #[must_use]
    pub fn cell(&self, wanted: &Attributes) -> f64 {
        let Attributes::Spots(spots) = wanted else { return f64::INFINITY };
        match self {
            Self::Patches(form) => {
                let patch = form.wanted(wanted, Spread::ZERO);
                patch.map_or(f64::INFINITY, |patch| form.radius(&patch) / PATCHES)
            }
            Self::Cells(gap) => (gap / CELLS[0]).min(spots.area.sqrt() / CELLS[1]),
            Self::Points(form) => form.cell(spots),
        }
    }

    /// The parameters with which `system` lays the places of such areas on cells of `cell` px; nothing reacts.
    #[must_use]
    pub fn law(&self, system: System, wanted: &Attributes, cell: f64) -> Answer {
        let Attributes::Spots(spots) = *wanted else { return answer(*wanted, 1.0, 1.0) };
        let spacing = spots.spacing.unwrap_or(spots.area.sqrt());
        let stretch = match self {
            Self::Patches(_) | Self::Points(_) => spots.aspect,
            Self::Cells(gap) => cells(*gap).wanted(&spots).aspect,
        };
        let root = (system.definition().laws.spacing)(RATIO as f32) * cell / spacing;
        answer(*wanted, root * root, stretch)
    }

    /// d ln area ÷ d ln level at ½.
    #[must_use]
    pub fn level_slope(&self, wanted: &Attributes) -> f64 {
        match self {
            // Labels change from 0 to 1 over a distance of points, about a third of the radius of a patch.
            Self::Patches(_) | Self::Points(_) => -0.5,
            Self::Cells(gap) => level_slope(wanted, *gap),
        }
    }
}

/// √area of spots.
fn side(wanted: &Attributes) -> Option<f64> {
    if let Attributes::Spots(spots) = wanted { Some(spots.area.sqrt()) } else { None }
}

/// The mean raggedness of drawn marks; that of ellipses without any.
fn mean_raggedness(strokes: &[Stroke], marks: &[Mark]) -> f64 {
    let shapes = shapes(strokes, marks);
    let sum: f64 = shapes.iter().map(|shape| shape.raggedness).sum();
    if shapes.is_empty() { 1.0 } else { sum / shapes.len() as f64 }
}

/// Cells with lines of this width, px, whose size follows from the laws alone: nothing reacts on a surface that could make them smaller.
fn cells(gap: f64) -> PolygonForm {
    PolygonForm { gap, relaxed: 0, learnt: LearntFactors::NONE }
}

/// Parameters that only lay places.
fn answer(wanted: Attributes, rate: f64, stretch: f64) -> Answer {
    let parameters =
        learn::Parameters { rate, ratio: Some(RATIO), stretch, direction: 0.0, level: Some(0.5) };
    Answer::of_law(parameters, wanted)
}

/// How ragged patches are, and of how many points they are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchForm {
    /// σ of the noise by which points are claimed, 0 to 1, or the raggedness that is wanted.
    pub ragged: Ragged,
    /// Points a patch.
    pub detail: f64,
}

/// What says how ragged patches are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ragged {
    /// σ.
    Given(f64),
    /// Contour² ÷ contour² of the ellipse of the same moments.
    Drawn(f64),
}

impl PatchForm {
    /// The patch that is wanted where spots of these attributes are.
    #[must_use]
    pub fn wanted(&self, wanted: &Attributes, spread: Spread) -> Option<Wanted> {
        let Attributes::Spots(spots) = wanted else { return None };
        let spacing = spots.spacing?;
        let patch = Wanted {
            area: spots.area,
            spacing,
            aspect: spots.aspect,
            angle: spots.angle,
            raggedness: 1.0,
            spread,
        };
        let raggedness = match self.ragged {
            Ragged::Given(sigma) => patch.raggedness_of(sigma, self.detail),
            Ragged::Drawn(raggedness) => raggedness,
        };
        Some(Wanted { raggedness, ..patch })
    }

    /// The radius of the discs around the points of a patch, px.
    #[must_use]
    pub fn radius(&self, wanted: &Wanted) -> f64 {
        disc(wanted, wanted.points(self.detail))
    }
}

/// The radius of the discs of patches of so many points, px.
#[must_use]
pub fn disc(wanted: &Wanted, points: f64) -> f64 {
    (POINTS_A_SQUARE * wanted.area / points.clamp(Patches::LEAST_DETAIL, Patches::MOST_DETAIL)).sqrt()
}

/// The length over which the pattern changes at an edge, in widths of the lines: in the middle of a line it is 0.03.
pub const SOFT: f64 = 0.15;

/// d ln area ÷ d ln level at ½, for cells of these attributes: the edge moves by 4·[`SOFT`]·gap·d level, along a contour of about 4·√area.
fn level_slope(wanted: &Attributes, gap: f64) -> f64 {
    let Attributes::Spots(spots) = wanted else { return -1.0 };
    -8.0 * SOFT * gap / spots.area.sqrt()
}
