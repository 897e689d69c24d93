//! The region map: attributes at any point of the canvas.

use thiserror::Error;

use super::RegionGrid;
use crate::attributes::moments::weighted_variation;
use crate::attributes::periods::{PeriodRules, grouped_periods};
use crate::attributes::spacing::{WeightedEdge, grouped_neighbours, mean_length};
use crate::attributes::{Attributes, Spots, Spread, Stripes};
use crate::grid::{Edges, atan2};
use crate::marks::{Ellipse, Mark, Path, axial};

/// Above this mean aspect a region has no direction of its own (`docs/format.md`, *region map*).
pub(super) const ROUND: f64 = 0.9;

/// Fewer marks than this have no spread: their differences may be accidental.
pub const MARKS_OF_A_SPREAD: usize = 6;

/// Below this squared length a sum of unit double-angle vectors has cancelled: rounding leaves some 1e-32.
const CANCELLED: f64 = 1e-24;

/// Why there is no region map of some marks.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RegionsError {
    /// There are no marks.
    #[error("no marks: draw at least one ellipse or line")]
    NoMarks,
    /// There are both ellipses and lines.
    #[error("{ellipses} ellipses and {lines} lines: a layer holds ellipses or lines, not both")]
    Mixed {
        /// How many ellipses.
        ellipses: usize,
        /// How many lines.
        lines: usize,
    },
    /// The canvas has no extent or no regions.
    #[error(
        "a canvas of {size:?} px in {grid:?} regions: both sides must be above 0, and at least [1, 1] regions"
    )]
    Layout {
        /// Width and height, px.
        size: [f64; 2],
        /// Columns and rows.
        grid: [usize; 2],
    },
}

/// One region: the attributes of the marks drawn in it, and those that the map has there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region {
    /// How many marks have their centre in it.
    pub marks: usize,
    /// Attributes of those marks; `None` without any. The period of lines that do not lie side by side is that of the nearest region
    /// in which some do.
    pub own: Option<Attributes>,
    /// `own`, or those of the nearest region with marks. The angle is that of the marks even where they
    /// are round; the map turns it, see [`RegionMap::at`].
    pub filled: Attributes,
    /// How much the marks that `filled` is the mean of vary, where they are at least six ellipses;
    /// else [`Spread::ZERO`].
    pub spread: Spread,
    /// (cos 2θ, sin 2θ) of the direction that the map has at the region's centre.
    direction: [f64; 2],
}

/// Attributes at any point of the canvas, from marks gathered by region.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionMap {
    layout: RegionGrid,
    regions: Vec<Region>,
    spread_is_given: bool,
}

impl Region {
    /// The whole canvas as a region with these attributes of its `marks`.
    pub(in crate::attributes) fn whole(marks: usize, attributes: Attributes, spread: Spread) -> Self {
        let double = (2.0 * attributes.angle()).to_radians();
        let direction = [libm::cos(double), libm::sin(double)];
        Self { marks, own: Some(attributes), filled: attributes, spread, direction }
    }
}

impl RegionMap {
    /// The map in which the regions of `layout` have these attributes, all of one kind, without spread.
    pub(in crate::attributes) fn from_attributes(
        layout: RegionGrid,
        attributes: impl Iterator<Item = Attributes>,
    ) -> Self {
        let region = |filled: Attributes| Region::whole(1, filled, Spread::ZERO);
        Self { layout, regions: attributes.map(region).collect(), spread_is_given: false }
    }

    /// The map of `marks` on a canvas of `size` px, cut into `grid` = [columns, rows] regions.
    ///
    /// A mark belongs to the region its centre is in. A region without marks takes the attributes of the
    /// nearest one with some; a region of spots with a mean aspect above 0.9 takes the direction of the
    /// nearest region that has one (along x if none has). Distances are in regions, across the border on
    /// `Wrap`; ties go to the smaller row, then the smaller column.
    ///
    /// The period of stripes is the mean distance of the lines of a region that lie side by side, as between free ones. A region in
    /// which none do takes that of the nearest region in which some do; where there is none, stripes are half as wide as their period.
    ///
    /// # Errors
    /// Without marks, with ellipses and lines mixed, and for a canvas without extent or regions.
    pub fn from_marks(
        marks: &[Mark],
        size: [f64; 2],
        grid: [usize; 2],
        edges: Edges,
    ) -> Result<Self, RegionsError> {
        Self::with_rules(marks, size, grid, edges, PeriodRules::STRIPES)
    }

