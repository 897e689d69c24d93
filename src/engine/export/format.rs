//! Picture formats, by file name ending.

use std::path::Path;

/// A format that pictures are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Format {
    /// 8 and 16 bit, with or without opacity; may contain the document.
    Png,
    /// 8 and 16 bit, with or without opacity; not compressed.
    Tiff,
    /// 32-bit floating point, linear colours; any number of named channels.
    Exr,
    /// 8-bit colours, lossy.
    Jpeg,
    /// 8-bit colours, lossless, with or without opacity.
    Webp,
}

/// The kind of content of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Colours to look at.
    Colours,
    /// A number for each px, for computation: a pattern.
    Numbers,
    /// An integer for each px: labels.
    Labels,
    /// Several named numbers for each px: concentrations.
    Channels,
}

impl Format {
    /// Endings and their formats; the usual ending of a format first.
    pub const ENDINGS: [(&'static str, Self); 7] = [
        ("png", Self::Png),
        ("tif", Self::Tiff),
        ("tiff", Self::Tiff),
        ("exr", Self::Exr),
        ("jpg", Self::Jpeg),
        ("jpeg", Self::Jpeg),
        ("webp", Self::Webp),
    ];

    /// The format of the ending of `path`, in upper or lower case.
    ///
    /// ```
    /// use std::path::Path;
    ///
    /// use dapple_engine::export::Format;
    ///
    /// assert_eq!(Format::from_path(Path::new("zebra.PNG")), Some(Format::Png));
    /// assert_eq!(Format::from_path(Path::new("zebra.txt")), None);
    /// ```
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?;
        let known = Self::ENDINGS.iter().find(|(known, _)| known.eq_ignore_ascii_case(ending));
        known.map(|(_, format)| *format)
    }

    /// Its usual name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Tiff => "TIFF",
            Self::Exr => "OpenEXR",
            Self::Jpeg => "JPEG",
            Self::Webp => "WebP",
        }
    }

    /// Whether it can hold `content`: numbers must not change by lossy compression.
    #[must_use]
    pub fn holds(self, content: Content) -> bool {
        match content {
            Content::Colours => true,
            Content::Numbers => matches!(self, Self::Png | Self::Tiff | Self::Exr),
            Content::Labels => matches!(self, Self::Png | Self::Tiff),
            Content::Channels => self == Self::Exr,
        }
    }

    /// Whether its px can be transparent.
    #[must_use]
    pub fn has_opacity(self) -> bool {
        self != Self::Jpeg
    }

    /// Whether it can hold 16 bits a channel.
    #[must_use]
    pub fn is_deep(self) -> bool {
        matches!(self, Self::Png | Self::Tiff)
    }

    /// The longest side that it can hold, px.
    #[must_use]
    pub fn max_side(self) -> usize {
        match self {
            Self::Png | Self::Exr => i32::MAX as usize,
            Self::Tiff => u32::MAX as usize,
            Self::Jpeg => 65_535,
            Self::Webp => 16_383,
        }
    }

    /// Bytes a px that the writer holds in addition to the current band: WebP needs the whole picture at once. Measured: 7.0, and
    /// 8.0 with opacity, for one texture of 8192² px. This value is larger because the compressed picture is part of it and other
    /// textures compress worse.
    #[must_use]
    pub fn writer_bytes_per_px(self) -> f64 {
        if self == Self::Webp { 14.0 } else { 0.0 }
    }
}

impl Content {
    /// The endings of the formats that can hold `content`.
    #[must_use]
    pub fn endings(self) -> Vec<&'static str> {
        Format::ENDINGS.iter().filter(|(_, format)| format.holds(self)).map(|(ending, _)| *ending).collect()
    }
}

/// Whether a file name ends in `.ending`, in upper or lower case.
#[must_use]
pub fn has_ending(path: &Path, ending: &str) -> bool {
    path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending))
}

/// The endings of the formats that can hold `content`, as a message lists them.
pub(super) fn endings(content: Content) -> String {
    content.endings().iter().map(|ending| format!(".{ending}")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ending_in_any_case_gives_the_format() {
        assert_eq!(Format::from_path(Path::new("a/b.TIFF")), Some(Format::Tiff));
        assert_eq!(Format::from_path(Path::new("b.x.Jpg")), Some(Format::Jpeg));
        assert_eq!(
            [".png", "a", "a.gif", "a.png.bak"].map(|name| Format::from_path(Path::new(name))),
            [None; 4]
        );
    }

    #[test]
    fn numbers_are_not_written_in_lossy_formats() {
        assert_eq!(endings(Content::Numbers), ".png, .tif, .tiff, .exr");
        assert_eq!(endings(Content::Labels), ".png, .tif, .tiff");
        assert_eq!(endings(Content::Channels), ".exr");
    }
}
