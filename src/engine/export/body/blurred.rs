//! Colours by vertex, blurred more and more, for models that are seen from far away.
//!
//! Turk (1991), section 6: colours diffuse over the surface until patterns finer than a px are gone. A blur of standard deviation σ
//! is a diffusion of the time σ²/2; σ doubles from level to level.

use rayon::prelude::*;

use crate::surface::{Laplacian, Stretch, Surface, laplacian};

/// The standard deviation of the first level, mean sides of a cell.
const FIRST: f64 = 0.5;
/// Steps of a level; each is implicit, so that its length is free.
const STEPS: usize = 3;
/// How small the rest of an equation is to be, as a share of its right side.
const ACCURACY: f64 = 1e-4;
/// The most iterations of a step.
const ITERATIONS: usize = 400;

/// Colours, linear light, of the vertices of a mesh at several levels of blur.
#[derive(Clone, Debug)]
pub struct Blurred {
    /// The standard deviation of the first level, in units of the mesh.
    first: f64,
    /// By level and vertex.
    levels: Vec<Vec<[f32; 3]>>,
}

impl Blurred {
    /// The levels of the colours of a surface's vertices, up to the standard deviation `most`, in its units.
    #[must_use]
    pub fn new(surface: &Surface, colours: &[[f32; 3]], most: f64) -> Self {
        let mesh = &surface.mesh;
        let operator = laplacian(mesh, surface.frames(), &vec![Stretch::NONE; mesh.positions.len()]);
        let first = FIRST * surface.unit();
        let mut channels = [0, 1, 2].map(|i| colours.iter().map(|c| f64::from(c[i])).collect::<Vec<f64>>());
        let (mut levels, mut before, mut next) = (Vec::new(), 0.0, first);
        loop {
            let time = 0.5 * (next * next - before * before) / STEPS as f64;
            channels.par_iter_mut().for_each(|values| {
                (0..STEPS).for_each(|_| diffuse(&operator, values, time));
            });
            levels.push((0..colours.len()).map(|i| [0, 1, 2].map(|c| channels[c][i] as f32)).collect());
            if next >= most {
                return Self { first, levels };
            }
            (before, next) = (next, 2.0 * next);
        }
    }

    /// The colour of a triangle's vertices with a blur of this standard deviation, mixed by the shares of the corners.
    #[must_use]
    pub fn at(&self, vertices: [usize; 3], shares: [f64; 3], deviation: f64) -> [f32; 3] {
        let level = libm::log2((deviation / self.first).max(1.0)).min((self.levels.len() - 1) as f64);
        let (low, share) = (level as usize, level - level.floor());
        let of_level = |level: usize, channel: usize| {
            let colours = &self.levels[level.min(self.levels.len() - 1)];
            (0..3).map(|at| shares[at] * f64::from(colours[vertices[at]][channel])).sum::<f64>()
        };
        [0, 1, 2].map(|channel| {
            let (near, far) = (of_level(low, channel), of_level(low + 1, channel));
            (near + share * (far - near)) as f32
        })
    }
}

/// Values after a time of diffusion: (M + t·L) u = M u₀ by conjugate gradients, M the areas of the vertices.
fn diffuse(operator: &Laplacian, values: &mut [f64], time: f64) {
    let Laplacian { starts, columns, weights, mass } = operator;
    let row = |row: usize| starts[row] as usize..starts[row + 1] as usize;
    let diagonal: Vec<f64> =
        (0..mass.len()).map(|at| mass[at] + time * weights[row(at)].iter().sum::<f64>()).collect();
    let apply = |from: &[f64], to: &mut [f64]| {
        for (at, to) in to.iter_mut().enumerate() {
            let off: f64 = row(at).map(|entry| weights[entry] * from[columns[entry] as usize]).sum();
            *to = diagonal[at] * from[at] - time * off;
        }
    };
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let right: Vec<f64> = values.iter().zip(mass).map(|(value, mass)| value * mass).collect();
    let enough = ACCURACY * ACCURACY * dot(&right, &right);
    let mut image = vec![0.0; values.len()];
    apply(values, &mut image);
    let mut rest: Vec<f64> = right.iter().zip(&image).map(|(right, image)| right - image).collect();
    let mut scaled: Vec<f64> = rest.iter().zip(&diagonal).map(|(rest, d)| rest / d).collect();
    let mut way = scaled.clone();
    let mut product = dot(&rest, &scaled);
    for _ in 0..ITERATIONS {
        if dot(&rest, &rest) <= enough {
            return;
        }
        apply(&way, &mut image);
        let step = product / dot(&way, &image);
        values.iter_mut().zip(&way).for_each(|(value, way)| *value += step * way);
        rest.iter_mut().zip(&image).for_each(|(rest, image)| *rest -= step * image);
        scaled.iter_mut().zip(&rest).zip(&diagonal).for_each(|((scaled, rest), d)| *scaled = rest / d);
        let next = dot(&rest, &scaled);
        way.iter_mut().zip(&scaled).for_each(|(way, scaled)| *way = scaled + next / product * *way);
        product = next;
    }
}

/// The standard deviation of the blur of a px, sides of the px.
pub const OF_A_PX: f64 = 0.3;
/// The length of a px, cells, from which on a surface is blurred: a pattern has about twelve cells a spacing, and 16 samples a px see
/// what is coarser.
const FAR: f64 = 4.0;

