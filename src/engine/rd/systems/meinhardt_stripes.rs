//! Meinhardt stripes: two activators that exclude each other and help each other at a distance.
//!
//! ∂a/∂t = 0.01 a²e/c − k_ab a + ∇·(Dₐ∇a)
//! ∂b/∂t = 0.01 b²d/c − k_ab b + ∇·(Dₐ∇b)
//! ∂c/∂t = 0.01 a²e + 0.01 b²d − k_c c
//! ∂d/∂t = k_de(a − d) + D_d∇²d
//! ∂e/∂t = k_de(b − e) + D_d∇²e
//!
//! Meinhardt (1982); in this form Turk (1991) and Phan & Grimm (2006), appendix C. All reactions share one
//! rate factor s, so that s/Dₐ alone sets the width. Only a and b diffuse by the tensor: with d and e isotropic, stripes run
//! along its long axis (`facts.md` E).

use crate::attributes::Attribute;
use crate::attributes::columns;
use crate::attributes::system::{Description, LookupBy, MarkKind, picture};
use crate::rd::chemicals::reacting;
use crate::rd::definition::{
    Begin, Convergence, Cost, Definition, ErrorBounds, Laws, MarkCells, Resolution, Scatter, System,
};
use crate::rd::gabor::{self, Kernels};
use crate::rd::kinetics::{Kinetics, Spreading};
use crate::rd::line_noise::{Reach, lead};
use crate::rd::oriented_waves::{WaveStart, WaveValue};
use crate::rd::parameter_field::{ParameterField, Parameters};
use crate::rd::seeding::{Seeding, seeded, waves};
use crate::rd::selling::PrincipalAxes;
use crate::rd::sparse::reacting_by_rows;
use crate::rd::start::Start;
use crate::rd::sweep;
use crate::rd::systems::embedded;
use crate::rd::vector::Number;

impl System {
    /// Five chemicals; stripes as wide as the gaps between them.
    pub const MEINHARDT_STRIPES: Self = Self::new(&DEFINITION);
}

static DEFINITION: Definition = Definition {
    description: Description {
        name: "meinhardt-stripes",
        title: "Meinhardt's stripes",
        noun: "Meinhardt's stripes",
        help: "Stripes as wide as the gaps between them",
        picture: picture!("meinhardt-stripes"),
        marks: MarkKind::Stripes,
        seeding: true,
        tone: true,
        option_keys: &["keep", "duty", "seeding", "vary", "double", "ragged"],
        lookup: LookupBy::Rows,
        columns: &columns::STRIPES,
        training: embedded!("meinhardt-stripes-orientation", "meinhardt-stripes-width"),
        neighbours: &[75, 42],
        ..Description::PLAIN
    },
    chemicals: &["a", "b", "c", "d", "e"],
    spread: &MeinhardtStripes::SPREAD,
    tensors: &[PrincipalAxes::of_unit_width],
    mobilities: |_| [1.0, RATIO],
    reacting: |_, _, planes| reacting(MeinhardtStripes, planes),
    by_rows: Some(|rows, _| reacting_by_rows(MeinhardtStripes, rows)),
    fineness: None,
    begin: Begin::Waves {
        on_grid: begin,
        on_any: Some(WaveStart {
            kernels: NOISE_ON_SURFACES,
            lead: LEAD,
            value: WaveValue::Height,
            fill: write_ripples,
        }),
    },
    peaks: None,
    show: |chemicals, _, marks| {
        for ((mark, a), b) in marks.iter_mut().zip(chemicals[0]).zip(chemicals[1]) {
            *mark = a / (a + b);
        }
    },
    decay_noise: None,
    along_curves: None,
    obstacle: &OBSTACLE,
    obstacle_rim: 0.0,
    g: None,
    decay: K_AB,
    // `facts.md` C.
    reaction_limit: 4.0,
    // `facts.md` S: 12 is accurate, 24 diverges.
    super_step_limit: 11.0,
    laws: Laws {
        size: |_| 0.25 * WAVELENGTH * WAVELENGTH,
        spacing: |_| WAVELENGTH,
        // `facts.md` C: width 40.5/√rate.
        rate: |width, _, _| {
            let root = 40.5 / width;
            root * root
        },
    },
    compensation: 0.0,
    // `facts.md` C: wavelengths of 12–20 cells. The training set reaches to widths of 16.
    resolution: Resolution {
        least: 18.0,
        enough: 23.0,
        thin_side: false,
        planned: MarkCells::always(8.0),
        exact: MarkCells::always(14.0),
    },
    convergence: Convergence { earliest: 30.0, latest: 300.0, drift: 0.008, corrected: 2.0, still: 0.01 },
    scatter: Scatter { size: 0.014, spacing: 0.0, elongation: 0.0, direction: 0.5 },
    tolerated: Scatter { size: 0.03, spacing: 0.0, elongation: 0.0, direction: 1.0 },
    // A sinusoidal profile: width = (λ/π) arccos(2l − 1).
    level_slope: -2.0 / std::f64::consts::PI,
    spots: None,
    cost: Cost { seconds_a_cell: 2e-6, bytes_a_cell: 150.0, updates: 0.29, updates_on_one_grid: 0.29 },
    sweep: &[sweep::WIDTH, sweep::STRETCH, sweep::DIRECTION],
    usual_rate: 40.0,
    error_bounds: ErrorBounds {
        looked_up: &[(Attribute::Width, [2.0, 6.0]), (Attribute::Angle, [1.5, 4.0])],
        refined: &[(Attribute::Width, [1.0, 3.0])],
    },
};

