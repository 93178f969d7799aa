//! What the documents say is there, and the fixtures are used.

use super::source::{absolute, files, has_extension, is_word, places, read};

/// Folders of `fixtures/` of which a test reads every file.
const WALKED: [&str; 5] = ["meshes", "predicates", "refused", "replays", "scenes"];

/// The texts of a document that are set as code: its inline code, and the lines of its fences.
struct Code<'a> {
    inline: Vec<&'a str>,
    fenced: Vec<&'a str>,
}

impl<'a> Code<'a> {
    fn of(document: &'a str) -> Self {
        let (mut inline, mut fenced, mut fence) = (vec![], vec![], false);
        for line in document.lines() {
            if line.trim_start().starts_with("```") {
                fence = !fence;
            } else if fence {
                fenced.push(line.trim_start_matches("$ "));
            } else {
                inline.extend(line.split('`').skip(1).step_by(2));
            }
        }
        Self { inline, fenced }
    }
}

/// The subcommands that a document calls and the command line does not have.
fn unknown_commands<'a>(document: &'a str, command_line: &str) -> Vec<&'a str> {
    let Code { inline, fenced } = Code::of(document);
    let calls = inline.into_iter().chain(fenced).filter_map(|code| {
        let call = code.strip_prefix("verlock ");
        call.or_else(|| code.split_once("cargo run --release -- ").map(|(_, call)| call))
    });
    let names = calls.filter_map(|call| call.split_whitespace().next());
    names
        .filter(|name| name.starts_with(|c: char| c.is_ascii_lowercase()))
        .filter(|name| {
            let variant = name[..1].to_ascii_uppercase() + &name[1..];
            let quoted = format!("\"{name}\"");
            !command_line.contains(&quoted) && places(command_line, &variant).next().is_none()
        })
        .collect()
}

/// The paths that a document names and `exists` does not find.
fn missing_paths(document: &str, exists: impl Fn(&str) -> bool) -> Vec<&str> {
    let is_path = |code: &&str| {
        let first = code.split('/').next().unwrap_or(code);
        let typical = ["rs", "md", "toml"].iter().any(|extension| has_extension(code, extension));
        code.chars().all(|c| is_word(c) || "-./".contains(c))
            && !code.starts_with(['/', '-'])
            && (typical || code.contains('/') && exists(first))
    };
    let inline = Code::of(document).inline;
    inline.into_iter().filter(is_path).filter(|path| !exists(path)).collect()
}

/// The fixtures that nothing names, by file name or by its part before the first dot.
fn unused_fixtures<'a>(fixtures: &'a [String], texts: &[String]) -> Vec<&'a String> {
    let walked = |path: &&String| {
        let folder = path.split('/').nth(1).unwrap_or_default();
        WALKED.contains(&folder) || path.ends_with("/README.md")
    };
    let (walked, single): (Vec<_>, Vec<_>) = fixtures.iter().partition(walked);
    let named = |path: &&String| {
        let file = path.rsplit('/').next().unwrap_or(path);
        let stem = file.split('.').next().unwrap_or(file);
        let whole = |text: &str| {
            places(text, stem)
                .any(|at| !text[..at].ends_with('-') && !text[at + stem.len()..].starts_with('-'))
        };
        texts.iter().any(|text| whole(text)) || walked.iter().any(|path| whole(path))
    };
    single.into_iter().filter(|path| !named(path)).collect()
}

/// Commands and paths in the documents exist.
#[test]
fn documents_are_true() {
    let command_line: String = files("crates/cli/src")
        .iter()
        .filter(|path| has_extension(path, "rs"))
        .map(|p| read(p))
        .collect();
    for path in ["README.md", "ARCHITECTURE.md"] {
        let document = read(path);
        let exists = |path: &str| absolute(path).exists() || absolute("src").join(path).exists();
        assert_eq!(unknown_commands(&document, &command_line), [""; 0], "commands in {path}");
        assert_eq!(missing_paths(&document, exists), [""; 0], "paths in {path}");
    }
}

/// Every fixture is used by a test, a bench or an example, or explained in the folder's README.
#[test]
fn fixtures_are_used() {
    let users = ["tests", "crates", "benches", "examples"];
    let users =
        users.iter().flat_map(|folder| files(folder)).filter(|path| has_extension(path, "rs"));
    let mut texts: Vec<String> = users.map(|path| read(&path)).collect();
    texts.push(read("fixtures/README.md"));
    assert_eq!(unused_fixtures(&files("fixtures"), &texts), Vec::<&String>::new());
}

/// A wrong command, a wrong path and a forgotten fixture are noticed; near misses are not.
#[test]
fn papers_can_be_wrong() {
    let line = "match name { \"verify\" => 1 } enum Command { Run(Run) }";
    let calls = "verlock is `verlock run` and `verlock lift`:\n```sh\nverlock verify a\n\
        $ verlock move\ncargo run --release -- throw a\n```\n";
    assert_eq!(unknown_commands(calls, line), ["lift", "move", "throw"]);

    let paths = "`src/math` `src/maths`, `and/or`, `real.rs` `src/<x>.rs` src/none";
    assert_eq!(
        missing_paths(paths, |path| path == "src" || path == "src/math"),
        ["src/maths", "real.rs"]
    );

    let fixtures =
        ["scenes/a.ron", "golden/a.hashes", "golden/b.hashes", "clips/c.clip", "clips/d.clip"];
    let fixtures = fixtures.map(|path| format!("fixtures/{path}"));
    let unused = unused_fixtures(&fixtures, &["play(\"c\"); b-side; d2".into()]);
    assert_eq!(unused, [&fixtures[2], &fixtures[4]]);
}
