//! Regions of the canvas, and attributes at any point between them.
