//! The sweep: all runs of a plan, or a part of them, in parallel, each into the journal.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Instant;

use rayon::prelude::*;

use crate::files;
use crate::journal::Journal;
use crate::plan::{MOST_RUNS, Plan};
use crate::progress::{Bar, Tally, summary};
use crate::run::{Record, run};
use crate::shard::Shard;

/// What to sweep, and where to write.
#[derive(clap::Args)]
pub struct Args {
    /// Sweep this plan instead of the built-in one, which `data-gen plan` prints; needs -o
    #[arg(long, value_name = "FILE", requires = "output")]
    plan: Option<PathBuf>,
    /// Only this set; may be given more than once
    #[arg(long, value_name = "NAME")]
    set: Vec<String>,
    /// Simulations a set [default: as planned for each]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MOST_RUNS))]
    runs: Option<u64>,
    /// The folder to write into [default: training]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Run only this part of it, such as 3/16, and leave its journal for `data-gen merge`
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// Threads to use [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// Sweeps, and writes the files, or with `--shard` the journal of that part.
pub fn command(args: &Args) -> Result<(), String> {
    if let Some(threads) = args.threads {
        rayon::ThreadPoolBuilder::new()
            .num_threads(usize::from(threads))
            .build_global()
            .map_err(|error| format!("cannot start {threads} threads: {error}"))?;
    }
    let plan = args.plan.as_ref().map_or_else(Plan::built_in, |path| Plan::load(path))?;
    let plan = plan.chosen(&args.set, args.runs)?;
    let folder = args.output.clone().unwrap_or_else(|| PathBuf::from("training"));
    match args.shard {
        None => whole(&plan, &folder).map(drop),
        Some(shard) => {
            part(&plan, &folder, shard)?;
            println!(
                "part {shard} is done: {}; when all parts are, `data-gen merge` makes the files of them",
                folder.join(shard.journal()).display()
            );
            Ok(())
        }
    }
}

/// Runs all that is not yet in the journal, writes the files, and takes the journal away. Gives how many it ran.
pub fn whole(plan: &Plan, folder: &Path) -> Result<u64, String> {
    let Swept { journal, records, ran } = sweep(plan, folder, Shard::WHOLE)?;
    files::write(folder, plan, records)?;
    journal.remove()?;
    Ok(ran)
}

/// Runs all of a part that is not yet in its journal. Gives how many it ran.
pub fn part(plan: &Plan, folder: &Path, shard: Shard) -> Result<u64, String> {
    Ok(sweep(plan, folder, shard)?.ran)
}

/// What was swept.
struct Swept {
    journal: Journal,
    /// All runs of this part, in any order.
    records: Vec<Record>,
    /// How many of them ran now.
    ran: u64,
}

fn sweep(plan: &Plan, folder: &Path, shard: Shard) -> Result<Swept, String> {
    files::make_folder(folder)?;
    let (journal, mut records) = Journal::open(folder, shard, plan)?;
    let mut ran = 0;
    for (set, planned) in plan.sets.iter().enumerate() {
        let before: Vec<&Record> = records.iter().filter(|record| record.set == set).collect();
        let done: BTreeSet<u64> = before.iter().map(|record| record.index).collect();
        let left: Vec<u64> =
            (0..planned.runs).filter(|index| shard.holds(*index) && !done.contains(index)).collect();
        let bar = Bar::new(&planned.name, shard.count(planned.runs), Tally::of(before));
        let (start, new) = (Instant::now(), Mutex::new(Vec::new()));
        // Runs cost from milliseconds to seconds, and the order in which they end does not matter.
        let result = left.par_iter().with_max_len(1).try_for_each(|index| {
            let (verdict, line) = run(planned, *index)?;
            let record = Record { set, index: *index, verdict, line };
            journal.append(plan, &record)?;
            bar.done(verdict);
            new.lock().map_err(|_| "another run failed".to_owned())?.push(record);
            Ok::<(), String>(())
        });
        bar.clear();
        result?;
        records.append(&mut new.into_inner().map_err(|_| "a run failed".to_owned())?);
        let tally = Tally::of(records.iter().filter(|record| record.set == set));
        println!("{}", summary(&planned.name, &tally, left.len() as u64, start.elapsed()));
        ran += left.len() as u64;
    }
    Ok(Swept { journal, records, ran })
}
