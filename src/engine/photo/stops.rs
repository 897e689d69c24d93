//! The colours of marks and ground, as stops that keep the visible edge.
//!
//! The blur of a photograph produces all colours between ground and mark. Stops taken at pattern values would reproduce them, and
//! move the edge by a fifth of the area. So the colours are taken by the distance from the edge: far from it on either side, and
//! just beyond the blur. Each is the median of the px there, after light that falls off has been divided out. If marks or the
//! ground between them are so thin that their middles show both colours, the mixture is separated again.

use super::edge_blur::Shares;
use super::lab::Lab;
use super::light::Light;
use crate::colour::srgb_of_oklab;
use crate::grid::Field;
use crate::grid::distance::{length, nearest};

/// A colour at a pattern value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tone {
    /// Pattern value, 0..1.
    pub at: f64,
    /// Red, green, blue (sRGB).
    pub colour: [u8; 3],
}

/// Pattern values of far ground, near ground, near mark and the middle of marks. The two in the middle are at this distance from ½
/// so that edges painted by dapple are as sharp as in a picture without blur.
const AT: [f64; 4] = [0.0, 0.41, 0.59, 1.0];
/// Half of the width of a blurred edge, cells: px closer to the edge show both colours.
const BLUR: f64 = 2.0;
/// Limit of "near", beyond the blur, as a share of the largest distance inside.
const NEAR: f64 = 0.35;
/// Lower limit of "far", as that share.
const FAR: f64 = 0.6;
/// Distances are compared with this quantile of those of inner cells: the largest ones occur only in a few places.
const QUANTILE: f64 = 0.95;
/// Number of cells that are sampled: a median of so many is accurate to a step of 8 bits.
const ENOUGH: usize = 1 << 19;

/// Stops, and the light that was divided out of their colours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tones {
    /// The stops, ascending; empty where there are no marks, or no ground.
    pub tones: Vec<Tone>,
    /// The light; `None` without stops.
    pub light: Option<Light>,
}

/// The stops of the marks above `level` in `field` for whose cells `counts` holds, on the ground around all marks; cells that are
/// `enclosed` by marks do not count as ground.
#[must_use]
pub fn tones(
    lab: &Lab,
    field: &Field,
    level: f32,
    counts: impl Fn(usize) -> bool,
    enclosed: impl Fn(usize) -> bool,
) -> Tones {
    let grid = field.grid();
    let is_mark: Vec<bool> = field.values.iter().map(|value| *value > level).collect();
    let is_ground: Vec<bool> = is_mark.iter().map(|mark| !mark).collect();
    let (Some(to_mark), Some(to_ground)) = (nearest(&is_mark, &grid), nearest(&is_ground, &grid)) else {
        return Tones::default();
    };
    let unit = grid.cell[0];
    let out = |cell: usize| length(to_mark[cell], &grid) / unit;
    let into = |cell: usize| length(to_ground[cell], &grid) / unit;
    let cells = (0..is_mark.len()).step_by(stride(is_mark.len(), lab.size[0]));
    let ground = cells.clone().filter(|cell| is_ground[*cell] && !enclosed(*cell));
    let ground: Vec<(f64, usize)> = ground.map(|cell| (out(cell), cell)).collect();
    let marks = cells.filter(|cell| is_mark[*cell] && counts(*cell));
    let marks: Vec<(f64, usize)> = marks.map(|cell| (into(cell), cell)).collect();
    let [near_ground, far_ground] = near_and_far(&ground);
    let [near_mark, far_mark] = near_and_far(&marks);
    let light = Light::of(lab, [&far_ground, &far_mark]);
    let is_counted: Vec<bool> =
        is_mark.iter().enumerate().map(|(cell, mark)| *mark && counts(cell)).collect();
    let other = |(cell, mark): (usize, &bool)| if *mark { !counts(cell) } else { enclosed(cell) };
    let is_other: Vec<bool> = is_mark.iter().enumerate().map(other).collect();
    let shares = Shares::of_marks(lab, &is_counted, &is_other, &light);
    let [near, far] = [[&near_ground, &near_mark], [&far_ground, &far_mark]].map(|[ground, marks]| {
        let colours = [ground, marks].map(|cells| median(lab, &light, cells));
        shares.separated([ground, marks], colours)
    });
    let tones = [(far[0], &far_ground), (near[0], &near_ground), (near[1], &near_mark), (far[1], &far_mark)]
        .iter()
        .zip(AT)
        .filter(|((_, cells), _)| !cells.is_empty())
        .map(|((colour, _), at)| Tone { at, colour: srgb_of_oklab(*colour) })
        .collect();
    Tones { tones, light: Some(light) }
}

