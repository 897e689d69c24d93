//! The plain solver: one explicit Euler step, cell by cell. Slow, obvious, and the judge of the fast one.

use super::kinetics::{Kinetics, Spread, euler};
use super::plane::Plane;
use super::problem::Problem;
use super::selling::OFFSETS;
use crate::field::Edges;

/// Steps the chemicals `u` once.
pub fn step<const N: usize, K: Kinetics<N>>(problem: &Problem, u: &mut [Plane; N]) {
    let old = u.clone();
    for y in 0..problem.ny {
        for x in 0..problem.nx {
            let cell = y * problem.nx + x;
            let here = old[0].at(x, y);
            let spread = std::array::from_fn(|i| match K::SPREAD[i] {
                Spread::Tensor(_) => tensor(problem, &old[i], [x, y]),
                Spread::Isotropic(_) => isotropic(problem, &old[i], here),
                Spread::Still => 0.0,
            });
            let mobility = [problem.mobility[0][cell], problem.mobility[1][cell]];
            let next = euler::<N, K>(
                std::array::from_fn(|i| old[i].values[here]),
                spread,
                mobility,
                problem.rate[cell],
            );
            for i in 0..N {
                u[i].values[here] = next[i];
            }
        }
    }
    for plane in u {
        plane.fill_margin(problem.edges);
    }
}

/// Σₖ wₖ (u(x + eₖ) + u(x − eₖ) − 2u(x)); what lies beyond a closed edge counts as u(x) itself.
///
/// Leaving out what crosses the edge is the natural boundary condition n·D∇u = 0. A mirror would demand
/// n·∇u = 0, which a tensor that is oblique to the edge does not conserve: spots would slide along the edge.
fn tensor(problem: &Problem, u: &Plane, [x, y]: [usize; 2]) -> f32 {
    let (here, stride) = (u.at(x, y), u.stride() as isize);
    let own = u.values[here];
    let at = |dx: isize, dy: isize| {
        let inside = x.checked_add_signed(dx).is_some_and(|x| x < problem.nx)
            && y.checked_add_signed(dy).is_some_and(|y| y < problem.ny);
        if inside || problem.edges == Edges::Wrap {
            u.values[here.wrapping_add_signed(dy * stride + dx)]
        } else {
            own
        }
    };
    let mut sum = 0.0;
    for (k, [dx, dy]) in OFFSETS.into_iter().enumerate() {
        let weight = problem.diffusion.weights[k][y * problem.nx + x];
        sum += weight * (at(dx, dy) + at(-dx, -dy) - 2.0 * own);
    }
    sum
}

fn isotropic(problem: &Problem, u: &Plane, here: usize) -> f32 {
    let twice = 2.0 * u.values[here];
    let stride = u.stride();
    problem.isotropic[0] * (u.values[here + 1] + u.values[here - 1] - twice)
        + problem.isotropic[1] * (u.values[here + stride] + u.values[here - stride] - twice)
}

#[cfg(test)]
mod tests {
    use super::super::diffusion::Diffusion;
    use super::super::selling::Tensor;
    use super::*;

    /// The largest error of the stencil of a constant tensor on sin(x)·sin(y), n cells a period.
    fn stencil_error(n: usize, tensor: Tensor) -> f64 {
        let k = std::f64::consts::TAU / n as f64;
        let at = |i: usize| k * i as f64;
        let mut u = Plane::flat(n, n, 0.0);
        for y in 0..n {
            for x in 0..n {
                let here = u.at(x, y);
                u.values[here] = (libm::sin(at(x)) * libm::sin(at(y))) as f32;
            }
        }
        u.fill_margin(Edges::Wrap);
        let problem = problem(n, n, tensor);
        let mut largest = 0.0f64;
        for y in 0..n {
            for x in 0..n {
                let found = f64::from(super::tensor(&problem, &u, [x, y])) / (k * k);
                let (sx, sy) = (libm::sin(at(x)), libm::sin(at(y)));
                let (cx, cy) = (libm::cos(at(x)), libm::cos(at(y)));
                let exact = -(tensor.xx + tensor.yy) * sx * sy + 2.0 * tensor.xy * cx * cy;
                largest = largest.max((found - exact).abs());
            }
        }
        largest
    }

    fn problem(nx: usize, ny: usize, tensor: Tensor) -> Problem {
        Problem {
            nx,
            ny,
            edges: Edges::Wrap,
            diffusion: Diffusion::new(nx, ny, |_| tensor),
            isotropic: [1.0, 1.0],
            mobility: [vec![1.0; nx * ny], vec![1.0; nx * ny]],
            rate: vec![1.0; nx * ny],
        }
    }

    #[test]
    fn the_stencil_converges_with_order_two_at_any_angle() {
        for degrees in [0.0, 17.0, 45.0, 80.0, 130.0] {
            for stretch in [1.0, 0.5, 0.3] {
                let tensor = Tensor::oriented(1.0 / stretch, stretch, degrees);
                let order = (stencil_error(16, tensor) / stencil_error(32, tensor)).log2();
                assert!(order > 1.85 && order < 2.3, "{degrees}° {stretch}: order {order}");
            }
        }
    }

    #[test]
    fn nothing_flows_across_a_closed_edge_whatever_the_tensor() {
        let tensor = Tensor::oriented(3.0, 0.33, 30.0);
        let problem = Problem { edges: Edges::Closed, ..problem(9, 7, tensor) };
        let cells: Vec<f32> = (0..63).map(|i| libm::sinf(i as f32 * 1.7) + 2.0).collect();
        let u = Plane::from_cells(9, 7, &cells, Edges::Closed).expect("63 cells");
        let gained: f32 =
            (0..7).flat_map(|y| (0..9).map(move |x| [x, y])).map(|at| super::tensor(&problem, &u, at)).sum();
        assert!(gained.abs() < 1e-4, "{gained}");
    }

    #[test]
    fn the_stencil_is_exact_on_quadratics() {
        let tensor = Tensor::oriented(2.5, 0.4, 33.0);
        let problem = problem(5, 5, tensor);
        let mut u = Plane::flat(5, 5, 0.0);
        let stride = u.stride();
        for (i, value) in u.values.iter_mut().enumerate() {
            let (x, y) = ((i % stride) as f32, (i / stride) as f32);
            *value = 0.5 * x * x + 0.25 * x * y - 1.5 * y * y + 2.0 * x - y + 7.0;
        }
        let exact = tensor.xx + 0.5 * tensor.xy - 3.0 * tensor.yy;
        let found = super::tensor(&problem, &u, [2, 2]);
        assert!((f64::from(found) - exact).abs() < 1e-4, "{found} for {exact}");
    }
}
