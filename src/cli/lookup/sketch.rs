//! A sketch that is equivalent to a question about a system of pairs.

use super::Args;
use super::answer::brief;
use crate::attributes::Stripes;
use crate::attributes::direction_groups::{CROSSING, SAME};
use crate::cli::Error;
use crate::document::limits;
use crate::document::{Document, DutyChoice, Layer, LayerOptions, PairKind, Stroke, SystemChoice};
use crate::marks::axial;
use crate::rd::pairs::Threads;
use crate::synth::pairs::plan::least_between;
use crate::synth::pairs::plan::thread_map::OWN_DUTY;
use crate::synth::side_by_side;

/// Limits of the sides of its canvas, px. The smallest side is used where a smaller one would be enough.
const SIDES: [f64; 2] = [64.0, limits::MAX_SIDE as f64];
/// Length of the pieces of a maze ÷ period, where none is given.
const LONG: f64 = 4.0;

/// The side of a canvas, px, on which the length with this `name`, px, fits `times` times.
///
/// # Errors
/// [`Error::Usage`] where there is no such canvas; `key` is the option that asks for the length.
pub fn side(key: &str, name: &str, times: f64, length: f64) -> Result<f64, Error> {
    let [least, most] = SIDES;
    if times * length > most {
        let (found, most) = (brief(length), brief(most / times));
        return Err(Error::Usage(format!(
            "{key}: found a {name} of {found} px; allowed: at most {most} px, of which {times:.0} fit on the largest canvas"
        )));
    }
    Ok((times * length).max(least))
}

/// The document, if it could be drawn.
///
/// # Errors
///
/// [`Error::Usage`] with what is out of range: a mark that is too small or too large.
pub fn checked(document: Document) -> Result<Document, Error> {
    let source = "the sketch for the question";
    document.check(source).map_err(|error| Error::Usage(error.to_string()))?;
    Ok(document)
}

/// Lines of one direction.
pub struct Direction {
    /// Direction, degrees.
    pub angle: f64,
    /// Width and period, px.
    pub threads: Threads,
    /// Whether the period was asked for. It follows from a duty; where no duty is given, the usual period is used.
    pub asks_period: bool,
}

/// The directions that the arguments ask for.
///
/// # Errors
/// [`Error::Usage`] where two of them are so similar that they count as one.
pub fn directions(kind: PairKind, first: Stripes, args: &Args) -> Result<Vec<Direction>, Error> {
    let usual = match kind {
        PairKind::Weave => OWN_DUTY[usize::from(args.across.len() > 1)],
        _ => LayerOptions::DUTY,
    };
    let direction = |angle: f64, width: f64, duty: Option<f64>| {
        let threads = Threads { width, period: width / duty.unwrap_or(usual) };
        Direction { angle, threads, asks_period: duty.is_some() }
    };
    let across = args.across.iter().map(|across| {
        direction(axial(across.angle), across.width.unwrap_or(first.width), across.duty.or(args.duty))
    });
    let all: Vec<_> = std::iter::once(direction(first.angle, first.width, args.duty)).chain(across).collect();
    let alike = if kind == PairKind::Maze { SAME } else { CROSSING };
    if least_between(&all.iter().map(|of| of.angle).collect::<Vec<_>>()) <= alike {
        return Err(Error::Usage(format!(
            "--across: directions that differ by {alike}° or less count as one; allowed: more"
        )));
    }
    Ok(all)
}

/// Two lines side by side of each direction.
pub fn document(kind: PairKind, all: &[Direction], side: f64, args: &Args) -> Document {
    let long = match kind {
        PairKind::Maze => args.long.unwrap_or(LONG * all[0].threads.period),
        _ => 0.6 * side,
    };
    let strokes: Vec<Stroke> = match kind {
        PairKind::Stucco => vec![Stroke::ellipse([0.5 * side; 2], [0.5 * all[0].threads.width; 2], 0.0)],
        _ => all.iter().flat_map(|of| side_by_side([0.5 * side; 2], of.angle, of.threads, long)).collect(),
    };
    let usual = LayerOptions::default();
    let options = LayerOptions {
        decay: args.decay.unwrap_or(usual.decay),
        duty: match args.duty {
            // All directions have the same duty.
            Some(duty)
                if kind != PairKind::Weave && args.across.iter().all(|across| across.duty.is_none()) =>
            {
                DutyChoice::Given(duty)
            }
            _ => DutyChoice::Drawn,
        },
        ..usual
    };
    let layer = Layer::new(strokes).with_system(SystemChoice::Of(kind.description())).with_options(options);
    Document::new([side.round() as u32; 2]).with_layer(layer)
}
