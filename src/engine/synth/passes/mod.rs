//! Passes that correct a layer of spots or stripes: one ordered list, run by one loop ([`Passes`]), on a canvas or on a surface.
//!
//! ```text
//!  grow ─▶ thresholds ─▶ own thresholds ─▶ parts ─▶ keep ─▶ separation ─▶ room ─▶ corrections ─▶ … ─▶ bias ─▶ raggedness
//!   ▲                     (as it is shown)   │     the best    │   (spots begin again, or grow in other parameters)  │
//!   └────────────────────────────────────────┴─────────────────┴─────────────────────────────────────────────────────┘
//! ```
//!
//! A pass sees what the layer has measured ([`Correctable`]), and changes thresholds or lets spots begin again. Whatever begins again
//! grows on, and the list begins anew. What a pass sees, changes and costs is written down ([`Trace`]); `docs/passes.md` says what each
//! earns.

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
