//! Colours of px in OKLab, in which equal distances look equal.

use palette::{FromColor, LinSrgb, Oklab, Srgb};

/// Linear light (0..1) of each of the 256 values of an sRGB channel.
#[must_use]
pub fn linear_light() -> [f32; 256] {
    std::array::from_fn(|value| Srgb::new(value as u8, 0, 0).into_linear::<f64>().red as f32)
}

/// OKLab (L 0..1, a, b) of linear red, green, blue, 0..1.
#[must_use]
pub fn oklab_of_light([red, green, blue]: [f32; 3]) -> [f32; 3] {
    let lab: Oklab<f32> = Oklab::from_color(LinSrgb::new(red, green, blue));
    [lab.l, lab.a, lab.b]
}

/// The sRGB colour nearest to L, a, b of OKLab; what lies outside of sRGB is clipped channel by channel.
///
/// ```
/// use dapple_engine::colour::{linear_light, oklab_of_light, srgb_of_oklab};
///
/// let light = linear_light();
/// let brown = [120, 70, 30];
/// assert_eq!(srgb_of_oklab(oklab_of_light(brown.map(|channel| light[channel]))), [120, 70, 30]);
/// ```
#[must_use]
pub fn srgb_of_oklab([l, a, b]: [f32; 3]) -> [u8; 3] {
    let light = LinSrgb::from_color(Oklab::new(f64::from(l), f64::from(a), f64::from(b)));
    let clipped =
        LinSrgb::new(light.red.clamp(0.0, 1.0), light.green.clamp(0.0, 1.0), light.blue.clamp(0.0, 1.0));
    let srgb: Srgb<u8> = Srgb::from_linear(clipped);
    [srgb.red, srgb.green, srgb.blue]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_come_back_and_white_and_black_are_at_the_ends() {
        let light = linear_light();
        for colour in [[0, 0, 0], [255; 3], [244, 227, 193], [59, 35, 20], [3, 200, 90]] {
            let lab = oklab_of_light(colour.map(|value: u8| light[usize::from(value)]));
            assert_eq!(srgb_of_oklab(lab), colour);
            let gray = colour[0] == colour[1] && colour[1] == colour[2];
            assert!(!gray || lab[1].abs() < 1e-4 && lab[2].abs() < 1e-4, "{lab:?}");
        }
        assert_eq!(oklab_of_light([0.0; 3])[0], 0.0);
        assert!((oklab_of_light([1.0; 3])[0] - 1.0).abs() < 1e-5);
    }
}
