//! Search for points of a surface near a place.

use crate::grid::{Buckets, Domain};
use crate::surface::{Surface, SurfacePoint};

/// Points sorted by the cells of a surface that they lie in.
pub struct Near<'a> {
    surface: &'a Surface,
    points: &'a [SurfacePoint],
    /// By cell, the indices of its points.
    cells: Vec<Vec<u32>>,
}

impl<'a> Near<'a> {
    pub fn new(surface: &'a Surface, points: &'a [SurfacePoint]) -> Self {
        let mut cells = vec![Vec::new(); surface.cells()];
        for (index, place) in (0..).zip(points) {
            cells[surface.vertex_of(*place)].push(index);
        }
        Self { surface, points, cells }
    }

    /// The points within `reach` of point number `own`, each with the displacement to it in the tangent plane there; lengths are
    /// those of the surface. No point is reached through the body.
    pub fn around(&self, own: usize, reach: f64) -> Vec<(usize, [f64; 2])> {
        let place = self.points[own];
        // The displacement to the point itself would be that to its mirror image beyond a border.
        self.ways(place, reach).into_iter().filter(|(index, _)| self.points[*index] != place).collect()
    }

    /// The points within `reach` of a place, with their distances.
    pub fn distances(&self, place: SurfacePoint, reach: f64) -> Vec<(usize, f64)> {
        let distance = |(index, [x, y]): (usize, [f64; 2])| {
            (index, if self.points[index] == place { 0.0 } else { (x * x + y * y).sqrt() })
        };
        let mut all: Vec<(usize, f64)> = self.ways(place, reach).into_iter().map(distance).collect();
        let here = self.cells[self.surface.vertex_of(place)].iter().map(|index| *index as usize);
        for own in here.filter(|index| self.points[*index] == place) {
            if all.iter().all(|(index, _)| *index != own) {
                all.push((own, 0.0));
            }
        }
        all
    }

    fn ways(&self, place: SurfacePoint, reach: f64) -> Vec<(usize, [f64; 2])> {
        let unit = self.surface.unit();
        let buckets = self.surface.buckets(reach / unit);
        let mut found = Vec::new();
        for (range, way) in buckets.near(place, reach / unit) {
            for index in self.cells[range].iter().flatten().map(|index| *index as usize) {
                if let Some([x, y]) = way(self.points[index]).map(|way| way.map(|part| part * unit))
                    && x * x + y * y <= reach * reach
                {
                    found.push((index, [x, y]));
                }
            }
        }
        found
    }
}
