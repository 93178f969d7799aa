//! The files of the repository, and Rust without its comments and literals.

use std::fs;
use std::path::{Path, PathBuf};

/// A Rust file.
pub struct Source {
    /// From the root of the repository, with `/`.
    pub path: String,
    pub text: String,
    /// The text with comments and literals blanked out, line for line.
    pub code: String,
}

impl Source {
    pub fn new(path: &str, text: String) -> Self {
        Self { path: path.into(), code: code_of(&text), text }
    }
}

pub fn absolute(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

pub fn read(path: &str) -> String {
    fs::read_to_string(absolute(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// All files below a folder, sorted; build folders are left out.
pub fn files(folder: &str) -> Vec<String> {
    let Ok(entries) = fs::read_dir(absolute(folder)) else { return vec![] };
    let mut found = vec![];
    for entry in entries.map(|entry| entry.expect(folder)) {
        let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
        match entry.file_type().expect(folder).is_dir() {
            true if path.ends_with("/target") => {}
            true => found.append(&mut files(&path)),
            false => found.push(path),
        }
    }
    found.sort();
    found
}

pub fn has_extension(path: &str, extension: &str) -> bool {
    Path::new(path).extension().is_some_and(|found| found == extension)
}

pub const fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}

/// Where `word` stands in `text` as a whole word.
pub fn places<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = usize> + 'a {
    text.match_indices(word).map(|(at, _)| at).filter(move |&at| {
        !text[..at].ends_with(is_word) && !text[at + word.len()..].starts_with(is_word)
    })
}

/// Blanks out comments, strings and characters, so that only code is left on its lines.
fn code_of(text: &str) -> String {
    let mut code = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let (dark, after) = rest.split_at(dark_length(rest));
        if dark.is_empty() {
            code.push(c);
            rest = &rest[c.len_utf8()..];
        } else {
            code.extend(dark.chars().map(|c| if c == '\n' { c } else { ' ' }));
            rest = after;
        }
    }
    code
}

/// The length of the comment or literal that `text` begins with, 0 for none.
fn dark_length(text: &str) -> usize {
    let until = |open: usize, close: &str| {
        text[open..].find(close).map_or(text.len(), |at| open + at + close.len())
    };
    let raw = text.strip_prefix('r').map(|rest| rest.trim_start_matches('#'));
    if text.starts_with("//") {
        text.find('\n').unwrap_or(text.len())
    } else if text.starts_with("/*") {
        until(2, "*/")
    } else if let Some(rest) = raw.filter(|rest| rest.starts_with('"')) {
        let open = text.len() - rest.len();
        until(open + 1, &format!("\"{}", &text[1..open]))
    } else if text.starts_with('"') || text.starts_with(r"'\") {
        quoted(text)
    } else if text.starts_with('\'') && text.chars().nth(2) == Some('\'') {
        // Not a lifetime, which has no second quote.
        text.char_indices().nth(3).map_or(text.len(), |(end, _)| end)
    } else {
        0
    }
}

/// The length of the literal up to the quote that it begins with and that is not escaped.
fn quoted(text: &str) -> usize {
    let mut escaped = false;
    let end = text[1..].find(|c| {
        let ends = !escaped && text.starts_with(c);
        escaped = !escaped && c == '\\';
        ends
    });
    end.map_or(text.len(), |end| end + 2)
}

/// What is not code is blank, what is code stays where it was.
#[test]
fn only_code_is_left() {
    let cases = [
        ("a // b\nc", "a     \nc"),
        ("a /* b\nc */ d", "a     \n     d"),
        (r#"f("a\"b", c)"#, "f(      , c)"),
        (r##"f(r#"a"b"#, c)"##, "f(        , c)"),
        (r"f('\'', 'a', 'é', &'a b)", "f(    ,    ,    , &'a b)"),
        ("r#type", "r#type"),
    ];
    for (text, code) in cases {
        assert_eq!(Source::new("", text.into()).code, code, "{text}");
    }
}
