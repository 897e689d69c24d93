//! What a sketch wants at any place of the canvas: by regions, or by free marks.

mod changed;
mod means;

use super::free::{FreeMap, FreeRules};
use super::metric_field::MetricField;
use super::modulation::Modulation;
use super::periods::PeriodRules;
use super::regions::{Region, RegionGrid, RegionMap, RegionsError};
use super::{Attributes, Spots, Spread, Stripes};
use crate::grid::Edges;
use crate::marks::Mark;

/// Nodes a region along each side at which parameters are looked up; odd, so that region centres, where attributes bend,
/// are nodes.
const FINER: [usize; 3] = [5, 3, 1];
/// With so many nodes along a side, or fewer, parameters are smooth enough; of more regions each has one.
const MOST_NODES: usize = 64;

/// Attributes at any place of the canvas.
#[derive(Clone, Debug, PartialEq)]
pub struct AttributeMap {
    source: Source,
    spread_is_given: bool,
    /// Whether stripes of free marks are left the wavelength of their system.
    wavelength_is_free: bool,
    /// The modulations by the maps of the layer.
    modulated: Option<Box<Modulated>>,
    /// The metric of the surface on which it is wanted; `None` = on the canvas.
    metric: Option<Box<MetricField>>,
}

/// A modulation of a map.
#[derive(Clone, Debug, PartialEq)]
struct Modulated {
    by: Modulation,
    /// Whether the spacing of the spots was free before it was filled in.
    spacing_follows: bool,
    /// The largest area ÷ spacing² of spots.
    densest: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Source {
    /// Means of the marks of each region.
    Regions(RegionMap),
    /// What each mark wants around it. The whole canvas is one region.
    Free { map: Box<FreeMap>, layout: RegionGrid, whole: Region },
}

impl Source {
    fn of_free(marks: &[Mark], size: [f64; 2], edges: Edges, rules: FreeRules) -> Result<Self, RegionsError> {
        let map = Box::new(FreeMap::with_rules(marks, size, edges, rules)?);
        let whole = Region::whole(marks.len(), map.mean(), map.spread());
        Ok(Self::Free { map, layout: RegionGrid { size, grid: [1, 1], edges }, whole })
    }
}

impl AttributeMap {
    /// The map of `marks` on a canvas of `size` px: by [columns, rows] regions, or `None` = by free marks.
    ///
    /// # Errors
    /// Without marks, with ellipses and lines mixed, and for a canvas without extent or regions.
    pub fn from_marks(
        marks: &[Mark],
        size: [f64; 2],
        regions: Option<[usize; 2]>,
        edges: Edges,
    ) -> Result<Self, RegionsError> {
        Self::after_change(marks, size, regions, edges, None)
    }

    /// The map of `marks` that have been changed, where free ellipses wanted the spacing `far_before`, px, far from all marks
    /// before the change.
    ///
    /// # Errors
    /// Those of [`Self::from_marks`].
    pub fn after_change(
        marks: &[Mark],
        size: [f64; 2],
        regions: Option<[usize; 2]>,
        edges: Edges,
        far_before: Option<f64>,
    ) -> Result<Self, RegionsError> {
        let source = match regions {
            Some(grid) => Source::Regions(RegionMap::from_marks(marks, size, grid, edges)?),
            None => {
                let rules = FreeRules { far_spacing: far_before, ..FreeRules::default() };
                Source::of_free(marks, size, edges, rules)?
            }
        };
        Ok(Self::of(source))
    }

    fn of(source: Source) -> Self {
        Self { source, spread_is_given: false, wavelength_is_free: false, modulated: None, metric: None }
    }

    /// The map of a canvas, as that of `layout`, on which the same is wanted everywhere.
    #[must_use]
    pub fn uniform(layout: &RegionGrid, wanted: Attributes) -> Self {
        let whole = RegionGrid { grid: [1, 1], ..*layout };
        Self::from(RegionMap::from_attributes(whole, std::iter::once(wanted)))
    }

