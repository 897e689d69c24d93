use super::*;
use crate::grid::Edges;
use crate::measure::{otsu_threshold, picture};

/// A picture of 256 × 256 px.
fn painted(tone: impl FnMut([f64; 2]) -> f32) -> Field {
    Field::from_fn([256, 256], [1.0, 1.0], Edges::Closed, tone)
}

/// The verdict on a picture in which marks can be measured.
fn judged(field: &Field) -> Option<NotTexture> {
    let level = otsu_threshold(&field.values);
    let found = picture(field, level).expect("something is measured");
    check_picture(field, level, &found).err()
}

/// 1 inside of an edge, 0 outside, over 2 px.
fn ink(inside: f64) -> f32 {
    (0.5 + 0.5 * inside).clamp(0.0, 1.0) as f32
}

/// The distance to the next place of a lattice of this step.
fn to_lattice([x, y]: [f64; 2], step: f64) -> f64 {
    let near = |x: f64| x.rem_euclid(step) - 0.5 * step;
    near(x).hypot(near(y))
}

/// Sums of waves of random directions and phases: `waves` of each wavelength, with this amplitude.
fn waves(wavelengths: &[(f64, f64)], waves: u32) -> Field {
    let mut state = 7_u32;
    let mut random = || {
        state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        f64::from(state >> 8) / f64::from(1 << 24) * std::f64::consts::TAU
    };
    let mut all = Vec::new();
    for (wavelength, amplitude) in wavelengths {
        for _ in 0..waves {
            let (way, phase) = (random(), random());
            let k = std::f64::consts::TAU / wavelength;
            all.push(([k * way.cos(), k * way.sin()], phase, *amplitude));
        }
    }
    let whole: f64 = all.iter().map(|wave| wave.2).sum::<f64>() / f64::from(waves).sqrt();
    painted(|[x, y]| {
        let sum: f64 = all.iter().map(|([kx, ky], phase, high)| high * (kx * x + ky * y + phase).sin()).sum();
        (0.5 + 0.15 * sum / whole).clamp(0.0, 1.0) as f32
    })
}

#[test]
fn spots_and_stripes_are_textures_also_few_or_sparse_ones() {
    for (radius, step) in [(8.0, 26.0), (4.0, 60.0), (20.0, 80.0), (2.5, 11.0)] {
        let spots = painted(|at| ink(radius - to_lattice(at, step)));
        assert_eq!(judged(&spots), None, "{radius} {step}");
    }
    for (width, period) in [(5.0, 10.0), (4.0, 20.0), (20.0, 60.0)] {
        let stripes = painted(|[x, y]| {
            let across = 0.8 * x + 0.6 * y;
            ink(0.5 * width - (across.rem_euclid(period) - 0.5 * period).abs())
        });
        assert_eq!(judged(&stripes), None, "{width} {period}");
    }
}

#[test]
fn soft_stripes_that_bend_and_change_their_width_are_a_texture() {
    let rings = painted(|[x, y]| {
        let out = (x + 60.0).hypot(y - 128.0);
        (0.5 + 0.45 * (out * 0.5 + out * out * 0.0008).sin()) as f32
    });
    assert_eq!(judged(&rings), None);
}

#[test]
fn two_discs_are_too_few_spots() {
    let pair = painted(|[x, y]| ink(40.0 - (x - 70.0).hypot(y - 128.0).min((x - 180.0).hypot(y - 128.0))));
    assert_eq!(judged(&pair), Some(NotTexture::TooFewSpots { marks: 2 }));
}

#[test]
fn a_chessboard_is_no_texture() {
    for side in [16, 23, 32] {
        let board = painted(|[x, y]| f32::from(((x as u32 / side + y as u32 / side) % 2) as u8));
        let said = judged(&board);
        assert!(
            matches!(said, Some(NotTexture::BrokenGround { .. } | NotTexture::NoDirection { .. })),
            "{side} {said:?}"
        );
    }
}

#[test]
fn noise_of_all_wavelengths_is_no_texture() {
    let noise = waves(&[(160.0, 1.0), (80.0, 0.7), (40.0, 0.5)], 12);
    let said = judged(&noise);
    assert!(matches!(said, Some(NotTexture::Contrast { .. } | NotTexture::NoDirection { .. })), "{said:?}");
}

#[test]
fn soft_shadows_with_sharp_edges_here_and_there_are_no_texture() {
    // Soft shades, and bars and a disc that are sharp where they differ from them, as in a photograph.
    let photo = painted(|[x, y]| {
        let shade = 0.5 + 0.3 * (x / 40.0).sin() * (y / 50.0).cos();
        let rod = |at: f64| f64::from(ink(8.0 - (0.6 * x - 0.8 * y + at).abs()));
        let disc = f64::from(ink(35.0 - (x - 190.0).hypot(y - 190.0)));
        (shade + 0.3 * rod(60.0) - 0.25 * rod(-40.0) - 0.3 * disc).clamp(0.0, 1.0) as f32
    });
    let said = judged(&photo);
    assert!(matches!(said, Some(NotTexture::Contrast { .. })), "{said:?}");
}

#[test]
fn a_web_around_spots_is_a_texture() {
    let web = painted(|at| ink(to_lattice(at, 30.0) - 12.0));
    assert_eq!(judged(&web), None);
}

#[test]
fn a_silhouette_is_too_few_stripes() {
    // A bent bar with legs, as the silhouette of an animal.
    let beast = painted(|[x, y]| {
        let body = 25.0 - (y - 90.0 - 20.0 * (x / 60.0).sin()).abs();
        let legs = [60.0, 110.0, 170.0].map(|leg| (9.0 - (x - leg).abs()).min(60.0 - (y - 140.0).abs()));
        ink(legs.into_iter().fold(body.min(105.0 - (x - 120.0).abs()), f64::max))
    });
    let said = judged(&beast);
    assert!(
        matches!(said, Some(NotTexture::TooFewStripes { .. } | NotTexture::TooFewSpots { .. })),
        "{said:?}"
    );
}
