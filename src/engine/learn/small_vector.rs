//! Up to five coordinates without a heap allocation.

use std::ops::{Deref, DerefMut};

/// Most coordinates: the four features of spots plus the second component of the vector.
pub(super) const MOST: usize = 5;

/// Up to [`MOST`] coordinates; those beyond its length are 0.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct SmallVector {
    /// All numbers, zeros at the end.
    pub padded: [f64; MOST],
    len: usize,
}

impl SmallVector {
    /// The numbers in their order.
    pub fn new(numbers: impl IntoIterator<Item = f64>) -> Self {
        let mut point = Self::default();
        point.extend(numbers);
        point
    }

    /// Appends numbers.
    ///
    /// # Panics
    /// Never for at most [`MOST`] numbers in all.
    pub fn extend(&mut self, numbers: impl IntoIterator<Item = f64>) {
        for number in numbers {
            self.padded[self.len] = number;
            self.len += 1;
        }
    }

    /// The double-angle vector in the last two numbers, its components times ±1: a mirror image.
    pub fn mirrored(mut self, [c, s]: [f64; 2]) -> Self {
        if let [.., x, y] = &mut *self {
            (*x, *y) = (*x * c, *y * s);
        }
        self
    }
}

impl Deref for SmallVector {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.padded[..self.len]
    }
}

impl DerefMut for SmallVector {
    fn deref_mut(&mut self) -> &mut [f64] {
        &mut self.padded[..self.len]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mirror_image_changes_the_last_two_numbers_and_not_the_padding() {
        let point = SmallVector::new([1.0, 2.0, 3.0]);
        assert_eq!(*point.mirrored([-1.0, 1.0]), [1.0, -2.0, 3.0]);
        assert_eq!(point.mirrored([1.0, -1.0]).padded, [1.0, 2.0, -3.0, 0.0, 0.0]);
    }
}
