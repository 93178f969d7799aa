//! `verlock verify`: steps replays again.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use verlock::replay::{Divergence, DivergenceKind};
use verlock::snapshot::Difference;

use crate::count::{counted, grouped};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::input::Input;
use crate::json;
use crate::progress::Progress;
use crate::replays::replays;
use crate::verdict::{Compared, Verdict};

/// Step replays again and compare every tick
///
/// Compares the inputs, the state and the keyframes of every tick with what was recorded, and tells
/// the first that differs: its tick, both hashes and, where a keyframe was recorded at that tick,
/// the first 20 differing fields (`diff` tells all). Goes on with the next replay whatever it
/// finds.
#[derive(Debug, clap::Args)]
pub(crate) struct Verify {
    /// Replays, or folders in which all *.replay are verified
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

/// What came of all replays.
#[derive(Default)]
struct Tally {
    verified: u64,
    diverged: u64,
    unproven: u64,
    /// Files that could not be read.
    unread: u64,
    compared: Compared,
    /// A row for every replay.
    rows: Vec<Value>,
}

impl Verify {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let mut tally = Tally::default();
        for path in &self.paths {
            match replays(path) {
                Ok(files) => {
                    for file in files {
                        self.verify(&file, limit, &mut tally, out)?;
                    }
                }
                Err(failure) => tally.note_failure(path, &failure),
            }
        }
        let exit = tally.exit();
        if self.json {
            writeln!(out, "{:#}", tally.into_json())?;
        } else {
            writeln!(out, "{}", tally.line())?;
        }
        Ok(exit)
    }

    fn verify(
        &self,
        path: &Path,
        limit: u64,
        tally: &mut Tally,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        let input = match Input::read(path, limit) {
            Ok(input) => input,
            Err(failure) => {
                tally.note_failure(path, &failure);
                return Ok(());
            }
        };
        let mut progress = None;
        let verdict = Verdict::of(input.bytes(), |replay| {
            progress.get_or_insert_with(|| Progress::new(input.name(), replay.len())).step();
        });
        drop(progress);
        tally.note(&input, &verdict);
        if !self.json {
            print(&input, &verdict, out)?;
        }
        Ok(())
    }
}

impl Tally {
    fn note(&mut self, input: &Input, verdict: &Verdict) {
        match verdict {
            Verdict::Verified(_) => self.verified += 1,
            Verdict::Diverged(..) => self.diverged += 1,
            Verdict::Unproven(error) => {
                let failure = input.unproven(error);
                return self.note_failure(Path::new(input.name()), &failure);
            }
        }
        self.compared = self.compared + verdict.compared();
        self.rows.push(row(input, verdict));
    }

    fn note_failure(&mut self, path: &Path, failure: &Failure) {
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
    fn exit(&self) -> Exit {
        match self {
            Self { diverged: 1.., .. } => Exit::Different,
            Self { unproven: 1.., .. } => Exit::Unproven,
            Self { unread: 1.., .. } => Exit::Usage,
            _ => Exit::Fine,
        }
    }

    fn line(&self) -> String {
        let Self { verified, diverged, unproven, unread, compared, rows: _ } = self;
        let mut parts = vec![format!("{} verified", counted(*verified, "replay"))];
        for (count, name) in [(diverged, "diverged"), (unproven, "unproven"), (unread, "unread")] {
            if *count > 0 {
                parts.push(format!("{} {name}", grouped(*count)));
            }
        }
        let replays = parts.join(", ");
        let ticks = counted(compared.ticks, "tick");
        let particles = counted(compared.particle_states, "particle state");
        let constraints = counted(compared.constraint_states, "constraint state");
        format!("{replays}: {ticks}, {particles}, {constraints} compared")
    }

    fn into_json(self) -> Value {
        let Self { verified, diverged, unproven, unread, compared, rows } = self;
        json!({
            "replays": rows,
            "verified": verified, "diverged": diverged, "unproven": unproven, "unread": unread,
            "ticks": compared.ticks,
            "particle_states": compared.particle_states,
            "constraint_states": compared.constraint_states,
        })
    }
}

fn print(input: &Input, verdict: &Verdict, out: &mut dyn Write) -> io::Result<()> {
    let name = input.name();
    match verdict {
        Verdict::Verified(compared) => {
            let ticks = counted(compared.ticks, "tick");
            let particles = counted(compared.particles, "particle");
            let constraints = counted(compared.constraints, "constraint");
            writeln!(out, "{name}: verified: {ticks}, {particles}, {constraints}")
        }
        Verdict::Diverged(divergence, _, differences) => {
            writeln!(out, "{name}: diverged: {divergence}")?;
            if !differences.is_empty() {
                writeln!(out, "  recorded against found in the state after it:")?;
            }
            differences.iter().try_for_each(|difference| writeln!(out, "  {difference}"))
        }
        // Told as a failure.
        Verdict::Unproven(_) => Ok(()),
    }
}

fn row(input: &Input, verdict: &Verdict) -> Value {
    let compared = verdict.compared();
    let mut row = json!({
        "path": input.name(),
        "verdict": "verified",
        "ticks": compared.ticks,
        "particles": compared.particles,
        "constraints": compared.constraints,
    });
    if let Verdict::Diverged(divergence, _, differences) = verdict {
        row["verdict"] = "diverged".into();
        row["divergence"] = divergence_json(divergence, differences);
    }
    row
}

fn divergence_json(divergence: &Divergence, differences: &[Difference]) -> Value {
    let Divergence { tick, kind, recorded, found } = divergence;
    let kind = match kind {
        DivergenceKind::Inputs => "inputs",
        DivergenceKind::State => "state",
        DivergenceKind::Keyframe => "keyframe",
        _ => "other",
    };
    json!({
        "tick": tick, "kind": kind,
        "recorded": recorded.to_string(), "found": found.to_string(),
        "differences": differences.iter().map(json::difference).collect::<Vec<_>>(),
    })
}
