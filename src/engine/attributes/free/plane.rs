//! A plane fitted to weighted values about a point.

/// Ridge on the slope, as a share of the variance of the places: marks in a row have no slope across it.
const RIDGE: f64 = 0.02;

/// Variance of places, px², that rounding leaves where all are one.
const LEAST: f64 = 1e-2;

/// Weighted moments of places (px, relative to the point of the estimate) and values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plane<const N: usize> {
    weight: f64,
    place: [f64; 2],
    /// xx, xy, yy.
    places: [f64; 3],
    value: [f64; N],
    /// x·value, y·value.
    products: [[f64; N]; 2],
}

impl<const N: usize> Default for Plane<N> {
    fn default() -> Self {
        Self { weight: 0.0, place: [0.0; 2], places: [0.0; 3], value: [0.0; N], products: [[0.0; N]; 2] }
    }
}

impl<const N: usize> Plane<N> {
    pub fn add(&mut self, [x, y]: [f64; 2], weight: f64, value: &[f64; N]) {
        self.weight += weight;
        self.place[0] += weight * x;
        self.place[1] += weight * y;
        self.places[0] += weight * x * x;
        self.places[1] += weight * x * y;
        self.places[2] += weight * y * y;
        for (i, value) in value.iter().enumerate() {
            self.value[i] += weight * value;
            self.products[0][i] += weight * x * value;
            self.products[1][i] += weight * y * value;
        }
    }

    /// Adds the values of another one about the same point.
    pub fn merge(&mut self, other: &Self) {
        self.weight += other.weight;
        for axis in 0..2 {
            self.place[axis] += other.place[axis];
        }
        for (sum, other) in self.places.iter_mut().zip(other.places) {
            *sum += other;
        }
        for i in 0..N {
            self.value[i] += other.value[i];
            self.products[0][i] += other.products[0][i];
            self.products[1][i] += other.products[1][i];
        }
    }

    /// These sums about a point that is `by` px from the present one.
    pub fn about(&self, [dx, dy]: [f64; 2]) -> Self {
        let Self { weight, place: [x, y], places: [xx, xy, yy], value, products } = *self;
        let mut moved = Self { place: [x - weight * dx, y - weight * dy], ..*self };
        moved.places = [
            xx - 2.0 * dx * x + weight * dx * dx,
            xy - dx * y - dy * x + weight * dx * dy,
            yy - 2.0 * dy * y + weight * dy * dy,
        ];
        for i in 0..N {
            moved.products[0][i] = products[0][i] - dx * value[i];
            moved.products[1][i] = products[1][i] - dy * value[i];
        }
        moved
    }

    /// Whether nothing that counts was added.
    pub fn is_empty(&self) -> bool {
        self.weight <= 0.0
    }

    /// Sum of the weights.
    pub fn weight(&self) -> f64 {
        self.weight
    }

    /// The mean value; 0 of none.
    pub fn mean(&self) -> [f64; N] {
        if self.is_empty() { [0.0; N] } else { self.value.map(|value| value / self.weight) }
    }

    /// The value of the fitted plane at the point itself; beyond the places its slope is followed for about so many of
    /// their standard deviations.
    pub fn at_origin(&self, followed: f64) -> [f64; N] {
        let mut at = self.mean();
        if self.is_empty() {
            return at;
        }
        let [x, y] = self.place.map(|sum| sum / self.weight);
        let [xx, xy, yy] = self.places.map(|sum| sum / self.weight);
        let [xx, xy, yy] = [(xx - x * x).max(0.0), xy - x * y, (yy - y * y).max(0.0)];
        let variance = 0.5 * (xx + yy);
        let ridge = RIDGE * variance + LEAST;
        let [xx, yy] = [xx + ridge, yy + ridge];
        let determinant = xx * yy - xy * xy;
        let far = (x * x + y * y) / (followed * followed * variance + LEAST);
        let share = 1.0 / (1.0 + far * far).sqrt().sqrt();
        for (i, at) in at.iter_mut().enumerate() {
            let mean = *at;
            let xv = self.products[0][i] / self.weight - x * mean;
            let yv = self.products[1][i] / self.weight - y * mean;
            *at -= share * (x * (yy * xv - xy * yv) + y * (xx * yv - xy * xv)) / determinant;
        }
        at
    }
}
