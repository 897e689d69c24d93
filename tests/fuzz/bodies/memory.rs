//! An allocator with a limit, like that of a small machine: an allocation beyond the limit ends the run.
//!
//! If a few bytes make a reader allocate gigabytes, that is a fault, even where the system would grant them.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// The most bytes that may be allocated at the same time. Pictures are decoded into at most 512 MiB, which is the limit
/// of their readers.
const MOST: usize = 1 << 30;

struct Bounded;

static HELD: AtomicUsize = AtomicUsize::new(0);

#[global_allocator]
static BOUNDED: Bounded = Bounded;

/// Counts `size` more bytes; false where that is too much.
fn take(size: usize) -> bool {
    let fits = HELD.fetch_add(size, Relaxed) + size <= MOST;
    if !fits {
        HELD.fetch_sub(size, Relaxed);
    }
    fits
}

// SAFETY: the returned memory is that of the system allocator for the same layout; where it would be too much, null is
// returned, which is allowed.
unsafe impl GlobalAlloc for Bounded {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller keeps to the contract of `alloc`, which is the same.
        if take(layout.size()) { unsafe { System.alloc(layout) } } else { std::ptr::null_mut() }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the same as for `alloc`.
        if take(layout.size()) { unsafe { System.alloc_zeroed(layout) } } else { std::ptr::null_mut() }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size(), Relaxed);
        // SAFETY: `at` came from the system allocator with this layout.
        unsafe { System.dealloc(at, layout) };
    }

    unsafe fn realloc(&self, at: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        if !take(size) {
            return std::ptr::null_mut();
        }
        // SAFETY: the same as for `dealloc`, and `size` comes from the caller.
        let new = unsafe { System.realloc(at, layout, size) };
        HELD.fetch_sub(if new.is_null() { size } else { layout.size() }, Relaxed);
        new
    }
}
