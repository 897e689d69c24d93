//! The document: everything that defines a texture, and its `.dapple` file (JSON, UTF-8).
//!
//! A document that was read is valid: every number is finite and within [`limits`], some part of every mark lies on the canvas (on
//! a tile the rest of it continues at the other side), and no layer mixes ellipses with lines or paths. (Freehand strokes are
//! fitted, and checked, when the document is grown.)
//!
//! | key | default |
//! |---|---|
//! | `format`, `version`, `size`, `layers`, a layer's `strokes`, a stroke's shape | required |
//! | `name` | empty |
//! | `regions` | none: each mark says what is wanted around it |
//! | `edges` | `"closed"` |
//! | `seed` | 1 |
//! | `dpi` | 300 |
//! | `growth.refine` | true |
//! | `model` | none: a flat canvas |
//! | `model.sha256` | none: whatever the file holds |
//! | `model.px` | 900 |
//! | `model.up`, `model.along` | `"y"`, `"x"` |
//! | `model.pins`, `model.strokes`, `model.only` | none |
//! | the `region` and `toward` of a pin | [0, 0]; along the axis `along` |
//! | `warp` | none: marks stay as they grow |
//! | `finish` | none: the colours alone |
//! | `finish.size` | by kind: [`crate::finish::Kind::usual_size`] |
//! | `finish.flow` | across the stripes of the lowest visible layer, otherwise 190 |
//! | `starred` | none: no other textures are kept |
//! | a layer's `name` | `layer 1`, `layer 2`, … |
//! | a layer's `system` | `"auto"` |
//! | a layer's `after` | `"between"` |
//! | a layer's `visible` | true |
//! | a layer's `seed` | derived from the document's: [`Document::layer_seed`] |
//! | a layer's `far_spacing` | none: it follows from the strokes alone |
//! | a layer's `options` | `{}` |
//! | `options.spread`, of spots | `"drawn"` |
//! | `options.duty`, of stripes | `"drawn"` |
//! | `options.broken`, of `"after": "around"` | 0: closed rings |
//! | `options.near`, of `"after": "near"` | 24 |
//! | `options.irregular`, of spots | 0 |
//! | `options.keep` | true where there are no regions or one, `irregular` is 0, and no map changes what grows |
//! | `options.seeding`, of stripes | `"noise"` |
//! | `options.ragged`, of patches, spots and stripes | `"drawn"`: of spots and stripes as they grow |
//! | `options.detail`, of patches | 24 |
//! | a layer's `tone` | none: no picture drives it |
//! | `tone.range` | `[0.1, 0.9]` |
//! | `tone.drives` | `["level", "direction", "spacing"]` |
//! | `tone.sketch` | 0.1 |
//! | `tone.equalise` | true |
//! | a layer's `maps` | `{}`: nothing varies but what is drawn |
//! | `noise.octaves` of a map | 2 |
//! | `factor` of a map with an image | false |
//! | a layer's `colours` | the default set of that layer |
//! | `colours.bends` | none: straight between all stops |
//! | `colours.ground` | white |
//! | `colours.halo` | 1: the ground as the stops say |
//! | an ellipse's `angle`; the `normal` of one on the model | 0; either side |
//! | an ellipse's `outline` | none: it was drawn as an ellipse |
//! | the `width` of a line, a path or a freehand stroke | 6 px |
//!
//! `options.spread` of a layer of spots tells how much they differ from each other, as [`Spread`] defines it:
//!
//! | value | meaning |
//! |---|---|
//! | `"drawn"` | as much as the marks of each region; those of fewer than six marks are even |
//! | a number, 0–0.6 | the coefficient of variation of the area; shapes, directions and distances are even |
//! | `{"area": 0–0.6, "angle": 0–45, "aspect": 0–0.2, "spacing": 0–0.2}` | each by itself; what is left out is even |
//!
//! `options.duty` of a layer of stripes is the width of the stripes ÷ their period. `"drawn"`: the duty of the drawn lines that lie
//! side by side, and 0.5 where none do. With regions it is the mean of the lines of each; a region in which no lines lie side by
//! side takes the period of the nearest one in which some do. A number, 0.18–0.82: the stripes are as wide as drawn, and width ÷
//! duty apart. At 0.5 `auto` takes `meinhardt-stripes`, whose stripes are as wide as their gaps; otherwise `meinhardt-lines`, thin
//! stripes on wide ground. `meinhardt-stripes` takes no other duty. Stripes that cover more than half of their period are the gaps
//! between such lines: the lines are grown, and the pattern is 1 − theirs. A layer grows either stripes or gaps, by the mean of the
//! duty over the canvas; strokes of the layer that ask for the other side of 0.5 keep their width and get a duty of about 0.5.
//!
//! `"system": "weave"` of a layer of lines and paths that cross grows threads of two to five directions, as Witkin and Kass
//! (SIGGRAPH 1991). `auto` takes it where lines cross and both go on; with `"stripes"` such lines stay stripes, which have one
//! direction at each place. Lines that cross at 30° or more have different directions; each direction has the width and the period of its
//! own lines, and threads run through the drawn lines and on all over the canvas. `options.duty` is that of each direction; without
//! it, lines side by side say how far apart threads are, and a line alone has threads that cover 0.28 (of three and more
//! directions 0.2). Threads that would leave no gaps are moved apart, and a note says so.
//!
//! `"system": "maze"` of the same lines, which need not cross, grows straight pieces of their directions that meet and never cross.
//! Directions less than 20° apart count as one. Pieces are as long as the lines are in the mean, and regions whose lines have one direction
//! are one piece.
//!
//! `"system": "cells"` of a layer of ellipses and outlines grows cells of their area, aspect and direction. `options.gap` is the
//! width of the lines between the cells; `"drawn"` = the width of the gaps between drawn outlines that nearly touch.
//!
//! `"system": "patches"` of a layer of ellipses and outlines grows blotches as on cows and giraffes: scattered points, of which each
//! patch claims those that are nearest to its centre. `auto` takes them where outlines are drawn, and where
//! ellipses are too dense for spots: [`Document::areas`]. An
//! outline is a closed polygon, and asks for what the ellipse with its moments asks for, and for its raggedness: (contour ÷
//! contour of that ellipse)². `options.ragged` gives it instead. With `options.keep` the drawn outlines are reproduced. On spots and
//! stripes of reaction and diffusion `options.ragged` roughens the grown edges.
//!
//! `options.broken` of a layer `around` the one beneath, 0–0.6: the share of each ring that is open, in two to five gaps a
//! ring, as on a leopard.
//!
//! `options.irregular` of a layer of spots, 0–1, says how irregular their shapes are: 0 grows ellipses, 1 beans, bars and
//! drops that differ by 0.4 in area (β ± 3 of Phan & Grimm). Only `turing-spots` does that, which `auto` takes then; their
//! spacing goes with their area. The mean area is as drawn; aspect and angle are those of the spots before they were bent.
//!
//! `options.keep`: whether the drawn marks are among those that grow. Each drawn ellipse then has a grown spot within a
//! quarter of its radius √(r₁r₂), of its own size and shape as far as the spots of its region can differ; each drawn line
//! lies in a stripe over nine tenths of its length. Where two are nearer to each other than such marks can stand, as many
//! stay as can, and the report says how many do not. In many regions a mark says what is wanted around it, and may lie
//! where the map between regions wants something else; there it is off unless asked for. On a canvas of another size than
//! the document's the marks stand at the stretched places and keep their size. Not with `"after"` around, net, inside.
//!
//! `options.seeding` of a layer of stripes with a duty of 0.5 is the initial state of the stripes:
//!
//! | value | meaning |
//! |---|---|
//! | `"noise"` | noise of their wavelength and direction; they grow along a tensor and follow the direction to 4° (rms) |
//! | `"segments"` | short lines of their direction at random places, no tensor (Phan & Grimm, V.1): forked and wavy, 18° off (rms) |
//! | `"initiators"` | the drawn lines alone, no tensor: regular stripes around them (Turk, "Regular Stripe Patterns") |

