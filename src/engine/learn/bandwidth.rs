//! The number of neighbours of the regression, chosen by cross validation.
//!
//! Few neighbours follow the curvature of the map, many average out the noise of the rows; which matters more depends on
//! the number of rows and their noise. (Atkeson, Moore & Schaal, Artificial Intelligence Review 11, 1997, §7.1: global
//! tuning of a nearest-neighbour bandwidth by leave-one-out cross validation.)

use rayon::prelude::*;

use super::local::{Images, Local, Sample};
use crate::learn::weighted_line::Line;

/// Candidate numbers of neighbours per feature. Fewer than 8 may be two rows and their mirror images: good on average,
/// but they do not define a linear map.
pub(super) const CANDIDATES: [usize; 4] = [8, 14, 25, 45];
/// Number of rows that are left out in turn, at regular steps. Twice as many give the same choice or the next one.
const QUESTIONS: usize = 64;

/// Mean squared errors up to this multiple of the smallest one count as equal. The smaller number of neighbours is then preferred:
/// they are closer where the map is more curved than on average, and an answer takes less time.
const NEARLY: f64 = 1.02;

impl Local {
    /// Standardises `rows`. The number of neighbours is chosen by cross validation, unless the choice is `known`.
    pub fn new(rows: Vec<Sample>, images: Images, known: Option<usize>) -> Self {
        let local = Self::with_neighbours(rows, images, 0);
        let neighbours = known.unwrap_or_else(|| chosen(&local));
        local.asking(neighbours)
    }
}

/// The number of neighbours with the smallest error when rows of `local` are predicted from the others.
fn chosen(local: &Local) -> usize {
    let most = local.samples_of_others();
    let counts: Vec<usize> =
        CANDIDATES.iter().map(|each| each * local.dims()).filter(|count| *count <= most).collect();
    let errors = errors(local, &counts);
    let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
    let mut good = counts.iter().zip(&errors).filter(|(_, error)| **error <= NEARLY * least);
    good.next().map_or(most, |(count, _)| *count)
}

/// Mean error of the answers for rows left out, for each number of neighbours: the sum over the outputs of (error ÷
/// standard deviation over the rows)².
fn errors(local: &Local, counts: &[usize]) -> Vec<f64> {
    let rows = local.rows();
    let Some(most) = counts.iter().max() else { return Vec::new() };
    let scales = local.output_scales();
    let questions = QUESTIONS.min(rows.len());
    let of_each: Vec<Vec<f64>> = (0..questions)
        .into_par_iter()
        .map(|question| {
            let row = question * rows.len() / questions;
            let q = local.standardised(&rows[row].at);
            // One search for all numbers: a smaller set of neighbours is the beginning of a larger one.
            let near = local.near(&q, *most, Some(row));
            let error = |count: &usize| {
                let value = Line::through(local, &q, &near[..*count]).value();
                let off = value.iter().zip(rows[row].gives.iter()).zip(&scales);
                off.map(|((value, gives), scale)| ((value - gives) / scale).powi(2)).sum()
            };
            counts.iter().map(error).collect()
        })
        .collect();
    // Added up in the order of the rows, so that the number of threads does not change the sum.
    (0..counts.len())
        .map(|i| of_each.iter().map(|errors| errors[i]).sum::<f64>() / questions as f64)
        .collect()
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    use super::super::local::AS_IT_IS;
    use super::*;
    use crate::learn::small_vector::SmallVector;

    /// 400 rows all over a box, and `f` there with noise up to ±`noise`.
    fn rows(f: impl Fn(&[f64; 3]) -> f64, noise: f64) -> Vec<Sample> {
        let rng = &mut Pcg64::seed_from_u64(5);
        (0..400)
            .map(|_| {
                let at: [f64; 3] = std::array::from_fn(|_| rng.random());
                let gives = f(&at) + noise * (2.0 * rng.random::<f64>() - 1.0);
                Sample { at: SmallVector::new(at), gives: SmallVector::new([gives]) }
            })
            .collect()
    }

    /// Neighbours per feature chosen for such rows; and whether many give smaller errors than few.
    fn chosen_by(f: impl Fn(&[f64; 3]) -> f64, noise: f64) -> (usize, bool) {
        let local = Local::new(rows(f, noise), AS_IT_IS, None);
        let errors = errors(&local, &[24, 135]);
        (local.neighbours() / 3, errors[1] < 0.96 * errors[0])
    }

    #[test]
    fn noisy_rows_of_a_plane_need_more_neighbours() {
        assert_eq!(chosen_by(|[x, y, z]| x + 2.0 * y - z, 0.5), (14, true));
    }

    #[test]
    fn exact_rows_of_a_curved_map_need_few_neighbours() {
        let curved = |[x, y, z]: &[f64; 3]| libm::sin(6.0 * x) * libm::cos(5.0 * y) + z * z;
        assert_eq!(chosen_by(curved, 0.0), (8, false));
    }

    #[test]
    fn the_chosen_number_of_neighbours_is_at_most_the_number_of_samples() {
        for n in [1, 2, 7, 30] {
            let rows: Vec<Sample> = rows(|[x, ..]| *x, 0.1).into_iter().take(n).collect();
            assert!(Local::new(rows, AS_IT_IS, None).neighbours() < n.max(1));
        }
    }

    #[test]
    fn the_choice_does_not_depend_on_the_number_of_threads() {
        let errors_on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            let local = Local::with_neighbours(rows(|[x, y, _]| x * y, 0.1), AS_IT_IS, 0);
            pool.install(|| errors(&local, &[15, 36]))
        };
        assert_eq!(errors_on(1), errors_on(3));
    }
}
