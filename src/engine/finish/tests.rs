//! Every finish: seamless, the same with any number of threads, equal to the plain computation, and true to the marks.

use super::*;
use crate::grid::Edges;

const SIDE: usize = 96;

/// A test picture: marks on a tile of [`SIDE`] px, `scale` px a px.
struct Picture {
    size: [usize; 2],
    rgb: Vec<u8>,
    labels: Vec<u8>,
}

/// Nine discs of radius 7 to 10, of which one lies over the border.
fn picture(scale: usize) -> Picture {
    let size = [SIDE * scale; 2];
    let ink = |px: usize| {
        let point = [px % size[0], px / size[0]].map(|at| (at as f32 + 0.5) / scale as f32);
        (0..9).any(|disc| {
            let centre =
                [(disc % 3) as f32 * 32.0 + 3.0, (disc / 3) as f32 * 32.0 + 12.0 + 2.0 * (disc % 2) as f32];
            let apart = [0, 1].map(|axis| {
                let apart = (point[axis] - centre[axis]).abs();
                apart.min(SIDE as f32 - apart)
            });
            let radius = 7.0 + (disc % 4) as f32;
            apart[0] * apart[0] + apart[1] * apart[1] < radius * radius
        })
    };
    let labels: Vec<u8> = (0..size[0] * size[1]).map(|px| u8::from(ink(px))).collect();
    let colour = |label: &u8| if *label > 0 { [40, 26, 18] } else { [226, 190, 130] };
    Picture { size, rgb: labels.iter().flat_map(colour).collect(), labels }
}

/// What `with` makes of the picture with `scale` px a px and a finish.
fn of<T>(finish: Finish, scale: usize, with: impl FnOnce(&Source) -> T) -> T {
    let (one, picture) = (picture(1), picture(scale));
    let reach = finish.reach(&one.labels, one.size, Edges::Wrap);
    let flow = Flow::uniform(190.0);
    with(&Source {
        size: picture.size,
        canvas: [SIDE as f32; 2],
        edges: Edges::Wrap,
        rgb: &picture.rgb,
        labels: &picture.labels,
        flow: &flow,
        reach: &reach,
        seed: 5,
    })
}

fn every() -> impl Iterator<Item = Finish> {
    Kind::NAMES.into_iter().map(|(_, kind)| Finish::new(kind))
}

fn gray(surfel: &Surfel) -> f32 {
    surfel.lit().iter().sum::<f32>() / 3.0
}

/// Number of pieces of ink on a tile, and px of ink.
fn counted(mask: &[u8], [width, height]: [usize; 2]) -> [usize; 2] {
    let (mut seen, mut pieces) = (vec![false; mask.len()], 0);
    for start in (0..mask.len()).filter(|px| mask[*px] > 0) {
        if std::mem::replace(&mut seen[start], true) {
            continue;
        }
        pieces += 1;
        let mut left = vec![start];
        while let Some(px) = left.pop() {
            let (x, y) = (px % width, px / width);
            for [x, y] in [[x + 1, y], [x + width - 1, y], [x, y + 1], [x, y + height - 1]] {
                let near = y % height * width + x % width;
                if mask[near] > 0 && !std::mem::replace(&mut seen[near], true) {
                    left.push(near);
                }
            }
        }
    }
    [pieces, mask.iter().filter(|label| **label > 0).count()]
}

#[test]
fn every_finish_keeps_the_number_of_marks_and_their_area() {
    for finish in every() {
        for scale in [1, 3] {
            let picture = picture(scale);
            let mask = of(finish, scale, |source| finish.paint(source).mask);
            let [[pieces, ink], [drawn, wanted]] =
                [&mask, &picture.labels].map(|mask| counted(mask, picture.size));
            assert_eq!(pieces, drawn, "{finish:?} at {scale}");
            let change = ink as f64 / wanted as f64 - 1.0;
            assert!(change.abs() <= 0.01, "{finish:?} at {scale}: {change}");
        }
    }
}

#[test]
fn the_colours_of_the_picture_agree_with_its_mask() {
    for finish in every().filter(|finish| finish.kind != Kind::Print) {
        of(finish, 1, |source| {
            let finished = finish.paint(source);
            let mean = |marks: bool| {
                let px =
                    finished.surfels.iter().zip(&finished.mask).filter(|(_, label)| (**label > 0) == marks);
                let red: Vec<f32> = px.map(|(surfel, _)| surfel.colour[0]).collect();
                red.iter().sum::<f32>() / red.len() as f32
            };
            assert!(mean(true) < 0.3 && mean(false) > 0.75, "{finish:?}: {} {}", mean(true), mean(false));
        });
    }
}

