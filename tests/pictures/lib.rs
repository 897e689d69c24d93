//! Pictures for tests: of the window, painted on the processor, and from formulas. A package of its own, since they are slow
//! without optimisation.

pub mod portrait;
pub mod tone_pictures;
pub mod window;
