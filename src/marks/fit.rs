//! Points → an ellipse (direct least squares) or a line.
