//! Search for neighbouring points.

use crate::grid::{Buckets, turned};
use crate::rd::nucleus::Nucleus;

/// The displacement from one point to another.
#[derive(Clone, Copy, Debug)]
pub struct Displacement {
    /// Its coordinates in the frame of the first point.
    pub here: [f64; 2],
    /// Its coordinates in the frame of the second point.
    pub there: [f64; 2],
}

/// Squared distance in pitches, by the mean of both metrics.
pub fn distance2<P>(a: &Nucleus<P>, b: &Nucleus<P>, displacement: Displacement) -> f64 {
    0.5 * (a.distance2(displacement.here) + b.distance2(displacement.there))
}

/// Points sorted by place, so that neighbours are found without testing all points.
pub struct CellList<B: Buckets> {
    /// The buckets that sort the points.
    pub buckets: B,
    /// The points.
    pub all: Vec<Nucleus<B::Place>>,
    /// Points of each bucket: index and place.
    cells: Vec<Vec<(u32, B::Place)>>,
    /// The longest reach of any of them.
    longest: f64,
}

impl<B: Buckets> CellList<B> {
    /// No points yet.
    pub fn new(buckets: B) -> Self {
        let cells = vec![Vec::new(); buckets.count()];
        Self { buckets, all: Vec::new(), cells, longest: 0.0 }
    }

    /// A list without points, with these buckets.
    pub fn emptied(&self) -> Self {
        Self::new(self.buckets.clone())
    }

    /// Moves the points to other places.
    pub fn moved(&mut self, to: impl Fn(usize, &Nucleus<B::Place>) -> B::Place) {
        let all = self.all.iter().enumerate();
        let all = all.map(|(index, point)| Nucleus { at: to(index, point), ..*point }).collect();
        self.replace(all);
    }

    pub fn replace(&mut self, all: Vec<Nucleus<B::Place>>) {
        self.all.clear();
        self.longest = 0.0;
        self.cells.iter_mut().for_each(Vec::clear);
        all.into_iter().for_each(|point| self.insert(point));
    }

    pub fn insert(&mut self, point: Nucleus<B::Place>) {
        self.cells[self.buckets.bucket(point.at)].push((self.all.len() as u32, point.at));
        self.longest = self.longest.max(point.reach);
        self.all.push(point);
    }

    /// Calls `each(other, displacement)` for every point, or image of a point beyond the border (also of `point`), that can lie
    /// within `pitches` of `point` by the mean of both metrics, and for some that are farther away.
    pub fn near(
        &self,
        point: &Nucleus<B::Place>,
        pitches: f64,
        mut each: impl FnMut(&Nucleus<B::Place>, Displacement),
    ) {
        self.within(point, point.reach_among(self.longest, pitches), |other, displacement| {
            each(&self.all[other], displacement);
        });
    }

    /// Whether `is_near(other, displacement)` holds for any of these.
    pub fn any_near(
        &self,
        point: &Nucleus<B::Place>,
        pitches: f64,
        is_near: impl Fn(&Nucleus<B::Place>, Displacement) -> bool,
    ) -> bool {
        let reach = pitches * point.reach * 1.5;
        self.buckets.near(point.at, reach).any(|(buckets, displacement)| {
            let near = |(index, at): &(u32, B::Place)| {
                displacement(*at).is_some_and(|here| {
                    let other = &self.all[*index as usize];
                    let there = turned(here, self.buckets.transport_angle(point.cell, other.cell));
                    is_near(other, Displacement { here, there })
                })
            };
            self.cells[buckets].iter().any(|bucket| bucket.iter().any(near))
        })
    }

    /// Calls `each` with the index of each point within `pitches` pitches of `point`, and the displacement to it.
    pub fn near_by_index(
        &self,
        point: &Nucleus<B::Place>,
        pitches: f64,
        each: impl FnMut(usize, Displacement),
    ) {
        self.within(point, pitches * point.reach * 1.5, each);
    }

    /// Calls `each` for all points in the square about `point` whose sides are `reach` away, cells.
    fn within(&self, point: &Nucleus<B::Place>, reach: f64, mut each: impl FnMut(usize, Displacement)) {
        for (buckets, displacement) in self.buckets.near(point.at, reach) {
            for &(index, at) in self.cells[buckets].iter().flatten() {
                if let Some(here) = displacement(at) {
                    let other = &self.all[index as usize];
                    let there = turned(here, self.buckets.transport_angle(point.cell, other.cell));
                    each(index as usize, Displacement { here, there });
                }
            }
        }
    }

    /// Whether the displacement `displacement`, from `point` to `other`, leads to the mirror image of `other`, beyond a border.
    pub fn is_to_image(
        &self,
        point: &Nucleus<B::Place>,
        other: &Nucleus<B::Place>,
        displacement: Displacement,
    ) -> bool {
        self.buckets.is_to_image(point.at, other.at, displacement.here)
    }
}
