//! The attributes that are compared, of spots and stripes, with their units and bounds.

/// A number that is compared region by region.
pub struct Attribute {
    /// Its name in `docs/format.md`.
    pub name: &'static str,
    /// The unit in which errors are printed.
    pub unit: &'static str,
    /// The factor from an error to this unit.
    pub factor: f64,
    /// Bounds of the median and 95th percentile of |error|, in that unit; `None` where it is only printed.
    pub bounds: Option<[f64; 2]>,
    /// Whether it is an attribute of spots; otherwise it is one of stripes.
    pub spots: bool,
}

/// All attributes; the errors of a region are in this order.
pub const ATTRIBUTES: [Attribute; 8] = [
    spots("area", "%", 100.0, Some([1.0, 3.0])),
    spots("spacing", "%", 100.0, Some([2.0, 6.0])),
    // `docs/format.md` defines errors over the whole layer. Here that means over all whole marks of the layer.
    spots("spacing of whole marks", "%", 100.0, None),
    spots("aspect", "", 1.0, Some([0.006, 0.02])),
    spots("angle", "°", 1.0, Some([0.5, 2.0])),
    stripes("width", "%", 100.0, Some([2.0, 5.0])),
    stripes("angle", "°", 1.0, Some([1.2, 4.0])),
    stripes("angle, rms", "°", 1.0, None),
];

/// Errors of a region, by attribute.
pub type Errors = [Option<f64>; ATTRIBUTES.len()];

const fn spots(name: &'static str, unit: &'static str, factor: f64, bounds: Option<[f64; 2]>) -> Attribute {
    Attribute { name, unit, factor, bounds, spots: true }
}

const fn stripes(name: &'static str, unit: &'static str, factor: f64, bounds: Option<[f64; 2]>) -> Attribute {
    Attribute { name, unit, factor, bounds, spots: false }
}
