//! Marks of several colours on one ground.
//!
//! A single channel cannot separate them from the ground if the ground lies between two of them, or one of them between the ground
//! and another. In this case the colours of the picture are found one by one (maxima of their density). The commonest is the
//! ground. The share of mark in a colour follows from its distances:
//!
//! p = d_g ÷ (d_g + min d_m)
//!
//! with its distances d_g and d_m in OKLab from the ground and from each of the marks' colours. Where the blur of an edge mixes the
//! ground and one colour, p is the share of that colour.

use rayon::prelude::*;

use super::lab::Lab;
use super::light::Light;

/// Side of a bin of colours, OKLab.
const BIN: f32 = 0.02;
/// Number of bins of L, which is 0..1 and higher where light is divided out, and of a and b, −0.4..0.4.
const BINS: [usize; 3] = [60, 40, 40];
/// Lower limits of the first bins.
const LOWEST: [f32; 3] = [0.0, -0.4, -0.4];
/// Passes of a mean over three bins each way, which smooth the density: together a Gaussian of σ = 0.03.
const PASSES: usize = 3;
/// Colours nearer than this are one, OKLab.
const APART: f32 = 0.12;
/// The density between two colours falls below this share of that of the rarer one; in shaded marks it does not.
const VALLEY: f32 = 0.5;
/// Least share of a colour of marks among all cells whose surroundings have one colour.
const RAREST: f64 = 0.02;
/// Least share of the picture that the ground covers: with less, the ground cannot be identified.
const GROUND: f64 = 0.5;
/// Change of colour over a cell at which the weight of a cell is one half: edges have no colours of their own. OKLab.
const CHANGE: f32 = 0.02;
/// Number of cells that are sampled.
const ENOUGH: usize = 1 << 17;

/// The colours of a picture in full light, OKLab.
#[derive(Clone, Debug, PartialEq)]
pub struct MarkColours {
    light: Light,
    ground: [f32; 3],
    marks: Vec<[f32; 3]>,
}

/// A sampled cell.
struct Sample {
    colour: [f32; 3],
    /// Weight: it decreases with the change of colour around the cell.
    weight: f32,
}

impl MarkColours {
    /// The colours of ground and marks if there are at least three, and one of them covers most; `share` is the single channel's
    /// value of each cell: 0 = ground, 1 = marks, or the reverse.
    #[must_use]
    pub fn of(lab: &Lab, share: &[f32]) -> Option<Self> {
        let cells = looked_at(lab.size);
        let side = |takes: fn(f32) -> bool| -> Vec<usize> {
            cells.iter().copied().filter(|cell| takes(share[*cell])).collect()
        };
        let light = Light::of(lab, [&side(|share| share < 0.25), &side(|share| share > 0.75)]);
        let samples: Vec<Sample> = cells.iter().map(|cell| sample(lab, &light, *cell)).collect();
        let mut groups = groups(&samples, &Density::of(&samples));
        groups.sort_by(|a, b| b.cells.total_cmp(&a.cells));
        let ground = groups.first()?;
        if groups.len() < 3 || ground.cells < GROUND {
            return None;
        }
        let marks = groups[1..].iter().map(|group| group.colour).collect();
        Some(Self { light, ground: ground.colour, marks })
    }

    /// The share of mark in each cell: 0 = ground, 1 = a mark.
    #[must_use]
    pub fn shares(&self, lab: &Lab) -> Vec<f32> {
        (0..lab.planes[0].len())
            .into_par_iter()
            .map(|cell| {
                let colour = self.light.divided_out(lab, cell);
                let ground = distance(colour, self.ground);
                let mark =
                    self.marks.iter().map(|mark| distance(colour, *mark)).fold(f32::INFINITY, f32::min);
                ground / (ground + mark).max(f32::MIN_POSITIVE)
            })
            .collect()
    }

    /// The least difference of the ground and a colour of marks, OKLab.
    #[must_use]
    pub fn contrast(&self) -> f32 {
        self.marks.iter().map(|mark| distance(*mark, self.ground)).fold(f32::INFINITY, f32::min)
    }
}

fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    (0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum::<f32>().sqrt()
}

/// Some cells of all rows and columns except the outermost.
fn looked_at([width, height]: [usize; 2]) -> Vec<usize> {
    let step = (width * height / ENOUGH + 1) | 1;
    let is_inner = |cell: &usize| {
        let (x, y) = (cell % width, cell / width);
        x > 0 && y > 0 && x + 1 < width && y + 1 < height
    };
    (0..width * height).step_by(step).filter(is_inner).collect()
}

