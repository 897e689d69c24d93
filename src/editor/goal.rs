//! What a layer can become, in words of what it looks like: the change of the document that leads there, or what is missing.

use crate::attributes::system::{Description, Family};
use crate::document::layer_rules::{Beneath, Combination, Rule, tidy};
use crate::document::sketch_notes::crossing_strokes;
use crate::document::systems::{POINTS, TURING_GROWTH};
use crate::document::{
    After, AreaKind, Document, Kind, Layer, LineKind, PairKind, Points, Stroke, System, SystemChoice, Tone,
    ToneImage, limits,
};
use crate::editor::layer_choices::{as_beneath, beneath};
use crate::editor::session::Session;
use crate::marks::{Line, Mark, turn};
use crate::synth::import::tone;

/// Lines whose directions differ by more than this, degrees, have two directions; a maze takes nearer ones as one.
const TWO_DIRECTIONS: f64 = 20.0;
/// The width of added rings and of an added net ÷ the mean smaller radius of the spots.
const RING: f64 = 0.45;
/// The share of the canvas that is dark in a field of points.
const DARK: f64 = 0.42;
/// The distance of the points of such a field ÷ the mean radius of the marks: several points of the same value are a blotch.
const POINTS_A_RADIUS: f64 = 0.6;
/// Where the line begins that stands for added rings or an added net: its distance from the left and the lower border, as a share of the canvas; and
/// its length, in its widths.
const RING_LINE: (f64, f64) = (0.05, 4.0);

/// What a layer can become.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Goal {
    /// Spots as far apart as drawn.
    Spots,
    /// Spots as close to each other as they grow.
    DenseSpots,
    /// A smaller spot in each spot beneath.
    Inside,
    /// Rings around the spots beneath.
    Rings,
    /// A net between the spots beneath.
    Net,
    /// Cells side by side.
    Cells,
    /// Blotches with outlines like the drawn ones.
    Patches,
    /// Stripes.
    Stripes,
    /// Stripes that end and begin anew.
    Tips,
    /// Ragged stripes with ends.
    Streaks,
    /// Threads that cross.
    Weave,
    /// Straight pieces that meet.
    Maze,
    /// A net of lines.
    Cracks,
    /// Dots and worms.
    DotsAndWorms,
    /// Worms alone.
    Worms,
    /// Dark and light fields of scattered points.
    Blotches,
    /// Marks that follow the tone of a picture.
    Tone,
}

