//! A part of a growth that has been advanced by itself.

use super::Growth;
use crate::grid::Cutout;
use crate::rd::plane::Plane;

impl Growth {
    /// Number of cells.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.stepper.problem.grid.nx * self.stepper.problem.grid.ny
    }

    /// The concentrations of each chemical in the cells of `cutout`.
    #[must_use]
    pub fn concentrations_in(&self, cutout: &Cutout) -> Vec<Vec<f32>> {
        let nx = self.stepper.problem.grid.nx;
        let of = |plane: &Plane| cutout.cells().map(|cell| plane.row(cell / nx)[cell % nx]).collect();
        self.stepper.chemicals.planes()[..self.system.chemicals().len()].iter().map(of).collect()
    }

    /// [`Self::marks`] in the cells of `cutout`.
    #[must_use]
    pub fn marks_in(&self, cutout: &Cutout) -> Vec<f32> {
        let nx = self.stepper.problem.grid.nx;
        let cells: Vec<usize> = cutout.cells().collect();
        let mut row = vec![0.0; nx];
        let mut marks = Vec::with_capacity(cells.len());
        for cells in cells.chunks(cutout.grid.size[0]) {
            self.show_row(cells[0] / nx, &mut row);
            marks.extend(cells.iter().map(|cell| row[cell % nx]));
        }
        marks
    }

    /// Takes over the concentrations in the cells of `cutout` from `part`, which has grown there. The coefficients do not change,
    /// so that this growth can be read afterwards, but must not be advanced.
    pub fn take(&mut self, cutout: &Cutout, part: &Self) {
        let nx = self.stepper.problem.grid.nx;
        let cells: Vec<usize> = cutout.cells().collect();
        for (plane, values) in self.stepper.chemicals.planes_mut().iter_mut().zip(part.concentrations()) {
            let of_rows = cells.chunks(cutout.grid.size[0]).zip(values.chunks(cutout.grid.size[0]));
            for (cells, values) in of_rows {
                plane.change_row(cells[0] / nx, |row| {
                    cells.iter().zip(values).for_each(|(cell, value)| row[cell % nx] = *value);
                });
            }
        }
        if !self.peaks.is_empty() {
            cutout.replace(&mut self.peaks, &part.peaks);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::grid::{Cutout, Edges};
    use crate::rd::{Growth, ParameterField, Parameters, System};

    #[test]
    fn a_part_with_a_frozen_rim_grows_as_within_the_whole_and_is_put_back() {
        let p = Parameters { rate: 0.09, ratio: 20.0, stretch: 0.6, direction: 30.0, pitch: 1.0 };
        let maps = ParameterField::uniform([70, 60], Edges::Wrap, p);
        let mut whole = Growth::new(System::TURING_SPOTS, &maps, 4).with_stages(1);
        whole.advance(60);
        // The part crosses the border.
        let cutout = Cutout::about(&maps.domain, &[([68.0, 30.0], 14.0)]).expect("a small one")[0];
        let frozen = |cell: usize| {
            let [x, y] = cutout.grid.position(cell);
            x.min(y) < 3 || x + 3 >= cutout.grid.size[0] || y + 3 >= cutout.grid.size[1]
        };
        let in_cutout = whole.concentrations_in(&cutout);
        let mut part = Growth::resumed(System::TURING_SPOTS, &maps.cut(&cutout), in_cutout.clone())
            .expect("its chemicals")
            .with_stages(1);
        part.freeze(frozen);
        let mut expected = whole.clone();
        expected.freeze(|cell| match cutout.place([(cell % 70) as f64 + 0.5, (cell / 70) as f64 + 0.5]) {
            Some([x, y]) => frozen(cutout.grid.index([x as usize, y as usize])),
            None => true,
        });
        part.advance(40);
        expected.advance(40);
        whole.take(&cutout, &part);
        assert!(whole.concentrations() == expected.concentrations() && whole.marks() == expected.marks());
        assert!(whole.concentrations_in(&cutout) != in_cutout);
        assert!(whole.marks_in(&cutout) == cutout.of(&whole.marks().values));
    }
}
