//! Ratios of two durations, measured alternately on one thread. Described in README.md.

use criterion::measurement::{Measurement, ValueFormatter};
use criterion::{BenchmarkGroup, Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use dapple::document::{AreaKind, Document, Layer, Stroke, SystemChoice};
use dapple::lookup::{Attributes, LookedUp, Spots, System, Training};
use dapple::machine::clock;
use dapple::{Grown, Options};
use dapple_engine::rd::Growth;
use dapple_engine::rd::benchmark::Case;
use dapple_engine::synth;
use dapple_engine::synth::marks::plan::Targets;
use dapple_engine::synth::profile::{Section, measured};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::fmt::Write;
use std::fs;
use std::hint::black_box;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// A number that criterion measures instead of a time.
struct Ratio;

impl Measurement for Ratio {
    type Intermediate = ();
    type Value = f64;

    fn start(&self) {}

    fn end(&self, (): ()) -> f64 {
        0.0
    }

    fn add(&self, a: &f64, b: &f64) -> f64 {
        a + b
    }

    fn zero(&self) -> f64 {
        0.0
    }

    fn to_f64(&self, value: &f64) -> f64 {
        *value
    }

    fn formatter(&self) -> &dyn ValueFormatter {
        self
    }
}

impl ValueFormatter for Ratio {
    fn scale_values(&self, _: f64, _: &mut [f64]) -> &'static str {
        "times"
    }

    fn scale_throughputs(&self, _: f64, _: &Throughput, _: &mut [f64]) -> &'static str {
        "times"
    }

    fn scale_for_machines(&self, _: &mut [f64]) -> &'static str {
        "times"
    }
}

type Group<'a> = BenchmarkGroup<'a, Ratio>;

fn group<'a>(criterion: &'a mut Criterion<Ratio>, name: &str) -> Group<'a> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(10).sampling_mode(SamplingMode::Flat);
    group.warm_up_time(Duration::from_millis(100)).measurement_time(Duration::from_secs(2));
    group
}

/// Measures `number` once in each round.
fn number(group: &mut Group, name: &str, mut number: impl FnMut() -> f64 + Send) {
    let one = one_thread();
    group.bench_function(name, |bencher| {
        bencher.iter_custom(|turns| one.install(|| (0..turns).map(|_| number()).sum()));
    });
}

/// Measures the duration of `this` ÷ that of `that`, over `by`.
fn ratio(
    group: &mut Group,
    name: &str,
    by: f64,
    mut this: impl FnMut() + Send,
    mut that: impl FnMut() + Send,
) {
    number(group, name, || seconds(&mut this) / seconds(&mut that) / by);
}

fn seconds(work: &mut impl FnMut()) -> f64 {
    let before = Instant::now();
    work();
    before.elapsed().as_secs_f64()
}

fn one_thread() -> ThreadPool {
    ThreadPoolBuilder::new().num_threads(1).build().expect("a thread can be started")
}

fn steps(criterion: &mut Criterion<Ratio>) {
    let mut group = group(criterion, "steps");
    for case in [Case::ALL[1], Case::ALL[4], Case::ALL[7]] {
        let growth = case.growth(&case.start(), &case.maps(256)).expect("the case's own start");
        let (mut plain, mut fast) = (growth.clone(), growth);
        ratio(
            &mut group,
            &format!("plain ÷ fast, {}", case.name()),
            1.0,
            || plain.advance_plain(16),
            || fast.advance(16),
        );
        // Both start from the same state and cover the same time.
        let begun = Growth::new(case.system, &case.maps(256), 1);
        let to_the_end = |mut growth: Growth| growth.advance(growth.steps_in(5.0));
        ratio(
            &mut group,
            &format!("Euler ÷ super steps, {}", case.name()),
            1.0,
            || to_the_end(begun.clone().with_stages(1)),
            || to_the_end(begun.clone()),
        );
    }
}

/// `columns` × `rows` ellipses of about `area` px² on a canvas of `size` px, all different, with this number of
/// `regions`.
fn spots(size: [u32; 2], [columns, rows]: [u32; 2], area: f64, regions: Option<[u32; 2]>) -> Document {
    let [wide, high] = [f64::from(size[0]) / f64::from(columns), f64::from(size[1]) / f64::from(rows)];
    let spot = |index: u32| {
        let [x, y] = [f64::from(index % columns), f64::from(index / columns)];
        let radius = (area / std::f64::consts::PI).sqrt() * (1.0 + 0.1 * libm::sin(f64::from(index)));
        let center = [(x + 0.5) * wide, (y + 0.5) * high];
        Stroke::ellipse(center, [1.1 * radius, radius / 1.1], f64::from(37 * index % 180))
    };
    let layer = Layer::new((0..columns * rows).map(spot));
    Document { regions, ..Document::new(size).with_layer(layer) }
}

