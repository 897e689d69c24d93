//! Rings: offset curves of the marks beneath, at the same distance everywhere; near marks share one wall.

use super::gaps::{Gaps, open};
use super::nearest::{Nearest, between, parts};
use super::{Curves, Request, runs};
use crate::surface::Surface;
use crate::synth::error::CurvesError;
use crate::synth::marks::plan::offset_curves::rings::{
    CROWDED, LANE, NARROWEST, OWN, SHARED, SIDES, STRIP, WALL, place,
};

/// Lays rings around the obstacles of `request`.
pub fn lay(request: &Request) -> Result<Curves, CurvesError> {
    let Request { surface, laws, obstacles, widths, .. } = request;
    let px = surface.unit();
    let away = Nearest::new(surface, obstacles).ok_or(CurvesError::Nothing("ring"))?;
    // The edge of a covered cell is half a cell before its centre.
    let distance: Vec<f64> = away.distance.iter().map(|away| (away - 0.5 * px).max(0.0)).collect();
    let marks = parts(surface, obstacles);
    let room = room(surface, &between(surface, &away, &marks), &distance);
    let at = |vertex: usize| place(room[vertex] / widths[vertex]) * widths[vertex];
    let off: Vec<f64> =
        (0..distance.len())
            .map(|vertex| {
                if distance[vertex].is_finite() {
                    (distance[vertex] - at(vertex)).abs() / px
                } else {
                    f64::MAX
                }
            })
            .collect();
    let has_own = |vertex: usize| room[vertex] >= SHARED * widths[vertex];
    let is_blocked = |vertex: usize| {
        let width = widths[vertex];
        let narrow = room[vertex] < NARROWEST * width && distance[vertex] < width;
        let in_widths = room[vertex] / width;
        let between_rings =
            (SHARED..STRIP[0]).contains(&in_widths) && distance[vertex] / width > in_widths - STRIP[1];
        off[vertex] * px > LANE * width || narrow || between_rings
    };
    let mut blocked: Vec<bool> = (0..off.len()).map(is_blocked).collect();
    let mut curve: Vec<bool> =
        off.iter().zip(&blocked).map(|(off, blocked)| *off < 1.0 && !blocked).collect();
    let mut remarks = Vec::new();
    check_room(request, &has_own, &mut remarks)?;
    let mut ends = Vec::new();
    if request.broken > 0.0 {
        let ring = |vertex: usize| marks.root(away.to[vertex]).0 as usize;
        let Gaps { opened, ends: places } = open(request, &off, &curve, ring);
        ends = places;
        for (vertex, opened) in opened.iter().enumerate() {
            blocked[vertex] |= opened;
            curve[vertex] &= !opened;
        }
    }
    let side = |vertex: usize| SIDES[usize::from(distance[vertex] > at(vertex))];
    let inhibitor = (0..off.len()).map(|vertex| if has_own(vertex) { side(vertex) } else { WALL }).collect();
    let run = runs(request, &away.distance, |vertex| {
        let (law, meeting) = if has_own(vertex) { (laws.rings, 0.0) } else { (laws.web, 1.0) };
        (law.stretch, meeting)
    });
    let distance = off.iter().map(|off| *off as f32).collect();
    Ok(Curves { distance, run, blocked, inhibitor, curve, ends, remarks })
}

/// Half the distance between the two marks whose medial axis is nearest to each vertex, px.
fn room(surface: &Surface, medial: &[bool], distance: &[f64]) -> Vec<f64> {
    let Some(nearest) = Nearest::new(surface, medial) else { return vec![f64::INFINITY; distance.len()] };
    let ways = nearest.distance.iter().zip(&nearest.to);
    ways.map(|(way, to)| if way.is_finite() { distance[*to as usize] } else { f64::INFINITY }).collect()
}

/// Refuses rings with too little room, and remarks on rings of which some have too little.
fn check_room(
    request: &Request,
    has_own: &dyn Fn(usize) -> bool,
    remarks: &mut Vec<String>,
) -> Result<(), CurvesError> {
    let Request { surface, obstacles, widths, .. } = request;
    let is_outline =
        |vertex: &usize| obstacles[*vertex] && surface.ring(*vertex).any(|other| !obstacles[other]);
    let outline: Vec<usize> = (0..obstacles.len()).filter(is_outline).collect();
    if outline.is_empty() {
        return Err(CurvesError::Nothing("ring"));
    }
    let all = outline.len() as f64;
    let share = outline.iter().filter(|vertex| !has_own(**vertex)).count() as f64 / all;
    let width = outline.iter().map(|vertex| widths[*vertex]).sum::<f64>() / all;
    let need = OWN * width;
    if share > CROWDED {
        return Err(CurvesError::TooNarrow { lines: "rings", width, need, share });
    }
    if share > 0.005 {
        remarks.push(format!(
            "rings {width:.1} px wide need {need:.1} px between marks; {:.0} % of the outlines have less, and neighbours share a wall there",
            100.0 * share
        ));
    }
    Ok(())
}
