//! Stripes by the smallest eigenvector, as a peer of those that grow: F. Knöppel, K. Crane, U. Pinkall, P. Schröder, "Stripe patterns on
//! surfaces", ACM Transactions on Graphics 34 (2015).
//!
//! A complex number ψ at each vertex, whose argument is the phase: E = Σ w |ψⱼ − T ψᵢ|² over the edges, where T turns ψᵢ by ω, the phase from
//! vertex i to j along the wanted directions, and takes the conjugate where these point the opposite way. The pattern is cos(arg ψ) of the ψ of
//! length 1 for which E is least.

use dapple_engine::attributes::{Attribute, Attributes};
use dapple_engine::document::{Body, BodySource, Document, Layer, Stroke};
use dapple_engine::grid::Domain;
use dapple_engine::marks::Line;
use dapple_engine::surface::{Stretch, Surface, laplacian};
use dapple_engine::synth::Options;
use dapple_engine::synth::body::{BodyGrowth, BodyPlan, GrownBody};

/// Width of the stripes, px; their wavelength is twice as long.
const WIDTH: f64 = 10.0;
/// Rounds of inverse iteration, and most steps of conjugate gradients in each.
const ROUNDS: [usize; 2] = [12, 400];
/// The smallest residual that counts, as a share of the right side.
const LEFT: f64 = 1e-5;
/// Added to the diagonal, as a share: the energy of one constant phase may be 0.
const SHIFT: f64 = 1e-6;

type Complex = [f64; 2];

/// What ψ becomes from one vertex to the next.
struct Link {
    to: usize,
    weight: f64,
    /// exp(iω).
    turn: Complex,
    /// Whether the conjugate is taken.
    is_opposite: bool,
}

impl Link {
    fn carried(&self, [a, b]: Complex) -> Complex {
        let [c, s] = self.turn;
        let [x, y] = [c * a - s * b, s * a + c * b];
        if self.is_opposite { [x, -y] } else { [x, y] }
    }
}

/// Prints width, wavelength and direction of grown stripes and of those by the eigenvector, on a torus and on the animal.
pub fn table(seeds: u64) -> Result<(), String> {
    crate::say("| body | stripes | width | wavelength | direction, rms |")?;
    crate::say("|---|---|---|---|---|")?;
    for (name, px) in [("torus", 320.0), ("animal", 520.0)] {
        for seed in 1..=seeds {
            let grown = grown(name, px, seed)?;
            row(name, &format!("grown, seed {seed}"), &grown)?;
        }
        let mut peer = grown(name, px, 1)?;
        let layer = peer.layers.remove(0);
        let pattern = pattern(&layer.plan);
        peer.layers.push(layer.with_pattern(pattern));
        row(name, "smallest eigenvector", &peer)?;
    }
    Ok(())
}

fn grown(name: &'static str, px: f64, seed: u64) -> Result<GrownBody, String> {
    let line = |i: i32| {
        let x = 20.0 + 2.0 * WIDTH * f64::from(i);
        Stroke::from(Line { from: [x, 20.0], to: [x, 140.0], width: WIDTH })
    };
    let model = Some(Body { px, ..Body::new(BodySource::BuiltIn(name)) });
    let document =
        Document { model, seed, ..Document::new([220, 160]) }.with_layer(Layer::new((0..8).map(line)));
    let growth = BodyGrowth::begin(&document, None, &Options::default());
    growth.map_err(|error| error.to_string())?.run().map_err(|error| error.to_string())
}

fn row(body: &str, what: &str, grown: &GrownBody) -> Result<(), String> {
    let report = grown.report(body, 0.0);
    let region = &report.layers[0].regions[0];
    let error = |attribute: Attribute| 100.0 * region.error.get(&attribute).copied().unwrap_or(f64::NAN);
    let rms = region.direction.as_ref().map_or(f64::NAN, |direction| direction.rms);
    let (width, wavelength) = (error(Attribute::Width), error(Attribute::Wavelength));
    crate::say(&format!("| {body} | {what} | {width:+.2} % | {wavelength:+.2} % | {rms:.1}° |"))
}

/// ½ + ½·cos(arg ψ) by vertex.
fn pattern(plan: &BodyPlan) -> Vec<f32> {
    let surface = plan.surface();
    let links = links(plan, surface);
    let mass: Vec<f64> = (0..surface.cells()).map(|vertex| surface.area(vertex)).collect();
    // Any start that has a part of the eigenvector.
    let mut psi: Vec<Complex> = (0..surface.cells())
        .map(|vertex| {
            let phase = 2.4 * vertex as f64;
            [phase.cos(), phase.sin()]
        })
        .collect();
    for _ in 0..ROUNDS[0] {
        let right: Vec<Complex> =
            psi.iter().zip(&mass).map(|(psi, mass)| psi.map(|part| part * mass)).collect();
        psi = solved(&links, &right, psi);
        let norm = psi.iter().zip(&mass).map(|([a, b], mass)| mass * (a * a + b * b)).sum::<f64>().sqrt();
        psi.iter_mut().for_each(|psi| *psi = psi.map(|part| part / norm));
    }
    psi.iter()
        .map(|[a, b]| {
            let length = a.hypot(*b);
            if length > 0.0 { (0.5 + 0.5 * a / length) as f32 } else { 0.5 }
        })
        .collect()
}

