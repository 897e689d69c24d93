//! Locally weighted linear regression.
//!
//! At a question q the neighbours xᵢ with their answers yᵢ have the weights
//!
//! ```text
//! wᵢ = exp(−(1.5 dᵢ/h)²)      dᵢ = |xᵢ − q| in standardised features, h = distance of the k-th neighbour
//! ```
//!
//! and the answer is β₀ of the line that minimises Σ wᵢ |yᵢ − β₀ − Bᵀ(xᵢ − q)/h|² + λ|B|².
//! (Atkeson, Moore & Schaal, Artificial Intelligence Review 11, 1997, §4–5.) How large k is: [`super::bandwidth`].
//!
//! A row represents its mirror images, too. They are not stored: the distance of a question to the image of a row equals that of
//! the image of the question to the row.

use super::tree::{Near, Place, Tree};
use crate::learn::small_vector::{MOST, SmallVector};

/// A known point of the map: features → outputs. The last two of each are a double-angle vector.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    /// The features, in their own units.
    pub at: SmallVector,
    /// The outputs.
    pub gives: SmallVector,
}

/// The signs by which a double-angle vector is multiplied: first those of the row itself, then those of its mirror images.
pub(super) type Images = &'static [[f64; 2]];

/// No mirror images.
pub(super) const AS_IT_IS: Images = &[[1.0, 1.0]];

/// The known points, standardised.
pub(super) struct Local {
    rows: Vec<Sample>,
    /// Features of a row.
    dims: usize,
    /// Outputs of a row.
    outputs: usize,
    /// Standard deviation of each feature.
    scale: Place,
    /// Features ÷ scale and outputs, row by row.
    known: Vec<[Place; 2]>,
    /// The factors of these for each mirror image.
    signs: Vec<[Place; 2]>,
    images: Images,
    tree: Tree,
    /// Lowest and highest of each output.
    span: [[f64; 2]; MOST],
    /// k of the bandwidth.
    neighbours: usize,
}

/// Whether a parameter varies among the rows by at least 2 %. One that varies less is no feature.
pub(super) fn varies(values: impl Iterator<Item = f64>) -> bool {
    let (low, high) =
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
    high - low > 0.02
}

impl Local {
    /// Standardises `rows`. Both components of the vector have one scale, so that distances do not depend on direction.
    /// `neighbours` is the number of neighbours in the regression; [`super::bandwidth`] chooses it.
    pub fn with_neighbours(rows: Vec<Sample>, images: Images, neighbours: usize) -> Self {
        let (dims, outputs) = rows.first().map_or((0, 0), |row| (row.at.len(), row.gives.len()));
        let scale = scales(rows.iter().map(|row| &row.at.padded), dims, images);
        let divided = |at: &SmallVector| std::array::from_fn(|j| at.padded[j] / scale[j]);
        let known: Vec<[Place; 2]> = rows.iter().map(|row| [divided(&row.at), row.gives.padded]).collect();
        let ones = |len| SmallVector::new(std::iter::repeat_n(1.0, len));
        let signs = images.iter().map(|image| [dims, outputs].map(|len| ones(len).mirrored(*image).padded));
        let tree = Tree::new(known.iter().map(|[x, _]| *x));
        let mut local = Self {
            dims,
            outputs,
            scale,
            signs: signs.collect(),
            images,
            tree,
            span: [[f64::INFINITY, f64::NEG_INFINITY]; MOST],
            neighbours,
            rows,
            known,
        };
        for near in local.everything() {
            let [_, y] = local.known(near);
            for ([low, high], y) in local.span.iter_mut().zip(y) {
                (*low, *high) = (low.min(y), high.max(y));
            }
        }
        local
    }

    /// Features of a row.
    pub fn dims(&self) -> usize {
        self.dims
    }

    /// Outputs of a row.
    pub fn outputs(&self) -> usize {
        self.outputs
    }

    /// The rows, without their mirror images.
    pub fn rows(&self) -> &[Sample] {
        &self.rows
    }

    /// The number of samples, mirror images included, if one row is left out.
    pub fn samples_of_others(&self) -> usize {
        self.rows.len().saturating_sub(1) * self.images.len()
    }

    /// Every sample, with distance 0.
    fn everything(&self) -> impl Iterator<Item = Near> + use<> {
        let images = self.images.len() as u32;
        (0..self.rows.len() as u32)
            .flat_map(move |row| (0..images).map(move |image| Near::new(0.0, row, image)))
    }

    /// This model with another number of neighbours.
    pub fn asking(self, neighbours: usize) -> Self {
        Self { neighbours, ..self }
    }

    /// k of the bandwidth.
    pub fn neighbours(&self) -> usize {
        self.neighbours
    }

    /// The factors of mirror image number `image`.
    pub fn image(&self, image: usize) -> [f64; 2] {
        self.images[image]
    }

    /// Standard deviation of each output over all samples; two that are a vector share one.
    pub fn output_scales(&self) -> Place {
        scales(self.rows.iter().map(|row| &row.gives.padded), self.outputs, self.images)
    }