    /// The map of the threads of one direction, which want the periods that these `rules` allow.
    ///
    /// # Errors
    /// Those of [`Self::from_marks`].
    pub fn of_threads(
        marks: &[Mark],
        size: [f64; 2],
        regions: Option<[usize; 2]>,
        edges: Edges,
        rules: PeriodRules,
    ) -> Result<Self, RegionsError> {
        let source = match regions {
            Some(grid) => Source::Regions(RegionMap::with_rules(marks, size, grid, edges, rules)?),
            None => {
                let rules = FreeRules { periods: rules, ..FreeRules::default() };
                Source::of_free(marks, size, edges, rules)?
            }
        };
        Ok(Self::of(source))
    }

    /// The regions that are measured and reported; free marks have one.
    #[must_use]
    pub fn layout(&self) -> &RegionGrid {
        match &self.source {
            Source::Regions(map) => map.layout(),
            Source::Free { layout, .. } => layout,
        }
    }

    /// Whether the marks are free.
    #[must_use]
    pub fn is_free(&self) -> bool {
        matches!(self.source, Source::Free { .. })
    }

    /// The map of free marks.
    #[must_use]
    pub fn free(&self) -> Option<&FreeMap> {
        if let Source::Free { map, .. } = &self.source { Some(map) } else { None }
    }

    /// The nodes at whose centres parameters are looked up.
    #[must_use]
    pub fn nodes(&self) -> RegionGrid {
        if let Some(metric) = &self.metric {
            return *metric.nodes();
        }
        if let Some(modulated) = &self.modulated {
            return modulated.by.nodes;
        }
        match &self.source {
            Source::Regions(map) => {
                let finer = |n: usize| {
                    let times = FINER.into_iter().find(|times| times * n <= MOST_NODES);
                    if n == 1 { 1 } else { times.unwrap_or(1) * n }
                };
                RegionGrid { grid: map.layout().grid.map(finer), ..*map.layout() }
            }
            Source::Free { map, .. } => map.nodes(),
        }
    }

    /// Whether maps vary it, or the metric of a surface.
    #[must_use]
    pub fn is_modulated(&self) -> bool {
        self.modulated.is_some() || self.metric.is_some()
    }

    /// The metric of the surface on which it is wanted.
    #[must_use]
    pub fn metric(&self) -> Option<&MetricField> {
        self.metric.as_deref()
    }

    /// The attributes wanted at a point of the canvas, px.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attribute, AttributeMap};
    /// use dapple_engine::grid::Edges;
    /// use dapple_engine::marks::{Ellipse, Mark};
    ///
    /// // Small spots on the left, large ones on the right.
    /// let spot = |x, area| Mark::Ellipse(Ellipse::from_area([x, 50.0], area, 0.8, 0.0));
    /// let marks = [spot(20.0, 100.0), spot(180.0, 400.0)];
    /// let map = AttributeMap::from_marks(&marks, [200.0, 100.0], Some([2, 1]), Edges::Closed)?;
    /// let area = |x: f64| map.at([x, 50.0]).get(Attribute::Area).unwrap();
    /// assert!(area(20.0) < area(100.0) && area(100.0) < area(180.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> Attributes {
        let wanted = self.wanted_on_surface(point);
        self.metric.as_ref().map_or(wanted, |metric| metric.at(point).to_canvas(wanted))
    }

    /// The attributes wanted at a point, px: on the surface, where there is one.
    fn wanted_on_surface(&self, point: [f64; 2]) -> Attributes {
        let base = self.unmodulated_at(point);
        let Some(modulated) = &self.modulated else { return base };
        match modulated.by.applied(base, point, modulated.spacing_follows) {
            Attributes::Spots(spots) => {
                let least = (spots.area / modulated.densest).sqrt();
                Attributes::Spots(Spots { spacing: spots.spacing.map(|spacing| spacing.max(least)), ..spots })
            }
            stripes @ Attributes::Stripes(_) => stripes,
        }
    }

