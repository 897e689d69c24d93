//! Rows → answers: locally weighted regression over the training sets.
