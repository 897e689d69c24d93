//! The list of passes.

/// A pass over a layer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass {
    /// Small patches are grown, to correct the parameters that were looked up.
    Probes,
    /// The pattern grows until it has settled. Drawn marks are moved back to their places.
    Growth,
    /// The threshold of each region is moved until areas or widths are as asked for.
    Thresholds,
    /// The threshold of each drawn spot is moved until its area is as drawn. The thresholds of the other spots compensate for it.
    OwnThresholds,
    /// If only a few spots have merged, all but one of each are removed, and only the cells about them are grown again.
    Parts,
    /// The best pattern so far is kept.
    Keep,
    /// If many spots have merged, all but one of each are removed.
    Separation,
    /// Neighbours of drawn spots that have not grown are removed, and the spots beside these are restarted with them.
    Room,
    /// Drawn spots with errors continue with corrected parameters; those that have not grown are restarted.
    Corrections,
    /// Drawn spots that merge with another one with any parameters are left out.
    LeavingOut,
    /// Half-grown spots are restarted.
    Mending,
    /// Marks beneath rotate and stretch the spots between them: the layer grows once more, with parameters that compensate for it.
    Bias,
    /// Edges get the raggedness that is asked for.
    Raggedness,
}

impl Pass {
    /// All passes in their order.
    pub const ALL: [Self; 13] = [
        Self::Probes,
        Self::Growth,
        Self::Thresholds,
        Self::OwnThresholds,
        Self::Parts,
        Self::Keep,
        Self::Separation,
        Self::Room,
        Self::Corrections,
        Self::LeavingOut,
        Self::Mending,
        Self::Bias,
        Self::Raggedness,
    ];

    /// Its name in tables and arguments.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Probes => "probes",
            Self::Growth => "growth",
            Self::Thresholds => "thresholds",
            Self::OwnThresholds => "own-thresholds",
            Self::Parts => "parts",
            Self::Keep => "keep",
            Self::Separation => "separation",
            Self::Room => "room",
            Self::Corrections => "corrections",
            Self::LeavingOut => "leaving-out",
            Self::Mending => "mending",
            Self::Bias => "bias",
            Self::Raggedness => "raggedness",
        }
    }

    /// Whether a layer can be grown without it.
    #[must_use]
    pub fn can_be_left_out(self) -> bool {
        !matches!(self, Self::Growth | Self::Keep)
    }
}

/// Some of the passes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PassSet(u16);

impl PassSet {
    /// No pass.
    pub const NONE: Self = Self(0);

    /// This set with `pass` added.
    #[must_use]
    pub fn with(self, pass: Pass) -> Self {
        Self(self.0 | 1 << pass as u16)
    }

    /// Whether `pass` is one of them.
    #[must_use]
    pub fn has(self, pass: Pass) -> bool {
        self.0 & 1 << pass as u16 != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pass_has_its_own_place_and_name() {
        for (index, pass) in Pass::ALL.into_iter().enumerate() {
            assert_eq!(pass as usize, index);
            assert_eq!(Pass::ALL.iter().filter(|other| other.name() == pass.name()).count(), 1);
        }
    }

    #[test]
    fn a_set_contains_the_passes_that_were_added() {
        let set = PassSet::NONE.with(Pass::Room).with(Pass::Raggedness);
        let has: Vec<Pass> = Pass::ALL.into_iter().filter(|pass| set.has(*pass)).collect();
        assert_eq!(has, [Pass::Room, Pass::Raggedness]);
    }
}
