//! The window, driven by pointer and keys as a hand would.
#![cfg(feature = "app")]

mod access;
mod documents;
mod drawing;
mod growing;
mod hand;
mod history;
mod keyboard;
mod preferences;
mod recovery;
mod selecting;
mod sights;
mod views;
