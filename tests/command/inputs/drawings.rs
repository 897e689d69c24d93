//! SVGs of drawing programs.

use crate::outlines::bench::Bench;
use dapple::ReadFile;
use dapple::document::Document;

const COAT: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" width="128" height="128"><rect width="128" height="128" fill="#f2d9a6"/>
    <g id="brown" fill="#5a3210"><ellipse cx="30" cy="30" rx="9" ry="6"/><ellipse cx="60" cy="34" rx="9" ry="6"/><ellipse cx="44" cy="60" rx="9" ry="6"/></g></svg>"##;

fn imported(bench: &Bench, arguments: &str) -> (Document, String) {
    let said = bench.does(&format!("import {arguments} -o out.dapple"));
    (Document::read(bench.path("out.dapple")).unwrap(), said)
}

fn hex(document: &Document, layer: usize) -> [String; 2] {
    let colours = document.layers[layer].colours.as_ref().expect("colours");
    [&colours.stops[0], &colours.stops[colours.stops.len() - 1]].map(dapple::document::Stop::hex)
}

#[test]
fn a_rectangle_behind_everything_is_the_ground_and_fills_are_the_colours() {
    let bench = Bench::new();
    bench.write("coat.svg", COAT);
    let (document, said) = imported(&bench, "coat.svg");
    assert_eq!((document.layers.len(), document.layers[0].strokes.len()), (1, 3));
    assert_eq!(hex(&document, 0), ["#f2d9a6", "#5a3210"]);
    assert!(said.contains("ground #f2d9a6"), "{said}");
    bench.does("grow out.dapple -o out.png");
}

#[test]
fn outlines_with_their_ground_are_imported_unchanged() {
    let bench = Bench::new();
    bench.does("grow a.dapple -o a.svg --ground");
    let drawn = bench.text("a.svg").matches("<path").count();
    let (document, _) = imported(&bench, "a.svg");
    assert_eq!((document.size, document.dpi, document.layers.len()), ([128, 96], 300.0, 1));
    assert_eq!(document.layers[0].name, "big spots");
    assert!(document.layers[0].strokes.len() >= drawn, "{drawn}");
    let ground = bench.text("a.svg").split("fill=\"").nth(1).unwrap()[..7].to_owned();
    assert_eq!(hex(&document, 0)[0], ground);
}

#[test]
fn compressed_and_wide_drawings_are_read() {
    let bench = Bench::new();
    let wide: Vec<u8> = [0xfeff].into_iter().chain(COAT.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    std::fs::write(bench.path("wide.svg"), &wide).unwrap();
    std::fs::write(bench.path("wide"), &wide).unwrap();
    let mut packed = vec![0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 0, 3];
    packed.extend(dapple_engine_deflate(COAT.as_bytes()));
    std::fs::write(bench.path("coat.svgz"), &packed).unwrap();
    for file in ["wide.svg", "wide", "coat.svgz"] {
        assert_eq!(imported(&bench, file).0.layers[0].strokes.len(), 3, "{file}");
    }
    std::fs::write(bench.path("cut.svgz"), &packed[..packed.len() / 2]).unwrap();
    bench.refuses("import cut.svgz -o x.dapple", 1, &["compressed data are damaged", "a whole .svgz"]);
}

/// Stored blocks of deflate (RFC 1951), without compression.
fn dapple_engine_deflate(bytes: &[u8]) -> Vec<u8> {
    let length = u16::try_from(bytes.len()).expect("one block");
    [&[1][..], &length.to_le_bytes(), &(!length).to_le_bytes(), bytes].concat()
}
