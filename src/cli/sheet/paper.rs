//! The px of a sheet.

/// The colour of the paper.
const BLANK: [u8; 3] = [250, 249, 246];
/// A tile without a picture.
pub const EMPTY: [u8; 3] = [232, 229, 222];

/// A picture to draw on: red, green, blue for each px, row by row from the top.
pub struct Paper {
    /// Width and height, px.
    pub size: [usize; 2],
    /// The px.
    pub rgb: Vec<u8>,
}

impl Paper {
    /// Blank paper.
    pub fn blank(size: [usize; 2]) -> Self {
        Self { size, rgb: BLANK.repeat(size[0] * size[1]) }
    }

    /// Copies a picture of `size` px to the paper, with its upper left corner at `at`. It must fit on the paper.
    pub fn place(&mut self, rgb: &[u8], size: [usize; 2], at: [usize; 2]) {
        for (row, px) in rgb.chunks_exact(3 * size[0]).enumerate() {
            let start = 3 * ((at[1] + row) * self.size[0] + at[0]);
            self.rgb[start..start + px.len()].copy_from_slice(px);
        }
    }

    /// Fills a rectangle.
    pub fn fill(&mut self, at: [usize; 2], size: [usize; 2], colour: [u8; 3]) {
        self.place(&colour.repeat(size[0] * size[1]), size, at);
    }

    /// Mixes a share (0..1) of a colour into a px; px outside of the paper are ignored.
    pub fn blend(&mut self, [x, y]: [i64; 2], colour: [u8; 3], share: f32) {
        let on = |at: i64, side: usize| usize::try_from(at).ok().filter(|at| *at < side);
        let (Some(x), Some(y)) = (on(x, self.size[0]), on(y, self.size[1])) else { return };
        let px = 3 * (y * self.size[0] + x);
        for (under, over) in self.rgb[px..px + 3].iter_mut().zip(colour) {
            let [a, b] = [f32::from(*under), f32::from(over)];
            *under = (a + (b - a) * share.clamp(0.0, 1.0)).round() as u8;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_copied_to_its_place() {
        let mut paper = Paper::blank([4, 3]);
        paper.place(&[1, 2, 3, 4, 5, 6], [2, 1], [1, 2]);
        assert_eq!(paper.rgb[..27], BLANK.repeat(9));
        assert_eq!(paper.rgb[27..33], [1, 2, 3, 4, 5, 6]);
        assert_eq!(paper.rgb[33..], BLANK);
    }

    #[test]
    fn px_outside_of_the_paper_are_ignored() {
        let mut paper = Paper::blank([2, 1]);
        for at in [[-1, 0], [2, 0], [0, 1], [0, -7]] {
            paper.blend(at, [0; 3], 1.0);
        }
        assert_eq!(paper.rgb, BLANK.repeat(2));
        paper.blend([1, 0], [0, 9, 46], 0.5);
        assert_eq!(paper.rgb[3..], [125, 129, 146]);
    }
}
