//! A browser: threads are workers that share the program's memory, files lie in memory, and a page stands between the program and
//! the visitor.
//!
//! ```text
//!  page ─▶ window (the page's thread, which never waits)      workers ─▶ tasks, pools
//!   ▲ │                 │                                        │
//!   │ └─ files given ─▶ files in memory ◀────────────────────────┘
//!   └── requests: choose a file, save one ◀─────────────────────┘
//! ```

pub mod archive;
pub mod fs;
pub mod memory;
pub mod page;
pub mod sync;
pub mod temporary;
pub mod threads;
