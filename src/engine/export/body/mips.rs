//! A picture of colours at all sizes, each half of the one before: the mean colours of whatever a px shows.
//!
//! L. Williams, "Pyramidal Parametrics", SIGGRAPH 1983.

/// Colours, linear light, of a picture and of its smaller copies.
#[derive(Clone, Debug)]
pub struct Mips {
    levels: Vec<Level>,
}

#[derive(Clone, Debug)]
struct Level {
    size: [usize; 2],
    colours: Vec<[f32; 3]>,
}

impl Level {
    /// The colour at a place, in shares of the picture from the upper left corner, between four texels.
    fn at(&self, place: [f64; 2]) -> [f32; 3] {
        let along = |axis: usize| {
            let at = place[axis] * self.size[axis] as f64 - 0.5;
            let low = at.floor();
            let index = |off: f64| (low + off).clamp(0.0, (self.size[axis] - 1) as f64) as usize;
            ([index(0.0), index(1.0)], (at - low) as f32)
        };
        let ((columns, x), (rows, y)) = (along(0), along(1));
        let texel = |column: usize, row: usize| self.colours[rows[row] * self.size[0] + columns[column]];
        let mix = |a: [f32; 3], b: [f32; 3], share: f32| [0, 1, 2].map(|i| a[i] + share * (b[i] - a[i]));
        mix(mix(texel(0, 0), texel(1, 0), x), mix(texel(0, 1), texel(1, 1), x), y)
    }

    /// The picture of half the size.
    fn halved(&self) -> Self {
        let size = self.size.map(|side| side.div_ceil(2));
        let colour = |at: usize| {
            let [column, row] = [2 * (at % size[0]), 2 * (at / size[0])];
            let mut sum = [0.0; 3];
            let mut count = 0.0;
            for y in row..(row + 2).min(self.size[1]) {
                for x in column..(column + 2).min(self.size[0]) {
                    let texel = self.colours[y * self.size[0] + x];
                    sum = [0, 1, 2].map(|i| sum[i] + texel[i]);
                    count += 1.0;
                }
            }
            sum.map(|sum| sum / count)
        };
        Self { size, colours: (0..size[0] * size[1]).map(colour).collect() }
    }
}

impl Mips {
    /// The sizes of a picture, row by row from its upper left corner. Where a texture has no texels, it should have those of its gutter:
    /// small copies mix them with those beside.
    ///
    /// # Panics
    /// If the picture has no texel, or not as many as its size says.
    #[must_use]
    pub fn new(size: [usize; 2], colours: Vec<[f32; 3]>) -> Self {
        assert!(!colours.is_empty() && colours.len() == size[0] * size[1], "a texture of {size:?} texels");
        let mut levels = vec![Level { size, colours }];
        while let Some(last) = levels.last().filter(|last| last.size != [1, 1]) {
            let halved = last.halved();
            levels.push(halved);
        }
        Self { levels }
    }

    /// The mean colour around a texture coordinate, from the lower left corner, over so many texels of the largest picture.
    #[must_use]
    pub fn at(&self, [u, v]: [f64; 2], texels: f64) -> [f32; 3] {
        let level = libm::log2(texels.max(1.0)).min((self.levels.len() - 1) as f64);
        let (low, share) = (level as usize, (level - level.floor()) as f32);
        let place = [u, 1.0 - v];
        let near = self.levels[low].at(place);
        match self.levels.get(low + 1) {
            Some(next) if share > 0.0 => {
                let far = next.at(place);
                [0, 1, 2].map(|i| near[i] + share * (far[i] - near[i]))
            }
            _ => near,
        }
    }

    /// Width and height of the largest picture, texels.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.levels[0].size
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_checkerboard_is_sharp_at_its_own_size_and_gray_when_it_is_small() {
        let colours = (0..64 * 64).map(|at| [((at % 64 + at / 64) % 2) as f32; 3]).collect();
        let mips = Mips::new([64, 64], colours);
        assert_eq!(mips.at([10.5 / 64.0, 1.0 - 20.5 / 64.0], 0.3), [0.0; 3]);
        assert_eq!(mips.at([11.5 / 64.0, 1.0 - 20.5 / 64.0], 1.0), [1.0; 3]);
        for texels in [2.0, 3.7, 1e9] {
            assert_eq!(mips.at([0.3, 0.8], texels), [0.5; 3]);
        }
        // Halfway between two sizes, halfway between their colours.
        assert!((mips.at([10.5 / 64.0, 1.0 - 20.5 / 64.0], 2f64.sqrt())[0] - 0.25).abs() < 1e-3);
    }

    #[test]
    fn sides_that_cannot_be_halved_keep_their_mean() {
        let mips = Mips::new([3, 1], vec![[0.0; 3], [1.0; 3], [0.5; 3]]);
        assert_eq!(mips.at([0.5, 0.5], 1e9), [0.5; 3]);
    }
}