/// A goal for a layer: the document in which the layer is it, or what is missing, in a few words and in a sentence.
#[derive(Clone, Debug, PartialEq)]
pub struct Offer {
    /// The goal.
    pub goal: Goal,
    /// The document, as [`Session::finished`] would give it, or what is missing.
    pub outcome: Result<Document, [&'static str; 2]>,
}

impl Goal {
    /// The goals of a layer of ellipses.
    const OF_ELLIPSES: [Self; 11] = [
        Self::Spots,
        Self::DenseSpots,
        Self::Cells,
        Self::Patches,
        Self::Rings,
        Self::Net,
        Self::Inside,
        Self::DotsAndWorms,
        Self::Worms,
        Self::Blotches,
        Self::Tone,
    ];
    /// The goals of a layer of lines.
    const OF_LINES: [Self; 11] = [
        Self::Stripes,
        Self::Tips,
        Self::Streaks,
        Self::Weave,
        Self::Maze,
        Self::Cracks,
        Self::Rings,
        Self::Net,
        Self::DotsAndWorms,
        Self::Worms,
        Self::Tone,
    ];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Spots => "Spots",
            Self::DenseSpots => "Dense spots",
            Self::Inside => "Spots inside",
            Self::Rings => "Rings",
            Self::Net => "Net",
            Self::Cells => "Cells",
            Self::Patches => "Patches",
            Self::Stripes => "Stripes",
            Self::Tips => "Stripes, tips",
            Self::Streaks => "Streaks",
            Self::Weave => "Weave",
            Self::Maze => "Maze",
            Self::Cracks => "Cracks",
            Self::DotsAndWorms => "Dots, worms",
            Self::Worms => "Worms",
            Self::Blotches => "Blotches",
            Self::Tone => "Tone",
        }
    }

    /// What grows, in a sentence.
    #[must_use]
    pub const fn help(self) -> &'static str {
        match self {
            Self::Spots => "Spots of the drawn size, shape and direction, as far apart as they are drawn",
            Self::DenseSpots => "Spots of the drawn size, as close to each other as they can grow",
            Self::Inside => "A smaller spot in each spot of the layer beneath, which itself is not shown",
            Self::Rings => "Rings around the spots, as on a leopard",
            Self::Net => "A connected net in the space between the spots, as on a giraffe",
            Self::Cells => {
                "Cells of the drawn size side by side, with thin lines between them, as on a reptile"
            }
            Self::Patches => "Blotches with outlines like the drawn ones, as on a cow",
            Self::Stripes => "Stripes of the drawn width that follow the drawn lines",
            Self::Tips => "Stripes that end in tips and begin anew, as on a zebra",
            Self::Streaks => "Ragged stripes with ends, as on a tiger",
            Self::Weave => "Threads along the drawn lines that cross each other",
            Self::Maze => "Straight pieces of the drawn directions that meet and never cross",
            Self::Cracks => "A net of lines in all directions, as in dry mud",
            Self::DotsAndWorms => "Dots and worms in all directions, as wide as the drawn marks",
            Self::Worms => "Worms in all directions, as wide as the drawn marks",
            Self::Blotches => "Dark and light fields of scattered points, as large as the drawn marks",
            Self::Tone => {
                "Marks that are wide where a picture is dark and narrow where it is light. Here the picture is a ball; \
                 a click asks for yours"
            }
        }
    }

    /// The system that grows it, by the name that it has in the list of systems.
    #[must_use]
    pub fn system(self) -> &'static str {
        match self {
            Self::Tone => "the system of the marks, driven by a picture",
            Self::Rings | Self::Net => {
                System::first(|system| system.along_curves).map_or("", |system| system.description().title)
            }
            _ => self.choice().title(),
        }
    }

    fn choice(self) -> SystemChoice {
        let first = |property: fn(&Description) -> bool| {
            System::first(property)
                .map_or(SystemChoice::Auto, |system| SystemChoice::Of(system.description()))
        };
        match self {
            Self::Spots | Self::Inside => first(|system| system.fixed_places),
            Self::DenseSpots => first(|system| system.irregular),
            Self::Rings | Self::Net | Self::Tone => SystemChoice::Auto,
            Self::Stripes => SystemChoice::Stripes,
            Self::Cells => SystemChoice::Of(AreaKind::Polygons.description()),
            Self::Patches => SystemChoice::Of(AreaKind::Patches.description()),
            Self::Streaks => SystemChoice::Of(LineKind::Streaks.description()),
            Self::Cracks => SystemChoice::Of(LineKind::Cracks.description()),
            Self::Tips => SystemChoice::Of(PairKind::Stripes.description()),
            Self::Weave => SystemChoice::Of(PairKind::Weave.description()),
            Self::Maze => SystemChoice::Of(PairKind::Maze.description()),
            Self::DotsAndWorms => SystemChoice::Of(PairKind::Stucco.description()),
            Self::Worms => SystemChoice::Of(TURING_GROWTH),
            Self::Blotches => SystemChoice::Of(&POINTS),
        }
    }

    const fn after(self) -> After {
        match self {
            Self::Rings => After::Around,
            Self::Net => After::Net,
            Self::Inside => After::Inside,
            _ => After::Between,
        }
    }

    /// What `layer` is now, where `system` has grown it.
    #[must_use]
    pub fn of_layer(layer: &Layer, system: &'static Description) -> Option<Self> {
        let all = Self::OF_ELLIPSES.into_iter().chain(Self::OF_LINES);
        match layer.after {
            _ if layer.tone.is_some() => Some(Self::Tone),
            After::Around => Some(Self::Rings),
            After::Net => Some(Self::Net),
            After::Inside => Some(Self::Inside),
            After::Between | After::Near if system.kind == Family::Marks && system.is_striped() => {
                Some(Self::Stripes)
            }
            After::Between | After::Near => all
                .into_iter()
                .filter(|goal| goal.after() == After::Between)
                .find(|goal| goal.choice() == SystemChoice::Of(system)),
        }
    }

    /// The goals of the active layer of `session`; `now` is what it is now, and stays as it is. Empty where nothing is drawn on it.
    #[must_use]
    pub fn offers(session: &Session, now: Option<Self>) -> Vec<Offer> {
        let layer = session.active_layer;
        let all = match session.kind(layer) {
            Some(Kind::Ellipse) => Self::OF_ELLIPSES,
            Some(Kind::Line) => Self::OF_LINES,
            None => return Vec::new(),
        };
        let finished = session.finished();
        let blank = session.document().layers.iter().take(layer).filter(|layer| layer.is_blank()).count();
        let offer = |goal: Self| {
            if Some(goal) == now {
                return Some(Offer { goal, outcome: Ok(finished.clone()) });
            }
            let outcome = match goal.missing(session, layer)? {
                Some(missing) => Err(missing),
                None => {
                    let mut document = finished.clone();
                    goal.apply(&mut document, layer - blank, &session.marks_of(layer));
                    Ok(document)
                }
            };
            Some(Offer { goal, outcome })
        };
        all.into_iter().filter_map(offer).collect()
    }

    /// What the layer lacks, in a few words and in a sentence; `Some(None)` where it lacks nothing, `None` where its marks
    /// cannot be this at all.
    fn missing(self, session: &Session, layer: usize) -> Option<Option<[&'static str; 2]>> {
        let document = session.document();
        let marks = &session.fitted_marks()[layer];
        if self.adds_a_layer(&session.marks_of(layer)) {
            return Self::has_room_above(session, layer).then_some(None);
        }
        if self == Self::Weave && crossing_strokes(marks).is_empty() {
            return Some(Some(["needs lines that cross", "Draw a line across the others."]));
        }
        if self == Self::Maze && !has_two_directions(marks) {
            return Some(Some(["needs lines in two directions", "Draw a line in another direction, too."]));
        }
        match self.broken_rule(&document.layers[layer], session.kind(layer), beneath(session, layer)) {
            None => Some(None),
            Some(rule) if self.after() != After::Between => {
                Some(Some(["needs spots on a layer beneath", rule.reason]))
            }
            Some(rule) if session.beneath(layer).is_some() && matches!(self, Self::Tone | Self::Worms) => {
                Some(Some(["only on the lowest layer", rule.reason]))
            }
            Some(_) => None,
        }
    }

    /// The rule that keeps a layer from being this.
    fn broken_rule(self, layer: &Layer, kind: Option<Kind>, beneath: Beneath) -> Option<&'static Rule> {
        let mut changed = layer.clone();
        self.set(&mut changed);
        let untidy = Combination::new(&changed, kind, beneath);
        // A picture drives the system of the layer, or else the automatic one.
        let by_system = || untidy.against_system(changed.system).filter(|_| self != Self::Tone);
        let rule = untidy.against_after(changed.after).or_else(by_system);
        tidy(&mut changed, kind);
        rule.or_else(|| Combination::new(&changed, kind, beneath).broken_rule())
    }

    /// Whether a layer of rings or a net can be added above a layer: nothing else is above it.
    fn has_room_above(session: &Session, layer: usize) -> bool {
        let layers = &session.document().layers;
        layers[layer + 1..].iter().all(Layer::is_blank) && layers.len() < limits::MAX_LAYERS
    }

    /// Whether it is a layer of its own above these marks: rings around ellipses.
    fn adds_a_layer(self, marks: &[Mark]) -> bool {
        let is_of_lines = matches!(self.after(), After::Around | After::Net);
        is_of_lines && marks.iter().all(|mark| mark.ellipse().is_some())
    }

    /// Changes `document` so that layer `index`, whose marks are given, becomes this. Gives the layer that is it then.
    pub fn apply(self, document: &mut Document, index: usize, marks: &[Mark]) -> usize {
        if self.adds_a_layer(marks) {
            // They grow around spots.
            let beneath = &mut document.layers[index];
            let kind = Some(Kind::Ellipse);
            if as_beneath(beneath, beneath.areas(), kind) != Beneath::Grows(Kind::Ellipse) {
                Self::Spots.set(beneath);
                tidy(beneath, kind);
            }
            let stroke = Stroke::Line(ring_line(document.size, marks));
            let layer = Layer { after: self.after(), strokes: vec![stroke], ..Layer::default() };
            document.layers.insert(index + 1, layer);
            return index + 1;
        }
        self.set(&mut document.layers[index]);
        if let (Self::Tone, Some(image)) = (self, ball()) {
            tone::drive(document, image);
        }
        tidy(&mut document.layers[index], Kind::of_layer(marks.iter().map(Kind::from)));
        index
    }

    fn set(self, layer: &mut Layer) {
        let stays = layer.after == After::Near && self.after() == After::Between;
        layer.after = if stays { After::Near } else { self.after() };
        layer.tone = ball().filter(|_| self == Self::Tone).map(Tone::new);
        layer.points = (self == Self::Blotches).then(|| blotches(&layer.strokes));
        layer.system = if self == Self::Tone { layer.system } else { self.choice() };
    }
}