mod area_kind;
mod areas;
mod body;
mod builder;
mod causes;
mod choices;
mod colours;
mod dense;
pub mod embedded;
mod error;
mod file;
mod finish;
#[doc(hidden)]
pub mod layer_rules;
pub mod limits;
mod line_kind;
pub mod link;
mod maps;
mod migrate;
mod node;
mod option_key;
mod outline;
pub mod palette;
mod parametric;
mod points;
mod reader;
mod schema;
mod setting;
mod shape;
mod side_by_side;
#[doc(hidden)]
pub mod sketch_notes;
mod strokes;
mod syntax;
mod system_choice;
pub mod systems;
pub mod tile;
mod tone;
mod warp;
mod weaving;
mod writer;

pub use crate::attributes::Spread;
pub use crate::colour::{Gradient, PRESETS, Preset};
pub use crate::finish::{Finish, Kind as FinishKind};
pub use crate::grid::Edges;
pub use crate::marks::{Ellipse, Line, Path};
pub use crate::rd::pairs::PairKind;
pub use crate::rd::{Seeding, System};
pub use area_kind::AreaKind;
pub use body::{Axis, Body, BodyEllipse, BodyMark, BodySource, Pin};
pub use causes::{io_in_words, with_causes};
pub use choices::{After, Kind, Over};
pub use colours::{Colours, Stop};
pub use embedded::{Extent, in_stream};
pub use error::{DocumentError, LinkError, Problem};
pub use finish::{Finishing, FlowChoice};
pub use line_kind::LineKind;
pub use maps::{LayerMap, LayerMaps, MapChange, MapKey, MapSource};
pub use option_key::OptionKey;
pub use outline::Outline;
pub use parametric::{ParametricSurface, Relief};
pub use points::{Interpolation, Labels, Points, Progression, Towards};
pub use schema::schema;
pub use setting::Setting;
pub use system_choice::SystemChoice;
pub use tone::{Drives, Tone, ToneImage};
pub use warp::Warp;

