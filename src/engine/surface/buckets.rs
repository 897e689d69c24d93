//! Points on a surface, sorted by the cells that they lie in.

use std::cell::RefCell;
use std::ops::Range;
use std::rc::Rc;
use std::sync::Arc;

use super::border::Border;
use super::local_map::LocalMap;
use super::point::SurfacePoint;
use super::triangle_surface::Surface;
use crate::grid::{Buckets, Domain};

/// Buckets that are the cells of a surface. A point near a border has its mirror image beyond it as a neighbour, so that other
/// points do not push it onto the border.
#[derive(Clone)]
pub struct SurfaceBuckets<'a> {
    surface: &'a Surface,
    border: Option<Arc<Border>>,
}

impl<'a> SurfaceBuckets<'a> {
    pub fn new(surface: &'a Surface) -> Self {
        Self { surface, border: Border::new(surface).map(Arc::new) }
    }
}

/// Largest distance of places of a cell from its centre, units.
const FARTHEST_IN_CELL: f64 = 1.0;
/// Largest distance of the corners of its faces from the centre, units.
const BESIDE: f64 = 1.0;
/// Distance of a point on the border from its mirror image, units.
const LEAST: f64 = 1e-3;

impl Buckets for SurfaceBuckets<'_> {
    type Place = SurfacePoint;

    fn count(&self) -> usize {
        self.surface.cells()
    }

    fn bucket(&self, place: SurfacePoint) -> usize {
        self.surface.vertex_of(place)
    }

    fn near(
        &self,
        place: SurfacePoint,
        reach: f64,
    ) -> impl Iterator<Item = (Range<usize>, impl Fn(SurfacePoint) -> Option<[f64; 2]>)> {
        let (surface, unit) = (self.surface, self.surface.unit());
        let map = Rc::new(RefCell::new(LocalMap::about(surface, place)));
        let image = self.border.as_ref().and_then(|border| {
            border
                .image(surface, place, reach * unit, LEAST * unit)
                .map(|displacement| displacement.map(|part| part / unit))
        });
        let known = map.clone();
        let displacement = move |other: SurfacePoint| {
            if other == place {
                return image;
            }
            let displacement = known.borrow().displacement(surface, other)?.map(|part| part / unit);
            let near = displacement != [0.0; 2] && displacement.iter().all(|part| part.abs() <= reach);
            near.then_some(displacement)
        };
        let farthest = (reach + FARTHEST_IN_CELL) * unit;
        (0..).map_while(move |number| {
            let mut map = map.borrow_mut();
            // A cell is returned once its faces are known, and the search continues only on demand.
            while map.len() <= number || map.reached(map.len() - 1).1 < map.reached(number).1 + BESIDE * unit
            {
                if map.advance(surface, farthest + BESIDE * unit).is_none() {
                    break;
                }
            }
            let (cell, _) =
                (number < map.len()).then(|| map.reached(number)).filter(|found| found.1 <= farthest)?;
            Some((cell..cell + 1, displacement.clone()))
        })
    }

    fn is_to_image(&self, from: SurfacePoint, to: SurfacePoint, displacement: [f64; 2]) -> bool {
        from == to && displacement != [0.0; 2]
    }

    fn transport_angle(&self, from: usize, to: usize) -> f64 {
        self.surface.transport_angle(from, to)
    }
}
