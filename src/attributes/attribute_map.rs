//! What a sketch wants at any place of the canvas: by regions, or by free marks.

use super::free::{FreeMap, FreeRules, PeriodRules};
use super::modulation::Modulation;
use super::regions::{Region, RegionGrid, RegionMap, RegionsError};
use super::{Attributes, Polarity, Spots, Spread, Stripes, axial_mean};
use crate::grid::Edges;
use crate::marks::Mark;

/// Nodes a region along each side at which parameters are looked up; odd, so that region centres, where attributes bend,
/// are nodes.
const FINER: [usize; 3] = [5, 3, 1];
/// With so many nodes along a side, or fewer, parameters are smooth enough; of more regions each has one.
const MOST_NODES: usize = 64;
/// Regions along a side by which free marks are blended with others, at most.
const MOST_BLENDED: usize = 8;
/// Width ÷ wavelength of stripes by themselves, and how near to it a duty counts as the same.
const USUAL_DUTY: f64 = 0.5;
/// See [`USUAL_DUTY`].
const SAME_DUTY: f64 = 0.02;

/// Attributes at any place of the canvas.
#[derive(Clone, Debug, PartialEq)]
pub struct AttributeMap {
    source: Source,
    spread_is_given: bool,
    /// Are stripes left the wavelength of their system?
    wavelength_is_free: bool,
    /// By what maps it varies.
    modulated: Option<Box<Modulated>>,
}

/// A modulation of a map.
#[derive(Clone, Debug, PartialEq)]
struct Modulated {
    by: Modulation,
    /// Was the spacing of the spots free before it was filled in?
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