/// The mean colour of 3 × 3 cells in full light.
fn sample(lab: &Lab, light: &Light, cell: usize) -> Sample {
    let width = lab.size[0];
    let around = [cell - width - 1, cell - width, cell - width + 1, cell - 1, cell, cell + 1]
        .into_iter()
        .chain([cell + width - 1, cell + width, cell + width + 1]);
    let mut colour = [0.0; 3];
    for (k, sum) in colour.iter_mut().enumerate() {
        *sum = around.clone().map(|cell| lab.planes[k][cell]).sum::<f32>() / 9.0;
    }
    let lit = light.divided_out(lab, cell)[0] / lab.planes[0][cell].max(f32::MIN_POSITIVE);
    let row = |at: usize, plane: usize| (0..3).map(|x| lab.planes[plane][at - 1 + x]).sum::<f32>();
    let column = |at: usize, plane: usize| {
        [at - width, at, at + width].iter().map(|at| lab.planes[plane][*at]).sum::<f32>()
    };
    let change = |plane: usize| {
        let down = row(cell + width, plane) - row(cell - width, plane);
        let across = column(cell + 1, plane) - column(cell - 1, plane);
        (down * down + across * across) / 36.0
    };
    let change = (0..3).map(change).sum::<f32>() / (CHANGE * CHANGE);
    Sample { colour: colour.map(|value| value * lit), weight: 1.0 / (1.0 + change) }
}

/// The density of colours.
struct Density {
    bins: Vec<f32>,
}

impl Density {
    fn of(samples: &[Sample]) -> Self {
        let mut bins = vec![0.0; BINS.iter().product()];
        for sample in samples {
            bins[bin(sample.colour)] += sample.weight;
        }
        let strides = [BINS[1] * BINS[2], BINS[2], 1];
        for _ in 0..PASSES {
            for (axis, stride) in strides.into_iter().enumerate() {
                bins = smoothed(&bins, BINS[axis], stride);
            }
        }
        Self { bins }
    }

    fn at(&self, colour: [f32; 3]) -> f32 {
        self.bins[bin(colour)]
    }

    /// The bins where the density is largest among all within [`APART`], the largest first, as colours.
    fn peaks(&self) -> Vec<[f32; 3]> {
        let mut order: Vec<usize> = (0..self.bins.len()).filter(|bin| self.bins[*bin] > 0.0).collect();
        order.sort_by(|a, b| self.bins[*b].total_cmp(&self.bins[*a]).then(a.cmp(b)));
        let mut peaks: Vec<[f32; 3]> = Vec::new();
        // Few are enough: a colour rarer than a thousandth of the commonest one is no colour of a texture.
        let least = order.first().map_or(0.0, |first| self.bins[*first] / 1000.0);
        for colour in order.iter().take_while(|bin| self.bins[**bin] > least).map(|bin| middle(*bin)) {
            if peaks.iter().all(|peak| self.has_valley(*peak, colour)) {
                peaks.push(colour);
            }
        }
        peaks
    }

    /// Whether two colours are apart and the density between them is lower than at both.
    fn has_valley(&self, common: [f32; 3], rare: [f32; 3]) -> bool {
        const STEPS: usize = 16;
        let between = |k: usize| {
            let t = k as f32 / STEPS as f32;
            self.at([0, 1, 2].map(|axis| common[axis] + t * (rare[axis] - common[axis])))
        };
        let lowest = (1..STEPS).map(between).fold(f32::INFINITY, f32::min);
        distance(common, rare) > APART && lowest < VALLEY * self.at(rare)
    }
}

/// The bin of a colour.
fn bin(colour: [f32; 3]) -> usize {
    let place = |k: usize| (((colour[k] - LOWEST[k]) / BIN).max(0.0) as usize).min(BINS[k] - 1);
    (place(0) * BINS[1] + place(1)) * BINS[2] + place(2)
}

/// The colour in the middle of a bin.
fn middle(bin: usize) -> [f32; 3] {
    let places = [bin / (BINS[1] * BINS[2]), bin / BINS[2] % BINS[1], bin % BINS[2]];
    [0, 1, 2].map(|k| LOWEST[k] + (places[k] as f32 + 0.5) * BIN)
}

/// Means over three bins along an axis of `count` bins that are `stride` apart; bins beyond the ends are empty.
fn smoothed(bins: &[f32], count: usize, stride: usize) -> Vec<f32> {
    let mean = |at: usize| {
        let place = at / stride % count;
        let below = if place > 0 { bins[at - stride] } else { 0.0 };
        let above = if place + 1 < count { bins[at + stride] } else { 0.0 };
        (below + bins[at] + above) / 3.0
    };
    (0..bins.len()).map(mean).collect()
}

