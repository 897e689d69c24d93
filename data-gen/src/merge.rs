//! Joins the parts of a sweep that were run separately.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::files;
use crate::journal::{Part, difference};
use crate::progress::Tally;
use crate::run::Record;
use crate::shard::Shard;

/// The parts to join, and where to write.
#[derive(clap::Args)]
pub struct Args {
    /// Folders with the journals that `data-gen sweep --shard` left
    #[arg(value_name = "DIR", required = true)]
    parts: Vec<PathBuf>,
    /// The folder to write into
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
}

/// Carries out the command.
pub fn command(args: &Args) -> Result<(), String> {
    merge(&args.parts, &args.output)?.iter().try_for_each(|printed| crate::say(printed))
}

/// Joins all parts whose journals lie in these folders, and writes the files into `output`. The journals stay. Returns
/// a one-line summary for each set.
pub fn merge(folders: &[PathBuf], output: &Path) -> Result<Vec<String>, String> {
    let mut parts = Vec::new();
    for folder in folders {
        for path in journals(folder)? {
            parts.push(Part::read(&path)?);
        }
    }
    let Some(first) = parts.first() else {
        let folders: Vec<String> = folders.iter().map(|folder| folder.display().to_string()).collect();
        return Err(format!("no journal (sweep-I-of-N.journal) in {}", folders.join(", ")));
    };
    check(&parts)?;
    let plan = first.plan.clone();
    let records: Vec<Record> = parts.into_iter().flat_map(|part| part.records).collect();
    let printed = |(number, name): (usize, &String)| {
        let tally = Tally::count_records(records.iter().filter(|record| record.set == number));
        format!("{name}: {} runs: {tally}", tally.all())
    };
    let printed = plan.sets.iter().map(|set| &set.name).enumerate().map(printed).collect();
    files::write(output, &plan, records)?;
    Ok(printed)
}

/// The journals in a folder, by name.
fn journals(folder: &Path) -> Result<Vec<PathBuf>, String> {
    let failed = |error: std::io::Error| format!("{}: cannot be read: {error}", folder.display());
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.extension().is_some_and(|ending| ending == "journal") {
            paths.push(path);
        }
    }
    paths.sort();
    Ok(paths)
}

/// Checks that these are all parts of one sweep, each present once and complete.
fn check(parts: &[Part]) -> Result<(), String> {
    let Some(first) = parts.first() else { return Ok(()) };
    let mut by_part: BTreeMap<u64, &Part> = BTreeMap::new();
    for part in parts {
        let [a, b] = [&part.plan, &first.plan].map(|plan| serde_json::to_value(plan).unwrap_or_default());
        let apart = difference(&a, &b).map(|inside| format!("plan: {}", inside.trim_start()));
        let apart = apart.or_else(|| {
            (part.shard.of != first.shard.of)
                .then(|| format!("part {} there, {} here", part.shard, first.shard))
        });
        if let Some(apart) = apart {
            return Err(format!(
                "{} and {} belong to different sweeps ({apart})",
                part.path.display(),
                first.path.display()
            ));
        }
        if let Some(before) = by_part.insert(part.shard.part, part) {
            return Err(format!(
                "{} and {} are both part {}; leave one out",
                before.path.display(),
                part.path.display(),
                part.shard
            ));
        }
    }
    let of = first.shard.of;
    for number in 1..=of {
        let shard = Shard { part: number, of };
        let Some(part) = by_part.get(&number) else {
            return Err(format!("part {shard} is missing: run `data-gen sweep … --shard {shard}`"));
        };
        let expected: u64 = part.plan.sets.iter().map(|set| shard.count(set.runs)).sum();
        let there = part.records.len() as u64;
        if there < expected {
            return Err(format!(
                "{}: {there} of {expected} runs of part {shard} are there: start that part again, it \
                 continues where it stopped",
                part.path.display()
            ));
        }
    }
    Ok(())
}
