//! The plain solver: explicit steps, row by row. The fast solver is tested against it.

use super::kinetics::{Kinetics, MOBILITIES, Spreading, stepped};
use super::plane::{LANES, MARGIN, Plane};
use super::problem::Problem;
use super::selling::OFFSETS;
use super::super_step::Stage;
use crate::grid::Edges;

/// Takes one stage, from `old` into `new`, which holds the chemicals before `old`; in the first stage its contents do not
/// matter.
pub fn step<const N: usize, K: Kinetics<N>>(
    problem: &Problem,
    kinetics: &K,
    stage: Stage,
    old: &[Plane; N],
    new: &mut [Plane; N],
) {
    let stride = problem.grid.stride();
    let mut stencils = vec![Stencil::new(stride); problem.tensors.len()];
    let mut mobility = vec![0.0; MOBILITIES * stride];
    let mut rate = vec![0.0; stride];
    let mut spread = vec![0.0; N * stride];
    for y in 0..problem.grid.ny {
        // Weights are computed again only if a row differs from the previous one.
        let same = |alike: &dyn Fn(usize, usize) -> bool| y > 0 && alike(y, y - 1);
        for (stencil, tensor) in stencils.iter_mut().zip(&problem.tensors) {
            if !same(&|y, other| tensor.weights.alike(y, other)) {
                stencil.used = tensor.weights.row(y, &mut stencil.weights);
                center_row(stencil.used, &stencil.weights, &mut stencil.center);
            }
        }
        if !same(&|y, other| problem.mobility.alike(y, other)) {
            problem.mobility.row(y, &mut mobility);
        }
        if !same(&|y, other| problem.rate.alike(y, other)) {
            problem.rate.row(y, &mut rate);
        }
        for (i, spread) in spread.chunks_exact_mut(stride).enumerate() {
            match K::SPREAD[i] {
                Spreading::Tensor { tensor, .. } => {
                    tensor_row(problem, tensor, &old[i], y, &stencils[tensor], spread);
                }
                Spreading::Isotropic { .. } => isotropic_row(problem, &old[i], y, spread),
                Spreading::Still => {}
            }
        }
        let from = old.each_ref().map(|plane| plane.memory(y));
        let mut to = new.each_mut().map(|plane| &mut plane.memory_mut()[y * stride..(y + 1) * stride]);
        for place in problem.grid.inner().map(|group| group * LANES) {
            step_lanes::<N, K>((kinetics, stage), &from, &spread, [&mobility, &rate], &mut to, place);
        }
        to.into_iter().for_each(|row| problem.grid.fill_margins(row));
    }
}

/// The weights of one tensor along a row.
#[derive(Clone)]
struct Stencil {
    /// The offsets in use, as bits.
    used: u32,
    weights: Vec<f32>,
    /// 2 Σₖ wₖ.
    center: Vec<f32>,
}

impl Stencil {
    fn new(stride: usize) -> Self {
        Self { used: 0, weights: vec![0.0; OFFSETS.len() * stride], center: vec![0.0; stride] }
    }
}

/// Steps [`LANES`] cells of a row, given their diffusion term.
fn step_lanes<const N: usize, K: Kinetics<N>>(
    (kinetics, Stage { repeated, weight }): (&K, Stage),
    from: &[&[f32]; N],
    spread: &[f32],
    [mobility, rate]: [&[f32]; 2],
    to: &mut [&mut [f32]; N],
    place: usize,
) {
    let stride = rate.len();
    let lanes = |row: &[f32], at: usize| -> [f32; LANES] {
        let mut lanes = [0.0; LANES];
        lanes.copy_from_slice(&row[at..at + LANES]);
        lanes
    };
    let (rate, mobility) = (lanes(rate, place), [lanes(mobility, place), lanes(mobility, stride + place)]);
    let (mut u, mut d, mut next) = ([[0.0; LANES]; N], [[0.0; LANES]; N], [[0.0; LANES]; N]);
    for i in 0..N {
        u[i] = lanes(from[i], place);
        next[i] = lanes(to[i], place);
        d[i] = lanes(spread, i * stride + place);
    }
    for j in 0..LANES {
        let (mut here, mut laplacian) = ([0.0; N], [0.0; N]);
        for i in 0..N {
            here[i] = u[i][j];
            laplacian[i] = d[i][j];
        }
        let mut base = here;
        if repeated != 0.0 {
            for i in 0..N {
                base[i] = here[i] + repeated * (here[i] - next[i][j]);
            }
        }
        let mobility = [weight * mobility[0][j], weight * mobility[1][j]];
        let stepped = stepped::<N, K, f32>(kinetics, [here, base], laplacian, mobility, weight * rate[j]);
        for i in 0..N {
            next[i][j] = stepped[i];
        }
    }
    for i in 0..N {
        to[i][place..place + LANES].copy_from_slice(&next[i]);
    }
}

