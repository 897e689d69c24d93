//! Inputs of users: pipes; drawings, pictures and tables of other programs; values on the command line.

mod drawings;
mod errors;
mod pictures;
mod pipes;
mod settings;
