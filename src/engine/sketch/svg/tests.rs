//! SVGs as texts.

use super::names::INKSCAPE;
use super::*;
use crate::marks::{Ellipse, Line};
use proptest::prelude::*;

fn read_marks(body: &str) -> Vec<Mark> {
    let drawing = read(svg(body).as_bytes(), Some(DPI)).unwrap();
    drawing.groups.into_iter().flat_map(|group| group.marks).collect()
}

fn svg(body: &str) -> String {
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="{INKSCAPE}" width="400" height="300">{body}</svg>"#
    )
}

#[track_caller]
fn is_ellipse(mark: &Mark, center: [f64; 2], [major, minor]: [f64; 2], angle: f64) {
    let Mark::Ellipse(found) = mark else { panic!("{mark:?}") };
    let near = |a: f64, b: f64| (a - b).abs() < 0.02 * major;
    let radii = [found.radii[0].max(found.radii[1]), found.radii[0].min(found.radii[1])];
    assert!(near(found.center[0], center[0]) && near(found.center[1], center[1]), "{found:?}");
    assert!(near(radii[0], major) && near(radii[1], minor), "{found:?}");
    let round = minor / major > 0.9;
    assert!(round || crate::marks::turn(found.major_angle(), angle).abs() < 1.0, "{found:?}");
}

#[track_caller]
fn is_line(mark: &Mark, from: [f64; 2], to: [f64; 2], width: f64) {
    let Mark::Line(Line { from: a, to: b, width: w }) = *mark else { panic!("{mark:?}") };
    // Which end comes first does not matter.
    let [a, b] = if (a[0] - from[0]).hypot(a[1] - from[1]) < 0.2 { [a, b] } else { [b, a] };
    for (found, wanted) in [(a[0], from[0]), (a[1], from[1]), (b[0], to[0]), (b[1], to[1]), (w, width)] {
        assert!((found - wanted).abs() < 0.1, "{mark:?}");
    }
}

#[test]
fn circles_ellipses_and_lines_are_read_exactly() {
    let marks = read_marks(
        r#"<circle cx="50" cy="60" r="20"/>
           <ellipse cx="200" cy="100" rx="30" ry="12" transform="rotate(30 200 100)"/>
           <line x1="10" y1="20" x2="110" y2="80" stroke="black" stroke-width="7"/>"#,
    );
    assert_eq!(marks.len(), 3);
    is_ellipse(&marks[0], [50.0, 60.0], [20.0, 20.0], 0.0);
    is_ellipse(&marks[1], [200.0, 100.0], [30.0, 12.0], 30.0);
    is_line(&marks[2], [10.0, 20.0], [110.0, 80.0], 7.0);
}

#[test]
fn paths_rectangles_and_polygons_are_fitted_as_a_pen_s_strokes_are() {
    let marks = read_marks(
        r#"<rect x="100" y="100" width="60" height="24"/>
           <path d="M20 20 Q 60 0 100 20" fill="none" stroke="black" stroke-width="3"/>
           <path d="M200 200 a 20 10 0 1 0 40 0 a 20 10 0 1 0 -40 0 z" fill="none" stroke="red"/>
           <polygon points="300,50 330,60 320,90 290,85"/>"#,
    );
    assert_eq!(marks.len(), 4);
    // Of the least squared distances to its sides.
    is_ellipse(&marks[0], [130.0, 112.0], [36.4, 13.5], 0.0);
    assert!(
        matches!(&marks[1], Mark::Path(path) if (path.width - 3.0).abs() < 1e-6 && path.points.len() < 14)
    );
    is_ellipse(&marks[2], [220.0, 200.0], [20.0, 10.0], 0.0);
    assert!(matches!(marks[3], Mark::Ellipse(Ellipse { center: [x, _], .. }) if (290.0..330.0).contains(&x)));
}

