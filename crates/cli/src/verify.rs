//! `verlock verify`: steps replays again.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use verlock::replay::{Divergence, DivergenceKind, Replay, VerifyError};
use verlock::snapshot::{DecodeError, DecodeReason, Difference};

use crate::count::counted;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::files::{REPLAY, files};
use crate::input::Input;
use crate::json;
use crate::progress::Progress;
use crate::tally::Tally;
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

impl Verify {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let mut tally = Tally::new("verified");
        let mut compared = Compared::default();
        for path in &self.paths {
            match files(path, &[REPLAY]) {
                Ok(files) => {
                    for file in files {
                        compared = compared + self.verify(&file, limit, &mut tally, out)?;
                    }
                }
                Err(failure) => tally.note_failure(path, &failure),
            }
        }
        let exit = tally.exit();
        if self.json {
            let mut report = tally.into_json("replays");
            report.insert("ticks".into(), compared.ticks.into());
            report.insert("particle_states".into(), compared.particle_states.into());
            report.insert("constraint_states".into(), compared.constraint_states.into());
            writeln!(out, "{:#}", Value::Object(report))?;
        } else {
            writeln!(out, "{}: {} compared", tally.line("replay"), compared.line())?;
        }
        Ok(exit)
    }

    /// Verifies a replay, prints and notes what came of it, and returns how much came out the same.
    fn verify(
        &self,
        path: &Path,
        limit: u64,
        tally: &mut Tally,
        out: &mut dyn Write,
    ) -> Result<Compared, Failure> {
        let mut progress = None;
        let on_tick = |input: &Input, replay: &Replay<'_>| {
            let begin = || Progress::new(input.name(), replay.len(), "ticks");
            progress.get_or_insert_with(begin).step();
        };
        let (input, verdict) = match judge(path, limit, on_tick) {
            Ok(judged) => judged,
            Err(failure) => {
                tally.note_failure(path, &failure);
                return Ok(Compared::default());
            }
        };
        drop(progress);
        tally.note(input.name(), matches!(verdict, Verdict::Verified(_)), row(&verdict));
        if !self.json {
            print(&input, &verdict, out)?;
        }
        Ok(verdict.compared())
    }
}

/// A file and what stepping it again proves, if it proves anything.
fn judge(
    path: &Path,
    limit: u64,
    mut on_tick: impl FnMut(&Input, &Replay<'_>),
) -> Result<(Input, Verdict), Failure> {
    let input = Input::read(path, limit)?;
    let verdict = Verdict::of(input.bytes(), |replay| on_tick(&input, replay));
    match &verdict {
        Verdict::Unproven(VerifyError::Decode(DecodeError {
            reason: DecodeReason::NotThisKind,
            offset: 0,
        })) => Err(input.other_kind("a replay")),
        Verdict::Unproven(VerifyError::Decode(error)) => Err(input.undecoded(*error)),
        Verdict::Unproven(error) => Err(input.unproven(error)),
        _ => Ok((input, verdict)),
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

fn row(verdict: &Verdict) -> Value {
    let compared = verdict.compared();
    let mut row = json!({
        "ticks": compared.ticks,
        "particles": compared.particles,
        "constraints": compared.constraints,
    });
    if let Verdict::Diverged(divergence, _, differences) = verdict {
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
