//! The rows of one system, ready to be asked.

use std::path::Path;
use std::sync::OnceLock;

use super::coverage::Limit;
use super::csv_rows::read_rows;
use super::scale_law::Law;
use super::spot_map::SpotMap;
use super::stripe_map::StripeMap;
use super::{Row, TrainingError};

/// The systems that have a training set, by the names of the document.
pub const SYSTEMS: [&str; 3] = ["turing-spots", "meinhardt-spots", "meinhardt-stripes"];

/// A line in five dimensions, and a scatter about it, from fewer rows is a guess.
const FEWEST_ROWS: usize = 30;

/// What a system makes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Spots,
    Stripes,
}

/// The system of this name.
pub(super) fn find(name: &str) -> Result<(&'static str, Kind), TrainingError> {
    let unknown = || TrainingError::UnknownSystem { name: name.to_owned(), allowed: SYSTEMS.join(", ") };
    let system = *SYSTEMS.iter().find(|system| **system == name).ok_or_else(unknown)?;
    Ok((system, if system.ends_with("stripes") { Kind::Stripes } else { Kind::Spots }))
}

/// The rows of one system, ready to be asked.
pub struct TrainingSet {
    pub(super) system: &'static str,
    pub(super) rows: Vec<Row>,
    pub(super) map: Map,
    law: OnceLock<Law>,
}

/// The map between attributes and parameters, learnt from the rows.
pub(super) enum Map {
    Spots(Box<SpotMap>),
    Stripes(Box<StripeMap>),
}

impl TrainingSet {
    /// The set of `system` that is compiled in.
    ///
    /// # Errors
    /// [`TrainingError::UnknownSystem`]; the others only if the program was built from a broken file.
    pub fn embedded(system: &str) -> Result<Self, TrainingError> {
        let text = match find(system)?.0 {
            "turing-spots" => include_str!("../../training/turing-spots.csv"),
            "meinhardt-spots" => include_str!("../../training/meinhardt-spots.csv"),
            _ => include_str!("../../training/meinhardt-stripes.csv"),
        };
        Self::read(system, &format!("training/{system}.csv (compiled in)"), text.as_bytes())
    }

    /// The set of `system` in the folder `dir`: `dir/SYSTEM.csv`.
    ///
    /// # Errors
    /// [`TrainingError`]: no such system, no such file, or a fault in it with file, line, column and value.
    pub fn load(dir: &Path, system: &str) -> Result<Self, TrainingError> {
        let path = dir.join(format!("{}.csv", find(system)?.0));
        let bytes =
            std::fs::read(&path).map_err(|source| TrainingError::Open { path: path.clone(), source })?;
        Self::read(system, &path.display().to_string(), &bytes)
    }

    fn read(system: &str, file: &str, bytes: &[u8]) -> Result<Self, TrainingError> {
        let rows = read_rows(find(system)?.1, file, bytes)?;
        Self::new(system, rows).map_err(|error| match error {
            TrainingError::TooFew { rows, needed, .. } => {
                TrainingError::TooFew { file: file.to_owned(), rows, needed }
            }
            other => other,
        })
    }

    /// The set of `system` that these rows make.
    ///
    /// # Errors
    /// [`TrainingError::UnknownSystem`], [`TrainingError::TooFew`], [`TrainingError::Row`].
    pub fn from_rows(system: &str, rows: Vec<Row>) -> Result<Self, TrainingError> {
        // Writing checks every value.
        super::write_rows(system, &rows, std::io::sink())?;
        Self::new(system, rows)
    }

    fn new(system: &str, rows: Vec<Row>) -> Result<Self, TrainingError> {
        let (system, kind) = find(system)?;
        if rows.len() < FEWEST_ROWS {
            let file = format!("training/{system}.csv");
            return Err(TrainingError::TooFew { file, rows: rows.len(), needed: FEWEST_ROWS });
        }
        let map = match kind {
            Kind::Spots => Map::Spots(Box::new(SpotMap::new(&rows))),
            Kind::Stripes => Map::Stripes(Box::new(StripeMap::new(&rows))),
        };
        Ok(Self { system, rows, map, law: OnceLock::new() })
    }

    /// The system's name.
    #[must_use]
    pub fn system(&self) -> &'static str {
        self.system
    }

    /// The rows.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The laws of scale with the constants of these rows, worked out when first asked for.
    pub(super) fn law(&self) -> &Law {
        self.law.get_or_init(|| Law::of(&self.rows))
    }

    /// The lowest and highest value of each attribute in the set that limits a question, lengths in cells.
    #[must_use]
    pub fn reach(&self) -> Vec<(&'static str, [f64; 2])> {
        let limits = match &self.map {
            Map::Spots(map) => vec![&map.area, &map.density, &map.elongation],
            Map::Stripes(map) => vec![&map.width],
        };
        let shown = |limit: &Limit| {
            let [a, b] = limit.span.map(limit.shown);
            (limit.what, [a.min(b), a.max(b)])
        };
        limits.into_iter().map(shown).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::laws::{MEASURED, turing};
    use super::*;

    #[test]
    fn every_system_has_a_set_compiled_in() {
        for system in SYSTEMS {
            let set = TrainingSet::embedded(system).unwrap();
            assert_eq!(set.system(), system);
            assert!(set.rows().len() >= 200, "{system}: {}", set.rows().len());
        }
    }

    #[test]
    fn a_set_is_read_from_a_folder() {
        let dir = tempfile::tempdir().unwrap();
        let rows = turing(60, MEASURED);
        let file = std::fs::File::create(dir.path().join("turing-spots.csv")).unwrap();
        super::super::write_rows("turing-spots", &rows, file).unwrap();
        assert_eq!(TrainingSet::load(dir.path(), "turing-spots").unwrap().rows().len(), 60);

        let message = |system| TrainingSet::load(dir.path(), system).err().unwrap().to_string();
        assert!(message("meinhardt-spots").contains("meinhardt-spots.csv: cannot be read"));
        assert!(message("spots").contains("allowed: turing-spots, meinhardt-spots, meinhardt-stripes"));
        std::fs::write(dir.path().join("meinhardt-spots.csv"), [0xff, 0xfe, 0x00]).unwrap();
        assert!(message("meinhardt-spots").contains("meinhardt-spots.csv, line 1"));
    }

    #[test]
    fn too_few_rows_are_refused() {
        let error = TrainingSet::from_rows("turing-spots", turing(29, MEASURED)).err().unwrap();
        assert!(error.to_string().contains("29 rows are too few"), "{error}");
        assert!(TrainingSet::from_rows("turing-spots", turing(30, MEASURED)).is_ok());
    }

    #[test]
    fn the_reach_is_that_of_the_rows() {
        let set = TrainingSet::from_rows("turing-spots", turing(60, MEASURED)).unwrap();
        let aspects = set.rows().iter().filter_map(|row| match row.attributes {
            crate::attributes::Attributes::Spots(spots) => Some(spots.aspect),
            crate::attributes::Attributes::Stripes(_) => None,
        });
        let highest = aspects.fold(0.0, f64::max);
        let reach = set.reach();
        assert_eq!(
            reach.iter().map(|(name, _)| *name).collect::<Vec<_>>(),
            ["area", "area/spacing²", "aspect"]
        );
        assert!((reach[2].1[1] - highest).abs() < 1e-12);
    }
}
