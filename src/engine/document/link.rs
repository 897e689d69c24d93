//! A document in a link: it stands in the fragment of the address, which browsers do not send to servers.
//!
//! ```text
//!  document ─▶ JSON without what has its default ─▶ deflate (RFC 1951) ─▶ base64url without padding (RFC 4648) ─▶ #dapple1=…
//! ```
//!
//! The number is the version of the link format; the version of the document is a part of the document.

use serde_json::Value;

use crate::document::limits::{MAX_LINK, MAX_LINK_TEXT};
use crate::document::{BodySource, Document, Layer, LinkError, writer};

/// Web address of the window unless the settings name another. (The domain is reserved and has no owner.)
pub const SITE: &str = "https://dapple.example/";
/// Characters of a fragment that messengers, mail programs and forums pass on whole.
pub const SHORT: usize = 2_000;

/// Text before the version.
const MARK: &str = "#dapple";
/// The version that is written, and the newest that is read.
const VERSION: &str = "1";
/// The highest level of `miniz_oxide`.
const LEVEL: u8 = 10;
/// The name of the document of a link in messages.
const SOURCE: &str = "the document in the link";

/// Whether a text is an address with a document in its fragment, of whatever version, or such a fragment alone.
#[must_use]
pub fn is_link(text: &str) -> bool {
    let text = text.trim();
    let Some((address, fragment)) = text.split_once(MARK) else { return false };
    let version = fragment.split('=').next().unwrap_or_default();
    let is_address = address.is_empty() || address.contains("://") && !address.contains(char::is_whitespace);
    is_address && fragment.contains('=') && !version.is_empty() && version.bytes().all(|c| c.is_ascii_digit())
}

impl Document {
    /// The fragment of a link to this document, from `#` on.
    ///
    /// # Errors
    /// It needs a model that is a file, or is too large for a link.
    pub fn fragment(&self) -> Result<String, LinkError> {
        self.without_files()?;
        let mut value = writer::value(self);
        leave_defaults_out(&mut value);
        let text = value.to_string();
        if text.len() > MAX_LINK_TEXT {
            return Err(LinkError::TooLarge);
        }
        let packed = miniz_oxide::deflate::compress_to_vec(text.as_bytes(), LEVEL);
        let fragment = format!("{MARK}{VERSION}={}", base64::encode_config(packed, base64::URL_SAFE_NO_PAD));
        match fragment.len() {
            found if found > MAX_LINK => Err(LinkError::TooLong { found }),
            _ => Ok(fragment),
        }
    }

    /// The document in a link, or in its fragment. White space is ignored: mail programs break lines.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    ///
    /// let drawn = Document::new([96, 96]).with_layer(Layer::new([Stroke::ellipse([30.0, 30.0], [8.0, 5.0], 30.0)]));
    /// let fragment = drawn.fragment()?;
    /// assert_eq!(Document::from_link(&fragment)?, drawn);
    /// # Ok::<(), dapple_engine::document::LinkError>(())
    /// ```
    ///
    /// # Errors
    /// There is none, it is damaged or too large, or what it holds is no valid document or needs a file.
    pub fn from_link(text: &str) -> Result<Self, LinkError> {
        if text.len() > MAX_LINK + MAX_LINK / 8 {
            return Err(LinkError::TooLong { found: text.chars().count() });
        }
        let (version, packed) = parts(text).ok_or(LinkError::NoDocument)?;
        if version != VERSION {
            return Err(LinkError::Newer { version: version.to_owned(), known: VERSION });
        }
        let document = Self::from_bytes(&unpacked(packed)?, SOURCE)?;
        document.without_files()?;
        Ok(document)
    }

    /// Checks that the document needs no file.
    fn without_files(&self) -> Result<(), LinkError> {
        let all = std::iter::once(self).chain(self.starred.iter().map(|starred| &starred.document));
        let file = |document: &Self| match (
            document.model.as_ref().map(|model| &model.source),
            &document.parametric,
        ) {
            (Some(BodySource::File { path, .. }), _) => Some(path.clone()),
            (_, Some(surface)) => surface.relief().map(|relief| relief.path.clone()),
            _ => None,
        };
        all.filter_map(file).next().map_or(Ok(()), |file| Err(LinkError::Model { file }))
    }
}

