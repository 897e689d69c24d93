//! Results of comparing the spots of a settled layer. Spots are numbered: the drawn ones first, then the others.

/// The differences between the grown and the drawn spots.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnSpots {
    /// Number of drawn spots.
    pub count: usize,
    /// Spots that grew, but with an error above the tolerance.
    pub different: Vec<usize>,
    /// Whether some of these errors are so large that the pattern is corrected again.
    pub again: bool,
    /// Spots that have vanished, moved away or split, and so are restarted.
    pub lost: Vec<usize>,
    /// Lost spots that have not split: their neighbours leave them too little room.
    pub crowded: Vec<usize>,
    /// The sum over the drawn spots of their errors; 1 for a lost spot.
    pub error: f64,
}

/// The spots that have merged with another one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MergedSpots {
    /// For each merged spot, all original spots but one; drawn ones are never included.
    pub surplus: Vec<usize>,
    /// The other original spots of the merged ones.
    pub kept: Vec<usize>,
    /// Kept spots, all but one for each merged spot: drawn ones that are too near to each other.
    pub crowded: Vec<usize>,
}
