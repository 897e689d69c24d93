//! Plans of fields of points.

use crate::attributes::modulation::{Modulated, Modulation};
use crate::attributes::{AttributeMap, Attributes, Spots};
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::limits::{POINT_DISTANCE, POINT_SHARE};
use crate::document::{
    Document, DocumentError, Interpolation, Kind, Labels, Points, Problem, Progression, ToneImage, Towards,
};
use crate::grid::distance::{length, nearest};
use crate::grid::{Bounds, Edges, Grid};
use crate::points::discs::Laying;
use crate::points::extent::Extent;
use crate::points::fields::{Labelling, Shift, expected_points, frame};
use crate::points::metric::Metric;
use crate::synth::drawn::maps::modulation;
use crate::synth::drawn::sketch_targets::{marks, region_map};

/// Cells of the grid per radius of the finest discs. With 3, as for patches, creases of folded fields looked like beads, and the
/// share of forty points had an error of 0.4 %.
const CELLS: f64 = 6.0;
/// Cells of the grid per radius of the finest discs if fields are folded: their creases have no width.
const FOLDED: f64 = 24.0;
/// Smallest cell of interpolated fields, px: finer details cannot be seen on the canvas.
const SMALLEST: f64 = 1.0;
/// The cell of fields without interpolation, px: a px then shows the mean of four cells, so that corners have no steps.
const SHARP: f64 = 0.5;
/// Largest cell, px ÷ the longer side of the canvas: a field of a single disc still has a form.
const COARSEST: f64 = 1.0 / 128.0;
/// Assumed distance of a single drawn ellipse from its neighbours, in radii of the circle of its area.
const ALONE: f64 = 3.0;
/// Smallest discs, in longer sides of the canvas, as in [`poisson_discs`](crate::points::discs::poisson_discs).
const FINEST: f64 = 1.0 / 2_000.0;
/// Spots side by side cover area ÷ (this · spacing²): a value between those of a square lattice, 1, and a hexagonal one, 0.87.
const LATTICE: f64 = 0.9;

/// A field of points that is ready to grow.
#[derive(Clone, Debug)]
pub struct FieldPlan {
    /// The settings of the points.
    pub points: Points,
    /// Area and spacing of the drawn ellipses, if there are any.
    pub map: Option<AttributeMap>,
    /// The grid over the canvas, px.
    pub grid: Grid,
    /// Number of drawn ellipses.
    pub drawn: usize,
    /// The smallest and the largest distance of points anywhere, px.
    pub distances: [f64; 2],
    /// The share that is asked for, before maps vary it.
    unvaried_share: Option<f64>,
    /// The share above the edge, of the area that the layers beneath leave free; `None` = the share that results.
    pub share: Option<f64>,
    /// Variation of the distance of points and the area of dark parts by maps.
    varied: Option<Modulation>,
    /// Notes for the user.
    pub notes: Vec<String>,
    /// Cells of the grid that the marks of the layers beneath have taken; empty = none.
    pub obstacles: Vec<bool>,
}

impl FieldPlan {
    /// Reads layer `index` of a document named `source`, whose points are `points`, on a canvas of `size` px.
    ///
    /// # Errors
    /// Its marks are no ellipses, or a rule of layers is broken: file, place, what is allowed.
    pub fn read(
        document: &Document,
        index: usize,
        points: Points,
        source: &str,
        size: [f64; 2],
    ) -> Result<Self, DocumentError> {
        let layer = &document.layers[index];
        let marks = marks(document, index, source)?;
        let below = if index == 0 { Beneath::Nothing } else { Beneath::Unknown };
        let kind = marks.first().map(Kind::from);
        if let Some(problem) = Combination::new(layer, kind, below).problem(&format!("layers[{index}]")) {
            return Err(problem.in_file(source));
        }
        let map =
            if marks.is_empty() { None } else { Some(region_map(document, index, source)?.resized(size)) };
        let grid = Grid { size: [1, 1], cell: size, edges: document.edges };
        let (drawn, distances) = (marks.len(), [0.0; 2]);
        let mut plan = Self {
            points,
            map,
            grid,
            drawn,
            distances,
            unvaried_share: None,
            share: None,
            varied: modulation(document, index, size),
            notes: Vec::new(),
            obstacles: Vec::new(),
        };
        plan.distances = plan.all_distances();
        plan.unvaried_share = plan.wanted_share();
        plan.share = plan.varied_share();
        if let Some(problem) = plan.one_point(index) {
            return Err(problem.in_file(source));
        }
        plan.note();
        let cell = plan.wanted_cell();
        let cells = size.map(|side| (side / cell).ceil().max(1.0) as usize);
        plan.grid = Grid { size: cells, cell: [0, 1].map(|axis| size[axis] / cells[axis] as f64), ..grid };
        Ok(plan)
    }