fn grown(document: &Document, options: &Options) -> Grown {
    synth::Growth::begin(black_box(document), options, None).run().expect("a texture")
}

/// Grows `document` with default options.
fn growing(document: &Document) -> impl FnMut() + Send {
    move || drop(grown(document, &Options::default()))
}

fn documents(criterion: &mut Criterion<Ratio>) {
    let mut group = group(criterion, "document");
    for (name, text) in [
        ("cheetah-run", include_str!("../examples/cheetah-run.dapple")),
        ("zebra", include_str!("../examples/zebra.dapple")),
    ] {
        let document = Document::parse(text, name).expect("an example is valid");
        let at = |side: u32| Options { size: Some([side; 2]), ..Options::default() };
        let sized = |side| {
            let (document, options) = (&document, at(side));
            move || drop(grown(document, &options))
        };
        ratio(&mut group, &format!("a px at 1024² ÷ at 512², {name}"), 4.0, sized(1024), sized(512));
        number(&mut group, &format!("not stepping ÷ stepping at 1024², {name}"), || {
            let (_, seconds) = measured(clock::cpu_time, || grown(&document, &at(1024)));
            let steps = seconds.of(Section::Steps);
            (seconds.total() - steps) / steps
        });
    }
}

fn cliffs(criterion: &mut Criterion<Ratio>) {
    let mut group = group(criterion, "no cliff");
    let look_up = |side: u32| {
        let document = spots([16 * side; 2], [side; 2], 40.0, Some([side; 2]));
        move || {
            let size = document.size.map(f64::from);
            let targets = Targets::read(black_box(&document), 0, "the document", size, None);
            targets.expect("targets").look_up(Training::built_in()).expect("parameters");
        }
    };
    ratio(&mut group, "a region of 64² ÷ of 16², looked up", 16.0, look_up(64), look_up(16));
    let of_marks = |side: u32, system: SystemChoice| {
        let mut document = spots([32 * side; 2], [side; 2], 150.0, None);
        document.layers[0].system = system;
        move || drop(grown(&document, &Options::default()))
    };
    for (name, system) in [
        ("free ellipse", SystemChoice::Auto),
        ("patch", SystemChoice::Of(AreaKind::Patches.description())),
        ("cell", SystemChoice::Of(AreaKind::Polygons.description())),
    ] {
        let [many, few] = [24, 12].map(|side| of_marks(side, system));
        ratio(&mut group, &format!("a drawn {name} of 576 ÷ of 144"), 4.0, many, few);
    }
    let [thin, square] = [[5, 777], [62, 62]].map(|size| spots(size, [1, 4], 12.0, None));
    ratio(&mut group, "canvas of 5 × 777 ÷ 62 × 62", 1.0, growing(&thin), growing(&square));
    let [small, large] = [10.0, 300.0].map(|area| spots([256; 2], [4, 4], area, None));
    ratio(&mut group, "16 free dots of 10 px² ÷ of 300 px² at 256²", 1.0, growing(&small), growing(&large));
    let one = spots([256; 2], [3, 3], 300.0, None);
    let layer = one.layers[0].clone();
    let four = (0..3).fold(one.clone(), |document, _| document.with_layer(layer.clone()));
    ratio(&mut group, "a layer of four ÷ one alone", 4.0, growing(&four), growing(&one));
}

fn changes(criterion: &mut Criterion<Ratio>) {
    let mut group = group(criterion, "change");
    let two = spots([256; 2], [3, 3], 300.0, None);
    let two = two.clone().with_layer(two.layers[0].clone());
    let before = grown(&two, &Options::default());
    let mut changed = two.clone();
    changed.layers[1].strokes.pop();
    let again =
        || drop(synth::Growth::begin(&changed, &Options::default(), Some(&before)).run().expect("a texture"));
    ratio(&mut group, "grown after the upper of two layers changed ÷ anew", 1.0, again, growing(&changed));
}

/// The program, with its output discarded.
fn program() -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_dapple"));
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command
}

fn run(mut command: Command) {
    assert!(command.status().expect("the program can be started").success(), "{command:?}");
}

