//! Paths of straight and cubic pieces, px.

/// How a path goes on from where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece {
    /// Straight to a point.
    Line([f64; 2]),
    /// By a cubic Bezier: two handles, and the point where it ends.
    Cubic([[f64; 2]; 3]),
}

impl Piece {
    /// Where it ends.
    #[must_use]
    pub fn end(&self) -> [f64; 2] {
        match self {
            Self::Line(end) | Self::Cubic([_, _, end]) => *end,
        }
    }

    /// The point at parameter `t` of the piece that begins at `start`.
    #[must_use]
    pub fn at(&self, start: [f64; 2], t: f64) -> [f64; 2] {
        match self {
            Self::Line(end) => [0, 1].map(|axis| start[axis] + t * (end[axis] - start[axis])),
            Self::Cubic([a, b, end]) => cubic([start, *a, *b, *end], t),
        }
    }
}

/// B(t) = (1−t)³p₀ + 3(1−t)²t p₁ + 3(1−t)t² p₂ + t³p₃.
#[must_use]
pub fn cubic(p: [[f64; 2]; 4], t: f64) -> [f64; 2] {
    let s = 1.0 - t;
    let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
    [0, 1].map(|axis| (0..4).map(|i| weights[i] * p[i][axis]).sum())
}

/// A path, px.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    /// Where it begins.
    pub start: [f64; 2],
    /// How it goes on; a closed one ends where it begins.
    pub pieces: Vec<Piece>,
    /// Whether it is closed.
    pub closed: bool,
}

impl Path {
    /// A stroke from point to point.
    #[must_use]
    pub fn stroke(from: [f64; 2], to: [f64; 2]) -> Self {
        Self { start: from, pieces: vec![Piece::Line(to)], closed: false }
    }

    /// Where it ends.
    #[must_use]
    pub fn end(&self) -> [f64; 2] {
        self.pieces.last().map_or(self.start, Piece::end)
    }

    /// Each piece with the point where it begins.
    pub fn steps(&self) -> impl Iterator<Item = ([f64; 2], Piece)> + '_ {
        let mut from = self.start;
        self.pieces.iter().map(move |piece| (std::mem::replace(&mut from, piece.end()), *piece))
    }

    /// The area that it encloses, px²: ½∮(x dy − y dx), positive around marks, negative around holes.
    #[must_use]
    pub fn area(&self) -> f64 {
        let [ox, oy] = self.start;
        let cross = |a: [f64; 2], b: [f64; 2]| (a[0] - ox) * (b[1] - oy) - (a[1] - oy) * (b[0] - ox);
        let twice = |(start, piece): ([f64; 2], Piece)| match piece {
            Piece::Line(end) => cross(start, end),
            // The integral over a Bezier, by pairs of its control points.
            Piece::Cubic([a, b, end]) => {
                0.6 * cross(start, a)
                    + 0.3 * cross(start, b)
                    + 0.1 * cross(start, end)
                    + 0.3 * cross(a, b)
                    + 0.3 * cross(a, end)
                    + 0.6 * cross(b, end)
            }
        };
        0.5 * self.steps().map(twice).sum::<f64>()
    }

    /// Its length, px, of the flattened path.
    #[must_use]
    pub fn length(&self) -> f64 {
        let points = self.flat(0.05);
        points.windows(2).map(|pair| distance(pair[0], pair[1])).sum()
    }

    /// Points along it that lie nowhere farther than about `tolerance` px from it; a closed one ends where it begins.
    #[must_use]
    pub fn flat(&self, tolerance: f64) -> Vec<[f64; 2]> {
        let mut points = vec![self.start];
        for (start, piece) in self.steps() {
            if let Piece::Cubic([a, b, end]) = piece {
                // Wang's bound: with second differences of at most d, n steps lie within ¾·d/n² of the curve.
                let bend = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
                    distance([p[0] + r[0], p[1] + r[1]], [2.0 * q[0], 2.0 * q[1]])
                };
                let most = bend(start, a, b).max(bend(a, b, end));
                let steps = (0.75 * most / tolerance).sqrt().ceil().clamp(1.0, 1000.0);
                points.extend((1..steps as usize).map(|i| piece.at(start, i as f64 / steps)));
            }
            points.push(piece.end());
        }
        points
    }

    /// The same path the other way round.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let back = |(start, piece): ([f64; 2], Piece)| match piece {
            Piece::Line(_) => Piece::Line(start),
            Piece::Cubic([a, b, _]) => Piece::Cubic([b, a, start]),
        };
        let mut pieces: Vec<Piece> = self.steps().map(back).collect();
        pieces.reverse();
        Self { start: self.end(), pieces, closed: self.closed }
    }

    /// A closed path that begins at the end of its `first` pieces.
    #[must_use]
    pub fn begun_after(mut self, first: usize) -> Self {
        if let Some(piece) = first.checked_sub(1).and_then(|last| self.pieces.get(last)) {
            self.start = piece.end();
            self.pieces.rotate_left(first);
        }
        self
    }

    /// What is left of a closed path without what runs along the border of a canvas of `size` px: open strokes, or
    /// the path itself.
    #[must_use]
    pub fn cut(&self, size: [f64; 2]) -> Vec<Self> {
        let runs = |(start, piece): ([f64; 2], Piece)| match piece {
            Piece::Line(end) => borders(start, size) & borders(end, size) != 0,
            Piece::Cubic(_) => false,
        };
        let along: Vec<bool> = self.steps().map(runs).collect();
        let Some(first) = along.iter().position(|along| *along) else { return vec![self.clone()] };
        let turned = self.clone().begun_after(first);
        let mut strokes: Vec<Self> = Vec::new();
        let mut open = false;
        for (i, (start, piece)) in turned.steps().enumerate() {
            if along[(first + i) % along.len()] {
                open = false;
            } else if let Some(stroke) = strokes.last_mut().filter(|_| open) {
                stroke.pieces.push(piece);
            } else {
                strokes.push(Self { start, pieces: vec![piece], closed: false });
                open = true;
            }
        }
        strokes
    }
}