    /// Standardised features and outputs of a sample, padded with zeros.
    pub fn known(&self, near: Near) -> [Place; 2] {
        let [[x, y], [of_x, of_y]] = [&self.known[near.row()], &self.signs[near.image()]];
        [times(x, of_x), times(y, of_y)]
    }

    /// A sample in its own units.
    pub fn sample(&self, near: Near) -> Sample {
        let (row, image) = (&self.rows[near.row()], self.images[near.image()]);
        Sample { at: row.at.mirrored(image), gives: row.gives.mirrored(image) }
    }

    /// A question in standardised features.
    pub fn standardised(&self, q: &SmallVector) -> Place {
        std::array::from_fn(|j| q.padded[j] / self.scale[j])
    }

    /// The `k` samples nearest to `q`, the nearest first, without those of the row `without`.
    pub fn near(&self, q: &Place, k: usize, without: Option<usize>) -> Vec<Near> {
        let without = without.and_then(|row| u32::try_from(row).ok());
        let images: Vec<Place> = self.signs.iter().map(|[signs, _]| times(q, signs)).collect();
        self.tree.nearest(&images, k, without)
    }

    /// The sample nearest to `q`, ignoring those of the row `without`.
    pub fn nearest(&self, q: &SmallVector, without: Option<usize>) -> Option<Sample> {
        self.near(&self.standardised(q), 1, without).first().map(|near| self.sample(*near))
    }

    /// Outputs clamped to those of the rows.
    pub fn clamped(&self, mut value: SmallVector) -> SmallVector {
        for (value, [low, high]) in value.iter_mut().zip(&self.span) {
            *value = value.clamp(*low, *high);
        }
        value
    }
}

/// a · b, number by number.
fn times(a: &Place, b: &Place) -> Place {
    let mut product = *a;
    product.iter_mut().zip(b).for_each(|(a, b)| *a *= b);
    product
}