/// The most memory that a program holds, kB, as read every millisecond until it ends.
#[cfg(target_os = "linux")]
fn peak(mut command: Command) -> f64 {
    let mut child = command.spawn().expect("the program can be started");
    let held = |child: &std::process::Child| {
        let status = fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
        line.split_whitespace().next()?.parse::<f64>().ok()
    };
    let mut most = 0.0_f64;
    loop {
        if let Some(status) = child.try_wait().expect("a child can be waited for") {
            assert!(status.success(), "{command:?}");
            return most;
        }
        most = most.max(held(&child).unwrap_or(0.0));
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Writes a table with this number of questions, all different.
fn questions(folder: &Path, rows: u32) -> PathBuf {
    let mut text = "system,area,aspect,angle,spacing\n".to_owned();
    for row in 0..rows {
        let area = 60 + row % 977;
        let spacing = 3.2 * f64::from(area).sqrt();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "turing-spots,{area},0.{},{},{spacing:.3}", 50 + row % 49, row % 180);
    }
    let table = folder.join(format!("{rows}.csv"));
    fs::write(&table, text).expect("a table can be written");
    table
}

/// Spots of many sizes, shapes and distances.
fn questions_of_spots() -> Vec<Attributes> {
    let spots = |i: u32| {
        let share = |step: f64| (step * f64::from(i)).fract();
        let (area, spacing) = (100.0 + 400.0 * share(0.618), 30.0 + 30.0 * share(0.755));
        Spots { area, aspect: 0.3 + 0.7 * share(0.57), angle: 180.0 * share(0.819), spacing: Some(spacing) }
    };
    (0..2_000).map(|i| Attributes::Spots(spots(i))).collect()
}

fn tables(criterion: &mut Criterion<Ratio>) {
    let mut group = group(criterion, "lookup --batch");
    let folder = tempfile::tempdir().expect("a folder can be made");
    let [many, few] = [200_000, 20_000].map(|rows| questions(folder.path(), rows));
    let look_up = |table: &Path| {
        let mut command = program();
        command.args(["lookup", "--batch"]).arg(table).arg("-o").arg(folder.path().join("answers.csv"));
        command
    };
    let (training, wanted) = (Training::built_in(), questions_of_spots());
    let asked = || {
        let looked =
            |wanted| LookedUp::new(training, System::MEINHARDT_SPOTS, wanted).map(|looked| looked.predict());
        wanted.iter().for_each(|wanted| drop(black_box(looked(wanted))));
    };
    let found = || {
        let looked = |wanted| LookedUp::new(training, System::MEINHARDT_SPOTS, wanted);
        wanted.iter().for_each(|wanted| drop(black_box(looked(wanted))));
    };
    ratio(&mut group, "with what is predicted ÷ without", 1.0, asked, found);
    let name = "a row of 200,000 ÷ of 20,000";
    ratio(&mut group, name, 10.0, || run(look_up(&many)), || run(look_up(&few)));
    #[cfg(target_os = "linux")]
    number(&mut group, "memory for 200,000 rows ÷ for 20,000", || {
        peak(look_up(&many)) / peak(look_up(&few))
    });
}

/// Growths by the whole program: memory, and the time until a change is shown.
fn programs(criterion: &mut Criterion<Ratio>) {
    let mut group = group(criterion, "program");
    #[cfg(target_os = "linux")]
    {
        let folder = tempfile::tempdir().expect("a folder can be made");
        let grow = |side: u32| {
            let mut command = program();
            let document = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/cheetah-run.dapple");
            command.args(["grow", document, "--size", &format!("{side}x{side}"), "-o"]);
            command.arg(folder.path().join("grown.png"));
            command
        };
        number(&mut group, "memory of 2048² px ÷ of 1024²", || peak(grow(2048)) / peak(grow(1024)));
    }
    #[cfg(feature = "app")]
    number(&mut group, "first picture of a change ÷ settled", || {
        let mut command = program();
        command.args(["bench", "--changes", "--quick", "--only", "free", "--json"]).stdout(Stdio::piped());
        let said = command.output().expect("the program can be started").stdout;
        let said: serde_json::Value = serde_json::from_slice(&said).expect("JSON");
        let change = &said["changes"][0];
        let [first, settled] = ["first_picture", "settled"].map(|time| change[time].as_f64());
        first.zip(settled).map(|(first, settled)| first / settled).expect("both times")
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().with_measurement(Ratio);
    targets = steps, documents, cliffs, changes, tables, programs
}
criterion_main!(benches);
