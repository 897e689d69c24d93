//! The direction of the hair in a photograph, from the structure tensor of its fine detail.
//!
//! ```text
//! g = (1 − G₂)² * G₁.₁ * L,  w = 1 ÷ (|∇g|² + m),  J = Gσ * (w·∇g ∇gᵀ)
//! ```
//! with the lightness L and the median m of |∇g|², so that all hairs count about equally, light and dark ones. Edges of marks have
//! directions of their own, so w = 0 beside them; and their shading is removed by the square, which leaves 1 % of a wave of 30 px.
//!
//! J. Bigün & G. Granlund, "Optimal orientation detection of linear symmetry", ICCV 1987.

use rayon::prelude::*;

use super::coarse::{Blocks, Coarse};
use super::lab::Lab;
use super::reading::Reading;
use super::{Raster, Segmentation};
use crate::grid::blur::gaussian;
use crate::grid::distance::{length, nearest};
use crate::grid::{Edges, Field};

/// Standard deviations of the blurs between which fine detail lies, cells.
const FINE: [f64; 2] = [1.1, 2.0];
/// Most cells: of a larger photograph, squares of px.
const MOST: usize = 8 << 20;
/// Distance from edges of marks up to which detail does not count, cells.
const BESIDE: f64 = 5.0;
/// Least share of the cells that counts.
const SEEN: f64 = 0.02;
/// Least median of |∇g|, OKLab a cell: weaker detail is that of the compression.
const LEAST: f32 = 0.002;
/// Number of cells among which the median is sought.
const SAMPLES: usize = 1 << 16;
/// Standard deviation of the window, in distances of marks, and its least one, in shorter sides of the picture.
const WINDOW: [f64; 2] = [1.5, 0.06];
/// Least coherence of hair: fur has 0.15 and more, detail without a direction 0.06.
const COHERENT: f64 = 0.1;
/// Root mean square deviation from the mean up to which one direction describes all of it, degrees.
const STRAIGHT: f64 = 10.0;
/// Lines along the shorter side, and their length as a share of their distance.
const LINES: f64 = 3.0;
const LONG: f64 = 0.55;

/// The direction of hair. Directions are from head to tail, which a photograph does not show: of the two, the one that is nearer to a
/// given one.
#[derive(Clone, Debug, PartialEq)]
pub enum Hair {
    /// One direction, degrees from +x towards +y, 0 to 360.
    Angle(f64),
    /// Lines that hair follows, from their first point to their second one, px of the photograph.
    Lines(Vec<[[f64; 2]; 2]>),
}

/// The direction of the hair between and on the marks of a photograph, nearer to `tail` (degrees); `None` if its fine detail has no
/// direction.
#[must_use]
pub fn hair(raster: &Raster, reading: &Reading, tail: f64) -> Option<Hair> {
    let px = raster.size[0] * raster.size[1];
    let factor = (1..).find(|factor| px / (factor * factor) <= MOST)?;
    let lab = Lab::of(raster, factor);
    let window = (WINDOW[0] * reading.segmentation.wavelength / factor as f64)
        .max(WINDOW[1] * lab.size[0].min(lab.size[1]) as f64);
    let tensors = Tensors::of(&lab, &apart(reading, &lab), window)?;
    let (angle, straight) = tensors.mean()?;
    let toward = |angle: f64| {
        let turned = (angle - tail + 180.0).rem_euclid(360.0) - 180.0;
        if turned.abs() > 90.0 { (angle + 180.0).rem_euclid(360.0) } else { angle.rem_euclid(360.0) }
    };
    if straight < STRAIGHT {
        return Some(Hair::Angle(toward(angle)));
    }
    let size = raster.size.map(|side| side as f64);
    let lines = with_signs(tensors.lines(size, factor as f64), tail);
    (!lines.is_empty()).then_some(Hair::Lines(lines))
}