/// Whether a px that is so long on a surface needs a blur.
#[must_use]
pub fn is_far(surface: &Surface, px: f64) -> bool {
    px > FAR * surface.unit()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::body::{Paint, Painted, View, draw, length_of_px, normals};
    use crate::export::downscale;
    use crate::surface::test_meshes::{even_plate, sphere};

    #[test]
    fn waves_fade_as_a_blur_of_the_standard_deviation_makes_them() {
        // A wave of length l fades by exp(−2π²σ²/l²).
        let side = 60.0;
        let surface = Surface::new(even_plate([side; 2], 1.0), [1.0, 0.0, 0.0]);
        let wave = |x: f64| 0.5 + 0.5 * libm::cos(std::f64::consts::TAU * x / 20.0);
        let colours: Vec<[f32; 3]> =
            surface.mesh.positions.iter().map(|at| [wave(at[0]) as f32; 3]).collect();
        let blurred = Blurred::new(&surface, &colours, 8.0);
        for (level, values) in blurred.levels.iter().enumerate() {
            let deviation = 0.5 * surface.unit() * f64::from(1 << level);
            let inside = surface.mesh.positions.iter().zip(values);
            let inside =
                inside.filter(|(at, _)| (15.0..45.0).contains(&at[0]) && (15.0..45.0).contains(&at[1]));
            let [mut kept, mut whole] = [0.0; 2];
            for (at, value) in inside {
                kept += (f64::from(value[0]) - 0.5) * (wave(at[0]) - 0.5);
                whole += (wave(at[0]) - 0.5) * (wave(at[0]) - 0.5);
            }
            let x = std::f64::consts::TAU * deviation / 20.0;
            let expected = libm::exp(-0.5 * x * x);
            assert!((kept / whole - expected).abs() < 0.06, "level {level}: {} {expected}", kept / whole);
        }
    }

    /// A ball with stripes from pole to pole, seen from sides a degree apart.
    struct Ball {
        surface: Surface,
        values: Vec<f32>,
    }

    impl Ball {
        const RADIUS: f64 = 100.0;

        /// With so many stripes around its equator.
        fn new(stripes: f64) -> Self {
            let surface = Surface::new(sphere(36, Self::RADIUS), [0.0, 1.0, 0.0]);
            let wave = |at: &[f64; 3]| {
                0.5 + 0.5 * libm::sin(stripes * libm::atan2(at[2], at[0]) + 9.0 * at[1] / 100.0)
            };
            let values = surface.mesh.positions.iter().map(|at| wave(at) as f32).collect();
            Self { surface, values }
        }

        fn picture(&self, paint: Paint, side: u32, azimuth: f64) -> Vec<u8> {
            let normals = normals(&self.surface.mesh);
            let part = Painted { mesh: &self.surface.mesh, normals: &normals, paint };
            let view = View { turns: true, shadow: false, ..View::new(azimuth, 0.0, [side; 2]) };
            draw(&[part], &view).rgb()
        }
    }

    /// The mean difference between each picture and the next.
    fn change(pictures: &[Vec<u8>]) -> f64 {
        let differences = pictures.windows(2).map(|pair| difference(&pair[0], &pair[1]));
        differences.sum::<f64>() / (pictures.len() - 1) as f64
    }

    fn difference(a: &[u8], b: &[u8]) -> f64 {
        a.iter().zip(b).map(|(a, b)| (f64::from(*a) - f64::from(*b)).abs()).sum::<f64>() / a.len() as f64
    }

    #[test]
    fn a_model_that_turns_far_away_does_not_shimmer() {
        let gray = |values: &[f32]| [values[0]; 3];
        // Stripes of 2.6, 1.6 and 1.1 px (a dark and a light one) at the equator of a ball about 27 px wide.
        for stripes in [32.0, 54.0, 80.0] {
            let ball = Ball::new(stripes);
            let colours: Vec<[f32; 3]> = ball.values.iter().map(|value| [*value; 3]).collect();
            let px = length_of_px(
                &View { turns: true, ..View::new(0.0, 0.0, [32; 2]) },
                &ball.surface.mesh.positions,
            );
            let blurred = Blurred::new(&ball.surface, &colours, 4.0 * px);
            let fields = [ball.values.as_slice()];
            let sharp = Paint::Pattern { fields: &fields, colour: &gray };
            let pictures = |paint: Paint, side: u32| -> Vec<Vec<u8>> {
                (0..8).map(|degrees| ball.picture(paint, side, f64::from(degrees))).collect()
            };
            let (soft, sampled) = (pictures(Paint::Blurred(&blurred), 32), pictures(sharp, 32));
            let exact: Vec<Vec<u8>> = (0..8)
                .map(|degrees| downscale(&ball.picture(sharp, 128, f64::from(degrees)), [128; 2], [32; 2]))
                .collect();
            let away = |pictures: &[Vec<u8>]| {
                pictures.iter().zip(&exact).map(|(a, b)| difference(a, b)).sum::<f64>() / 8.0
            };
            let [changes, sampled_changes] = [change(&soft), change(&sampled)];
            println!(
                "{stripes} stripes, px {:.1} cells: change {changes:.2}, 4 × 4 samples {sampled_changes:.2}, exact {:.2}; away from exact {:.2} and {:.2}",
                px / ball.surface.unit(),
                change(&exact),
                away(&soft),
                away(&sampled)
            );
            assert!(changes <= 1.2 * sampled_changes, "{stripes}: {changes} {sampled_changes}");
            assert!(away(&soft) <= 1.2 * away(&sampled) + 0.5, "{stripes}");
        }
    }
}
