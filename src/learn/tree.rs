//! The nearest of many points: a k-d tree (Bentley, Communications of the ACM 18(9), 1975), each node with the box
//! of its points.
//!
//! The answer equals that of a search through all points, bit for bit: distances are summed in the same order, a box is
//! skipped only if its own distance, summed likewise, is larger than that of the last neighbour, and of points at equal
//! distance those with lower numbers are taken. Existing crates do not specify which of several points at equal distance is
//! found, and do not support mirror images.

use crate::learn::small_vector::MOST;

/// Points in a leaf. Tuned on 9,000 rows in 3 to 5 dimensions: 4 and 16 are a tenth slower.
const LEAF: usize = 8;

/// A place in standardised features, padded with zeros.
pub(super) type Place = [f64; MOST];

/// |a − b|², added up in the order of the coordinates.
pub(super) fn squared(a: &Place, b: &Place) -> f64 {
    let mut sum = 0.0;
    for (a, b) in a.iter().zip(b) {
        sum += (a - b) * (a - b);
    }
    sum
}

/// A sample that is near a question. Ordered: the nearer first, then the lower row, then the lower image.
///
/// One number, for fast sorting: the 64 bits of the squared distance, which are ordered like the distances because none is
/// negative; 32 bits of the row, 32 of the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Near(u128);

impl Near {
    /// An image of a row at a distance.
    pub fn new(squared: f64, row: u32, image: u32) -> Self {
        Self(u128::from(squared.to_bits()) << 64 | u128::from(row) << 32 | u128::from(image))
    }

    /// Its squared distance.
    pub fn squared(self) -> f64 {
        f64::from_bits((self.0 >> 64) as u64)
    }

    /// The row.
    pub fn row(self) -> usize {
        (self.0 as u64 >> 32) as usize
    }

    /// The mirror image of it.
    pub fn image(self) -> usize {
        self.0 as u32 as usize
    }
}

/// The nearest samples so far, `most` at most.
pub(super) struct Nearest {
    most: usize,
    /// Up to twice as many, so that one selection serves many insertions.
    found: Vec<Near>,
    /// Points beyond this squared distance are not among the nearest.
    reach: f64,
}

impl Nearest {
    /// An empty list.
    pub fn new(most: usize) -> Self {
        // No distance is below −1.
        let reach = if most == 0 { -1.0 } else { f64::INFINITY };
        Self { most, found: Vec::with_capacity(2 * most), reach }
    }

    /// Keeps an image of a row if it may be among the nearest.
    #[inline]
    fn offer(&mut self, squared: f64, row: u32, image: u32) {
        if squared > self.reach {
            return;
        }
        self.found.push(Near::new(squared, row, image));
        if self.found.len() == 2 * self.most {
            self.sort_out();
        }
    }

    fn sort_out(&mut self) {
        if self.found.len() >= self.most && self.most > 0 {
            let (_, last, _) = self.found.select_nth_unstable(self.most - 1);
            self.reach = last.squared();
            self.found.truncate(self.most);
        }
    }

    /// All, the nearest first.
    pub fn sorted(mut self) -> Vec<Near> {
        self.sort_out();
        self.found.sort_unstable();
        self.found
    }
}

/// Points, prepared for searching.
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// The points with their numbers, leaf by leaf.
    points: Vec<(Place, u32)>,
}

struct Node {
    low: Place,
    high: Place,
    /// Its part of the points.
    from: usize,
    to: usize,
    /// The second half; the first is the next node. `None` of a leaf.
    second: Option<usize>,
}

impl Node {
    /// Squared distance of `q` to the box.
    fn squared(&self, q: &Place) -> f64 {
        let mut sum = 0.0;
        for j in 0..MOST {
            let (low, high, q) = (self.low[j], self.high[j], q[j]);
            // Comparisons are faster than `max`, which checks for NaN; there are none.
            let (below, above) = (low - q, q - high);
            let off = if below > above { below } else { above };
            let off = if off > 0.0 { off } else { 0.0 };
            sum += off * off;
        }
        sum
    }
}

impl Tree {
    /// A tree over `points`, numbered in their order.
    pub fn new(points: impl Iterator<Item = Place>) -> Self {
        let points = points.zip(0..).collect();
        let mut tree = Self { nodes: Vec::new(), points };
        tree.split(0, tree.points.len());
        tree
    }

    /// Adds the node of the points `from..to`, and those below it.
    fn split(&mut self, from: usize, to: usize) {
        let part = &mut self.points[from..to];
        let (mut low, mut high) = ([f64::INFINITY; MOST], [f64::NEG_INFINITY; MOST]);
        for (point, _) in part.iter() {
            for ((low, high), x) in low.iter_mut().zip(&mut high).zip(point) {
                (*low, *high) = (low.min(*x), high.max(*x));
            }
        }
        let node = self.nodes.len();
        self.nodes.push(Node { low, high, from, to, second: None });
        let width = |axis: usize| high[axis] - low[axis];
        let widest =
            (1..MOST).fold(0, |widest, axis| if width(axis) > width(widest) { axis } else { widest });
        if to - from <= LEAF || width(widest) == 0.0 {
            return;
        }
        let half = (to - from) / 2;
        // Ties are broken by number, so that the tree does not depend on the sorting algorithm.
        part.select_nth_unstable_by(half, |(a, i), (b, j)| a[widest].total_cmp(&b[widest]).then(i.cmp(j)));
        self.split(from, from + half);
        self.nodes[node].second = Some(self.nodes.len());
        self.split(from + half, to);
    }

    /// Adds to `nearest` each point that may be among the nearest to `q`, as this image of its row, except the point
    /// `without`.
    pub fn search(&self, q: &Place, image: u32, without: Option<u32>, nearest: &mut Nearest) {
        if self.points.is_empty() {
            return;
        }
        // Nodes that are still to be searched, the nearest last.
        let mut waiting = vec![(0, self.nodes[0].squared(q))];
        while let Some((mut node, far)) = waiting.pop() {
            if far > nearest.reach {
                continue;
            }
            while let Some(second) = self.nodes[node].second {
                let mut near = (node + 1, self.nodes[node + 1].squared(q));
                let mut far = (second, self.nodes[second].squared(q));
                if far.1 < near.1 {
                    (near, far) = (far, near);
                }
                if far.1 <= nearest.reach {
                    waiting.push(far);
                }
                node = near.0;
            }
            let Node { from, to, .. } = self.nodes[node];
            for (point, row) in &self.points[from..to] {
                if without != Some(*row) {
                    nearest.offer(squared(point, q), *row, image);
                }
            }
        }
    }
}