/// Whether each cell is far from the edges of marks.
fn apart(reading: &Reading, lab: &Lab) -> Vec<bool> {
    let Segmentation { field, level, .. } = &reading.segmentation;
    let grid = field.grid();
    let ink = reading.rosettes.as_ref().map(|rosettes| (&rosettes.ink, rosettes.level));
    let above = |of: &Field, level: f32, cell: usize| u8::from(of.values[cell] > level);
    let class =
        |cell: usize| above(field, *level, cell) + 2 * ink.map_or(0, |(ink, level)| above(ink, level, cell));
    let is_edge = |cell: usize| {
        let right = !(cell + 1).is_multiple_of(field.width) && class(cell) != class(cell + 1);
        right || cell + field.width < field.values.len() && class(cell) != class(cell + field.width)
    };
    let edges: Vec<bool> = (0..field.values.len()).map(is_edge).collect();
    let Some(offsets) = nearest(&edges, &grid) else { return vec![true; lab.size[0] * lab.size[1]] };
    let px = lab.factor as f64;
    let is_apart = |cell: usize| {
        let at = [cell % lab.size[0], cell / lab.size[0]].map(|at| (at as f64 + 0.5) * px);
        let [x, y] = [0, 1].map(|axis| ((at[axis] / grid.cell[axis]) as usize).min(grid.size[axis] - 1));
        length(offsets[y * grid.size[0] + x], &grid) > BESIDE * px
    };
    (0..lab.size[0] * lab.size[1]).into_par_iter().map(is_apart).collect()
}

/// Structure tensors: xx, xy and yy.
struct Tensors {
    parts: [Coarse; 3],
}

impl Tensors {
    /// The tensors of the fine detail of the cells that count, over a window of `sigma` cells; `None` if there is none.
    fn of(lab: &Lab, counts: &[bool], sigma: f64) -> Option<Self> {
        let [width, height] = lab.size;
        let mut fine = gaussian(&lab.planes[0], lab.size, FINE[0], Edges::Closed);
        for _ in 0..2 {
            let slow = gaussian(&fine, lab.size, FINE[1], Edges::Closed);
            fine.iter_mut().zip(slow).for_each(|(fine, slow)| *fine -= slow);
        }
        let gradient = |cell: usize| -> Option<[f32; 2]> {
            let (x, y) = (cell % width, cell / width);
            let inside = x >= 2 && y >= 2 && x + 2 < width && y + 2 < height;
            if !inside || !counts[cell] {
                return None;
            }
            // Of the fourth order: a difference of neighbours alone would turn directions towards the diagonals.
            let along = |step: usize| {
                8.0 * (fine[cell + step] - fine[cell - step])
                    - (fine[cell + 2 * step] - fine[cell - 2 * step])
            };
            Some([1, width].map(|step| along(step) / 12.0))
        };
        let energy = |[x, y]: [f32; 2]| x * x + y * y;
        let step = (fine.len() / SAMPLES).max(1) | 1;
        let mut energies: Vec<f32> =
            (0..fine.len()).step_by(step).filter_map(|cell| gradient(cell).map(energy)).collect();
        if (energies.len() * step) as f64 <= SEEN * fine.len() as f64 {
            return None;
        }
        let middle = energies.len() / 2;
        let median = *energies.select_nth_unstable_by(middle, f32::total_cmp).1;
        if median < LEAST * LEAST {
            return None;
        }
        let blocks = Blocks::new(lab.size, sigma);
        let parts: [Vec<f32>; 3] = blocks.blurred(
            |_| (),
            |(), _, cell| {
                let Some([x, y]) = gradient(cell) else { return [0.0; 3] };
                let weight = 1.0 / (x * x + y * y + median);
                [weight * x * x, weight * x * y, weight * y * y]
            },
        );
        Some(Self { parts: parts.map(|part| blocks.field(part)) })
    }

    /// xx, xy and yy of a block.
    fn at(&self, block: usize) -> [f64; 3] {
        [0, 1, 2].map(|part| f64::from(self.parts[part].values[block]))
    }

