//! Reasons why there is no room for rings or a web.

/// The reason why lines have no curves to follow.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CurvesError {
    /// Nothing has grown beneath, or nothing that is shown.
    #[error("no mark has grown beneath it: nothing to {0}")]
    Nothing(&'static str),
    /// The marks beneath stand too near to each other.
    #[error(
        "{lines} {width:.1} px wide need {need:.1} px between the marks beneath, and {:.0} % of their outlines have less; \
         draw thinner lines, or the marks beneath farther apart",
        100.0 * share
    )]
    TooNarrow {
        /// `rings` or `webs`.
        lines: &'static str,
        /// Mean width, px.
        width: f64,
        /// The distance between marks that they need, px.
        need: f64,
        /// Share of the outlines with less, 0..1.
        share: f64,
    },
    /// There is only one mark: a web runs between at least two.
    #[error(
        "one mark beneath it on a closed canvas: a web needs two marks or more; draw those beneath smaller or closer"
    )]
    Single,
    /// Marks that reach from border to border cut the web into this number of parts.
    #[error(
        "the marks beneath cut the web into {0} parts: leave gaps between the marks, as a web must be connected"
    )]
    Parts(usize),
}
