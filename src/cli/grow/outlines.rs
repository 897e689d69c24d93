//! The outlines of a growth: SVG and DXF.

use super::Args;
use crate::cli::{Error, values};
use crate::document::{Document, Extent, Layer, Stroke};
use crate::export::outline::svg::{self, Sheet, Unit};
use crate::export::outline::{Ends, FORMATS, Hatch, Smallest, Style, Travel, dxf};
use crate::export::{Stopped, has_ending};
use crate::files::{self, Prepared};
use crate::machine::free_memory;
use crate::marks::ellipse_of_outline;
use crate::synth::render::outlining::{Outlining, ground, outlines};
use crate::synth::{Grown, Watch, memory};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// Options for outlines.
#[derive(clap::Args, Clone, Debug, Default)]
#[command(next_help_heading = "Outlines (-o OUT.svg, -o OUT.dxf, --svg, --dxf)")]
pub struct OutlineArgs {
    /// Also write the outlines of the marks as SVG, one group for each layer
    #[arg(long, value_name = "OUT.svg")]
    pub svg: Option<PathBuf>,
    /// Also write the outlines of the marks as DXF (release 12), one DXF layer for each layer
    #[arg(long, value_name = "OUT.dxf")]
    pub dxf: Option<PathBuf>,
    /// The pattern value that outlines follow, above 0, below 1 [default: 0.5, the edge of the marks]
    #[arg(long, value_name = "P", value_parser = values::level)]
    pub level: Option<f64>,
    /// The unit of lengths in the file and in these options: mm (by the document's dpi) or px [default: mm]
    #[arg(long, value_name = "mm|px", value_parser = values::unit)]
    pub units: Option<values::Units>,
    /// fill, stroke, hatch:SPACING or hatch:SPACING:ANGLE (degrees); several with commas [default: fill]
    #[arg(long, value_name = "STYLE", value_delimiter = ',', value_parser = values::style)]
    pub style: Vec<values::StylePart>,
    /// Width of the strokes [default: 0.3 mm or 1 px]
    #[arg(long, value_name = "WIDTH", value_parser = values::positive)]
    pub pen: Option<f64>,
    /// Leave out islands and holes that are narrower
    #[arg(long, value_name = "WIDTH", value_parser = values::positive)]
    pub min_feature: Option<f64>,
    /// Leave out islands and holes of a smaller area (mm² or px²)
    #[arg(long, value_name = "AREA", value_parser = values::positive)]
    pub min_area: Option<f64>,
    /// Strokes of marks at the edge of the canvas: closed along it, or cut there [default: closed]
    #[arg(long, value_name = "closed|cut", value_parser = values::ends)]
    pub edges: Option<Ends>,
    /// Put a rectangle in the colour of the ground under the outlines of an SVG
    #[arg(long)]
    pub ground: bool,
    /// Draw paths in the order in which they are found, instead of searching for a short route
    #[arg(long)]
    pub no_order: bool,
}

impl OutlineArgs {
    /// The first given option for outlines.
    fn given(&self) -> Option<&'static str> {
        let given = [
            ("--level", self.level.is_some()),
            ("--units", self.units.is_some()),
            ("--style", !self.style.is_empty()),
            ("--pen", self.pen.is_some()),
            ("--min-feature", self.min_feature.is_some()),
            ("--min-area", self.min_area.is_some()),
            ("--edges", self.edges.is_some()),
            ("--ground", self.ground),
            ("--no-order", self.no_order),
        ];
        given.into_iter().find_map(|(name, given)| given.then_some(name))
    }

    /// The width of the pen in this unit.
    fn pen(&self, unit: Unit) -> f64 {
        self.pen.unwrap_or(unit.stroke())
    }

    fn style(&self, unit: Unit) -> Style {
        let a_unit = 1.0 / unit.per_px();
        let mut style = Style {
            fill: self.style.is_empty(),
            pen: self.pen(unit) * a_unit,
            ends: self.edges.unwrap_or_default(),
            ordered: !self.no_order,
            ..Style::default()
        };
        for part in &self.style {
            match *part {
                values::StylePart::Fill => style.fill = true,
                values::StylePart::Stroke => style.stroke = true,
                values::StylePart::Hatch { spacing, angle } => {
                    style.hatch = Some(Hatch { spacing: spacing * a_unit, angle });
                }
            }
        }
        style
    }

    fn unit(&self, dpi: f64) -> Unit {
        match self.units {
            Some(values::Units::Px) => Unit::Px,
            Some(values::Units::Mm) | None => Unit::Mm { dpi },
        }
    }
}

/// Whether a file is one of outlines, not a picture.
pub fn holds_outlines(path: &Path) -> bool {
    FORMATS.iter().any(|ending| has_ending(path, ending))
}

/// The requested files of outlines.
pub fn files(args: &Args) -> Vec<&Path> {
    let output = args.output.as_ref().filter(|path| holds_outlines(path));
    output.into_iter().chain(&args.outlines.svg).chain(&args.outlines.dxf).map(PathBuf::as_path).collect()
}

/// Whether outlines are requested.
pub fn requested(args: &Args) -> bool {
    !files(args).is_empty()
}