    /// The mean direction, degrees, and the root mean square deviation from it; `None` if they have no direction.
    fn mean(&self) -> Option<(f64, f64)> {
        let all: Vec<[f64; 3]> = (0..self.parts[0].values.len()).map(|block| self.at(block)).collect();
        let weight: f64 = all.iter().map(|[xx, _, yy]| xx + yy).sum();
        let coherence = all.iter().map(|part| coherence(*part) * (part[0] + part[2])).sum::<f64>() / weight;
        if coherence.is_nan() || coherence < COHERENT {
            return None;
        }
        let sum = all.iter().fold([0.0; 3], |sum, part| [0, 1, 2].map(|k| sum[k] + part[k]));
        let mean = along(sum);
        let mut square = 0.0;
        let mut strength = 0.0;
        for part in all {
            let own = coherence_energy(part);
            let turned = crate::marks::turn(along(part), mean);
            square += own * turned * turned;
            strength += own;
        }
        Some((mean, (square / strength).sqrt()))
    }

    /// Lines on a grid of places on a picture of `size` px, where the detail has a direction; a cell has `px` px.
    fn lines(&self, size: [f64; 2], px: f64) -> Vec<[[f64; 2]; 2]> {
        let side = size[0].min(size[1]) / LINES;
        let count = size.map(|length| (length / side).round().max(1.0) as usize);
        let apart = [0, 1].map(|axis| size[axis] / count[axis] as f64);
        let half = 0.5 * LONG * apart[0].min(apart[1]);
        let block = self.parts[0].block as f64 * px;
        let line = |k: usize| {
            let place = [k % count[0], k / count[0]];
            let middle = [0, 1].map(|axis| (place[axis] as f64 + 0.5) * apart[axis]);
            let blocks = self.parts[0].size;
            let [x, y] = [0, 1].map(|axis| ((middle[axis] / block) as usize).min(blocks[axis] - 1));
            let part = self.at(y * blocks[0] + x);
            let (sin, cos) = libm::sincos(along(part).to_radians());
            let end = |by: f64| [middle[0] + by * cos, middle[1] + by * sin];
            (coherence(part) >= COHERENT).then(|| [end(-half), end(half)])
        };
        (0..count[0] * count[1]).filter_map(line).collect()
    }
}

/// The direction along the detail, degrees.
fn along([xx, xy, yy]: [f64; 3]) -> f64 {
    0.5 * libm::atan2(-2.0 * xy, yy - xx).to_degrees()
}

/// How much of the energy has one direction.
fn coherence_energy([xx, xy, yy]: [f64; 3]) -> f64 {
    ((xx - yy) * (xx - yy) + 4.0 * xy * xy).sqrt()
}

fn coherence(part: [f64; 3]) -> f64 {
    let sum = part[0] + part[2];
    if sum > 0.0 { coherence_energy(part) / sum } else { 0.0 }
}

