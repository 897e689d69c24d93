//! The page of the matrices.

use std::fmt::Write;

use super::effect::Effects;
use super::gray_scott::{ATTRIBUTES, Row};
use super::subjects::Subject;

/// The page: a matrix for each system, then the plain simulation.
pub fn text(matrices: &[(&Subject, Vec<Effects>)], plain: &[Row], seeds: u64) -> String {
    let mut text = format!(
        "# What else changes when one attribute is changed\n\n\
         Written by `cargo run --release -p data-gen -- cross-talk --only attributes --seeds {seeds}`. Of each system a sketch with one set of\n\
         attributes is drawn; one attribute is multiplied by 0.8 and by 1.2 (directions are turned by −18° and +18°), all others stay as\n\
         drawn, and everything is measured on what has grown.\n"
    );
    // Writing to a String cannot fail.
    let _ = writeln!(
        text,
        "\nA cell says by how much the attribute of its column changes when that of its row is changed: the mean over {seeds} seeds of the\n\
         signed change, in per cent of the change of the row's own attribute, ± its standard error. Changes of lengths, areas and aspects are\n\
         ratios (their logarithms are compared), and a turn of 36° counts as a factor of 1.2 ÷ 0.8. The column *own* says how much of what\n\
         was asked for the row's own attribute changes. The first table sums up the cells that are not *own*, by their size.\n"
    );
    let all: Vec<f64> = matrices.iter().flat_map(|(_, rows)| off_diagonal(rows)).collect();
    let _ =
        writeln!(text, "| system | median | largest | mean change of the own attribute |\n|---|---|---|---|");
    for (subject, rows) in matrices {
        let own = rows.iter().enumerate().map(|(row, effects)| effects.0[row].mean);
        let own = own.sum::<f64>() / rows.len() as f64;
        let _ =
            writeln!(text, "| {} | {} | {:.1} % |", name(subject), summary(off_diagonal(rows)), 100.0 * own);
    }
    let _ = writeln!(text, "| all | {} | |", summary(all));
    let _ = writeln!(text, "| plain Gray–Scott (below) | {} | |", summary(beside_the_largest(plain)));
    for (subject, rows) in matrices {
        text += &table(subject, rows);
    }
    text + &plain_table(plain, seeds)
}

/// The name of a system, without what its heading says beside it.
fn name(subject: &Subject) -> &str {
    subject.title.split(':').next().unwrap_or_default()
}

/// The effects on other attributes, as shares of the effect on the own one.
fn off_diagonal(rows: &[Effects]) -> Vec<f64> {
    let of = |(row, effects): (usize, &Effects)| {
        let own = effects.0[row].mean;
        let others =
            effects.0.iter().enumerate().filter(|(column, effect)| *column != row && effect.count > 0);
        others.map(|(_, effect)| (effect.mean / own).abs()).collect::<Vec<f64>>()
    };
    rows.iter().enumerate().flat_map(of).collect()
}

/// Of the plain simulation: the effects of each parameter as shares of its largest one, without that one.
fn beside_the_largest(rows: &[Row]) -> Vec<f64> {
    let shares = |effects: &[f64; ATTRIBUTES.len()]| {
        let mut sizes = effects.map(f64::abs);
        sizes.sort_by(|a, b| b.total_cmp(a));
        sizes[1..].iter().map(|size| size / sizes[0]).collect::<Vec<f64>>()
    };
    rows.iter().filter_map(|row| row.effects.as_ref()).flat_map(shares).collect()
}

/// Median and largest, per cent.
fn summary(mut shares: Vec<f64>) -> String {
    shares.sort_by(f64::total_cmp);
    let middle = shares.get(shares.len() / 2).copied().unwrap_or_default();
    format!("{:.1} % | {:.1} %", 100.0 * middle, 100.0 * shares.last().copied().unwrap_or_default())
}

fn table(subject: &Subject, rows: &[Effects]) -> String {
    let names = subject.attributes;
    let mut text = format!("\n## {}\n\n{}\n\n", subject.title, subject.about());
    let _ = writeln!(text, "| changed | own | {} |\n|{}", names.join(" | "), "---|".repeat(names.len() + 2));
    for (row, effects) in rows.iter().enumerate() {
        let own = effects.0[row].mean;
        let cell = |(column, effect): (usize, &super::effect::Effect)| match (column == row, effect.count) {
            (true, _) => "100".to_owned(),
            (false, 0) => "–".to_owned(),
            (false, _) => {
                format!("{:+.1} ± {:.1}", 100.0 * effect.mean / own, 100.0 * (effect.error / own).abs())
            }
        };
        let cells: Vec<String> = effects.0.iter().enumerate().map(cell).collect();
        let _ = writeln!(text, "| {} | {:.1} % | {} |", names[row], 100.0 * own, cells.join(" | "));
    }
    text
}

/// The parameters of the plain simulation.
fn plain_table(rows: &[Row], seeds: u64) -> String {
    let mut text = format!(
        "\n## A plain simulation: Gray–Scott\n\nSpots that divide until the canvas is full (F = 0.0367, k = 0.0649, Dᵤ = 0.16, D_v = 0.08; \
         160² cells, 12,000\nsteps, {seeds} seeds), measured by the same ruler above half of the highest value. Its parameters are no attributes: \
         no cell is the\n*own* one, so a row is in per cent of its largest effect, and *sensitivity* is that effect: by how many per cent it \
         changes where the\nparameter changes by one. D multiplies both coefficients of diffusion. The first table leaves out the largest \
         effect of each row.\n\n| changed | by | sensitivity | {} |\n|---|---|---|{}\n",
        ATTRIBUTES.join(" | "),
        "---|".repeat(ATTRIBUTES.len())
    );
    for Row { name, factors, effects } in rows {
        let by = format!("±{:.0} %", 100.0 * (factors[1] - 1.0));
        let Some(effects) = effects else {
            let _ = writeln!(text, "| {name} | {by} | no spots grow |{}", " – |".repeat(ATTRIBUTES.len()));
            continue;
        };
        let largest = effects.iter().copied().fold(0.0, |most: f64, effect| most.max(effect.abs()));
        let cells: Vec<String> =
            effects.iter().map(|effect| format!("{:+.0}", 100.0 * effect / largest)).collect();
        let _ = writeln!(text, "| {name} | {by} | {largest:.2} | {} |", cells.join(" | "));
    }
    text
}
