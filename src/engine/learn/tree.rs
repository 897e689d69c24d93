//! The nearest of many points: a k-d tree (Bentley, Communications of the ACM 18(9), 1975), each node with the box
//! of its points.
//!
//! The result equals that of a search through all points, bit for bit: distances are summed in one order, a box is skipped only if
//! its own distance, summed likewise, is larger than that of the last neighbour, and of points at equal distance those with lower
//! indices are taken. Existing crates do not specify which of several points at equal distance is found, and do not support mirror
//! images.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::Range;

use multiversion::multiversion;

use crate::learn::small_vector::MOST;

/// Points in a leaf. Tuned on 9,000 rows in 3 to 5 dimensions: 4 and 16 are a tenth slower.
const LEAF: usize = 24;

/// A place in standardised features, padded with zeros.
pub(super) type Place = [f64; MOST];

/// |a − b|², added up in the order of the coordinates.
#[cfg(test)]
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
struct Nearest {
    most: usize,
    /// Up to half as many more, so that one selection serves many insertions.
    found: Vec<Near>,
    /// Points beyond this squared distance are not among the nearest.
    reach: f64,
}

impl Nearest {
    /// An empty list.
    fn new(most: usize) -> Self {
        // No distance is below −1.
        let reach = if most == 0 { -1.0 } else { f64::INFINITY };
        Self { most, found: Vec::with_capacity(Self::held(most)), reach }
    }

    /// Number of samples that are kept before the farthest are removed.
    fn held(most: usize) -> usize {
        most + most / 2 + 1
    }

