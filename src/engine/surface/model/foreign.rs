//! Files of other formats, recognised by their first bytes.

/// First bytes, and the kind of file that begins with them.
const BEGINNINGS: [(&[u8], &str); 17] = [
    (b"Kaydara FBX", "an FBX file"),
    (b"; FBX", "an FBX file"),
    (b"PK\x03\x04", "a ZIP archive (or a format that is one, such as .3mf or .usdz)"),
    (b"\x1f\x8b", "a file compressed by gzip"),
    (b"\x28\xb5\x2f\xfd", "a file compressed by zstd (such as a .blend file)"),
    (b"7z\xbc\xaf\x27\x1c", "a 7z archive"),
    (b"Rar!", "a RAR archive"),
    (b"BLENDER", "a file of Blender"),
    (b"PXR-USDC", "a USD file"),
    (b"#usda", "a USD file"),
    (b"OFF\n", "an OFF file"),
    (b"MM\0\0", "a TIFF picture or a 3DS file"),
    (b"\x89PNG", "a PNG picture"),
    (b"\xff\xd8\xff", "a JPEG picture"),
    (b"%PDF", "a PDF file"),
    (b"\xff\xfe", "text in UTF-16"),
    (b"\xfe\xff", "text in UTF-16"),
];

/// The kind of a file, if it is certainly not one of those that are read.
pub fn format(bytes: &[u8]) -> Option<&'static str> {
    let known = BEGINNINGS.iter().find(|(beginning, _)| bytes.starts_with(beginning));
    if let Some((_, name)) = known {
        return Some(name);
    }
    let text = bytes.trim_ascii_start();
    match text.first() {
        None => return Some("an empty file"),
        Some(b'<') => return Some("an XML file (such as .dae or .x3d)"),
        _ => {}
    }
    bytes[..bytes.len().min(4096)].contains(&0).then_some("a binary file")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_formats_are_named() {
        let cases: [(&[u8], &str); 4] = [
            (b"Kaydara FBX Binary  \0", "FBX"),
            (b"PK\x03\x04\x14\0", "ZIP"),
            (b"v 1 2 3\n\0\0\0", "binary"),
            (b"\n", "empty"),
        ];
        for (bytes, name) in cases {
            assert!(format(bytes).is_some_and(|found| found.contains(name)), "{name}: {:?}", format(bytes));
        }
        assert_eq!(format(b"# a cube\nv 0 0 0\n"), None);
    }
}
