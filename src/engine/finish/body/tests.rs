//! Every finish on surfaces: equal to the plain computation, the same with any number of threads, as dense as on a canvas, true to the
//! marks.

use rayon::prelude::*;

use super::*;
use crate::finish::flow::Flow;
use crate::finish::noise::Random;
use crate::finish::{Reach, Source};
use crate::grid::Edges;
use crate::surface::test_meshes::{even_plate, sphere};
use crate::surface::{Mesh, Surface};

const RADIUS: f64 = 40.0;

fn ball() -> Surface {
    Surface::new(sphere(24, RADIUS), [1.0, 0.0, 0.0])
}

/// Twelve round marks on a ball, of radius 7 px.
fn is_mark(at: Vector) -> bool {
    let gold = 0.5 * (1.0 + 5.0_f64.sqrt());
    let long = (1.0 + gold * gold).sqrt();
    let centre = |axis: usize, sign: f64, other: f64| {
        let mut centre = [0.0; 3];
        centre[axis] = sign / long;
        centre[(axis + 1) % 3] = other * gold / long;
        centre
    };
    let centres = (0..12).map(|k| centre(k % 3, [1.0, -1.0][k / 3 % 2], [1.0, -1.0][k / 6]));
    centres.into_iter().any(|centre| dot(centre, at) > RADIUS * libm::cos(7.0 / RADIUS))
}

/// A surface with dark marks where `marks` says so, and hair along +x.
fn source(surface: &Surface, marks: fn(Vector) -> bool) -> SurfaceSource<'_> {
    let paint = move |point: SurfacePoint| match marks(surface.position(point)) {
        true => [0.15, 0.1, 0.08, 1.0],
        false => [0.9, 0.75, 0.5, 0.0],
    };
    let labels = surface.mesh.positions.iter().map(|at| u8::from(marks(*at))).collect();
    let flow = (0..surface.mesh.positions.len()).map(|vertex| surface.frame(vertex)[0]).collect();
    SurfaceSource { surface, paint: Box::new(paint), labels, flow, seed: 5 }
}

fn finished(finish: Finish, source: SurfaceSource) -> SurfaceFinish {
    SurfaceFinish::new(finish, source, &|| false).expect("it is for surfaces")
}

fn every() -> impl Iterator<Item = Finish> {
    Kind::NAMES.into_iter().filter(|(_, kind)| kind.on_models().is_ok()).map(|(_, kind)| Finish::new(kind))
}

/// Places all over a surface, at random.
fn places(surface: &Surface, count: u32) -> Vec<SurfacePoint> {
    let place = |index: u32| {
        let mut random = Random::of(77, [index, 0]);
        let face = (random.number() * surface.mesh.faces.len() as f32) as u32;
        let [a, b] = [random.number(), random.number()].map(f64::from);
        SurfacePoint { face, weights: if a + b > 1.0 { [1.0 - a, 1.0 - b] } else { [a, b] } }
    };
    (0..count).map(place).collect()
}

#[test]
fn fur_is_what_all_hairs_of_the_surface_make_of_a_place() {
    let surface = ball();
    let finish = finished(Finish::new(Kind::Fur), source(&surface, is_mark));
    let Parts::Fur(hairs) = &finish.parts else { panic!("fur") };
    for point in places(&surface, 150) {
        let place = finish.source.place(point);
        for (scale, beside) in
            [(1.0, [[0.4, -0.3, 0.2], [0.0; 3]]), (4.0, [[0.0, 0.1, -0.1], [0.1, 0.0, 0.0]])]
        {
            let own = [0.9, 0.75, 0.5, 0.0];
            let plain = hairs.look_plainly(&place, beside, scale, own);
            assert_eq!(hairs.look(&place, beside, scale, own), plain, "{place:?} {scale}");
        }
    }
}

#[test]
fn seeds_are_the_nearest_of_all() {
    let surface = ball();
    for kind in [Kind::Skin, Kind::Leather] {
        let finish = finished(Finish::new(kind), source(&surface, is_mark));
        let Parts::Hide(grains) = &finish.parts else { panic!("grains") };
        for point in places(&surface, 200) {
            grains.check_plainly(&finish.source.place(point));
        }
    }
}

