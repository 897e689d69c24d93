//! Colours, sizes and type of the window, light and dark.

use egui::{
    Color32, Context, CornerRadius, FontFamily, FontId, Margin, Shadow, Stroke, Style, TextStyle, Theme,
    Visuals, vec2,
};

/// The colours beyond those of egui's style.
#[derive(Clone, Copy, Debug)]
pub struct Palette {
    /// The background of canvas and texture.
    pub background: Color32,
    /// The canvas.
    pub paper: Color32,
    /// The canvas' border.
    pub border: Color32,
    /// Marks, by layer.
    pub inks: [Color32; 4],
    /// A freehand stroke.
    pub pen: Color32,
    /// Selected or active things.
    pub accent: Color32,
    /// Selected or active things, paler.
    pub accent_pale: Color32,
    /// The region grid.
    pub grid: Color32,
    /// Lines between neighbours that count for the spacing.
    pub edge: Color32,
    /// Lines between neighbours that do not count.
    pub edge_pale: Color32,
    /// Axes of fitted marks.
    pub axis: Color32,
    /// Errors.
    pub wrong: Color32,
}

const LIGHT: Palette = Palette {
    background: Color32::from_rgb(0xe4, 0xe1, 0xdb),
    paper: Color32::from_rgb(0xfd, 0xfc, 0xf9),
    border: Color32::from_rgb(0xc9, 0xc4, 0xba),
    inks: [
        Color32::from_rgb(0x3c, 0x36, 0x30),
        Color32::from_rgb(0x9a, 0x4b, 0x27),
        Color32::from_rgb(0x2f, 0x5d, 0x7c),
        Color32::from_rgb(0x5d, 0x6b, 0x2b),
    ],
    pen: Color32::from_rgb(0x1b, 0x6f, 0x6a),
    accent: Color32::from_rgb(0x12, 0x7a, 0x74),
    accent_pale: Color32::from_rgb(0x9c, 0xc4, 0xc0),
    grid: Color32::from_rgb(0xd3, 0xce, 0xc4),
    edge: Color32::from_rgb(0x2f, 0x6f, 0xb4),
    edge_pale: Color32::from_rgb(0xb9, 0xcd, 0xe2),
    axis: Color32::from_rgb(0xc2, 0x5a, 0x1e),
    wrong: Color32::from_rgb(0xa8, 0x32, 0x1f),
};

const DARK: Palette = Palette {
    background: Color32::from_rgb(0x18, 0x18, 0x19),
    paper: Color32::from_rgb(0x2a, 0x2a, 0x2b),
    border: Color32::from_rgb(0x43, 0x43, 0x45),
    inks: [
        Color32::from_rgb(0xe8, 0xe3, 0xda),
        Color32::from_rgb(0xe5, 0x96, 0x6b),
        Color32::from_rgb(0x7f, 0xb4, 0xd8),
        Color32::from_rgb(0xb6, 0xc6, 0x75),
    ],
    pen: Color32::from_rgb(0x62, 0xcf, 0xc6),
    accent: Color32::from_rgb(0x4f, 0xc0, 0xb6),
    accent_pale: Color32::from_rgb(0x2d, 0x68, 0x63),
    grid: Color32::from_rgb(0x44, 0x44, 0x47),
    edge: Color32::from_rgb(0x6f, 0xad, 0xec),
    edge_pale: Color32::from_rgb(0x38, 0x50, 0x68),
    axis: Color32::from_rgb(0xe8, 0x8b, 0x4e),
    wrong: Color32::from_rgb(0xef, 0x83, 0x6e),
};

impl Palette {
    /// The colours of the current theme.
    #[must_use]
    pub fn current(visuals: &Visuals) -> &'static Self {
        if visuals.dark_mode { &DARK } else { &LIGHT }
    }

    /// The ink of a layer.
    #[must_use]
    pub fn ink(&self, layer: usize) -> Color32 {
        self.inks[layer % self.inks.len()]
    }
}