fn has_two_directions(marks: &[Option<Mark>]) -> bool {
    let angles: Vec<f64> =
        marks.iter().flatten().filter_map(Mark::path).filter_map(|path| direction(&path)).collect();
    angles.iter().any(|angle| turn(*angle, angles[0]).abs() > TWO_DIRECTIONS)
}

/// The direction from end to end.
fn direction(path: &crate::marks::Path) -> Option<f64> {
    let (from, to) = (*path.points.first()?, *path.points.last()?);
    Some((to[1] - from[1]).atan2(to[0] - from[0]).to_degrees())
}

/// The line that stands for rings or a net around spots: their width follows from that of the line, its place is of no importance.
fn ring_line(size: [u32; 2], marks: &[Mark]) -> Line {
    let radii = marks.iter().filter_map(Mark::ellipse).map(|ellipse| ellipse.radii[0].min(ellipse.radii[1]));
    let width = (RING * radii.sum::<f64>() / marks.len().max(1) as f64).max(1.0);
    let width = (10.0 * width).round() / 10.0;
    let (share, long) = RING_LINE;
    let [w, h] = size.map(f64::from);
    let from = [share * w, (1.0 - share) * h].map(f64::round);
    Line { from, to: [(from[0] + long * width).round(), from[1]], width }
}

