//! A first guess from fewer unknowns: vertices are aggregated into groups with one direction each, which is transported into their
//! frames.
//!
//! The coarse equations are those of the same energy (Galerkin). Groups are those of P. Vaněk, J. Mandel, M. Brezina, "Algebraic multigrid
//! by smoothed aggregation", Computing 56 (1996), not smoothed: only a guess is needed.

use std::collections::BTreeMap;

use super::hermitian::{Complex, Hermitian, conjugate, plus, times, unit};

/// Systems of at most this number of unknowns are solved directly.
const FEW: usize = 1_000;

/// The group of each row, and its value for the direction [1, 0] of the group.
struct Groups {
    group: Vec<u32>,
    carried: Vec<Complex>,
    count: usize,
}

/// The solution of the equations.
pub fn solve(matrix: &Hermitian) -> Vec<Complex> {
    let rows = matrix.diagonal.len();
    let guess = if rows <= FEW {
        vec![[0.0; 2]; rows]
    } else {
        let groups = gathered(matrix);
        // Nothing is aggregated if no row has a neighbour.
        if groups.count < rows { groups.spread(&solve(&groups.coarse(matrix))) } else { vec![[0.0; 2]; rows] }
    };
    matrix.solve(guess)
}

/// A row and all its neighbours form a group if none of them is in another; the remaining rows join the group of a neighbour.
fn gathered(matrix: &Hermitian) -> Groups {
    const NONE: u32 = u32::MAX;
    let rows = matrix.diagonal.len();
    let mut groups = Groups { group: vec![NONE; rows], carried: vec![[1.0, 0.0]; rows], count: 0 };
    for row in 0..rows {
        let is_free = |row: usize| groups.group[row] == NONE;
        if is_free(row) && matrix.row(row).all(|(column, _)| is_free(column)) {
            let own = groups.count as u32;
            groups.group[row] = own;
            for (column, coupling) in matrix.row(row) {
                groups.group[column] = own;
                groups.carried[column] = unit(conjugate(coupling));
            }
            groups.count += 1;
        }
    }
    let first = groups.group.clone();
    for row in (0..rows).filter(|row| first[*row] == NONE) {
        let size = |[a, b]: Complex| a * a + b * b;
        let joined = matrix.row(row).filter(|(column, _)| first[*column] != NONE);
        let strongest = joined.max_by(|a, b| size(a.1).total_cmp(&size(b.1)).then(b.0.cmp(&a.0)));
        match strongest {
            Some((column, coupling)) => {
                groups.group[row] = first[column];
                groups.carried[row] = times(unit(coupling), groups.carried[column]);
            }
            None => {
                groups.group[row] = groups.count as u32;
                groups.count += 1;
            }
        }
    }
    groups
}

impl Groups {
    /// The equations between the directions of the groups.
    fn coarse(&self, matrix: &Hermitian) -> Hermitian {
        let mut coarse = Hermitian {
            starts: vec![0],
            diagonal: vec![0.0; self.count],
            right: vec![[0.0; 2]; self.count],
            ..Hermitian::default()
        };
        let mut rows: Vec<BTreeMap<u32, Complex>> = vec![BTreeMap::new(); self.count];
        for (row, group) in self.group.iter().enumerate() {
            let own = *group as usize;
            let back = conjugate(self.carried[row]);
            coarse.diagonal[own] += matrix.diagonal[row];
            coarse.right[own] = plus(coarse.right[own], times(back, matrix.right[row]));
            for (column, coupling) in matrix.row(row) {
                let seen = times(times(back, coupling), self.carried[column]);
                if self.group[column] == *group {
                    coarse.diagonal[own] -= seen[0];
                } else {
                    let sum = rows[own].entry(self.group[column]).or_insert([0.0; 2]);
                    *sum = plus(*sum, seen);
                }
            }
        }
        for row in rows {
            coarse.columns.extend(row.keys());
            coarse.couplings.extend(row.values());
            coarse.starts.push(coarse.columns.len() as u32);
        }
        coarse
    }

    /// The values of all rows, from those of their groups.
    fn spread(&self, values: &[Complex]) -> Vec<Complex> {
        self.group
            .iter()
            .zip(&self.carried)
            .map(|(group, carried)| times(*carried, values[*group as usize]))
            .collect()
    }
}
