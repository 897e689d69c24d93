//! Whether there is room for rings or a web, and what to say where there is none.

use super::Way;

/// Distance between two marks, ÷ the width of the lines, that they need between them.
pub struct Need;

impl Need {
    /// For lines of their own; below it neighbours share what is between them.
    #[must_use]
    pub fn own(way: Way) -> f64 {
        match way {
            Way::Rings => 2.0 * super::rings::OWN,
            Way::Web => super::web::NEED,
        }
    }
}

/// Why there is no course.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CourseError {
    /// Nothing was grown beneath, or nothing that is shown.
    #[error("no mark has grown beneath it: nothing to {0}")]
    Nothing(&'static str),
    /// The marks beneath stand too near to each other.
    #[error(
        "{lines} {width:.1} px wide need {need:.1} px between the marks beneath, and {:.0} % of these stand nearer; draw \
         thinner lines, or the marks beneath farther apart",
        100.0 * share
    )]
    TooNarrow {
        /// What is drawn.
        lines: &'static str,
        /// Mean width, px.
        width: f64,
        /// What it needs, px.
        need: f64,
        /// Share of what would be drawn that finds no room, 0..1.
        share: f64,
    },
    /// There is but one mark, whose web would have no end to meet.
    #[error("one mark beneath it on a closed canvas: a web runs between marks; draw those beneath smaller or nearer")]
    Single,
    /// Marks from border to border cut the web.
    #[error("the marks beneath cut the web into {0} parts: a web runs between marks that leave a way round them")]
    Parts(usize),
}
