//! What the pointer is doing on the canvas, from press to release.

use super::handles::{self, Handle};
use super::tool::Tool;
use crate::editor::selection::{Place, Selection};
use crate::editor::session::Session;
use crate::editor::shape;
use crate::marks::{Ellipse, Line, Mark};
use crate::sketch::recognise;

/// A drag shorter than this is a click, points.
const CLICK: f64 = 3.0;

/// What the pointer is doing.
#[derive(Clone, Debug)]
pub enum Gesture {
    /// It draws; the points so far, px.
    Pen(Vec<[f64; 2]>),
    /// It drags an ellipse from corner to corner.
    Ellipse([[f64; 2]; 2]),
    /// It drags a line.
    Line([[f64; 2]; 2]),
    /// It drags a box around what shall be selected, beside what was.
    Box([[f64; 2]; 2], Selection),
    /// It moves what is selected.
    Move {
        /// Where it was pressed.
        from: [f64; 2],
        /// What is moved, as it was.
        marks: Vec<(Place, Mark)>,
        /// What was pressed on.
        on: Place,
        /// Has it moved?
        moved: bool,
    },
    /// It pulls a handle.
    Pull(Handle, [f64; 2], Vec<(Place, Mark)>),
    /// It rubs out; where it was last.
    Erase([f64; 2]),
    /// It moves the view.
    Pan,
}

/// The hand: where it is and what it holds.
#[derive(Clone, Copy, Debug)]
pub struct Hand {
    /// The place on the canvas, px.
    pub at: [f64; 2],
    /// Points on the screen a px of the canvas.
    pub zoom: f64,
    /// Shift: even, in steps, more.
    pub shift: bool,
    /// Alt: a copy.
    pub alt: bool,
}

/// What new marks are made with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nib {
    /// Width of lines, px.
    pub width: f64,
    /// Radii of the ellipse that a click makes, px.
    pub radii: [f64; 2],
}

impl Default for Nib {
    /// The default width of a document's lines; the paper's round spot of 300 px².
    fn default() -> Self {
        Self { width: 6.0, radii: [9.8, 9.8] }
    }
}

/// The pointer goes down.
pub fn press(tool: Tool, session: &mut Session, handle: Option<Handle>, hand: Hand) -> Gesture {
    match tool {
        Tool::Hand => Gesture::Pan,
        Tool::Pen => Gesture::Pen(vec![hand.at]),
        Tool::Ellipse => Gesture::Ellipse([hand.at; 2]),
        Tool::Line => Gesture::Line([hand.at; 2]),
        Tool::Eraser => {
            erase(session, [hand.at; 2], hand.zoom);
            Gesture::Erase(hand.at)
        }
        Tool::Select => match handle {
            Some(handle) => Gesture::Pull(handle, hand.at, session.selected().collect()),
            None => select(session, hand),
        },
    }
}

