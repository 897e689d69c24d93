//! The command line through the real program: documents in; pictures, outlines, films, tables and reports out.

mod batch;
mod command_line;
mod examples;
mod grow;
mod learn;
mod motion;
mod outlines;
mod photos;
mod pictures;
mod reach;
mod sheet;
