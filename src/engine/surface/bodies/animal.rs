//! A big cat that walks: chains of bars along its bones, joined by fillets.

use super::super::model::Model;
use super::bars::{Bar, Chain, distance, joined};
use super::implicit::model;

/// Trunk, neck and head, each point: x, y, z, radius, width as a share of the height.
fn middle() -> [Chain; 6] {
    [
        // From the breast to the rump.
        Chain::new(
            0.05,
            &[
                [0.42, 0.605, 0.0, 0.095, 0.80],
                [0.34, 0.588, 0.0, 0.160, 0.72],
                [0.20, 0.580, 0.0, 0.178, 0.70],
                [0.04, 0.592, 0.0, 0.160, 0.72],
                [-0.12, 0.612, 0.0, 0.132, 0.76],
                [-0.26, 0.625, 0.0, 0.124, 0.82],
                [-0.38, 0.615, 0.0, 0.122, 0.86],
                [-0.46, 0.612, 0.0, 0.085, 0.90],
            ],
        ),
        // The neck.
        Chain::new(
            0.07,
            &[
                [0.30, 0.640, 0.0, 0.130, 0.72],
                [0.43, 0.705, 0.0, 0.104, 0.80],
                [0.52, 0.775, 0.0, 0.084, 0.88],
                [0.58, 0.835, 0.0, 0.074, 0.95],
            ],
        ),
        // The skull, from the nape to the brow.
        Chain::new(
            0.04,
            &[
                [0.565, 0.856, 0.0, 0.076, 1.0],
                [0.615, 0.868, 0.0, 0.086, 1.0],
                [0.660, 0.858, 0.0, 0.076, 1.0],
                [0.690, 0.842, 0.0, 0.058, 1.0],
            ],
        ),
        // The muzzle, the nose, the chin.
        Chain::new(
            0.03,
            &[
                [0.680, 0.832, 0.0, 0.050, 1.1],
                [0.735, 0.822, 0.0, 0.042, 1.15],
                [0.755, 0.819, 0.0, 0.036, 1.2],
            ],
        ),
        Chain::new(0.015, &[[0.720, 0.848, 0.0, 0.020, 1.2], [0.778, 0.838, 0.0, 0.016, 1.4]]),
        Chain::new(0.02, &[[0.690, 0.797, 0.0, 0.030, 1.1], [0.740, 0.790, 0.0, 0.024, 1.1]]),
    ]
}

/// The points of a limb, which are given for the side z > 0, on the side `side` (1 or −1). The foot is `ahead` of its position in a
/// vertical leg.
fn chain<const N: usize>(fillet: f64, side: f64, ahead: f64, points: [[f64; 5]; N]) -> Chain {
    let placed =
        |[x, y, z, radius, flat]: [f64; 5]| [x + ahead * (1.0 - y / 0.6).max(0.0), y, z * side, radius, flat];
    Chain::new(fillet, &points.map(placed))
}

/// Cheek and ear.
fn side_of_head(side: f64) -> [Chain; 2] {
    [
        chain(0.03, side, 0.0, [[0.620, 0.838, 0.040, 0.048, 0.9], [0.668, 0.826, 0.036, 0.040, 0.9]]),
        chain(
            0.02,
            side,
            0.0,
            [
                [0.592, 0.918, 0.056, 0.025, 1.7],
                [0.590, 0.948, 0.066, 0.023, 1.6],
                [0.584, 0.970, 0.073, 0.013, 1.5],
            ],
        ),
    ]
}

/// The leg and the paw.
fn fore_leg(side: f64, ahead: f64) -> [Chain; 2] {
    let leg = [
        [0.325, 0.650, 0.062, 0.085, 0.70],
        [0.335, 0.540, 0.082, 0.092, 0.70],
        [0.285, 0.420, 0.094, 0.064, 0.80],
        [0.284, 0.300, 0.092, 0.046, 0.92],
        [0.298, 0.170, 0.087, 0.036, 1.0],
        [0.300, 0.100, 0.086, 0.031, 1.0],
        [0.302, 0.045, 0.086, 0.033, 1.0],
    ];
    let paw = [
        [0.304, 0.036, 0.086, 0.036, 1.1],
        [0.340, 0.034, 0.088, 0.038, 1.2],
        [0.372, 0.026, 0.089, 0.026, 1.3],
    ];
    [chain(0.06, side, ahead, leg), chain(0.02, side, ahead, paw)]
}

/// The leg and the paw.
fn hind_leg(side: f64, ahead: f64) -> [Chain; 2] {
    let leg = [
        [-0.385, 0.630, 0.055, 0.095, 0.75],
        [-0.355, 0.520, 0.076, 0.122, 0.66],
        [-0.290, 0.410, 0.092, 0.082, 0.70],
        [-0.335, 0.315, 0.094, 0.055, 0.82],
        [-0.412, 0.235, 0.092, 0.038, 0.95],
        [-0.432, 0.195, 0.091, 0.036, 1.0],
        [-0.418, 0.110, 0.090, 0.031, 1.0],
        [-0.408, 0.045, 0.090, 0.033, 1.0],
    ];
    let paw = [
        [-0.406, 0.036, 0.090, 0.036, 1.1],
        [-0.366, 0.034, 0.092, 0.037, 1.2],
        [-0.336, 0.026, 0.093, 0.026, 1.3],
    ];
    [chain(0.07, side, ahead, leg), chain(0.02, side, ahead, paw)]
}

fn tail() -> Chain {
    Chain::new(
        0.06,
        &[
            [-0.44, 0.660, 0.0, 0.052, 1.0],
            [-0.52, 0.630, 0.0, 0.042, 1.0],
            [-0.62, 0.535, 0.01, 0.036, 1.0],
            [-0.73, 0.410, 0.02, 0.034, 1.0],
            [-0.87, 0.335, 0.04, 0.033, 1.0],
            [-1.01, 0.355, 0.06, 0.032, 1.0],
            [-1.11, 0.445, 0.07, 0.031, 1.0],
            [-1.16, 0.545, 0.07, 0.027, 1.0],
        ],
    )
}

pub fn animal() -> Model {
    // It walks: the feet of either side move in opposite directions.
    let mut chains = middle().to_vec();
    for (side, fore, hind) in [(1.0, 0.07, -0.06), (-1.0, -0.07, 0.08)] {
        chains.extend(side_of_head(side));
        chains.extend(fore_leg(side, fore));
        chains.extend(hind_leg(side, hind));
    }
    chains.push(tail());
    let sockets = [1.0, -1.0].map(|side| {
        let place = [0.716, 0.874, 0.050 * side];
        Bar::new(place, place, [0.020; 2], 1.0)
    });
    let field = |place: [f64; 3]| {
        let sockets = sockets.iter().map(|socket| socket.distance(place)).fold(f64::MAX, f64::min);
        -joined(-distance(&chains, place), sockets, 0.02)
    };
    model(&field, [[-1.3, -0.06, -0.3], [0.9, 1.05, 0.3]], 0.0105)
}
