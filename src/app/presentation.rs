//! Which parts of the window are shown: on the web a page of others can show less of it.

/// Which parts of the window are shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Presentation {
    /// All.
    #[default]
    Full,
    /// Sketch and texture without panels, for a frame in a page of others.
    Embedded,
    /// The texture alone. Nothing can be drawn.
    Texture,
}

impl Presentation {
    /// The presentation that the query of an address asks for: all parts, unless it is `?embed` or `?view`.
    #[must_use]
    pub fn of_query(query: &str) -> Self {
        let mut switches = query.trim_start_matches('?').split('&').filter_map(|part| part.split('=').next());
        let named = |switch: &str| match switch {
            "embed" => Some(Self::Embedded),
            "view" => Some(Self::Texture),
            _ => None,
        };
        switches.find_map(named).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::Presentation;

    #[test]
    fn the_first_switch_of_a_query_that_is_known_counts() {
        let cases = [
            ("", Presentation::Full),
            ("?", Presentation::Full),
            ("?embedded", Presentation::Full),
            ("?embed", Presentation::Embedded),
            ("?a=b&view=1", Presentation::Texture),
            ("view&embed", Presentation::Texture),
        ];
        for (query, asked) in cases {
            assert_eq!(Presentation::of_query(query), asked, "{query}");
        }
    }
}
