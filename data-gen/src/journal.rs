//! The journal of a sweep: one line for each finished run, so that a sweep that was stopped continues where it was.
//!
//! ```text
//!  {"format":"dapple sweep journal","version":1,"dapple":"0.1.0","shard":"1/1","plan":{…}}
//!  SET,INDEX,VERDICT,LINE       LINE as in the file of rows or of rejected runs
//! ```
//!
//! A line is written as soon as its run is done. If writing was interrupted, the incomplete last line is dropped, and
//! its run is repeated.

use std::collections::BTreeSet;
use std::fs::{File, OpenOptions, TryLockError};
use std::io::{Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use serde_json::{Value, json};

use crate::plan::{Plan, shown};
use crate::run::Record;
use crate::shard::Shard;
use crate::verdicts::{ACCEPTED, reasons};

const FORMAT: &str = "dapple sweep journal";
const VERSION: u64 = 1;
/// The version of the program.
pub const DAPPLE: &str = env!("CARGO_PKG_VERSION");

/// The journal of a sweep that is running.
pub struct Journal {
    path: PathBuf,
    file: Mutex<File>,
}

impl Journal {
    /// Opens the journal of `shard` of `plan` in `folder`, or begins one. Returns the runs that it holds.
    pub fn open(folder: &Path, shard: Shard, plan: &Plan) -> Result<(Self, Vec<Record>), String> {
        let path = folder.join(shard.journal());
        let failed = |error: std::io::Error| format!("{}: {error}", path.display());
        let mut options = OpenOptions::new();
        let mut file =
            options.read(true).write(true).create(true).truncate(false).open(&path).map_err(failed)?;
        // Where the file system has no locks, a second start of the same sweep is not detected.
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(format!("{}: another sweep is writing it; let it end, or stop it", path.display()));
        }
        let mut bytes = Vec::new();
        file.read_to_end(&mut bytes).map_err(failed)?;
        let whole = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |last| last + 1);
        file.set_len(whole as u64).map_err(failed)?;
        file.seek(SeekFrom::End(0)).map_err(failed)?;
        let header = header(shard, plan)?;
        let records = if whole == 0 {
            file.write_all(format!("{header}\n").as_bytes()).map_err(failed)?;
            Vec::new()
        } else {
            let text = text(&path, bytes[..whole].to_vec())?;
            let (found, rest) = first_line(&text);
            let found = parsed(&path, found)?;
            if let Some(difference) = difference(&found, &header) {
                return Err(format!(
                    "{}: it belongs to another sweep ({difference}); finish that sweep with its own plan and \
                     options, or delete this file and lose its runs, or choose another folder with -o",
                    path.display()
                ));
            }
            records(&path, rest, shard, plan)?
        };
        Ok((Self { path, file: Mutex::new(file) }, records))
    }

    /// Adds a run.
    pub fn append(&self, plan: &Plan, record: &Record) -> Result<(), String> {
        let line =
            format!("{},{},{},{}\n", plan.sets[record.set].name, record.index, record.verdict, record.line);
        let mut file = self.file.lock().map_err(|_| "another run failed".to_owned())?;
        let failed = |error: std::io::Error| {
            format!(
                "{}: {error}; start the sweep again when the file can be written; it continues where it stopped",
                self.path.display()
            )
        };
        let before = file.stream_position().map_err(failed)?;
        file.write_all(line.as_bytes()).map_err(|error| {
            // Other runs are still in progress: their lines must not follow an incomplete line.
            let _ = file.set_len(before).and_then(|()| file.seek(SeekFrom::Start(before)));
            failed(error)
        })
    }

    /// Deletes the journal, because the files of the training set now hold its runs.
    pub fn remove(self) -> Result<(), String> {
        drop(self.file);
        std::fs::remove_file(&self.path).map_err(|error| format!("{}: {error}", self.path.display()))
    }
}

/// The journal of one part of a sweep, which was run earlier or on another machine.
pub struct Part {
    /// Its file.
    pub path: PathBuf,
    /// Which part of the sweep.
    pub shard: Shard,
    /// The plan of the sweep.
    pub plan: Plan,
    /// The runs in it.
    pub records: Vec<Record>,
}

