//! Pairs of numbers side by side in memory, read and written as two vectors: two chemicals of one vertex are always read
//! together, and reading from places all over memory takes as long for two numbers as for one.

#[cfg(target_arch = "x86_64")]
use super::{Eight, Sixteen};
use super::{Four, Vector};

/// A vector that reads and writes pairs.
pub trait Pairs: Vector {
    /// The first and the second numbers of the pairs that follow `from`.
    ///
    /// # Safety
    /// `WIDTH` pairs must be readable there.
    unsafe fn load_pairs(from: *const [f32; 2]) -> [Self; 2];

    /// Stores pairs.
    ///
    /// # Safety
    /// `WIDTH` pairs must be writable there.
    unsafe fn store_pairs(pairs: [Self; 2], to: *mut [f32; 2]);

    /// The first and the second numbers of the pairs with the indices that follow `at`.
    ///
    /// # Safety
    /// `WIDTH` indices must be readable there, and at each of them a pair from `from` on.
    unsafe fn gather_pairs(from: *const [f32; 2], at: *const u32) -> [Self; 2];
}

impl Pairs for Four {
    #[inline(always)]
    unsafe fn load_pairs(from: *const [f32; 2]) -> [Self; 2] {
        // SAFETY: the caller guarantees that the pairs are readable.
        let [a, e, b, f, c, g, d, h] = unsafe { from.cast::<[f32; 8]>().read_unaligned() };
        [Self([a, b, c, d]), Self([e, f, g, h])]
    }

    #[inline(always)]
    unsafe fn store_pairs([first, second]: [Self; 2], to: *mut [f32; 2]) {
        let ([a, b, c, d], [e, f, g, h]) = (first.0, second.0);
        // SAFETY: the caller guarantees that the pairs are writable.
        unsafe { to.cast::<[f32; 8]>().write_unaligned([a, e, b, f, c, g, d, h]) }
    }

    #[inline(always)]
    unsafe fn gather_pairs(from: *const [f32; 2], at: *const u32) -> [Self; 2] {
        // SAFETY: the caller guarantees that the indices are readable, and so are the pairs there.
        unsafe {
            let [a, b, c, d] = at.cast::<[u32; 4]>().read_unaligned();
            of_four(from, [a as usize, b as usize, c as usize, d as usize])
        }
    }
}

/// Four pairs as the first and the second numbers.
///
/// # Safety
/// There must be a pair at each index.
#[cfg(not(target_arch = "x86_64"))]
#[inline(always)]
unsafe fn of_four(from: *const [f32; 2], [a, b, c, d]: [usize; 4]) -> [Four; 2] {
    // SAFETY: the caller guarantees that the pairs are readable.
    let [a, b, c, d] = unsafe { [*from.add(a), *from.add(b), *from.add(c), *from.add(d)] };
    [Four([a[0], b[0], c[0], d[0]]), Four([a[1], b[1], c[1], d[1]])]
}

