//! An allocator with a limit, as on a small machine: an allocation beyond it ends the run.
//!
//! A few bytes that make a reader ask for gigabytes are a fault, even where the system would hand them out.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

/// Bytes that may be held at once. Pictures are decoded into 512 MiB at most, which is their readers' own bound.
const MOST: usize = 1 << 30;

struct Bounded;

static HELD: AtomicUsize = AtomicUsize::new(0);

#[global_allocator]
static BOUNDED: Bounded = Bounded;

/// Takes note of `size` bytes more; false where that is too much.
fn take(size: usize) -> bool {
    let fits = HELD.fetch_add(size, Relaxed) + size <= MOST;
    if !fits {
        HELD.fetch_sub(size, Relaxed);
    }
    fits
}

// SAFETY: what is handed out is the system allocator's own, with the same layout; null, which is allowed, where it is
// too much.
unsafe impl GlobalAlloc for Bounded {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller keeps to the contract of `alloc`, which is the same.
        if take(layout.size()) { unsafe { System.alloc(layout) } } else { std::ptr::null_mut() }
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as above.
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
        // SAFETY: as above, and `size` is the caller's.
        let new = unsafe { System.realloc(at, layout, size) };
        HELD.fetch_sub(if new.is_null() { size } else { layout.size() }, Relaxed);
        new
    }
}
