//! Outlines: the preview shows the written file, like another renderer draws it.

use super::*;

#[test]
fn outlines_drawn_by_another_renderer_look_like_the_preview() {
    let (mut hand, folder) = small();
    open(&mut hand, "Outlines");
    hand.press("hatch");
    hand.press("stroke");
    hand.type_into("Spacing of the hatch", "0.2");
    hand.type_into("Pen", "0.06");
    let made = seen(&mut hand);
    let path = folder.path().join("x.svg");
    write(&mut hand, &path);
    let output = made.message.clone().unwrap();
    assert!(output.contains("in the air"), "{output}");
    let options = usvg::Options::default();
    let tree = usvg::Tree::from_data(&fs::read(&path).unwrap(), &options).unwrap();
    let seen = &made.pictures()[0].1;
    let mut paper = resvg::tiny_skia::Pixmap::new(seen.size[0] as u32, seen.size[1] as u32).unwrap();
    paper.fill(resvg::tiny_skia::Color::WHITE);
    let scale = seen.size[0] as f32 / tree.size().width();
    resvg::render(&tree, resvg::tiny_skia::Transform::from_scale(scale, scale), &mut paper.as_mut());
    let off: u64 = seen
        .pixels
        .iter()
        .zip(paper.pixels())
        .map(|(a, b)| u64::from(a.r().abs_diff(b.red())) + u64::from(a.b().abs_diff(b.blue())))
        .sum();
    let mean = off as f64 / (2.0 * seen.pixels.len() as f64);
    assert!(mean < 2.0, "they differ by {mean} of 255 in the mean");

    let options = ["--style", "fill,stroke,hatch:0.2:45", "--pen", "0.06"];
    let other = grown(folder.path(), "cli.svg", &options);
    assert_eq!(fs::read_to_string(&path).unwrap(), fs::read_to_string(other).unwrap());

    open(&mut hand, "Outlines");
    hand.press("DXF");
    let path = folder.path().join("x.dxf");
    seen_again(&mut hand, &path);
    assert!(dxf::Drawing::load_file(&path).unwrap().entities().count() > 2);
}

fn seen_again(hand: &mut Hand, path: &Path) {
    seen(hand);
    write(hand, path);
}

#[test]
fn strokes_are_cut_only_where_nothing_is_filled() {
    let (mut hand, _folder) = small();
    open(&mut hand, "Outlines");
    hand.press("stroke");
    hand.press("fill");
    hand.press("cut");
    assert!(hand.window.state().choices().unwrap().outlines.cut);
    hand.press("fill");
    assert!(!hand.window.state().choices().unwrap().outlines.cut);
}

#[test]
fn lengths_are_converted_when_their_unit_changes() {
    let (mut hand, _folder) = small();
    open(&mut hand, "Outlines");
    hand.press("px");
    let outlines = hand.window.state().choices().unwrap().outlines;
    // 300 dpi.
    assert!((outlines.pen - 0.3 * 300.0 / 25.4).abs() < 1e-3, "{}", outlines.pen);
}
