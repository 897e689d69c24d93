//! What is found about the spots of a layer that has settled. Spots are numbered: the drawn ones first, then the others.

/// How the drawn spots differ from what was drawn.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DrawnSpots {
    /// How many there are.
    pub count: usize,
    /// Spots that grew, but differ by more than is tolerated.
    pub different: Vec<usize>,
    /// Whether some of these differ by so much that the pattern is corrected again.
    pub again: bool,
    /// Spots that have vanished, moved away or split, and so begin again.
    pub lost: Vec<usize>,
    /// Lost spots that have not split: their neighbours leave them too little room.
    pub crowded: Vec<usize>,
    /// The sum over the drawn spots: 1 for one that is lost, what it differs by for one that grew.
    pub error: f64,
}

/// Which of the spots that began have grown together with another.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MergedSpots {
    /// All but one, or but the drawn ones, of each grown spot.
    pub surplus: Vec<usize>,
    /// The others of these grown spots.
    pub kept: Vec<usize>,
    /// Of the kept ones all but one of each grown spot: drawn ones that are too near to each other.
    pub crowded: Vec<usize>,
}
