//! Pieces that turn out to be one: union–find that also knows how many canvases apart they were seen.

/// Pieces by number; each points to one that it is part of, seen some whole canvases away.
#[derive(Default)]
pub(super) struct Pieces {
    parent: Vec<u32>,
    /// Canvases (x, y) to add to this piece's places to get its parent's.
    shift: Vec<[i32; 2]>,
    endless: Vec<bool>,
}

impl Pieces {
    /// A new piece, on its own.
    pub(super) fn add(&mut self) -> u32 {
        let piece = self.parent.len() as u32;
        self.parent.push(piece);
        self.shift.push([0, 0]);
        self.endless.push(false);
        piece
    }

    pub(super) fn len(&self) -> usize {
        self.parent.len()
    }

    /// The lowest piece of the same whole, and the canvases to add to this one's places to get its.
    pub(super) fn find(&mut self, piece: u32) -> (u32, [i32; 2]) {
        let (mut at, mut total) = (piece, [0, 0]);
        while self.parent[at as usize] != at {
            total = sum(total, self.shift[at as usize]);
            at = self.parent[at as usize];
        }
        let (root, whole) = (at, total);
        let (mut at, mut left) = (piece, total);
        while self.parent[at as usize] != root && at != root {
            let step = self.shift[at as usize];
            let up = self.parent[at as usize];
            self.parent[at as usize] = root;
            self.shift[at as usize] = left;
            left = [left[0] - step[0], left[1] - step[1]];
            at = up;
        }
        (root, whole)
    }

    /// `a` and `b` are one: what is at p in `b` is at p + `apart` canvases in `a`.
    pub(super) fn join(&mut self, a: u32, b: u32, apart: [i32; 2]) {
        if a == b && apart == [0, 0] {
            return;
        }
        let ((ra, sa), (rb, sb)) = (self.find(a), self.find(b));
        // A place p of b is p + sb at its root, and as p + apart of a, p + apart + sa at a's root.
        let shift = [apart[0] + sa[0] - sb[0], apart[1] + sa[1] - sb[1]];
        if ra == rb {
            self.endless[ra as usize] |= shift != [0, 0];
            return;
        }
        let (low, high) = (ra.min(rb), ra.max(rb));
        self.parent[high as usize] = low;
        self.shift[high as usize] = if high == rb { shift } else { [-shift[0], -shift[1]] };
        self.endless[low as usize] |= self.endless[high as usize];
    }

    /// This root's whole meets itself across the border.
    pub(super) fn close(&mut self, root: u32) {
        self.endless[root as usize] = true;
    }

    /// Does this root's whole meet itself across the border, having gone right round the tile?
    pub(super) fn is_endless(&self, root: u32) -> bool {
        self.endless[root as usize]
    }
}

fn sum(a: [i32; 2], b: [i32; 2]) -> [i32; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pieces_remember_how_far_apart_they_were_seen() {
        let mut pieces = Pieces::default();
        for _ in 0..4 {
            pieces.add();
        }
        pieces.join(3, 2, [1, 0]);
        pieces.join(2, 1, [0, 1]);
        pieces.join(1, 0, [0, 0]);
        // 3 sees the places of 0 at (1, 1) more: −(1, 1) leads from 3's to 0's.
        assert_eq!(pieces.find(3), (0, [-1, -1]));
        assert_eq!(pieces.find(2), (0, [0, -1]));
        assert!(!pieces.is_endless(0));
        pieces.join(3, 0, [1, 1]);
        assert!(!pieces.is_endless(0));
        pieces.join(3, 0, [1, 0]);
        assert!(pieces.is_endless(0));
    }
}
