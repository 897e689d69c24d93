//! The CPU time from a document to its picture, by section of the work, on one thread.

use super::kernels::{Effort, Pools, median};
use super::pictures::{Example, Folder};
use super::{check_interrupt, pictures};
use crate::cli::Error;
use crate::machine::clock;
use crate::synth::profile::{Seconds, Section, measured};
use serde_json::{Value, json};
use std::fmt::Write;

/// Spots that vary in all attributes, stripes whose direction changes, spots of different sizes, and three layers.
pub const EXAMPLES: [Example; 4] = [
    pictures::EXAMPLES[0],
    pictures::EXAMPLES[1],
    Example { name: "growing-spots", text: include_str!("../../../examples/growing-spots.dapple") },
    Example { name: "leopard", text: include_str!("leopard.dapple") },
];

/// The measurement of one document at one size.
#[derive(Clone, Debug)]
pub struct Phases {
    /// Its name.
    pub document: &'static str,
    /// Side of the canvas, px.
    pub size: usize,
    /// CPU time of each section, seconds: the median.
    pub seconds: Seconds,
}

/// Grows `example` on a canvas of `size` × `size` px.
///
/// # Errors
/// [`Error::Interrupted`]; the errors of `grow`.
pub fn measure(
    example: &Example,
    size: usize,
    folder: &Folder,
    pools: &Pools,
    effort: Effort,
) -> Result<Phases, Error> {
    let args = folder.grow_args(example, Some(size))?;
    let mut all = Vec::with_capacity(effort.pictures);
    for _ in 0..effort.pictures {
        check_interrupt()?;
        let (grown, seconds) =
            pools.run_on_one(|| measured(clock::cpu_time, || crate::cli::grow::run(&args)));
        grown?;
        all.push(seconds);
    }
    let seconds = Seconds::by_section(|section| median(all.iter().map(|one| one.of(section)).collect()));
    Ok(Phases { document: example.name, size, seconds })
}

impl Phases {
    /// Nanoseconds per px.
    fn a_px(&self, seconds: f64) -> f64 {
        1e9 * seconds / (self.size * self.size) as f64
    }

    /// JSON of the times, s.
    pub fn json(&self) -> Value {
        let phases: serde_json::Map<String, Value> = Section::ALL
            .into_iter()
            .map(|section| (section.name().replace(' ', "_"), json!(self.seconds.of(section))))
            .collect();
        json!({"document": self.document, "size": [self.size, self.size], "cpu_seconds": phases})
    }
}

/// A table of nanoseconds per px, with a line for each section and a column for each measurement.
pub fn table(measurements: &[Phases]) -> String {
    let mut text = "\nCPU time from document to picture on one thread, nanoseconds per px\n".to_owned();
    let mut line = |name: &str, values: &dyn Fn(&Phases) -> String| {
        // Writing to a String cannot fail.
        let _ = write!(text, "  {name:14}");
        for measurement in measurements {
            let _ = write!(text, " {:>13}", values(measurement));
        }
        text.push('\n');
    };
    line("", &|m| m.document.to_owned());
    line("", &|m| format!("{}²", m.size));
    for section in Section::ALL {
        line(section.name(), &|m| format!("{:.1}", m.a_px(m.seconds.of(section))));
    }
    line("all", &|m| format!("{:.1}", m.a_px(m.seconds.total())));
    line("all but steps", &|m| format!("{:.1}", m.a_px(m.seconds.total() - m.seconds.of(Section::Steps))));
    line("steps ÷ all", &|m| format!("{:.2}", m.seconds.of(Section::Steps) / m.seconds.total()));
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;

    #[test]
    fn the_examples_are_valid() {
        for example in EXAMPLES {
            let document = Document::parse(example.text, example.name).expect("an example is valid");
            assert_eq!(document.layers.len(), if example.name == "leopard" { 3 } else { 1 });
        }
    }

    #[test]
    fn the_table_has_a_line_a_phase_and_a_column_a_measurement() {
        let seconds = Seconds::by_section(|section| if section == Section::Steps { 3e-3 } else { 0.5e-3 });
        let one = |size| Phases { document: "zebra", size, seconds };
        let text = table(&[one(1000), one(500)]);
        let line = |name: &str| {
            let line = text.lines().find(|line| line.trim_start().starts_with(name)).expect("a line");
            line.trim_start()[name.len()..].split_whitespace().map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(line("steps"), ["3.0", "12.0"]);
        assert_eq!(line("all but steps"), ["6.0", "24.0"]);
        assert_eq!(line("steps ÷ all"), ["0.33", "0.33"]);
        assert_eq!(one(10).json()["cpu_seconds"]["look_up"], 0.5e-3);
    }
}
