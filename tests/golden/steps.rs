//! The first steps of every system in which something reacts, to the bit.

use crate::renew::{bits_of, fnv, same_lines};
use dapple::document::{AreaKind, SystemChoice};
use dapple_engine::attributes::system::Family;
use dapple_engine::grid::{Edges, Grid};
use dapple_engine::rd::pairs::{
    Blurs, Combination, Course, MOST_PAIRS, PairField, PairGrowth, PairKind, PairModel, PairParameterField,
    PairStart, Stucco, polygons,
};
use dapple_engine::rd::{Growth, ParameterField, Parameters, System};
use std::fmt::Write;

/// Width and height of the grid, in cells: not square.
const CELLS: [u16; 2] = [48, 40];
const STEPS: u64 = 20;
const SEED: u64 = 11;

fn grid(edges: Edges) -> Grid {
    Grid { size: CELLS.map(usize::from), cell: [1.0, 0.95], edges }
}

/// Values that vary from cell to cell: `of` gets x and y, 0..1. They are computed by plain arithmetic, which gives the
/// same result on every machine.
fn by_cell<T>(of: impl Fn([f32; 2]) -> T) -> Vec<T> {
    let [nx, ny] = CELLS;
    let place = |cell: u16| [f32::from(cell % nx) / f32::from(nx), f32::from(cell / nx) / f32::from(ny)];
    (0..nx * ny).map(|cell| of(place(cell))).collect()
}

/// Parameters that all vary from cell to cell.
fn varying(system: System, edges: Edges) -> ParameterField {
    let rate = system.definition().usual_rate;
    let parameters = by_cell(|[x, y]| Parameters {
        rate: rate * (1.0 + 0.5 * x),
        ratio: 15.0 + 10.0 * y,
        stretch: 0.4 + 0.5 * y,
        direction: 170.0 * x,
        pitch: 1.0 + 0.1 * x,
    });
    ParameterField::new(grid(edges), parameters)
}

fn after_steps(system: System, maps: &ParameterField) -> Vec<Vec<f32>> {
    let mut growth = Growth::new(system, maps, SEED);
    growth.advance(STEPS);
    growth.concentrations()
}

/// One reaction of the pairs that a document can name.
fn model(kind: PairKind) -> PairModel {
    let constant = |combination, threshold, softness| PairModel {
        combination,
        ratio: 1.5,
        threshold: Course::Constant(threshold),
        softness,
        weights: [1.0; MOST_PAIRS],
        gain: Course::Constant(1.0),
    };
    match kind {
        PairKind::Weave => constant(Combination::Maximum, 0.2, 0.1),
        PairKind::Maze => constant(Combination::DifferenceOfAbsolutes, 0.0, 0.02),
        PairKind::Stripes => constant(Combination::Maximum, 0.0, 0.15),
        PairKind::Stucco => PairModel {
            threshold: Stucco::threshold(Stucco::DECAY),
            ..constant(Combination::Maximum, 0.0, 0.15)
        },
    }
}

/// Pairs whose directions and sizes vary, each rotated by one of the angles `turned`, degrees, after some steps from
/// noise.
fn pairs_after_steps(model: &PairModel, turned: &[f32], blurs: Blurs, edges: Edges) -> Vec<Vec<f32>> {
    let pair = |turned: &f32| PairField {
        direction: by_cell(|[x, _]| turned + 40.0 * x),
        size: by_cell(|[_, y]| 2.0 + 0.5 * y),
        blurs,
    };
    let maps = PairParameterField {
        grid: grid(edges),
        pairs: turned.iter().map(pair).collect(),
        obstacles: Vec::new(),
        raised: Vec::new(),
    };
    let mut growth = PairGrowth::new(&maps, model, &PairStart::Noise(SEED)).unwrap();
    growth.advance(STEPS);
    growth.concentrations()
}

/// The concentrations of each chemical after the first steps; `None` for a choice that names no system, and for systems
/// without a reaction. A new kind of system must be added here.
fn first_steps(choice: SystemChoice, edges: Edges) -> Option<Vec<Vec<f32>>> {
    let kind = choice.kind()?;
    if let Some(system) = choice.system() {
        return Some(after_steps(system, &varying(system, edges)));
    }
    match kind {
        Family::Growth => {
            let system = System::with_growth();
            let growth = by_cell(|[x, _]| 18.0 + 9.0 * x);
            Some(after_steps(system, &ParameterField { g: growth, ..varying(system, edges) }))
        }
        Family::Pairs => {
            let kind = choice.pairs()?;
            let (turned, blurs): (&[f32], _) = match kind {
                PairKind::Weave | PairKind::Maze => (&[0.0, 80.0], Blurs::Along(2.0)),
                PairKind::Stripes => (&[0.0], Blurs::Along(2.0)),
                PairKind::Stucco => (&[0.0], Blurs::Round),
            };
            Some(pairs_after_steps(&model(kind), turned, blurs, edges))
        }
        Family::Areas if choice.areas() == Some(AreaKind::Polygons) => {
            Some(pairs_after_steps(&polygons::model(), &[0.0], polygons::BLURS, edges))
        }
        // These are made from scattered points; `kinds` compares their patterns.
        Family::Areas | Family::Lines | Family::Points | Family::Marks => None,
    }
}

/// A line for each chemical: the hash of all cells, then a few of them as value and bits.
fn concentrations() -> String {
    let mut text =
        "# Concentrations on 48 x 40 cells after 20 steps (whole super steps), by system, edges, chemical: FNV-1a of the\n\
                    # bits of all cells; then cells 0, 500, 1000, 1500, 1919 as bits=value.\n"
            .to_owned();
    for (name, choice) in SystemChoice::names() {
        for (edges, word) in [(Edges::Wrap, "wrap"), (Edges::Closed, "closed")] {
            for (chemical, values) in first_steps(choice, edges).iter().flatten().enumerate() {
                write!(text, "{name} {word} {chemical} {:016x}", fnv(values)).unwrap();
                for cell in [0, 500, 1000, 1500, 1919] {
                    write!(text, " {}", bits_of(values[cell])).unwrap();
                }
                text.push('\n');
            }
        }
    }
    text
}

#[test]
fn twenty_steps_of_each_system_give_the_stored_bits() {
    same_lines("concentrations.txt", &concentrations());
}
