//! A gesture: what the pointer does on the canvas between a press and its release.

use egui::Pos2;

use super::handles::{self, Handle};
use super::reference::Part;
use super::tool::Tool;
use crate::editor::backdrop::Placement;
use crate::editor::selection::{Place, Selection};
use crate::editor::session::Session;
use crate::editor::shape;
use crate::editor::snap::Snap;
use crate::marks::{Ellipse, Line, Mark};
use crate::sketch::recognise;

/// The pointer picks a mark within this distance, points.
pub const REACH: f64 = 6.0;
/// Half the width of erasers, points.
const ERASER: f64 = 5.0;
/// A drag shorter than this is a click, points.
const CLICK: f64 = 3.0;

/// A gesture that is under way. Points are px of the canvas.
#[derive(Clone, Debug)]
pub enum Gesture {
    /// Drawing freehand: the points so far.
    Pen(Vec<[f64; 2]>),
    /// Dragging an ellipse from corner to corner of its box.
    Ellipse([[f64; 2]; 2]),
    /// Dragging a line from end to end.
    Line([[f64; 2]; 2]),
    /// Dragging a box around marks to select, in addition to those that were selected.
    Box([[f64; 2]; 2], Selection),
    /// Moving the selected marks.
    Move {
        /// Where the pointer was pressed.
        from: [f64; 2],
        /// The marks before the move.
        marks: Vec<(Place, Mark)>,
        /// The mark that was pressed.
        on: Place,
        /// Whether the pointer has moved too far for a click.
        moved: bool,
        /// Whether copies are moved.
        copied: bool,
    },
    /// Dragging a handle: the handle, where it was pressed, the marks before.
    Pull(Handle, [f64; 2], Vec<(Place, Mark)>),
    /// Combing hair: the points so far.
    Comb(Vec<[f64; 2]>),
    /// Erasing strokes of hair: the last point.
    Uncomb([f64; 2]),
    /// Erasing: the last point.
    Erase([f64; 2]),
    /// Moving or scaling the reference picture: the part that is dragged, where it was pressed, and the placement
    /// before the drag.
    Reference(Part, [f64; 2], Placement),
    /// Moving the view: the last position on the screen.
    Pan(Pos2),
}

/// The pointer and the keys that are held.
#[derive(Clone, Copy, Debug)]
pub struct Hand {
    /// Its position, px of the canvas.
    pub at: [f64; 2],
    /// Points of the screen per px of the canvas.
    pub zoom: f64,
    /// Shift is held: circles, steps of 15°, add to the selection.
    pub shift: bool,
    /// Alt or Ctrl is held: a drag makes a copy.
    pub copy: bool,
    /// The grid that marks snap to.
    pub snap: Snap,
}

impl Hand {
    /// Its position on the grid, px.
    fn snapped(&self) -> [f64; 2] {
        self.snap.at(self.at)
    }
}

/// A mark that was drawn.
#[derive(Clone, Debug)]
pub struct DrawnStroke {
    /// The mark.
    pub mark: Mark,
    /// The points of a freehand stroke.
    pub points: Vec<[f64; 2]>,
}

impl From<Mark> for DrawnStroke {
    fn from(mark: Mark) -> Self {
        Self { mark, points: Vec::new() }
    }
}

/// The size of new marks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nib {
    /// Width of lines, px.
    pub width: f64,
    /// Radii of the ellipse that a click adds, px.
    pub radii: [f64; 2],
}

impl Default for Nib {
    /// The default line width of documents, and the paper's round spot of 300 px².
    fn default() -> Self {
        Self { width: 6.0, radii: [9.8, 9.8] }
    }
}

/// Begins a gesture: the pointer is pressed at the position `on_screen`, on `handle` if there is one.
pub fn press(
    tool: Tool,
    session: &mut Session,
    handle: Option<Handle>,
    on_screen: Pos2,
    hand: Hand,
) -> Gesture {
    match tool {
        Tool::Hand => Gesture::Pan(on_screen),
        Tool::Pen => Gesture::Pen(vec![hand.at]),
        Tool::Ellipse => Gesture::Ellipse([hand.snapped(); 2]),
        Tool::Line => Gesture::Line([hand.snapped(); 2]),
        Tool::Eraser => {
            erase(session, [hand.at; 2], hand.zoom);
            Gesture::Erase(hand.at)
        }
        Tool::Comb if hand.copy => {
            session.uncomb([hand.at; 2], ERASER / hand.zoom);
            Gesture::Uncomb(hand.at)
        }
        Tool::Comb => Gesture::Comb(vec![hand.at]),
        Tool::Select => match handle {
            Some(handle) => Gesture::Pull(handle, hand.at, session.selected().collect()),
            None => select(session, hand),
        },
    }
}

