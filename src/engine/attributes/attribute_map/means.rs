//! What is wanted of regions as a whole, and of all stripes.

use super::{AttributeMap, Source};
use crate::attributes::regions::RegionGrid;
use crate::attributes::{Attributes, Polarity, Spots, Stripes, axial_mean};

/// Width ÷ wavelength of stripes by themselves, and how near to it a duty counts as the same.
const USUAL_DUTY: f64 = 0.5;
/// Difference of two duty cycles below which they count as the same.
const SAME_DUTY: f64 = 0.02;

impl AttributeMap {
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

    /// The polarity of its stripes: by their [`Self::mean_duty`], since a layer has one polarity.
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
        if self.is_modulated() {
            return self.mean_over(place, &self.nodes());
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
}
