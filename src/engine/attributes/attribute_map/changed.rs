//! Attribute maps with something changed.

use super::{AttributeMap, Modulated, Source};
use crate::attributes::free::FreeMap;
use crate::attributes::metric_field::MetricField;
use crate::attributes::modulation::Modulation;
use crate::attributes::regions::{RegionGrid, RegionMap};
use crate::attributes::{Attributes, Spots, Spread};

/// Regions along a side by which free marks are blended with others, at most.
const MOST_BLENDED: usize = 8;

impl AttributeMap {
    /// This map varied by a modulation, in place of any other.
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

    /// This map of marks that are wanted on the surface with this metric, in place of any other.
    #[must_use]
    pub fn on_surface(self, metric: MetricField) -> Self {
        Self { metric: Some(Box::new(metric)), ..self }
    }

    /// This map of marks that are wanted on the canvas, without the surface.
    #[must_use]
    pub fn without_surface(&self) -> Self {
        Self { metric: None, ..self.clone() }
    }

    /// This map with stripes that take the wavelength of their system.
    #[must_use]
    pub fn with_free_wavelength(self) -> Self {
        let map = self.changed(RegionMap::with_free_wavelength, |map| map);
        Self { wavelength_is_free: true, ..map }
    }

    /// This map with one spread everywhere, instead of the drawn one.
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

    /// This map with stripes of one duty cycle: width ÷ wavelength, 0..1.
    #[must_use]
    pub fn with_duty(self, duty: f64) -> Self {
        self.changed(|map| map.with_duty(duty), |map| map.with_duty(duty))
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

    /// This map on a canvas of another size, px: places stretch, sizes and spacings stay.
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
        let modulated = self.modulated.as_deref().map(resized).map(Box::new);
        Self { source, modulated, metric: self.metric.clone(), ..*self }
    }

    /// This map with these spacings, px, by region; `None` = unchanged.
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

    /// This map by regions: free marks are sampled.
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
