//! Scalars and processor vectors behind one trait. A formula written for [`Number`] gives the same bits for each of them:
//! every operation is rounded separately, none are fused.

use std::ops::{Add, Div, Mul, Sub};

/// The number type of the formulas of kinetics and diffusion.
pub trait Number:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// One value in all lanes.
    #[must_use]
    fn splat(value: f32) -> Self;

    /// The larger of both; `self` where they are equal or one is NaN.
    #[must_use]
    fn larger(self, other: Self) -> Self;

    /// The smaller of both; `self` where they are equal or one is NaN.
    #[must_use]
    fn smaller(self, other: Self) -> Self;

    /// The absolute value.
    #[must_use]
    fn absolute(self) -> Self;

    /// A soft step at `threshold`: 0 at `half_width` below it, 1 at `half_width` above it, linear between.
    #[must_use]
    #[inline(always)]
    fn soft_step(self, threshold: Self, half_width: Self) -> Self {
        let rise = Self::splat(0.5) + (self - threshold) / (half_width + half_width);
        rise.smaller(Self::splat(1.0)).larger(Self::splat(0.0))
    }

    /// `least` where the value is below it; otherwise the value, also NaN.
    #[must_use]
    fn at_least(self, least: f32) -> Self;
}

impl Number for f32 {
    #[inline(always)]
    fn splat(value: f32) -> Self {
        value
    }

    #[inline(always)]
    fn at_least(self, least: f32) -> Self {
        if self < least { least } else { self }
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        if other < self { other } else { self }
    }

    #[inline(always)]
    fn absolute(self) -> Self {
        self.abs()
    }
}

/// Several numbers side by side.
pub trait Vector: Number {
    /// Number of lanes.
    const WIDTH: usize;

    /// Loads the numbers at `from`, which need not be aligned.
    ///
    /// # Safety
    /// `WIDTH` numbers must be readable there.
    unsafe fn load(from: *const f32) -> Self;

    /// Stores the numbers at `to`, which need not be aligned.
    ///
    /// # Safety
    /// `WIDTH` numbers must be writable there.
    unsafe fn store(self, to: *mut f32);

    /// In each lane, `self` where a < b and `other` elsewhere.
    #[must_use]
    fn where_less(self, a: Self, b: Self, other: Self) -> Self;
}

/// Four numbers in a form that compilers turn into one vector.
#[derive(Clone, Copy)]
pub struct Four([f32; 4]);

impl Number for Four {
    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self([value; 4])
    }

    #[inline(always)]
    fn at_least(self, least: f32) -> Self {
        let mut lanes = self.0;
        for lane in &mut lanes {
            *lane = lane.at_least(least);
        }
        Self(lanes)
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        Self([a.larger(e), b.larger(f), c.larger(g), d.larger(h)])
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        Self([a.smaller(e), b.smaller(f), c.smaller(g), d.smaller(h)])
    }

    #[inline(always)]
    fn absolute(self) -> Self {
        Self(self.0.map(f32::absolute))
    }
}

impl Vector for Four {
    const WIDTH: usize = 4;

    #[inline(always)]
    unsafe fn load(from: *const f32) -> Self {
        // SAFETY: the caller guarantees that the numbers are readable.
        Self(unsafe { from.cast::<[f32; 4]>().read_unaligned() })
    }

    #[inline(always)]
    unsafe fn store(self, to: *mut f32) {
        // SAFETY: the caller guarantees that the numbers are writable.
        unsafe { to.cast::<[f32; 4]>().write_unaligned(self.0) }
    }

    #[inline(always)]
    fn where_less(self, a: Self, b: Self, other: Self) -> Self {
        let mut lanes = other.0;
        for (i, lane) in lanes.iter_mut().enumerate() {
            if a.0[i] < b.0[i] {
                *lane = self.0[i];
            }
        }
        Self(lanes)
    }
}

macro_rules! four {
    ($($operation:ident $method:ident $sign:tt),*) => {$(
        impl $operation for Four {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
                Self([a $sign e, b $sign f, c $sign g, d $sign h])
            }
        }
    )*};
}
four!(Add add +, Sub sub -, Mul mul *, Div div /);

#[cfg(target_arch = "x86_64")]
mod x86 {
    use super::{Add, Div, Mul, Number, Sub, Vector};
    use std::arch::x86_64::*;