/// The version of a link and what follows it.
fn parts(text: &str) -> Option<(&str, &str)> {
    is_link(text).then(|| text.split_once(MARK)?.1.split_once('=')).flatten()
}

/// Unpacks the text of a document, up to [`MAX_LINK_TEXT`] bytes.
fn unpacked(packed: &str) -> Result<Vec<u8>, LinkError> {
    let damaged = |why: String| LinkError::Damaged { why };
    let digits: String = packed.chars().filter(|c| !c.is_whitespace()).collect();
    let bytes = base64::decode_config(digits, base64::URL_SAFE_NO_PAD)
        .map_err(|error| damaged(format!("its characters are not base64url ({error})")))?;
    miniz_oxide::inflate::decompress_to_vec_with_limit(&bytes, MAX_LINK_TEXT).map_err(|error| {
        match error.status {
            miniz_oxide::inflate::TINFLStatus::HasMoreOutput => LinkError::TooLarge,
            _ => damaged("it does not unpack".to_owned()),
        }
    })
}

/// Removes the keys that have their default values from the JSON of a document.
fn leave_defaults_out(document: &mut Value) {
    let usual = writer::value(&Document { layers: vec![Layer::default()], ..Document::default() });
    remove_usual(document, &usual, &["format", "version", "size", "layers"]);
    for (index, layer) in items(document, "layers").enumerate() {
        remove_usual(layer, &usual["layers"][0], &["name", "strokes"]);
        if layer["name"] == format!("layer {}", index + 1)
            && let Some(map) = layer.as_object_mut()
        {
            map.shift_remove("name");
        }
    }
    for starred in items(document, "starred") {
        leave_defaults_out(&mut starred["document"]);
    }
}

fn items<'a>(value: &'a mut Value, key: &str) -> impl Iterator<Item = &'a mut Value> {
    value.get_mut(key).and_then(Value::as_array_mut).into_iter().flatten()
}