/// 2 Σₖ wₖ along a row.
fn center_row(used: u32, weights: &[f32], center: &mut [f32]) {
    center.fill(0.0);
    let in_use = weights.chunks_exact(center.len()).enumerate().filter(|(k, _)| used & (1 << k) != 0);
    for (_, weights) in in_use {
        center.iter_mut().zip(weights).for_each(|(center, weight)| *center += weight);
    }
    center.iter_mut().for_each(|center| *center *= 2.0);
}

/// Σₖ wₖ (u(x + eₖ) + u(x − eₖ)) − (2 Σₖ wₖ) u(x) along row `y`.
fn tensor_row(
    problem: &Problem,
    tensor: usize,
    u: &Plane,
    y: usize,
    Stencil { used, weights, center }: &Stencil,
    spread: &mut [f32],
) {
    let used = *used;
    let (grid, stride) = (problem.grid, problem.grid.stride());
    let cells = MARGIN..MARGIN + grid.nx;
    let shifted = |dx: isize, dy: isize| {
        let row = u.memory(grid.row(y as isize + dy));
        &row[cells.start.wrapping_add_signed(dx)..][..grid.nx]
    };
    let number = |k: usize| &weights[k * stride..][cells.clone()];
    let sums = &mut spread[cells.clone()];
    let (own, center) = (shifted(0, 0), &center[cells.clone()]);
    if used == 0b11 && problem.tensors.len() == 1 {
        // The five-point stencil in one expression, as in the fast solver.
        let (east, west, south, north) = (shifted(1, 0), shifted(-1, 0), shifted(0, 1), shifted(0, -1));
        let (wx, wy) = (number(0), number(1));
        for x in 0..grid.nx {
            sums[x] = wx[x] * (east[x] + west[x]) + wy[x] * (south[x] + north[x]) - center[x] * own[x];
        }
    } else {
        sums.fill(0.0);
        for (k, [dx, dy]) in OFFSETS.into_iter().enumerate().filter(|(k, _)| used & (1 << k) != 0) {
            let (weight, there, back) = (number(k), shifted(dx, dy), shifted(-dx, -dy));
            for x in 0..grid.nx {
                sums[x] += weight[x] * (there[x] + back[x]);
            }
        }
        for x in 0..grid.nx {
            sums[x] -= center[x] * own[x];
        }
    }
    if grid.edges == Edges::Closed {
        let reach = problem.reach;
        let edge_row = y < reach || y + reach >= grid.ny;
        for x in (0..grid.nx).filter(|x| edge_row || *x < reach || x + reach >= grid.nx) {
            spread[MARGIN + x] = at_cell(problem, tensor, u, [x, y]);
        }
    }
}

/// The diffusion term at one cell; a neighbour beyond a closed edge counts as u(x) itself.
///
/// Omitting differences across the edge gives the natural boundary condition n·D∇u = 0. A mirror would give n·∇u = 0, which
/// does not conserve u with a tensor oblique to the edge: spots would move along the edge.
fn at_cell(problem: &Problem, tensor: usize, u: &Plane, [x, y]: [usize; 2]) -> f32 {
    let grid = problem.grid;
    let own = u.row(y)[x];
    let at = |dx: isize, dy: isize| {
        let inside = x.checked_add_signed(dx).is_some_and(|x| x < grid.nx)
            && y.checked_add_signed(dy).is_some_and(|y| y < grid.ny);
        if inside || grid.edges == Edges::Wrap {
            u.row(grid.row(y as isize + dy))[grid.edges.index(x as isize + dx, grid.nx)]
        } else {
            own
        }
    };
    let weights = problem.tensors[tensor].weights.cell(x, y);
    let (mut sum, mut center) = (0.0, 0.0);
    for ([dx, dy], weight) in OFFSETS.into_iter().zip(weights) {
        sum += weight * (at(dx, dy) + at(-dx, -dy));
        center += weight;
    }
    sum - 2.0 * center * own
}

/// ∂²u/∂x² + ∂²u/∂y² along row `y`, on cells that need not be square.
fn isotropic_row(problem: &Problem, u: &Plane, y: usize, spread: &mut [f32]) {
    let (grid, [wx, wy, center]) = (problem.grid, problem.isotropic_weights());
    let cells = MARGIN..MARGIN + grid.nx;
    let row = u.memory(y);
    let (own, west, east) = (&row[cells.clone()], &row[cells.start - 1..], &row[cells.start + 1..]);
    let (north, south) = (u.row(grid.row(y as isize - 1)), u.row(grid.row(y as isize + 1)));
    let sums = spread[cells].iter_mut().zip(own).zip(east).zip(west).zip(south).zip(north);
    for (((((sum, own), east), west), south), north) in sums {
        *sum = wx * (east + west) + wy * (south + north) - center * own;
    }
}