#[test]
fn a_place_looks_the_same_from_both_triangles_at_its_edge() {
    let surface = ball();
    // The middle of a side of a triangle, which another triangle has as well.
    let middle = |face: usize, ends: [u32; 2]| {
        let share = |corner: usize| if ends.contains(&surface.mesh.faces[face][corner]) { 0.5 } else { 0.0 };
        SurfacePoint { face: face as u32, weights: [share(0), share(1)] }
    };
    for finish in every() {
        let finished = finished(finish, source(&surface, |_| false));
        let mut apart = 0.0;
        for face in (0..surface.mesh.faces.len()).step_by(97) {
            let [a, b, _] = surface.mesh.faces[face];
            let has_side = |other: &usize| {
                let corners = surface.mesh.faces[*other];
                *other != face && corners.contains(&a) && corners.contains(&b)
            };
            let other = (0..surface.mesh.faces.len()).find(has_side).expect("a neighbour");
            let [one, two] = [face, other].map(|face| finished.at(middle(face, [a, b]), 4.0).surfel);
            apart += (one.tint - two.tint).abs() + (one.height - two.height).abs();
        }
        assert!(apart < 0.05, "{finish:?}: {apart}");
    }
}

#[test]
fn every_finish_is_the_same_with_any_number_of_threads() {
    let surface = ball();
    let points = places(&surface, 60);
    for finish in every() {
        let looks = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| {
                let finished = finished(finish, source(&surface, is_mark));
                points.iter().map(|point| finished.at(*point, 3.0)).collect::<Vec<_>>()
            })
        };
        assert_eq!(looks(1), looks(4), "{finish:?}");
    }
}

#[test]
fn every_finish_looks_on_a_plate_as_it_does_on_a_canvas() {
    let side = 96.0;
    let surface = Surface::new(even_plate([side, side], 2.5), [1.0, 0.0, 0.0]);
    let size = [side as usize; 2];
    let labels = vec![0; size[0] * size[1]];
    let rgb: Vec<u8> = labels.iter().flat_map(|_| [230, 191, 128]).collect();
    let reach = Reach::of(&labels, size, Edges::Wrap, 30.0);
    for finish in every() {
        let flat = Source {
            size,
            canvas: size.map(|side| side as f32),
            edges: Edges::Wrap,
            rgb: &rgb,
            labels: &labels,
            flow: &Flow::uniform(0.0),
            reach: &reach,
            seed: 5,
        };
        let flat = finish.paint(&flat).surfels;
        let on_plate = finished(finish, source(&surface, |_| false));
        let inside = |point: &SurfacePoint| {
            surface.position(*point)[..2].iter().all(|part| (16.0..side - 16.0).contains(part))
        };
        let places = places(&surface, 9_000).into_iter().filter(inside);
        let found: Vec<Surfel> = places.map(|point| on_plate.at(point, 1.0).surfel).collect();
        let mean = |surfels: &[Surfel], of: fn(&Surfel) -> f32| {
            surfels.iter().map(of).sum::<f32>() / surfels.len() as f32
        };
        for (name, of, allowed) in [
            ("brightness", (|surfel: &Surfel| surfel.albedo()[1]) as fn(&Surfel) -> f32, 0.05),
            ("roughness", |surfel: &Surfel| surfel.roughness, 0.04),
            ("height", |surfel: &Surfel| surfel.height, 0.5),
        ] {
            let [flat, found] = [mean(&flat, of), mean(&found, of)];
            println!("{finish:?}: {name} {flat:.3} on a canvas, {found:.3} on a plate");
            assert!((flat - found).abs() < allowed, "{finish:?}: {name} {flat} {found}");
        }
    }
}