/// Standard deviation of each of `len` numbers over rows and their mirror images; the last two, a vector, share one.
fn scales<'a>(rows: impl ExactSizeIterator<Item = &'a Place> + Clone, len: usize, images: Images) -> Place {
    let (n, count) = (rows.len().max(1) as f64, images.len() as f64);
    let mut mean = SmallVector::new([0.0; MOST].into_iter().take(len));
    for row in rows.clone() {
        mean.padded.iter_mut().zip(row).for_each(|(mean, x)| *mean += x / n);
    }
    // The mean of a component over the mirror images is 0 or itself.
    let balance = [0, 1].map(|axis| images.iter().map(|image| image[axis]).sum::<f64>() / count);
    let mean = mean.mirrored(balance).padded;
    let mut variance = SmallVector::new([0.0; MOST].into_iter().take(len));
    for row in rows {
        for ((variance, x), mean) in variance.iter_mut().zip(row).zip(&mean) {
            *variance += (x - mean) * (x - mean) / n;
        }
    }
    if let [.., x, y] = &mut *variance {
        let shared = (*x + *y) / 2.0;
        (*x, *y) = (shared, shared);
    }
    // No division by zero where nothing varies.
    variance.padded.map(|variance| if variance > 1e-18 { variance.sqrt() } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::tree::squared;
    use super::*;

    impl Local {
        /// The `k` nearest samples by a search through all, for comparison with the tree.
        fn nearest_by_full_search(&self, q: &Place, k: usize, without: Option<usize>) -> Vec<Near> {
            let rows = (0..self.rows.len()).filter(|row| without != Some(*row));
            let images = |row| (0..self.images.len()).map(move |image| (row, image));
            let mut near: Vec<Near> = rows
                .flat_map(images)
                .map(|(row, image)| {
                    let [place, _] = self.known(Near::new(0.0, row as u32, image as u32));
                    Near::new(squared(&place, q), row as u32, image as u32)
                })
                .collect();
            near.sort_unstable();
            near.truncate(k);
            near
        }
    }

    /// Points of a 3-D box that fill it evenly without a generator (R₃ sequence), and `f` there.
    fn box_of(n: usize, f: impl Fn(&[f64]) -> Vec<f64>) -> Vec<Sample> {
        (0..n)
            .map(|i| {
                let at = SmallVector::new(
                    [0.819_172_5, 0.671_043_6, 0.549_700_5].map(|a| (0.5 + a * i as f64).fract()),
                );
                Sample { gives: SmallVector::new(f(&at)), at }
            })
            .collect()
    }

    /// A model with 12 neighbours per feature.
    fn twelve(rows: Vec<Sample>) -> Local {
        Local::with_neighbours(rows, AS_IT_IS, 36)
    }

    #[test]
    fn a_plane_is_recovered_exactly() {
        let plane = |x: &[f64]| vec![1.0 + 2.0 * x[0] - 3.0 * x[1] + 40.0 * x[2], 7.0];
        let local = twelve(box_of(200, plane));
        for q in [[0.5, 0.5, 0.5], [0.1, 0.9, 0.3], [0.02, 0.02, 0.02]] {
            let fit = local.fit(&SmallVector::new(q), None);
            assert!((fit.value[0] - plane(&q)[0]).abs() < 5e-4, "{q:?}: {}", fit.value[0]);
            assert_eq!(fit.value[1], 7.0);
            assert!(fit.deviation[0] < 1e-3 && fit.deviation[1] < 1e-12);
        }
    }

    #[test]
    fn an_answer_stays_within_the_range_of_the_rows() {
        let local = twelve(box_of(200, |x| vec![100.0 * x[0]]));
        let high = local.rows().iter().map(|s| s.gives[0]).fold(0.0, f64::max);
        assert_eq!(local.fit(&SmallVector::new([9.0, 0.5, 0.5]), None).value[0], high);
    }

    #[test]
    fn a_row_that_is_left_out_has_no_influence() {
        let mut rows = box_of(100, |x| vec![x[0]]);
        let (q, own) = (rows[40].at, rows[40].at[0]);
        rows[40].gives[0] = 50.0;
        let local = Local::with_neighbours(rows, AS_IT_IS, 21);
        assert!((local.fit(&q, Some(40)).value[0] - own).abs() < 1e-4);
        assert!(local.fit(&q, None).value[0] > own + 1.0);
    }

    #[test]
    fn scatter_is_measured() {
        // Alternately +0.1 and −0.1 from a plane: standard deviation 0.1.
        let mut rows = box_of(400, |x| vec![x[0]]);
        for (i, row) in rows.iter_mut().enumerate() {
            row.gives[0] += if i % 2 == 0 { 0.1 } else { -0.1 };
        }
        let deviation =
            Local::with_neighbours(rows, AS_IT_IS, 60).fit(&SmallVector::new([0.5; 3]), None).deviation[0];
        assert!((0.09..0.13).contains(&deviation), "{deviation}");
    }

    #[test]
    fn rows_at_one_place_give_their_mean() {
        let rows = (0..30)
            .map(|row| Sample {
                at: SmallVector::new([2.0, 0.0, 0.0]),
                gives: SmallVector::new([(row % 3) as f64]),
            })
            .collect();
        let value =
            Local::with_neighbours(rows, AS_IT_IS, 12).fit(&SmallVector::new([2.0, 0.0, 0.0]), None).value[0];
        assert!((value - 1.0).abs() < 0.2, "{value}");
    }

    #[test]
    fn the_nearest_row_is_found() {
        let local = twelve(box_of(50, |x| vec![x[0]]));
        let at = local.rows()[17].at;
        assert_eq!(
            local.nearest(&SmallVector::new([at[0] + 1e-3, at[1], at[2] - 1e-3]), None).unwrap().at,
            at
        );
        assert_ne!(local.nearest(&at, Some(17)).unwrap().at, at);
    }

    #[test]
    fn a_row_represents_its_mirror_images_too() {
        let images: Images = &[[1.0, 1.0], [1.0, -1.0]];
        let row = |a: f64, x: f64, y: f64| Sample {
            at: SmallVector::new([a, x, y]),
            gives: SmallVector::new([a, x, y]),
        };
        let local = Local::with_neighbours(vec![row(0.0, 3.0, 1.0), row(1.0, 5.0, 2.0)], images, 4);
        let near = local.near(&local.standardised(&SmallVector::new([0.0, 3.0, -1.0])), 1, None);
        assert_eq!(near[0], Near::new(0.0, 0, 1));
        assert_eq!(*local.sample(near[0]).gives, [0.0, 3.0, -1.0]);
    }

    /// Coordinates many of which are equal, so that there are ties.
    fn coordinate() -> impl Strategy<Value = f64> {
        prop_oneof![-1.0..1.0_f64, (-2..=2_i8).prop_map(f64::from), Just(-0.0)]
    }

    proptest! {
        #[test]
        fn the_tree_finds_bit_for_bit_what_a_full_search_finds(
            dims in 3..=MOST,
            numbers in proptest::collection::vec(coordinate(), 5..400),
            q in proptest::collection::vec(prop_oneof![coordinate(), -1e9..1e9_f64], MOST),
            k in 0..70_usize,
            without in proptest::option::of(0..80_usize),
            mirrors in any::<bool>(),
        ) {
            let rows: Vec<Sample> = numbers
                .chunks_exact(dims)
                .map(|at| Sample { at: SmallVector::new(at.iter().copied()), gives: SmallVector::new([at[0]]) })
                .collect();
            let images: Images =
                if mirrors { &[[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] } else { AS_IT_IS };
            let local = Local::with_neighbours(rows, images, k);
            let q = local.standardised(&SmallVector::new(q.into_iter().take(dims)));
            prop_assert_eq!(local.near(&q, k, without), local.nearest_by_full_search(&q, k, without));
            // At the place of a row there are ties.
            if !local.known.is_empty() {
                let [q, _] = local.known[k % local.known.len()];
                prop_assert_eq!(local.near(&q, k, without), local.nearest_by_full_search(&q, k, without));
            }
        }
    }
}