    /// The canvas, px.
    #[must_use]
    pub fn canvas(&self) -> Bounds {
        self.grid.bounds_px()
    }

    /// px a cell of the grid.
    #[must_use]
    pub fn px_a_cell(&self) -> f64 {
        self.grid.px_a_cell()
    }

    /// The radius of the discs at a place, px, including maps; beyond a closed border that at the nearest place on it.
    #[must_use]
    pub fn distance(&self, at: [f64; 2]) -> f64 {
        let own = self.unvaried_distance(at);
        self.changed(Modulated::Spacing, own, at).map_or(own, |distance| distance.max(POINT_DISTANCE.low))
    }

    /// The radius of the discs at a place without maps, px. Between the two ends of the progression it is interpolated
    /// geometrically, so that equal steps change the look equally.
    fn unvaried_distance(&self, at: [f64; 2]) -> f64 {
        match (self.points.distance, &self.map) {
            (Some([first, last]), _) if first == last => first,
            (Some([first, last]), _) => first * libm::pow(last / first, self.progress(at)),
            (None, Some(map)) => drawn_distance(&map.at(self.canvas().inside(at))),
            (None, None) => self.longer() / Points::ACROSS,
        }
    }

    /// The probability of dark points at a place, including a map of their area; 0 for labels without one.
    #[must_use]
    pub fn dark(&self, at: [f64; 2]) -> f64 {
        let own = self.unvaried_dark(at);
        let cover = LATTICE * self.distance(at) * self.distance(at);
        self.changed(Modulated::Area, own * cover, at).map_or(own, |area| (area / cover).clamp(0.0, 1.0))
    }

    /// A value at a place as the maps vary it; `None` if they do not vary it.
    fn changed(&self, attribute: Modulated, value: f64, at: [f64; 2]) -> Option<f64> {
        self.varied.as_ref()?.changed(attribute, value, self.canvas().inside(at))
    }

    /// The share of dark points at a place without maps. If it is constant and a share is asked for, it is that share; otherwise
    /// there might be no threshold for it.
    fn unvaried_dark(&self, at: [f64; 2]) -> f64 {
        match &self.points.labels {
            Labels::Random { dark: [first, last] } => match self.unvaried_share {
                Some(share) if first == last => share,
                _ => first + (last - first) * self.progress(at),
            },
            Labels::Image { image, .. } => 1.0 - self.brightness(image, at),
            _ => 0.0,
        }
    }

