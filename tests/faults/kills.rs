//! Kills the program by kill -9 at random moments while it writes over older files: afterwards each file is the
//! complete old or new one, and the next run removes temporary files.
//!
//! `DAPPLE_KILLS` is the number of kills (default 8), `DAPPLE_SEED` the seed of the random moments (default 1).

use std::collections::BTreeMap;
use std::fs;
use std::os::unix::process::ExitStatusExt;
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::bench::{Bench, files, is_part, say};
use crate::running::Running;

type Files = BTreeMap<String, Vec<u8>>;

/// Time between two checks of what is being written.
const BETWEEN: Duration = Duration::from_micros(100);

/// A command that writes into `out`, with the command that writes the older files.
struct Job {
    old: &'static str,
    new: &'static str,
}

/// Half of the kills go to the first command, which writes most.
const JOBS: [Job; 9] = [
    Job {
        old: "grow b.dapple -o out/a.png --pattern out/p.tif --labels out/l.png --concentrations out/c.exr --svg out/a.svg \
              --dxf out/a.dxf --report out/r.json --size 192x192",
        new: "grow a.dapple -o out/a.png --pattern out/p.tif --labels out/l.png --concentrations out/c.exr --svg out/a.svg \
              --dxf out/a.dxf --report out/r.json --size 192x192 --material out/m",
    },
    Job {
        old: "film b.dapple -o out/f.gif --seconds 0.5 --fps 10",
        new: "film a.dapple -o out/f.gif --seconds 0.5 --fps 10",
    },
    Job {
        old: "film b.dapple -o out/f.png --seconds 0.5 --fps 10",
        new: "film a.dapple -o out/f.png --seconds 0.5 --fps 10",
    },
    Job { old: "import in.svg -o out/i.dapple", new: "film a.dapple -o out/frames --seconds 0.5 --fps 10" },
    Job { old: "grow a.dapple b.dapple -o out --seed 7", new: "grow a.dapple b.dapple -o out" },
    Job {
        old: "sheet b.dapple a.dapple -o out/s.png --thumb 64",
        new: "sheet a.dapple b.dapple -o out/s.png --thumb 64",
    },
    Job { old: "import in.svg -o out/i.dapple --dpi 48", new: "import in.svg -o out/i.dapple" },
    Job { old: "lookup --batch other.csv -o out/t.csv", new: "lookup --batch in.csv -o out/t.csv" },
    Job {
        old: "learn --no-simulation --targets 1 --system meinhardt-lines -o out/e.csv",
        new: "learn --no-simulation --targets 2 --system meinhardt-lines -o out/e.csv",
    },
];