/// A field of points whose blotches are about as large as the marks.
fn blotches(strokes: &[Stroke]) -> Points {
    let ellipses: Vec<_> = strokes.iter().filter_map(|stroke| stroke.mark()?.ellipse()).collect();
    let radii = ellipses.iter().map(|ellipse| (ellipse.radii[0] * ellipse.radii[1]).sqrt());
    let mean = radii.sum::<f64>() / ellipses.len().max(1) as f64;
    let range = limits::POINT_DISTANCE;
    let distance = (POINTS_A_RADIUS * mean).round().clamp(range.low, range.high);
    Points { distance: Some([distance; 2]), share: Some(DARK), axis: 1.5, ..Points::default() }
}

/// The picture that stands for the user's: a ball that is lit from the left.
fn ball() -> Option<ToneImage> {
    const SIDE: usize = 64;
    let value = |index: usize| {
        let [x, y] = [index % SIDE, index / SIDE].map(|at| (2 * at + 1) as f64 / SIDE as f64 - 1.0);
        let depth = 0.8 - x * x - y * y;
        let light =
            if depth > 0.0 { (0.75 * depth.sqrt() - 0.45 * x - 0.3 * y).clamp(0.05, 1.0) } else { 0.9 };
        (255.0 * light) as u8
    };
    let values = (0..SIDE * SIDE).map(value).collect();
    ToneImage::new([SIDE; 2], values)
}

#[cfg(test)]
mod tests;
