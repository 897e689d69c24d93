//! Webs: the medial axis, where two marks beneath are equally near.

use super::nearest::{Nearest, between, parts};
use super::{Curves, Request, runs};
use crate::grid::UnionFind;
use crate::surface::Surface;
use crate::synth::error::CurvesError;
use crate::synth::marks::plan::offset_curves::medial_axis::{HALO, HELD, LANE, NARROW, NEED, PIECE};

/// Lays a web between the obstacles of `request`.
pub fn lay(request: &Request) -> Result<Curves, CurvesError> {
    let Request { surface, laws, obstacles, widths, .. } = request;
    let px = surface.unit();
    let away = Nearest::new(surface, obstacles).ok_or(CurvesError::Nothing("span a web between"))?;
    let distance: Vec<f64> = away.distance.iter().map(|away| (away - 0.5 * px).max(0.0)).collect();
    let mut marks = parts(surface, obstacles);
    let whole = between(surface, &away, &marks);
    let all = whole.iter().filter(|set| **set).count();
    if all == 0 {
        return Err(CurvesError::Single);
    }
    join_near(request, &away, &distance, &mut marks);
    let mut medial = between(surface, &away, &marks);
    let share = 1.0 - medial.iter().filter(|set| **set).count() as f64 / all as f64;
    let of_web = whole.iter().zip(widths).filter(|(set, _)| **set);
    let mean = of_web.map(|(_, width)| width).sum::<f64>() / all as f64;
    if share > NARROW {
        return Err(CurvesError::TooNarrow { lines: "webs", width: mean, need: NEED * mean, share });
    }
    one_piece(surface, &mut medial)?;
    let mut remarks = Vec::new();
    if share > 0.01 {
        remarks.push(format!(
            "a web {mean:.1} px wide needs {:.1} px between marks; {:.0} % of it has less, and marks there are surrounded together",
            NEED * mean,
            100.0 * share
        ));
    }
    let to = Nearest::new(surface, &medial).ok_or(CurvesError::Single)?;
    let off: Vec<f64> = to.distance.iter().map(|away| (away / px - 0.5).max(0.0)).collect();
    let is_blocked =
        |vertex: usize| distance[vertex] < HALO * widths[vertex] || off[vertex] * px > LANE * widths[vertex];
    let blocked: Vec<bool> = (0..off.len()).map(is_blocked).collect();
    let curve = off.iter().zip(&blocked).map(|(off, blocked)| *off < 1.0 && !blocked).collect();
    let stretch_and_meeting = |vertex: usize| {
        let from_curve = off[vertex] * px / widths[vertex];
        (laws.web.stretch, libm::exp(-from_curve * from_curve))
    };
    let run = runs(request, &to.distance, stretch_and_meeting);
    let inhibitor = vec![HELD; off.len()];
    let distance = off.iter().map(|off| *off as f32).collect();
    Ok(Curves { distance, run, blocked, inhibitor, curve, ends: Vec::new(), remarks })
}

/// Joins marks that are too near to each other somewhere.
fn join_near(request: &Request, away: &Nearest, distance: &[f64], marks: &mut UnionFind) {
    for vertex in 0..distance.len() {
        for other in request.surface.ring(vertex) {
            let [own, beside] = [vertex, other].map(|vertex| away.to[vertex]);
            let is_near = distance[vertex] + distance[other] < NEED * request.widths[vertex];
            if is_near && marks.root(own).0 != marks.root(beside).0 {
                marks.join(own, beside, [0, 0]);
            }
        }
    }
}

/// Removes all pieces but the largest where the others are small.
fn one_piece(surface: &Surface, medial: &mut [bool]) -> Result<(), CurvesError> {
    let pieces = parts(surface, medial);
    let mut sizes = vec![0_usize; medial.len()];
    for vertex in (0..medial.len()).filter(|vertex| medial[*vertex]) {
        sizes[pieces.root(vertex as u32).0 as usize] += 1;
    }
    let all: usize = sizes.iter().sum();
    let largest = (0..sizes.len()).fold(0, |best, root| if sizes[root] > sizes[best] { root } else { best });
    let count = sizes.iter().filter(|size| **size as f64 > PIECE * all as f64).count();
    if count > 1 {
        return Err(CurvesError::Parts(count));
    }
    for (vertex, set) in medial.iter_mut().enumerate() {
        *set = *set && pieces.root(vertex as u32).0 as usize == largest;
    }
    Ok(())
}
