//! `verlock dump`: every field of a state.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::builder::{PossibleValuesParser, TypedValueParser};
use serde_json::{Map, Value};
use verlock::snapshot::{Section, Snapshot};

use crate::exit::Exit;
use crate::failure::{Failure, tell};
use crate::input::Input;
use crate::json;
use crate::state::State;

/// Print every object and field of a state
///
/// Slots without a living object are printed too: they are part of the state. By default it is a
/// snapshot's only state, a replay's last, a scene's first.
#[derive(Debug, clap::Args)]
pub(crate) struct Dump {
    /// Snapshot, replay or scene
    path: PathBuf,

    /// Tick of the state
    #[arg(long, value_name = "T")]
    tick: Option<u64>,

    /// Only this section
    #[arg(long, value_parser = section_names())]
    section: Option<Section>,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Dump {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let input = Input::read(&self.path, limit)?;
        let state = State::at(&input, self.tick)?;
        let snapshot = state.snapshot(&input)?;
        if let Some(note) = state.note(&input, snapshot.tick()) {
            tell(note);
        }
        let wanted = |section: &Section| self.section.is_none_or(|only| only == *section);
        let sections: Vec<_> = Section::ALL.into_iter().filter(wanted).collect();
        if self.json {
            print_json(&snapshot, &sections, out)?;
        } else {
            print_lines(&snapshot, &sections, out)?;
        }
        Ok(Exit::Fine)
    }
}

fn section_names() -> impl TypedValueParser<Value = Section> {
    let names = PossibleValuesParser::new(Section::ALL.map(Section::name));
    names.try_map(|name| {
        let mut all = Section::ALL.into_iter();
        all.find(|section| section.name() == name).ok_or("no section has this name")
    })
}

fn print_lines(
    snapshot: &Snapshot<'_>,
    sections: &[Section],
    out: &mut dyn Write,
) -> io::Result<()> {
    for &section in sections {
        for index in 0..snapshot.count(section) {
            for (field, value) in snapshot.record(section, index) {
                let (name, raw) = (field.name, json::raw(&value));
                writeln!(out, "{section} {index} {name}: {value} (raw {raw})")?;
            }
        }
    }
    Ok(())
}

/// One object: `tick`, `hash`, and a list of objects for every section. Written piece by piece,
/// since the whole is many times as large as the state.
fn print_json(
    snapshot: &Snapshot<'_>,
    sections: &[Section],
    out: &mut dyn Write,
) -> io::Result<()> {
    write!(out, "{{\"tick\":{},\"hash\":\"{}\"", snapshot.tick(), snapshot.hash())?;
    for &section in sections {
        write!(out, ",\n\"{section}\":[")?;
        for index in 0..snapshot.count(section) {
            let fields = snapshot.record(section, index);
            let fields = fields.map(|(field, value)| (field.name.to_owned(), json::value(&value)));
            let object = Value::Object(fields.collect::<Map<_, _>>());
            let separator = if index == 0 { "" } else { "," };
            write!(out, "{separator}\n{object}")?;
        }
        write!(out, "]")?;
    }
    writeln!(out, "}}")
}
