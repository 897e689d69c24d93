//! The options of a layer: one row each.

use egui::{ComboBox, DragValue, Label, Ui};

use super::{CONTROL, rosette, share, spread};
use crate::app::fields::reset;
use crate::app::units::number_field;
use crate::document::{
    DutyChoice, GapChoice, Layer, LayerOptions, OptionKey, Over, RaggedChoice, Seeding, limits,
};
use crate::editor::edit::Edit;
use crate::editor::layer_choices::option_refusal;
use crate::editor::session::Session;

pub(super) fn option(ui: &mut Ui, session: &Session, layer: &Layer, choice: OptionKey) -> Option<Edit> {
    let (name, help) = (label(choice), explanation(choice));
    let refused = option_refusal(layer, session.kind(session.active_layer), choice);
    let enabled = refused.is_none();
    let label = ui.add_enabled(enabled, Label::new(name)).on_hover_text(help);
    label.on_disabled_hover_text(refused.unwrap_or_default());
    let mut options = layer.options;
    let shown = ui.add_enabled_ui(enabled, |ui| control(ui, session, choice, &mut options)).inner;
    shown.on_hover_text(help).on_disabled_hover_text(refused.unwrap_or_default());
    if reset(ui, name, choice.is_default(&layer.options)) {
        choice.reset(&mut options);
    }
    ui.end_row();
    if choice == OptionKey::Spread {
        spread::numbers(ui, &mut options);
    }
    if choice == OptionKey::Rosette && enabled {
        rosette::numbers(ui, &mut options.rosette);
    }
    (options != layer.options).then_some(Edit::LayerOptions(session.active_layer, options))
}

/// The label of an option.
fn label(choice: OptionKey) -> &'static str {
    match choice {
        OptionKey::Spread => "Variation",
        OptionKey::Irregular => "Irregular",
        OptionKey::Keep => "Keep marks",
        OptionKey::Duty => "Stripe width",
        OptionKey::Seeding => "Starts from",
        OptionKey::Vary => "Varying",
        OptionKey::Double => "Doubled",
        OptionKey::Ragged => "Ragged",
        OptionKey::Detail => "Detail",
        OptionKey::Gap => "Lines",
        OptionKey::Rosette => "Rosettes",
        OptionKey::Over => "Crossings",
        OptionKey::Decay => "Decay",
        OptionKey::Broken => "Broken",
        OptionKey::Near => "Near",
    }
}

/// The tooltip of an option.
fn explanation(choice: OptionKey) -> &'static str {
    match choice {
        OptionKey::Spread => {
            "How much the spots differ from each other: as much as the drawn ones (at least six in a region), not at all, or as below"
        }
        OptionKey::Irregular => {
            "How irregular the shapes are: 0 % grows ellipses, 100 % beans, bars and drops. Only Turing's \
             spots have this option"
        }
        OptionKey::Keep => {
            "Whether the drawn marks themselves are part of the texture. The default is yes, but not with several regions"
        }
        OptionKey::Duty => {
            "Width of the stripes, as a share of the distance from one stripe to the next. As drawn: measured \
             on the drawn lines that lie side by side, for each region separately. 50 %: the stripes are as \
             wide as the gaps between them; below, down to 18 %, they are lines on wide \
             ground; above, up to 82 %, wide stripes with thin gaps"
        }
        OptionKey::Seeding => {
            "What the growth starts from. Noise: stripes follow the drawn directions closely. Segments: short \
             lines in the drawn direction, which grow into forked and wavy stripes. Drawn lines: stripes \
             spread from the lines that you drew"
        }
        OptionKey::Vary => {
            "How much the width of stripes varies along them, 0 % to 80 %: they swell and taper, and above 40 % end in points"
        }
        OptionKey::Double => "The share of the stripes that open into two thin ones, as on a tiger",
        OptionKey::Ragged => {
            "How ragged the edges are, 0 % to 50 %. As drawn: patches are as ragged as the drawn outlines \
             (ellipses are smooth); the edges of spots and stripes are not changed"
        }
        OptionKey::Detail => {
            "Number of points that make up a patch or a streak, 7 to 200. More points: a patch has finer \
             fringes, a streak is longer"
        }
        OptionKey::Gap => {
            "Width of the lines between cells. As drawn: the width of the gaps between drawn outlines that \
             nearly touch"
        }
        OptionKey::Rosette => {
            "The rims of patches break up into blotches around a tinted centre, as on leopards; dots inside, as on jaguars"
        }
        OptionKey::Over => {
            "Which threads lie on top where they cross. Level: none. Plain: over one, under one. Twill: over \
             two, under one or two. Random: by chance"
        }
        OptionKey::Decay => {
            "How far worms break up into dots: 0 % grows a maze of worms, 80 % dots and worms, 85 % hardly any worms"
        }
        OptionKey::Near => {
            "The distance from the marks beneath at which these marks are about a third as frequent as beside them"
        }
        OptionKey::Broken => {
            "The share of each ring that is left open, 0 to 60 %, in two to five gaps, as in the rosettes of a leopard"
        }
    }
}