fn select(session: &mut Session, hand: Hand) -> Gesture {
    let Some(on) = session.hit(hand.at, REACH / hand.zoom) else {
        let before = if hand.shift { session.selection.clone() } else { Selection::default() };
        session.selection.clone_from(&before);
        return Gesture::Box([hand.at; 2], before);
    };
    if hand.shift {
        session.selection.toggle(on);
    } else if !session.selection.contains(on) {
        session.selection = Selection::new([on]);
    }
    session.active_layer = on.layer;
    if hand.copy {
        session.add_copies_in_place();
    }
    Gesture::Move { from: hand.at, marks: session.selected().collect(), on, moved: false, copied: hand.copy }
}

impl Gesture {
    /// Continues the gesture: the pointer has moved.
    pub fn advance(&mut self, session: &mut Session, hand: Hand) {
        match self {
            Self::Pan(_) | Self::Reference(..) => {}
            Self::Pen(points) | Self::Comb(points) => {
                // A distance of less than half a point on the screen is noise.
                let far = points
                    .last()
                    .is_none_or(|last| (last[0] - hand.at[0]).hypot(last[1] - hand.at[1]) * hand.zoom > 0.5);
                if far {
                    points.push(hand.at);
                }
            }
            Self::Ellipse(ends) => {
                let at = hand.snapped();
                ends[1] = if hand.shift { squared(ends[0], at) } else { at };
            }
            Self::Line(ends) => {
                ends[1] = if hand.shift { handles::straightened(ends[0], hand.at) } else { hand.snapped() };
            }
            Self::Box(ends, before) => {
                ends[1] = hand.at;
                let mut selection = before.clone();
                selection.add(within(session, *ends));
                session.selection = selection;
            }
            Self::Move { from, marks, on, moved, .. } => {
                let by = [hand.at[0] - from[0], hand.at[1] - from[1]];
                *moved |= by[0].hypot(by[1]) * hand.zoom > CLICK;
                if *moved {
                    let by = snapped_move(marks, *on, by, hand.snap);
                    let by = session.limit_move(marks, by);
                    let there: Vec<_> =
                        marks.iter().map(|(place, mark)| (*place, shape::moved(mark, by))).collect();
                    session.replace(&there);
                }
            }
            Self::Pull(handle, from, marks) => {
                let ends = match handles::end_of(*handle, marks).filter(|_| hand.snap.on && !hand.shift) {
                    Some(end) => [end, hand.snapped()],
                    None => [*from, hand.at],
                };
                session.replace(&handles::pulled(*handle, marks, ends, hand.shift));
            }
            Self::Uncomb(last) => {
                session.uncomb([*last, hand.at], ERASER / hand.zoom);
                *last = hand.at;
            }
            Self::Erase(last) => {
                erase(session, [*last, hand.at], hand.zoom);
                *last = hand.at;
            }
        }
    }

