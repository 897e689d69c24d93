//! The time limit of a growth, checked before it begins.
//!
//! The time is estimated by laws, in seconds of one core, so that a document is refused on all machines or on none, whatever their
//! load. The time measured on this machine is reported besides (`estimate`).

/// Most seconds that a large canvas may take: ten minutes.
const MOST: f64 = 600.0;
/// Seconds per px of the canvas that a smaller one may take. The slowest of the examples and golden textures takes 0.02 ms per px:
/// a growth that takes so much more has marks far finer than a px, or with far more different sizes than one picture shows.
const A_PX: f64 = 3e-4;
/// Seconds that any canvas may take at least.
const LEAST: f64 = 5.0;

/// Seconds of one core for each attempt to place a disc; see [`Laying`](crate::points::discs::Laying).
pub const TRY_SECONDS: f64 = 1e-5;

/// The time that a growth may take.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum TimeLimit {
    /// Without a limit.
    #[default]
    None,
    /// .3 ms a px of the canvas, at least 5 s and at most ten minutes.
    Usual,
    /// Limit in seconds.
    Seconds(f64),
}

impl TimeLimit {
    /// Seconds that a canvas of `size` px may take.
    #[must_use]
    pub fn seconds(self, size: [f64; 2]) -> f64 {
        match self {
            Self::None => f64::INFINITY,
            Self::Usual => (A_PX * size[0] * size[1]).clamp(LEAST, MOST),
            Self::Seconds(seconds) => seconds,
        }
    }

    /// Checks that the layers up to one, which take `needed` seconds on a canvas of `size` px, may be grown.
    ///
    /// # Errors
    /// [`TooLong`] with the numbers.
    pub fn allows(self, needed: f64, size: [f64; 2]) -> Result<(), TooLong> {
        let allowed = self.seconds(size);
        if needed > allowed { Err(TooLong { size, needed, allowed }) } else { Ok(()) }
    }
}

/// A growth that takes too long.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "growing takes {} of one core up to this layer, a canvas of {}×{} px may take {}; draw larger marks, or such as differ less \
     in size, or allow more with --minutes {}",
    in_words(*needed), size[0], size[1], in_words(*allowed), (needed / 60.0).ceil().max(1.0)
)]
pub struct TooLong {
    /// Canvas, px.
    pub size: [f64; 2],
    /// Seconds needed.
    pub needed: f64,
    /// Seconds allowed.
    pub allowed: f64,
}

/// A time in words, such as `about 40 s`: two digits at most.
#[must_use]
pub fn in_words(seconds: f64) -> String {
    let coarse = |value: f64| if value < 10.0 { value.round() } else { (value / 5.0).round() * 5.0 };
    match seconds {
        s if s < 1.0 => "under 1 s".to_owned(),
        s if s < 90.0 => format!("about {:.0} s", coarse(s)),
        s if s < 5400.0 => format!("about {:.0} min", coarse(s / 60.0)),
        s => format!("about {:.1} h", s / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn estimated_times_are_round_numbers() {
        let times = [0.3, 6.4, 41.0, 119.0, 1000.0, 7200.0].map(in_words);
        assert_eq!(
            times,
            ["under 1 s", "about 6 s", "about 40 s", "about 2 min", "about 15 min", "about 2.0 h"]
        );
    }

    #[test]
    fn a_canvas_may_take_five_seconds_to_ten_minutes_by_its_px() {
        let allowed = |size| TimeLimit::Usual.seconds(size);
        assert_eq!([allowed([4.0, 3.0]), allowed([64.0, 64.0]), allowed([9e3, 9e3])], [5.0, 5.0, 600.0]);
        assert!((allowed([400.0, 200.0]) - 24.0).abs() < 1e-9);
        assert_eq!(TimeLimit::None.allows(1e30, [1.0; 2]), Ok(()));
    }

    #[test]
    fn a_growth_that_takes_too_long_is_refused_with_the_numbers_and_the_remedy() {
        assert_eq!(TimeLimit::Usual.allows(23.0, [400.0, 200.0]), Ok(()));
        let error = TimeLimit::Usual.allows(100.0, [400.0, 200.0]).unwrap_err().to_string();
        assert!(error.starts_with("growing takes about 2 min"), "{error}");
        assert!(error.contains("a canvas of 400×200 px may take about 25 s"), "{error}");
        assert!(error.ends_with("allow more with --minutes 2"), "{error}");
        assert_eq!(TimeLimit::Seconds(120.0).allows(100.0, [200.0, 100.0]), Ok(()));
    }
}