    /// Keeps an image of a row that may be among the nearest.
    #[inline]
    fn keep(&mut self, squared: f64, row: u32, image: u32) {
        self.found.push(Near::new(squared, row, image));
        if self.found.len() == Self::held(self.most) {
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
    fn sorted(mut self) -> Vec<Near> {
        self.sort_out();
        self.found.sort_unstable();
        self.found
    }
}

/// Points, prepared for searching.
pub(super) struct Tree {
    nodes: Vec<Node>,
    /// The points, leaf by leaf.
    blocks: Vec<Block>,
}

struct Node {
    low: Place,
    high: Place,
    below: Below,
}

/// The content of a node: two nodes, or blocks of points.
#[derive(Clone)]
enum Below {
    /// Two nodes: the next one and this one.
    Nodes(usize),
    /// A leaf: its blocks.
    Blocks(Range<usize>),
}

/// Some points, coordinate by coordinate, so that the distances to all of them are computed at once.
struct Block {
    /// Zeros after the last point.
    coordinates: [[f64; LEAF]; MOST],
    /// The numbers of the points.
    numbers: [u32; LEAF],
    points: usize,
}

impl Block {
    /// At most [`LEAF`] points.
    fn new(points: &[(Place, u32)]) -> Self {
        let mut block = Self { coordinates: [[0.0; LEAF]; MOST], numbers: [0; LEAF], points: points.len() };
        for (i, (point, number)) in points.iter().enumerate() {
            block.coordinates.iter_mut().zip(point).for_each(|(coordinates, x)| coordinates[i] = *x);
            block.numbers[i] = *number;
        }
        block
    }
}

/// The square of the distance, from `q` to each point with these coordinates.
#[multiversion(targets("x86_64+avx2"))]
fn squared_of_each(coordinates: &[[f64; LEAF]; MOST], q: &Place) -> [f64; LEAF] {
    let mut sums = [0.0; LEAF];
    for (coordinates, q) in coordinates.iter().zip(q) {
        for (sum, x) in sums.iter_mut().zip(coordinates) {
            *sum += (x - q) * (x - q);
        }
    }
    sums
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

/// A node that is still to be searched for an image of the question. The nearest is the greatest.
///
/// Stored as one number, in the form of [`Near`]: 64 bits of the squared distance, 32 of the image, 32 of the node.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Waiting(Reverse<u128>);

impl Waiting {
    fn new(squared: f64, image: u32, node: u32) -> Self {
        Self(Reverse(u128::from(squared.to_bits()) << 64 | u128::from(image) << 32 | u128::from(node)))
    }

    /// Squared distance of the image to the box of the node.
    fn squared(&self) -> f64 {
        f64::from_bits((self.0.0 >> 64) as u64)
    }

    fn image(&self) -> u32 {
        (self.0.0 as u64 >> 32) as u32
    }

    fn node(&self) -> u32 {
        self.0.0 as u32
    }
}

impl Tree {
    /// A tree over `points`, numbered in their order.
    pub fn new(points: impl Iterator<Item = Place>) -> Self {
        let mut points: Vec<(Place, u32)> = points.zip(0..).collect();
        let mut tree = Self { nodes: Vec::new(), blocks: Vec::new() };
        tree.split(&mut points);
        tree
    }

    /// Adds the node of these points, and the nodes below it.
    fn split(&mut self, points: &mut [(Place, u32)]) {
        let (mut low, mut high) = ([f64::INFINITY; MOST], [f64::NEG_INFINITY; MOST]);
        for (point, _) in points.iter() {
            for ((low, high), x) in low.iter_mut().zip(&mut high).zip(point) {
                (*low, *high) = (low.min(*x), high.max(*x));
            }
        }
        let width = |axis: usize| high[axis] - low[axis];
        let widest =
            (1..MOST).fold(0, |widest, axis| if width(axis) > width(widest) { axis } else { widest });
        if points.len() <= LEAF || width(widest) == 0.0 {
            let first = self.blocks.len();
            self.blocks.extend(points.chunks(LEAF).map(Block::new));
            let below = Below::Blocks(first..self.blocks.len());
            self.nodes.push(Node { low, high, below });
            return;
        }
        // Whole blocks: computing on a part of a block takes as long as on all of it.
        let half = points.len().div_ceil(LEAF) / 2 * LEAF;
        // Ties are broken by number, so that the tree does not depend on the sorting algorithm.
        points.select_nth_unstable_by(half, |(a, i), (b, j)| a[widest].total_cmp(&b[widest]).then(i.cmp(j)));
        let node = self.nodes.len();
        self.nodes.push(Node { low, high, below: Below::Nodes(0) });
        let (first, second) = points.split_at_mut(half);
        self.split(first);
        self.nodes[node].below = Below::Nodes(self.nodes.len());
        self.split(second);
    }

    /// The `most` points that are nearest to any of the `images` of a question, the nearest first; not the point `without`.
    /// A point may be near several images.
    pub fn nearest(&self, images: &[Place], most: usize, without: Option<u32>) -> Vec<Near> {
        let mut nearest = Nearest::new(most);
        let root = |(image, q): (u32, &Place)| Waiting::new(self.nodes[0].squared(q), image, 0);
        let mut waiting: BinaryHeap<Waiting> = (0..).zip(images).map(root).collect();
        while let Some(next) = waiting.pop() {
            if next.squared() > nearest.reach {
                break;
            }
            let (image, mut node) = (next.image(), next.node() as usize);
            let q = &images[image as usize];
            let blocks = loop {
                let second = match &self.nodes[node].below {
                    Below::Blocks(blocks) => break blocks.clone(),
                    Below::Nodes(second) => *second,
                };
                let mut near = (self.nodes[node + 1].squared(q), node + 1);
                let mut far = (self.nodes[second].squared(q), second);
                if far.0 < near.0 {
                    (near, far) = (far, near);
                }
                if far.0 <= nearest.reach {
                    waiting.push(Waiting::new(far.0, image, far.1 as u32));
                }
                node = near.1;
            };
            for block in &self.blocks[blocks] {
                let distances = squared_of_each(&block.coordinates, q);
                for (squared, number) in distances.iter().zip(&block.numbers).take(block.points) {
                    // Most points are too far once there are enough.
                    if *squared <= nearest.reach && without != Some(*number) {
                        nearest.keep(*squared, *number, image);
                    }
                }
            }
        }
        nearest.sorted()
    }
}