    /// Ends the gesture: the pointer is released. Returns the mark that was drawn.
    pub fn release(self, session: &mut Session, nib: &mut Nib, hand: Hand) -> Option<DrawnStroke> {
        let far = |[from, to]: [[f64; 2]; 2]| (to[0] - from[0]).hypot(to[1] - from[1]) * hand.zoom > CLICK;
        match self {
            Self::Pen(points) => {
                let mark =
                    recognise(&points, nib.width).filter(|_| points.iter().any(|p| far([points[0], *p])))?;
                return Some(DrawnStroke { mark, points });
            }
            Self::Comb(points) if points.iter().any(|point| far([points[0], *point])) => {
                // The caller says so where the finish has no direction.
                let _ = session.comb(&points);
            }
            Self::Ellipse(ends) if far(ends) => {
                let ellipse = between(ends)?;
                nib.radii = ellipse.radii;
                return Some(Mark::Ellipse(ellipse).into());
            }
            Self::Ellipse([at, _]) => {
                return Some(Mark::Ellipse(Ellipse { center: at, radii: nib.radii, angle: 0.0 }).into());
            }
            Self::Line(ends) if far(ends) => return Some(Mark::Line(line(ends, nib.width)).into()),
            Self::Box(ends, _) if !far(ends) && !hand.shift => {
                if let Some(place) = session.hit_frozen(hand.at, REACH / hand.zoom) {
                    session.select_layer(place.layer);
                }
            }
            Self::Box(..) => {
                let mut layers = session.selection.places().map(|place| place.layer);
                if let Some(first) = layers.next().filter(|first| layers.all(|layer| layer == *first)) {
                    session.active_layer = first;
                }
            }
            // A copy that lies exactly on its original is useless.
            Self::Move { moved: false, copied: true, .. } => session.revert(),
            Self::Move { on, moved: false, .. } if !hand.shift => {
                session.selection = Selection::new([on]);
            }
            _ => {}
        }
        None
    }

    /// The mark that a release would add now; none for freehand strokes.
    #[must_use]
    pub fn preview(&self, nib: &Nib) -> Option<Mark> {
        match self {
            Self::Ellipse(ends) => between(*ends).map(Mark::Ellipse),
            Self::Line(ends) if ends[0] != ends[1] => Some(Mark::Line(line(*ends, nib.width))),
            _ => None,
        }
    }
}

/// The move `by` px, changed so that the centre of the pressed mark lies on the grid.
fn snapped_move(marks: &[(Place, Mark)], on: Place, by: [f64; 2], snap: Snap) -> [f64; 2] {
    let pressed = marks.iter().find(|(place, _)| *place == on).or(marks.first());
    let Some((_, mark)) = pressed.filter(|_| snap.on) else { return by };
    let center = shape::center(mark);
    let to = snap.at([0, 1].map(|axis| center[axis] + by[axis]));
    [0, 1].map(|axis| to[axis] - center[axis])
}

fn line([from, to]: [[f64; 2]; 2], width: f64) -> Line {
    Line { from, to, width }
}

/// The ellipse in an axis-parallel box. Its first radius is the longer one.
fn between([from, to]: [[f64; 2]; 2]) -> Option<Ellipse> {
    let center = [0, 1].map(|axis| 0.5 * (from[axis] + to[axis]));
    let [x, y] = [0, 1].map(|axis| 0.5 * (from[axis] - to[axis]).abs());
    let (radii, angle) = if x >= y { ([x, y], 0.0) } else { ([y, x], 90.0) };
    (radii[1] > 0.0).then_some(Ellipse { center, radii, angle })
}

/// `to`, moved so that the box from `from` is a square.
fn squared(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let by = [to[0] - from[0], to[1] - from[1]];
    let side = by[0].abs().max(by[1].abs());
    [0, 1].map(|axis| from[axis] + side.copysign(by[axis]))
}

/// The marks whose centre is in a box.
fn within(session: &Session, [from, to]: [[f64; 2]; 2]) -> Vec<Place> {
    let inside = |point: [f64; 2]| {
        (0..2).all(|axis| from[axis].min(to[axis]) <= point[axis] && point[axis] <= from[axis].max(to[axis]))
    };
    session.editable_marks().filter(|(_, mark)| inside(shape::center(mark))).map(|(place, _)| place).collect()
}

/// Deletes the marks that the eraser touches between two points.
fn erase(session: &mut Session, [from, to]: [[f64; 2]; 2], zoom: f64) {
    let length = (to[0] - from[0]).hypot(to[1] - from[1]) * zoom;
    let steps = (length / ERASER).ceil().max(1.0) as usize;
    let mut gone: Vec<Place> = Vec::new();
    for step in 0..=steps {
        let t = step as f64 / steps as f64;
        let at = [0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis]));
        gone.extend(session.hit(at, ERASER / zoom));
    }
    gone.sort_unstable();
    gone.dedup();
    if !gone.is_empty() {
        session.remove(&gone);
    }
}
