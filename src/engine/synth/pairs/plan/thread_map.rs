//! The wanted threads of one direction, at any place.

use crate::attributes::modulation::{Modulated, Modulation};
use crate::attributes::periods::PeriodRules;
use crate::attributes::{AttributeMap, Attributes, Stripes};
use crate::document::{Document, DutyChoice, LayerOptions};
use crate::grid::Bounds;
use crate::marks::{Mark, Path, turn};
use crate::rd::pairs::Threads;

/// Share of the canvas that threads of each direction cover if lines are not drawn side by side, for two directions and for more.
/// Two directions from noise cover 0.28 each at a threshold of 0.15 (`facts.md` T); three of 0.2 leave half of the canvas free.
pub const OWN_DUTY: [f64; 2] = [0.28, 0.2];
/// Directions that differ by less than this, degrees, count as equal. With equal directions and periods (see [`EVEN`]) one size
/// suffices for the whole canvas.
const STRAIGHT: f64 = 1.0;
/// Relative difference of periods below which they count as equal.
const EVEN: f64 = 0.02;
/// Places along a side at which widths are looked up for their mean.
const SAMPLES: usize = 16;

/// The threads of one direction.
#[derive(Clone, Debug)]
pub struct ThreadMap {
    /// The drawn lines, by their indices among the strokes of the layer, where they lie on the canvas that is grown.
    pub lines: Vec<(usize, Path)>,
    /// Width, period and direction at each place.
    map: AttributeMap,
    /// Factor by which they are farther apart than drawn, because they would cover too much.
    pub widened: f64,
    /// If a map varies the duty, its mean over the canvas.
    mean_duty: Option<f64>,
}

impl ThreadMap {
    /// Reads the `lines` of one direction of a layer with these `options`, on a canvas of `size` px; their places are those on the
    /// document's own canvas. The `rules` give the periods that they can have.
    #[must_use]
    pub fn new(
        document: &Document,
        options: &LayerOptions,
        lines: &[(usize, Path)],
        rules: PeriodRules,
        size: [f64; 2],
    ) -> Option<Self> {
        let own = document.size.map(f64::from);
        let regions = document.regions.map(|regions| regions.map(|n| n as usize));
        let marks: Vec<Mark> = lines.iter().map(|(_, line)| Mark::Path(line.clone())).collect();
        let map = AttributeMap::of_threads(&marks, own, regions, document.edges, rules).ok()?.resized(size);
        let map = match options.duty {
            DutyChoice::Given(duty) => map.with_duty(duty),
            DutyChoice::Drawn => map,
        };
        let [x, y] = [0, 1].map(|axis| size[axis] / own[axis]);
        let moved = |(index, line): &(usize, Path)| {
            let [from_x, from_y] = line.center();
            (*index, line.shifted([(x - 1.0) * from_x, (y - 1.0) * from_y]))
        };
        Some(Self { lines: lines.iter().map(moved).collect(), map, widened: 1.0, mean_duty: None })
    }

    /// This map varied by the maps of its layer. If these replace directions, the direction is the one of the map plus `turned`
    /// degrees.
    #[must_use]
    pub fn varied(self, by: &Modulation, turned: f64) -> Self {
        let map = self.map.modulated(by.turned(turned));
        let mean_duty = by.changes(Modulated::Duty).then(|| map.mean_duty());
        Self { map, mean_duty, ..self }
    }

    /// If a map varies the share of the period that threads cover, the mean of this share over the canvas.
    #[must_use]
    pub fn mean_duty(&self) -> Option<f64> {
        self.mean_duty
    }

    /// Width and period of the threads that are grown at a point, px. If a map varies the duty, these threads have its mean, since
    /// a system of pairs has one threshold everywhere; the wanted width is cut from them.
    #[must_use]
    pub fn grown_at(&self, point: [f64; 2]) -> Threads {
        let threads = self.threads_at(point);
        Threads { width: self.mean_duty.map_or(threads.width, |duty| duty * threads.period), ..threads }
    }

    /// Whether threads run along the drawn lines. False if maps vary them: lines are then examples and have no fixed places.
    #[must_use]
    pub fn keeps_lines(&self) -> bool {
        !self.map.is_modulated()
    }

    /// Width, period (px) and direction wanted at a point, px.
    #[must_use]
    pub fn at(&self, point: [f64; 2]) -> Stripes {
        self.of(self.map.at(point))
    }

    /// The `wanted` stripes, with the period of these threads.
    fn of(&self, wanted: Attributes) -> Stripes {
        let Attributes::Stripes(stripes) = wanted else { unreachable!("made of lines") };
        Stripes { wavelength: Some(self.widened * stripes.width / stripes.duty()), ..stripes }
    }

    /// Width and period wanted at a point, px.
    #[must_use]
    pub fn threads_at(&self, point: [f64; 2]) -> Threads {
        let stripes = self.at(point);
        Threads { width: stripes.width, period: stripes.width / stripes.duty() }
    }

    /// (cos 2θ, sin 2θ) of the direction θ at a point, px.
    #[must_use]
    pub fn double_angle_at(&self, point: [f64; 2]) -> [f64; 2] {
        self.map.double_angle_at(point)
    }

    /// The map of what was drawn.
    #[must_use]
    pub fn map(&self) -> &AttributeMap {
        &self.map
    }

    /// The threads of the layer as a whole: at the centre of the middle region; for free marks their mean.
    #[must_use]
    pub fn mean(&self) -> Stripes {
        let layout = self.map.layout();
        self.of(self.map.of_region(layout.place(layout.len() / 2)))
    }

    /// The threads of each region, row by row.
    #[must_use]
    pub fn of_regions(&self) -> Vec<Stripes> {
        let layout = self.map.layout();
        (0..layout.len()).map(|region| self.of(self.map.of_region(layout.place(region)))).collect()
    }

    /// The mean width that is wanted over the whole canvas, px.
    #[must_use]
    pub fn mean_width(&self, canvas: &Bounds) -> f64 {
        let place = |k: usize, axis: usize| (k as f64 + 0.5) / SAMPLES as f64 * canvas.size[axis];
        let width = |k: usize| self.at([place(k % SAMPLES, 0), place(k / SAMPLES, 1)]).width;
        (0..SAMPLES * SAMPLES).map(width).sum::<f64>() / (SAMPLES * SAMPLES) as f64
    }

    /// Whether all threads are straight and equally far apart.
    #[must_use]
    pub fn is_even(&self) -> bool {
        let mean = self.mean();
        let period = mean.width / mean.duty();
        let nodes = self.map.nodes();
        (0..nodes.len()).all(|index| {
            let here = self.at(nodes.center(nodes.place(index)));
            turn(here.angle, mean.angle).abs() <= STRAIGHT
                && (here.width / here.duty() / period - 1.0).abs() <= EVEN
        })
    }
}
