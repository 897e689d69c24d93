//! `dapple grow` through the real binary: documents in, pictures and reports out.

mod agreement;
mod around;
mod attributes;
mod body;
mod body_finish;
mod bytes;
mod cells;
mod coat_shapes;
mod extremes;
mod far_marks;
mod finish;
pub(crate) mod folder;
mod free;
mod heights;
mod inside;
#[cfg(unix)]
mod interrupt;
mod keep;
#[cfg(unix)]
mod limits;
mod mapped_pairs;
mod mapped_points;
mod maps;
mod maze;
mod options;
mod patches;
mod point_fields;
mod point_lines;
mod ragged;
mod refusals;
mod region_lines;
#[cfg(unix)]
#[path = "../../faults/running.rs"]
mod running;
mod seeding;
mod sketches;
mod spread;
mod stripe_shapes;
mod textures;
mod tips;
mod tone;
mod turing_growth;
mod weave;
mod wide_stripes;
