//! Passes that correct a layer of spots or stripes: one ordered list, run by one loop ([`Passes`]), on a canvas or on a surface.
//!
//! ```text
//!  grow ─▶ thresholds ─▶ own thresholds ─▶ parts ─▶ keep ─▶ separation ─▶ room ─▶ corrections ─▶ … ─▶ bias ─▶ raggedness
//!   ▲                     (as it is shown)   │     the best    │   (spots begin again, or grow in other parameters)  │
//!   └────────────────────────────────────────┴─────────────────┴─────────────────────────────────────────────────────┘
//! ```
//!
//! A pass reads the measurements of the layer ([`Correctable`]), and changes thresholds or restarts spots. After a restart the
//! growth continues, and the list begins again. A log ([`Trace`]) records what a pass saw, changed and cost; `docs/passes.md`
//! states what each contributes.

mod correctable;
mod found;
mod own_thresholds;
mod pass;
mod restarts;
mod room;
mod rounds;
mod run;
mod thresholds;
mod trace;

pub use correctable::{Correctable, Grown};
pub use found::{DrawnSpots, MergedSpots};
pub use own_thresholds::{OwnThresholds, SpotArea};
pub use pass::{Pass, PassSet};
pub use restarts::Restart;
pub use run::{Passes, Step};
pub use thresholds::{Levelling, Moved, Thresholds};
pub use trace::{Entry, Trace};
