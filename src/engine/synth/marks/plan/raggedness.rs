//! The raggedness that the edges of spots and stripes are to have.

use crate::attributes::{AttributeMap, Attributes, Spread};
use crate::document::{LayerOptions, RaggedChoice};
use crate::points::patches::{Patches, Wanted};

/// The share of the plane covered by spots whose spacing is free: far apart, their fringes have room.
const OPEN: f64 = 0.15;

/// The raggedness (at least 1) that `options` ask of the spots or stripes of `map`; `None` if their edges are not changed.
///
/// Its excess over 1 is that of patches of this size, shape and coverage with this σ over such patches with σ = 0, so that the
/// option has one meaning for both.
#[must_use]
pub fn asked_raggedness(map: &AttributeMap, options: &LayerOptions) -> Option<f64> {
    let RaggedChoice::Given(sigma) = options.ragged else { return None };
    let all = map.samples();
    let sum: f64 = all.iter().map(|of| excess(of, sigma)).sum();
    (sigma > 0.0 && !all.is_empty()).then(|| 1.0 + sum / all.len() as f64)
}

/// The σ with which marks of these attributes have this `raggedness` (at least 1): the inverse of [`asked_raggedness`].
#[must_use]
pub fn sigma_of(marks: &Attributes, raggedness: f64) -> f64 {
    let patch = patch(marks);
    let smooth = patch.raggedness_of(0.0, Patches::DETAIL);
    Wanted { raggedness: smooth + raggedness - 1.0, ..patch }.shape(Patches::DETAIL).sigma
}

/// By how much the raggedness of marks with these attributes and this σ exceeds 1.
#[must_use]
pub fn excess(wanted: &Attributes, sigma: f64) -> f64 {
    let patch = patch(wanted);
    patch.raggedness_of(sigma, Patches::DETAIL) - patch.raggedness_of(0.0, Patches::DETAIL)
}

/// The patch with the size, shape and coverage of spots or stripes.
fn patch(marks: &Attributes) -> Wanted {
    let (area, aspect, spacing) = match marks {
        Attributes::Spots(spots) => {
            let spacing = spots.spacing.unwrap_or(Wanted::spacing_of_coverage(spots.area, OPEN));
            (spots.area, spots.aspect, spacing)
        }
        Attributes::Stripes(stripes) => {
            let period = stripes.wavelength.unwrap_or(2.0 * stripes.width);
            let area = stripes.width * stripes.width;
            (area, 1.0, Wanted::spacing_of_coverage(area, stripes.width / period))
        }
    };
    Wanted { area, spacing, aspect, angle: 0.0, raggedness: 1.0, spread: Spread::ZERO }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::{Spots, Stripes};

    #[test]
    fn more_sigma_asks_for_more_and_close_marks_for_less() {
        let spots = |spacing| {
            Attributes::Spots(Spots { area: 900.0, aspect: 0.8, angle: 0.0, spacing: Some(spacing) })
        };
        assert_eq!(excess(&spots(90.0), 0.0), 0.0);
        assert!(excess(&spots(90.0), 0.3) > 2.0 * excess(&spots(90.0), 0.15));
        assert!(excess(&spots(90.0), 0.4) > 1.2 * excess(&spots(42.0), 0.4));
        let stripes = Attributes::Stripes(Stripes { width: 10.0, angle: 0.0, wavelength: None });
        assert!((0.2..0.6).contains(&excess(&stripes, 0.3)));
    }

    #[test]
    fn the_sigma_of_a_raggedness_asks_for_it() {
        let spots = Attributes::Spots(Spots { area: 900.0, aspect: 0.8, angle: 0.0, spacing: Some(70.0) });
        for sigma in [0.07, 0.2, 0.38] {
            let found = sigma_of(&spots, 1.0 + excess(&spots, sigma));
            assert!((found - sigma).abs() < 1e-6, "{sigma}: {found}");
        }
    }
}
