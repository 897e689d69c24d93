//! Pictures for tests: pictures of the window, which are painted on the processor; pictures from formulas; and
//! measurements in pictures, px by px. This is a separate package, because all of it is slow without optimisation.

pub mod portrait;
pub mod seams;
pub mod tone_pictures;
pub mod window;
