//! The choices on the disk: numbers and words, a line a kind of export.

use super::file::Entries;
use crate::app::exporting::choices::{
    Choices, ExportKind, FORMATS, Film, KINDS, Material, Outlines, Picture, PictureContent, RELIEF,
};
use crate::app::units::Units;
use crate::export::Format;
use crate::export::motion::Kind;
use crate::synth::render::clip::Clip;

/// Writes down what the next dialog begins with.
pub fn tell(choices: &Choices, entries: &mut Entries) {
    let first = Choices::default();
    let Choices { what, picture: p, material, outlines, film, .. } = choices;
    if (what, p) != (&first.what, &first.picture) {
        let [what, shows] = [*what as u8, p.shows as u8];
        let format = FORMATS.iter().position(|format| *format == p.format).unwrap_or(0);
        let [deep, clear, document] = [p.deep, p.transparent, p.document].map(u8::from);
        let quality = p.quality;
        entries.add("export", format!("{what} {shows} {format} {deep} {clear} {quality} {document}"));
    }
    if *material != first.material {
        let [deep, clear] = [material.deep, material.transparent].map(u8::from);
        entries.add("export-material", format!("{deep} {clear} {}", list(&material.roughness)));
        entries.add("export-relief", list(&material.relief));
    }
    if *outlines != first.outlines {
        let Outlines { level, spacing, angle, pen, width, area, .. } = *outlines;
        let o = outlines;
        let flags = [o.dxf, o.units == Units::Mm, o.fill, o.stroke, o.hatch, o.cut, o.ordered];
        let numbers = flags.map(|flag| f64::from(u8::from(flag))).into_iter();
        let numbers = numbers.chain([level, spacing, angle, pen, width, area]).collect::<Vec<_>>();
        entries.add("export-outlines", list(&numbers));
    }
    if (film.kind, film.clip) != (first.film.kind, first.film.clip) {
        let Clip { side, seconds, fps, once, hold } = film.clip;
        let (kind, once, side) = (film.kind as u8, u8::from(once), side.unwrap_or(0));
        entries.add("export-film", format!("{kind} {side} {seconds} {fps} {once} {hold}"));
    }
}

/// The same, read again; what makes no sense is as at first.
pub fn read(entries: &Entries) -> Choices {
    let first = Choices::default();
    let (what, picture) = picture(entries).unwrap_or((first.what, first.picture));
    let mut read = Choices {
        what,
        picture,
        material: material(entries).unwrap_or(first.material),
        outlines: outlines(entries).unwrap_or(first.outlines),
        film: film(entries).unwrap_or(first.film),
        ..Choices::default()
    };
    read.make_consistent();
    read
}

fn list(values: &[f64]) -> String {
    values.iter().map(f64::to_string).collect::<Vec<_>>().join(" ")
}

fn picture(entries: &Entries) -> Option<(ExportKind, Picture)> {
    let [what, shows, format, deep, clear, quality, document] = entries.numbers("export")?;
    let what = [ExportKind::Picture, ExportKind::Material, ExportKind::Outlines, ExportKind::Film]
        .get(what as usize)
        .copied()?;
    let all = [
        PictureContent::Texture,
        PictureContent::Pattern,
        PictureContent::Labels,
        PictureContent::Concentrations,
    ];
    let shows = all.get(shows as usize).copied()?;
    Some((
        what,
        Picture {
            shows,
            format: FORMATS.get(format as usize).copied().unwrap_or(Format::Png),
            deep: deep != 0.0,
            transparent: clear != 0.0,
            quality: quality.clamp(1.0, 100.0) as u8,
            document: document != 0.0,
        },
    ))
}

fn material(entries: &Entries) -> Option<Material> {
    let numbers = |key| {
        let words = entries.one(key).unwrap_or_default().split(' ');
        words.filter_map(|word| word.parse().ok().filter(|n: &f64| n.is_finite())).collect::<Vec<f64>>()
    };
    let (relief, rest) = (numbers("export-relief"), numbers("export-material"));
    let [deep, clear, roughness @ ..] = &rest[..] else { return None };
    (!relief.is_empty() && roughness.len() >= 2).then(|| Material {
        relief: relief.iter().map(|px| px.clamp(-RELIEF, RELIEF)).collect(),
        roughness: roughness.iter().map(|value| value.clamp(0.0, 1.0)).collect(),
        deep: *deep != 0.0,
        transparent: *clear != 0.0,
    })
}

fn outlines(entries: &Entries) -> Option<Outlines> {
    let [dxf, mm, fill, stroke, hatch, cut, ordered, level, spacing, angle, pen, width, area] =
        entries.numbers("export-outlines")?;
    let [dxf, mm, fill, stroke, hatch, cut, ordered] =
        [dxf, mm, fill, stroke, hatch, cut, ordered].map(|flag| flag != 0.0);
    Some(Outlines {
        dxf,
        level: level.clamp(0.01, 0.99),
        units: if mm { Units::Mm } else { Units::Px },
        fill,
        stroke,
        hatch,
        spacing: spacing.max(1e-3),
        angle,
        pen: pen.max(1e-3),
        width: width.max(0.0),
        area: area.max(0.0),
        cut,
        ordered,
    })
}

fn film(entries: &Entries) -> Option<Film> {
    let [kind, side, seconds, fps, once, hold] = entries.numbers("export-film")?;
    let clip = Clip {
        side: (side >= 16.0).then_some(side.min(8192.0) as u32),
        seconds: seconds.clamp(0.1, 600.0),
        fps: fps.clamp(1.0, 120.0) as u16,
        once: once != 0.0,
        hold: hold.clamp(0.0, 60.0),
    };
    Some(Film { kind: KINDS.get(kind as usize).copied().unwrap_or(Kind::Gif), change: false, to: None, clip })
}
