//! The triangle nearest to a point, by a tree of bounding boxes.

use super::mesh::area_vector;
use super::vector::{Vector, cross, dot, minus, plus, times};

/// Triangles of a leaf. Not tuned.
const LEAF: usize = 4;

/// Triangles sorted into boxes. Each inner node has two children: the next node, and the one it names.
#[derive(Clone, Debug)]
pub struct BoundingTree {
    nodes: Vec<Node>,
    /// The triangles in the order of the leaves.
    triangles: Vec<(u32, [Vector; 3])>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    low: Vector,
    high: Vector,
    /// The second child of an inner node, or the end of the triangles of a leaf.
    other: u32,
    /// The first triangle of a leaf; [`INNER`] for an inner node.
    first: u32,
}

const INNER: u32 = u32::MAX;

/// The point of a triangle nearest to another.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// The index of the triangle.
    pub triangle: u32,
    /// Barycentric coordinates, with the sum 1.
    pub weights: [f64; 3],
    /// Its position.
    pub at: Vector,
    /// Its distance, squared.
    pub square: f64,
}

impl BoundingTree {
    /// A tree of these triangles, which may be degenerate to segments or points.
    pub fn new(triangles: impl IntoIterator<Item = [Vector; 3]>) -> Self {
        let mut triangles: Vec<_> = (0..).zip(triangles).collect();
        let mut nodes = Vec::with_capacity(triangles.len());
        let count = triangles.len();
        build(&mut triangles, 0..count, &mut nodes);
        Self { nodes, triangles }
    }

    /// The nearest point of the triangles for which `is_fit` holds; the first of several. `None` if it holds for none.
    pub fn nearest(&self, point: Vector, is_fit: impl Fn(u32) -> bool) -> Option<Nearest> {
        let mut best: Option<Nearest> = None;
        let mut stack = [(0u32, 0.0f64); 64];
        let mut depth = usize::from(!self.triangles.is_empty());
        while depth > 0 {
            depth -= 1;
            let (index, square) = stack[depth];
            if best.is_some_and(|best| square > best.square) {
                continue;
            }
            let node = &self.nodes[index as usize];
            if node.first == INNER {
                let children = [index + 1, node.other];
                let [a, b] = children.map(|child| (child, self.nodes[child as usize].square_to(point)));
                // The nearer node is searched first.
                let (near, far) = if b.1 < a.1 { (b, a) } else { (a, b) };
                stack[depth] = far;
                stack[depth + 1] = near;
                depth += 2;
                continue;
            }
            for (triangle, corners) in &self.triangles[node.first as usize..node.other as usize] {
                let found = nearest_of(point, *corners);
                let is_better = best.is_none_or(|best| {
                    found.square < best.square || found.square == best.square && *triangle < best.triangle
                });
                if is_better && is_fit(*triangle) {
                    best = Some(Nearest { triangle: *triangle, ..found });
                }
            }
        }
        best
    }
}

/// Separates half of the triangles from the others, at the median along the longest side of the box of their centres.
fn build(all: &mut [(u32, [Vector; 3])], range: std::ops::Range<usize>, nodes: &mut Vec<Node>) {
    let triangles = &mut all[range.clone()];
    let mut node = Node { low: [f64::INFINITY; 3], high: [f64::NEG_INFINITY; 3], other: 0, first: INNER };
    let mut middles = node;
    for (_, corners) in triangles.iter() {
        corners.iter().for_each(|corner| node.add(*corner));
        middles.add(middle_of(corners));
    }
    let index = nodes.len();
    if triangles.len() <= LEAF {
        node.first = range.start as u32;
        node.other = range.end as u32;
        nodes.push(node);
        return;
    }
    let sides = [0, 1, 2].map(|axis| middles.high[axis] - middles.low[axis]);
    let axis = (0..3).max_by(|a, b| sides[*a].total_cmp(&sides[*b])).unwrap_or(0);
    let half = triangles.len() / 2;
    triangles.select_nth_unstable_by(half, |(i, a), (j, b)| {
        middle_of(a)[axis].total_cmp(&middle_of(b)[axis]).then(i.cmp(j))
    });
    nodes.push(node);
    build(all, range.start..range.start + half, nodes);
    nodes[index].other = nodes.len() as u32;
    build(all, range.start + half..range.end, nodes);
}