#[test]
fn a_filled_rectangle_longer_than_three_times_its_width_is_a_line() {
    let marks = read_marks(
        r#"<rect x="100" y="100" width="90" height="24"/>
           <rect x="20" y="30" width="12" height="80" rx="6"/>
           <rect x="-40" y="-5" width="80" height="10" transform="translate(300 200) rotate(30)" stroke="red" stroke-width="2"/>
           <path d="M10 250 L110 250 L110 258 L10 258 z"/>
           <rect x="100" y="150" width="70" height="24"/>
           <ellipse cx="200" cy="60" rx="60" ry="8"/>
           <rect x="100" y="200" width="90" height="24" fill="none" stroke="black"/>"#,
    );
    is_line(&marks[0], [190.0, 112.0], [100.0, 112.0], 24.0);
    is_line(&marks[1], [26.0, 110.0], [26.0, 30.0], 12.0);
    let [x, y] = [41.0 * 30f64.to_radians().cos(), 41.0 * 30f64.to_radians().sin()];
    is_line(&marks[2], [300.0 + x, 200.0 + y], [300.0 - x, 200.0 - y], 12.0);
    is_line(&marks[3], [110.0, 254.0], [10.0, 254.0], 8.0);
    assert!(marks[4..].iter().all(|mark| matches!(mark, Mark::Ellipse(_))), "{marks:?}");
    assert_eq!(marks.len(), 7);
}

#[test]
fn what_is_clipped_away_or_fully_transparent_is_not_read_and_counted() {
    let body = r##"<clipPath id="left"><rect width="100" height="300"/></clipPath>
        <clipPath id="corner"><rect width="2" height="2"/></clipPath>
        <g clip-path="url(#left)" transform="translate(50 0)">
            <circle cx="60" cy="50" r="20"/><circle cx="95" cy="120" r="20"/><circle cx="160" cy="50" r="20"/>
        </g>
        <circle cx="300" cy="50" r="20" clip-path="url(#corner)"/>
        <g opacity="0"><circle cx="300" cy="100" r="20"/></g>
        <circle cx="300" cy="150" r="20" fill-opacity="0"/>
        <circle cx="300" cy="200" r="20" fill-opacity="0" stroke="red"/>"##;
    let drawing = read(svg(body).as_bytes(), Some(DPI)).unwrap();
    let centers: Vec<f64> =
        drawing.groups.iter().flat_map(|group| &group.marks).map(|mark| mark.center()[0].round()).collect();
    assert_eq!(centers, [300.0, 110.0, 145.0]);
    assert_eq!((drawing.unread["clipped shape"], drawing.unread["transparent shape"]), (2, 2));
}

#[test]
fn groups_are_layers_by_label_or_id() {
    let body = r##"<circle cx="9" cy="9" r="5"/>
        <g id="layer1" inkscape:label="big spots"><circle cx="50" cy="50" r="20"/><g><circle cx="90" cy="50" r="20"/></g></g>
        <g id="lines" transform="translate(100 0) scale(2)"><line x2="50" y2="50" stroke="#000" stroke-width="3"/></g>
        <g id="empty"/>"##;
    let drawing = read(svg(body).as_bytes(), Some(DPI)).unwrap();
    let names: Vec<_> = drawing.groups.iter().map(|group| (group.name.as_str(), group.marks.len())).collect();
    assert_eq!(names, [("", 1), ("big spots", 2), ("lines", 1)]);
    is_line(&drawing.groups[2].marks[0], [100.0, 0.0], [200.0, 100.0], 6.0);
}

#[test]
fn the_view_box_and_the_size_make_the_canvas() {
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg" width="254mm" height="127mm" viewBox="0 0 100 50"><circle cx="50" cy="25" r="5"/></svg>"#;
    let drawing = read(text.as_bytes(), Some(300.0)).unwrap();
    assert!((drawing.size[0] - 3000.0).abs() < 0.1 && (drawing.size[1] - 1500.0).abs() < 0.1);
    is_ellipse(&drawing.groups[0].marks[0], [1500.0, 750.0], [150.0, 150.0], 0.0);
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="10 20 100 50"><circle cx="60" cy="45" r="5"/></svg>"#;
    let drawing = read(text.as_bytes(), Some(DPI)).unwrap();
    assert_eq!(drawing.size, [100.0, 50.0]);
    is_ellipse(&drawing.groups[0].marks[0], [50.0, 25.0], [5.0, 5.0], 0.0);
}

#[test]
fn what_cannot_be_read_is_counted_by_kind() {
    let body = r##"<text x="5" y="50">no</text><text>no</text><image href="x.png" width="5" height="5"/>
        <path d="M10 10 h80 v80 h-80 z M30 30 h40 v40 h-40 z" fill-rule="evenodd"/>
        <path d="M5 5 L5 5" stroke="#000"/><defs><text>unused</text></defs>"##;
    let drawing = read(svg(body).as_bytes(), Some(DPI)).unwrap();
    assert_eq!(drawing.groups[0].marks.len(), 1);
    assert_eq!((drawing.unread["text"], drawing.unread["image"], drawing.unread["hole"]), (2, 1, 1));
}

