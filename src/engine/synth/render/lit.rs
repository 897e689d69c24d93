//! A lit view of a material on a plane, a sphere or a cylinder.
//!
//! Each px casts rays at the body. Where one hits, the maps are read at the coordinates of the surface, and the reflection of a
//! directional light and of a sky is computed: by Lambert's law, and by Cook and Torrance's with the distribution of Trowbridge and
//! Reitz (GGX).
//!
//! R. Cook, K. Torrance, "A Reflectance Model for Computer Graphics", SIGGRAPH 1981. B. Walter et al., "Microfacet Models for
//! Refraction through Rough Surfaces", EGSR 2007.

mod body;
mod light;
mod maps;
mod vector;

use rayon::prelude::*;

pub use body::{Body, Pose};
use body::{Turn, cast};
use light::{shade, to_srgb};
use maps::linear_table;
pub use maps::{Maps, Pictures};

/// Half the height of the view, in radii of the sphere.
const REACH: f32 = 1.18;

/// The directions to the right, up and out of a plane that is seen from straight above.
const ABOVE: [[f32; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// A plane of this material seen from straight above, over white: red, green, blue a px, sRGB, row by row.
#[must_use]
pub fn from_above(pictures: &Pictures) -> Vec<u8> {
    let [width, height] = pictures.size;
    let linear = linear_table();
    let mut pixels = vec![0; 3 * width * height];
    pixels.par_chunks_mut((3 * width).max(1)).enumerate().for_each(|(row, line)| {
        for (column, px) in line.chunks_exact_mut(3).enumerate() {
            let texel = pictures.texel(row * width + column, &linear);
            for (out, part) in px.iter_mut().zip(shade(&texel, &ABOVE)) {
                let over_white = 255.0 + texel.opacity * (f32::from(to_srgb(part)) - 255.0);
                *out = over_white.round() as u8;
            }
        }
    });
    pixels
}

/// The body seen in a square of `side` px: red, green, blue, opacity a px, sRGB, row by row. Each px is the mean of `samples` ×
/// `samples` rays.
#[must_use]
pub fn render(maps: &Maps, body: Body, pose: Pose, side: usize, samples: usize) -> Vec<u8> {
    let turn = Turn::new(pose);
    let reach = REACH / pose.zoom;
    let mut pixels = vec![0; 4 * side * side];
    let samples = samples.max(1);
    pixels.par_chunks_mut((4 * side).max(1)).enumerate().for_each(|(row, line)| {
        for (column, px) in line.chunks_exact_mut(4).enumerate() {
            let mut sum = [0.0f32; 4];
            for sample in 0..samples * samples {
                let within = |index: usize| (index as f32 + 0.5) / samples as f32;
                let x = (column as f32 + within(sample % samples)) / side as f32 * 2.0 - 1.0;
                let y = 1.0 - (row as f32 + within(sample / samples)) / side as f32 * 2.0;
                let Some(hit) = cast(maps, body, &turn, [reach * x, reach * y]) else { continue };
                let texel = maps.at(hit.uv);
                let light = shade(&texel, &hit.frame);
                for (sum, part) in sum.iter_mut().zip(light) {
                    *sum += part * texel.opacity;
                }
                sum[3] += texel.opacity;
            }
            let opacity = sum[3] / (samples * samples) as f32;
            for (out, part) in px.iter_mut().zip(&sum[..3]) {
                *out = to_srgb(part / sum[3].max(1e-6));
            }
            px[3] = (255.0 * opacity).round() as u8;
        }
    });
    pixels
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: usize = 64;

    /// A flat material of one colour; the left half is red where `halves`.
    fn flat(roughness: u8, halves: bool) -> Maps {
        let colour = move |px: usize| {
            if halves && px % 16 < 8 { [200, 0, 0, 255] } else { [120, 120, 120, 255] }
        };
        let pictures = Pictures {
            size: [16, 16],
            colour: &colour,
            normal: &|_| [128, 128, 255],
            roughness: &move |_| roughness,
            occlusion: &|_| 255,
        };
        Maps::new(&pictures, true)
    }

    fn px(pixels: &[u8], x: usize, y: usize) -> [i32; 4] {
        let at = 4 * (y * SIDE + x);
        [0, 1, 2, 3].map(|channel| i32::from(pixels[at + channel]))
    }

    const AHEAD: Pose = Pose { yaw: 0.0, pitch: 0.0, zoom: 1.0 };

    #[test]
    fn a_sphere_is_round_lit_from_the_upper_left_and_dark_on_the_other_side() {
        let seen = render(&flat(255, false), Body::Sphere, AHEAD, SIDE, 2);
        assert_eq!(px(&seen, 1, 1)[3], 0, "beside it there is nothing");
        assert_eq!(px(&seen, 32, 32)[3], 255);
        let [bright, dark] = [px(&seen, 22, 20)[0], px(&seen, 46, 48)[0]];
        assert!(bright > dark + 40, "{bright} {dark}");
    }

    #[test]
    fn the_left_of_the_maps_is_on_the_left_and_turns_with_the_body() {
        let maps = flat(255, true);
        for body in [Body::Plane, Body::Cylinder] {
            let seen = render(&maps, body, AHEAD, SIDE, 1);
            let is_red = |x: usize| px(&seen, x, 32)[0] > 2 * px(&seen, x, 32)[1];
            assert!(is_red(27) != is_red(37), "{body:?}");
        }
        let seen = render(&maps, Body::Plane, AHEAD, SIDE, 1);
        assert!(px(&seen, 20, 32)[0] > 2 * px(&seen, 20, 32)[1]);
        // Turned by 180°, what was on the left is on the right.
        let behind = render(&maps, Body::Plane, Pose { yaw: 180.0, ..AHEAD }, SIDE, 1);
        assert!(px(&behind, 44, 32)[0] > 2 * px(&behind, 44, 32)[1]);
        let edge_on = render(&maps, Body::Plane, Pose { yaw: 90.0, ..AHEAD }, SIDE, 1);
        assert!(edge_on.chunks(4).filter(|px| px[3] > 0).count() < 3 * SIDE, "a plane seen edge-on is thin");
    }

    #[test]
    fn a_zoomed_body_is_larger_up_to_a_limit_and_never_smaller_than_the_view() {
        let width = |pose: Pose| {
            let seen = render(&flat(255, false), Body::Plane, pose, SIDE, 1);
            (0..SIDE).filter(|x| px(&seen, *x, 32)[3] > 0).count()
        };
        assert!(width(AHEAD) < 56 && width(AHEAD.zoomed(1.5)) == SIDE, "{}", width(AHEAD));
        assert_eq!(AHEAD.zoomed(0.5), AHEAD);
        assert_eq!(AHEAD.zoomed(100.0).zoom, 8.0);
    }

    #[test]
    fn a_smooth_sphere_has_a_highlight_and_a_rough_one_none() {
        let brightest = |roughness: u8| {
            let seen = render(&flat(roughness, false), Body::Sphere, AHEAD, SIDE, 2);
            seen.chunks(4).map(|px| i32::from(px[1])).max().unwrap_or(0)
        };
        assert!(brightest(50) > brightest(255) + 20, "{} {}", brightest(50), brightest(255));
    }

    #[test]
    fn a_slope_towards_the_light_is_brighter_than_one_away_from_it() {
        let slope = |x: u8| {
            let normal = move |_| [x, 128, 220];
            let pictures = Pictures {
                size: [4, 4],
                colour: &|_| [120, 120, 120, 255],
                normal: &normal,
                roughness: &|_| 255,
                occlusion: &|_| 255,
            };
            px(&render(&Maps::new(&pictures, true), Body::Plane, AHEAD, SIDE, 1), 32, 32)[0]
        };
        assert!(slope(60) > slope(196) + 20, "{} {}", slope(60), slope(196));
    }

    #[test]
    fn from_above_slopes_are_as_bright_as_on_a_plane_and_what_is_transparent_is_white() {
        let seen = |x: u8, opacity: u8| {
            let pictures = Pictures {
                size: [3, 2],
                colour: &|_| [120, 90, 60, opacity],
                normal: &|_| [x, 128, 220],
                roughness: &|_| 255,
                occlusion: &|_| 255,
            };
            let plane = render(&Maps::new(&pictures, true), Body::Plane, AHEAD, SIDE, 1);
            (from_above(&pictures), px(&plane, 32, 32))
        };
        for x in [60, 128, 196] {
            let (above, plane) = seen(x, 255);
            assert_eq!(above.len(), 18);
            assert!(
                (0..18).all(|at| (i32::from(above[at]) - plane[at % 3]).abs() <= 1),
                "{above:?} {plane:?}"
            );
        }
        assert_eq!(seen(128, 0).0, [255; 18]);
    }

    #[test]
    fn turning_there_and_back_is_the_identity_and_a_drag_stays_within_limits() {
        let turn = Turn::new(Pose { yaw: 33.0, pitch: -21.0, zoom: 1.0 });
        let back = turn.back(turn.out([0.3, -0.5, 0.8]));
        assert!(back.iter().zip([0.3, -0.5, 0.8]).all(|(a, b)| (a - b).abs() < 1e-6), "{back:?}");
        let far = AHEAD.turned([1000.0, -1000.0]);
        assert!((-180.0..180.0).contains(&far.yaw) && far.pitch == -85.0, "{far:?}");
    }
}