use crate::attributes::system::Family;
use crate::marks::{Mark, ellipse_of_outline};
use crate::points::patches::Patches;
pub use crate::points::rosettes::Rosettes;
use crate::rd::pairs::Stucco;
use crate::sketch::recognise;

/// Everything that defines a texture: what was drawn and how it is grown.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// Its name; may be empty.
    pub name: String,
    /// Width and height of the canvas, px, 1 to [`limits::MAX_SIDE`] each.
    pub size: [u32; 2],
    /// Columns and rows of regions, 1 to [`limits::MAX_REGIONS`] each; `None` = each mark gives the wanted properties around it.
    pub regions: Option<[u32; 2]>,
    /// Whether the canvas ends at its border or wraps around, which a very narrow one may not ([`limits::MAX_TILE_RATIO`]).
    pub edges: Edges,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Dots an inch, for print.
    pub dpi: f64,
    /// Settings of its growth.
    pub growth: Growth,
    /// The model that it grows on; `None` = a flat canvas.
    pub model: Option<Body>,
    /// The surface of which the canvas is the flat map; `None` = the canvas itself, or the model.
    pub parametric: Option<ParametricSurface>,
    /// How its grown marks are bent; `None` = they stay as they grow.
    pub warp: Option<Warp>,
    /// The material that the texture is made of; `None` = the colours alone.
    pub finish: Option<Finishing>,
    /// The layers, the lowest first; at least one.
    pub layers: Vec<Layer>,
    /// Other textures for the same sketch, or an earlier one, that were kept; they grow nothing.
    pub starred: Vec<Starred>,
}

impl Default for Document {
    /// An empty canvas of 512 × 512 px; it has no layers yet and so is not valid yet.
    fn default() -> Self {
        Self {
            name: String::new(),
            size: [512, 512],
            regions: None,
            edges: Edges::Closed,
            seed: 1,
            dpi: 300.0,
            growth: Growth::default(),
            model: None,
            parametric: None,
            warp: None,
            finish: None,
            layers: Vec::new(),
            starred: Vec::new(),
        }
    }
}

/// A texture that was kept beside the document's own.
#[derive(Clone, Debug, PartialEq)]
pub struct Starred {
    /// Short name of the difference from the sketch.
    pub name: String,
    /// Its document, which keeps no others.
    pub document: Document,
}

