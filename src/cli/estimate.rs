//! How long it will take, told before it begins.

use crate::synth::Training;
use crate::synth::estimate::{Needs, told};
use crate::synth::recipe::Document;
use std::io::Write;

/// What takes longer than this is told, seconds.
const LONG: f64 = 5.0;
/// px of all canvases below which a growth is over before its time is worked out.
const SMALL: f64 = 700.0 * 700.0;

/// Tells how long work will take.
pub struct Estimate<'a> {
    /// What parameters are looked up in.
    pub training: &'a Training,
    /// Nobody wants to know.
    pub quiet: bool,
}

impl Estimate<'_> {
    /// Tells on stderr how long these documents will take, each grown `times`, where that is long.
    pub fn tell(&self, documents: &[(&Document, &str)], times: f64) {
        let area = |size: [u32; 2]| f64::from(size[0]) * f64::from(size[1]);
        let px: f64 = documents.iter().map(|(document, _)| area(document.size)).sum();
        if self.quiet || times * px < SMALL {
            return;
        }
        let Some(first) =
            documents.first().and_then(|(document, source)| Needs::of(document, source, self.training))
        else {
            return;
        };
        // The first stands for the others, by its px.
        let seconds = times * first.seconds * px / area(documents[0].0.size);
        self.tell_seconds(seconds);
    }

    /// Tells on stderr that it will take so many seconds, where these are many.
    pub fn tell_seconds(&self, seconds: f64) {
        if !self.quiet && seconds > LONG {
            // Nobody left to tell is no reason to fail.
            let _ = writeln!(std::io::stderr(), "note: this will take {}", told(seconds));
        }
    }
}