#[cfg(test)]
mod tests {
    use super::super::coefficients::Coefficients;
    use super::super::diffusion::Diffusion;
    use super::super::plane::RowLayout;
    use super::super::selling::PrincipalAxes;
    use super::*;

    /// The largest error of the stencil of a constant tensor on sin(x)·sin(y), n cells a period.
    fn stencil_error(n: usize, axes: PrincipalAxes) -> f64 {
        let k = std::f64::consts::TAU / n as f64;
        let at = |i: usize| k * i as f64;
        let (problem, tensor) = (problem(n, n, Edges::Wrap, axes), axes.tensor());
        let cells: Vec<f32> =
            (0..n * n).map(|i| (libm::sin(at(i % n)) * libm::sin(at(i / n))) as f32).collect();
        let u = Plane::from_cells(problem.grid, &cells).expect("n² cells");
        let mut largest = 0.0f64;
        for y in 0..n {
            for x in 0..n {
                let found = f64::from(at_cell(&problem, 0, &u, [x, y])) / (k * k);
                let (sx, sy) = (libm::sin(at(x)), libm::sin(at(y)));
                let (cx, cy) = (libm::cos(at(x)), libm::cos(at(y)));
                let exact = -(tensor.xx + tensor.yy) * sx * sy + 2.0 * tensor.xy * cx * cy;
                largest = largest.max((found - exact).abs());
            }
        }
        largest
    }

    fn problem(nx: usize, ny: usize, edges: Edges, axes: PrincipalAxes) -> Problem {
        let grid = RowLayout { nx, ny, edges };
        let rate = Coefficients::new(grid, |_| (), |()| [1.0]);
        let mobility = Coefficients::new(grid, |_| (), |()| [1.0, 1.0]);
        Problem::new(grid, vec![Diffusion::new(grid, [1.0; 2], |_| axes)], [1.0, 1.0], mobility, rate, 1.0)
    }

    #[test]
    fn the_stencil_converges_with_order_two_at_any_angle() {
        for degrees in [0.0, 17.0, 45.0, 80.0, 130.0] {
            for stretch in [1.0, 0.5, 0.3] {
                let axes = PrincipalAxes { along: 1.0 / stretch, across: stretch, degrees };
                let order = (stencil_error(16, axes) / stencil_error(32, axes)).log2();
                assert!(order > 1.85 && order < 2.3, "{degrees}° {stretch}: order {order}");
            }
        }
    }

    #[test]
    fn nothing_flows_across_a_closed_edge_whatever_the_tensor() {
        for stretch in [0.33, 0.14] {
            let axes = PrincipalAxes { along: 1.0 / stretch, across: stretch, degrees: 30.0 };
            let problem = problem(9, 7, Edges::Closed, axes);
            let cells: Vec<f32> = (0..63).map(|i| libm::sinf(i as f32 * 1.7) + 2.0).collect();
            let u = Plane::from_cells(problem.grid, &cells).expect("63 cells");
            let all = (0..7).flat_map(|y| (0..9).map(move |x| [x, y]));
            let gained: f32 = all.map(|at| at_cell(&problem, 0, &u, at)).sum();
            assert!(gained.abs() < 2e-4, "{stretch}: {gained}");
        }
    }

    #[test]
    fn the_stencil_is_exact_on_quadratics() {
        let axes = PrincipalAxes { along: 2.5, across: 0.4, degrees: 33.0 };
        let (problem, tensor) = (problem(5, 5, Edges::Closed, axes), axes.tensor());
        let at = |i: usize| [(i % 5) as f32, (i / 5) as f32];
        let quadratic = |[x, y]: [f32; 2]| 0.5 * x * x + 0.25 * x * y - 1.5 * y * y + 2.0 * x - y + 7.0;
        let cells: Vec<f32> = (0..25).map(|i| quadratic(at(i))).collect();
        let u = Plane::from_cells(problem.grid, &cells).expect("25 cells");
        let exact = tensor.xx + 0.5 * tensor.xy - 3.0 * tensor.yy;
        let found = at_cell(&problem, 0, &u, [2, 2]);
        assert!((f64::from(found) - exact).abs() < 1e-4, "{found} for {exact}");
    }
}