    /// The map of `marks` on a canvas of `size` px, cut into [columns, rows] regions, with lines that want the periods that these
    /// `rules` allow.
    ///
    /// # Errors
    /// Those of [`Self::from_marks`].
    pub fn with_rules(
        marks: &[Mark],
        size: [f64; 2],
        grid: [usize; 2],
        edges: Edges,
        rules: PeriodRules,
    ) -> Result<Self, RegionsError> {
        let sound = size.iter().all(|side| side.is_normal() && *side > 0.0) && !grid.contains(&0);
        if !sound {
            return Err(RegionsError::Layout { size, grid });
        }
        let layout = RegionGrid { size, grid, edges };
        let ellipses = gather(&layout, marks, Mark::ellipse);
        let lines = gather(&layout, marks, Mark::path);
        let count = |counts: &mut dyn Iterator<Item = usize>| counts.sum::<usize>();
        let owns: Vec<Own> =
            match (count(&mut ellipses.iter().map(Vec::len)), count(&mut lines.iter().map(Vec::len))) {
                (0, 0) => return Err(RegionsError::NoMarks),
                (_, 0) => {
                    let neighbours = neighbours(&layout, marks);
                    ellipses.iter().zip(&neighbours).map(|(set, edges)| spots(set, edges)).collect()
                }
                (0, _) => {
                    let periods = periods(&layout, marks, &rules);
                    lines.iter().zip(periods).map(|(set, period)| stripes(set, period, &rules)).collect()
                }
                (ellipses, lines) => return Err(RegionsError::Mixed { ellipses, lines }),
            };
        Ok(Self { layout, regions: fill(&layout, &owns), spread_is_given: false })
    }

    /// Where the regions lie.
    #[must_use]
    pub fn layout(&self) -> &RegionGrid {
        &self.layout
    }

    /// The regions with their [column, row], row by row.
    pub fn regions(&self) -> impl ExactSizeIterator<Item = ([usize; 2], &Region)> {
        self.regions.iter().enumerate().map(|(index, region)| (self.layout.place(index), region))
    }

    /// The region at [column, row].
    ///
    /// # Panics
    /// Outside the layout.
    #[must_use]
    pub fn region(&self, place: [usize; 2]) -> &Region {
        &self.regions[self.layout.index(place)]
    }

    /// [column, row] of the region that a point (px) lies in, see [`RegionGrid::region_of`].
    #[must_use]
    pub fn region_of(&self, point: [f64; 2]) -> [usize; 2] {
        self.layout.region_of(point)
    }

    /// The attributes wanted at a point (px).
    ///
    /// Bilinear between the region centres, each attribute by itself: area, aspect, spacing and width the
    /// value, the angle the unit double-angle vector; beyond the outer centres clamped (`Closed`) or wrapped
    /// (`Wrap`). Where the vectors cancel, the angle is that of the region with the largest weight. The
    /// spacing is free (`None`) wherever a region with a free one has a weight.
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> Attributes {
        let corners = self.layout.corners(point);
        let angle = angle_of(self.blend_directions(&corners));
        match &self.regions[corners[0].0].filled {
            Attributes::Stripes(_) => {
                let mut blend = Stripes { width: 0.0, angle, wavelength: Some(0.0) };
                for (i, weight) in corners {
                    let stripes = self.stripes_of(i);
                    blend.width += weight * stripes.width;
                    blend.wavelength =
                        blend.wavelength.zip(stripes.wavelength).map(|(sum, one)| sum + weight * one);
                }
                Attributes::Stripes(blend)
            }
            Attributes::Spots(_) => {
                let mut blend = Spots { area: 0.0, aspect: 0.0, angle, spacing: Some(0.0) };
                for (i, weight) in corners.into_iter().filter(|(_, weight)| *weight > 0.0) {
                    let spots = self.spots_of(i);
                    blend.area += weight * spots.area;
                    blend.aspect += weight * spots.aspect;
                    blend.spacing = blend.spacing.zip(spots.spacing).map(|(sum, one)| sum + weight * one);
                }
                // Weights are rounded: their sum can be above 1.
                blend.aspect = blend.aspect.min(1.0);
                Attributes::Spots(blend)
            }
        }
    }

    /// The width (px) of the stripes that [`Self::at`] has there; `None` of spots.
    #[must_use]
    pub fn width_at(&self, point: [f64; 2]) -> Option<f64> {
        match &self.regions[0].filled {
            Attributes::Stripes(_) => {
                let corners = self.layout.corners(point).into_iter();
                Some(corners.fold(0.0, |sum, (i, weight)| sum + weight * self.stripes_of(i).width))
            }
            Attributes::Spots(_) => None,
        }
    }

