//! Text on a sheet.

use super::paper::Paper;
use ab_glyph::{Font, FontRef, GlyphId, PxScale, ScaleFont, point};

/// The colour of names.
pub const INK: [u8; 3] = [38, 36, 34];
/// The colour of seeds.
pub const PALE: [u8; 3] = [138, 132, 124];
/// The colour of errors.
pub const RED: [u8; 3] = [158, 40, 28];

/// Roboto Condensed; its source is in `assets/fonts/README.md`.
const FONT: &[u8] = include_bytes!("../../../assets/fonts/RobotoCondensed-Regular.ttf");

/// Draws text of one size.
pub struct Pen {
    font: FontRef<'static>,
    scale: PxScale,
    /// Line height, px.
    pub line: usize,
}

impl Pen {
    /// A pen whose text size is right for pictures of `thumb` px.
    pub fn for_pictures_of(thumb: usize) -> Self {
        let high = (thumb as f32 / 15.0).clamp(13.0, 48.0);
        let font = FontRef::try_from_slice(FONT).expect("the built-in font is valid");
        Self { font, scale: PxScale::from(high), line: (1.15 * high).round() as usize }
    }

    fn width(&self, text: &str) -> f32 {
        let font = self.font.as_scaled(self.scale);
        text.chars().map(|letter| font.h_advance(self.glyph(letter))).sum()
    }

    /// Characters missing in the font are boxes; control characters and white space are blanks.
    fn glyph(&self, letter: char) -> GlyphId {
        self.font.glyph_id(if letter.is_control() || letter.is_whitespace() { ' ' } else { letter })
    }

    /// Breaks a text into at most `most` lines of `width` px, between words if possible; the rest is replaced by an
    /// ellipsis.
    pub fn wrap(&self, text: &str, width: usize, most: usize) -> Vec<String> {
        let fits = |line: &str| self.width(line) <= width as f32;
        let mut lines = vec![String::new()];
        for word in text.split_whitespace() {
            let line = lines.last_mut().expect("there is one from the start");
            let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
            if fits(&longer) {
                *line = longer;
                continue;
            }
            if !line.is_empty() {
                lines.push(String::new());
            }
            for letter in word.chars() {
                let line = lines.last_mut().expect("there is one from the start");
                line.push(letter);
                if line.chars().count() > 1 && !fits(line) {
                    line.pop();
                    lines.push(letter.to_string());
                }
            }
        }
        if lines.len() > most {
            lines.truncate(most);
            if let Some(last) = lines.last_mut() {
                while !last.is_empty() && !fits(&format!("{last}…")) {
                    last.pop();
                }
                *last = format!("{}…", last.trim_end());
            }
        }
        lines
    }

    /// Draws one line with its upper left corner at `at`.
    pub fn write(&self, paper: &mut Paper, text: &str, at: [usize; 2], colour: [u8; 3]) {
        let font = self.font.as_scaled(self.scale);
        // Equal space above and below the letters.
        let base = at[1] as f32 + 0.5 * (self.line as f32 + font.ascent() + font.descent());
        let mut x = at[0] as f32;
        for letter in text.chars() {
            let id = self.glyph(letter);
            let glyph = id.with_scale_and_position(self.scale, point(x, base.round()));
            x += font.h_advance(id);
            let Some(outline) = self.font.outline_glyph(glyph) else { continue };
            let corner = outline.px_bounds().min;
            let corner = [corner.x as i64, corner.y as i64];
            outline.draw(|across, down, share| {
                paper.blend([corner[0] + i64::from(across), corner[1] + i64::from(down)], colour, share);
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_hold_all_words_and_fit() {
        let pen = Pen::for_pictures_of(256);
        let text = "smaller dots between larger ones (Phan & Grimm 2006, fig. 1b)";
        let lines = pen.wrap(text, 150, 9);
        assert!(lines.len() > 2, "{lines:?}");
        assert!(lines.iter().all(|line| pen.width(line) <= 150.0), "{lines:?}");
        assert_eq!(lines.join(" "), text);
        assert_eq!(pen.wrap(" a\n b\t", 150, 9), ["a b"]);
        assert_eq!(pen.wrap("", 150, 9), [""]);
    }

    #[test]
    fn long_texts_are_cut_off() {
        let pen = Pen::for_pictures_of(64);
        let word = "hippopotamus".repeat(9);
        let lines = pen.wrap(&word, 60, 2);
        assert!(lines.len() == 2 && lines[1].ends_with('…'), "{lines:?}");
        assert!(lines.iter().all(|line| pen.width(line) <= 60.0), "{lines:?}");
        assert!(word.starts_with(&lines[0]));
        // At least one letter a line, however narrow.
        assert_eq!(pen.wrap("ab", 1, 9), ["a", "b"]);
        assert!(pen.wrap(&word, 60, 0).is_empty());
    }

    #[test]
    fn letters_fit_into_their_line() {
        let pen = Pen::for_pictures_of(256);
        let mut paper = Paper::blank([200, 3 * pen.line]);
        let blank = paper.rgb[0];
        pen.write(&mut paper, "Åg|jÉ", [10, pen.line], INK);
        let inked =
            |row: usize| paper.rgb[3 * 200 * row..3 * 200 * (row + 1)].iter().step_by(3).any(|v| *v != blank);
        let rows: Vec<usize> = (0..3 * pen.line).filter(|row| inked(*row)).collect();
        assert!(rows[0] >= pen.line && *rows.last().unwrap() < 2 * pen.line, "{rows:?}");
        assert!(rows.len() > pen.line / 2);
    }
}
