//! Passes that a trial leaves out, and what each pass saw, changed and cost.

use std::fmt::Write;

use dapple::document::Document;
use dapple_engine::synth::error::GrowError;
use dapple_engine::synth::passes::{Entry, Pass, PassSet};
use dapple_engine::synth::profile;
use dapple_engine::synth::{Grown, Growth, Options};

use crate::cpu;

/// The passes to leave out, and the seeds to grow from.
#[derive(clap::Args, Clone, Default)]
pub struct PassArgs {
    /// Passes to leave out, to see their effect
    #[arg(long, value_name = "PASS", value_delimiter = ',', value_parser = named)]
    without: Vec<Pass>,
    /// A number to add to the seed of each document, to see how much results differ between seeds
    #[arg(long, value_name = "N", default_value_t = 0)]
    reseed: u64,
}

/// The pass with this name, which can be left out.
fn named(name: &str) -> Result<Pass, String> {
    let mut left_out = Pass::ALL.into_iter().filter(|pass| pass.can_be_left_out());
    left_out.clone().find(|pass| pass.name() == name).ok_or_else(|| {
        let first = left_out.next().map_or("", Pass::name);
        let others: Vec<&str> = left_out.map(Pass::name).collect();
        format!("allowed: {first}, {}", others.join(", "))
    })
}

impl PassArgs {
    /// The document, with another seed if one was asked for.
    pub fn reseeded(&self, mut document: Document) -> Document {
        document.seed = document.seed.wrapping_add(self.reseed);
        document
    }

    /// Grows a document, and records what its passes did.
    pub fn grow(&self, document: &Document, options: &Options) -> (Result<Grown, GrowError>, Vec<Entry>) {
        let without = self.without.iter().fold(PassSet::NONE, |set, pass| set.with(*pass));
        let grow = || Growth::begin(document, options, None).without(without).run();
        let (grown, _) = profile::measured(cpu::time, grow);
        let layers = grown.iter().flat_map(|grown| &grown.layers).filter_map(|layer| layer.marks());
        let entries = layers.flat_map(|marks| marks.trace.entries()).copied().collect();
        (grown, entries)
    }
}

/// The table of what the passes did: a line for each pass that did anything.
pub fn table(entries: &[Entry]) -> String {
    let total: f64 = entries.iter().map(|entry| entry.seconds).sum();
    let mut text = String::from("passes                 runs  rounds   changed    updates   CPU time\n");
    for pass in Pass::ALL {
        let own: Vec<&Entry> = entries.iter().filter(|entry| entry.pass == pass).collect();
        if own.is_empty() {
            continue;
        }
        let [rounds, changed] = [|entry: &&&Entry| entry.rounds, |entry: &&&Entry| entry.changed]
            .map(|number| own.iter().map(|entry| number(&entry)).sum::<usize>());
        let updates: u64 = own.iter().map(|entry| entry.updates).sum();
        let seconds: f64 = own.iter().map(|entry| entry.seconds).sum();
        let _ = writeln!(
            text,
            "  {:18} {:>6} {rounds:>7} {changed:>9} {:>8.0} M {seconds:>7.1} s {:>4.1} %",
            pass.name(),
            own.len(),
            updates as f64 * 1e-6,
            100.0 * seconds / total.max(f64::MIN_POSITIVE)
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_passes_that_can_be_left_out_have_a_name_here() {
        assert_eq!(named("own-thresholds"), Ok(Pass::OwnThresholds));
        let wrong = named("growth").expect_err("nothing grows without it");
        assert!(wrong.starts_with("allowed: probes, thresholds") && !wrong.contains("growth"), "{wrong}");
    }

    #[test]
    fn a_growth_without_a_pass_has_no_entry_of_it_and_other_figures() {
        let text = r#"{"format": "dapple", "version": 1, "size": [80, 80], "layers": [{"strokes": [
            {"kind": "ellipse", "center": [20, 20], "radii": [6, 4], "angle": 30}]}]}"#;
        let document = Document::parse(text, "spot").expect("a document");
        let options = Options::default();
        let passes = |without: &[Pass]| {
            let args = PassArgs { without: without.to_vec(), reseed: 0 };
            let (grown, entries) = args.grow(&document, &options);
            assert!(grown.is_ok() && entries.iter().all(|entry| entry.updates > 0), "{entries:?}");
            entries.iter().map(|entry| entry.pass).collect::<Vec<_>>()
        };
        assert!(passes(&[]).starts_with(&[Pass::Growth, Pass::Thresholds]));
        assert!(!passes(&[Pass::Thresholds]).contains(&Pass::Thresholds));
    }
}