    /// How much the marks wanted at a point (px) vary: bilinear between the regions, as [`Self::at`].
    #[must_use]
    pub fn spread_at(&self, point: [f64; 2]) -> Spread {
        let corners = self.layout.corners(point);
        corners.iter().fold(Spread::ZERO, |sum, &(i, weight)| {
            sum.with(&self.regions[i].spread, |sum, one| sum + weight * one)
        })
    }

    /// This map with one spread in all regions, instead of the drawn one.
    #[must_use]
    pub fn with_spread(mut self, spread: Spread) -> Self {
        self.regions.iter_mut().for_each(|region| region.spread = spread);
        self.spread_is_given = true;
        self
    }

    /// This map with stripes of one duty cycle: width ÷ wavelength, 0..1.
    #[must_use]
    pub fn with_duty(mut self, duty: f64) -> Self {
        for region in &mut self.regions {
            if let Attributes::Stripes(stripes) = &mut region.filled {
                stripes.wavelength = Some(stripes.width / duty);
            }
        }
        self
    }

    /// This map with stripes that take the wavelength of their system.
    #[must_use]
    pub fn with_free_wavelength(mut self) -> Self {
        for region in &mut self.regions {
            if let Attributes::Stripes(stripes) = &mut region.filled {
                stripes.wavelength = None;
            }
        }
        self
    }

    /// Whether the spread was given by [`Self::with_spread`], not drawn.
    #[must_use]
    pub fn spread_is_given(&self) -> bool {
        self.spread_is_given
    }

    /// (cos 2θ, sin 2θ) of the angle θ that [`Self::at`] has there, found without a transcendental function.
    #[must_use]
    pub fn double_angle_at(&self, point: [f64; 2]) -> [f64; 2] {
        self.blend_directions(&self.layout.corners(point))
    }

    /// Gives each region with a free spacing the one (px) that `spacing` returns for its spots.
    pub fn fill_free_spacing(&mut self, mut spacing: impl FnMut(&Spots) -> f64) {
        for region in &mut self.regions {
            let angle = angle_of(region.direction);
            if let Attributes::Spots(spots) = &mut region.filled
                && spots.spacing.is_none()
            {
                spots.spacing = Some(spacing(&Spots { angle, ..*spots }));
            }
        }
    }

    /// This map with these spacings, px, by region; `None` = unchanged.
    #[must_use]
    pub fn with_spacings(&self, spacings: &[Option<f64>]) -> Self {
        let mut map = self.clone();
        for (region, given) in map.regions.iter_mut().zip(spacings) {
            if let (Attributes::Spots(spots), Some(given)) = (&mut region.filled, given) {
                spots.spacing = Some(*given);
            }
        }
        map
    }

    /// The regions stretched over another canvas of `size` px: marks of unchanged size, more or fewer of them.
    #[must_use]
    pub fn resized(&self, size: [f64; 2]) -> Self {
        Self { layout: RegionGrid { size, ..self.layout }, ..self.clone() }
    }

    /// The blend of the unit double-angle vectors, of unit length again.
    fn blend_directions(&self, corners: &[(usize, f64); 4]) -> [f64; 2] {
        let (mut c, mut s) = (0.0, 0.0);
        for &(i, weight) in corners {
            c += weight * self.regions[i].direction[0];
            s += weight * self.regions[i].direction[1];
        }
        let squared = c * c + s * s;
        if squared > CANCELLED {
            let length = squared.sqrt();
            return [c / length, s / length];
        }
        let nearest = corners.iter().fold(corners[0], |best, &one| if one.1 > best.1 { one } else { best });
        self.regions[nearest.0].direction
    }

    /// The spots of a region of a map of ellipses.
    fn spots_of(&self, index: usize) -> &Spots {
        match &self.regions[index].filled {
            Attributes::Spots(spots) => spots,
            Attributes::Stripes(_) => unreachable!("all regions of a map are of one kind"),
        }
    }

    /// The stripes of a region of a map of lines.
    fn stripes_of(&self, index: usize) -> &Stripes {
        match &self.regions[index].filled {
            Attributes::Stripes(stripes) => stripes,
            Attributes::Spots(_) => unreachable!("all regions of a map are of one kind"),
        }
    }
}