impl Document {
    /// The seed of the layer at `index` (0 = the lowest): its own or, where it has none, one derived from the
    /// document's.
    ///
    /// The derived one is the output at position `index` + 1 of SplitMix64 started from the document's seed
    /// (Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014, fig. 17), so that
    /// neighbouring document seeds share no layer's.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    ///
    /// let spot = || Layer::new([Stroke::ellipse([30.0, 30.0], [8.0, 5.0], 30.0)]);
    /// let document = Document::new([96, 96]).with_layer(spot().with_seed(5)).with_layer(spot());
    /// assert_eq!(document.layer_seed(0), 5);
    /// assert_ne!(document.layer_seed(1), 5);
    /// ```
    #[must_use]
    pub fn layer_seed(&self, index: usize) -> u64 {
        const GOLDEN_GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;
        if let Some(seed) = self.layers.get(index).and_then(|layer| layer.seed) {
            return seed;
        }
        let mut z = self.seed.wrapping_add(GOLDEN_GAMMA.wrapping_mul(index as u64 + 1));
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}

impl Document {
    /// Whether the drawn marks of the layer at `index` are among those that grow (`options.keep`).
    ///
    /// Never if a tone or Turing's growth drives the layer. The default is yes without regions and with one. It is no with several
    /// regions, with [`Layer::maps`] and with [`Self::parametric`], because these may give other properties at the place of a mark,
    /// and for irregular spots, because these differ from drawn ellipses.
    #[must_use]
    pub fn keeps_marks(&self, index: usize) -> bool {
        let Some(layer) = self.layers.get(index).filter(|layer| !layer.is_driven()) else {
            return false;
        };
        let Layer { options, after, maps, .. } = layer;
        let changes = maps.change_growth() || self.parametric.is_some();
        let usual = self.region_grid() == [1, 1] && options.irregular == 0.0 && !changes;
        // The lowest layer has nothing beneath it to come after.
        (index == 0 || after.keeps_away()) && options.keep.unwrap_or(usual)
    }

    /// Columns and rows of the tables and overlays that go by region: 1 × 1 without regions.
    #[must_use]
    pub fn region_grid(&self) -> [usize; 2] {
        self.regions.unwrap_or([1, 1]).map(|n| n as usize)
    }
}

/// Settings of the growth of a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Growth {
    /// Whether a grown texture is measured and its parameters are corrected by what was found.
    pub refine: bool,
}

impl Default for Growth {
    fn default() -> Self {
        Self { refine: true }
    }
}

/// One set of marks and the system that grows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Its name; may be empty.
    pub name: String,
    /// The system that grows it.
    pub system: SystemChoice,
    /// Position of its marks relative to the frozen marks beneath.
    pub after: After,
    /// Whether it is painted; a hidden layer still grows.
    pub visible: bool,
    /// Its own seed; `None` = derived, see [`Document::layer_seed`].
    pub seed: Option<u64>,
    /// The drawn marks; at least one, unless there is a tone, or its system is a field of points or Turing's growth.
    pub strokes: Vec<Stroke>,
    /// The marks drawn on the model; none without a model. Documents hold them among the strokes.
    pub on_model: Vec<BodyMark>,
    /// The spacing that was wanted far from all ellipses before the strokes were last changed, px: it stays while these agree with it.
    /// `None` = they alone say it. Means nothing with regions.
    pub far_spacing: Option<f64>,
    /// Its options beyond the marks.
    pub options: LayerOptions,
    /// Its points, where these make it; `None` = their defaults.
    pub points: Option<Points>,
    /// The picture that drives its pattern.
    pub tone: Option<Tone>,
    /// Pictures and noise by which what it asks for varies.
    pub maps: LayerMaps,
    /// Its colours; `None` = the default set of that layer.
    pub colours: Option<Colours>,
}

impl Layer {
    /// Whether nothing would grow on it: nothing is drawn, nothing drives it, and it is no field of points.
    #[must_use]
    pub fn is_blank(&self) -> bool {
        let is_undrawn = self.strokes.is_empty() && self.on_model.is_empty();
        is_undrawn && self.tone.is_none() && !self.system.is_known(|system| system.grows_blank)
    }

    /// Whether a picture or a field determines its pattern: it has a `tone`, or its system is Turing's growth.
    #[must_use]
    pub fn is_driven(&self) -> bool {
        self.tone.is_some() || self.system.kind() == Some(Family::Growth)
    }

    /// The system that is asked for: irregular spots want one that grows such.
    #[must_use]
    pub fn wanted_system(&self) -> SystemChoice {
        let irregular = System::first(|system| system.irregular).filter(|_| self.options.irregular > 0.0);
        irregular.map_or(self.system, |system| SystemChoice::Of(system.description()))
    }
}

