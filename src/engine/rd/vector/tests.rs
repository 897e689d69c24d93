//! Every vector type computes the same bits as plain f32.

use super::*;
use crate::rd::wavefront::Instructions;

/// Values of every kind, including zeros of both signs and NaN: four of the widest vectors.
fn values() -> Vec<f32> {
    let special = [0.0, -0.0, 1.0, -1.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, f32::MIN_POSITIVE];
    (0..64).map(|i| if i % 3 == 0 { special[i / 3 % 8] } else { libm::sinf(i as f32 * 7.3) * 3.0 }).collect()
}

/// The bits of all operations on two lists of values.
#[inline(always)]
fn computed<V: Vector>(a: &[f32], b: &[f32]) -> Vec<u32> {
    let mut results = vec![0.0f32; 5 * a.len()];
    for at in (0..a.len()).step_by(V::WIDTH) {
        // SAFETY: the lengths of all lists are multiples of the widest vector's.
        unsafe {
            let (x, y) = (V::load(a[at..].as_ptr()), V::load(b[at..].as_ptr()));
            let all =
                [x.at_least(0.25), x.larger(y), x.smaller(y), x.absolute(), x.soft_step(y, V::splat(0.5))];
            for (k, value) in all.into_iter().enumerate() {
                value.store(results[k * a.len() + at..].as_mut_ptr());
            }
        }
    }
    results.into_iter().map(f32::to_bits).collect()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn computed_avx2(a: &[f32], b: &[f32]) -> Vec<u32> {
    computed::<Eight>(a, b)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl")]
fn computed_avx512(a: &[f32], b: &[f32]) -> Vec<u32> {
    computed::<Sixteen>(a, b)
}

#[test]
fn every_vector_type_computes_the_bits_of_plain_f32() {
    let a = values();
    let b: Vec<f32> = a.iter().cycle().skip(5).take(a.len()).copied().collect();
    let pairs = || a.iter().zip(&b);
    let mut plain: Vec<f32> = a.iter().map(|x| x.at_least(0.25)).collect();
    plain.extend(pairs().map(|(x, y)| x.larger(*y)));
    plain.extend(pairs().map(|(x, y)| x.smaller(*y)));
    plain.extend(a.iter().map(|x| x.absolute()));
    plain.extend(pairs().map(|(x, y)| x.soft_step(*y, 0.5)));
    let plain: Vec<u32> = plain.into_iter().map(f32::to_bits).collect();
    for instructions in Instructions::available() {
        let found = match instructions {
            Instructions::Baseline => computed::<Four>(&a, &b),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the processor supports them.
            Instructions::Avx2 => unsafe { computed_avx2(&a, &b) },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: the processor supports them.
            Instructions::Avx512 => unsafe { computed_avx512(&a, &b) },
        };
        // NaN results need not have the same bits.
        let same = |(plain, found): (&u32, &u32)| {
            plain == found || f32::from_bits(*plain).is_nan() && f32::from_bits(*found).is_nan()
        };
        assert!(plain.len() == found.len() && plain.iter().zip(&found).all(same), "{instructions:?}");
    }
}

#[test]
fn a_soft_step_rises_from_0_to_1_about_its_threshold() {
    let step = |x: f32| x.soft_step(2.0, 0.5);
    assert_eq!([1.0, 1.5, 2.0, 2.25, 2.5, 9.0].map(step), [0.0, 0.0, 0.5, 0.75, 1.0, 1.0]);
}