/// The marks for which `pick` gives a value, by region.
fn gather<T>(layout: &RegionGrid, marks: &[Mark], pick: impl Fn(&Mark) -> Option<T>) -> Vec<Vec<T>> {
    let mut sets: Vec<Vec<T>> = (0..layout.len()).map(|_| Vec::new()).collect();
    for mark in marks {
        sets[layout.index(layout.region_of(mark.center()))].extend(pick(mark));
    }
    sets
}

/// What was drawn in a region.
struct Own {
    marks: usize,
    attributes: Option<Attributes>,
    spread: Spread,
}

/// By region, the edges between the centres of its marks that count for its spacing.
fn neighbours(layout: &RegionGrid, marks: &[Mark]) -> Vec<Vec<WeightedEdge>> {
    let centers: Vec<[f64; 2]> = marks.iter().filter_map(|mark| Some(mark.ellipse()?.center)).collect();
    grouped_neighbours(&centers, layout.len(), |index| layout.index(layout.region_of(centers[index])))
}

fn spots(set: &[Ellipse], edges: &[WeightedEdge]) -> Own {
    let lengths = edges.iter().map(|edge| (edge.length, edge.weight));
    let spread = if set.len() >= MARKS_OF_A_SPREAD {
        Spread { spacing: weighted_variation(lengths), ..Spread::measure(set) }
    } else {
        Spread::ZERO
    };
    let spots = Spots::measure(set).map(|spots| Spots { spacing: mean_length(edges), ..spots });
    Own { marks: set.len(), attributes: spots.map(Attributes::Spots), spread }
}

/// By region, the log of the period that its lines want, px: of the nearest region in which lines lie side by side; `None` where there
/// is none.
fn periods(layout: &RegionGrid, marks: &[Mark], rules: &PeriodRules) -> Vec<Option<f64>> {
    let (lines, regions): (Vec<Path>, Vec<usize>) = marks
        .iter()
        .filter_map(|mark| Some((mark.path()?, layout.index(layout.region_of(mark.center())))))
        .unzip();
    let measured = grouped_periods(&lines, &layout.bounds(), rules, layout.len(), |line| regions[line]);
    let nearest = |index| layout.nearest(layout.place(index), |other| measured[other].is_some());
    (0..layout.len()).map(|index| measured[nearest(index)?]).collect()
}

fn stripes(set: &[Path], log_period: Option<f64>, rules: &PeriodRules) -> Own {
    let with_period = |stripes: Stripes| {
        let period = log_period.map_or(stripes.width / rules.alone, |period| {
            libm::exp(rules.possible(period, libm::log(stripes.width)))
        });
        Attributes::Stripes(Stripes { wavelength: Some(period), ..stripes })
    };
    Own { marks: set.len(), attributes: Stripes::measure(set).map(with_period), spread: Spread::ZERO }
}

/// Whether the attributes have a direction of their own.
fn is_directed(attributes: &Attributes) -> bool {
    match attributes {
        Attributes::Spots(spots) => spots.aspect <= ROUND,
        Attributes::Stripes(_) => true,
    }
}

/// Regions from their marks' attributes, of which at least one is there: the empty ones take attributes,
/// then the round ones a direction.
fn fill(layout: &RegionGrid, owns: &[Own]) -> Vec<Region> {
    let near = |index: usize, holds: &dyn Fn(usize) -> bool| layout.nearest(layout.place(index), holds);
    let (filled, spreads): (Vec<Attributes>, Vec<Spread>) = (0..layout.len())
        .filter_map(|index| near(index, &|other| owns[other].attributes.is_some()))
        .filter_map(|other| Some((owns[other].attributes?, owns[other].spread)))
        .unzip();
    let direction = |index: usize| {
        let angle = near(index, &|other| is_directed(&filled[other])).map_or(0.0, |i| filled[i].angle());
        let double = (2.0 * angle).to_radians();
        [libm::cos(double), libm::sin(double)]
    };
    owns.iter()
        .enumerate()
        .map(|(index, own)| Region {
            marks: own.marks,
            own: own.attributes,
            filled: filled[index],
            spread: spreads[index],
            direction: direction(index),
        })
        .collect()
}

/// The axial angle θ, degrees, of (cos 2θ, sin 2θ).
fn angle_of([c, s]: [f64; 2]) -> f64 {
    axial(0.5 * atan2(s, c).to_degrees())
}

#[cfg(test)]
mod tests;

#[cfg(test)]
mod period_tests;