    /// The width of the stripes wanted at a point, px; `None` of spots.
    #[must_use]
    pub fn width_at(&self, point: [f64; 2]) -> Option<f64> {
        if let (None, None, Source::Regions(map)) = (&self.modulated, &self.metric, &self.source) {
            return map.width_at(point);
        }
        match self.at(point) {
            Attributes::Stripes(stripes) => Some(stripes.width),
            Attributes::Spots(_) => None,
        }
    }

    /// What is wanted there without maps.
    fn unmodulated_at(&self, point: [f64; 2]) -> Attributes {
        match &self.source {
            Source::Regions(map) => map.at(point),
            Source::Free { map, .. } => self.freed(map.at(point)),
        }
    }

    /// Attributes without a wavelength, where that is left to the system.
    fn freed(&self, attributes: Attributes) -> Attributes {
        match attributes {
            Attributes::Stripes(stripes) if self.wavelength_is_free => {
                Attributes::Stripes(Stripes { wavelength: None, ..stripes })
            }
            other => other,
        }
    }

    /// Attributes wanted at sample places, so many that nothing finer or coarser is wanted anywhere.
    #[must_use]
    pub fn samples(&self) -> Vec<Attributes> {
        if self.is_modulated() {
            let nodes = self.nodes();
            return (0..nodes.len()).map(|index| self.at(nodes.center(nodes.place(index)))).collect();
        }
        match &self.source {
            Source::Regions(_) => self.of_regions(),
            Source::Free { map, .. } => {
                let nodes = map.nodes();
                (0..nodes.len()).map(|index| self.at(nodes.center(nodes.place(index)))).collect()
            }
        }
    }

    /// The regions with their [column, row], row by row.
    pub fn regions(&self) -> impl ExactSizeIterator<Item = ([usize; 2], &Region)> {
        let layout = self.layout();
        (0..layout.len()).map(|index| (layout.place(index), self.region(layout.place(index))))
    }

    /// The region at [column, row].
    ///
    /// # Panics
    /// Outside the layout.
    #[must_use]
    pub fn region(&self, place: [usize; 2]) -> &Region {
        match &self.source {
            Source::Regions(map) => map.region(place),
            Source::Free { whole, .. } => whole,
        }
    }

    /// [column, row] of the region that a point (px) lies in.
    #[must_use]
    pub fn region_of(&self, point: [f64; 2]) -> [usize; 2] {
        self.layout().region_of(point)
    }

    /// How much marks vary that are wanted at a point, px: between the regions as their attributes.
    #[must_use]
    pub fn spread_at(&self, point: [f64; 2]) -> Spread {
        match &self.source {
            Source::Regions(map) => map.spread_at(point),
            Source::Free { whole, .. } => whole.spread,
        }
    }

    /// Whether no region has a spread.
    #[must_use]
    pub fn is_without_spread(&self) -> bool {
        self.regions().all(|(_, region)| region.spread.is_zero())
    }

    /// Whether the spread was given by [`Self::with_spread`], not drawn.
    #[must_use]
    pub fn spread_is_given(&self) -> bool {
        self.spread_is_given
    }

    /// (cos 2θ, sin 2θ) of the angle θ that [`Self::at`] has there, found without a transcendental function.
    #[must_use]
    pub fn double_angle_at(&self, point: [f64; 2]) -> [f64; 2] {
        if self.metric.is_some() || self.modulated.as_ref().is_some_and(|modulated| modulated.by.turns()) {
            let double = (2.0 * self.at(point).angle()).to_radians();
            return [libm::cos(double), libm::sin(double)];
        }
        match &self.source {
            Source::Regions(map) => map.double_angle_at(point),
            Source::Free { map, .. } => map.double_angle_at(point),
        }
    }
}

impl From<RegionMap> for AttributeMap {
    fn from(map: RegionMap) -> Self {
        let spread_is_given = map.spread_is_given();
        Self { spread_is_given, ..Self::of(Source::Regions(map)) }
    }
}
