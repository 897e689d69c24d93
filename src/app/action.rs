//! All that one can do, whatever button, menu or key it is asked by.

use std::path::PathBuf;

use super::canvas::tool::Tool;
use super::panels::Tab;
use crate::editor::layer_action::LayerAction;

/// Something to be done.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Ask what the new document shall be.
    New,
    /// Ask which document to open.
    Open,
    /// Open this one.
    OpenFile(PathBuf),
    /// Open the example with this name.
    Example(&'static str),
    /// Save.
    Save,
    /// Ask where to save.
    SaveAs,
    /// Ask what to export, and how.
    Export,
    /// Ask for an SVG that becomes a document.
    Import,
    /// Ask for a palette whose colours the layer at hand takes.
    OpenPalette,
    /// Ask where to save the colours of the layer at hand.
    SavePalette,
    /// Close the window.
    Quit,
    /// Undo the last step.
    Undo,
    /// Do it again.
    Redo,
    /// Copy what is selected, and take it away.
    Cut,
    /// Copy what is selected.
    Copy,
    /// Put down what was copied, as text.
    Paste(String),
    /// Put down a copy of what is selected.
    Duplicate,
    /// Take away what is selected.
    Delete,
    /// Select all.
    SelectAll,
    /// Select nothing, let go of what is being drawn.
    Escape,
    /// Select the next mark (1) or the one before (−1).
    Next(isize),
    /// Move what is selected, px.
    Nudge([f64; 2]),
    /// Turn what is selected, degrees.
    Turn(f64),
    /// Make what is selected larger or smaller.
    Scale(f64),
    /// Put an ellipse (true) or a line (false) into the middle of what is seen.
    Insert(bool),
    /// Take a tool.
    Tool(Tool),
    /// Show the whole canvas.
    Fit,
    /// One px of the canvas a px of the screen.
    ActualSize,
    /// Zoom by this factor.
    Zoom(f32),
    /// Side by side, or one over the other.
    Over(bool),
    /// Two by two tiles.
    Tiled(bool),
    /// Show the region grid.
    Regions(bool),
    /// Show what is seen in the sketch.
    Analysis(bool),
    /// Ask for a picture to lie under the canvas.
    Reference,
    /// Pause, or go on.
    Pause,
    /// Stop growing.
    Stop,
    /// Grow again.
    Grow,
    /// Another seed.
    AnotherSeed,
    /// Do something to a layer.
    Layer(LayerAction),
    /// Show this in the column.
    Tab(Tab),
    /// Open this recovered document.
    Restore(String),
    /// Forget what was lost for good; which.
    Discard(String),
    /// Draw what can be reached in this region (column, row) of a layer of the finished document.
    Reach(usize, [usize; 2]),
    /// Show the training cloud about a region of a layer, or hide it.
    Cloud(Option<(usize, [usize; 2])>),
    /// Show the strip of alternatives, or hide it.
    Alternatives(bool),
    /// Whichever it is not.
    ToggleAlternatives,
    /// Open this alternative.
    TakeAlternative(u64),
    /// Keep this alternative (true), or let it go.
    KeepAlternative(u64, bool),
    /// Give up growing alternatives (true), or go on.
    StopAlternatives(bool),
    /// Show or hide a page.
    Page(Page),
}

/// A page over the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    /// How to begin.
    Hint,
    /// Examples, as pictures.
    Examples,
    /// Keys.
    Shortcuts,
    /// What this is, and whence.
    About,
    /// What was not saved when dapple was last closed.
    Recovery,
    /// How dapple shall be.
    Preferences,
}
