//! What grows by Turing's system at each growth G and decay β: figure 2 of Lawlor, "Reaction-diffusion textures with multigrid" (2003).

use std::path::PathBuf;

use dapple::internals::export;
use dapple::internals::export::png::rgb8;
use dapple::internals::grid::{Edges, Grid};
use dapple::internals::rd::{Growth, Maps, Parameters, System};

/// What to draw.
#[derive(clap::Args)]
pub struct Args {
    /// Where to write the picture
    #[arg(short, long, value_name = "OUT.png")]
    output: PathBuf,
    /// Cells and px along each side
    #[arg(long, default_value_t = 720, value_parser = clap::value_parser!(u32).range(60..=4096))]
    side: u32,
}

/// Growth on the right and decay at the top; both are 0 at the lower left corner.
const MOST: f64 = 30.0;
/// The decay of `turing-growth`, and the growth that it takes.
const TAKEN: (f64, [f64; 2]) = (20.0, [17.5, 27.5]);
/// Decay above and below [`TAKEN`] that the box encloses.
const BOX: f64 = 0.5;
/// Normalised time.
const TIME: f64 = 40.0;
/// s/√(DₐD_b) of Lawlor's parameters: marks are 11.6 cells apart.
const RATE: f64 = 0.141_42;
/// The colour of the box: that of Okabe & Ito (2008) which colour-blind readers tell from gray.
const COLOUR: [u8; 3] = [0xd5, 0x5e, 0x00];

/// Draws the map.
pub fn run(args: &Args) -> Result<(), String> {
    let side = args.side as usize;
    let marks = grown(side);
    let rgb: Vec<u8> = (0..side * side)
        .flat_map(|px| {
            let (growth, decay) = at(px, side);
            let gray = (255.0 * (1.0 - marks[px].clamp(0.0, 1.0))).round() as u8;
            if on_box(growth, decay, MOST / side as f64) { COLOUR } else { [gray; 3] }
        })
        .collect();
    export::save(&args.output, |out| rgb8(out, [side; 2], None, &rgb)).map_err(|error| error.to_string())
}

/// Growth and decay at a px.
fn at(px: usize, side: usize) -> (f64, f64) {
    let share = |k: usize| (k as f64 + 0.5) / side as f64;
    (MOST * share(px % side), MOST * (1.0 - share(px / side)))
}

/// Whether a place is within `width` of the border of the box.
fn on_box(growth: f64, decay: f64, width: f64) -> bool {
    let (middle, [low, high]) = TAKEN;
    let out = (low - growth).max(growth - high).max((decay - middle).abs() - BOX);
    (0.0..2.0 * width).contains(&out)
}

/// b ÷ (b + 3) of each px.
fn grown(side: usize) -> Vec<f32> {
    let parameters = Parameters { rate: RATE as f32, ratio: 1.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
    let grid = Grid { size: [side; 2], cell: [1.0; 2], edges: Edges::Closed };
    let places = || (0..side * side).map(|px| at(px, side));
    let maps = Maps {
        growth: places().map(|(growth, _)| growth as f32).collect(),
        decay_noise: places().map(|(_, decay)| (decay - TAKEN.0) as f32).collect(),
        ..Maps::new(grid, vec![parameters; side * side])
    };
    let mut growth = Growth::new(System::TURING_GROWTH, &maps, 1);
    growth.advance(growth.steps_in(TIME));
    growth.marks().values
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ground_lies_above_the_diagonal_and_marks_below_it() {
        let (side, marks) = (120, grown(120));
        let mean = |growth: [f64; 2], decay: [f64; 2]| {
            let inside = |px: &usize| {
                let (g, d) = at(*px, side);
                (growth[0]..growth[1]).contains(&g) && (decay[0]..decay[1]).contains(&d)
            };
            let px: Vec<usize> = (0..side * side).filter(inside).collect();
            px.iter().map(|px| f64::from(marks[*px])).sum::<f64>() / px.len() as f64
        };
        assert!(mean([0.0, 8.0], [22.0, 30.0]) < 0.05, "nothing lives on little growth");
        assert!(mean([22.0, 30.0], [0.0, 8.0]) > 0.7, "nothing dies of little decay");
    }

    #[test]
    fn the_box_is_drawn_where_turings_growth_lies() {
        assert!(on_box(17.49, 20.0, 0.05) && on_box(22.0, 20.53, 0.05));
        assert!(!on_box(22.0, 20.0, 0.05) && !on_box(10.0, 20.0, 0.05));
    }
}