impl Part {
    /// Reads a journal without changing it.
    pub fn read(path: &Path) -> Result<Self, String> {
        let bytes = std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))?;
        Self::parse(path, &bytes)
    }

    /// The journal in `bytes`; `path` is its name in messages.
    pub fn parse(path: &Path, bytes: &[u8]) -> Result<Self, String> {
        let failed = |problem: String| format!("{}: {}", path.display(), shown(&problem));
        let whole = bytes.iter().rposition(|byte| *byte == b'\n').map_or(0, |last| last + 1);
        let text = text(path, bytes[..whole].to_vec())?;
        let (first, rest) = first_line(&text);
        let found = parsed(path, first)?;
        let shard: Shard = found["shard"].as_str().unwrap_or_default().parse().map_err(failed)?;
        let plan = Plan::from_json(&found["plan"]).map_err(failed)?;
        if let Some(difference) = difference(&found, &header(shard, &plan)?) {
            return Err(failed(format!("written by another program ({difference}); sweep again")));
        }
        let records = records(path, rest, shard, &plan)?;
        Ok(Self { path: path.to_owned(), shard, plan, records })
    }
}

fn header(shard: Shard, plan: &Plan) -> Result<Value, String> {
    let plan = serde_json::to_value(plan).map_err(|error| error.to_string())?;
    Ok(json!({
        "format": FORMAT, "version": VERSION, "dapple": DAPPLE, "shard": shard.to_string(), "plan": plan,
    }))
}

fn text(path: &Path, bytes: Vec<u8>) -> Result<String, String> {
    String::from_utf8(bytes).map_err(|_| format!("{}: it is not a text file; delete it", path.display()))
}

fn first_line(text: &str) -> (&str, &str) {
    text.split_once('\n').unwrap_or((text, ""))
}

fn parsed(path: &Path, header: &str) -> Result<Value, String> {
    let value: Value = serde_json::from_str(header).unwrap_or_default();
    if value["format"] == FORMAT {
        Ok(value)
    } else {
        Err(format!(
            "{}: it is not the journal of a sweep; delete it, or choose another folder",
            path.display()
        ))
    }
}

/// The first place where two headers differ, as text: what was found and what was expected.
pub fn difference(found: &Value, expected: &Value) -> Option<String> {
    match (found, expected) {
        (Value::Object(a), Value::Object(b)) => {
            // Sets are compared by their names, so that the message can name them.
            let keys: BTreeSet<&String> = a.keys().chain(b.keys()).collect();
            keys.into_iter().find_map(|key| {
                let inside =
                    difference(a.get(key).unwrap_or(&Value::Null), b.get(key).unwrap_or(&Value::Null));
                inside.map(|inside| {
                    if inside.starts_with(' ') { format!("{key}{inside}") } else { format!("{key}.{inside}") }
                })
            })
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() && a.iter().all(Value::is_object) => {
            a.iter().zip(b).find_map(|(a, b)| {
                difference(a, b).map(|inside| format!("{}.{inside}", b["name"].as_str().unwrap_or("?")))
            })
        }
        (Value::Array(a), Value::Array(b)) if a.iter().chain(b).all(Value::is_object) => {
            let names = |sets: &[Value]| -> String {
                let names: Vec<&str> = sets.iter().filter_map(|set| set["name"].as_str()).collect();
                names.join(", ")
            };
            Some(format!(" has {} there, {} here", names(a), names(b)))
        }
        _ if found == expected => None,
        _ => Some(format!(" is {found} there, {expected} here")),
    }
}

/// The runs in the lines of a journal after its header.
fn records(path: &Path, lines: &str, shard: Shard, plan: &Plan) -> Result<Vec<Record>, String> {
    let mut seen = BTreeSet::new();
    lines
        .lines()
        .enumerate()
        .map(|(number, line)| {
            let wrong = |problem: &str| {
                format!(
                    "{}, line {}: {problem}; delete that line, so that its run is repeated",
                    path.display(),
                    number + 2
                )
            };
            let record = record(line, shard, plan).ok_or_else(|| wrong("it is damaged"))?;
            if seen.insert((record.set, record.index)) {
                Ok(record)
            } else {
                Err(wrong("this run is there twice"))
            }
        })
        .collect()
}

fn record(line: &str, shard: Shard, plan: &Plan) -> Option<Record> {
    let mut fields = line.splitn(4, ',');
    let name = fields.next()?;
    let set = plan.sets.iter().position(|set| set.name == name)?;
    let index: u64 = fields.next()?.parse().ok()?;
    let verdict = fields.next()?;
    let verdict = std::iter::once(ACCEPTED).chain(reasons()).find(|known| *known == verdict)?;
    let line = fields.next()?.to_owned();
    let seed: u64 = line.split(',').next()?.parse().ok()?;
    let planned = &plan.sets[set];
    (index < planned.runs && shard.holds(index) && seed == planned.seed_of(index)).then_some(Record {
        set,
        index,
        verdict,
        line,
    })
}
