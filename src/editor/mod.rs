//! The document while it is edited: selection, undo history, layers, marks, its files, recovery. It does not depend on
//! a window toolkit.

pub mod arithmetic;
pub mod arrange;
pub mod backdrop;
pub mod clipboard;
pub mod edit;
pub mod file_lock;
pub mod folder;
pub mod freehand;
pub mod goal;
pub mod history;
pub mod layer_action;
pub mod layer_choices;
pub mod path_encoding;
pub mod pens;
pub mod picture_use;
pub mod reading;
pub mod recent_sketches;
pub mod recovery;
pub mod saving;
pub mod selection;
pub mod session;
pub mod settings_file;
pub mod shape;
pub mod sketch_part;
pub mod snap;
pub mod suggestion;
pub mod task;
pub mod typed;
pub mod units;
pub mod wheel;
pub mod writing;