fn control(ui: &mut Ui, session: &Session, choice: OptionKey, options: &mut LayerOptions) -> egui::Response {
    let name = label(choice);
    match choice {
        OptionKey::Irregular => share(ui, name, &mut options.irregular, &limits::IRREGULAR),
        OptionKey::Duty => duty(ui, name, &mut options.duty),
        OptionKey::Broken => share(ui, name, &mut options.broken, &limits::BROKEN),
        OptionKey::Near => {
            let limits::Range { low, high, .. } = limits::NEAR;
            let field = DragValue::new(&mut options.near).range(low..=high).speed(0.5).max_decimals(0);
            ui.add(number_field(field, " px")).accessible_name(name)
        }
        OptionKey::Keep => {
            let mut keep = session.document().keeps_marks(session.active_layer);
            let field = ui.checkbox(&mut keep, "as drawn").accessible_name(name);
            if field.changed() {
                options.keep = Some(keep);
            }
            field
        }
        OptionKey::Vary => share(ui, name, &mut options.vary, &limits::VARY),
        OptionKey::Double => share(ui, name, &mut options.double, &limits::DOUBLE),
        OptionKey::Ragged => ragged(ui, name, &mut options.ragged),
        OptionKey::Detail => {
            let limits::Range { low, high, .. } = limits::DETAIL;
            let field = DragValue::new(&mut options.detail).range(low..=high).speed(0.5).max_decimals(0);
            ui.add(field).accessible_name(name)
        }
        OptionKey::Gap => gap(ui, name, &mut options.gap),
        OptionKey::Rosette => rosette::choice(ui, &mut options.rosette),
        OptionKey::Over => over(ui, &mut options.over),
        OptionKey::Decay => share(ui, name, &mut options.decay, &limits::DECAY),
        OptionKey::Seeding => seeding(ui, &mut options.seeding),
        OptionKey::Spread => spread::choice(ui, &mut options.spread),
    }
}

fn duty(ui: &mut Ui, name: &str, duty: &mut DutyChoice) -> egui::Response {
    let choose = |ui: &mut Ui| {
        let mut drawn = *duty == DutyChoice::Drawn;
        let choice = ui.checkbox(&mut drawn, "as drawn").accessible_name(format!("{name} as drawn"));
        if choice.changed() {
            *duty = if drawn { DutyChoice::Drawn } else { DutyChoice::Given(LayerOptions::DUTY) };
        }
        match duty {
            DutyChoice::Drawn => choice,
            DutyChoice::Given(given) => choice.union(share(ui, name, given, &limits::DUTY)),
        }
    };
    ui.horizontal(choose).inner
}

fn ragged(ui: &mut Ui, name: &str, ragged: &mut RaggedChoice) -> egui::Response {
    /// The value that the field begins with: as ragged as the patches of a Holstein.
    const BEGIN: f64 = 0.2;
    let choose = |ui: &mut Ui| {
        let mut drawn = *ragged == RaggedChoice::Drawn;
        let choice = ui.checkbox(&mut drawn, "as drawn").accessible_name(format!("{name} as drawn"));
        if choice.changed() {
            *ragged = if drawn { RaggedChoice::Drawn } else { RaggedChoice::Given(BEGIN) };
        }
        match ragged {
            RaggedChoice::Drawn => choice,
            RaggedChoice::Given(sigma) => choice.union(share(ui, name, sigma, &limits::RAGGED)),
        }
    };
    ui.horizontal(choose).inner
}

fn gap(ui: &mut Ui, name: &str, gap: &mut GapChoice) -> egui::Response {
    /// The value that the field begins with, px.
    const BEGIN: f64 = 6.0;
    let choose = |ui: &mut Ui| {
        let mut drawn = *gap == GapChoice::Drawn;
        let choice = ui.checkbox(&mut drawn, "as drawn").accessible_name(format!("{name} as drawn"));
        if choice.changed() {
            *gap = if drawn { GapChoice::Drawn } else { GapChoice::Given(BEGIN) };
        }
        match gap {
            GapChoice::Drawn => choice,
            GapChoice::Given(px) => {
                let limits::Range { low, high, .. } = limits::GAP;
                let field = DragValue::new(px).range(low..=high).speed(0.1).max_decimals(1).suffix(" px");
                choice.union(ui.add(field).accessible_name(name))
            }
        }
    };
    ui.horizontal(choose).inner
}

fn over(ui: &mut Ui, over: &mut Over) -> egui::Response {
    const READ: [(&str, Over); 5] = [
        ("Level", Over::Level),
        ("Plain", Over::Plain),
        ("Twill 2/1", Over::Twill21),
        ("Twill 2/2", Over::Twill22),
        ("Random", Over::Random),
    ];
    let now = READ.iter().find(|(_, one)| one == over).map_or("", |(name, _)| *name);
    let combo = ComboBox::from_id_salt("over").selected_text(now).width(CONTROL).truncate();
    let combo = combo.show_ui(ui, |ui| {
        for (name, one) in READ {
            ui.selectable_value(over, one, name);
        }
    });
    combo.response.accessible_name("Crossings")
}

fn seeding(ui: &mut Ui, seeding: &mut Seeding) -> egui::Response {
    const READ: [(&str, Seeding); 3] =
        [("Noise", Seeding::Noise), ("Segments", Seeding::Segments), ("Drawn lines", Seeding::Initiators)];
    let now = READ.iter().find(|(_, one)| one == seeding).map_or("", |(name, _)| *name);
    let combo = ComboBox::from_id_salt("seeding").selected_text(now).width(CONTROL).truncate();
    let combo = combo.show_ui(ui, |ui| {
        for (name, one) in READ {
            ui.selectable_value(seeding, one, name);
        }
    });
    combo.response.accessible_name("Starts from")
}
