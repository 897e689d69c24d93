//! The threads of each direction on a surface, as they have grown, against what is wanted at their places.

use crate::attributes::Stripes;
use crate::marks::{axial, turn};
use crate::measure::{surface_directions, surface_stripes};
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::thread_form::ThreadForm;
use crate::synth::body::threads::start::directions_at;
use crate::synth::pattern::EDGE;
use crate::synth::report::{ThreadErrors, ThreadReport};

/// Directions are averaged over this part of the distance of threads.
const AVERAGED: f64 = 0.5;
/// The coherence of the field of directions from which directions count: nearer to where it turns round a place they do not.
const COHERENT: f64 = 0.8;

/// Sums over the vertices of a surface.
#[derive(Default)]
struct Sums {
    area: f64,
    /// Area ÷ distance, and that times the width.
    contour: f64,
    width: f64,
    /// Of directions: weights, and the weighted cosine and sine of twice the wanted angle, of twice the error, and its square.
    weight: f64,
    angle: [f64; 2],
    off: [f64; 2],
    square: f64,
}

/// The threads of the direction number `direction`, whose pattern is `own`.
#[must_use]
pub fn measured(plan: &BodyPlan, form: &ThreadForm, direction: usize, own: &[f32]) -> ThreadReport {
    let surface = plan.surface();
    let is_free = |vertex: usize| !plan.maps.is_obstacle(vertex);
    let group = |vertex: usize| if is_free(vertex) { 0 } else { usize::MAX };
    let found = surface_stripes(surface, own, EDGE, 1, &group)[0];
    let wanted: Vec<Option<Stripes>> =
        (0..own.len()).map(|vertex| directions_at(plan, form, vertex).get(direction).copied()).collect();
    let widest = wanted.iter().flatten().filter_map(|own| own.wavelength).fold(0.0, f64::max);
    let directions = surface_directions(surface, own, AVERAGED * widest);
    let mut sums = Sums::default();
    for (vertex, (wanted, found)) in wanted.iter().zip(directions).enumerate() {
        let Some(own) = wanted.filter(|_| is_free(vertex)) else { continue };
        let area = surface.cell_area(vertex);
        let contour = area * own.duty() / own.width;
        sums.area += area;
        sums.contour += contour;
        sums.width += contour * own.width;
        let (sin, cos) = libm::sincos(2.0 * own.angle.to_radians());
        sums.angle = [sums.angle[0] + area * cos, sums.angle[1] + area * sin];
        if plan.directions.as_ref().is_none_or(|field| field.coherence[vertex] > COHERENT) {
            let off = turn(found.degrees, own.angle);
            let (sin, cos) = libm::sincos(2.0 * off.to_radians());
            sums.weight += found.weight;
            sums.off = [sums.off[0] + found.weight * cos, sums.off[1] + found.weight * sin];
            sums.square += found.weight * off * off;
        }
    }
    let mean = |[x, y]: [f64; 2]| 0.5 * libm::atan2(y, x).to_degrees();
    let asked = Stripes {
        width: sums.width / sums.contour,
        angle: axial(mean(sums.angle)),
        wavelength: Some(sums.area / sums.contour),
    };
    let grown = found.width().zip(found.wavelength()).filter(|_| sums.weight > 0.0);
    let errors = grown.map(|(width, wavelength)| ThreadErrors {
        width: width / asked.width - 1.0,
        wavelength: wavelength * sums.contour / sums.area - 1.0,
        angle: mean(sums.off),
        angle_rms: (sums.square / sums.weight).sqrt(),
    });
    let got = grown.zip(errors).map(|((width, wavelength), errors)| Stripes {
        width,
        angle: axial(asked.angle + errors.angle),
        wavelength: Some(wavelength),
    });
    ThreadReport { lines: form.lines.get(direction).copied().unwrap_or(0), asked, got, error: errors }
}
