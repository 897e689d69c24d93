//! dapple: a sketch of a pattern in, a grown texture out.
//!
//! ```no_run
//! use dapple::Document;
//! use dapple::prelude::*;
//!
//! fn main() -> Result<(), Box<dyn std::error::Error>> {
//!     Document::read("zebra.dapple")?.grow()?.save("zebra.png")?;
//!     Ok(())
//! }
//! ```
//!
//! A [`Document`] holds what was drawn: ellipses stand for spots, lines for stripes of their size, shape, direction and
//! spacing. It is read from a `.dapple` file or put together in code. Growing looks up the parameters of a
//! reaction-diffusion system in a training set, simulates it, measures what has grown and corrects it.
//!
//! ```
//! use dapple::document::{Document, Layer, Stroke};
//!
//! let spots = [[30.0, 30.0], [58.0, 34.0]].map(|center| Stroke::ellipse(center, [8.0, 5.0], 30.0));
//! let grown = Document::new([96, 96]).with_layer(Layer::new(spots)).grow()?;
//! assert_eq!(grown.rgb().len(), 3 * 96 * 96);
//! # Ok::<(), dapple::GrowError>(())
//! ```
//!
//! Programs in `examples/` show more: progress and cancelling, looking up parameters, measuring, outlines, films.
//! `docs/format.md` defines the words used here and the file formats.
//!
//! # Rooms
//!
//! ```text
//!  hand ──▶ sketch ──┐
//!                    ├─▶ Marks ─▶ Attributes ─▶ learn ─▶ Parameters ─▶ rd | points ─▶ Field ─▶ colour ─▶ Image ─▶ export
//!  photo ─▶ measure ─┘   └───────────────────── synth calls these, layer by layer ────────────────────────┘
//! ```
//!
//! | | modules | may import |
//! |---|---|---|
//! | base | `grid`, `surface`, `marks`, `attributes` | the base modules before them |
//! | steps | `sketch`, `measure`, `learn`, `rd`, `points`, `colour`, `export`, `finish` | base, never each other |
//! | pipeline | `photo`, [`document`], `synth`, [`data_set`] | base, steps, and the pipeline modules before them; `document` and `photo` do not import each other |
//! | shell | [`machine`], [`files`], [`editor`] | the three above, and the shell modules before them |
//! | entry points | `cli`, `app` (features) | everything; nothing imports them |
//!
//! Base, steps and pipeline are the engine, a separate package (`dapple-engine` in `src/engine`) on which this one
//! depends. The engine reads bytes and writes to any writer. Files, clocks, memory and threads belong to the shell:
//! [`files`] gives the engine the bytes of files, [`machine`] tells it how much memory is free and what time it is.
//!
//! `tests/layering` checks these rules. The opposite direction, from a grown field to parameters, goes through a file:
//! `data-gen` writes `training/`, `learn` reads it.
//!
//! Most modules are internal. What a user needs of them is re-exported here, in [`document`], [`lookup`] and [`output`].
//!
//! # Words
//!
//! | | means |
//! |---|---|
//! | level | the share of the local peak at which a mark has its edge |
//! | grid level | one of the coarser and finer grids on which a layer grows |
//! | time step | one of the explicit steps of a solver that a sweep over the grid takes at once |
//! | parameter field | the parameters of a simulation by cell |
//! | attribute map | the attributes that the sketch asks for at each place of the canvas |
//! | modulation | what the `maps` of a layer change in its attribute map |
//! | cell | an element of a grid; the areas of the system `cells` are polygons in code |
//! | patch | a mark of the system `patches`; what is grown to correct a lookup is a probe patch |
//! | phase | of a picture, its lighter or darker part; of threads, the phase of a wave |
//! | section | a part of the work whose time is measured |
//!
//! # Units
//!
//! Lengths are px of the canvas unless a line says cells; x runs right, y down; angles are degrees from +x towards +y and
//! axial (read mod 180).

