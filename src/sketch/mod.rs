//! Strokes → marks: what a hand drew.
