//! Texts about attributes that cannot be grown, with lengths in the user's unit.

use crate::attributes::{Attribute, Attributes};
use crate::editor::units::Ruler;
use crate::learn::{Note, Quantity};

/// What a note says, for marks with the attributes `asked`, with its remedy.
pub fn in_words(note: &Note, asked: &Attributes, ruler: Ruler) -> String {
    match note {
        Note::Beyond { asked: wanted, reached, .. } => match (wanted.attribute, asked) {
            (Attribute::Spacing, Attributes::Spots(spots)) => {
                let [drawn, possible] = [wanted.value, reached.value].map(|length| ruler.rough(length));
                // The distance at which round spots of this size touch.
                let touching = 2.0 * (spots.area / std::f64::consts::PI).sqrt();
                let problem = match wanted.value {
                    apart if apart > reached.value => "Spots are too far apart",
                    apart if apart < touching => "Spots overlap",
                    _ => "Spots are too near to each other",
                };
                format!("{problem}: at this size their centres need about {possible}, you drew {drawn}.")
            }
            (Attribute::Duty, _) => format!(
                "Stripes cannot be as wide as {:.0} % of the distance from one to the next; they will be {:.0} %.",
                100.0 * wanted.value,
                100.0 * reached.value
            ),
            (attribute, _) => {
                let (largest, name) = (wanted.value > reached.value, name(attribute));
                let side = if largest { "largest" } else { "smallest" };
                format!(
                    "{name} {} cannot be grown. The {side} possible is {}.",
                    number(wanted, ruler),
                    number(reached, ruler)
                )
            }
        },
        Note::Together { asked, reached } => {
            let list = |all: &[Quantity]| {
                let each = all
                    .iter()
                    .map(|one| format!("{} {}", name(one.attribute).to_lowercase(), number(one, ruler)));
                each.collect::<Vec<_>>().join(", ")
            };
            format!(
                "These cannot be grown together: {}. The nearest possible: {}.",
                list(asked),
                list(reached)
            )
        }
        other => format!("{other}."),
    }
}

fn name(attribute: Attribute) -> &'static str {
    match attribute {
        Attribute::Area => "Area",
        Attribute::Aspect => "Aspect",
        Attribute::Width => "Width",
        Attribute::Angle => "Direction",
        Attribute::Duty => "Stripe width (share of the period)",
        Attribute::Spacing => "Spacing",
        other => other.name(),
    }
}

fn number(quantity: &Quantity, ruler: Ruler) -> String {
    match quantity.attribute {
        Attribute::Area => ruler.area(quantity.value),
        Attribute::Width | Attribute::Spacing => ruler.length(quantity.value),
        Attribute::Angle => format!("{:.0}°", quantity.value),
        Attribute::Duty => format!("{:.0} %", 100.0 * quantity.value),
        _ => format!("{:.2}", quantity.value),
    }
}
