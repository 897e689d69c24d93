//! Union-find: items that are joined into sets. On a tile it also keeps how many whole canvases apart they were joined.
//!
//! R. E. Tarjan, "Efficiency of a good but not linear set union algorithm", J. ACM 22 (1975), with path compression. The
//! root of a set is always its lowest item, so that results do not depend on the order of the joins.

/// Items 0, 1, 2, … in sets. Each item points to another of its set, some whole canvases away.
#[derive(Clone, Debug, Default)]
pub struct UnionFind {
    parent: Vec<u32>,
    /// Canvases (x, y) to add to an item's places to get its parent's.
    shift: Vec<[i32; 2]>,
    /// By root: whether the set meets itself across the border.
    endless: Vec<bool>,
}

impl UnionFind {
    /// So many items, each a set of its own.
    #[must_use]
    pub fn new(items: usize) -> Self {
        Self { parent: (0..items as u32).collect(), shift: vec![[0, 0]; items], endless: vec![false; items] }
    }

    /// A new item, a set of its own.
    pub fn add(&mut self) -> u32 {
        let item = self.parent.len() as u32;
        self.parent.push(item);
        self.shift.push([0, 0]);
        self.endless.push(false);
        item
    }

    /// Number of items.
    #[must_use]
    pub fn len(&self) -> usize {
        self.parent.len()
    }

    /// Whether there is no item.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.parent.is_empty()
    }

    /// The lowest item of the same set, and the canvases to add to this item's places to get that one's.
    #[must_use]
    pub fn root(&self, item: u32) -> (u32, [i32; 2]) {
        let (mut at, mut total) = (item, [0, 0]);
        while self.parent[at as usize] != at {
            total = sum(total, self.shift[at as usize]);
            at = self.parent[at as usize];
        }
        (at, total)
    }

    /// The root of the set, see [`Self::root`]; all items on the path to it then point to the root itself.
    #[inline]
    pub fn find(&mut self, item: u32) -> (u32, [i32; 2]) {
        let parent = self.parent[item as usize];
        if self.parent[parent as usize] == parent {
            // The shift of a root is 0.
            return (parent, self.shift[item as usize]);
        }
        self.compressed(item)
    }

    /// [`Self::find`] for an item that may be far from its root.
    fn compressed(&mut self, item: u32) -> (u32, [i32; 2]) {
        let (root, whole) = self.root(item);
        let (mut at, mut left) = (item, whole);
        while self.parent[at as usize] != root && at != root {
            let step = self.shift[at as usize];
            let up = self.parent[at as usize];
            self.parent[at as usize] = root;
            self.shift[at as usize] = left;
            left = difference(left, step);
            at = up;
        }
        (root, whole)
    }

    /// Makes one set of those of `a` and `b`, where what is at p in `b` is at p + `apart` canvases in `a`. Gives its root.
    ///
    /// ```
    /// use dapple_engine::grid::UnionFind;
    ///
    /// let mut sets = UnionFind::new(3);
    /// sets.join(0, 2, [0, 0]);
    /// assert_eq!(sets.root(2).0, sets.root(0).0);
    /// assert_ne!(sets.root(1).0, sets.root(0).0);
    /// ```
    pub fn join(&mut self, a: u32, b: u32, apart: [i32; 2]) -> u32 {
        let (ra, sa) = self.find(a);
        if a == b && apart == [0, 0] {
            return ra;
        }
        let (rb, sb) = self.find(b);
        // A place p of b is p + sb at its root, and as p + apart of a, p + apart + sa at a's root.
        let shift = difference(sum(apart, sa), sb);
        if ra == rb {
            self.endless[ra as usize] |= shift != [0, 0];
            return ra;
        }
        let (low, high) = (ra.min(rb), ra.max(rb));
        self.parent[high as usize] = low;
        self.shift[high as usize] = if high == rb { shift } else { difference([0, 0], shift) };
        self.endless[low as usize] |= self.endless[high as usize];
        low
    }

    /// States that the set of this root meets itself across the border.
    pub fn mark_endless(&mut self, root: u32) {
        self.endless[root as usize] = true;
    }

    /// Whether the set of this root meets itself across the border, having gone right round the tile.
    #[must_use]
    pub fn is_endless(&self, root: u32) -> bool {
        self.endless[root as usize]
    }
}

fn sum(a: [i32; 2], b: [i32; 2]) -> [i32; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn difference(a: [i32; 2], b: [i32; 2]) -> [i32; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joined_items_keep_how_far_apart_they_were_joined() {
        let mut sets = UnionFind::default();
        for _ in 0..4 {
            sets.add();
        }
        sets.join(3, 2, [1, 0]);
        sets.join(2, 1, [0, 1]);
        assert_eq!(sets.join(1, 0, [0, 0]), 0);
        // 3 sees the places of 0 at (1, 1) more: −(1, 1) leads from 3's to 0's.
        assert_eq!(sets.root(3), (0, [-1, -1]));
        assert_eq!(sets.find(3), (0, [-1, -1]));
        assert_eq!(sets.find(2), (0, [0, -1]));
        assert!(!sets.is_endless(0));
        sets.join(3, 0, [1, 1]);
        assert!(!sets.is_endless(0));
        sets.join(3, 0, [1, 0]);
        assert!(sets.is_endless(0));
    }

    #[test]
    fn the_lowest_item_stands_for_a_set_whatever_the_order_of_joins() {
        for pairs in [[[4, 2], [2, 5], [5, 1]], [[1, 5], [5, 2], [4, 2]]] {
            let mut sets = UnionFind::new(6);
            pairs.iter().for_each(|[a, b]| {
                sets.join(*a, *b, [0, 0]);
            });
            assert_eq!((0..6).map(|item| sets.find(item).0).collect::<Vec<_>>(), [0, 1, 1, 3, 1, 1]);
        }
    }
}