/// The mean and the standard deviation of the tone that a finish makes of a gray picture without marks.
fn tone(finish: Finish) -> [f32; 2] {
    let size = [SIDE; 2];
    let (rgb, labels) = (vec![128; 3 * SIDE * SIDE], vec![0; SIDE * SIDE]);
    let reach = finish.reach(&labels, size, Edges::Wrap);
    let surfels = finish
        .paint(&Source {
            size,
            canvas: [SIDE as f32; 2],
            edges: Edges::Wrap,
            rgb: &rgb,
            labels: &labels,
            flow: &Flow::uniform(190.0),
            reach: &reach,
            seed: 5,
        })
        .surfels;
    let count = surfels.len() as f32;
    let mean = surfels.iter().map(gray).sum::<f32>() / count;
    let square = surfels.iter().map(|surfel| (gray(surfel) - mean).powi(2)).sum::<f32>() / count;
    [mean, square.sqrt()]
}

#[test]
fn a_gray_picture_keeps_its_mean_tone() {
    for finish in every().filter(|finish| !matches!(finish.kind, Kind::Ink | Kind::Print)) {
        let [mean, _] = tone(finish);
        assert!((mean / 0.502 - 1.0).abs() < 0.05, "{finish:?}: {mean}");
    }
}

#[test]
fn mottling_varies_the_tone_as_much_as_asked_and_leaves_the_marks() {
    // So fine that even its largest octave fits into the picture many times.
    let finish = Finish { size: 3.0, ..Finish::new(Kind::Ink) };
    let ([mean, deviation], mottled) = (tone(finish), Finish { mottle: 0.1, ..finish });
    let [mottled_mean, varied] = tone(mottled);
    assert!((mottled_mean / mean - 1.0).abs() < 0.05, "{mean} {mottled_mean}");
    let added = (varied * varied - deviation * deviation).sqrt() / mean;
    assert!((0.06..0.14).contains(&added), "{added}");
    let [before, after] = [finish, mottled].map(|finish| of(finish, 1, |source| finish.paint(source).mask));
    assert!(before == after);
}

#[test]
fn every_finish_is_seamless_on_a_tile() {
    for finish in every() {
        of(finish, 1, |source| {
            let surfels = finish.paint(source).surfels;
            // The mean step from each column, and from each row, to the next.
            let step = |at: usize, axis: usize| {
                let px =
                    |along: usize, at: usize| if axis == 0 { along * SIDE + at } else { at * SIDE + along };
                let steps = (0..SIDE).map(|along| {
                    (gray(&surfels[px(along, at)]) - gray(&surfels[px(along, (at + 1) % SIDE)])).abs()
                });
                steps.sum::<f32>() / SIDE as f32
            };
            for axis in [0, 1] {
                let inside = (0..SIDE - 1).map(|at| step(at, axis)).fold(0.0, f32::max);
                let seam = step(SIDE - 1, axis);
                assert!(seam <= 1.15 * inside, "{finish:?}: {seam} at the border, {inside} inside");
            }
        });
    }
}

#[test]
fn the_number_of_threads_does_not_change_a_byte() {
    let threads = |count| rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap();
    for finish in every() {
        let [one, three] =
            [1, 3].map(|count| threads(count).install(|| of(finish, 1, |source| finish.paint(source))));
        assert!(one.surfels == three.surfels && one.mask == three.mask, "{finish:?}");
    }
}

#[test]
fn hairs_painted_one_after_the_other_equal_those_found_px_by_px() {
    const CANVAS: [usize; 2] = [28, 18];
    let finish = Finish { size: 6.0, ..Finish::new(Kind::Fur) };
    let labels = |scale: usize| -> Vec<u8> {
        let width = CANVAS[0] * scale;
        (0..width * CANVAS[1] * scale).map(|px| u8::from(px % width / scale % 14 < 6)).collect()
    };
    let one = labels(1);
    for (edges, scale) in [(Edges::Wrap, 1), (Edges::Wrap, 2), (Edges::Closed, 1)] {
        let labels = labels(scale);
        let rgb: Vec<u8> = labels.iter().flat_map(|label| [200 - 150 * label; 3]).collect();
        let reach = finish.reach(&one, CANVAS, edges);
        let flow = Flow::uniform(200.0);
        let source = Source {
            size: CANVAS.map(|side| side * scale),
            canvas: CANVAS.map(|side| side as f32),
            edges,
            rgb: &rgb,
            labels: &labels,
            flow: &flow,
            reach: &reach,
            seed: 5,
        };
        let (fast, plain) = (fur::paint(&source, 6.0), fur::paint_plainly(&source, 6.0));
        let different = fast.iter().zip(&plain).filter(|(fast, plain)| fast != plain).count();
        assert_eq!(different, 0, "of {} px, {edges:?} at {scale}", plain.len());
    }
}