    /// The same once marks have been changed, before which free ellipses wanted the spacing `far_before` far from all of them, px.
    ///
    /// # Errors
    /// As [`Self::from_marks`].
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
        Self { source, spread_is_given: false, wavelength_is_free: false, modulated: None }
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
    /// As [`Self::from_marks`].
    pub fn of_threads(
        marks: &[Mark],
        size: [f64; 2],
        regions: Option<[usize; 2]>,
        edges: Edges,
        rules: PeriodRules,
    ) -> Result<Self, RegionsError> {
        let source = match regions {
            Some(grid) => {
                Source::Regions(RegionMap::from_marks(marks, size, grid, edges)?.with_duty(rules.alone))
            }
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

    /// The same map varied by this modulation, in place of any other.
    #[must_use]
    pub fn modulated(self, by: Modulation) -> Self {
        let spacing_follows = !by.replaces_spacing()
            && self
                .samples()
                .iter()
                .any(|wanted| matches!(wanted, Attributes::Spots(Spots { spacing: None, .. })));
        let modulated = Modulated { by, spacing_follows, densest: f64::INFINITY };
        Self { modulated: Some(Box::new(modulated)), ..self }
    }

    /// Whether maps vary it.
    #[must_use]
    pub fn is_modulated(&self) -> bool {
        self.modulated.is_some()
    }

    /// The attributes wanted at a point, px.
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> Attributes {
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
        if let (None, Source::Regions(map)) = (&self.modulated, &self.source) {
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

    /// The same map with free marks of lines that take the wavelength of their system.
    #[must_use]
    pub fn with_free_wavelength(self) -> Self {
        Self { wavelength_is_free: true, ..self }
    }

    /// Whether all stripes are wanted half as wide as their wavelength, nearly.
    #[must_use]
    pub fn has_usual_duty(&self) -> bool {
        self.samples().iter().all(|wanted| match wanted {
            Attributes::Stripes(Stripes { width, wavelength: Some(wavelength), .. }) => {
                (width / wavelength - USUAL_DUTY).abs() < SAME_DUTY
            }
            Attributes::Stripes(_) => true,
            Attributes::Spots(_) => false,
        })
    }

    /// That of its stripes: by their [`Self::mean_duty`], since a layer has one polarity.
    #[must_use]
    pub fn polarity(&self) -> Polarity {
        Polarity::of_duty(self.mean_duty())
    }

    /// Width ÷ period of stripes, its mean over the canvas; 0.5 of spots.
    #[must_use]
    pub fn mean_duty(&self) -> f64 {
        let duty = |wanted: &Attributes| match wanted {
            Attributes::Stripes(stripes) => Some(stripes.duty()),
            Attributes::Spots(_) => None,
        };
        let duties: Vec<f64> = self.samples().iter().filter_map(duty).collect();
        if duties.is_empty() { USUAL_DUTY } else { duties.iter().sum::<f64>() / duties.len() as f64 }
    }

    /// What is wanted of a region as a whole: at its centre; of free marks their mean; where maps vary it, the mean over the region.
    #[must_use]
    pub fn of_region(&self, place: [usize; 2]) -> Attributes {
        if let Some(modulated) = &self.modulated {
            return self.mean_over(place, &modulated.by.nodes);
        }
        match &self.source {
            Source::Regions(map) => map.at(map.layout().center(place)),
            Source::Free { whole, .. } => self.freed(whole.filled),
        }
    }

    /// The mean of what is wanted at the nodes of a region; where it has none, what is wanted at its centre.
    fn mean_over(&self, place: [usize; 2], nodes: &RegionGrid) -> Attributes {
        let [columns, rows] = [0, 1].map(|axis| {
            let (count, regions) = (nodes.grid[axis], self.layout().grid[axis]);
            place[axis] * count / regions..((place[axis] + 1) * count).div_ceil(regions)
        });
        let centers = rows.flat_map(|row| columns.clone().map(move |column| nodes.center([column, row])));
        let all: Vec<Attributes> =
            centers.filter(|center| self.region_of(*center) == place).map(|center| self.at(center)).collect();
        let Some(first) = all.first() else { return self.at(self.layout().center(place)) };
        let count = all.len() as f64;
        let angle =
            axial_mean(all.iter().map(|one| (one.angle(), 1.0))).map_or(first.angle(), |(angle, _)| angle);
        let mean = |value: &dyn Fn(&Attributes) -> Option<f64>| {
            let sum: Option<f64> = all.iter().map(value).sum();
            sum.map(|sum| sum / count)
        };
        let of_spots = |value: fn(&Spots) -> Option<f64>| {
            mean(&|one| if let Attributes::Spots(spots) = one { value(spots) } else { None })
        };
        let of_stripes = |value: fn(&Stripes) -> Option<f64>| {
            mean(&|one| if let Attributes::Stripes(stripes) = one { value(stripes) } else { None })
        };
        match first {
            Attributes::Spots(spots) => Attributes::Spots(Spots {
                area: of_spots(|spots| Some(spots.area)).unwrap_or(spots.area),
                aspect: of_spots(|spots| Some(spots.aspect)).unwrap_or(spots.aspect),
                angle,
                spacing: of_spots(|spots| spots.spacing),
            }),
            Attributes::Stripes(stripes) => Attributes::Stripes(Stripes {
                width: of_stripes(|stripes| Some(stripes.width)).unwrap_or(stripes.width),
                angle,
                wavelength: of_stripes(|stripes| stripes.wavelength),
            }),
        }
    }

    /// What is wanted of each region as a whole, row by row.
    #[must_use]
    pub fn of_regions(&self) -> Vec<Attributes> {
        self.regions().map(|(place, _)| self.of_region(place)).collect()
    }

    /// What is wanted at so many places that nothing finer or coarser is wanted anywhere.
    #[must_use]
    pub fn samples(&self) -> Vec<Attributes> {
        if let Some(modulated) = &self.modulated {
            let nodes = modulated.by.nodes;
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

    /// Whether no region has a spread.
    #[must_use]
    pub fn is_without_spread(&self) -> bool {
        self.regions().all(|(_, region)| region.spread.is_zero())
    }

    /// The same map with this spread everywhere, instead of the drawn one.
    #[must_use]
    pub fn with_spread(self, spread: Spread) -> Self {
        let source = match self.source {
            Source::Regions(map) => Source::Regions(map.with_spread(spread)),
            Source::Free { map, layout, mut whole } => {
                whole.spread = spread;
                Source::Free { map, layout, whole }
            }
        };
        Self { source, spread_is_given: true, ..self }
    }

    /// Whether the spread was given by [`Self::with_spread`], not drawn.
    #[must_use]
    pub fn spread_is_given(&self) -> bool {
        self.spread_is_given
    }

    /// The same map with stripes of this duty cycle: width ÷ wavelength, 0..1.
    #[must_use]
    pub fn with_duty(self, duty: f64) -> Self {
        self.changed(|map| map.with_duty(duty), |map| map.with_duty(duty))
    }

    /// (cos 2θ, sin 2θ) of the angle θ that [`Self::at`] has there, found without a transcendental function.
    #[must_use]
    pub fn double_angle_at(&self, point: [f64; 2]) -> [f64; 2] {
        if self.modulated.as_ref().is_some_and(|modulated| modulated.by.turns()) {
            let double = (2.0 * self.at(point).angle()).to_radians();
            return [libm::cos(double), libm::sin(double)];
        }
        match &self.source {
            Source::Regions(map) => map.double_angle_at(point),
            Source::Free { map, .. } => map.double_angle_at(point),
        }
    }

    /// Gives each free spacing the one (px) that `spacing` returns for its spots.
    pub fn fill_free_spacing(&mut self, mut spacing: impl FnMut(&Spots) -> f64) {
        match &mut self.source {
            Source::Regions(map) => map.fill_free_spacing(spacing),
            Source::Free { map, whole, .. } => {
                map.fill_free_spacing(&mut spacing);
                whole.filled = map.mean();
            }
        }
    }

    /// Widens the spacing of free spots where area ÷ spacing² is more than this. Returns whether it was anywhere; never in
    /// regions.
    pub fn limit_density(&mut self, most: f64) -> bool {
        match &mut self.source {
            Source::Regions(_) => false,
            Source::Free { map, whole, .. } => {
                let limited = map.limit_density(most);
                whole.filled = map.mean();
                self.modulated.iter_mut().for_each(|modulated| modulated.densest = most);
                limited
            }
        }
    }

    /// The same map on a canvas of another size, px: places stretch, sizes and spacings stay.
    #[must_use]
    pub fn resized(&self, size: [f64; 2]) -> Self {
        let source = match &self.source {
            Source::Regions(map) => Source::Regions(map.resized(size)),
            Source::Free { map, layout, whole } => {
                let map = Box::new(map.resized(size));
                Source::Free { map, layout: RegionGrid { size, ..*layout }, whole: *whole }
            }
        };
        let resized = |modulated: &Modulated| Modulated { by: modulated.by.resized(size), ..*modulated };
        Self { source, modulated: self.modulated.as_deref().map(resized).map(Box::new), ..*self }
    }

    /// The same map with these spacings, px, by region; `None` = as it is.
    #[must_use]
    pub fn with_spacings(&self, spacings: &[Option<f64>]) -> Self {
        let given = spacings.first().copied().flatten();
        self.clone().changed(|map| map.with_spacings(spacings), |map| map.with_spacing(given))
    }

    /// The map on the way from this one (`share` 0) to `other` (1), see [`RegionMap::blended`].
    ///
    /// `None` where one has spots and the other stripes.
    #[must_use]
    pub fn blended(&self, other: &Self, share: f64) -> Option<Self> {
        self.by_regions().blended(&other.by_regions(), share).map(Self::from)
    }

    /// The same map by regions: free marks are sampled.
    fn by_regions(&self) -> RegionMap {
        match &self.source {
            _ if self.is_modulated() => {
                let grid = self.nodes().grid.map(|n| n.min(MOST_BLENDED));
                let layout = RegionGrid { grid, ..*self.layout() };
                let at = |index: usize| self.at(layout.center(layout.place(index)));
                RegionMap::from_attributes(layout, (0..layout.len()).map(at))
            }
            Source::Regions(map) => map.clone(),
            Source::Free { map, layout, .. } => {
                let grid = map.nodes().grid.map(|n| n.min(MOST_BLENDED));
                let layout = RegionGrid { grid, ..*layout };
                let at = |index: usize| map.at(layout.center(layout.place(index)));
                RegionMap::from_attributes(layout, (0..layout.len()).map(at))
            }
        }
    }

    fn changed(
        self,
        regions: impl FnOnce(RegionMap) -> RegionMap,
        free: impl FnOnce(FreeMap) -> FreeMap,
    ) -> Self {
        let source = match self.source {
            Source::Regions(map) => Source::Regions(regions(map)),
            Source::Free { map, layout, mut whole } => {
                let map = Box::new(free(*map));
                whole.filled = map.mean();
                Source::Free { map, layout, whole }
            }
        };
        Self { source, ..self }
    }
}

impl From<RegionMap> for AttributeMap {
    fn from(map: RegionMap) -> Self {
        let spread_is_given = map.spread_is_given();
        Self { spread_is_given, ..Self::of(Source::Regions(map)) }
    }
}