/// Checks the options before anything grows.
pub fn check(args: &Args, document: &Document, extent: Extent) -> Result<(), Error> {
    let OutlineArgs { svg, dxf, edges, .. } = &args.outlines;
    for (path, ending) in [(svg, "svg"), (dxf, "dxf")] {
        if let Some(path) = path {
            files::check_ending(path, &[ending]).map_err(Error::step)?;
        }
    }
    if !requested(args) {
        return match args.outlines.given() {
            Some(option) => Err(Error::Usage(format!(
                "{option}: found without outlines; allowed: with --svg, --dxf or -o OUT.svg"
            ))),
            None => Ok(()),
        };
    }
    let scale = f64::from(extent.scale);
    let unit = args.outlines.unit(document.dpi * scale);
    let style = args.outlines.style(unit);
    if style.fill && *edges == Some(Ends::Cut) {
        let allowed = "allowed: --edges cut with --style stroke or hatch:SPACING";
        return Err(Error::Usage(format!(
            "--edges: found cut with filled areas, which must be closed; {allowed}"
        )));
    }
    match style.hatch {
        Some(hatch) if hatch.spacing < Hatch::FINEST => {
            let (least, name) = (Hatch::FINEST * unit.per_px(), unit.name());
            Err(Error::Usage(format!(
                "--style: found a hatch spacing of {:.3} {name}; allowed: at least {least:.3} {name}, {} px of {}",
                hatch.spacing * unit.per_px(),
                Hatch::FINEST,
                args.file.display()
            )))
        }
        Some(hatch) => {
            let size = extent.size.unwrap_or(document.size).map(f64::from);
            // Px of the canvas.
            let each = document.layers.iter().map(|layer| strokes(layer, size, hatch.spacing / scale));
            let needed = BYTES_PER_STROKE * each.sum::<f64>();
            memory::check_export(
                "so dense a hatch",
                needed,
                "hatch with a larger spacing",
                Some(free_memory()),
            )
            .map_err(Error::step)
        }
        None => Ok(()),
    }
}

/// Bytes for each stroke of a hatch while its route is searched for: three times the path, its possible starts, and its
/// visit. Measured: 490, with 1.4 million strokes on 4096² px.
const BYTES_PER_STROKE: f64 = 700.0;

/// Estimated number of hatch strokes in the marks of a layer; lengths are px of the canvas. The estimate assumes that
/// marks cover at most half of the canvas, and that strokes are on average at least as long as the narrowest drawn mark
/// is wide.
fn strokes(layer: &Layer, size: [f64; 2], spacing: f64) -> f64 {
    let widths = layer.strokes.iter().map(|stroke| match stroke {
        Stroke::Ellipse(ellipse) | Stroke::Fitted { ellipse, .. } => {
            2.0 * ellipse.radii[0].min(ellipse.radii[1])
        }
        Stroke::Line(line) => line.width,
        Stroke::Path(path) => path.width,
        Stroke::Freehand { width, .. } => *width,
        Stroke::Outline(outline) => {
            ellipse_of_outline(&outline.points).map_or(0.0, |ellipse| 2.0 * ellipse.radii[1])
        }
    });
    let narrowest = widths.fold(f64::MAX, f64::min).max(1.0);
    0.5 * size[0] * size[1] / (spacing * narrowest)
}

/// The distance that the pen moves to draw the outlines.
pub struct Drawn {
    unit: Unit,
    travel: Travel,
}

/// The outlines' entry in the report: lengths in `unit`.
#[derive(Serialize)]
pub struct OutlineReport {
    paths: usize,
    unit: &'static str,
    pen_down: f64,
    pen_up: f64,
    pen_up_unordered: f64,
}

impl Drawn {
    /// One line for a terminal.
    pub fn text(&self) -> String {
        self.travel.text(self.unit)
    }

    /// The entry of the report.
    pub fn report(&self) -> OutlineReport {
        let length = |px: f64| px * self.unit.per_px();
        let Travel { paths, down, up, up_unordered } = self.travel;
        OutlineReport {
            paths,
            unit: self.unit.name(),
            pen_down: length(down),
            pen_up: length(up),
            pen_up_unordered: length(up_unordered),
        }
    }
}

/// Writes the requested outlines under temporary names.
pub fn prepare(
    args: &Args,
    document: &Document,
    grown: &Grown,
    extent: Extent,
    watch: &Watch,
) -> Result<Option<(Vec<Prepared>, Drawn)>, Error> {
    let files = files(args);
    let Some(first) = files.first() else { return Ok(None) };
    let size = grown.size.map(|side| side as usize * extent.scale as usize);
    let unit = args.outlines.unit(document.dpi * f64::from(extent.scale));
    let a_unit = 1.0 / unit.per_px();
    let wanted = Outlining {
        size,
        level: args.outlines.level.unwrap_or(0.5),
        only: args.layer.map(|layer| layer as usize - 1),
        smallest: Smallest {
            width: args.outlines.min_feature.unwrap_or(0.0) * a_unit,
            area: args.outlines.min_area.unwrap_or(0.0) * a_unit * a_unit,
        },
        style: args.outlines.style(unit),
    };
    let stopped = |stopped| match stopped {
        Stopped::Cancelled => Error::Interrupted,
        Stopped::Io(source) => Error::File { file: first.display().to_string(), done: "written", source },
    };
    let (groups, travel) = outlines(document, grown, &wanted, watch).map_err(stopped)?;
    let size = size.map(|side| side as f64);
    let sheet = Sheet {
        title: document.name.clone(),
        size,
        unit,
        stroke_width: args.outlines.pen(unit),
        ground: args.outlines.ground.then(|| ground(document)),
    };
    let write = |path: &&Path| {
        files::prepare(path, |out| {
            // Standard output has no ending that could name a format.
            if has_ending(path, "dxf")
                || !has_ending(path, "svg") && args.outlines.dxf.as_deref() == Some(*path)
            {
                dxf::write(out, size, unit, &groups)?;
            } else {
                svg::write(out, &sheet, &groups)?;
            }
            Ok(())
        })
    };
    let prepared = files.iter().map(write).collect::<Result<_, _>>().map_err(Error::exported)?;
    Ok(Some((prepared, Drawn { unit, travel })))
}