/// The step between sampled cells, of `cells` in rows of `width`, so that enough cells are sampled, and in all columns.
fn stride(cells: usize, width: usize) -> usize {
    let stride = cells / ENOUGH + 1;
    if stride > 1 && width.is_multiple_of(stride) { stride + 1 } else { stride }
}

/// The cells just beyond the blur of an edge, and those far from it, from cells with their distances.
fn near_and_far(cells: &[(f64, usize)]) -> [Vec<usize>; 2] {
    if cells.is_empty() {
        return [Vec::new(), Vec::new()];
    }
    let mut inner: Vec<f64> = cells.iter().map(|(far, _)| *far).collect();
    let rank = ((inner.len() - 1) as f64 * QUANTILE) as usize;
    let (_, most, _) = inner.select_nth_unstable_by(rank, f64::total_cmp);
    let most = *most;
    // Thin marks have no place beyond the blur: the cells farthest from the edge represent all.
    let blur = BLUR.min(NEAR * most);
    let near = |far: f64| far >= blur && far <= blur + NEAR * (most - blur) + 1.0;
    let far = |far: f64| far >= FAR * most;
    let pick = |takes: &dyn Fn(f64) -> bool| {
        cells.iter().filter(|(far, _)| takes(*far)).map(|(_, cell)| *cell).collect()
    };
    [pick(&near), pick(&far)]
}

/// The median of L, a and b of some cells in full light; black without any.
fn median(lab: &Lab, light: &Light, cells: &[usize]) -> [f32; 3] {
    let even: Vec<[f32; 3]> = cells.iter().map(|cell| light.divided_out(lab, *cell)).collect();
    [0, 1, 2].map(|k| {
        let mut values: Vec<f32> = even.iter().map(|colour| colour[k]).collect();
        let middle = values.len() / 2;
        if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(middle, f32::total_cmp).1 }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::colour::{linear_light, oklab_of_light};
    use crate::grid::Edges;

    #[test]
    fn blurred_discs_in_falling_light_have_their_own_colours() {
        let (sand, brown) = ([244, 227, 193], [59, 35, 20]);
        let lut = linear_light();
        let lab = |colour: [u8; 3]| oklab_of_light(colour.map(|value| lut[usize::from(value)]));
        let size = [200, 160];
        let near = |x: usize| (x as f64 + 0.5).rem_euclid(40.0) - 20.0;
        let share = |k: usize| {
            (0.5 + (11.0 - near(k % size[0]).hypot(near(k / size[0]))) / 4.0).clamp(0.0, 1.0) as f32
        };
        let field = Field {
            width: 200,
            height: 160,
            cell: [1.0; 2],
            edges: Edges::Closed,
            values: (0..size[0] * size[1]).map(share).collect(),
        };
        let planes = [0, 1, 2].map(|plane| {
            let mixed = |(k, share): (usize, &f32)| {
                let light = 1.0 - 0.15 * (k % size[0]) as f32 / 200.0;
                light * (lab(sand)[plane] + share * (lab(brown)[plane] - lab(sand)[plane]))
            };
            field.values.iter().enumerate().map(mixed).collect()
        });
        let lab = Lab { size, factor: 1, planes };
        let found = tones(&lab, &field, 0.5, |_| true, |_| false).tones;
        assert_eq!(found.iter().map(|tone| tone.at).collect::<Vec<_>>(), AT);
        for (tone, wanted) in found.iter().zip([sand, sand, brown, brown]) {
            let off = (0..3).map(|k| tone.colour[k].abs_diff(wanted[k])).max().unwrap();
            // In uneven light the plain medians have errors of 18; a blur that is estimated too wide makes colours near the edge
            // stronger by 6.
            assert!(off <= 8, "{found:?}");
        }
    }
}
