//! `dapple data-set`: labelled textures of random sketches.

use super::progress::Bar;
use super::{Error, values};
use crate::data_set::{ItemError, Kind, Settings, item, manifest};
use crate::files;
use crate::machine::{fs, threads};
use crate::synth::{Stage, Watch};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

/// The file that says what the items of a folder are made from.
const MANIFEST: &str = "data-set.json";
/// Items in a folder.
const IN_A_FOLDER: u64 = 1_000;
/// The most items.
const MOST: u64 = 1_000_000_000;

/// Arguments of `dapple data-set`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The folder for the items; those that are there already are not made again
    #[arg(short, long, value_name = "DIR")]
    pub output: PathBuf,
    /// How many items
    #[arg(long, value_name = "N", value_parser = values::whole(1..=MOST))]
    pub count: u64,
    /// The index of the first item: several processes can make parts of a data set
    #[arg(long, value_name = "K", default_value = "0", value_parser = values::whole(0..=MOST))]
    pub first: u64,
    /// The seed of all random numbers
    #[arg(long, value_name = "S", default_value = "1", value_parser = values::seed)]
    pub seed: u64,
    /// Width and height of the pictures, px
    #[arg(long, value_name = "PX", default_value_t = Settings::SIDE,
        value_parser = values::whole(Settings::SIDES[0]..=Settings::SIDES[1]))]
    pub size: u32,
    /// The kinds of textures: spots, irregular-spots, stripes, pair-stripes, stucco, patches, cells [default: all of them]
    #[arg(long, value_name = "KIND,…", value_delimiter = ',', value_parser = kind)]
    pub kinds: Vec<Kind>,
    /// Items to make at once [default: all cores]
    #[arg(long, value_name = "N", value_parser = values::threads)]
    pub threads: Option<usize>,
    /// Show no progress
    #[arg(short, long)]
    pub quiet: bool,
}

/// A kind by its name.
fn kind(name: &str) -> Result<Kind, String> {
    Kind::named(name).ok_or_else(|| format!("allowed: {}", Kind::ALL.map(Kind::name).join(", ")))
}

impl Args {
    fn settings(&self) -> Settings {
        let kinds = if self.kinds.is_empty() { Kind::ALL.to_vec() } else { self.kinds.clone() };
        Settings { seed: self.seed, side: self.size, kinds }
    }

    /// The folder of an item.
    fn folder(&self, index: u64) -> PathBuf {
        let group = index / IN_A_FOLDER;
        self.output.join(format!("{group:06}")).join(format!("{index:09}"))
    }
}

/// Makes the items that are not there yet.
///
/// # Errors
/// The folder holds another data set, or a file cannot be written; an item cannot be grown; Ctrl-C.
pub fn run(args: &Args) -> Result<(), Error> {
    let settings = args.settings();
    files::make_folder(&args.output).map_err(Error::step)?;
    check_manifest(&args.output.join(MANIFEST), &settings)?;
    let cancelled = super::install();
    let failed: Mutex<Option<Error>> = Mutex::new(None);
    let stops = || cancelled.load(Ordering::Relaxed) || locked(&failed).is_some();
    let watch = Watch { progress: &|_, _| {}, cancelled: &stops };
    let bar = Bar::new(args.quiet);
    let (next, done) = (AtomicU64::new(0), AtomicU64::new(0));
    threads::each(args.threads.unwrap_or_else(threads::cores), || {
        while !stops() {
            let step = next.fetch_add(1, Ordering::Relaxed);
            if step >= args.count {
                return;
            }
            if let Err(error) = make(args, &settings, args.first + step, &watch) {
                locked(&failed).get_or_insert(error);
            }
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            bar.show(Stage::Grow, done as f64 / args.count as f64);
        }
    })
    .map_err(Error::step)?;
    bar.clear();
    let failed = locked(&failed).take();
    failed.map_or(Ok(()), Err)
}

fn locked<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes one item, unless it is there.
fn make(args: &Args, settings: &Settings, index: u64, watch: &Watch) -> Result<(), Error> {
    let folder = args.folder(index);
    if fs::is_dir(&folder) {
        return Ok(());
    }
    let made = item(settings, index, watch).map_err(|error| match error {
        ItemError::Cancelled => Error::Interrupted,
        error @ ItemError::Failed { .. } => Error::step(error),
    })?;
    let written = made.files().map_err(|why| Error::Usage(format!("{}: {why}", folder.display())))?;
    files::make_folder(files::folder_of(&folder).as_path()).map_err(Error::step)?;
    files::write_folder(&folder, &written).map_err(Error::step)
}

/// Writes what the data set is made from, or compares it with what is there.
fn check_manifest(path: &Path, settings: &Settings) -> Result<(), Error> {
    let text = format!("{:#}\n", manifest(settings));
    match fs::read_to_string(path) {
        Ok(there) if there == text => Ok(()),
        Ok(there) => Err(Error::Usage(format!(
            "{}: found a data set made from {}; allowed: the same --seed, --size and --kinds, or another folder",
            path.display(),
            there.split_whitespace().collect::<Vec<_>>().join(" ")
        ))),
        Err(_) => files::save(path, |out| {
            use std::io::Write;
            Ok(out.write_all(text.as_bytes())?)
        })
        .map_err(Error::step),
    }
}
