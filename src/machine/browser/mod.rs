//! A browser: threads are workers that share the program's memory, files are kept in memory, and the page passes files
//! and requests between the program and the visitor.
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