impl Default for Layer {
    fn default() -> Self {
        Self {
            name: String::new(),
            system: SystemChoice::Auto,
            after: After::Between,
            visible: true,
            seed: None,
            strokes: Vec::new(),
            on_model: Vec::new(),
            far_spacing: None,
            options: LayerOptions::default(),
            points: None,
            tone: None,
            maps: LayerMaps::default(),
            colours: None,
        }
    }
}

/// A layer's options beyond its marks; [`layer_rules`] says which of them go with which layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LayerOptions {
    /// Random differences between its spots.
    pub spread: SpreadChoice,
    /// Stripe ÷ period.
    pub duty: DutyChoice,
    /// The share of each ring of an `around` layer that is open, 0..[`limits::BROKEN`].
    pub broken: f64,
    /// The distance from the marks beneath at which the marks of a `near` layer are 1/e as frequent as beside them, px: [`limits::NEAR`].
    pub near: f64,
    /// Irregularity of its spots, 0–1.
    pub irregular: f64,
    /// Whether the drawn marks are among those that grow; `None` = see [`Document::keeps_marks`].
    pub keep: Option<bool>,
    /// Initial state of its stripes.
    pub seeding: Seeding,
    /// How much the width of its stripes varies along them, 0–[`limits::VARY`]: standard deviation ÷ mean.
    pub vary: f64,
    /// The share of its stripes that open into two, 0–1.
    pub double: f64,
    /// Raggedness of its patches, or of the edges of its spots and stripes.
    pub ragged: RaggedChoice,
    /// Points from which a patch is made, [`limits::DETAIL`]: the more, the finer its fringes; or a streak: the more, the longer it is.
    pub detail: f64,
    /// Width of the lines between its cells.
    pub gap: GapChoice,
    /// What its patches are as rosettes; `None` = they are solid.
    pub rosette: Option<Rosettes>,
    /// Decrease of the gain of its stucco, 0–[`limits::DECAY`]: 1 − the last ÷ the first. The larger, the fewer worms beside dots.
    pub decay: f64,
    /// Rule that tells which threads of its weave lie over the others.
    pub over: Over,
}

impl LayerOptions {
    /// Width of the stripes ÷ their period where neither the drawn lines nor the options say anything else.
    pub const DUTY: f64 = 0.5;
}

impl Default for LayerOptions {
    fn default() -> Self {
        Self {
            spread: SpreadChoice::default(),
            duty: DutyChoice::default(),
            broken: 0.0,
            near: 24.0,
            irregular: 0.0,
            keep: None,
            seeding: Seeding::Noise,
            vary: 0.0,
            double: 0.0,
            ragged: RaggedChoice::Drawn,
            detail: Patches::DETAIL,
            gap: GapChoice::Drawn,
            rosette: None,
            decay: Stucco::DECAY,
            over: Over::Level,
        }
    }
}

/// A value that either follows from the drawn marks or is given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum DrawnOr<T> {
    /// The value follows from the drawn marks.
    #[default]
    Drawn,
    /// This everywhere, whatever was drawn.
    Given(T),
}

impl<T> DrawnOr<T> {
    /// The given value; `None` for [`Self::Drawn`].
    #[must_use]
    pub fn given(self) -> Option<T> {
        if let Self::Given(value) = self { Some(value) } else { None }
    }
}

/// Raggedness of the edges of a layer. It follows from the drawn outlines (ellipses are smooth; spots and stripes keep the edges
/// that they grow) or is given, 0–[`limits::RAGGED`]: the standard deviation σ of the logarithm of the distance by which patches
/// claim their points. Edges of spots and stripes get the same increase of raggedness over smooth ones.
pub type RaggedChoice = DrawnOr<f64>;

/// Width of the lines between the cells of a layer, px, [`limits::GAP`]. It follows from the gaps between drawn outlines that
/// nearly touch, or is given.
pub type GapChoice = DrawnOr<f64>;

/// Random differences between the spots of a layer. They follow from the marks of a region, if these are at least six (otherwise
/// there are none), or are given.
pub type SpreadChoice = DrawnOr<Spread>;

/// Share of their period that the stripes of a layer cover. It follows from drawn lines that lie side by side, with regions
/// separately for each ([`LayerOptions::DUTY`] if no lines do), or is given, 0.18–0.82.
pub type DutyChoice = DrawnOr<f64>;

