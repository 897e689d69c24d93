//! The sweep: all runs of a plan, or a part of them, in parallel, each into the journal.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

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
    /// Simulations for each set [default: the planned number]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MOST_RUNS))]
    runs: Option<u64>,
    /// The folder to write into [default: training]
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Run only this part of the sweep, such as 3/16, and keep its journal for `data-gen merge`
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// Threads to use [default: all cores]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// Runs the sweep, and writes the files, or with `--shard` the journal of that part.
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
            crate::say(&format!(
                "part {shard} is done: {}; when all parts are done, `data-gen merge` writes their files",
                folder.join(shard.journal()).display()
            ))
        }
    }
}

/// Runs the simulations that are not yet in the journal, writes the files, and deletes the journal. Returns the number
/// of new runs.
pub fn whole(plan: &Plan, folder: &Path) -> Result<u64, String> {
    let Swept { journal, records, ran } = sweep(plan, folder, Shard::WHOLE)?;
    files::write(folder, plan, records)?;
    journal.remove()?;
    Ok(ran)
}

/// Runs the simulations of a part that are not yet in its journal. Returns the number of new runs.
pub fn part(plan: &Plan, folder: &Path, shard: Shard) -> Result<u64, String> {
    Ok(sweep(plan, folder, shard)?.ran)
}

/// The result of a sweep.
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
        let bar = Bar::new(&planned.name, shard.count(planned.runs), Tally::count_records(before));
        let (start, new) = (Instant::now(), Mutex::new(Vec::new()));
        let result = each(&left, |index| {
            let (verdict, line) = run(planned, index)?;
            let record = Record { set, index, verdict, line };
            journal.append(plan, &record)?;
            bar.done(verdict);
            new.lock().map_err(|_| "another run failed".to_owned())?.push(record);
            Ok(())
        });
        bar.clear();
        result?;
        records.append(&mut new.into_inner().map_err(|_| "a run failed".to_owned())?);
        let tally = Tally::count_records(records.iter().filter(|record| record.set == set));
        crate::say(&summary(&planned.name, &tally, left.len() as u64, start.elapsed()))?;
        ran += left.len() as u64;
    }
    Ok(Swept { journal, records, ran })
}

/// Does `work` with each of `items`. One thread works on one item at a time. Stops at the first failure.
///
/// Runs take from milliseconds to half a minute: each thread takes the next item when it is free. If the inner parallel work
/// (stepping and measuring a patch) shared the same pool, a waiting thread would start another run within its own, and so on.
fn each(items: &[u64], work: impl Fn(u64) -> Result<(), String> + Sync) -> Result<(), String> {
    let (next, failed) = (AtomicUsize::new(0), Mutex::new(None));
    let fail = |error: String| {
        next.store(items.len(), Ordering::Relaxed);
        if let Ok(mut failed) = failed.lock() {
            failed.get_or_insert(error);
        }
    };
    let alone = || {
        let pool = match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
            Ok(pool) => pool,
            Err(error) => return fail(format!("cannot start a thread: {error}")),
        };
        while let Some(item) = items.get(next.fetch_add(1, Ordering::Relaxed)) {
            if let Err(error) = pool.install(|| work(*item)) {
                return fail(error);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..rayon::current_num_threads().min(items.len()) {
            scope.spawn(alone);
        }
    });
    failed.into_inner().map_err(|_| "a run failed".to_owned())?.map_or(Ok(()), Err)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_item_is_worked_on_once_by_one_thread_alone() {
        let items: Vec<u64> = (0..100).collect();
        let done = Mutex::new(Vec::new());
        let work = |item| {
            assert_eq!(rayon::current_num_threads(), 1);
            done.lock().unwrap().push(item);
            Ok(())
        };
        assert_eq!(each(&items, work), Ok(()));
        let mut done = done.into_inner().unwrap();
        done.sort_unstable();
        assert_eq!(done, items);
    }

    #[test]
    fn nothing_is_begun_after_a_failure() {
        let begun = AtomicUsize::new(0);
        let work = |item| {
            begun.fetch_add(1, Ordering::Relaxed);
            if item == 3 { Err("the disk is full".to_owned()) } else { Ok(()) }
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
        let items: Vec<u64> = (0..100).collect();
        assert_eq!(pool.install(|| each(&items, work)), Err("the disk is full".to_owned()));
        assert_eq!(begun.into_inner(), 4);
    }
}