#[test]
fn hair_at_a_closed_border_has_no_colour_of_the_other_side() {
    let (size, finish) = ([60, 24], Finish { size: 12.0, ..Finish::new(Kind::Fur) });
    let labels: Vec<u8> = (0..60 * 24).map(|px| u8::from(px % 60 >= 30)).collect();
    let rgb: Vec<u8> = labels.iter().flat_map(|label| [255 * label; 3]).collect();
    let (reach, flow) = (finish.reach(&labels, size, Edges::Closed), Flow::uniform(0.0));
    let (canvas, edges) = ([60.0, 24.0], Edges::Closed);
    let source =
        Source { size, canvas, edges, rgb: &rgb, labels: &labels, flow: &flow, reach: &reach, seed: 1 };
    let surfels = finish.paint(&source).surfels;
    let at_the_left = (0..24 * 12).map(|px| surfels[px / 12 * 60 + px % 12].ink).fold(0.0, f32::max);
    assert!(at_the_left < 0.01, "{at_the_left}");
}

#[test]
fn rows_computed_side_by_side_equal_px_computed_one_after_the_other() {
    for finish in every().filter(|finish| finish.kind != Kind::Fur) {
        of(finish, 1, |source| {
            let plain = finish.shaded_plainly(source);
            let fast = finish.surfels(source);
            let unlit = |surfel: &Surfel| Surfel { light: 1.0, ..*surfel };
            assert!(fast.iter().zip(&plain).all(|(fast, plain)| unlit(fast) == *plain), "{finish:?}");
        });
    }
}

#[test]
fn more_px_show_new_details_of_what_fewer_show() {
    for finish in every() {
        let [small, large] = [1, 4].map(|scale| of(finish, scale, |source| finish.paint(source).surfels));
        let (mut off, mut new) = (0.0, 0.0);
        for y in 0..SIDE {
            for x in 0..SIDE {
                let block: Vec<f32> =
                    (0..16).map(|k| gray(&large[(4 * y + k / 4) * 4 * SIDE + 4 * x + k % 4])).collect();
                let mean = block.iter().sum::<f32>() / 16.0;
                off += (mean - gray(&small[y * SIDE + x])).powi(2);
                new += block.iter().map(|value| (value - mean).powi(2)).sum::<f32>() / 16.0;
            }
        }
        let [off, new] = [off, new].map(|sum| (sum / (SIDE * SIDE) as f32).sqrt());
        assert!(off < 0.12 * finish.kind.exposure(), "{finish:?}: reduced, it is off by {off}");
        assert!(new > 0.01, "{finish:?}: details finer than a px: {new}");
    }
}

#[test]
fn another_seed_gives_another_material_and_the_same_marks() {
    for finish in every() {
        of(finish, 1, |source| {
            let other = Source { seed: 6, ..*source };
            let [first, second] = [source, &other].map(|source| finish.paint(source));
            assert!(first.surfels != second.surfels, "{finish:?}");
            let moved = first.mask.iter().zip(&second.mask).filter(|(a, b)| a != b).count();
            assert!(moved < SIDE * SIDE / 12, "{finish:?}: {moved} px");
        });
    }
}

#[test]
fn a_canvas_without_marks_and_a_canvas_of_one_px_are_finished() {
    for finish in every() {
        for size in [[1, 1], [7, 3], [40, 2]] {
            let count = size[0] * size[1];
            let (rgb, labels) = (vec![128; 3 * count], vec![0; count]);
            for edges in [Edges::Closed, Edges::Wrap] {
                let reach = finish.reach(&labels, size, edges);
                let canvas = size.map(|side| side as f32);
                let flow = Flow::uniform(0.0);
                let source = Source {
                    size,
                    canvas,
                    edges,
                    rgb: &rgb,
                    labels: &labels,
                    flow: &flow,
                    reach: &reach,
                    seed: 1,
                };
                let finished = finish.paint(&source);
                assert_eq!(finished.mask, labels, "{finish:?}");
                assert!(finished.surfels.iter().all(|surfel| surfel.light.is_finite()), "{finish:?}");
            }
        }
    }
}
