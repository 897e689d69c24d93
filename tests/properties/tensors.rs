//! The diffusion tensor stays positive definite, and its stencil non-negative.

use crate::cases;
use dapple_engine::rd::selling::{MIN_STRETCH, OFFSETS, Tensor};
use proptest::prelude::*;

/// The diffusion tensor of a stencil with these weights: Σ wₖ eₖeₖᵀ.
fn diffused(weights: &[f32]) -> Tensor {
    let sum = |f: fn(f64, f64) -> f64| -> f64 {
        let offsets = OFFSETS.iter().map(|[x, y]| f(*x as f64, *y as f64));
        weights.iter().zip(offsets).map(|(weight, product)| f64::from(*weight) * product).sum()
    };
    Tensor { xx: sum(|x, _| x * x), xy: sum(|x, y| x * y), yy: sum(|_, y| y * y) }
}

proptest! {
    #![proptest_config(cases(2_000))]

    #[test]
    fn any_tensor_becomes_a_stencil_that_is_non_negative_and_positive_definite(
        size in -6.0..6.0_f64,
        stretch in 0.001..=1.0_f64,
        degrees in -1e4..1e4_f64,
        cell in 0.2..5.0_f64,
    ) {
        let size = libm::pow(10.0, size);
        let tensor = Tensor::oriented(size / stretch, size * stretch, degrees).on_cells([cell, 1.0]);
        let weights = tensor.weights();
        prop_assert!(weights.iter().all(|weight| weight.is_finite() && *weight >= 0.0), "{:?}", weights);
        let made = diffused(&weights);
        let determinant = made.xx * made.yy - made.xy * made.xy;
        prop_assert!(made.xx > 0.0 && made.yy > 0.0 && determinant > 0.0, "{:?} from {:?}", made, tensor);
        // A tensor that is made rounder keeps its size.
        prop_assert!(((made.xx + made.yy) / (tensor.xx + tensor.yy) - 1.0).abs() < 1e-5);
    }

    #[test]
    fn an_allowed_tensor_is_represented_exactly(
        stretch in f64::from(MIN_STRETCH)..=1.0,
        degrees in 0.0..180.0_f64,
    ) {
        let tensor = Tensor::oriented(1.0 / stretch, stretch, degrees);
        let made = diffused(&tensor.weights());
        for (made, asked) in [(made.xx, tensor.xx), (made.xy, tensor.xy), (made.yy, tensor.yy)] {
            prop_assert!((made - asked).abs() < 1e-5 / stretch, "{:?} from {:?}", made, tensor);
        }
    }
}