    /// A register of AVX2 or AVX-512. It is created only inside functions compiled for such processors, which
    /// [`super::super::wavefront`] calls only on them; every `unsafe` below relies on this.
    macro_rules! register {
        ($name:ident, $register:ty, $width:literal, $splat:ident, $load:ident, $store:ident, $max:ident,
         $min:ident, $absolute:ident, $less:ident, $($operation:ident $method:ident $intrinsic:ident),*) => {
            #[doc = concat!(stringify!($width), " numbers.")]
            #[derive(Clone, Copy)]
            pub struct $name(pub(super) $register);

            impl Number for $name {
                #[inline(always)]
                fn splat(value: f32) -> Self {
                    // SAFETY: the processor supports these instructions.
                    Self(unsafe { $splat(value) })
                }

                #[inline(always)]
                fn at_least(self, least: f32) -> Self {
                    // The instruction returns the second operand where neither is greater, and where one is NaN.
                    // SAFETY: the processor supports these instructions.
                    Self(unsafe { $max($splat(least), self.0) })
                }

                #[inline(always)]
                fn larger(self, other: Self) -> Self {
                    // As for `at_least`: `self` is returned where neither is greater.
                    // SAFETY: the processor supports these instructions.
                    Self(unsafe { $max(other.0, self.0) })
                }

                #[inline(always)]
                fn smaller(self, other: Self) -> Self {
                    // SAFETY: the processor supports these instructions.
                    Self(unsafe { $min(other.0, self.0) })
                }

                #[inline(always)]
                fn absolute(self) -> Self {
                    // SAFETY: the processor supports these instructions.
                    Self(unsafe { $absolute(self.0) })
                }
            }

            impl Vector for $name {
                const WIDTH: usize = $width;

                #[inline(always)]
                unsafe fn load(from: *const f32) -> Self {
                    // SAFETY: the caller guarantees that the numbers are readable.
                    Self(unsafe { $load(from) })
                }

                #[inline(always)]
                unsafe fn store(self, to: *mut f32) {
                    // SAFETY: the caller guarantees that the numbers are writable.
                    unsafe { $store(to, self.0) }
                }

                #[inline(always)]
                fn where_less(self, a: Self, b: Self, other: Self) -> Self {
                    // SAFETY: the processor supports these instructions.
                    Self(unsafe { $less(self.0, a.0, b.0, other.0) })
                }
            }

            $(impl $operation for $name {
                type Output = Self;
                #[inline(always)]
                fn $method(self, other: Self) -> Self {
                    // SAFETY: the processor supports these instructions.
                    Self(unsafe { $intrinsic(self.0, other.0) })
                }
            })*
        };
    }

    #[inline(always)]
    unsafe fn absolute_of_8(of: __m256) -> __m256 {
        // SAFETY: the processor supports these instructions.
        unsafe { _mm256_andnot_ps(_mm256_set1_ps(-0.0), of) }
    }

    #[inline(always)]
    unsafe fn where_less_of_8(this: __m256, a: __m256, b: __m256, other: __m256) -> __m256 {
        // SAFETY: the processor supports these instructions.
        unsafe { _mm256_blendv_ps(other, this, _mm256_cmp_ps::<_CMP_LT_OQ>(a, b)) }
    }

    #[inline(always)]
    unsafe fn where_less_of_16(this: __m512, a: __m512, b: __m512, other: __m512) -> __m512 {
        // SAFETY: the processor supports these instructions.
        unsafe { _mm512_mask_blend_ps(_mm512_cmp_ps_mask::<_CMP_LT_OQ>(a, b), other, this) }
    }

    register!(
        Eight, __m256, 8, _mm256_set1_ps, _mm256_loadu_ps, _mm256_storeu_ps, _mm256_max_ps,
        _mm256_min_ps, absolute_of_8, where_less_of_8,
        Add add _mm256_add_ps, Sub sub _mm256_sub_ps, Mul mul _mm256_mul_ps, Div div _mm256_div_ps
    );
    register!(
        Sixteen, __m512, 16, _mm512_set1_ps, _mm512_loadu_ps, _mm512_storeu_ps, _mm512_max_ps,
        _mm512_min_ps, _mm512_abs_ps, where_less_of_16,
        Add add _mm512_add_ps, Sub sub _mm512_sub_ps, Mul mul _mm512_mul_ps, Div div _mm512_div_ps
    );
}
#[cfg(target_arch = "x86_64")]
pub use x86::{Eight, Sixteen};

mod pairs;
pub use pairs::Pairs;

#[cfg(test)]
mod tests;
