//! The rows of one system, prepared for questions.

use std::sync::OnceLock;

use super::brought_rows::rows_of;
use super::compiled_rows::compiled_rows;
use super::coverage::Limit;
use super::csv_rows::read_rows;
use super::folder::Folder;
use super::folder_rows::rows_of_folder;
use super::row::FEWEST_ROWS;
use super::scale_law::Law;
use super::spot_ranges::SpotRanges;
use super::stripe_regression::StripeRegression;
use super::{InCells, Row, TrainingError};
use crate::attributes::Attribute;
use crate::attributes::system::{Description, MarkKind, TrainingFile};

/// The rows of one system, prepared for questions.
pub struct TrainingSet {
    pub(super) system: &'static Description,
    pub(super) rows: Vec<Row>,
    pub(super) map: Regressions,
    law: OnceLock<Law>,
}

/// The map between attributes and parameters, learnt from the rows.
pub(super) enum Regressions {
    Spots(Box<SpotRanges>),
    Stripes(Box<StripeRegression>),
}

impl TrainingSet {
    /// The embedded set of `system`.
    ///
    /// # Errors
    /// [`TrainingError`], only if the program was built from a broken file.
    pub fn embedded(system: &'static Description) -> Result<Self, TrainingError> {
        let named = |file: &'static TrainingFile| {
            (format!("training/{}.csv (compiled in)", file.name), rows_of(file))
        };
        let mut rows = Vec::new();
        for (name, of_file) in system.training.iter().map(named) {
            rows.extend(compiled_rows(system, &name, of_file)?);
        }
        Self::new(system, rows, system.neighbours)
    }

    /// The set of `system` in `folder`: the rows of `SYSTEM.csv` and of each `SYSTEM-*.csv`, in the order of
    /// their names. `known` are all existing systems: if no file is found, the error names the systems that have files.
    ///
    /// # Errors
    /// [`TrainingError`]: no such file, or a fault in one with file, line, column and value.
    pub fn load(
        folder: &dyn Folder,
        system: &'static Description,
        known: &[&'static Description],
    ) -> Result<Self, TrainingError> {
        let (rows, names) =
            rows_of_folder(folder, system, known, |name, bytes| read_rows(system, name, bytes))?;
        Self::from_files(system, rows, &names)
    }

    /// The rows of all `files` (names for messages, contents) as one set.
    ///
    /// # Errors
    /// [`TrainingError`]: a fault in a file with line, column and value, or too few rows.
    pub fn read<'a>(
        system: &'static Description,
        files: impl Iterator<Item = (&'a str, &'a [u8])>,
    ) -> Result<Self, TrainingError> {
        let (mut rows, mut names) = (Vec::new(), Vec::new());
        for (file, bytes) in files {
            rows.extend(read_rows(system, file, bytes)?);
            names.push(file.to_owned());
        }
        Self::from_files(system, rows, &names)
    }

    /// All rows of files with these names as one set.
    fn from_files(
        system: &'static Description,
        rows: Vec<Row>,
        names: &[String],
    ) -> Result<Self, TrainingError> {
        Self::new(system, rows, &[]).map_err(|error| match error {
            TrainingError::TooFew { rows, needed, .. } => {
                TrainingError::TooFew { file: names.join(", "), rows, needed }
            }
            other => other,
        })
    }

    /// The set of `system` with these rows.
    ///
    /// # Errors
    /// [`TrainingError::TooFew`], [`TrainingError::Row`].
    pub fn from_rows(system: &'static Description, rows: Vec<Row>) -> Result<Self, TrainingError> {
        // Writing checks every value.
        super::write_rows(system, &rows, std::io::sink())?;
        Self::new(system, rows, &[])
    }

    /// The numbers of `neighbours` of the regressions are chosen by cross validation where they are not known.
    fn new(
        system: &'static Description,
        rows: Vec<Row>,
        neighbours: &[usize],
    ) -> Result<Self, TrainingError> {
        if rows.len() < FEWEST_ROWS {
            let file = format!("training/{}.csv", system.name);
            return Err(TrainingError::TooFew { file, rows: rows.len(), needed: FEWEST_ROWS });
        }
        let map = match system.marks {
            MarkKind::Spots => Regressions::Spots(Box::new(SpotRanges::new(&rows, neighbours))),
            MarkKind::Stripes => Regressions::Stripes(Box::new(StripeRegression::new(&rows, neighbours))),
        };
        Ok(Self { system, rows, map, law: OnceLock::new() })
    }

    /// The system.
    #[must_use]
    pub fn system(&self) -> &'static Description {
        self.system
    }

    /// The rows.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// The laws of scale with the constants of these rows, computed at first use.
    pub(super) fn law(&self) -> &Law {
        self.law.get_or_init(|| Law::fitted(self.system.scaling, &self.rows))
    }

    /// The numbers of neighbours of its regressions.
    #[cfg(test)]
    pub fn regression_neighbours(&self) -> Vec<usize> {
        match &self.map {
            Regressions::Spots(map) => map.neighbours(),
            Regressions::Stripes(map) => map.neighbours(),
        }
    }

    /// The lowest and highest value of each attribute in the set that limits a question.
    #[must_use]
    pub fn reach(&self) -> InCells<Vec<(Attribute, [f64; 2])>> {
        let limits = match &self.map {
            Regressions::Spots(map) => vec![&map.usual().area, &map.usual().density, &map.elongation],
            Regressions::Stripes(map) => std::iter::once(&map.width).chain(map.duty.as_ref()).collect(),
        };
        let shown = |limit: &Limit| {
            let [a, b] = limit.span.map(limit.shown);
            (limit.what, [a.min(b), a.max(b)])
        };
        InCells(limits.into_iter().map(shown).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::super::laws::{MEASURED, MEINHARDT, SYSTEMS, TURING, turing};
    use super::*;
    use std::collections::BTreeMap;
    use std::io;
    use std::path::Path;

    #[test]
    fn every_system_has_an_embedded_training_set() {
        for system in SYSTEMS {
            let set = TrainingSet::embedded(system).unwrap();
            assert_eq!(set.system().name, system.name);
            assert!(set.rows().len() >= 200, "{}: {}", system.name, set.rows().len());
        }
    }

    /// Files in memory, by name.
    struct Memory(BTreeMap<String, Vec<u8>>);

    impl Folder for Memory {
        fn path(&self) -> &Path {
            Path::new("sets")
        }

        fn names(&self) -> io::Result<Vec<String>> {
            Ok(self.0.keys().rev().cloned().collect())
        }

        fn read(&self, name: &str) -> io::Result<Option<Vec<u8>>> {
            Ok(self.0.get(name).cloned())
        }
    }

    /// A folder that cannot be read.
    struct Nowhere;

    impl Folder for Nowhere {
        fn path(&self) -> &Path {
            Path::new("nowhere")
        }

        fn names(&self) -> io::Result<Vec<String>> {
            Err(io::ErrorKind::NotFound.into())
        }

        fn read(&self, _: &str) -> io::Result<Option<Vec<u8>>> {
            Ok(None)
        }
    }

    #[test]
    fn a_set_is_read_from_all_its_files_in_a_folder() {
        let rows = turing(60, MEASURED);
        let mut folder = Memory(BTreeMap::new());
        let mut write = |name: &str, rows: &[Row]| {
            let mut bytes = Vec::new();
            super::super::write_rows(&TURING, rows, &mut bytes).unwrap();
            folder.0.insert(name.to_owned(), bytes);
        };
        write("turing-spots-b.csv", &rows[50..]);
        write("turing-spots.csv", &rows[..20]);
        write("turing-spots-a.csv", &rows[20..50]);
        // This file does not belong to the set.
        write("turing-spots-a.rejected.csv", &rows);
        write("turing-spotted.csv", &rows);
        write("old-turing-spots.csv", &rows);
        folder.0.insert("notes.json".to_owned(), b"{}".to_vec());
        let set = TrainingSet::load(&folder, &TURING, &SYSTEMS).unwrap();
        // '-' sorts before '.'.
        let seeds: Vec<u64> = set.rows().iter().map(|row| row.seed).collect();
        let expected = rows[20..].iter().chain(&rows[..20]).map(|row| row.seed);
        assert_eq!(seeds, expected.collect::<Vec<_>>());

        let message =
            |folder: &Memory| TrainingSet::load(folder, &MEINHARDT, &SYSTEMS).err().unwrap().to_string();
        let missing = message(&folder);
        assert!(missing.contains("neither meinhardt-spots.csv nor meinhardt-spots-*.csv"), "{missing}");
        assert!(missing.contains("it has rows of turing-spots:"), "{missing}");
        folder.0.insert("meinhardt-spots.csv".to_owned(), vec![0xff, 0xfe, 0x00]);
        assert!(message(&folder).contains("meinhardt-spots.csv, line 1"));
        let nowhere = TrainingSet::load(&Nowhere, &TURING, &SYSTEMS).err().unwrap().to_string();
        assert!(nowhere.contains("nowhere: cannot be read"), "{nowhere}");
    }

    #[test]
    fn too_few_rows_are_refused() {
        let error = TrainingSet::from_rows(&TURING, turing(29, MEASURED)).err().unwrap();
        assert!(error.to_string().contains("29 rows are too few"), "{error}");
        assert!(TrainingSet::from_rows(&TURING, turing(30, MEASURED)).is_ok());
    }

    #[test]
    fn the_range_of_a_set_is_that_of_its_rows() {
        let set = TrainingSet::from_rows(&TURING, turing(60, MEASURED)).unwrap();
        let aspects = set.rows().iter().filter_map(|row| match row.attributes.0 {
            crate::attributes::Attributes::Spots(spots) => Some(spots.aspect),
            crate::attributes::Attributes::Stripes(_) => None,
        });
        let highest = aspects.fold(0.0, f64::max);
        let InCells(reach) = set.reach();
        assert_eq!(
            reach.iter().map(|(attribute, _)| *attribute).collect::<Vec<_>>(),
            [Attribute::Area, Attribute::Density, Attribute::Aspect]
        );
        assert!((reach[2].1[1] - highest).abs() < 1e-12);
    }
}
