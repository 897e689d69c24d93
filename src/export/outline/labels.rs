//! Which parts of a canvas are connected.

/// Labels of parts, joined when parts turn out to be connected (union-find with path halving; Tarjan & van Leeuwen 1984).
#[derive(Debug, Default)]
pub struct Labels(Vec<u32>);

impl Labels {
    /// `count` labels, none joined.
    pub fn new(count: u32) -> Self {
        Self((0..count).collect())
    }

    /// A new label.
    pub fn new_label(&mut self) -> u32 {
        let label = self.0.len() as u32;
        self.0.push(label);
        label
    }

    /// The least of the labels joined with this one.
    pub fn find(&mut self, mut label: u32) -> u32 {
        while self.0[label as usize] != label {
            self.0[label as usize] = self.0[self.0[label as usize] as usize];
            label = self.0[label as usize];
        }
        label
    }

    /// Joins two labels; returns what [`Self::find`] then returns for both.
    pub fn join(&mut self, a: u32, b: u32) -> u32 {
        let (a, b) = (self.find(a), self.find(b));
        let (least, other) = (a.min(b), a.max(b));
        self.0[other as usize] = least;
        least
    }
}