/// The lines, turned so that they lead from head to tail: first the one that is most along `tail` (degrees), then each as the nearest
/// of those that are turned already.
fn with_signs(mut lines: Vec<[[f64; 2]; 2]>, tail: f64) -> Vec<[[f64; 2]; 2]> {
    let (sin, cos) = libm::sincos(tail.to_radians());
    let way = |[from, to]: [[f64; 2]; 2]| [to[0] - from[0], to[1] - from[1]];
    let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
    let middle = |[from, to]: [[f64; 2]; 2]| [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
    for turned in 0..lines.len() {
        let nearest = |k: usize| {
            let apart = |other: &&[[f64; 2]; 2]| {
                let [a, b] = [middle(**other), middle(lines[k])];
                dot([a[0] - b[0], a[1] - b[1]], [a[0] - b[0], a[1] - b[1]])
            };
            let near = lines[..turned].iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
            near.map_or((0.0, [cos, sin]), |near| (apart(&near), way(*near)))
        };
        // The nearest of the lines that are left, or first the one most along the direction.
        let order = |k: &usize| {
            if turned > 0 { nearest(*k).0 } else { -dot(way(lines[*k]), [cos, sin]).abs() }
        };
        let Some(next) = (turned..lines.len()).min_by(|a, b| order(a).total_cmp(&order(b))) else { break };
        let (_, like) = nearest(next);
        if dot(way(lines[next]), like) < 0.0 {
            lines[next].reverse();
        }
        lines.swap(turned, next);
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photo::read;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Discs on a ground, with short hairs that lie at `angle` (degrees) at each place.
    fn pelt(mut angle: impl FnMut([f64; 2]) -> f64) -> Raster {
        let size = [320, 240];
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let mut hairs = vec![0.0; size[0] * size[1]];
        for _ in 0..9000 {
            let from = size.map(|side| side as f64 * random.random::<f64>());
            let strength = 0.3 * (random.random::<f64>() - 0.5);
            let (sin, cos) = angle(from).to_radians().sin_cos();
            for step in 0..20 {
                let at = [from[0] + 0.5 * f64::from(step) * cos, from[1] + 0.5 * f64::from(step) * sin];
                let [x, y] = [at[0] as usize, at[1] as usize];
                if x < size[0] && y < size[1] {
                    hairs[y * size[0] + x] += 0.5 * strength;
                }
            }
        }
        let px = |k: usize| {
            let near = |at: usize| (at as f64 + 0.5).rem_euclid(40.0) - 20.0;
            let disc = (9.0 - near(k % size[0]).hypot(near(k / size[0]))).clamp(-0.5, 0.5);
            let light = (0.75 - 0.4 * (disc + 0.5)) * (1.0 + hairs[k]);
            [(255.0 * light.clamp(0.0, 1.0)) as u8; 3]
        };
        Raster { size, rgb: (0..size[0] * size[1]).flat_map(px).collect(), dpi: None }
    }

    fn found(raster: &Raster) -> Option<Hair> {
        hair(raster, &read(raster, false).expect("discs"), 190.0)
    }

    #[test]
    fn the_direction_of_hair_is_found_between_and_on_marks() {
        for (angle, wanted) in [(20.0, 200.0), (110.0, 110.0), (140.0, 140.0), (260.0, 260.0)] {
            let Some(Hair::Angle(found)) = found(&pelt(|_| angle)) else { panic!("{angle}: no direction") };
            assert!((found - wanted).abs() < 3.0, "{angle}: {found}");
        }
    }

    #[test]
    fn hair_that_turns_becomes_lines_that_lead_the_same_way() {
        let angle = |[x, _]: [f64; 2]| 150.0 + 80.0 * x / 320.0;
        let Some(Hair::Lines(lines)) = found(&pelt(angle)) else { panic!("one direction") };
        assert!(lines.len() >= 9, "{}", lines.len());
        for [from, to] in lines {
            let found = (to[1] - from[1]).atan2(to[0] - from[0]).to_degrees().rem_euclid(360.0);
            let wanted = angle([0, 1].map(|axis| 0.5 * (from[axis] + to[axis])));
            assert!((found - wanted).abs() < 10.0, "{from:?} {to:?}: {found} {wanted}");
        }
    }

    #[test]
    fn marks_without_hair_have_no_direction_of_hair() {
        let stripes = |k: usize| {
            let across = (k % 320) as f64 + 0.4 * (k / 320) as f64;
            [(150.0 + 80.0 * (across / 4.0).sin()) as u8; 3]
        };
        let stripes = Raster { size: [320, 240], rgb: (0..320 * 240).flat_map(stripes).collect(), dpi: None };
        assert_eq!(found(&stripes), None);
        let mut random = Pcg64Mcg::seed_from_u64(6);
        assert_eq!(found(&pelt(|_| 360.0 * random.random::<f64>())), None);
    }
}