fn number(name: &str, usual: u64) -> u64 {
    std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

/// The files, with the times in the report set to 0.
fn without_time(mut files: Files) -> Files {
    if let Some(bytes) = files.get_mut("r.json")
        && let Ok(mut report) = serde_json::from_slice::<serde_json::Value>(bytes)
    {
        report["seconds"] = 0.into();
        *bytes = report.to_string().into_bytes();
    }
    files
}

/// The duration of a run, and the time until it begins to write.
struct Course {
    whole: Duration,
    writes: Duration,
}

struct Killing {
    bench: Bench,
    old: Files,
    new: Files,
    course: Course,
    random: Pcg64Mcg,
}

/// Counts of the results.
#[derive(Default)]
struct Count {
    killed: u64,
    ended: u64,
    /// Kills while a file was being written.
    writing: u64,
    /// Files that were afterwards old, and new.
    old: u64,
    new: u64,
}

impl Killing {
    fn new(job: &Job, random: Pcg64Mcg) -> Self {
        let bench = Bench::new();
        bench.write("other.csv", "system,width,angle\nmeinhardt-stripes,11,80\n");
        fs::create_dir(bench.path("out")).unwrap();
        bench.does(job.old);
        let old = files(&bench.path("out"));
        let began = Instant::now();
        let mut running = start(&bench, job.new);
        let mut writes = None;
        while !running.ends_within(BETWEEN) {
            if writes.is_none() && is_writing(&bench.path("out")) {
                writes = Some(began.elapsed());
            }
        }
        let whole = began.elapsed();
        assert!(running.child.wait().unwrap().success(), "{}", job.new);
        let new = without_time(files(&bench.path("out")));
        assert!(new.len() >= old.len() && new != old);
        Self { bench, old, new, course: Course { whole, writes: writes.unwrap_or(whole) }, random }
    }

    /// Restores the old files; temporary files of a killed run stay.
    fn renew(&self) {
        for name in self.new.keys().filter(|name| !self.old.contains_key(*name)) {
            let _ = fs::remove_file(self.bench.path("out").join(name));
        }
        // A film of frames may have an empty folder at its path.
        let _ = fs::remove_dir(self.bench.path("out/frames"));
        for (name, bytes) in &self.old {
            fs::write(self.bench.path("out").join(name), bytes).unwrap();
        }
    }

    /// Waits for a random moment (every second time, until the run writes), and kills the run.
    fn kill(&mut self, job: &Job, while_writing: bool, count: &mut Count) {
        let out = self.bench.path("out");
        let mut running = start(&self.bench, job.new);
        let Course { whole, writes } = self.course;
        while while_writing && !is_writing(&out) && !running.ends_within(BETWEEN) {}
        let most = if while_writing { whole.saturating_sub(writes) } else { whole };
        running.ends_within(most.mul_f64(self.random.random_range(0.0..1.0)));
        running.child.kill().unwrap();
        match running.child.wait().unwrap().signal() {
            Some(9) => count.killed += 1,
            _ => count.ended += 1,
        }
        if files(&out).keys().any(|name| is_part(name)) {
            count.writing += 1;
        }
    }

    /// Checks that each file is the old or the new one.
    fn check(&self, job: &Job, count: &mut Count) {
        let there = without_time(files(&self.bench.path("out")));
        let old = without_time(self.old.clone());
        for (name, bytes) in there.iter().filter(|(name, _)| !is_part(name)) {
            if self.new.get(name) == Some(bytes) {
                count.new += 1;
            } else {
                assert!(old.get(name) == Some(bytes), "{}: {name} is damaged", job.new);
                count.old += 1;
            }
        }
        for name in old.keys() {
            assert!(there.contains_key(name), "{}: {name} is lost", job.new);
        }
    }
}

fn start(bench: &Bench, arguments: &str) -> Running {
    Running::start(bench.command(arguments).stderr(Stdio::null()))
}

/// The number of temporary files and folders.
fn parts(folder: &Path) -> usize {
    let names = |folder: &Path| -> Vec<String> {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
    };
    [folder, &folder.join("m")].into_iter().flat_map(names).filter(|name| is_part(name)).count()
}

fn is_writing(folder: &Path) -> bool {
    parts(folder) > 0
}

#[test]
fn files_are_complete_old_or_new_ones_after_the_program_was_killed() {
    let (kills, seed) = (number("DAPPLE_KILLS", 8), number("DAPPLE_SEED", 1));
    let mut all = Count::default();
    for (index, job) in JOBS.iter().enumerate() {
        let others = JOBS.len() as u64 - 1;
        let times = if index == 0 { kills.div_ceil(2) } else { (kills / 2).div_ceil(others) };
        let random = Pcg64Mcg::seed_from_u64(seed + 1000 * index as u64);
        let mut killing = Killing::new(job, random);
        let mut count = Count::default();
        // If a run ended before the kill, it is repeated, a limited number of times.
        let mut turn = 0;
        while count.killed < times && turn < 4 * times {
            // Temporary files of the previous run would be counted for this one.
            clear_parts(&killing.bench.path("out"));
            killing.renew();
            killing.kill(job, turn % 2 == 0, &mut count);
            killing.check(job, &mut count);
            turn += 1;
        }
        killing.renew();
        killing.bench.does(job.new);
        assert!(
            without_time(files(&killing.bench.path("out"))) == killing.new,
            "{}: not the same again",
            job.new
        );
        let Count { killed, ended, writing, old, new } = count;
        let name: String = job.new.split_whitespace().take(4).collect::<Vec<_>>().join(" ");
        // Written directly to stderr, because these numbers are reported.
        let times = format!("{killed:3} killed ({writing} while writing), {ended} ended before");
        say(&format!("{name:34} {times}; then {old} old files, {new} new"));
        all.killed += killed;
        all.writing += writing;
    }
    say(&format!("{} kills in all, {} while writing; no damaged file", all.killed, all.writing));
    assert!(all.killed > 0 && all.writing > 0);
}

/// Removes the temporary files of the previous run.
fn clear_parts(out: &Path) {
    for name in files(out).keys().filter(|name| is_part(name)) {
        let _ = fs::remove_file(out.join(name));
        let _ =
            out.join(name).parent().filter(|parent| is_part(&parent.to_string_lossy())).map(fs::remove_dir);
    }
}

#[test]
fn the_next_run_into_a_folder_removes_what_a_killed_one_left() {
    let bench = Bench::new();
    fs::create_dir(bench.path("out")).unwrap();
    let job = "grow a.dapple -o out/a.png --size 256x256 --scale 8";
    // The run may have ended before the kill.
    for _ in 0..20 {
        let mut child = start(&bench, job).child;
        while child.try_wait().unwrap().is_none() && !is_writing(&bench.path("out")) {
            std::thread::yield_now();
        }
        child.kill().unwrap();
        child.wait().unwrap();
        if is_writing(&bench.path("out")) {
            break;
        }
    }
    assert!(is_writing(&bench.path("out")), "it was never caught");
    bench.does("import in.svg -o out/i.dapple");
    assert_eq!(parts(&bench.path("out")), 0);
    // Not while another process is writing: both processes complete.
    fs::remove_file(bench.path("out/a.png")).unwrap_or_default();
    let mut child = start(&bench, job).child;
    while child.try_wait().unwrap().is_none() {
        bench.does("import in.svg -o out/i.dapple");
    }
    assert!(child.wait().unwrap().success() && bench.path("out/a.png").exists());
    assert_eq!(parts(&bench.path("out")), 0);
}
