//! Which parts of a canvas hang together.

/// Labels that are joined as parts turn out to be one (union-find with path halving; Tarjan & van Leeuwen 1984).
#[derive(Debug, Default)]
pub struct Labels(Vec<u32>);

impl Labels {
    /// So many labels, each by itself.
    pub fn of(count: u32) -> Self {
        Self((0..count).collect())
    }

    /// A label that has not been given yet.
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

    /// Makes one of two; gives what [`Self::find`] finds for both.
    pub fn join(&mut self, a: u32, b: u32) -> u32 {
        let (a, b) = (self.find(a), self.find(b));
        let (least, other) = (a.min(b), a.max(b));
        self.0[other as usize] = least;
        least
    }
}
