//! What came of many files.

use std::path::Path;

use serde_json::{Map, Value, json};

use crate::count::{counted, grouped};
use crate::exit::Exit;
use crate::failure::Failure;

/// How many files came out how, and a row for each.
#[derive(Debug)]
pub(crate) struct Tally {
    /// What is said of a file that came out well.
    good: &'static str,
    passed: u64,
    diverged: u64,
    unproven: u64,
    /// Files that could not be read.
    unread: u64,
    rows: Vec<Value>,
}

impl Tally {
    pub(crate) fn new(good: &'static str) -> Self {
        Self { good, passed: 0, diverged: 0, unproven: 0, unread: 0, rows: Vec::new() }
    }

    /// Notes a file that was compared, with what is told of it beside its name and verdict.
    pub(crate) fn note(&mut self, name: &str, passed: bool, details: Value) {
        let (count, verdict) =
            if passed { (&mut self.passed, self.good) } else { (&mut self.diverged, "diverged") };
        *count += 1;
        let mut row = json!({ "path": name, "verdict": verdict });
        if let (Value::Object(row), Value::Object(mut details)) = (&mut row, details) {
            row.append(&mut details);
        }
        self.rows.push(row);
    }

    /// Tells and notes why a file was not compared.
    pub(crate) fn note_failure(&mut self, path: &Path, failure: &Failure) {
        failure.tell();
        let (count, verdict) = match failure.exit() {
            Exit::Unproven => (&mut self.unproven, "unproven"),
            _ => (&mut self.unread, "unread"),
        };
        *count += 1;
        let path = path.display().to_string();
        self.rows.push(json!({ "path": path, "verdict": verdict, "why": failure.to_string() }));
    }

    /// A divergence outweighs a file that proves nothing, and that one a file that is not there.
    pub(crate) fn exit(&self) -> Exit {
        match self {
            Self { diverged: 1.., .. } => Exit::Different,
            Self { unproven: 1.., .. } => Exit::Unproven,
            Self { unread: 1.., .. } => Exit::Usage,
            _ => Exit::Fine,
        }
    }

    /// How many things came out how.
    pub(crate) fn line(&self, thing: &str) -> String {
        let Self { good, passed, diverged, unproven, unread, rows: _ } = self;
        let mut parts = vec![format!("{} {good}", counted(*passed, thing))];
        for (count, name) in [(diverged, "diverged"), (unproven, "unproven"), (unread, "unread")] {
            if *count > 0 {
                parts.push(format!("{} {name}", grouped(*count)));
            }
        }
        parts.join(", ")
    }

    /// The rows under the name of the things, and the counts.
    pub(crate) fn into_json(self, things: &str) -> Map<String, Value> {
        let Self { good, passed, diverged, unproven, unread, rows } = self;
        let counts =
            [(good, passed), ("diverged", diverged), ("unproven", unproven), ("unread", unread)];
        let counts = counts.into_iter().map(|(name, count)| (name.to_owned(), count.into()));
        [(things.to_owned(), rows.into())].into_iter().chain(counts).collect()
    }
}
