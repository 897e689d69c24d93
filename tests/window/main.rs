//! The window, driven by pointer and keys as by a user.
#![cfg(feature = "app")]

mod access;
mod alternatives;
mod clipboard;
mod colour;
mod columns;
mod documents;
mod drawing;
mod exporting;
mod free_marks;
mod growing;
mod hand;
mod history;
mod importing;
mod keyboard;
mod layers;
mod leopard;
mod outlines;
mod preferences;
mod recovery;
mod result;
mod selecting;
mod sights;
mod typing;
mod views;
