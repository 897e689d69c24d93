//! The measurements, as text and as JSON.

#[cfg(feature = "app")]
use super::changes::{self, Changes};
use super::kernels::{Effort, Kernel};
use super::machine::{Machine, load};
use super::phases::{self, Phases};
use super::pictures::Picture;
use serde_json::{Value, json};
use std::fmt::Write;

/// All measurements.
pub struct Report {
    machine: Machine,
    threads: usize,
    effort: Effort,
    load: [Option<f64>; 2],
    /// Cell updates a second.
    pub kernels: Vec<Kernel>,
    /// Times from document to picture.
    pub pictures: Vec<Picture>,
    /// CPU times from document to picture, by section of the work.
    pub phases: Vec<Phases>,
    /// Times after changes of a sketch.
    #[cfg(feature = "app")]
    pub changes: Vec<Changes>,
}

impl Report {
    /// A report without measurements, with the current load of the machine.
    pub fn begin(threads: usize, effort: Effort) -> Self {
        Self {
            machine: Machine::here(),
            threads,
            effort,
            load: [load(), None],
            kernels: Vec::new(),
            pictures: Vec::new(),
            phases: Vec::new(),
            #[cfg(feature = "app")]
            changes: Vec::new(),
        }
    }

    /// Adds the load of the machine at the end of the measurements.
    pub fn end(&mut self) {
        self.load[1] = load();
    }

    /// JSON of rates, cell updates a second, and times, s.
    pub fn json(&self) -> Value {
        let kernel = |k: &Kernel| {
            json!({
                "system": k.case.system.name(),
                "diffusion": k.case.diffusion(),
                "size": k.size,
                "plain": k.plain.round(),
                "fast_one_thread": k.one.round(),
                "fast_all_threads": k.all.round(),
                "fast_over_plain": k.fast_over_plain,
                "all_over_one": k.all_over_one,
            })
        };
        let picture = |p: &Picture| json!({"document": p.document, "size": p.size, "seconds": p.seconds});
        #[cfg_attr(not(feature = "app"), expect(unused_mut, reason = "only the window has changes"))]
        let mut report = json!({
            "version": env!("CARGO_PKG_VERSION"),
            "machine": {
                "processor": self.machine.processor,
                "cores": self.machine.cores,
                "instructions": self.machine.instructions,
            },
            "threads": self.threads,
            "load": {"before": self.load[0], "after": self.load[1]},
            "pairs": self.effort.pairs,
            "seconds_a_turn": self.effort.at_least.as_secs_f64(),
            "kernels": self.kernels.iter().map(kernel).collect::<Vec<_>>(),
            "pictures": self.pictures.iter().map(picture).collect::<Vec<_>>(),
            "phases": self.phases.iter().map(Phases::json).collect::<Vec<_>>(),
        });
        #[cfg(feature = "app")]
        if !self.changes.is_empty() {
            report["changes"] = self.changes.iter().map(Changes::json).collect();
        }
        report
    }

    /// The report as text for a terminal.
    pub fn text(&self) -> String {
        let mut text = self.head();
        if !self.kernels.is_empty() {
            text += &self.kernel_table();
        }
        if !self.pictures.is_empty() {
            text += &format!("\nFrom document to picture, {} threads\n", self.threads);
        }
        for Picture { document, size: [width, height], seconds } in &self.pictures {
            let size = format!("{width} × {height} px");
            // Writing to a String cannot fail.
            let _ = writeln!(text, "  {document:18} {size:>16} {seconds:9.2} s");
        }
        if !self.phases.is_empty() {
            text += &phases::table(&self.phases);
        }
        #[cfg(feature = "app")]
        if !self.changes.is_empty() {
            text += &changes::table(&self.changes);
        }
        text
    }

    fn head(&self) -> String {
        let Machine { processor, cores, instructions } = &self.machine;
        let [before, after] =
            self.load.map(|load| load.map_or_else(|| "unknown".to_owned(), |load| format!("{load:.2}")));
        format!(
            "dapple {} on {processor}, {cores} cores, {instructions}; load {before} before, {after} after\n",
            env!("CARGO_PKG_VERSION")
        )
    }

    fn kernel_table(&self) -> String {
        let Effort { pairs, at_least, .. } = self.effort;
        let mut text = format!(
            "\nMillion cell updates a second, medians of {pairs} runs of {:.2} s or more\n",
            at_least.as_secs_f64()
        );
        let many = format!("{} threads", self.threads);
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "  {:18} {:11} {:>6} {:>8} {:>8} {:>11} {:>12} {:>10}",
            "system", "diffusion", "cells", "plain", "fast", many, "fast/plain", "many/one"
        );
        for k in &self.kernels {
            let [plain, one, all] = [k.plain, k.one, k.all].map(|rate| rate / 1e6);
            let _ = writeln!(
                text,
                "  {:18} {:11} {:>6} {plain:8.0} {one:8.0} {all:11.0} {:12.2} {:10.2}",
                k.case.system.name(),
                k.case.diffusion(),
                format!("{}²", k.size),
                k.fast_over_plain,
                k.all_over_one
            );
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::json::known;
    use crate::rd::benchmark::Case;
    use std::time::Duration;

    fn report() -> Report {
        let effort = Effort { pairs: 3, at_least: Duration::from_millis(10), pictures: 1 };
        let kernel = Kernel {
            case: Case::ALL[1],
            size: 256,
            plain: 3e8,
            one: 6e8,
            all: 1.8e9,
            fast_over_plain: 2.0,
            all_over_one: 3.0,
        };
        let picture = Picture { document: "zebra", size: [512, 300], seconds: 0.25 };
        Report { kernels: vec![kernel], pictures: vec![picture], ..Report::begin(4, effort) }
    }

    #[test]
    fn the_table_shows_rates_ratios_and_times() {
        let text = report().text();
        for word in [
            "turing-spots",
            "aspect-0.5",
            "256²",
            " 300 ",
            " 600 ",
            " 1800 ",
            "2.00",
            "512 × 300 px",
            "0.25 s",
        ] {
            assert!(text.contains(word), "{word} in\n{text}");
        }
        assert!(text.lines().all(|line| line.chars().count() <= 120), "{text}");
    }

    #[test]
    fn an_unknown_load_is_left_out() {
        let report = Report { load: [None, Some(1.5)], ..report() };
        assert_eq!(known(report.json())["load"], json!({"after": 1.5}));
        assert!(report.text().contains("load unknown before, 1.50 after"));
    }
}
