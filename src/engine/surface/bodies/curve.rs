//! Curves through points.

/// A curve through the points (Catmull and Rom 1974), with `steps` steps between two of them.
pub fn curve<const N: usize>(points: &[[f64; N]], steps: usize) -> Vec<[f64; N]> {
    let last = points.len() - 1;
    let at = |part: usize, t: f64| {
        let ends = [part.saturating_sub(1), part, (part + 1).min(last), (part + 2).min(last)];
        let [a, b, c, d] = ends.map(|index| points[index]);
        std::array::from_fn(|axis| {
            let [a, b, c, d] = [a, b, c, d].map(|point| point[axis]);
            b + 0.5 * t * (c - a + t * (2.0 * a - 5.0 * b + 4.0 * c - d + t * (3.0 * (b - c) + d - a)))
        })
    };
    let places = (0..last).flat_map(|part| (0..steps).map(move |step| (part, step as f64 / steps as f64)));
    places.map(|(part, t)| at(part, t)).chain([points[last]]).collect()
}
