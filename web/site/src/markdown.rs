//! Markdown → HTML, with the anchors that GitHub gives to headings.

use std::collections::HashMap;

use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

/// A page.
pub struct Page {
    /// The text of its first heading.
    pub title: String,
    /// The text of its first paragraph.
    pub summary: String,
    /// Its content.
    pub html: String,
}

/// Renders a text. `place` returns the target on the site for a link or a picture in the text.
pub fn render<E>(text: &str, mut place: impl FnMut(&str) -> Result<String, E>) -> Result<Page, E> {
    let options = Options::ENABLE_TABLES | Options::ENABLE_STRIKETHROUGH | Options::ENABLE_FOOTNOTES;
    let mut events: Vec<Event> = Parser::new_ext(text, options).collect();
    for event in &mut events {
        if let Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) = event {
            *dest_url = place(dest_url)?.into();
        }
    }
    anchor_headings(&mut events);
    let title = words(&events, |tag| matches!(tag, Tag::Heading { level: HeadingLevel::H1, .. }));
    let summary = words(&events, |tag| matches!(tag, Tag::Paragraph));
    let mut html = String::new();
    html::push_html(&mut html, events.into_iter().flat_map(scrolled));
    Ok(Page { title, summary, html })
}

/// Tables get a scroll bar on narrow screens, and pictures load only when they are close to being visible.
fn scrolled(event: Event) -> Vec<Event> {
    match event {
        Event::Start(Tag::Table(_)) => vec![Event::Html("<div class=\"wide\">".into()), event],
        Event::End(TagEnd::Table) => vec![event, Event::Html("</div>".into())],
        event => vec![event],
    }
}

fn anchor_headings(events: &mut [Event]) {
    let mut seen: HashMap<String, usize> = HashMap::new();
    for start in 0..events.len() {
        if !matches!(events[start], Event::Start(Tag::Heading { .. })) {
            continue;
        }
        let anchor = anchor(&text_from(events, start));
        let times = seen.entry(anchor.clone()).or_default();
        let own = if *times == 0 { anchor } else { format!("{anchor}-{times}") };
        *times += 1;
        if let Event::Start(Tag::Heading { id, .. }) = &mut events[start] {
            *id = Some(own.into());
        }
    }
}

/// The anchor that GitHub makes of a heading: small letters, no punctuation, hyphens for spaces.
fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase();
    let kept = kept.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.map(|c| if c == ' ' { '-' } else { c }).collect()
}

/// The text of the first element whose tag fulfils `is`.
fn words(events: &[Event], is: impl Fn(&Tag) -> bool) -> String {
    let start = events.iter().position(|event| matches!(event, Event::Start(tag) if is(tag)));
    start.map(|start| text_from(events, start)).unwrap_or_default()
}

/// The text of the element that begins with this event.
fn text_from(events: &[Event], start: usize) -> String {
    let mut depth = 0;
    let mut text = String::new();
    for event in &events[start..] {
        match event {
            Event::Start(_) => depth += 1,
            Event::End(_) => depth -= 1,
            Event::Text(part) | Event::Code(part) => text.push_str(part),
            Event::SoftBreak | Event::HardBreak => text.push(' '),
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_have_the_anchors_of_github() {
        let text = "# A `b`, c-d\n\nFirst *words*.\n\n## Same\n\n## Same\n";
        let page = render(text, |link| Ok::<_, ()>(link.to_owned())).unwrap();
        assert_eq!((page.title.as_str(), page.summary.as_str()), ("A b, c-d", "First words."));
        for id in ["id=\"a-b-c-d\"", "id=\"same\"", "id=\"same-1\""] {
            assert!(page.html.contains(id), "{}", page.html);
        }
    }

    #[test]
    fn links_are_placed_and_tables_scroll() {
        let page = render("[a](b.md)\n\n|a|\n|-|\n|![c](d.png)|\n", |link| Ok::<_, ()>(format!("x/{link}")))
            .unwrap();
        for part in ["href=\"x/b.md\"", "src=\"x/d.png\"", "<div class=\"wide\"><table>"] {
            assert!(page.html.contains(part), "{}", page.html);
        }
    }
}
