//! What a Rust file must not do. Each function gives the line and the matter of every offence.

use super::source::{Source, is_word, places};

pub type Offences = Vec<(usize, String)>;

/// The modules of the library by floor, lowest first.
const FLOORS: [&[&str]; 12] = [
    &["math", "store"],
    &["geometry"],
    &["partition"],
    &["particle"],
    &["constraint"],
    &["collision"],
    &["body"],
    &["world"],
    &["snapshot"],
    &["scene"],
    &["replay"],
    &["session"],
];

/// Exported macros stand at the top of the library, whatever their floor.
const MACROS: [&str; 1] = ["real"];

/// Types whose size, order or value differs between machines, or that have no bound.
const NOT_STORED: [&str; 7] = ["usize", "isize", "f32", "f64", "HashMap", "HashSet", "String"];

/// Marks of unfinished work.
const MARKS: [&str; 4] =
    [concat!("TO", "DO"), concat!("FIX", "ME"), concat!("XX", "X "), concat!("dbg", "!(")];

fn lines_where(text: &str, offends: impl Fn(&str) -> bool) -> Offences {
    let lines = (1..).zip(text.lines()).filter(|(_, line)| offends(line));
    lines.map(|(number, line)| (number, line.trim().into())).collect()
}

fn line_at(text: &str, at: usize) -> usize {
    text[..at].matches('\n').count() + 1
}

/// 500 lines or more.
pub fn long_file(source: &Source) -> Offences {
    let lines = source.text.lines().count();
    if lines < 500 { vec![] } else { vec![(lines, "the last".into())] }
}

/// More than 100 columns.
pub fn wide_line(source: &Source) -> Offences {
    lines_where(&source.text, |line| line.chars().count() > 100)
}

/// Functions of 70 lines or more. The layout is rustfmt's: a function ends at its own indent.
pub fn long_function(source: &Source) -> Offences {
    let lines: Vec<&str> = source.code.lines().collect();
    let indent = |line: &str| line.len() - line.trim_start().len();
    let length = |first: usize| {
        let own = indent(lines[first]);
        let ends = |line: &&str| indent(line) == own && line.trim_end().ends_with(['}', ';']);
        lines[first..].iter().position(ends).map_or(lines.len() - first, |last| last + 1)
    };
    let functions = (0..lines.len()).filter(|&at| is_function(lines[at]));
    functions.filter(|&at| length(at) >= 70).map(|at| (at + 1, lines[at].trim().into())).collect()
}

fn is_function(line: &str) -> bool {
    let modifier = |word: &&str| {
        word.starts_with("pub") || ["const", "async", "unsafe", "extern"].contains(word)
    };
    line.split_whitespace().find(|word| !modifier(word)) == Some("fn")
}

/// Marks of unfinished work.
pub fn unfinished(source: &Source) -> Offences {
    lines_where(&source.text, |line| MARKS.iter().any(|mark| line.contains(mark)))
}

/// The crate of fixed-point numbers.
pub fn names_fixed(source: &Source) -> Offences {
    lines_where(&source.code, |line| {
        places(line, "fixed").any(|at| line[at..].starts_with("fixed::"))
    })
}

/// Types and literals of floating-point numbers.
pub fn float(source: &Source) -> Offences {
    lines_where(&source.code, |line| {
        let starts =
            line.char_indices().filter(|&(at, c)| is_word(c) && !line[..at].ends_with(is_word));
        starts.map(|(at, _)| line.split_at(at)).any(|(before, rest)| {
            let (word, after) = rest.split_at(rest.find(|c| !is_word(c)).unwrap_or(rest.len()));
            if !word.starts_with(|c: char| c.is_ascii_digit()) {
                return word == "f32" || word == "f64";
            }
            // `a.0.1` are fields, `0..1` is a range, `1.max(2)` a call, `0xe5` and `1usize` whole.
            let field = before.ends_with('.') && !before.ends_with("..");
            let point = after.strip_prefix('.').is_some_and(|fraction| {
                !fraction.starts_with(|c: char| c == '.' || c == '_' || c.is_ascii_alphabetic())
            });
            let suffix = word.trim_start_matches(|c: char| c == '_' || c.is_ascii_digit());
            !field && (point || suffix.starts_with(['e', 'f']))
        })
    })
}

/// Records that are written to snapshots, with a field that is not the same everywhere.
pub fn unstable_record(source: &Source) -> Offences {
    let code = &source.code;
    let mut found = vec![];
    for at in places(code, "Serialize") {
        if !code[..at].rsplit([')', ';']).next().is_some_and(|before| before.contains("derive(")) {
            continue;
        }
        let end = [";\n", "\n}"].iter().filter_map(|end| code[at..].find(end)).min();
        let record = &code[at..end.map_or(code.len(), |end| at + end)];
        for word in NOT_STORED {
            found
                .extend(places(record, word).map(|place| (line_at(code, at + place), word.into())));
        }
    }
    found
}

/// Paths that climb to the top of the library and come down in the file's own floor or above.
pub fn upward(source: &Source) -> Offences {
    let code = &source.code;
    let path = source.path.trim_start_matches("src/").trim_end_matches(".rs");
    let modules: Vec<&str> = path.split('/').filter(|&module| module != "mod").collect();
    let floor = |module| FLOORS.iter().position(|floor| floor.contains(&module));
    let Some(own) = floor(modules[0]) else { return vec![(1, "a module without a floor".into())] };
    let allowed = |name| {
        name == modules[0] || MACROS.contains(&name) || floor(name).is_some_and(|floor| floor < own)
    };

    let mut found = vec![];
    for at in places(code, "crate") {
        let Some(rest) = code[at..].strip_prefix("crate::") else { continue };
        found.extend(heads(rest).into_iter().filter(|name| !allowed(name)).map(|name| (at, name)));
    }
    for at in places(code, "super").filter(|&at| !code[..at].ends_with("::")) {
        let rest = code[at..].trim_start_matches("super::");
        let climbed = (code.len() - at - rest.len()) / "super::".len();
        // An inline module is one step deeper, so a climb this high may also end beside the file.
        let names = heads(rest)
            .into_iter()
            .filter(|name| climbed >= modules.len() && floor(name).is_some());
        found.extend(names.filter(|name| !allowed(name)).map(|name| (at, name)));
    }
    found.into_iter().map(|(at, name)| (line_at(code, at), name.into())).collect()
}

/// The first name of the path that `rest` begins with, or of each path in a braced list.
fn heads(rest: &str) -> Vec<&str> {
    let Some(list) = rest.strip_prefix('{') else { return vec![first_word(rest)] };
    let change = |c| i32::from(c == '{') - i32::from(c == '}');
    let mut depth = 0;
    let closes = |c| {
        depth += change(c);
        depth < 0
    };
    let list = &list[..list.find(closes).unwrap_or(list.len())];
    let mut depth = 0;
    let items = list.split(|c| {
        depth += change(c);
        depth == 0 && c == ','
    });
    items.map(first_word).filter(|name| !name.is_empty()).collect()
}

fn first_word(text: &str) -> &str {
    let text = text.trim_start();
    &text[..text.find(|c| !is_word(c)).unwrap_or(text.len())]
}
