//! Growths on models as people have them: each grows, or is refused in words.

use std::f64::consts::TAU;
use std::fmt::Write;

use rayon::prelude::*;

use super::{BodyGrowth, GrownBody};
use crate::document::{Body, BodySource, Document, Layer, Stroke};
use crate::surface::Mesh;
use crate::surface::test_meshes::{
    both, cube, cylinder, moebius, plate, ringed_sphere, scaled, shifted, slab, soup, sphere, torus,
};
use crate::synth::Options;

/// Round spots 24 px apart on a model in a file, of 30 px.
fn document() -> Document {
    let at = |i: i32| [40.0 + 24.0 * f64::from(i % 4), 40.0 + 20.8 * f64::from(i / 4)];
    let layer = Layer::new((0..12).map(|i| Stroke::ellipse(at(i), [4.0, 4.0], 0.0)));
    let source = BodySource::File { path: "bad".to_owned(), sha256: None };
    Document {
        model: Some(Body { px: 30.0, ..Body::new(source) }),
        ..Document::new([200, 160]).with_layer(layer)
    }
}

fn grown(bytes: &[u8]) -> Result<GrownBody, String> {
    let document = document();
    let options = Options { source: "a.dapple", memory: Some(1e9), ..Options::default() };
    let growth = BodyGrowth::begin(&document, Some(bytes), &options).map_err(|error| error.to_string())?;
    growth.run().map_err(|error| error.to_string())
}

fn obj(mesh: &Mesh) -> String {
    let mut text = String::new();
    for [x, y, z] in &mesh.positions {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "v {x} {y} {z}");
    }
    for [a, b, c] in mesh.faces.iter().map(|face| face.map(|vertex| vertex + 1)) {
        let _ = writeln!(text, "f {a} {b} {c}");
    }
    text
}

/// A mesh with some faces turned over.
fn turned(mesh: &Mesh, is_turned: impl Fn(usize) -> bool) -> Mesh {
    let faces = mesh.faces.iter().enumerate();
    let turned = faces.map(|(face, [a, b, c])| if is_turned(face) { [*a, *c, *b] } else { [*a, *b, *c] });
    Mesh { positions: mesh.positions.clone(), faces: turned.collect() }
}

/// A mesh with more vertices and faces.
fn with(mesh: &Mesh, positions: &[[f64; 3]], faces: &[[u32; 3]]) -> Mesh {
    let mut made = mesh.clone();
    made.positions.extend(positions);
    made.faces.extend(faces);
    made
}

/// A box whose two faces of each side are cut into a fan about a point near one of its corners.
fn slivers(near: f64) -> Mesh {
    let body = cube(1, 1.0);
    let mut made = Mesh { positions: body.positions.clone(), faces: Vec::new() };
    for face in &body.faces {
        let [a, b, c] = face.map(|vertex| body.positions[vertex as usize]);
        let middle = made.positions.len() as u32;
        made.positions.push(std::array::from_fn(|i| (1.0 - 2.0 * near) * a[i] + near * (b[i] + c[i])));
        made.faces.extend([
            [face[0], face[1], middle],
            [face[1], face[2], middle],
            [face[2], face[0], middle],
        ]);
    }
    made
}

/// A cone so pointed that its point is thinner than a spot.
fn needle() -> Mesh {
    let rim =
        (0..24).map(|k| TAU * f64::from(k) / 24.0).map(|turn| [0.1 * turn.cos(), 0.1 * turn.sin(), 0.0]);
    let mut made = Mesh { positions: vec![[0.0, 0.0, 1.0], [0.0; 3]], faces: Vec::new() };
    made.positions.extend(rim);
    for k in 0..24 {
        let (a, b) = (2 + k, 2 + (k + 1) % 24);
        made.faces.extend([[0, a, b], [1, b, a]]);
    }
    made
}

