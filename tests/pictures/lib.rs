//! Pictures for tests: of the window, painted on the processor, from formulas, and what is measured in them px by px. A package of its
//! own, since all of it is slow without optimisation.

pub mod portrait;
pub mod seams;
pub mod tone_pictures;
pub mod window;
