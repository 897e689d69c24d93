//! Triangles whose common edges belong to only one of them, with the fill rule of graphics cards.

use std::ops::Range;

use egui::epaint::Vertex;

/// The number of parts into which a pixel is divided for places.
const PARTS: f32 = 256.0;

/// A corner of a triangle.
#[derive(Clone, Copy)]
pub struct Corner {
    /// Its place, in parts of a pixel.
    at: [i64; 2],
    /// Its colour, multiplied by its opacity, 0–1.
    colour: [f32; 4],
    /// Its place in the texture.
    place: [f32; 2],
}

impl Corner {
    /// The corner for a vertex, on a screen with `scale` pixels per point.
    pub fn new(vertex: &Vertex, scale: f32) -> Self {
        Self {
            at: [vertex.pos.x, vertex.pos.y].map(|part| (part * scale * PARTS).round() as i64),
            colour: vertex.color.to_array().map(|part| f32::from(part) / 255.0),
            place: [vertex.uv.x, vertex.uv.y],
        }
    }
}

/// A triangle with an area.
pub struct Triangle {
    corners: [Corner; 3],
    /// Twice its area, in parts².
    area: i64,
}

/// The side of the line from `a` to `b` on which a point is, as the sign; the value is twice the area of their
/// triangle.
fn side(a: [i64; 2], b: [i64; 2], point: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])
}

/// Whether points on the edge from `a` to `b` belong to the triangle: if it is on the left or on the top.
fn owns(a: [i64; 2], b: [i64; 2]) -> bool {
    b[1] < a[1] || (b[1] == a[1] && b[0] > a[0])
}

impl Triangle {
    /// The triangle with these corners; `None` if it has no area.
    pub fn new(mut corners: [Corner; 3]) -> Option<Self> {
        let area = side(corners[0].at, corners[1].at, corners[2].at);
        if area < 0 {
            corners.swap(1, 2);
        }
        (area != 0).then_some(Self { corners, area: area.abs() })
    }

    /// Calls `paint` for each of these pixels whose middle is inside, with the colour and the place in the texture
    /// there.
    pub fn fill(
        &self,
        [columns, rows]: [Range<i64>; 2],
        mut paint: impl FnMut([i64; 2], [f32; 4], [f32; 2]),
    ) {
        let whole = PARTS as i64;
        let [columns, rows] = [(0, columns), (1, rows)].map(|(axis, clip)| {
            let parts = self.corners.map(|corner| corner.at[axis].div_euclid(whole));
            let [least, most] = [parts.iter().min(), parts.iter().max()].map(|part| *part.expect("three"));
            clip.start.max(least)..clip.end.min(most + 1)
        });
        let [a, b, c] = self.corners.map(|corner| corner.at);
        let edges = [(b, c), (c, a), (a, b)];
        for y in rows {
            for x in columns.clone() {
                let middle = [x, y].map(|part| part * whole + whole / 2);
                let sides = edges.map(|(from, to)| side(from, to, middle));
                let inside =
                    |(&side, &(from, to)): (&i64, &(_, _))| side > 0 || (side == 0 && owns(from, to));
                if sides.iter().zip(&edges).all(inside) {
                    let shares = sides.map(|side| side as f32 / self.area as f32);
                    paint(
                        [x, y],
                        self.mean(shares, |corner| corner.colour),
                        self.mean(shares, |corner| corner.place),
                    );
                }
            }
        }
    }

    fn mean<const N: usize>(&self, shares: [f32; 3], of: impl Fn(&Corner) -> [f32; N]) -> [f32; N] {
        let corners = self.corners.each_ref().map(of);
        std::array::from_fn(|part| (0..3).map(|corner| shares[corner] * corners[corner][part]).sum())
    }
}
