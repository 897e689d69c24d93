//! Woven cloth: threads of the warp, along y, and of the weft, along x, one over the other by the rule of the weave.

use super::light;
use super::noise::{Noise, Random, floor, part_seed, whole_cells, wrapped};
use super::surfel::{Source, Surfel};

/// The rule by which threads of the warp lie over those of the weft.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weave {
    /// Every thread goes over one and under one.
    Plain,
    /// Every thread goes over two and under two, one further in each row (2/2 twill).
    Twill,
}

/// The share of a thread's colour that is that of the middle of its float.
const FROM_MIDDLE: f32 = 0.85;

impl Weave {
    /// Threads that a float lies over.
    fn float(self) -> i32 {
        match self {
            Self::Plain => 1,
            Self::Twill => 2,
        }
    }

    /// Whether warp thread `column` lies over weft thread `row`, and the place of this crossing in the float, counted from 0.
    fn over(self, column: i32, row: i32) -> (bool, i32) {
        let float = self.float();
        let place = (column + row).rem_euclid(2 * float);
        (place < float, place % float)
    }
}

/// Cloth of threads that are `size` px apart.
#[must_use]
pub fn woven(source: &Source, size: f32, weave: Weave) -> Vec<Surfel> {
    let mut picture = source.shaded(surfel(source, size, weave));
    light::apply(&mut picture, source, 0.05);
    picture
}

pub(super) fn surfel<'a>(
    source: &'a Source,
    size: f32,
    weave: Weave,
) -> impl Fn([f32; 2]) -> Surfel + Sync + 'a {
    // A whole number of repeats of the weave, so that the cloth continues on a tile.
    let repeat = 2 * weave.float() as usize;
    let threads = whole_cells(source.canvas, repeat as f32 * size).map(|repeats| repeats * repeat);
    let apart = [0, 1].map(|axis| source.canvas[axis] / threads[axis] as f32);
    let seeds = [part_seed(source.seed, 64), part_seed(source.seed, 65)];
    let slubs = Noise::new(source.canvas, 6.0 * size, part_seed(source.seed, 66));
    let fuzz = Noise::new(source.canvas, 0.16 * size, part_seed(source.seed, 67));
    let fine = (0.22 * size * source.scale()[0] - 0.9).clamp(0.0, 1.0);
    move |point| {
        let place = [0, 1].map(|axis| point[axis] / apart[axis]);
        let [column, row] = place.map(floor);
        let (warp, step) = weave.over(column, row);
        // Along the float, and across the thread.
        let (along, across) = if warp { (1, 0) } else { (0, 1) };
        // The weft is on top where the warp is not: its steps count from the other side.
        let float = weave.float() as f32;
        let step = step as f32;
        let from_start = step + place[along] - floor(place[along]) as f32;
        let off = place[across] - floor(place[across]) as f32 - 0.5;
        let thread = if warp { column } else { row };
        let mut random = Random::of(seeds[along], [wrapped(thread, threads[across]) as u32, 0]);
        let dye = 1.0 + 0.1 * random.signed();
        // Threads of uneven thickness.
        let thick = 0.46
            + 0.05 * slubs.at(if warp { [point[0] * 3.0, point[1]] } else { [point[0], point[1] * 3.0] });
        let round = (off / thick).clamp(-1.0, 1.0);
        let arch = 2.0 * from_start / float - 1.0;
        let to_middle = {
            let mut by = [0.0; 2];
            by[along] = (0.5 * float - from_start) * apart[along];
            by[across] = -off * apart[across];
            by
        };
        let [red, green, blue, ink] =
            source.carried(point, to_middle, (0.5 * float + 0.4) * size, FROM_MIDDLE);
        let profile = 1.0 - round * round;
        let bow = 1.0 - arch * arch * arch * arch;
        // Fibres twisted along the thread.
        let twist = from_start * 1.6 + off * 2.2 + thread as f32 * 0.37;
        let strand = twist - floor(twist) as f32;
        let groove = fine * 4.0 * (strand - 0.5) * (strand - 0.5);
        let hairs = fuzz.at(point);
        Surfel {
            colour: [red, green, blue],
            tint: dye
                * (0.42 + 0.58 * profile.max(0.0).sqrt())
                * (0.72 + 0.28 * bow)
                * (1.0 - 0.2 * groove)
                * (1.0 + 0.08 * hairs),
            light: 1.0,
            height: size
                * (0.26 * profile.max(0.0).sqrt() * (0.5 + 0.5 * bow)
                    + 0.03 * (1.0 - groove)
                    + 0.012 * hairs),
            roughness: 0.85 + 0.05 * hairs,
            ink,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn threads_go_over_as_many_as_under() {
        for weave in [Weave::Plain, Weave::Twill] {
            for thread in -3..5 {
                let period = 2 * weave.float();
                let over = (0..period).filter(|row| weave.over(thread, *row).0).count();
                assert_eq!(over as i32, weave.float());
                let turned = (0..period).filter(|column| weave.over(*column, thread).0).count();
                assert_eq!(turned as i32, weave.float());
            }
        }
    }
}