    /// The method that gives its points their values; `dark` is [`Self::dark`].
    #[must_use]
    pub fn labelling<'a>(&self, dark: &'a (dyn Fn([f64; 2]) -> f64 + Sync)) -> Labelling<'a> {
        match self.points.labels {
            Labels::Values { group } => Labelling::Values(group as usize),
            Labels::Random { .. } => Labelling::Random(dark),
            Labels::Image { passes, .. } => Labelling::Reference(dark, passes),
            Labels::SpaceGiraffe { rays } => Labelling::SpaceGiraffe(rays.map(|rays| rays as usize)),
            Labels::BreadthFirst { size } => Labelling::BreadthFirst(size as usize),
            Labels::DepthFirst { size } => Labelling::DepthFirst(size as usize),
            Labels::RoundRobin { size, rings } => Labelling::RoundRobin(size as usize, rings as usize),
            Labels::Connected { start, rings } => Labelling::Connected(start, rings as usize),
        }
    }

    /// The direction in which weights are shifted.
    #[must_use]
    pub fn shift(&self) -> Shift {
        match self.points.towards {
            Towards::Random => Shift::Random,
            Towards::Outward => Shift::Outward,
            Towards::Angle(angle) => Shift::Along(angle),
        }
    }

    /// Whether each cell takes the value of a single point.
    #[must_use]
    pub fn is_sharp(&self) -> bool {
        self.points.interpolation == Interpolation::Nearest
    }

    /// The approximate number of points on the canvas.
    #[must_use]
    pub fn expected_points(&self) -> f64 {
        self.points_each() * expected_points(&self.canvas(), &|at| self.distance(at), self.points.octaves)
    }

    /// Number of points for each disc.
    fn points_each(&self) -> f64 {
        match self.points.labels {
            Labels::SpaceGiraffe { rays: [least, most] } => 1.0 + f64::from(least + most),
            // 1 + 2 + 4 + …
            Labels::Image { passes, .. } => 2f64.powi(passes as i32) - 1.0,
            _ => 1.0,
        }
    }

    /// The work of laying all points, also beyond closed borders.
    #[must_use]
    pub fn laying(&self) -> Laying {
        let (canvas, axis) = (Extent::from(self.canvas()), self.points.axis);
        let of_octave = |octave: u32| {
            let scale = 0.5f64.powi(octave as i32);
            let margin = scale * frame(axis, self.distances[1]);
            Laying::new(&canvas, margin, &|at| Metric::circle(scale * self.distance(at)))
        };
        let all = (0..self.points.octaves).map(of_octave).fold(Laying::default(), Laying::and);
        let each = self.points_each();
        Laying { points: each * all.points, tries: each * all.tries, ..all }
    }

    /// The cells in which no point may be dark: those that are taken, and cells closer to these than one distance of points.
    #[must_use]
    pub fn blocked(&self) -> Vec<bool> {
        let Some(ways) = nearest(&self.obstacles, &self.grid) else { return Vec::new() };
        let is_near = |(cell, way): (usize, &[i32; 2])| {
            length(*way, &self.grid) < self.distance(self.grid.center_px(cell))
        };
        ways.iter().enumerate().map(is_near).collect()
    }

    /// The position of a place along the progression, 0..1.
    fn progress(&self, at: [f64; 2]) -> f64 {
        let bounds = self.canvas();
        let [x, y] = bounds.inside(at);
        let [width, height] = bounds.size;
        let along = |share: f64| {
            // To the middle and back, so that a tile has no seam.
            let share = if bounds.edges == Edges::Wrap { 1.0 - (2.0 * share - 1.0).abs() } else { share };
            share.clamp(0.0, 1.0)
        };
        match &self.points.progression {
            Progression::Across => along(x / width),
            Progression::Down => along(y / height),
            Progression::Outward => {
                let away = libm::hypot(x - 0.5 * width, y - 0.5 * height);
                (away / (0.5 * libm::hypot(width, height))).clamp(0.0, 1.0)
            }
            Progression::Image(image) => self.brightness(image, at),
        }
    }

    /// The brightness of a picture over the canvas at a place, 0 = black, 1 = white; linear between the centres of px.
    fn brightness(&self, image: &ToneImage, at: [f64; 2]) -> f64 {
        let bounds = self.canvas();
        let (at, size) = (bounds.inside(at), image.size());
        let place = [0, 1].map(|axis| at[axis] / bounds.size[axis] * size[axis] as f64 - 0.5);
        let first = place.map(f64::floor);
        let value = |step: [isize; 2]| {
            let [x, y] = [0, 1].map(|axis| bounds.edges.index(first[axis] as isize + step[axis], size[axis]));
            f64::from(image.values()[y * size[0] + x]) / 255.0
        };
        let [u, v] = [0, 1].map(|axis| place[axis] - first[axis]);
        let row = |y: isize| value([0, y]) * (1.0 - u) + value([1, y]) * u;
        row(0) * (1.0 - v) + row(1) * v
    }

    fn longer(&self) -> f64 {
        let [width, height] = self.canvas().size;
        width.max(height)
    }

    /// The smallest and the largest distance that occur.
    fn all_distances(&self) -> [f64; 2] {
        let all = match (self.points.distance, &self.map, &self.varied) {
            (_, _, Some(varied)) => {
                let place = |index: usize| varied.nodes.center(varied.nodes.place(index));
                (0..varied.nodes.len()).map(|index| self.distance(place(index))).collect()
            }
            (Some(both), ..) => both.to_vec(),
            (None, Some(map), _) => map.samples().iter().map(drawn_distance).collect(),
            (None, None, _) => vec![self.longer() / Points::ACROSS],
        };
        let least = all.iter().copied().fold(f64::INFINITY, f64::min);
        [least, all.iter().copied().fold(0.0, f64::max)]
    }

    /// The share that is asked for: in the options, by the drawn ellipses, or by the probabilities.
    fn wanted_share(&self) -> Option<f64> {
        if self.is_sharp() && self.points.labels.are_dark_or_light() && self.points.octaves == 1 {
            return None;
        }
        if let Some(share) = self.points.share {
            return Some(share);
        }
        if let Some(map) = &self.map {
            let all = map.samples();
            let covered: f64 = all.iter().map(drawn_share).sum();
            return Some(covered / all.len().max(1) as f64);
        }
        let asked = self.points.labels.share_is_asked() && self.points.octaves == 1 && !self.points.fold;
        asked.then(|| self.mean(|at| self.unvaried_dark(at)))
    }

    /// The share of dark points as a map of the area varies it: in proportion to the mean of their probability.
    fn varied_share(&self) -> Option<f64> {
        let share = self.unvaried_share?;
        if !self.varied.as_ref().is_some_and(|varied| varied.changes(Modulated::Area)) {
            return Some(share);
        }
        let [own, varied] = [self.mean(|at| self.unvaried_dark(at)), self.mean(|at| self.dark(at))];
        Some((share * varied / own.max(f64::MIN_POSITIVE)).clamp(POINT_SHARE.low, POINT_SHARE.high))
    }

    /// The mean over the canvas.
    fn mean(&self, of: impl Fn([f64; 2]) -> f64) -> f64 {
        /// Number of places along a side at which it is sampled.
        const SAMPLES: usize = 128;
        let size = self.canvas().size;
        let place = |k: usize, axis: usize| (k as f64 + 0.5) / SAMPLES as f64 * size[axis];
        let at = |k: usize| of([place(k % SAMPLES, 0), place(k / SAMPLES, 1)]);
        (0..SAMPLES * SAMPLES).map(at).sum::<f64>() / (SAMPLES * SAMPLES) as f64
    }

    /// The problem if a tile has room for only one point, which gives a single value.
    fn one_point(&self, index: usize) -> Option<Problem> {
        let Bounds { size, edges } = self.canvas();
        let most = 0.5 * libm::hypot(size[0], size[1]);
        // The rays of the cells of a space giraffe have points of their own.
        let has_rays = matches!(self.points.labels, Labels::SpaceGiraffe { .. });
        let is_one = edges == Edges::Wrap && self.finest() > most && !has_rays;
        let allowed = format!(
            "less than {:.1} px, half the diagonal of a canvas that wraps; take a smaller distance, or closed edges",
            most * self.distances[0] / self.finest()
        );
        is_one.then(|| {
            Problem::new(
                format!("layers[{index}].points.distance"),
                format!("{:.1} px", self.distances[0]),
                allowed,
            )
        })
    }

    /// The least distance of points in the finest octave or pass, px.
    fn finest(&self) -> f64 {
        let finer = match self.points.labels {
            Labels::Image { passes, .. } => 0.5 * f64::from(passes - 1),
            // Two points of a ray are at most a quarter of the distance of cells apart.
            Labels::SpaceGiraffe { .. } => 2.0,
            _ => 0.0,
        };
        self.distances[0] * libm::pow(0.5, finer + f64::from(self.points.octaves - 1))
    }

    /// The cells that the finest discs need, px.
    fn wanted_cell(&self) -> f64 {
        if self.is_sharp() {
            return SHARP;
        }
        let finest = self.finest();
        let cells = if self.points.fold { FOLDED } else { CELLS };
        (finest / cells).max(SMALLEST).min((COARSEST * self.longer()).max(SMALLEST))
    }

    fn note(&mut self) {
        let least = FINEST * self.longer();
        if self.distances[0] < least {
            let asked = self.distances[0];
            self.notes
                .push(format!("points are at least {least:.1} px apart on this canvas, not {asked:.1} px"));
        }
        if self.drawn > 0
            && self.points.distance.is_some()
            && (self.points.share.is_some() || self.is_sharp())
        {
            self.notes.push("the drawn ellipses change nothing: distance and share are given".to_owned());
        }
    }
}

/// The distance of points that drawn ellipses ask for, px.
pub(in crate::synth) fn drawn_distance(wanted: &Attributes) -> f64 {
    let Attributes::Spots(spots) = wanted else { unreachable!("made of ellipses") };
    spots.spacing.unwrap_or_else(|| ALONE * (spots.area / std::f64::consts::PI).sqrt())
}

/// The share that these ellipses cover.
pub(in crate::synth) fn drawn_share(wanted: &Attributes) -> f64 {
    let Attributes::Spots(Spots { area, .. }) = wanted else { unreachable!("made of ellipses") };
    let spacing = drawn_distance(wanted);
    (area / (LATTICE * spacing * spacing)).clamp(POINT_SHARE.low, POINT_SHARE.high)
}
