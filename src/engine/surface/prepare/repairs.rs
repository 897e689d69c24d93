//! Counts of the defects of a mesh.

/// Number of repairs of each kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// Faces with corners that are not finite or no vertices.
    pub unreal: usize,
    /// Vertices that were joined with another one at the same place.
    pub welded: usize,
    /// Faces without area.
    pub flat: usize,
    /// Faces with the same corners as another one.
    pub doubled: usize,
    /// Edges at which more than two faces met.
    pub crowded: usize,
    /// Vertices at which faces met without a common edge.
    pub pinched: usize,
    /// Faces that were reversed.
    pub turned: usize,
    /// Edges along which a one-sided surface was cut.
    pub cut: usize,
}

impl Repairs {
    /// Notes on them for the user, in words. Vertices are welded in most models: files store them once per face.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let parts = [
            (self.unreal, "faces with corners that are not finite numbers were dropped"),
            (self.flat, "faces without an area were dropped"),
            (self.doubled, "faces that were there twice were dropped"),
            (self.crowded, "edges at which more than two faces met were taken apart"),
            (self.pinched, "vertices at which parts met in a point only were taken apart"),
            (self.turned, "faces that pointed inwards were turned over"),
            (self.cut, "edges of a one-sided surface were cut open"),
        ];
        parts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}")).collect()
    }
}
