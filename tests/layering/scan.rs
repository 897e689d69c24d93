//! Reads Rust source far enough to list the paths that it names: comments and literals are skipped, `use` trees
//! are expanded, `self`, `super` and names that the file imports are followed.

use std::collections::BTreeMap;

use proc_macro2::{Delimiter, Spacing, TokenStream, TokenTree};

/// A path that a source file names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Named {
    /// The number of the line, counted from 1.
    pub line: usize,
    /// The path from the root of the crate (`crate`, room, …), or from an external package (its name, …).
    pub path: Vec<String>,
    /// Whether the path is in a module called `tests`.
    pub in_tests: bool,
}

#[derive(Clone, Debug)]
struct Token {
    line: usize,
    /// A word, `::`, or one sign.
    text: String,
}

impl Token {
    fn is_word(&self) -> bool {
        self.text.starts_with(|c: char| c.is_alphabetic() || c == '_')
    }
}

/// The paths that a source file names.
#[derive(Debug)]
pub struct Scan {
    /// Every path of two or more names, and every `use`.
    pub paths: Vec<Named>,
    /// Names that a `mod` or a `use` outside tests brings in, with the full path of each.
    pub bound: BTreeMap<String, Vec<String>>,
}

/// Scans a file that is the module `module` (`[]` = the root).
pub fn scan(source: &str, module: &[&str]) -> Scan {
    let mut reader = Reader {
        tokens: tokens(source),
        at: 0,
        module: module.iter().map(|&name| name.to_owned()).collect(),
        inline: Vec::new(),
        depth: 0,
        bound: BTreeMap::new(),
        found: Vec::new(),
    };
    reader.read();
    let Reader { bound: all, mut found, .. } = reader;
    let expanded = |path: &[String]| -> Option<Vec<String>> {
        let stands_for = all.get(&path[0]).filter(|stands_for| stands_for[0] == "crate")?;
        Some(stands_for.iter().chain(&path[1..]).cloned().collect())
    };
    // A name that the file binds to an item of the crate is not a package, even if a package has the same name.
    for named in &mut found {
        if let Some(full) = expanded(&named.path) {
            named.path = full;
        }
    }
    let bound = all.iter().map(|(name, path)| (name.clone(), expanded(path).unwrap_or_else(|| path.clone())));
    Scan { bound: bound.filter(|(_, path)| path[0] == "crate").collect(), paths: found }
}

/// The words of a file with their lines, without comments and literals.
pub fn words(source: &str) -> impl Iterator<Item = (usize, String)> {
    tokens(source).into_iter().filter(Token::is_word).map(|token| (token.line, token.text))
}

struct Reader {
    tokens: Vec<Token>,
    at: usize,
    module: Vec<String>,
    /// Depth of braces at which each inline module began.
    inline: Vec<usize>,
    depth: usize,
    /// Names that a `mod` or a `use` brought in, each with its path.
    bound: BTreeMap<String, Vec<String>>,
    found: Vec<Named>,
}

impl Reader {
    fn text(&self, ahead: usize) -> &str {
        self.tokens.get(self.at + ahead).map_or("", |token| &token.text)
    }

    fn word(&self, ahead: usize) -> bool {
        self.tokens.get(self.at + ahead).is_some_and(Token::is_word)
    }

    fn read(&mut self) {
        while self.at < self.tokens.len() {
            match self.text(0) {
                "{" => self.depth += 1,
                "}" => {
                    self.depth = self.depth.saturating_sub(1);
                    if self.inline.last() == Some(&self.depth) {
                        self.inline.pop();
                        self.module.pop();
                    }
                }
                "mod" if self.word(1) => {
                    let name = self.text(1).to_owned();
                    self.bind(&["self".to_owned(), name.clone()], name.clone());
                    if self.text(2) == "{" {
                        self.module.push(name);
                        self.inline.push(self.depth);
                    }
                    self.at += 1;
                }
                "use" => {
                    self.at += 1;
                    self.use_tree(&[]);
                    continue;
                }
                _ if self.word(0) => {
                    self.inline_path();
                    continue;
                }
                _ => {}
            }
            self.at += 1;
        }
    }

