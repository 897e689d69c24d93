//! Everything a user can ask for, by any button, menu or key.

use std::path::PathBuf;
use std::sync::Arc;

use egui::{ColorImage, ThemePreference};

use super::canvas::Nib;
use super::canvas::tool::Tool;
use crate::editor::backdrop::Placement;
use crate::editor::edit::Edit;
use crate::editor::layer_action::LayerAction;
use crate::editor::picture_use::PictureUse;
use crate::editor::selection::Place;
use crate::editor::snap::Snap;

/// The factor by which one press of a key makes marks wider or larger.
pub const WIDER: f64 = 1.1;

/// What an empty canvas can begin with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beginning {
    /// A few ellipses.
    Spots,
    /// A few lines.
    Stripes,
    /// The marks of the example with this name.
    Example(&'static str),
    /// A field of points with the blotches of a cow.
    Cow,
    /// The canvas, the layers and the finish of the example with this name.
    Coat(&'static str),
}

/// What a user can ask for.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Ask for the properties of a new document.
    New,
    /// Ask the user which document to open.
    Open,
    /// Open this document.
    OpenFile(PathBuf),
    /// Open the document in this link.
    OpenLink(String),
    /// Read small sketches of the recently used documents.
    ReadRecent,
    /// Forget the recently used documents.
    ForgetRecent,
    /// Open the example with this name.
    Example(&'static str),
    /// Save.
    Save,
    /// Ask where to save.
    SaveAs,
    /// Open the export dialog.
    Export,
    /// Cancel the export that is being written.
    CancelExport,
    /// Ask for an SVG that becomes a document.
    Import,
    /// Ask for a photograph that becomes a document.
    ImportPhoto,
    /// Open the sketch that was made from a photograph.
    TakePhoto,
    /// Ask for a palette whose colours the active layer takes.
    OpenPalette,
    /// Ask where to save the colours of the active layer.
    SavePalette,
    /// Ask for a picture that the active layer follows.
    ChoosePicture(PictureUse),
    /// Close the window.
    Quit,
    /// Undo the last step.
    Undo,
    /// Redo the step that was undone.
    Redo,
    /// Copy the selected marks, then delete them.
    Cut,
    /// Copy the selected marks.
    Copy,
    /// Add the marks of a document or an SVG that is given as text.
    Paste(String),
    /// Take this picture as reference picture.
    PastePicture(Arc<ColorImage>),
    /// Copy the finished texture as a picture.
    CopyPicture,
    /// Copy a link that holds the document.
    CopyLink,
    /// Add a copy of the selected marks.
    Duplicate,
    /// Delete the selected marks.
    Delete,
    /// Select all marks.
    SelectAll,
    /// Select these marks.
    SelectMarks(Vec<Place>),
    /// Cancel the stroke that is being drawn; if there is none, clear the selection.
    Escape,
    /// Select the next mark (1) or the previous one (−1).
    Next(isize),
    /// Move the selected marks, px.
    Nudge([f64; 2]),
    /// Turn the selected marks, degrees.
    Turn(f64),
    /// Change the width of the selected lines and the size of the selected ellipses by a factor; where none is selected, those
    /// of new marks.
    Widen(f64),
    /// Put the centres of the selected marks on one line: the same x (0) or y (1).
    Align(usize),
    /// Make the distances between the selected marks equal, along x (0) or y (1).
    Distribute(usize),
    /// Put something on an empty canvas.
    Begin(Beginning),
    /// Ask the system for the text on the clipboard, to paste it.
    AskPaste,
    /// Open the menu of the selected marks or of the canvas, at the selection.
    ContextMenu,
    /// Scale the selected marks by a factor.
    Scale(f64),
    /// Add an ellipse (true) or a line (false) in the centre of the view.
    Insert(bool),
    /// Choose a tool.
    Tool(Tool),
    /// Set the size of new marks.
    Nib(Nib),
    /// Show the whole canvas.
    Fit,
    /// Show one px of the canvas as one px of the screen.
    ActualSize,
    /// Zoom by a factor.
    Zoom(f32),
    /// Show the column on the right, or hide it.
    Column(bool),
    /// Show the column of tools, or hide it.
    Tools(bool),
    /// Show the column on the right if it is hidden, else hide it.
    ToggleColumn,
    /// Hide all panels beside sketch and texture; where they are hidden, show them.
    TogglePanels,
    /// Fill the screen with the window; where it does, give it back its size.
    FullScreen,
    /// Show the texture over the sketch (true) or beside it (false).
    Over(bool),
    /// Show two by two tiles.
    Tiled(bool),
    /// Zoom and pan sketch and texture together.
    Linked(bool),
    /// Show the region grid.
    Regions(bool),
    /// Show fitted marks, neighbours and mean marks.
    Analysis(bool),
    /// Show the sizes and directions that the free marks ask for in the space between them.
    Wanted(bool),
    /// Show these sizes and directions if they are hidden, else hide them.
    ToggleWanted,
    /// Set the grid that marks snap to.
    Snap(Snap),
    /// Ask for a picture to show under the canvas.
    ChooseReference,
    /// Show or hide the reference picture.
    ShowReference(bool),
    /// Set the opacity of the reference picture, 0..1.
    ReferenceOpacity(f32),
    /// Lock the reference picture where it is (true), or let the pointer move and scale it.
    LockReference(bool),
    /// Put the reference picture elsewhere.
    PlaceReference(Placement),
    /// Put the reference picture back to the centre of the canvas, as large as it fits.
    FitReference,
    /// Remove the reference picture.
    RemoveReference,
    /// Set the theme.
    Theme(ThemePreference),
    /// Pause the growth, or resume it.
    Pause,
    /// Stop growing.
    Stop,
    /// Grow again.
    Grow,
    /// Use the next seed.
    AnotherSeed,
    /// Change the document.
    Edit(Edit),
    /// Carry out an operation on a layer.
    Layer(LayerAction),
    /// Show this tab.
    Tab(Tab),
    /// Open the recovered document with this id.
    Restore(String),
    /// Delete the recovered document with this id.
    Discard(String),
    /// Replace the marks of a region by the most similar ones that can be grown: layer of the finished document,
    /// (column, row).
    Reach(usize, [usize; 2]),
    /// Show the training cloud of a region of a layer of the finished document, or hide it.
    Cloud(Option<(usize, [usize; 2])>),
    /// Show or hide what the layer can become.
    Goals(bool),
    /// Show or hide the alternatives.
    Alternatives(bool),
    /// Show the alternatives if they are hidden, else hide them.
    ToggleAlternatives,
    /// Open this alternative.
    TakeAlternative(u64),
    /// Keep this alternative when the sketch changes (true), or no longer (false).
    KeepAlternative(u64, bool),
    /// Stop growing alternatives (true), or resume (false).
    StopAlternatives(bool),
    /// Open this page; where it is open, close it.
    Page(Page),
}

/// A page over the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Page {
    /// First steps.
    Hint,
    /// Examples, as pictures.
    Examples,
    /// Keyboard shortcuts.
    Shortcuts,
    /// Version, papers, licence.
    About,
    /// Documents that were not saved when dapple was closed.
    Recovery,
    /// Settings for all documents.
    Preferences,
}

/// A tab of the column on the right.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tab {
    /// The tool, the selected marks, what they ask for.
    #[default]
    Draw,
    /// Size, regions and edges of the canvas, and what is shown on it.
    Canvas,
    /// The colours of the active layer.
    Colour,
    /// What was asked for and what has grown.
    Result,
}

impl Tab {
    /// All tabs, in order.
    pub const ALL: [Self; 4] = [Self::Draw, Self::Canvas, Self::Colour, Self::Result];

    /// Its label.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Draw => "Draw",
            Self::Canvas => "Canvas",
            Self::Colour => "Colour",
            Self::Result => "Result",
        }
    }
}
