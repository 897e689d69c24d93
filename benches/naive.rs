//! Turing spots computed in the simplest way: nested vectors, `%` at every neighbour, one step after the other. It is
//! the reference that shows that the plain solver is not slow.

use dapple_engine::rd::Growth;

/// D_a/D_b of the system.
pub const RATIO: f32 = 3.8;

/// Two chemicals on a torus.
pub struct Naive {
    a: Vec<Vec<f32>>,
    b: Vec<Vec<f32>>,
    next_a: Vec<Vec<f32>>,
    next_b: Vec<Vec<f32>>,
    /// dt·D of each chemical.
    mobility: [f32; 2],
    /// dt·k.
    rate: f32,
}

impl Naive {
    /// Starts from the state of `growth`: isotropic Turing spots of `size` × `size` cells, `rate` everywhere.
    pub fn beside(growth: &Growth, size: usize, rate: f32) -> Self {
        let rows = |cells: &Vec<f32>| cells.chunks(size).map(<[f32]>::to_vec).collect::<Vec<_>>();
        let concentrations = growth.concentrations();
        let [a, b] = [rows(&concentrations[0]), rows(&concentrations[1])];
        let scale = scale(growth, rate, 1.0);
        let mobility = [scale * RATIO.sqrt(), scale / RATIO.sqrt()];
        Self { next_a: a.clone(), next_b: b.clone(), a, b, mobility, rate: scale * rate }
    }

    /// Takes `steps` steps.
    pub fn advance(&mut self, steps: u64) {
        for _ in 0..steps {
            self.step();
        }
    }

    /// Takes a few steps, and checks that `growth`, which has the same state, computes the same.
    ///
    /// # Panics
    ///
    /// When the results differ.
    pub fn check(&mut self, growth: &Growth) {
        let mut growth = growth.clone();
        growth.advance_plain(5);
        self.advance(5);
        for (naive, plain) in [&self.a, &self.b].into_iter().zip(growth.concentrations()) {
            let apart = naive.iter().flatten().zip(&plain).map(|(n, p)| (n - p).abs()).fold(0.0, f32::max);
            assert!(apart < 1e-4, "the naive solver and the plain one are {apart} apart");
        }
    }

    fn step(&mut self) {
        let height = self.a.len();
        let width = self.a[0].len();
        for y in 0..height {
            for x in 0..width {
                let (up, down) = ((y + height - 1) % height, (y + 1) % height);
                let (left, right) = ((x + width - 1) % width, (x + 1) % width);
                let (a, b) = (self.a[y][x], self.b[y][x]);
                let spread_a = self.a[up][x] + self.a[down][x] + self.a[y][left] + self.a[y][right] - 4.0 * a;
                let spread_b = self.b[up][x] + self.b[down][x] + self.b[y][left] + self.b[y][right] - 4.0 * b;
                self.next_a[y][x] = a + self.mobility[0] * spread_a + self.rate * (16.0 - a * b);
                let next_b = b + self.mobility[1] * spread_b + self.rate * (a * b - b - 12.0);
                self.next_b[y][x] = next_b.max(0.0);
            }
        }
        std::mem::swap(&mut self.a, &mut self.next_a);
        std::mem::swap(&mut self.b, &mut self.next_b);
    }
}

/// The normalised time of one step of `growth`, in units of cell² ÷ √(Dₐ·D_b), where the lowest rate of the cells is
/// `rate`. `decay` is the system's constant of normalised time.
pub fn scale(growth: &Growth, rate: f32, decay: f64) -> f32 {
    let mut growth = growth.clone();
    let before = growth.time();
    growth.advance(1);
    ((growth.time() - before) / decay / f64::from(rate)) as f32
}
