//! The map of what Turing's growth makes for each parameter G and decay β, after Lawlor's figure 2: `assets/growth-map.png`, made
//! by `data-gen growth-map`.

/// Patches side by side, each grown with one G and one β.
#[derive(Clone, Copy, Debug)]
pub struct GrowthMap {
    /// G of the first column, of the columns from left to right.
    pub first_growth: f32,
    /// G from column to column.
    pub growth_step: f32,
    /// β of the lowest row; rows are counted from below.
    pub first_decay: f32,
    /// β from row to row.
    pub decay_step: f32,
    /// Columns and rows.
    pub patches: [usize; 2],
}

impl GrowthMap {
    /// The map in the docs and in the window.
    pub const SHOWN: Self =
        Self { first_growth: 8.0, growth_step: 1.0, first_decay: 8.0, decay_step: 2.0, patches: [33, 13] };

    /// G of a column.
    #[must_use]
    pub fn growth(&self, column: usize) -> f32 {
        self.first_growth + self.growth_step * column as f32
    }

    /// β of a row, counted from below.
    #[must_use]
    pub fn decay(&self, row: usize) -> f32 {
        self.first_decay + self.decay_step * row as f32
    }

    /// G at the left and the right border, β at the lower and the upper one: half a patch beyond the outer patches.
    #[must_use]
    pub fn bounds(&self) -> [[f32; 2]; 2] {
        let [columns, rows] = self.patches.map(|count| count as f32 - 0.5);
        let along = |first: f32, step: f32, count: f32| [first - 0.5 * step, first + count * step];
        [along(self.first_growth, self.growth_step, columns), along(self.first_decay, self.decay_step, rows)]
    }
}