/// The engine: from the bytes of a document to a grown texture. Its modules may change at any time; what a user needs of them is
/// re-exported here.
pub use dapple_engine as engine;
#[cfg(feature = "app")]
use dapple_engine::colour;
pub use dapple_engine::data_set;
pub use dapple_engine::document;
#[cfg(any(feature = "app", feature = "cli"))]
use dapple_engine::finish;
use dapple_engine::{attributes, export, grid, learn, marks, measure, photo, rd, sketch, synth};

// Shell.
pub mod machine;
// (machine before files: a picture is checked against the memory that is free)
pub mod files;
// (files before editor: it opens and saves them)
pub mod editor;

// Entry points.
#[cfg(feature = "app")]
pub mod app;
#[cfg(feature = "cli")]
pub mod cli;

pub use document::{Document, DocumentError, Layer, Stroke};
pub use export::ExportError;
pub use files::{ReadFile, SaveTexture, WriteFile};
pub use grid::Field;
pub use machine::free_memory;
pub use synth::{
    Cancelled, GrowError, Grown, GrownLayer, GrownMarks, GrownPairs, GrownTone, Growth, Options, Progress,
    Snapshot, Stage, Watch,
};

/// The traits that read and write files: `use dapple::prelude::*;`.
pub mod prelude {
    pub use crate::files::{ReadFile, SaveFilm, SavePicture, SaveTexture, WriteFile};
}

/// Looking up the parameters of a reaction-diffusion system without a document.
pub mod lookup {
    pub use crate::attributes::{Attribute, Attributes, Spots, Stripes, Unit};
    pub use crate::files::{TrainingFolder, training};
    pub use crate::learn::{Answer, Coverage, Found, InCells, Note, Parameters, TrainingError};
    pub use crate::rd::System;
    pub use crate::synth::error::PlanError;
    pub use crate::synth::{LookedUp, Training};
}

/// Making a document from a photograph.
pub mod photograph {
    pub use crate::files::import_photo;
    pub use crate::photo::{Corners, Crop, LEVELS, Limits, Neither, Wanted};
    pub use crate::synth::import::measured_picture::{Framing, MeasureError};
    pub use crate::synth::import::photo::{ImportedPhoto, PhotoImportError, PhotoOptions};
}

/// Pictures that drive patterns.
pub mod tone {
    pub use crate::document::{Drives, Tone, ToneImage};
    pub use crate::files::read_tone;
    pub use crate::synth::import::tone::drive;
    pub use crate::synth::report::ToneReport;
}

/// Fields of points.
pub mod point_fields {
    pub use crate::document::{Interpolation, Labels, Points, Progression, Towards};
    pub use crate::synth::report::PointsReport;
}

/// Pictures and noise that vary a layer.
pub mod maps {
    pub use crate::document::{LayerMap, LayerMaps, MapChange, MapKey, MapSource};
}

/// What can be made from a growth: pictures, outlines, materials, films, a report, measurements.
pub mod output {
    pub use crate::export::Format;
    pub use crate::export::maps::{Green, Height, Surface};
    pub use crate::export::motion::{Film, Kind as FilmKind};
    pub use crate::export::outline::svg::{Sheet, Unit};
    pub use crate::export::outline::{Ends, Group, Hatch, Shape, Smallest, Style as OutlineStyle};
    pub use crate::files::{Prepared, PreparedFilm, SaveFilm, SavePicture, film_kind};
    pub use crate::measure::{Picture, StripeStatistics, picture};
    pub use crate::synth::render::clip::{Clip, ClipError};
    pub use crate::synth::render::film::Scene;
    pub use crate::synth::render::outlining::{Outlining, outlines};
    pub use crate::synth::render::painting::{Channel, Making, Painting, Style};
    pub use crate::synth::report::{
        GrowthReport, LayerReport, RegionReport, Report, ThreadReport, ToneReport,
    };
}

/// Contact sheets.
#[cfg(feature = "cli")]
#[doc(hidden)]
pub mod sheet {
    pub use crate::cli::sheet::{Contact, Thumbnail, write};
}
