//! Counts laid cells that have an area of their own: whole ones that neither closed nor merged with others.

use std::collections::{BTreeMap, BTreeSet};

use crate::grid::{Field, UnionFind};
use crate::synth::areas::grown::OwnPolygons;
use crate::synth::areas::measured::EDGE;
use crate::synth::areas::plan::AreaPlan;
use crate::synth::areas::plan::polygons::PolygonForm;
use crate::synth::areas::polygons::owned::TAKEN;

/// Least share of an area that lies on the places of a cell for the area to belong to it.
const OWN: f64 = 0.9;
/// Only cells whose places make up at least this share of their planned area are counted: others are cut by a border, by layers
/// beneath or by drawn marks.
const WHOLE: f64 = 0.5;

/// Number of laid cells that have an area of their own in `field`. `owned` holds the owner of each place, `is_kept` tells the
/// places of drawn marks.
pub(super) fn own_polygons(
    plan: &AreaPlan,
    owned: &[u32],
    field: &Field,
    is_kept: impl Fn(usize) -> bool,
) -> OwnPolygons {
    let areas = areas(field);
    let mut places: BTreeMap<u32, (usize, usize)> = BTreeMap::new();
    let mut of_area: BTreeMap<u32, BTreeMap<u32, usize>> = BTreeMap::new();
    for (cell, owner) in owned.iter().enumerate().filter(|(cell, owner)| **owner != TAKEN && !is_kept(*cell))
    {
        places.entry(*owner).or_insert((0, cell)).0 += 1;
        if let Some(area) = areas[cell] {
            *of_area.entry(area).or_default().entry(*owner).or_default() += 1;
        }
    }
    let cell_area = plan.grid.cell[0] * plan.grid.cell[1];
    let is_whole = |(_, (count, first)): &(&u32, &(usize, usize))| {
        let laid = PolygonForm::distance_of(&plan.wanted(plan.grid.center_px(*first)));
        *count as f64 * cell_area >= WHOLE * laid * laid
    };
    // The cell that an area belongs to.
    let belongs = |owners: &BTreeMap<u32, usize>| {
        let all: usize = owners.values().sum();
        owners.iter().find(|(_, own)| **own as f64 >= OWN * all as f64).map(|(owner, _)| *owner)
    };
    let with_area: BTreeSet<u32> = of_area.values().filter_map(belongs).collect();
    let whole: Vec<u32> = places.iter().filter(is_whole).map(|(owner, _)| *owner).collect();
    let own = whole.iter().filter(|owner| with_area.contains(owner)).count();
    OwnPolygons { own, laid: whole.len() }
}

/// The number of the connected area that each cell of the grid lies in.
fn areas(field: &Field) -> Vec<Option<u32>> {
    let [nx, ny] = [field.width, field.height];
    let mut sets = UnionFind::new(nx * ny);
    let is_in = |cell: usize| field.values[cell] > EDGE;
    for cell in (0..nx * ny).filter(|cell| is_in(*cell)) {
        let (x, y) = (cell % nx, cell / nx);
        // On a closed canvas the index beyond the border is a cell at it.
        let [right, below] = [(1, 0), (0, 1)].map(|(dx, dy)| {
            let [x, y] = [(x + dx, nx), (y + dy, ny)].map(|(at, side)| field.edges.index(at as isize, side));
            y * nx + x
        });
        for other in [right, below].into_iter().filter(|other| is_in(*other)) {
            sets.join(cell as u32, other as u32, [0, 0]);
        }
    }
    (0..nx * ny).map(|cell| is_in(cell).then(|| sets.find(cell as u32).0)).collect()
}