    /// A path `a::b::c` in code outside `use`.
    fn inline_path(&mut self) {
        let line = self.tokens[self.at].line;
        let before = |back: usize| self.at.checked_sub(back).map(|i| self.tokens[i].text.as_str());
        let part_of_another = before(1) == Some(".")
            || before(1) == Some("::")
                && before(2).is_some_and(|text| text == ">" || self.tokens[self.at - 2].is_word());
        let mut path = vec![self.text(0).to_owned()];
        self.at += 1;
        while self.text(0) == "::" && self.word(1) {
            path.push(self.text(1).to_owned());
            self.at += 2;
        }
        if path.len() > 1 && !part_of_another {
            self.name(line, &path);
        }
    }

    /// The part after `use`, or after a `{` or `,` within it. `prefix` is the path before the braces.
    fn use_tree(&mut self, prefix: &[String]) {
        let mut path = prefix.to_vec();
        let mut alias = None;
        let line = self.tokens.get(self.at).map_or(0, |token| token.line);
        while self.at < self.tokens.len() {
            match self.text(0) {
                "::" => {}
                "{" => {
                    self.at += 1;
                    while self.at < self.tokens.len() && self.text(0) != "}" {
                        self.use_tree(&path);
                        if self.text(0) == "," {
                            self.at += 1;
                        }
                    }
                    self.at += 1;
                    return;
                }
                "*" => path.push("*".to_owned()),
                "as" => {
                    self.at += 1;
                    alias = Some(self.text(0).to_owned());
                }
                _ if self.word(0) => path.push(self.text(0).to_owned()),
                _ => break,
            }
            self.at += 1;
        }
        if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
            path.pop();
        }
        if let Some(last) = path.last().cloned() {
            self.bind(&path, alias.unwrap_or(last));
            self.name(line, &path);
        }
    }

    /// Outside tests, a name is bound to its last path; tests never rebind a name.
    fn bind(&mut self, path: &[String], name: String) {
        let full = self.full(path);
        if self.in_tests() {
            self.bound.entry(name).or_insert(full);
        } else {
            self.bound.insert(name, full);
        }
    }

    fn name(&mut self, line: usize, path: &[String]) {
        if path[0] != "Self" {
            self.found.push(Named { line, path: self.full(path), in_tests: self.in_tests() });
        }
    }

    /// The path from the root where it begins with `crate`, `self` or `super`; any other path unchanged.
    fn full(&self, path: &[String]) -> Vec<String> {
        let mut full = match path[0].as_str() {
            "crate" => Vec::new(),
            "self" | "super" => self.module.clone(),
            _ => return path.to_vec(),
        };
        for name in path {
            match name.as_str() {
                "crate" | "self" => {}
                "super" => drop(full.pop()),
                _ => full.push(name.clone()),
            }
        }
        full.insert(0, "crate".to_owned());
        full
    }

    fn in_tests(&self) -> bool {
        self.module.iter().any(|name| name == "tests")
    }
}

/// Words and signs, without comments and literals.
fn tokens(source: &str) -> Vec<Token> {
    let stream: TokenStream = source.parse().unwrap_or_else(|error| panic!("no Rust: {error}"));
    let mut tokens = Vec::new();
    add(&mut tokens, stream);
    tokens
}

fn add(tokens: &mut Vec<Token>, stream: TokenStream) {
    let mut first_colon = false;
    for tree in stream {
        let line = tree.span().start().line;
        let is_colon = matches!(&tree, TokenTree::Punct(sign) if sign.as_char() == ':');
        let mut push = |text: String| tokens.push(Token { line, text });
        match tree {
            TokenTree::Group(group) => {
                let [open, close] = match group.delimiter() {
                    Delimiter::Brace => ["{", "}"],
                    Delimiter::Parenthesis => ["(", ")"],
                    Delimiter::Bracket => ["[", "]"],
                    Delimiter::None => ["", ""],
                };
                push(open.to_owned());
                add(tokens, group.stream());
                tokens.push(Token { line: group.span_close().start().line, text: close.to_owned() });
            }
            TokenTree::Ident(word) => push(word.to_string().trim_start_matches("r#").to_owned()),
            TokenTree::Punct(_) if is_colon && first_colon => {
                tokens.push(Token { line, text: "::".to_owned() });
            }
            TokenTree::Punct(sign) if is_colon && sign.spacing() == Spacing::Joint => {
                first_colon = true;
                continue;
            }
            TokenTree::Punct(sign) => push(sign.as_char().to_string()),
            TokenTree::Literal(_) => {}
        }
        first_colon = false;
    }
}
