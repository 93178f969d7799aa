//! What a command tells about something.

use std::io::{self, Write};

use serde_json::{Map, Value};

/// Named values: lines of text, or one JSON object.
#[derive(Debug, Default)]
pub(crate) struct Report(Map<String, Value>);

impl Report {
    pub(crate) fn add(&mut self, name: &str, value: impl Into<Value>) {
        self.0.insert(name.into(), value.into());
    }

    /// Adds how many objects of each kind a world has; the names begin with `when`.
    pub(crate) fn add_counts(&mut self, when: &str, world: &verlock::World) {
        let mut add = |kind, count: usize| self.add(&format!("{when}{kind}"), count);
        add("particles", world.particles().len());
        add("distances", world.distances().count());
        add("volumes", world.volumes().count());
        add("faces", world.faces().count());
        add("half_spaces", world.half_spaces().count());
    }

    pub(crate) fn print(self, json: bool, out: &mut dyn Write) -> io::Result<()> {
        if json {
            return writeln!(out, "{:#}", Value::Object(self.0));
        }
        // The version of the form is for programs.
        for (name, value) in self.0.iter().filter(|(name, _)| *name != "v") {
            match value {
                Value::Array(rows) => {
                    rows.iter().try_for_each(|row| writeln!(out, "{name} {}", line(row)))?;
                }
                value => writeln!(out, "{name} {}", line(value))?,
            }
        }
        Ok(())
    }
}

/// A value on one line: texts without quotes, objects as `name=value`.
fn line(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Null => "none".into(),
        Value::Object(fields) if fields.is_empty() => "none".into(),
        Value::Object(fields) => {
            let fields = fields.iter().map(|(name, value)| format!("{name}={}", line(value)));
            fields.collect::<Vec<_>>().join(" ")
        }
        value => value.to_string(),
    }
}
