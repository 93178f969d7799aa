//! Text to statements, and these to words, with nothing copied.

/// One statement of the text: a line, with the lines it goes on in.
pub(super) struct Statement<'a> {
    /// Where it begins, counted from 1; `u32::MAX` also beyond.
    pub(super) line: u32,
    text: &'a str,
}

/// The statements of a text, empty ones among them.
pub(super) struct Statements<'a> {
    rest: &'a str,
    lines: u32,
}

impl<'a> Statement<'a> {
    /// The words between blanks, without comments.
    pub(super) fn words(&self) -> impl Iterator<Item = &'a str> + use<'a> {
        let lines = self.text.split_inclusive('\n');
        lines.flat_map(|line| contents(line).0.split_ascii_whitespace())
    }
}

impl<'a> Statements<'a> {
    /// Of a text, which may begin with a byte order mark.
    pub(super) fn of(text: &'a str) -> Self {
        Self { rest: text.strip_prefix('\u{feff}').unwrap_or(text), lines: 0 }
    }
}

impl<'a> Iterator for Statements<'a> {
    type Item = Statement<'a>;

    fn next(&mut self) -> Option<Statement<'a>> {
        if self.rest.is_empty() {
            return None;
        }
        let line = self.lines.saturating_add(1);
        let mut end = 0;
        for piece in self.rest.split_inclusive('\n') {
            end += piece.len();
            self.lines = self.lines.saturating_add(1);
            if !contents(piece).1 {
                break;
            }
        }
        let (text, rest) = self.rest.split_at(end);
        self.rest = rest;
        Some(Statement { line, text })
    }
}

/// A line without its comment and without blanks and `\` at its end; whether there is such a `\`.
fn contents(line: &str) -> (&str, bool) {
    let line = line.split_once('#').map_or(line, |(before, _)| before);
    let kept = line.trim_end_matches(|c: char| c == '\\' || c.is_ascii_whitespace());
    (kept, line[kept.len()..].contains('\\'))
}
