//! Comparisons of growth on models: other triangulations of one surface, and other ways to compute diffusion on it.

mod eigenvector;
mod figure;
mod parametric;
mod spread;
mod triangulations;
mod turk;
mod whole;

use std::path::PathBuf;

use dapple_engine::rd::System;

/// The comparison to make.
#[derive(clap::Args)]
pub struct Args {
    #[command(subcommand)]
    what: What,
}

#[derive(clap::Subcommand)]
enum What {
    /// Grow stripes, and compute stripes by the smallest eigenvector (Knöppel et al. 2015) for the same directions and wavelength
    Stripes {
        /// Seeds of the grown ones
        #[arg(long, default_value_t = 3)]
        seeds: u64,
    },
    /// Grow on four triangulations of the same surface (the animal), and on meshes with fewer triangles
    Meshes {
        /// Seeds for each mesh
        #[arg(long, default_value_t = 5)]
        seeds: u64,
    },
    /// Grow flat maps of hills and of a torus, corrected by their metric, and meshes of the same surfaces
    Parametric {
        /// Seeds for each surface
        #[arg(long, default_value_t = 5)]
        seeds: u64,
        /// A picture of the hills
        #[arg(short, long, value_name = "OUT.png", default_value = "assets/heights.png")]
        output: PathBuf,
    },
    /// Turk's method (1991): points that repel each other, their planar Voronoi cells, normalised coefficients
    Turk {
        /// Seeds for each row of the table
        #[arg(long, default_value_t = 5)]
        seeds: u64,
        /// A picture of the six steps, like figure 7 of the paper
        #[arg(short, long, value_name = "OUT.png", default_value = "assets/turk-mesh.png")]
        output: PathBuf,
    },
}

/// Grows all and prints tables as Markdown.
pub fn run(args: &Args) -> Result<(), String> {
    match &args.what {
        What::Stripes { seeds } => eigenvector::table(*seeds),
        What::Meshes { seeds } => {
            whole::table(*seeds)?;
            spread::table(*seeds)
        }
        What::Parametric { seeds, output } => {
            parametric::table(*seeds)?;
            figure::save_heights(output)
        }
        What::Turk { seeds, output } => {
            turk::table(*seeds)?;
            figure::save(output)
        }
    }
}

/// The system whose spots grow on surfaces.
fn system() -> Result<System, String> {
    let grows = |system: &System| system.definition().fineness.is_some();
    System::ALL.into_iter().find(grows).ok_or_else(|| "no spots grow on surfaces".to_owned())
}

/// The mean of some numbers.
fn mean(numbers: impl Iterator<Item = f64> + Clone) -> f64 {
    numbers.clone().sum::<f64>() / numbers.count().max(1) as f64
}

/// The coefficient of variation of some numbers.
fn variation(numbers: impl Iterator<Item = f64> + Clone) -> f64 {
    let middle = mean(numbers.clone());
    mean(numbers.map(|number| (number - middle) * (number - middle))).sqrt() / middle
}
