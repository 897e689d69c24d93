//! Formats of pictures, by the ending of a file's name.

use std::path::Path;

/// A format that pictures are written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// 8 and 16 bit, with or without opacity; keeps the document.
    Png,
    /// 8 and 16 bit, with or without opacity; not compressed.
    Tiff,
    /// 32-bit floating point, colours as light; any number of named channels.
    Exr,
    /// 8-bit colours, with losses.
    Jpeg,
    /// 8-bit colours, without losses, with or without opacity.
    Webp,
}

/// What a picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Content {
    /// Colours, to be looked at.
    Colours,
    /// A number a px, to be reckoned with: a pattern.
    Numbers,
    /// A whole number a px: labels.
    Labels,
    /// Several numbers a px, each with its name: concentrations.
    Channels,
}

impl Format {
    /// Endings and the formats that they stand for; the usual ending of a format first.
    pub const ENDINGS: [(&'static str, Self); 7] = [
        ("png", Self::Png),
        ("tif", Self::Tiff),
        ("tiff", Self::Tiff),
        ("exr", Self::Exr),
        ("jpg", Self::Jpeg),
        ("jpeg", Self::Jpeg),
        ("webp", Self::Webp),
    ];

    /// The format that the ending of `path`, in upper or lower case, stands for.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?;
        let known = Self::ENDINGS.iter().find(|(known, _)| known.eq_ignore_ascii_case(ending));
        known.map(|(_, format)| *format)
    }

    /// What people call it.
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

    /// Whether it is fit to show `content`: what is reckoned with must not be changed by losses.
    #[must_use]
    pub fn shows(self, content: Content) -> bool {
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

    /// Whether it holds 16 bit a channel.
    #[must_use]
    pub fn is_deep(self) -> bool {
        matches!(self, Self::Png | Self::Tiff)
    }

    /// Px of the longest side that it can hold.
    #[must_use]
    pub fn longest(self) -> usize {
        match self {
            Self::Png | Self::Exr => i32::MAX as usize,
            Self::Tiff => u32::MAX as usize,
            Self::Jpeg => 65_535,
            Self::Webp => 16_383,
        }
    }

    /// Bytes a px that its writer holds beside the band in work: WebP's wants the whole picture at once. Measured 7.0, and
    /// 8.0 with opacity, for one texture of 8192² px; more is allowed for, as the coded picture is part of it and others
    /// code worse.
    #[must_use]
    pub fn held(self) -> f64 {
        if self == Self::Webp { 14.0 } else { 0.0 }
    }
}

/// The endings of the formats that show `content`, as a message lists them.
/// The endings of the formats that show `content`.
pub(super) fn fitting(content: Content) -> Vec<&'static str> {
    Format::ENDINGS.iter().filter(|(_, format)| format.shows(content)).map(|(ending, _)| *ending).collect()
}

pub(super) fn endings(content: Content) -> String {
    let fit = Format::ENDINGS.iter().filter(|(_, format)| format.shows(content));
    fit.map(|(ending, _)| format!(".{ending}")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ending_in_any_case_tells_the_format() {
        assert_eq!(Format::of(Path::new("a/b.TIFF")), Some(Format::Tiff));
        assert_eq!(Format::of(Path::new("b.x.Jpg")), Some(Format::Jpeg));
        assert_eq!([".png", "a", "a.gif", "a.png.bak"].map(|name| Format::of(Path::new(name))), [None; 4]);
    }

    #[test]
    fn numbers_are_not_written_with_losses() {
        assert_eq!(endings(Content::Numbers), ".png, .tif, .tiff, .exr");
        assert_eq!(endings(Content::Labels), ".png, .tif, .tiff");
        assert_eq!(endings(Content::Channels), ".exr");
    }
}
