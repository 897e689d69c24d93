//! The tools.

use std::borrow::Cow;

use crate::app::icons::Icon;

/// What the pointer does on the canvas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Tool {
    /// Selects, moves, resizes, turns.
    Select,
    /// Draws freehand: a closed stroke becomes an ellipse, an open one a line.
    #[default]
    Pen,
    /// Draws an ellipse by dragging.
    Ellipse,
    /// Draws a line by dragging.
    Line,
    /// Deletes the marks that it touches.
    Eraser,
    /// Draws strokes that hair and scales follow.
    Comb,
    /// Moves the view.
    Hand,
}

impl Tool {
    /// All tools, in order.
    pub const ALL: [Self; 7] =
        [Self::Select, Self::Pen, Self::Ellipse, Self::Line, Self::Eraser, Self::Comb, Self::Hand];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Select => "Select",
            Self::Pen => "Freehand",
            Self::Ellipse => "Ellipse",
            Self::Line => "Line",
            Self::Eraser => "Eraser",
            Self::Comb => "Comb",
            Self::Hand => "Pan",
        }
    }

    /// How it is used. `closed`: what a closed stroke becomes, with its article.
    #[must_use]
    pub fn help(self, closed: &str) -> Cow<'static, str> {
        Cow::Borrowed(match self {
            Self::Select => {
                "Click a mark, or drag a box around several; Shift adds to the selection. Drag to move; drag \
                 the handles to resize and turn. Alt-drag or Ctrl-drag makes a copy."
            }
            Self::Pen => {
                return format!(
                    "Draw with the pointer: a closed stroke becomes {closed}, an open one a line."
                )
                .into();
            }
            Self::Ellipse => {
                "Drag from corner to corner; Shift makes a circle. Click to add one like the last."
            }
            Self::Line => "Drag from end to end; Shift limits the angle to steps of 15°.",
            Self::Eraser => "Drag over marks to erase them.",
            Self::Comb => {
                "Drag from head to tail: hair and scales follow the stroke, and turn between strokes. Alt-drag or Ctrl-drag \
                 erases strokes."
            }
            Self::Hand => "Drag the view. With any tool: drag with the middle button, or hold Space.",
        })
    }

    /// Its icon.
    #[must_use]
    pub fn icon(self) -> Icon {
        match self {
            Self::Select => Icon::Arrow,
            Self::Pen => Icon::Pen,
            Self::Ellipse => Icon::Ellipse,
            Self::Line => Icon::Line,
            Self::Eraser => Icon::Eraser,
            Self::Comb => Icon::Comb,
            Self::Hand => Icon::Hand,
        }
    }
}