/// Removes the keys that have the same value as in `usual`, except those that are required or have another default.
fn remove_usual(value: &mut Value, usual: &Value, kept: &[&str]) {
    if let Some(map) = value.as_object_mut() {
        map.retain(|key, value| kept.contains(&key.as_str()) || usual.get(key) != Some(value));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Starred, Stroke};

    fn document() -> Document {
        let strokes = [[30.0, 30.25], [58.0, 34.0]].map(|center| Stroke::ellipse(center, [8.0, 5.0], 30.0));
        let layer = Layer { name: "layer 1".to_owned(), ..Layer::new(strokes) };
        Document::new([96, 96]).with_layer(layer)
    }

    /// A link with these bytes, deflated.
    fn link_of(bytes: &[u8]) -> String {
        let packed = miniz_oxide::deflate::compress_to_vec(bytes, LEVEL);
        format!("{MARK}{VERSION}={}", base64::encode_config(packed, base64::URL_SAFE_NO_PAD))
    }

    fn error(text: &str) -> String {
        Document::from_link(text).unwrap_err().to_string()
    }

    #[test]
    fn values_at_their_defaults_are_left_out_and_read_back() {
        let document = document();
        let fragment = document.fragment().unwrap();
        let text = unpacked(fragment.strip_prefix("#dapple1=").unwrap()).unwrap();
        assert_eq!(
            String::from_utf8(text).unwrap(),
            r#"{"format":"dapple","version":2,"size":[96,96],"layers":[{"strokes":[{"kind":"ellipse","center":[30,30.25],"radii":[8,5],"angle":30},{"kind":"ellipse","center":[58,34],"radii":[8,5],"angle":30}]}]}"#
        );
        assert_eq!(Document::from_link(&fragment).unwrap(), document);
    }

    #[test]
    fn values_other_than_defaults_are_kept_in_starred_textures_too() {
        let inner = Document { seed: 5, ..document() };
        let starred = vec![Starred { name: "seed 5".to_owned(), document: inner }];
        let mut document = Document { name: "a".to_owned(), seed: 7, dpi: 90.0, starred, ..document() };
        document.growth.refine = false;
        document.layers[0].name = "layer 2".to_owned();
        document.layers[0].visible = false;
        assert_eq!(Document::from_link(&document.fragment().unwrap()).unwrap(), document);
    }

    #[test]
    fn a_link_is_an_address_with_a_document_or_its_fragment() {
        let fragment = document().fragment().unwrap();
        let address = format!(" https://example.org/a/?view{fragment}\n");
        for text in [fragment.as_str(), &address, "file:///a/index.html#dapple9=x"] {
            assert!(is_link(text), "{text}");
        }
        let json = document().to_json();
        for text in
            ["", "#", "#dapple", "#dapple=", "#dapplex=1", "a#dapple1=b", "see https://a#dapple1=b", &json]
        {
            assert!(!is_link(text), "{text}");
        }
        let broken = address.replace("BA", "B\r\n A").replace("y", "y\n");
        assert_eq!(Document::from_link(&broken).unwrap(), document());
    }

    #[test]
    fn a_link_that_was_cut_off_or_changed_is_refused_wherever_that_was() {
        let fragment = document().fragment().unwrap();
        for end in "#dapple1=".len()..fragment.len() {
            let message = error(&fragment[..end]);
            assert!(message.contains("damaged or was cut off"), "{end}: {message}");
        }
        assert!(error(&fragment.replace("=", "=%3D")).contains("base64url"), "{fragment}");
        assert!(error("https://example.org").contains("allowed: a link"));
        assert!(error("#dapple2=abc").contains("version: found 2"));
    }

    #[test]
    fn the_size_of_an_unpacked_link_is_bounded() {
        let bomb = link_of(&vec![b' '; 40 << 20]);
        assert!(bomb.len() < MAX_LINK, "{}", bomb.len());
        assert!(error(&bomb).contains("more than 1048576 bytes"));
        let long = format!("{MARK}{VERSION}={}", "A".repeat(2 * MAX_LINK));
        assert!(error(&long).contains("allowed: at most 65536"));
        assert!(error(&link_of(b"\xff\xfe{}")).contains("0xff"));
        assert!(
            error(&link_of("[".repeat(MAX_LINK_TEXT - 1).as_bytes())).contains("the document in the link")
        );
        assert!(error(&link_of(b"{}")).contains("format"));
    }

    #[test]
    fn a_model_that_is_a_file_is_in_no_link() {
        let text = r#"{"format": "dapple", "version": 2, "size": [200, 160], "model": {"file": "cat.obj"}, "layers": [
            {"strokes": [{"kind": "ellipse", "at": [0, 1, 0], "radii": [9, 6]}]}]}"#;
        let of_file = Document::parse(text, "a").unwrap();
        assert!(of_file.fragment().unwrap_err().to_string().contains("\"cat.obj\""));
        assert!(error(&link_of(text.as_bytes())).contains("\"cat.obj\""));
        let heights = document()
            .to_json()
            .replace("\"layers\"", "\"model\": {\"height\": \"hills.png\", \"scale\": 9}, \"layers\"");
        assert!(error(&link_of(heights.as_bytes())).contains("\"hills.png\""));
    }

    #[test]
    fn a_document_that_is_too_large_for_a_link_says_so() {
        let mut document = document();
        let mut many = (0..20_000).map(|i| f64::from(i) * 0.618 % 96.0);
        let strokes = std::iter::from_fn(|| Some([many.next()?, many.next()?]));
        document.layers[0].strokes = strokes.map(|center| Stroke::ellipse(center, [2.0, 1.0], 7.0)).collect();
        let message = document.fragment().unwrap_err().to_string();
        assert!(message.contains("as a file instead"), "{message}");
    }
}