/// One drawn stroke.
#[derive(Clone, Debug, PartialEq)]
pub enum Stroke {
    /// A spot.
    Ellipse(Ellipse),
    /// A straight piece of a stripe.
    Line(Line),
    /// A piece of a stripe that may bend.
    Path(Path),
    /// A freehand stroke: if closed, an ellipse; if open, a path, or a line if it is straight. It is fitted when the
    /// document is grown.
    Freehand {
        /// Points in the order in which they were drawn, px; at least two.
        points: Vec<[f64; 2]>,
        /// Width of the pen, px: that of the line or path.
        width: f64,
    },
    /// A patch as it was drawn.
    Outline(Outline),
    /// A spot that was drawn as an outline and is read as the ellipse that fits it. Patches and cells grow the outline.
    Fitted {
        /// The ellipse.
        ellipse: Ellipse,
        /// The drawn outline.
        outline: Outline,
    },
}

impl Stroke {
    /// Width of a line, a path or a freehand stroke that states none, px.
    pub const WIDTH: f64 = 6.0;

    /// The mark of the stroke; a mark is fitted to a freehand stroke. `None` for a freehand stroke that is no mark.
    #[must_use]
    pub fn mark(&self) -> Option<Mark> {
        match self {
            Self::Ellipse(ellipse) | Self::Fitted { ellipse, .. } => Some(Mark::Ellipse(*ellipse)),
            Self::Line(line) => Some(Mark::Line(*line)),
            Self::Path(path) => Some(Mark::Path(path.clone())),
            Self::Freehand { points, width } => recognise(points, *width),
            Self::Outline(outline) => ellipse_of_outline(&outline.points).map(Mark::Ellipse),
        }
    }

    /// The stroke that stands for `mark` instead: an outline, also that of a closed freehand stroke, is moved, rotated and stretched as
    /// its ellipse was to become that of `mark`; other strokes become the mark.
    #[must_use]
    pub fn changed(&self, mark: Mark) -> Self {
        let before = self.mark();
        if before.as_ref() == Some(&mark) {
            return self.clone();
        }
        let (Some(Mark::Ellipse(from)), Mark::Ellipse(to)) = (before, &mark) else { return Self::from(mark) };
        match self {
            Self::Outline(outline) => Self::Outline(outline.carried(&from, to)),
            Self::Fitted { outline, .. } => {
                Self::Fitted { ellipse: *to, outline: outline.carried(&from, to) }
            }
            Self::Freehand { points, .. } => match Outline::closed(points) {
                Some(outline) => Self::Fitted { ellipse: *to, outline: outline.carried(&from, to) },
                None => Self::Ellipse(*to),
            },
            Self::Ellipse(_) | Self::Line(_) | Self::Path(_) => Self::from(mark),
        }
    }

    /// The kind of the mark; `None` for a freehand stroke, which must be fitted first.
    #[must_use]
    pub fn kind(&self) -> Option<Kind> {
        match self {
            Self::Ellipse(_) | Self::Outline(_) | Self::Fitted { .. } => Some(Kind::Ellipse),
            Self::Line(_) | Self::Path(_) => Some(Kind::Line),
            Self::Freehand { .. } => None,
        }
    }
}

impl From<Mark> for Stroke {
    fn from(mark: Mark) -> Self {
        match mark {
            Mark::Ellipse(ellipse) => Self::Ellipse(ellipse),
            Mark::Line(line) => Self::Line(line),
            Mark::Path(path) => Self::Path(path),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layer_without_a_seed_gets_splitmix64_of_the_documents() {
        let document = Document { seed: 0, layers: vec![Layer::default(); 3], ..Document::default() };
        // The first outputs of SplitMix64 from 0, as published with the generator.
        assert_eq!(document.layer_seed(0), 0xe220_a839_7b1d_cdaf);
        assert_eq!(document.layer_seed(1), 0x6e78_9e6a_a1b9_65f4);
        assert_eq!(document.layer_seed(2), 0x06c4_5d18_8009_454f);
    }

    #[test]
    fn a_layer_keeps_its_own_seed() {
        let layer = Layer { seed: Some(7), ..Layer::default() };
        let document = Document { layers: vec![layer], ..Document::default() };
        assert_eq!(document.layer_seed(0), 7);
    }
}