#[test]
fn every_finish_keeps_the_ink_of_the_marks() {
    let surface = ball();
    let places = scattered::scattered(&surface, 0.15, 9);
    for finish in every() {
        let finished = finished(finish, source(&surface, is_mark));
        let ink = |point: &SurfacePoint| {
            [f32::from(u8::from(is_mark(surface.position(*point)))), finished.at(*point, 2.0).surfel.ink]
        };
        let inks: Vec<[f32; 2]> = places.par_iter().map(ink).collect();
        let sum = |of: fn(&[f32; 2]) -> f32| inks.iter().map(|ink| f64::from(of(ink))).sum::<f64>();
        let [before, after] = [sum(|ink| ink[0]), sum(|ink| ink[1])];
        let moved = sum(|ink| (ink[1] - ink[0]).abs());
        let change = after / before - 1.0;
        println!("{finish:?}: ink {:+.2} %, moved {:.1} %", 100.0 * change, 100.0 * moved / before);
        assert!(change.abs() < 0.01 && moved < 0.5 * before, "{finish:?}: {change} {moved} {before}");
    }
}

#[test]
fn heights_lie_in_their_range_and_rise_along_the_slope() {
    let surface = ball();
    for finish in every() {
        let finished = finished(finish, source(&surface, is_mark));
        let [low, high] = finished.heights();
        let (mut products, mut squares, mut beyond) = (0.0, 0.0, 0);
        let points = places(&surface, 3_000);
        for point in &points {
            let here = finished.at(*point, 4.0);
            beyond += usize::from(!(low..=high).contains(&here.surfel.height));
            let axis = surface.frame(surface.vertex_of(*point))[0];
            let step = 0.1;
            let there = finished.at(surface.walk(*point, [step, 0.0]), 4.0).surfel.height;
            let rise = f64::from(there - here.surfel.height) / step;
            let expected = dot(here.slope, axis);
            (products, squares) = (products + rise * expected, squares + expected * expected);
        }
        let agreement = products / squares;
        println!("{finish:?}: rise ÷ slope {agreement:.2}, {beyond} of {} beyond", points.len());
        assert!((0.8..1.25).contains(&agreement), "{finish:?}: {agreement}");
        assert!(beyond * 200 < points.len(), "{finish:?}: {beyond}");
    }
}

#[test]
fn hair_lies_along_the_flow() {
    let surface = ball();
    let finished = finished(Finish::new(Kind::Fur), source(&surface, |_| false));
    let [mut along, mut across] = [0.0; 2];
    for point in places(&surface, 4_000) {
        let tint = |by: [f64; 2]| finished.at(surface.walk(point, by), 4.0).surfel.tint;
        let own = tint([0.0; 2]);
        along += (tint([0.8, 0.0]) - own).abs();
        across += (tint([0.0, 0.8]) - own).abs();
    }
    assert!(across > 1.6 * along, "{along} {across}");
}

#[test]
fn finishes_that_are_lattices_are_not_for_surfaces_and_a_cancelled_one_is_none() {
    let surface = ball();
    for kind in [Kind::Cloth, Kind::Twill, Kind::Print] {
        assert!(SurfaceFinish::new(Finish::new(kind), source(&surface, is_mark), &|| false).is_none());
    }
    for finish in every() {
        assert!(SurfaceFinish::new(finish, source(&surface, is_mark), &|| true).is_none());
    }
}

#[test]
fn a_hair_does_not_show_on_the_other_side_of_a_thin_sheet() {
    // Two plates a px apart, which face away from each other; only hairs of the upper one have dark roots.
    let upper = even_plate([40.0, 40.0], 2.0);
    let count = upper.positions.len() as u32;
    let lower = upper.positions.iter().map(|[x, y, _]| [*x, *y, -1.0]);
    let positions = upper.positions.iter().copied().chain(lower).collect();
    let turned = upper.faces.iter().map(|[a, b, c]| [*a + count, *c + count, *b + count]);
    let mesh = Mesh { positions, faces: upper.faces.iter().copied().chain(turned).collect() };
    let surface = Surface::new(mesh, [1.0, 0.0, 0.0]);
    let finished = finished(Finish::new(Kind::Fur), source(&surface, |at| at[2] > -0.5));
    for point in places(&surface, 400) {
        let is_upper = surface.position(point)[2] > -0.5;
        assert_eq!(finished.at(point, 2.0).surfel.ink > 0.5, is_upper);
    }
}
