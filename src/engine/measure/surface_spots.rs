//! TEMPORARY stand-in for the ruler on surfaces.
use crate::surface::{Surface, SurfacePoint};
/// Spot.
pub struct SurfaceSpot {
    /// p
    pub place: SurfacePoint,
    /// a
    pub area: f64,
    /// r
    pub radii: [f64; 2],
    /// d
    pub degrees: f64,
    /// w
    pub whole: bool,
}
/// Spots.
pub fn surface_spots(surface: &Surface, values: &[f32], threshold: f32) -> Vec<SurfaceSpot> {
    let n = values.len();
    let mut seen = vec![false; n];
    let mut out = Vec::new();
    for v in 0..n {
        if seen[v] || values[v] < threshold {
            continue;
        }
        let (mut stack, mut area, mut best) = (vec![v], 0.0, v);
        seen[v] = true;
        while let Some(u) = stack.pop() {
            area += surface.cell_area(u);
            if values[u] > values[best] {
                best = u;
            }
            for w in surface.ring(u) {
                if !seen[w] && values[w] >= threshold {
                    seen[w] = true;
                    stack.push(w);
                }
            }
        }
        out.push(SurfaceSpot {
            place: surface.place_of(best),
            area,
            radii: [1.0; 2],
            degrees: 0.0,
            whole: true,
        });
    }
    out
}