/// Sets fonts, sizes and colours of both themes.
pub fn apply(ctx: &Context) {
    for theme in [Theme::Light, Theme::Dark] {
        ctx.style_mut_of(theme, |style| {
            sizes(style);
            match theme {
                Theme::Light => light(&mut style.visuals),
                Theme::Dark => dark(&mut style.visuals),
            }
        });
    }
}

fn sizes(style: &mut Style) {
    let font = |size| FontId::new(size, FontFamily::Proportional);
    style.text_styles.insert(TextStyle::Body, font(13.5));
    style.text_styles.insert(TextStyle::Button, font(13.5));
    style.text_styles.insert(TextStyle::Small, font(11.5));
    style.text_styles.insert(TextStyle::Heading, font(19.0));
    let spacing = &mut style.spacing;
    spacing.item_spacing = vec2(8.0, 7.0);
    spacing.button_padding = vec2(9.0, 4.0);
    spacing.interact_size = vec2(36.0, 24.0);
    spacing.menu_margin = Margin::same(6);
    spacing.slider_width = 120.0;
    spacing.tooltip_width = 280.0;
    // A wider bar covers the buttons at the ends of rows, which restore defaults.
    spacing.scroll.bar_width = 6.0;
    style.interaction.tooltip_delay = 0.4;
}

fn shared(visuals: &mut Visuals, palette: &Palette) {
    let round = CornerRadius::same(5);
    let widgets = &mut visuals.widgets;
    for widget in [
        &mut widgets.noninteractive,
        &mut widgets.inactive,
        &mut widgets.hovered,
        &mut widgets.active,
        &mut widgets.open,
    ] {
        widget.corner_radius = round;
        widget.expansion = 0.0;
    }
    visuals.window_corner_radius = CornerRadius::same(9);
    visuals.menu_corner_radius = CornerRadius::same(7);
    visuals.window_shadow =
        Shadow { offset: [0, 8], blur: 28, spread: 0, color: Color32::from_black_alpha(50) };
    visuals.popup_shadow =
        Shadow { offset: [0, 4], blur: 14, spread: 0, color: Color32::from_black_alpha(40) };
    visuals.selection.bg_fill = palette.accent;
    visuals.selection.stroke = Stroke::new(1.0, Color32::WHITE);
    visuals.hyperlink_color = palette.accent;
    visuals.slider_trailing_fill = true;
    visuals.error_fg_color = palette.wrong;
}

fn light(visuals: &mut Visuals) {
    shared(visuals, &LIGHT);
    // Darker than the accent, because text needs more contrast.
    visuals.hyperlink_color = Color32::from_rgb(0x0d, 0x69, 0x63);
    let ink = Color32::from_rgb(0x2e, 0x2a, 0x26);
    visuals.panel_fill = Color32::from_rgb(0xf4, 0xf2, 0xee);
    visuals.window_fill = Color32::from_rgb(0xfa, 0xf9, 0xf6);
    visuals.extreme_bg_color = Color32::from_rgb(0xff, 0xfe, 0xfc);
    visuals.faint_bg_color = Color32::from_rgb(0xec, 0xe9, 0xe3);
    visuals.window_stroke = Stroke::new(1.0, LIGHT.border);
    visuals.weak_text_color = Some(Color32::from_rgb(0x62, 0x5c, 0x54));
    let widgets = &mut visuals.widgets;
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, Color32::from_rgb(0xdd, 0xd9, 0xd1));
    widgets.noninteractive.fg_stroke = Stroke::new(1.0, ink);
    widgets.inactive.weak_bg_fill = Color32::from_rgb(0xe8, 0xe5, 0xdf);
    widgets.inactive.bg_fill = Color32::from_rgb(0xd3, 0xcd, 0xc2);
    widgets.inactive.fg_stroke = Stroke::new(1.0, ink);
    widgets.hovered.weak_bg_fill = Color32::from_rgb(0xdd, 0xd9, 0xd1);
    widgets.hovered.bg_stroke = Stroke::new(1.0, LIGHT.border);
    widgets.active.weak_bg_fill = Color32::from_rgb(0xda, 0xd6, 0xcd);
}