/// Which borders of a canvas of `size` px a point lies on: left 1, right 2, top 4, bottom 8.
#[must_use]
pub fn borders([x, y]: [f64; 2], [width, height]: [f64; 2]) -> u8 {
    let on = [x <= 0.0, x >= width, y <= 0.0, y >= height];
    on.iter().enumerate().map(|(bit, on)| u8::from(*on) << bit).sum()
}

/// Distance between two points.
#[must_use]
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (x, y) = (b[0] - a[0], b[1] - a[1]);
    (x * x + y * y).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A circle about the origin, of four cubics (off by 0.03 % of the radius).
    pub fn circle(r: f64) -> Path {
        let k = 0.552_284_75 * r;
        let pieces = [
            [[r, k], [k, r], [0.0, r]],
            [[-k, r], [-r, k], [-r, 0.0]],
            [[-r, -k], [-k, -r], [0.0, -r]],
            [[k, -r], [r, -k], [r, 0.0]],
        ];
        Path { start: [r, 0.0], pieces: pieces.map(Piece::Cubic).to_vec(), closed: true }
    }

    #[test]
    fn a_circle_has_its_area_and_length_either_way_round() {
        let circle = circle(10.0);
        assert!((circle.area() / (100.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
        assert!((circle.length() / (20.0 * std::f64::consts::PI) - 1.0).abs() < 5e-3);
        assert!((circle.reversed().area() + circle.area()).abs() < 1e-9);
        let turned = circle.clone().begun_after(2);
        assert_eq!((turned.start, turned.end()), ([-10.0, 0.0], [-10.0, 0.0]));
        assert!((turned.area() - circle.area()).abs() < 1e-9);
    }

    #[test]
    fn a_flattened_path_stays_within_the_tolerance() {
        for tolerance in [1.0, 0.1, 0.01] {
            let points = circle(10.0).flat(tolerance);
            for pair in points.windows(2) {
                let middle = [0, 1].map(|axis| 0.5 * (pair[0][axis] + pair[1][axis]));
                assert!(distance(middle, [0.0, 0.0]) > 9.99 - tolerance, "{tolerance}: {middle:?}");
            }
        }
    }

    #[test]
    fn what_runs_along_the_border_is_cut_away() {
        // A half circle at the left border of a canvas.
        let arc = Piece::Cubic([[4.0, 2.0], [4.0, 8.0], [0.0, 8.0]]);
        let path = Path { start: [0.0, 2.0], pieces: vec![arc, Piece::Line([0.0, 2.0])], closed: true };
        let strokes = path.cut([20.0, 20.0]);
        assert_eq!(strokes, [Path { start: [0.0, 2.0], pieces: vec![arc], closed: false }]);
        assert_eq!(circle(3.0).cut([50.0, 50.0]).len(), 1);
        let corners = [[20.0, 0.0], [20.0, 20.0], [0.0, 20.0], [0.0, 0.0]];
        let frame = Path { start: [0.0, 0.0], pieces: corners.map(Piece::Line).to_vec(), closed: true };
        assert_eq!(frame.cut([20.0, 20.0]), []);
    }
}