fn middle_of([a, b, c]: &[Vector; 3]) -> Vector {
    plus(plus(*a, *b), *c)
}

impl Node {
    fn add(&mut self, point: Vector) {
        self.low = [0, 1, 2].map(|axis| self.low[axis].min(point[axis]));
        self.high = [0, 1, 2].map(|axis| self.high[axis].max(point[axis]));
    }

    /// Squared distance of a point to the box.
    fn square_to(&self, point: Vector) -> f64 {
        let off = |axis: usize| {
            let off = (self.low[axis] - point[axis]).max(point[axis] - self.high[axis]).max(0.0);
            off * off
        };
        off(0) + off(1) + off(2)
    }
}

/// The nearest point of one triangle.
fn nearest_of(point: Vector, [a, b, c]: [Vector; 3]) -> Nearest {
    let normal = area_vector([a, b, c]);
    let square = dot(normal, normal);
    let at_weights = |weights: [f64; 3]| {
        let at = plus(plus(times(a, weights[0]), times(b, weights[1])), times(c, weights[2]));
        let off = minus(point, at);
        Nearest { triangle: 0, weights, at, square: dot(off, off) }
    };
    if square > 0.0 {
        let off = minus(point, a);
        let second = dot(cross(off, minus(c, a)), normal) / square;
        let third = dot(cross(minus(b, a), off), normal) / square;
        if second >= 0.0 && third >= 0.0 && second + third <= 1.0 {
            return at_weights([1.0 - second - third, second, third]);
        }
    }
    let on_side = |from: Vector, to: Vector| {
        let side = minus(to, from);
        let square = dot(side, side);
        if square > 0.0 { (dot(minus(point, from), side) / square).clamp(0.0, 1.0) } else { 0.0 }
    };
    let [first, second, third] = [on_side(a, b), on_side(b, c), on_side(c, a)];
    let sides =
        [[1.0 - first, first, 0.0], [0.0, 1.0 - second, second], [third, 0.0, 1.0 - third]].map(at_weights);
    let nearer = |a: Nearest, b: Nearest| if b.square < a.square { b } else { a };
    nearer(nearer(sides[0], sides[1]), sides[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::test_meshes::sphere;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn the_nearest_triangle_is_that_of_a_full_search() {
        let mesh = sphere(6, 2.0);
        let tree = BoundingTree::new((0..mesh.faces.len()).map(|face| mesh.corners(face)));
        let mut rng = Pcg64Mcg::seed_from_u64(1);
        for _ in 0..300 {
            let point = [0; 3].map(|_| 6.0 * rng.random::<f64>() - 3.0);
            let found = tree.nearest(point, |face| !face.is_multiple_of(3)).expect("some are fit");
            let all = (0..mesh.faces.len()).filter(|face| !face.is_multiple_of(3));
            let least =
                all.map(|face| nearest_of(point, mesh.corners(face)).square).fold(f64::INFINITY, f64::min);
            assert!(!found.triangle.is_multiple_of(3) && found.square == least);
        }
        assert!(tree.nearest([0.0; 3], |_| false).is_none());
        assert!(BoundingTree::new([]).nearest([0.0; 3], |_| true).is_none());
    }

    #[test]
    fn triangles_without_area_are_segments_and_points() {
        let (a, b) = ([0.0; 3], [2.0, 0.0, 0.0]);
        for corners in [[a, b, b], [a, a, b], [b, a, [1.0, 0.0, 0.0]]] {
            let found = nearest_of([0.5, 3.0, 0.0], corners);
            assert_eq!((found.at, found.square), ([0.5, 0.0, 0.0], 9.0));
        }
        assert_eq!(nearest_of([0.5, 3.0, 0.0], [b; 3]).at, b);
    }
}