fn select(session: &mut Session, hand: Hand) -> Gesture {
    let Some(on) = session.hit(hand.at, 6.0 / hand.zoom) else {
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
    if hand.alt {
        let copies: Vec<Mark> = session.selected().map(|(_, mark)| mark).collect();
        session.add(&copies);
    }
    Gesture::Move { from: hand.at, marks: session.selected().collect(), on, moved: false }
}

impl Gesture {
    /// The pointer moves.
    pub fn advance(&mut self, session: &mut Session, hand: Hand) {
        match self {
            Self::Pan => {}
            Self::Pen(points) => {
                // Finer than half a point on the screen is noise.
                let far = points
                    .last()
                    .is_none_or(|last| (last[0] - hand.at[0]).hypot(last[1] - hand.at[1]) * hand.zoom > 0.5);
                if far {
                    points.push(hand.at);
                }
            }
            Self::Ellipse(ends) => ends[1] = if hand.shift { squared(ends[0], hand.at) } else { hand.at },
            Self::Line(ends) => {
                ends[1] = if hand.shift { handles::straightened(ends[0], hand.at) } else { hand.at };
            }
            Self::Box(ends, before) => {
                ends[1] = hand.at;
                let mut selection = before.clone();
                selection.add(within(session, *ends));
                session.selection = selection;
            }
            Self::Move { from, marks, moved, .. } => {
                let by = [hand.at[0] - from[0], hand.at[1] - from[1]];
                *moved |= by[0].hypot(by[1]) * hand.zoom > CLICK;
                if *moved {
                    let by = session.limit_move(marks, by);
                    let there: Vec<_> =
                        marks.iter().map(|(place, mark)| (*place, shape::moved(mark, by))).collect();
                    session.replace(&there);
                }
            }
            Self::Pull(handle, from, marks) => {
                session.replace(&handles::pulled(*handle, marks, [*from, hand.at], hand.shift));
            }
            Self::Erase(last) => {
                erase(session, [*last, hand.at], hand.zoom);
                *last = hand.at;
            }
        }
    }

    /// The pointer goes up. Gives the stroke that shall fade away, if one was recognised.
    pub fn release(self, session: &mut Session, nib: &mut Nib, hand: Hand) -> Option<Vec<[f64; 2]>> {
        let far = |[from, to]: [[f64; 2]; 2]| (to[0] - from[0]).hypot(to[1] - from[1]) * hand.zoom > CLICK;
        match self {
            Self::Pen(points) => {
                let mark =
                    recognise(&points, nib.width).filter(|_| points.iter().any(|p| far([points[0], *p])))?;
                session.add(&[mark]);
                return Some(points);
            }
            Self::Ellipse(ends) if far(ends) => {
                if let Some(ellipse) = between(ends) {
                    nib.radii = ellipse.radii;
                    session.add(&[Mark::Ellipse(ellipse)]);
                }
            }
            Self::Ellipse([at, _]) => {
                session.add(&[Mark::Ellipse(Ellipse { center: at, radii: nib.radii, angle: 0.0 })]);
            }
            Self::Line(ends) if far(ends) => session.add(&[Mark::Line(line(ends, nib.width))]),
            Self::Box(ends, _) if !far(ends) && !hand.shift => {
                // A frozen mark that is clicked on is frozen no more.
                if let Some(place) = session.hit_frozen(hand.at, 6.0 / hand.zoom) {
                    session.activate_layer(place.layer);
                    session.selection = Selection::new([place]);
                }
            }
            Self::Box(..) => {
                let mut layers = session.selection.places().map(|place| place.layer);
                if let Some(first) = layers.next().filter(|first| layers.all(|layer| layer == *first)) {
                    session.active_layer = first;
                }
            }
            Self::Move { on, moved: false, .. } if !hand.shift && !hand.alt => {
                session.selection = Selection::new([on]);
            }
            _ => {}
        }
        None
    }

    /// What would be made if the pointer went up now.
    #[must_use]
    pub fn preview(&self, nib: &Nib) -> Option<Mark> {
        match self {
            Self::Ellipse(ends) => between(*ends).map(Mark::Ellipse),
            Self::Line(ends) if ends[0] != ends[1] => Some(Mark::Line(line(*ends, nib.width))),
            _ => None,
        }
    }
}

fn line([from, to]: [[f64; 2]; 2], width: f64) -> Line {
    Line { from, to, width }
}

/// The ellipse in an upright box. Its first radius is the longer one.
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

/// The marks with their middle in a box.
fn within(session: &Session, [from, to]: [[f64; 2]; 2]) -> Vec<Place> {
    let inside = |point: [f64; 2]| {
        (0..2).all(|axis| from[axis].min(to[axis]) <= point[axis] && point[axis] <= from[axis].max(to[axis]))
    };
    session.editable_marks().filter(|(_, mark)| inside(shape::center(mark))).map(|(place, _)| place).collect()
}

/// Takes away what the eraser touches on its way.
fn erase(session: &mut Session, [from, to]: [[f64; 2]; 2], zoom: f64) {
    /// Half the eraser's breadth, points.
    const REACH: f64 = 5.0;
    let length = (to[0] - from[0]).hypot(to[1] - from[1]) * zoom;
    let steps = (length / REACH).ceil().max(1.0) as usize;
    let mut gone: Vec<Place> = Vec::new();
    for step in 0..=steps {
        let t = step as f64 / steps as f64;
        let at = [0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis]));
        gone.extend(session.hit(at, REACH / zoom));
    }
    gone.sort_unstable();
    gone.dedup();
    if !gone.is_empty() {
        session.remove(&gone);
    }
}