#[test]
fn a_file_that_is_not_svg_is_refused_with_a_reason() {
    for (text, reason) in [
        ("", "is no SVG"),
        ("hello", "is no SVG"),
        ("<svg", "is no SVG"),
        ("<html></html>", "cannot be read as SVG"),
        (r#"<svg xmlns="http://www.w3.org/2000/svg" width="-5" height="0"/>"#, "cannot be read as SVG"),
    ] {
        let error = read(text.as_bytes(), Some(DPI)).unwrap_err().to_string();
        assert!(error.contains(reason), "{text}: {error}");
    }
    assert!(matches!(read(b"\x89PNG\r\n\x1a\n\0\xff", Some(DPI)), Err(SvgError::NotText)));
    let deep = svg(&format!("{}{}", "<g>".repeat(100_000), "</g>".repeat(100_000)));
    assert!(matches!(read(deep.as_bytes(), Some(DPI)), Err(SvgError::TooDeep { .. })));
}

/// Found by fuzzing: XML's reader quotes what it finds, whatever that does to a terminal, and however long it is.
#[test]
fn quoted_text_of_a_broken_svg_is_escaped() {
    let message = |text: &str| read(text.as_bytes(), Some(DPI)).unwrap_err().to_string();
    for broken in ["<svg\u{0}", "<svg a\u{1b}[2J='1'/>", "<svg\u{7f}/>"] {
        let message = message(broken);
        assert!(message.starts_with("is no SVG: ") && !message.contains(char::is_control), "{message:?}");
    }
    let long = message(&format!("<svg><{}></svg>", "g".repeat(100_000)));
    assert!(long.len() < 500 && long.contains("…; allowed: a plain SVG"), "{long}");
}

#[test]
fn what_covers_the_canvas_is_the_ground_and_no_mark() {
    let dot = r##"<circle cx="50" cy="50" r="20" fill="#5a3210"/>"##;
    for (ground, colour) in [
        (r##"<rect width="400" height="300" fill="#f2d9a6"/>"##, Some([0xf2, 0xd9, 0xa6])),
        (r##"<path d="M-5 -5 H500 V400 H-5 z" fill="#f2d9a6"/>"##, Some([0xf2, 0xd9, 0xa6])),
        (
            r##"<rect x="2" y="2" width="396" height="296" fill="#f2d9a6" stroke="red"/>"##,
            Some([0xf2, 0xd9, 0xa6]),
        ),
        (
            r##"<g id="back"><rect width="100%" height="100%" style="fill:#00f;fill-opacity:.5"/></g>"##,
            Some([128, 128, 255]),
        ),
        (r##"<rect x="1" y="1" width="398" height="298" fill="none" stroke="red"/>"##, None),
    ] {
        let drawing = read(svg(&format!("{ground}{dot}")).as_bytes(), None).unwrap();
        let marks: Vec<_> = drawing.groups.iter().flat_map(|group| &group.marks).collect();
        assert_eq!((marks.len(), drawing.ground), (1, colour), "{ground}");
        assert_eq!(drawing.unread.contains_key("frame"), colour.is_none());
    }
    // A large mark is none.
    let large = read(svg(r#"<rect width="300" height="300"/>"#).as_bytes(), None).unwrap();
    assert_eq!((large.groups[0].marks.len(), large.ground), (1, None));
    let over =
        read(svg(&format!(r#"{dot}<rect width="400" height="300" fill="red"/>"#)).as_bytes(), None).unwrap();
    assert_eq!((over.ground, over.unread["shape over the whole canvas"]), (None, 1));
}

#[test]
fn marks_have_the_colours_of_their_fills_and_strokes() {
    let body = r##"<linearGradient id="l"><stop stop-color="#200"/><stop offset="1" stop-color="#420"/></linearGradient>
        <g fill="#5a3210"><circle cx="50" cy="50" r="20"/><circle cx="90" cy="50" r="20" style="fill:rgb(1,2,3)"/></g>
        <path d="M10 100 L90 100" stroke="teal" fill="none" stroke-width="4"/>
        <circle cx="150" cy="50" r="20" fill="url(#l)"/><circle cx="250" cy="50" r="20" fill="black" opacity=".5"/>"##;
    let drawing = read(svg(body).as_bytes(), None).unwrap();
    let colours: Vec<_> = drawing.groups.iter().flat_map(|group| group.colours.clone()).collect();
    for colour in [[0x5a, 0x32, 0x10], [1, 2, 3], [0, 128, 128], [0x33, 0x11, 0], [128, 128, 128]] {
        assert!(colours.contains(&colour), "{colour:?} in {colours:?}");
    }
    assert_eq!(commonest(&[[1; 3], [2; 3], [2; 3], [1; 3]]), Some([1; 3]));
}

#[test]
fn a_fill_by_a_pattern_gives_the_dots_of_its_tiles() {
    let read_tiles = |pattern: &str, shape: &str| {
        read(svg(&format!("<defs>{pattern}</defs>{shape}")).as_bytes(), None).unwrap()
    };
    let tile = r##"<pattern id="p" x="10" y="5" width="40" height="50" patternUnits="userSpaceOnUse"><rect width="40" height="50" fill="#eee"/><circle cx="16" cy="20" r="9" fill="#123"/></pattern>"##;
    let drawing = read_tiles(tile, r#"<rect width="400" height="300" fill="url(#p)"/>"#);
    assert_eq!((drawing.groups[0].marks.len(), drawing.ground), (60, Some([0xee; 3])));
    is_ellipse(&drawing.groups[0].marks[0], [26.0, 25.0], [9.0, 9.0], 0.0);
    // In a part of the canvas, with a transform, and with a box of the tile's own.
    let turned = r#"<pattern id="p" width="10" height="10" viewBox="0 0 100 100" patternUnits="userSpaceOnUse" patternTransform="scale(2) translate(5)"><ellipse cx="50" cy="50" rx="30" ry="20"/></pattern>"#;
    let drawing = read_tiles(turned, r#"<circle cx="100" cy="100" r="60" fill="url(#p)"/>"#);
    let marks = &drawing.groups[0].marks;
    assert!((24..=32).contains(&marks.len()), "{}", marks.len());
    is_ellipse(
        marks
            .iter()
            .find(|mark| (mark.center()[0] - 100.0).abs() < 1.0 && (mark.center()[1] - 90.0).abs() < 1.0)
            .unwrap(),
        [100.0, 90.0],
        [6.0, 4.0],
        0.0,
    );
    // Dots across the corners of tiles are drawn by four of them; a quarter of one alone is clipped.
    let corners = r#"<pattern id="p" width="40" height="40" patternUnits="userSpaceOnUse"><circle r="8"/><circle cx="40" r="8"/><circle cy="40" r="8"/><circle cx="40" cy="40" r="8"/></pattern>"#;
    let drawing = read_tiles(corners, r#"<rect x="20" y="20" width="120" height="120" fill="url(#p)"/>"#);
    assert_eq!(drawing.groups[0].marks.len(), 9);
    let quarter =
        r#"<pattern id="p" width="40" height="40" patternUnits="userSpaceOnUse"><circle r="8"/></pattern>"#;
    let drawing = read_tiles(
        quarter,
        r#"<rect x="20" y="20" width="120" height="120" fill="url(#p)"/><circle r="5" cx="9" cy="9"/>"#,
    );
    assert_eq!((drawing.groups[0].marks.len(), drawing.unread["clipped shape"]), (1, 9));
    let image = r#"<pattern id="p" width="40" height="40" patternUnits="userSpaceOnUse"><image href="a.png" width="40" height="40"/></pattern>"#;
    let drawing = read_tiles(
        image,
        r#"<rect width="120" height="120" fill="url(#p)"/><circle r="5" cx="200" cy="9"/>"#,
    );
    assert_eq!((drawing.groups[0].marks.len(), drawing.unread["pattern"]), (1, 1));
}

#[test]
fn groups_with_names_are_layers_inside_of_groups_too() {
    let names = |body: &str| -> Vec<(String, usize)> {
        let drawing = read(svg(body).as_bytes(), None).unwrap();
        drawing.groups.into_iter().map(|group| (group.name, group.marks.len())).collect()
    };
    let dot = r#"<circle cx="50" cy="50" r="20"/>"#;
    let of = |found: &[(&str, usize)]| {
        found.iter().map(|(name, marks)| ((*name).to_owned(), *marks)).collect::<Vec<_>>()
    };
    let coat = format!(
        r#"<g id="coat"><g id="spots">{dot}{dot}</g><g id="g12">{dot}</g><g id="x" inkscape:label="big">{dot}</g></g>"#
    );
    assert_eq!(names(&coat), of(&[("coat", 1), ("spots", 2), ("big", 1)]));
    let layers = format!(
        r#"<g id="layer1" inkscape:groupmode="layer"><g id="layer2" inkscape:groupmode="layer" inkscape:label="in">{dot}</g>{dot}</g>"#
    );
    assert_eq!(names(&layers), of(&[("layer1", 1), ("in", 1)]));
    let illustrator = format!(
        r#"<!-- Generator: Adobe Illustrator 27.0 --><g id="Big_x0020_spots">{dot}</g><g id="_x31_st_1_">{dot}</g><g id="a" data-name="L&#246;we">{dot}</g>"#
    );
    assert_eq!(names(&illustrator), of(&[("Big spots", 1), ("1st", 1), ("Löwe", 1)]));
    // One group a shape: these are no layers.
    let many: String =
        (0..40).map(|k| format!(r#"<g id="spot{}">{dot}</g>"#, (b'a' + k % 26) as char)).collect();
    assert_eq!(names(&format!(r#"<g id="all">{many}</g>"#)).len(), 1);
}

#[test]
fn hidden_and_empty_shapes_are_counted() {
    let body = r#"<circle cx="50" cy="50" r="20"/><g style="display:none"><circle r="3"/><rect width="9" height="9"/></g>
        <circle cx="9" r="0"/><rect width="4" height="4" fill="none"/><flowRoot/>"#;
    let unread = read(svg(body).as_bytes(), None).unwrap().unread;
    assert_eq!(
        (unread["hidden shape"], unread["shape that draws nothing"], unread["text"]),
        (2, 2, 1),
        "{unread:?}"
    );
}

#[test]
fn a_file_says_with_how_many_px_an_inch_it_was_drawn() {
    let text = r#"<svg xmlns="http://www.w3.org/2000/svg" width="25.4mm" height="12.7mm" viewBox="0 0 25.4 12.7" data-dpi="300"><circle cx="5" cy="5" r="2"/></svg>"#;
    let size = |dpi| read(text.as_bytes(), dpi).unwrap().size.map(f64::round);
    assert_eq!((size(None), size(Some(96.0))), ([300.0, 150.0], [96.0, 48.0]));
}

#[test]
fn decimal_commas_and_other_encodings_are_read() {
    let text = r#"<?xml version="1.0" encoding="ISO-8859-1"?><svg xmlns="http://www.w3.org/2000/svg" width="400" height="300"><g id="Löwe"><ellipse cx="50,5" cy="60,25" rx="20,5" ry="10,5"/></g></svg>"#;
    let latin: Vec<u8> = text.chars().map(|c| c as u8).collect();
    let drawing = read(&latin, None).unwrap();
    assert_eq!(drawing.groups[0].name, "Löwe");
    is_ellipse(&drawing.groups[0].marks[0], [50.5, 60.25], [20.5, 10.5], 0.0);
}

proptest! {
    #[test]
    fn a_drawn_ellipse_is_read_back(
        (x, y) in (50.0..350.0, 50.0..250.0),
        (major, aspect) in (5.0..60.0, 0.3..1.0),
        angle in 0.0..180.0,
    ) {
        let body = format!(
            r#"<ellipse cx="{x}" cy="{y}" rx="{major}" ry="{}" transform="rotate({angle} {x} {y})"/>"#,
            major * aspect
        );
        is_ellipse(&read_marks(&body)[0], [x, y], [major, major * aspect], angle);
    }

    #[test]
    fn garbage_never_panics(
        pieces in prop::collection::vec(prop::sample::select(vec![
            "<g>", "</g>", "<circle r='1e39'/>", "<path d='M0 0L1e38 1e38z'/>", "<path d='M'/>", "<line/>",
            "<rect width='1' height='nan'/>", "<g transform='scale(0)'>", "<use href='#a'/>", "<g id='a'>",
            "<path stroke='red' d='M1 1h1e-30'/>", "<svg>", "</svg>", "&amp;", "<!--", "<ellipse rx='3' ry='1'/>",
            "<path d='M0 0a1 1 0 0 1 1e9 0' stroke='red' transform='matrix(1e20 0 0 1e20 0 0)'/>",
        ]), 0..12),
        bytes in prop::collection::vec(any::<u8>(), 0..40),
    ) {
        let _ = read(&bytes, Some(DPI));
        if let Ok(drawing) = read(svg(&pieces.concat()).as_bytes(), Some(DPI)) {
            let marks = drawing.groups.iter().flat_map(|group| &group.marks);
            prop_assert!(marks.into_iter().all(|mark| mark.center().iter().all(|c| c.is_finite())));
        }
    }
}
