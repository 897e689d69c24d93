//! `after: "around"` and `after: "net"`: lines round the marks beneath, or as one web between them.
//!
//! They are Meinhardt's lines along a [`Course`] that is laid once the layers beneath have grown. Their width is all
//! that is drawn; their rate follows from it by one law, and the level sets the last per cents.

use crate::attributes::regions::RegionMap;
use crate::attributes::{Attributes, Spots, Stripes};
use crate::document::After;
use crate::grid::Field;
use crate::learn::{self, Answer, Coverage};
use crate::rd::System;
use crate::synth::plan::offset_curves::{Course, CourseError, Grid, RATIO, Wanted, Way};
use crate::synth::plan::{Plan, PlanError, planned};

/// What a layer's lines do to the marks beneath, where it is that.
#[must_use]
pub fn way(after: After) -> Option<Way> {
    match after {
        After::Around => Some(Way::Rings),
        After::Net => Some(Way::Web),
        After::Between | After::Inside => None,
    }
}

/// Plans a layer of lines that are as wide as `map` says.
///
/// # Errors
/// None that such lines have.
pub fn plan_lines(way: Way, map: RegionMap) -> Result<Plan, PlanError> {
    let asked = |wanted: &Attributes, cell: f64| {
        let width = match wanted {
            Attributes::Stripes(stripes) => stripes.width,
            Attributes::Spots(spots) => spots.area.sqrt(),
        };
        let root = way.law() * cell / width;
        Ok(Answer {
            parameters: learn::Parameters {
                rate: root * root,
                ratio: Some(RATIO),
                stretch: way.stretch(),
                direction: 0.0,
                level: Some(0.5),
            },
            predicted: *wanted,
            interval: Vec::new(),
            coverage: Coverage::Inside,
            nearest: *wanted,
            notes: Vec::new(),
            pitch: 1.0,
        })
    };
    let mut plan = planned(System::MeinhardtLines, map, &asked)?;
    plan.way = Some(way);
    Ok(plan)
}

impl Plan {
    /// Lays the course of lines round or between the marks that have taken its cells. Of rings the share `broken` is open.
    ///
    /// # Errors
    /// Nothing is beneath, or it leaves no room.
    pub fn lay_course(&mut self, broken: f64, seed: u64) -> Result<(), CourseError> {
        let Some(way) = self.way else { return Ok(()) };
        let grid = self.grid_of_cells();
        let nothing = vec![false; grid.cells()];
        let taken = if self.taken.is_empty() { &nothing } else { &self.taken };
        let width = self.widths(&grid);
        let layout = *self.map.layout();
        let region_of = |point| layout.index(layout.region_of(point));
        let wanted = Wanted { way, taken, width: &width, broken, seed };
        let course = Course::lay(&wanted, &grid, layout.len(), &region_of)?;
        for remarks in &mut self.remarks {
            remarks.extend(course.remarks.iter().cloned());
        }
        self.course = Some(course);
        Ok(())
    }

    /// The concentration `marks` as a share of the peak nearby, where lines have a course.
    #[must_use]
    pub fn levelled(&self, mut marks: Field) -> Field {
        if let Some(course) = self.course.as_ref().filter(|_| [marks.width, marks.height] == self.grid) {
            let grid = self.grid_of_cells();
            marks.values = course.levelled(&marks.values, &grid, &self.widths(&grid));
        }
        marks
    }

    fn grid_of_cells(&self) -> Grid {
        Grid { size: self.grid, cell: self.cell, edges: self.map.layout().edges }
    }

    /// Width wanted at each cell, px.
    fn widths(&self, grid: &Grid) -> Vec<f32> {
        let width = |cell| match self.map.at(grid.middle(cell)) {
            Attributes::Stripes(Stripes { width, .. }) => width as f32,
            Attributes::Spots(_) => 0.0,
        };
        (0..grid.cells()).map(width).collect()
    }
}

/// Mean distance of spots, less their size, ÷ what lines between them need, below which most places have too little: the
/// nearest of a spot's neighbours stands nearer than the mean. Below the second some have.
const TIGHT: [f64; 2] = [1.1, 1.5];

impl Plan {
    /// What there will be to say about room above the layer planned `beneath`, before anything has grown; `None` where
    /// there is enough.
    #[must_use]
    pub fn expected_room(&self, beneath: &Self) -> Option<String> {
        let way = self.way.filter(|_| beneath.way.is_none())?;
        let layout = self.map.layout();
        let room = |(place, _)| {
            let center = layout.center(place);
            let Attributes::Stripes(Stripes { width, .. }) = self.map.at(center) else { return None };
            let gap = match beneath.map.at(center) {
                Attributes::Spots(Spots { area, spacing, .. }) => {
                    spacing? - 2.0 * (area / std::f64::consts::PI).sqrt()
                }
                Attributes::Stripes(stripes) => stripes.width,
            };
            Some((gap / width, gap, width))
        };
        let (room, gap, width) = self.map.regions().filter_map(room).min_by(|a, b| a.0.total_cmp(&b.0))?;
        let [lines, some] = match way {
            Way::Rings => ["rings", "some neighbours will share a wall"],
            Way::Web => ["a web of lines", "some marks will be surrounded together"],
        };
        let tight = TIGHT.map(|tight| room < tight * way.need());
        let then = match tight {
            [true, _] => {
                "grow will most likely refuse it; draw thinner lines, or the marks beneath farther apart"
            }
            [false, true] => some,
            [false, false] => return None,
        };
        Some(format!(
            "{lines} {width:.1} px wide need {:.1} px between the marks beneath, which will stand about {gap:.1} px \
             apart: {then}",
            way.need() * width
        ))
    }
}