/// Four pairs as the first and the second numbers, one load a pair: compilers load each number by itself.
///
/// # Safety
/// There must be a pair at each index.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
unsafe fn of_four(from: *const [f32; 2], [a, b, c, d]: [usize; 4]) -> [Four; 2] {
    use std::arch::x86_64::*;
    // SAFETY: the caller guarantees that the pairs are readable; every processor of this architecture has SSE2.
    unsafe {
        let two = |i: usize, j: usize| {
            let first = _mm_load_sd(from.add(i).cast());
            _mm_castpd_ps(_mm_loadh_pd(first, from.add(j).cast()))
        };
        let (ab, cd) = (two(a, b), two(c, d));
        let (mut first, mut second) = ([0.0; 4], [0.0; 4]);
        _mm_storeu_ps(first.as_mut_ptr(), _mm_shuffle_ps::<0b10_00_10_00>(ab, cd));
        _mm_storeu_ps(second.as_mut_ptr(), _mm_shuffle_ps::<0b11_01_11_01>(ab, cd));
        [Four(first), Four(second)]
    }
}

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Eight, Pairs, Sixteen};
    use std::arch::x86_64::*;

    /// Two vectors of first and second numbers, in the order a … h, from registers with the pairs a, b, e, f and c, d, g, h.
    #[inline(always)]
    unsafe fn parted_8(abef: __m256, cdgh: __m256) -> [Eight; 2] {
        // SAFETY: the processor supports these instructions.
        unsafe {
            let first = _mm256_shuffle_ps::<0b10_00_10_00>(abef, cdgh);
            let second = _mm256_shuffle_ps::<0b11_01_11_01>(abef, cdgh);
            [Eight(first), Eight(second)]
        }
    }

    impl Pairs for Eight {
        #[inline(always)]
        unsafe fn load_pairs(from: *const [f32; 2]) -> [Self; 2] {
            // SAFETY: the caller guarantees that the pairs are readable; the processor supports these instructions.
            unsafe {
                let abcd = _mm256_loadu_ps(from.cast());
                let efgh = _mm256_loadu_ps(from.add(4).cast());
                parted_8(
                    _mm256_permute2f128_ps::<0x20>(abcd, efgh),
                    _mm256_permute2f128_ps::<0x31>(abcd, efgh),
                )
            }
        }

        #[inline(always)]
        unsafe fn store_pairs([first, second]: [Self; 2], to: *mut [f32; 2]) {
            // SAFETY: the caller guarantees that the pairs are writable; the processor supports these instructions.
            unsafe {
                let abef = _mm256_unpacklo_ps(first.0, second.0);
                let cdgh = _mm256_unpackhi_ps(first.0, second.0);
                _mm256_storeu_ps(to.cast(), _mm256_permute2f128_ps::<0x20>(abef, cdgh));
                _mm256_storeu_ps(to.add(4).cast(), _mm256_permute2f128_ps::<0x31>(abef, cdgh));
            }
        }

        #[inline(always)]
        unsafe fn gather_pairs(from: *const [f32; 2], at: *const u32) -> [Self; 2] {
            // SAFETY: the caller guarantees that the indices are readable, and so are the pairs there; the processor supports
            // these instructions. Loads of single pairs are faster than the gathers of many processors with AVX2.
            unsafe {
                let pair = |i: usize| from.add(*at.add(i) as usize).cast::<f64>();
                let two = |i: usize, j: usize| _mm_castpd_ps(_mm_loadh_pd(_mm_load_sd(pair(i)), pair(j)));
                let (ab, cd, ef, gh) = (two(0, 1), two(2, 3), two(4, 5), two(6, 7));
                parted_8(_mm256_set_m128(ef, ab), _mm256_set_m128(gh, cd))
            }
        }
    }

    /// Sixteen pairs, eight a register, as two vectors of first and second numbers.
    #[inline(always)]
    unsafe fn parted_16(low: __m512, high: __m512) -> [Sixteen; 2] {
        // SAFETY: the processor supports these instructions.
        unsafe {
            let even = _mm512_set_epi32(30, 28, 26, 24, 22, 20, 18, 16, 14, 12, 10, 8, 6, 4, 2, 0);
            let odd = _mm512_set_epi32(31, 29, 27, 25, 23, 21, 19, 17, 15, 13, 11, 9, 7, 5, 3, 1);
            [
                Sixteen(_mm512_permutex2var_ps(low, even, high)),
                Sixteen(_mm512_permutex2var_ps(low, odd, high)),
            ]
        }
    }

    impl Pairs for Sixteen {
        #[inline(always)]
        unsafe fn load_pairs(from: *const [f32; 2]) -> [Self; 2] {
            // SAFETY: the caller guarantees that the pairs are readable; the processor supports these instructions.
            unsafe { parted_16(_mm512_loadu_ps(from.cast()), _mm512_loadu_ps(from.add(8).cast())) }
        }

        #[inline(always)]
        unsafe fn store_pairs([first, second]: [Self; 2], to: *mut [f32; 2]) {
            // SAFETY: the caller guarantees that the pairs are writable; the processor supports these instructions.
            unsafe {
                let low = _mm512_set_epi32(23, 7, 22, 6, 21, 5, 20, 4, 19, 3, 18, 2, 17, 1, 16, 0);
                let high = _mm512_set_epi32(31, 15, 30, 14, 29, 13, 28, 12, 27, 11, 26, 10, 25, 9, 24, 8);
                _mm512_storeu_ps(to.cast(), _mm512_permutex2var_ps(first.0, low, second.0));
                _mm512_storeu_ps(to.add(8).cast(), _mm512_permutex2var_ps(first.0, high, second.0));
            }
        }

        #[inline(always)]
        unsafe fn gather_pairs(from: *const [f32; 2], at: *const u32) -> [Self; 2] {
            // SAFETY: the caller guarantees that the indices are readable, and so are the pairs there; the processor supports
            // these instructions.
            unsafe {
                let low = _mm512_i32gather_pd::<8>(_mm256_loadu_si256(at.cast()), from.cast());
                let high = _mm512_i32gather_pd::<8>(_mm256_loadu_si256(at.add(8).cast()), from.cast());
                parted_16(_mm512_castpd_ps(low), _mm512_castpd_ps(high))
            }
        }
    }
}