/// Cells of one colour.
struct Group {
    colour: [f32; 3],
    /// Share of the cells; cells at edges have less weight.
    cells: f64,
}

/// The colours that are common enough, each with the cells that are nearest to it.
fn groups(samples: &[Sample], density: &Density) -> Vec<Group> {
    let peaks = density.peaks();
    // Weight, L, a and b.
    let mut sums = vec![[0.0_f64; 4]; peaks.len()];
    for sample in samples {
        let far = |peak: &[f32; 3]| distance(*peak, sample.colour);
        let nearest = (0..peaks.len()).min_by(|a, b| far(&peaks[*a]).total_cmp(&far(&peaks[*b])));
        let Some(nearest) = nearest.filter(|peak| far(&peaks[*peak]) < APART) else { continue };
        let [l, a, b] = sample.colour;
        let weight = f64::from(sample.weight);
        let more = [1.0, l, a, b].map(|value| weight * f64::from(value));
        sums[nearest].iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
    }
    let all: f64 = samples.iter().map(|sample| f64::from(sample.weight)).sum();
    let group = |[weight, l, a, b]: [f64; 4]| Group {
        colour: [l, a, b].map(|sum| (sum / weight) as f32),
        cells: weight / all,
    };
    sums.into_iter().filter(|sum| sum[0] > RAREST * all).map(group).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [120, 120];
    const GROUND_COLOUR: [f32; 3] = [0.75, 0.05, 0.02];
    const MARKS: [[f32; 3]; 2] = [[0.95, -0.02, 0.1], [0.4, 0.15, 0.05]];

    /// Discs of radius 6 every 20 cells, every second one of the other colour, with edges of a cell, in light that falls off.
    fn discs(colours: [[f32; 3]; 2]) -> Lab {
        let colour = |cell: usize| {
            let (x, y) = (cell % SIZE[0], cell / SIZE[0]);
            let near = |x: usize| (x as f32 + 0.5).rem_euclid(20.0) - 10.0;
            let share = (6.5 - near(x).hypot(near(y))).clamp(0.0, 1.0);
            let mark = colours[(x / 20 + y / 20) % 2];
            let light = 1.0 - 0.3 * x as f32 / SIZE[0] as f32;
            [0, 1, 2].map(|k| light * (GROUND_COLOUR[k] + share * (mark[k] - GROUND_COLOUR[k])))
        };
        let cells: Vec<[f32; 3]> = (0..SIZE[0] * SIZE[1]).map(colour).collect();
        Lab { size: SIZE, factor: 1, planes: [0, 1, 2].map(|k| cells.iter().map(|cell| cell[k]).collect()) }
    }

    /// The values of a channel that shows only the first colour.
    fn one_channel() -> Vec<f32> {
        let seen = discs([MARKS[0], GROUND_COLOUR]);
        let (low, high) = (GROUND_COLOUR[0], MARKS[0][0]);
        let light = |cell: usize| 1.0 - 0.3 * (cell % SIZE[0]) as f32 / SIZE[0] as f32;
        seen.planes[0].iter().enumerate().map(|(cell, l)| (l / light(cell) - low) / (high - low)).collect()
    }

    #[test]
    fn dots_of_both_colours_are_marks_and_their_edges_are_half_way() {
        let lab = discs(MARKS);
        let found = MarkColours::of(&lab, &one_channel()).expect("three colours");
        assert_eq!(found.marks.len(), 2);
        assert!(distance(found.ground, GROUND_COLOUR) < 0.03, "{found:?}");
        let shares = found.shares(&lab);
        let at = |x: usize, y: usize| shares[y * SIZE[0] + x];
        for (x, y) in [(10, 10), (30, 10), (90, 110)] {
            assert!(at(x, y) > 0.9, "{x} {y}: {}", at(x, y));
            // Six cells from the middle, to within half of a cell.
            let edge = (0..10).map(|step| at(x + step, y)).take_while(|share| *share > 0.5).count();
            assert!((6..=7).contains(&edge), "{edge}");
        }
        assert!(at(20, 20) < 0.1);
    }

    #[test]
    fn marks_of_one_colour_are_left_to_the_channel() {
        let lab = discs([MARKS[0]; 2]);
        let share = one_channel();
        assert_eq!(MarkColours::of(&lab, &share), None);
    }
}
