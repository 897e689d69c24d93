//! Sums of weighted values of which a few can be left out.

use std::ops::Range;

use super::plane::Plane;

/// Values that are summed one by one. Not tuned.
const FEW: usize = 64;

/// A weighted value at a place, px.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term<const N: usize> {
    pub place: [f64; 2],
    pub weight: f64,
    pub value: [f64; N],
}

/// Values with the sums of all, of both halves, of their halves, and so on.
#[derive(Clone, Debug, Default)]
pub(super) struct PlaneSums<const N: usize> {
    terms: Vec<Term<N>>,
    /// Sum 0 is that of all; sums 2 i + 1 and 2 i + 2 are those of the two halves of the range that has sum i.
    sums: Vec<Plane<N>>,
}

impl<const N: usize> PlaneSums<N> {
    /// The sums of `terms`.
    pub fn new(terms: Vec<Term<N>>) -> Self {
        let (mut longest, mut count) = (terms.len(), 1);
        while longest > FEW {
            (longest, count) = (longest.div_ceil(2), 2 * count + 1);
        }
        let mut sums = Self { terms, sums: vec![Plane::default(); count] };
        sums.sum(0..sums.terms.len(), 0);
        sums
    }

    /// The sum of all.
    pub fn all(&self) -> &Plane<N> {
        &self.sums[0]
    }

    /// The sum of all but these, ascending. Nothing is subtracted, so that what is left out leaves no rounding error.
    pub fn without(&self, left_out: &[usize]) -> Plane<N> {
        let mut sum = Plane::default();
        self.add(0..self.terms.len(), 0, left_out, &mut sum);
        sum
    }

    /// Finds the sum number `at`, of a range, and those of its halves.
    fn sum(&mut self, range: Range<usize>, at: usize) {
        let mut sum = Plane::default();
        match halves(&range) {
            None => self.terms[range].iter().for_each(|term| sum.add(term.place, term.weight, &term.value)),
            Some(halves) => {
                for (half, at) in halves.into_iter().zip(2 * at + 1..) {
                    self.sum(half, at);
                    sum.merge(&self.sums[at]);
                }
            }
        }
        self.sums[at] = sum;
    }

    /// Adds a range, whose sum is number `at`, without what is left out.
    fn add(&self, range: Range<usize>, at: usize, left_out: &[usize], sum: &mut Plane<N>) {
        let first = left_out.partition_point(|index| *index < range.start);
        let left_out = &left_out[first..left_out.partition_point(|index| *index < range.end)];
        if left_out.is_empty() {
            sum.merge(&self.sums[at]);
            return;
        }
        match halves(&range) {
            None => {
                let kept = range.filter(|index| left_out.binary_search(index).is_err());
                kept.map(|index| &self.terms[index])
                    .for_each(|term| sum.add(term.place, term.weight, &term.value));
            }
            Some(halves) => {
                halves.into_iter().zip(2 * at + 1..).for_each(|(half, at)| self.add(half, at, left_out, sum));
            }
        }
    }
}

/// The halves of a range with more than a few values.
fn halves(range: &Range<usize>) -> Option<[Range<usize>; 2]> {
    let middle = range.start + range.len() / 2;
    (range.len() > FEW).then_some([range.start..middle, middle..range.end])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_out_does_not_count() {
        for n in [0, 1, 5, 64, 65, 300, 1000] {
            // Whole numbers, so that no sum is rounded.
            let term = |i: usize| Term {
                place: [(i % 13) as f64, (i % 7) as f64],
                weight: (1 + i % 3) as f64,
                value: [(i % 11) as f64, i as f64],
            };
            let sums = PlaneSums::new((0..n).map(term).collect());
            let rare: Vec<usize> = (0..n).filter(|i| i % 97 == 5).collect();
            let first: Vec<usize> = (0..n / 2).collect();
            for left_out in [Vec::new(), rare, first, (0..n).collect()] {
                let mut expected = Plane::default();
                for i in (0..n).filter(|i| !left_out.contains(i)) {
                    let Term { place, weight, value } = term(i);
                    expected.add(place, weight, &value);
                }
                assert_eq!(sums.without(&left_out), expected, "{n}: {left_out:?}");
            }
            assert_eq!(*sums.all(), sums.without(&[]));
        }
    }
}