fn stl(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = vec![b' '; 80];
    bytes.extend((mesh.faces.len() as u32).to_le_bytes());
    for face in 0..mesh.faces.len() {
        bytes.extend([0; 12]);
        bytes.extend(mesh.corners(face).iter().flatten().flat_map(|value| (*value as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

/// A model, and what the notes on it must hold.
type Case = (&'static str, Vec<u8>, &'static str);

fn mesh(name: &'static str, mesh: &Mesh, note: &'static str) -> Case {
    (name, obj(mesh).into_bytes(), note)
}

fn text(name: &'static str, text: &str, note: &'static str) -> Case {
    (name, text.as_bytes().to_vec(), note)
}

fn texts() -> Vec<Case> {
    let corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
    let quads = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
    let l_prism = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n\
        f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\nf 5 6 12 11\nf 6 1 7 12\n";
    vec![
        text("quads", &format!("{corners}{quads}"), ""),
        text("negative indices", &format!("{corners}f -5 -6 -7 -8\nf -4 -3 -2 -1\nf -8 -7 -3 -4\n"), ""),
        text(
            "normals only",
            &format!("{corners}vn 0 0 1\nf 4//1 3//1 2//1 1//1\nf 5//1 6//1 7//1 8//1\n"),
            "",
        ),
        text("a polygon that is not convex", l_prism, ""),
        text("a polygon that is not plane", "v 0 0 0\nv 1 0 0.3\nv 1 1 0\nv 0 1 0.3\nf 1 2 3 4\n", ""),
        text("a polygon with a corner twice", &format!("{corners}{quads}f 1 2 2 3\n"), "without an area"),
        text("a line among faces", &format!("{corners}{quads}f 1 2\n"), "fewer than 3 corners"),
        text("groups", &format!("{corners}g a\nf 4 3 2 1\ng b\nf 5 6 7 8\nusemtl c\nf 1 2 6 5\n"), ""),
    ]
}

/// Bodies that touch, or are not whole.
fn put_together() -> Vec<Case> {
    let body = cube(2, 1.0);
    let last = body.positions.len() as u32;
    let open = Mesh { faces: body.faces[4..].to_vec(), ..body.clone() };
    let fin = with(&body, &[[0.5, 0.5, 2.0]], &[[body.faces[0][0], body.faces[0][1], last]]);
    let hollow = both(&body, &turned(&shifted(&scaled(&body, 0.5), [0.25; 3]), |_| true));
    let crack = turned(&plate([1, 1], 1.0), |_| true);
    let beside = |by| both(&body, &shifted(&body, by));
    vec![
        mesh("a body", &body, ""),
        mesh("triangles with vertices of their own", &soup(&body), ""),
        mesh("a hole", &open, ""),
        mesh("two parts", &beside([1.5, 0.0, 0.0]), ""),
        mesh("parts that touch in a point", &beside([1.0, 1.0, 1.0]), "in a point only"),
        mesh("parts that touch in an edge", &beside([1.0, 1.0, 0.0]), "more than two faces"),
        mesh("parts that touch in a side", &beside([1.0, 0.0, 0.0]), ""),
        mesh("parts within each other", &beside([0.4, 0.3, 0.2]), ""),
        mesh("a hollow", &hollow, ""),
        mesh("a fin", &fin, "more than two faces"),
        mesh(
            "a part smaller than a spacing",
            &both(&body, &shifted(&scaled(&body, 0.05), [1.5, 0.0, 0.0])),
            "",
        ),
        mesh("cracks", &both(&body, &shifted(&crack, [0.0, 0.0, 1.0 + 1e-7])), ""),
        mesh("inside out", &turned(&body, |_| true), "inwards"),
        mesh("turned at random", &turned(&body, |face| face % 3 == 0), "inwards"),
        mesh("each face twice", &with(&body, &[], &body.faces), "there twice"),
        mesh("each face twice, turned", &with(&body, &[], &turned(&body, |_| true).faces), "there twice"),
        ("as STL", stl(&body), ""),
    ]
}

/// Numbers that are none, too small or too large.
fn numbers() -> Vec<Case> {
    let body = cube(2, 1.0);
    let last = body.positions.len() as u32;
    let line = [[0.2, 0.5, 1.2], [0.4, 0.5, 1.2], [0.8, 0.5, 1.2]];
    vec![
        mesh("faces of one corner", &with(&body, &[], &[[0, 0, 0], [1, 1, 2]]), "without an area"),
        mesh("a face in a line", &with(&body, &line, &[[last, last + 1, last + 2]]), "without an area"),
        mesh("slivers", &slivers(1e-3), ""),
        mesh("slivers without an area", &slivers(1e-9), ""),
        mesh("no number that no face has", &with(&body, &[[f64::NAN, 0.0, 0.0]], &[]), ""),
        mesh("no number in a face", &with(&body, &[[f64::NAN, 0.0, 0.0]], &[[0, 1, last]]), "not finite"),
        mesh("infinity in a face", &with(&body, &[[0.0, f64::INFINITY, 0.0]], &[[0, 1, last]]), "not finite"),
        mesh("a vertex of no face, far away", &with(&body, &[[1e9, 0.0, 0.0]], &[]), ""),
        ("as STL with no number", stl(&with(&body, &[[f64::NAN; 3]], &[[0, 1, last]])), "not finite"),
        mesh("of a size of 1e-7", &scaled(&body, 1e-7), ""),
        mesh("of a size of 1e6", &scaled(&body, 1e6), ""),
        mesh("at 1e7", &shifted(&body, [1e7, 1e7, -1e7]), ""),
    ]
}

/// Shapes that are thin, open, one-sided or coarse.
fn shapes() -> Vec<Case> {
    vec![
        mesh("a thin sheet of two sides", &slab([1.0, 1.0, 1e-3], 0.3), ""),
        mesh("a thinner sheet of two sides", &slab([1.0, 1.0, 1e-6], 0.3), ""),
        mesh("a Moebius strip", &moebius([40, 6], 1.0, 0.6), "cut open"),
        mesh("a plate", &plate([3, 3], 1.0), ""),
        mesh("a tube", &cylinder([12, 6], 0.5, 1.0), ""),
        mesh("a ring", &torus([16, 8], [1.0, 0.4]), ""),
        text("one triangle", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", ""),
        mesh("a needle", &needle(), ""),
        mesh("a rod", &slab([1.0, 0.01, 0.01], 0.2), ""),
        mesh("coarse", &sphere(1, 1.0), ""),
        mesh("finely ringed, with slivers at the poles", &ringed_sphere(60, 1.0), ""),
    ]
}

#[test]
fn models_as_people_have_them_grow_and_what_was_mended_is_said() {
    let cases = [texts(), put_together(), numbers(), shapes()].concat();
    assert!(cases.len() >= 40, "{}", cases.len());
    let wrong: Vec<String> = cases
        .par_iter()
        .filter_map(|(name, bytes, note)| match grown(bytes) {
            Err(error) => Some(format!("{name}: {error}")),
            Ok(grown) if grown.layers[0].spots() == 0 => {
                Some(format!("{name}: {} spots", grown.layers[0].spots()))
            }
            Ok(grown) => {
                let notes = grown.placed.notes();
                let is_said = notes.iter().any(|text| text.contains(note)) || note.is_empty();
                (!is_said).then(|| format!("{name}: {notes:?} instead of {note:?}"))
            }
        })
        .collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn models_on_which_nothing_can_grow_are_refused_in_words() {
    let cases: [(&str, &[u8], &str); 7] = [
        ("nothing", b"", "an empty file"),
        ("no faces", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "no faces, but 3 positions"),
        ("an index of nothing", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "line 4"),
        ("faces in a line", b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "has an area"),
        ("no numbers", b"v nan 0 0\nv nan 0 0\nv 2 0 nan\nf 1 2 3\n", "finite"),
        ("one place", b"v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", "has an area"),
        ("another format", b"PK\x03\x04", "a ZIP archive"),
    ];
    for (name, bytes, wanted) in cases {
        let Err(error) = grown(bytes) else { panic!("{name}: it grows") };
        assert!(error.starts_with("a.dapple") && error.contains(wanted), "{name}: {error}");
    }
}
