//! Levels along curves: the concentration as a share of the peak that lines have nearby.

use super::Curves;
use crate::surface::Surface;
use crate::synth::marks::plan::offset_curves::level_curves::LEAST;

impl Curves {
    /// The concentration `marks` as a share of the peak that lines have nearby: they stand lower where three meet, where others are close, or
    /// marks. `width` is that of the thinnest lines, px.
    #[must_use]
    pub fn levelled(&self, surface: &Surface, marks: &[f32], width: f64) -> Vec<f32> {
        // A quarter of the width, in edges: where lines meet, the saddle between them is what counts, not their own height.
        let rounds = ((0.25 * width / surface.unit()).round() as usize).max(1);
        let mut highest = marks.to_vec();
        for _ in 0..rounds {
            let around = |vertex: usize| {
                surface.ring(vertex).map(|other| highest[other]).fold(highest[vertex], f32::max)
            };
            highest = (0..highest.len()).map(around).collect();
        }
        let on = |value: &dyn Fn(usize) -> f32| -> Vec<f32> {
            (0..marks.len()).map(|vertex| if self.curve[vertex] { value(vertex) } else { 0.0 }).collect()
        };
        let [mut peaks, mut there] = [on(&|vertex| highest[vertex].max(LEAST)), on(&|_| 1.0)];
        // A box of so many edges has about the variance of twice as many rounds.
        for _ in 0..2 * rounds * rounds {
            [peaks, there] = [&peaks, &there].map(|values| averaged(surface, values));
        }
        let share = |vertex: usize| {
            if there[vertex] > 1e-6 { marks[vertex] * there[vertex] / peaks[vertex] } else { marks[vertex] }
        };
        (0..marks.len()).map(share).collect()
    }
}

/// The mean of each vertex and those beside it.
fn averaged(surface: &Surface, values: &[f32]) -> Vec<f32> {
    let mean = |vertex: usize| {
        let (sum, count) = surface
            .ring(vertex)
            .fold((0.0, 0.0), |(sum, count), other| (sum + values[other], count + 1.0_f32));
        0.5 * (values[vertex] + sum / count.max(1.0))
    };
    (0..values.len()).map(mean).collect()
}
