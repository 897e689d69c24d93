//! The library: documents and their messages, layers, the ruler, and what it says of grown patterns.

mod documents;
mod gallery;
mod layers;
mod patches;
mod ruler;
mod verdicts;