/// a, b, c, d, e.
#[derive(Clone, Copy, Debug)]
pub struct MeinhardtStripes;

/// Decay of the activators.
const K_AB: f32 = 0.04;
/// Decay of the shared inhibitor. With the published 0.06 (1.5 k_ab) concentrations diverge; with 2 k_ab they settle (`facts.md` C).
const K_C: f32 = 0.08;
/// Exchange of d and e with the activators.
const K_DE: f32 = 0.04;
/// D_d/Dₐ. `facts.md` C: the wavelength hardly depends on it between 3 and 5; 5 is where its law was fitted.
const RATIO: f32 = 5.0;

/// Concentrations at rest: a = b = d = e = k_c/(2 k_ab), c = 0.02 a³/k_c.
const REST: [f32; 5] = {
    let a = K_C / (2.0 * K_AB);
    [a, a, 0.02 * a * a * a / K_C, a, a]
};

/// Concentrations on a seed: a raised, b lowered (`facts.md` E).
const SEED: [f32; 5] = [1.5, 0.6, REST[2], REST[3], REST[4]];

impl Kinetics<5> for MeinhardtStripes {
    const SPREAD: [Spreading; 5] = [
        Spreading::Tensor { tensor: 0, mobility: 0 },
        Spreading::Tensor { tensor: 0, mobility: 0 },
        Spreading::Still,
        Spreading::Isotropic { mobility: 1 },
        Spreading::Isotropic { mobility: 1 },
    ];

    #[inline(always)]
    fn react<V: Number>(&self, [a, b, c, d, e]: [V; 5]) -> [V; 5] {
        let [source, k_ab] = [V::splat(0.01), V::splat(K_AB)];
        let [k_c, k_de] = [V::splat(K_C), V::splat(K_DE)];
        let from_a = source * a * a * e;
        let from_b = source * b * b * d;
        let inverse = V::splat(1.0) / c;
        [
            from_a * inverse - k_ab * a,
            from_b * inverse - k_ab * b,
            from_a + from_b - k_c * c,
            k_de * (a - d),
            k_de * (b - e),
        ]
    }
}

/// Noise with the wavelength and the direction of the stripes.
const NOISE: Kernels = Kernels { reach: [4.0, 1.8], density: 2.0 };
/// On surfaces directions turn and surfaces bend within long kernels: shorter ones follow both.
const NOISE_ON_SURFACES: Kernels = Kernels { reach: [3.0, 1.5], density: 2.0 };
/// Stripes repair defects: the noise follows guide lines over a short distance.
const LEAD: Reach = Reach { beyond: [0.0, 1.5], across: [0.4, 1.3] };

fn begin(start: &Start, maps: &ParameterField) -> Vec<Vec<f32>> {
    let lines = start.lines;
    let wavelength = |p: &Parameters| System::MEINHARDT_STRIPES.spacing(p);
    match start.seeding {
        Seeding::Noise => {
            let mut noise = gabor::noise(maps, &wavelength, NOISE, &mut start.random());
            lead(&mut noise, maps, lines, &wavelength, LEAD);
            ripples(&noise)
        }
        Seeding::Segments => {
            let seeded = seeded(maps, lines, &wavelength);
            let mut cells = REST.map(|c| vec![c; seeded.len()]);
            for (cells, seed) in cells.iter_mut().zip(SEED) {
                cells.iter_mut().zip(&seeded).for_each(|(cell, share)| *cell += share * (seed - *cell));
            }
            cells.into()
        }
        Seeding::Initiators => ripples(&waves(maps, lines, &wavelength)),
    }
}

/// The ground at rest with a and d raised, b and e lowered by `noise`.
fn ripples(noise: &[f32]) -> Vec<Vec<f32>> {
    let mut cells = REST.map(|c| vec![c; noise.len()]);
    write_ripples(&mut cells.each_mut().map(Vec::as_mut_slice), noise, &[]);
    cells.into()
}

/// Writes the ground at rest with a and d raised, b and e lowered by `noise`.
fn write_ripples(cells: &mut [&mut [f32]], noise: &[f32], _: &[Parameters]) {
    for (chemical, (cells, rest)) in cells.iter_mut().zip(REST).enumerate() {
        let sign = [1.0, -1.0, 0.0, 1.0, -1.0][chemical];
        for (cell, noise) in cells.iter_mut().zip(noise) {
            *cell = rest * (1.0 + sign * (0.2 * noise).clamp(-0.9, 0.9));
        }
    }
}

/// Wavelength × √rate (`facts.md` C: 81√(Dₐ/s)).
const WAVELENGTH: f64 = 81.0;

/// The ground between stripes: the state of a net's cells in `facts.md` G, with a and b exchanged, and d and e.
const OBSTACLE: [f32; 5] = [0.05, 1.95, 0.33, 0.69, 1.31];
