//! Rules about the text of the repository that no compiler checks.

mod papers;
mod rules;
mod source;

use rules::Offences;
use source::{Source, files, has_extension, read};

/// Where Rust is kept.
const FOLDERS: [&str; 6] = ["src", "crates", "tests", "benches", "examples", "fuzz"];

/// The files of the library that convert floats, by their bits.
const FLOAT_FILES: [&str; 1] = ["src/math/float.rs"];

struct Rule {
    name: &'static str,
    applies: fn(&str) -> bool,
    offences: fn(&Source) -> Offences,
    /// Paths and texts of files that break the rule, see [`filled`].
    bad: &'static [(&'static str, &'static str)],
    /// A file that comes close to it but does not.
    good: (&'static str, &'static str),
}

const RULES: [Rule; 8] = [
    Rule {
        name: "a file names only its own module and lower floors",
        applies: |path| path.starts_with("src/") && path != "src/lib.rs",
        offences: rules::upward,
        bad: &[
            ("src/math/real.rs", "use crate::world::World;"),
            ("src/math/real.rs", "fn f() -> crate::store::Handle {}"),
            ("src/math/mod.rs", "use super::geometry::Aabb;"),
            ("src/body/rope/knot.rs", "use super::super::super::world::World;"),
            ("src/body/rope.rs", "use crate::{\n    math::{Real, Vec3},\n    world::World,\n};"),
            ("src/body/rope.rs", "use crate::World;"),
            ("src/utils.rs", ""),
        ],
        good: (
            "src/body/rope.rs",
            "//! See [`crate::world`].\nuse crate::{body::Pose, math::Real, real};",
        ),
    },
    Rule {
        name: "a file has fewer than 500 lines",
        applies: |_| true,
        offences: rules::long_file,
        bad: &[("src/a.rs", "<100 lines><100 lines><100 lines><100 lines><100 lines>")],
        good: ("src/a.rs", "<100 lines><100 lines><100 lines><100 lines>"),
    },
    Rule {
        name: "a line has at most 100 columns",
        applies: |_| true,
        offences: rules::wide_line,
        bad: &[("src/a.rs", "<100 columns>."), ("src/a.rs", "\n// <100 columns>")],
        good: ("src/a.rs", "<100 columns>\n"),
    },
    Rule {
        name: "a function has fewer than 70 lines",
        applies: |_| true,
        offences: rules::long_function,
        bad: &[
            ("src/a.rs", "fn f() {<100 lines>}"),
            ("src/a.rs", "impl A {\n    pub(crate) const fn f(\n    ) {<100 lines>    }\n}"),
        ],
        good: ("src/a.rs", "fn f() {}\ntrait A {\n    fn f(\n    );\n}\n<100 lines>fn g() {\n}"),
    },
    Rule {
        name: "nothing is left unfinished",
        applies: |_| true,
        offences: rules::unfinished,
        bad: &[("src/a.rs", concat!("// TO", "DO: all")), ("tests/a.rs", "    dbg\x21(1);")],
        good: ("src/a.rs", "// Hashed by XXH3."),
    },
    Rule {
        name: "only math/ names the crate fixed",
        applies: |path| path.starts_with("src/") && !path.starts_with("src/math/"),
        offences: rules::names_fixed,
        bad: &[("src/a.rs", "use fixed::types::I40F24;"), ("src/a.rs", "let a = ::fixed::f();")],
        good: ("src/a.rs", "let a = config.fixed_int(); // not fixed::types"),
    },
    Rule {
        name: "the library has no floats",
        applies: |path| path.starts_with("src/") && !FLOAT_FILES.contains(&path),
        offences: rules::float,
        bad: &[
            ("src/a.rs", "let a = 0.5;"),
            ("src/a.rs", "let a = 2.;"),
            ("src/a.rs", "let a = 1e9 as i64;"),
            ("src/a.rs", "let a = 1_f64;"),
            ("src/a.rs", "fn f(a: [f32; 3]) {}"),
        ],
        good: (
            "src/a.rs",
            "for i in 0..9usize { real!(\"9.8\") + b.0.1 + from_f64(0xe5) * 1.max(i) }",
        ),
    },
    Rule {
        name: "a stored record holds only numbers of fixed size",
        applies: |path| path.starts_with("src/") && !path.starts_with("src/scene/"),
        offences: rules::unstable_record,
        bad: &[
            ("src/a.rs", "#[derive(Clone, Serialize)]\nstruct A {\n    a: usize,\n}\n"),
            ("src/a.rs", "#[derive(\n    Serialize,\n)]\npub struct A(pub HashMap<u8, u8>);\n"),
        ],
        good: (
            "src/a.rs",
            "use serde::Serialize;\n#[derive(Serialize)]\nstruct A([u8; 3]);\nstruct B(usize);\n",
        ),
    },
];

/// Every Rust file keeps every rule.
#[test]
fn source_is_tidy() {
    let paths = FOLDERS.iter().flat_map(|folder| files(folder));
    let paths = paths.filter(|path| has_extension(path, "rs"));
    let sources: Vec<Source> = paths.map(|path| Source::new(&path, read(&path))).collect();
    assert!(sources.len() > 3, "found only {} files", sources.len());
    let mut report = vec![];
    for source in &sources {
        for rule in RULES.iter().filter(|rule| (rule.applies)(&source.path)) {
            for (line, matter) in (rule.offences)(source) {
                report.push(format!("{}:{line}: {} ({matter})", source.path, rule.name));
            }
        }
    }
    assert!(report.is_empty(), "\n{}", report.join("\n"));
}

/// Every rule notices the texts that break it, and lets pass the one that does not.
#[test]
fn rules_can_be_broken() {
    for Rule { name, applies, offences, bad, good } in RULES {
        for (path, text) in bad {
            assert!(applies(path), "{name}: does not look at {path}");
            assert_ne!(offences(&Source::new(path, filled(text))), [], "{name}: allows {text}");
        }
        let (path, text) = good;
        assert_eq!(offences(&Source::new(path, filled(text))), [], "{name}: refuses {text}");
    }
}

fn filled(text: &str) -> String {
    text.replace("<100 lines>", &"\n".repeat(100)).replace("<100 columns>", &"x".repeat(100))
}