/// The links of each vertex.
fn links(plan: &BodyPlan, surface: &Surface) -> Vec<Vec<Link>> {
    let mesh = &surface.mesh;
    let operator = laplacian(mesh, surface.frames(), &vec![Stretch::NONE; mesh.positions.len()]);
    // Across the stripes, degrees in the frame of the vertex, and the wave number, 1/px.
    let wanted = |vertex: usize| match &plan.wanted[vertex] {
        Attributes::Stripes(stripes) => {
            let wavelength = stripes.wavelength.unwrap_or(2.0 * stripes.width);
            (stripes.angle + 90.0, std::f64::consts::TAU / wavelength)
        }
        Attributes::Spots(_) => (0.0, 0.0),
    };
    let of_vertex = |from: usize| {
        let (own, number) = wanted(from);
        let link = |entry: usize| {
            let to = operator.columns[entry] as usize;
            let way = surface
                .displacement(surface.place_of(from), surface.place_of(to))
                .map(|part| part * surface.unit());
            let (other, also) = wanted(to);
            let other = other + surface.transport_angle(to, from);
            let is_opposite = (own - other).to_radians().cos() < 0.0;
            let along = |degrees: f64| {
                let (s, c) = degrees.to_radians().sin_cos();
                c * way[0] + s * way[1]
            };
            let sign = if is_opposite { -1.0 } else { 1.0 };
            let (s, c) = (0.5 * (number * along(own) + sign * also * along(other))).sin_cos();
            Link { to, weight: operator.weights[entry], turn: [c, s], is_opposite }
        };
        (operator.starts[from] as usize..operator.starts[from + 1] as usize).map(link).collect()
    };
    (0..surface.cells()).map(of_vertex).collect()
}

/// The solution of (A + shift) x = right from a first guess, A the matrix of the energy: conjugate gradients.
fn solved(links: &[Vec<Link>], right: &[Complex], mut x: Vec<Complex>) -> Vec<Complex> {
    let diagonal: Vec<f64> =
        links.iter().map(|links| (1.0 + SHIFT) * links.iter().map(|link| link.weight).sum::<f64>()).collect();
    let product = |x: &[Complex]| -> Vec<Complex> {
        let mut out: Vec<Complex> =
            x.iter().zip(&diagonal).map(|(x, diagonal)| x.map(|part| part * diagonal)).collect();
        for (from, links) in links.iter().enumerate() {
            for link in links {
                let [a, b] = link.carried(x[from]);
                out[link.to][0] -= link.weight * a;
                out[link.to][1] -= link.weight * b;
            }
        }
        out
    };
    let dot =
        |a: &[Complex], b: &[Complex]| a.iter().zip(b).map(|(a, b)| a[0] * b[0] + a[1] * b[1]).sum::<f64>();
    let scaled = |rest: &[Complex]| -> Vec<Complex> {
        rest.iter().zip(&diagonal).map(|(rest, diagonal)| rest.map(|part| part / diagonal)).collect()
    };
    let image = product(&x);
    let mut rest: Vec<Complex> = right.iter().zip(&image).map(|(b, a)| [b[0] - a[0], b[1] - a[1]]).collect();
    let enough = LEFT * LEFT * dot(right, right);
    let mut step = scaled(&rest);
    let mut way = step.clone();
    let mut size = dot(&rest, &step);
    for _ in 0..ROUNDS[1] {
        if dot(&rest, &rest) <= enough {
            break;
        }
        let image = product(&way);
        let far = size / dot(&way, &image);
        for row in 0..x.len() {
            for k in 0..2 {
                x[row][k] += far * way[row][k];
                rest[row][k] -= far * image[row][k];
            }
        }
        step = scaled(&rest);
        let next = dot(&rest, &step);
        way.iter_mut()
            .zip(&step)
            .for_each(|(way, step)| *way = [0, 1].map(|k| step[k] + next / size * way[k]));
        size = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_eigenvector_makes_stripes_of_the_wanted_wavelength_and_direction() {
        let mut grown = grown("torus", 130.0, 1).expect("it grows");
        let layer = grown.layers.remove(0);
        let pattern = pattern(&layer.plan);
        grown.layers.push(layer.with_pattern(pattern));
        let report = grown.report("torus", 0.0);
        let region = &report.layers[0].regions[0];
        assert!(region.error[&Attribute::Wavelength].abs() < 0.06, "{:?}", region.error);
        assert!(region.direction.as_ref().expect("directions").rms < 12.0);
    }
}
