//! Scattered points → field: partition of unity parametrics (PUPs), and patches made with them.
//!
//! ```text
//!  metric ─▶ discs ─▶ delaunay ─▶ labels ─▶ interpolation ─▶ level ─▶ Field
//!           (points)  (graph)    (values)   (eq. 1–4)        (½ = edge)
//!                          └──────── fields, patches, lines, noise, roughened are made of these
//! ```
//!
//! After the paper on procedural textures by partition of unity parametrics, a modelling method of A. Runions and F. Samavati,
//! which the comments call the paper: points are scattered over the plane, joined by their Delaunay graph and given values, which
//! are interpolated along the graph's edges. The equations are in [`interpolation`].
//!
//! There are two methods. The paper gives each px the label of the point of the highest weight ([`interpolation::highest_weight`]),
//! which makes polygons. Interpolating labels 0 and 1 and cutting at the level of a wanted share ([`level`]) makes smooth organic
//! edges; the result is a pattern as in the other rooms: 0..1, ½ = edge.
//!
//! The paper's figures; the unit of length is a side of the tile (r: radius of the discs; other values that were tried: `facts.md`
//! U):
//!
//! | figure | made by |
//! |---|---|
//! | 6–8 noise, turbulence | [`noise::Noise`], r = .1, four octaves, folded |
//! | 9, 10 cells | [`interpolation::highest_weight`], r .08; four layers, r .16·2⁻ⁱ |
//! | 5 oriented cells | the same with [`interpolation::Orientation`], ε .5 |
//! | 11 cow | [`labels::random`], r .06, L 1.5, level by share |
//! | 12 space giraffe | [`labels::space_giraffe`], r .11, 10–20 rays |
//! | 13, 14 fractal outline | [`labels::by_reference`], r .07, ÷ √2 in each pass |
//! | 15–17 progressions | [`discs::poisson_discs`] with a map of radii; [`labels::random`] with a map |
//! | 19, 20 connected | [`labels::connected`], start 3–4 % |
//! | 22, 23 breadth, depth first | [`labels::clusters`], r .02–.03, 8–40 points |
//! | 19, 23 with given width and share | [`lines::Lines`] |
//! | 24 round robin | [`labels::round_robin`] and [`labels::bordered`], 60 centres, r .012 |
//!
//! Lengths are px. Every function that draws random numbers takes a generator or a seed. Results depend neither on the number of
//! threads nor on the processor.

pub mod appearance;
pub mod centers;
pub mod delaunay;
mod depth;
pub mod discs;
pub mod extent;
pub mod fields;
pub mod graph;
pub mod interpolation;
pub mod labels;
pub mod level;
pub mod lines;
pub mod metric;
pub mod noise;
pub mod patches;
pub mod rosettes;
pub mod roughened;
pub mod solid_noise;
pub mod stripe_variation;
pub mod stripe_widths;
pub mod voronoi;
mod ways;