fn dark(visuals: &mut Visuals) {
    shared(visuals, &DARK);
    visuals.selection.stroke = Stroke::new(1.0, Color32::from_rgb(0x0e, 0x1c, 0x1b));
    let ink = Color32::from_rgb(0xdc, 0xd9, 0xd4);
    visuals.panel_fill = Color32::from_rgb(0x22, 0x22, 0x23);
    visuals.window_fill = Color32::from_rgb(0x29, 0x29, 0x2b);
    visuals.extreme_bg_color = Color32::from_rgb(0x19, 0x19, 0x1a);
    visuals.faint_bg_color = Color32::from_rgb(0x2b, 0x2b, 0x2d);
    visuals.window_stroke = Stroke::new(1.0, DARK.border);
    visuals.weak_text_color = Some(Color32::from_rgb(0xa8, 0xa5, 0x9f));
    let widgets = &mut visuals.widgets;
    widgets.noninteractive.bg_stroke = Stroke::new(1.0, Color32::from_rgb(0x36, 0x36, 0x38));
    widgets.noninteractive.fg_stroke = Stroke::new(1.0, ink);
    widgets.inactive.weak_bg_fill = Color32::from_rgb(0x33, 0x33, 0x35);
    widgets.inactive.bg_fill = Color32::from_rgb(0x48, 0x48, 0x4c);
    widgets.inactive.fg_stroke = Stroke::new(1.0, ink);
    widgets.hovered.weak_bg_fill = Color32::from_rgb(0x38, 0x38, 0x3b);
    widgets.hovered.bg_stroke = Stroke::new(1.0, DARK.border);
    widgets.active.weak_bg_fill = Color32::from_rgb(0x3b, 0x3b, 0x3e);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Relative luminance, by the definition of WCAG 2.2.
    fn luminance(colour: Color32) -> f64 {
        let linear = |channel: u8| {
            let share = f64::from(channel) / 255.0;
            if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * linear(colour.r()) + 0.7152 * linear(colour.g()) + 0.0722 * linear(colour.b())
    }

    fn contrast(a: Color32, b: Color32) -> f64 {
        let [a, b] = [a, b].map(|colour| luminance(colour) + 0.05);
        a.max(b) / a.min(b)
    }

    #[test]
    fn every_text_is_at_least_4_5_times_as_bright_or_dark_as_its_ground() {
        let ctx = Context::default();
        apply(&ctx);
        for theme in [Theme::Light, Theme::Dark] {
            let visuals = &ctx.style_of(theme).visuals;
            let palette = Palette::current(visuals);
            let widgets = &visuals.widgets;
            let grounds = [
                ("panel", visuals.panel_fill),
                ("window", visuals.window_fill),
                ("field", visuals.extreme_bg_color),
                ("row", visuals.faint_bg_color),
                ("canvas", palette.background),
            ];
            let texts = [
                ("text", visuals.text_color()),
                ("muted text", visuals.weak_text_color()),
                ("error", palette.wrong),
                ("link", visuals.hyperlink_color),
            ];
            for (ground, fill) in grounds {
                for (text, colour) in texts {
                    let found = contrast(colour, fill);
                    assert!(found >= 4.5, "{theme:?}: {text} on {ground}: {found:.2}");
                }
            }
            for (name, widget) in [
                ("button", &widgets.inactive),
                ("button under the pointer", &widgets.hovered),
                ("pressed button", &widgets.active),
            ] {
                for (text, colour) in
                    [("text", widget.text_color()), ("muted text", visuals.weak_text_color())]
                {
                    let found = contrast(colour, widget.weak_bg_fill);
                    assert!(found >= 4.5, "{theme:?}: {text} on {name}: {found:.2}");
                }
            }
            let found = contrast(visuals.selection.stroke.color, visuals.selection.bg_fill);
            assert!(found >= 4.5, "{theme:?}: selected: {found:.2}");
        }
    }
}
