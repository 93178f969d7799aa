//! What can be typed.

use std::io::Write;

use clap::{CommandFactory as _, FromArgMatches as _, Parser, Subcommand};
use verlock::SIM_VERSION;
use verlock::replay::Replay;
use verlock::snapshot::Snapshot;

use crate::bisect::Bisect;
use crate::completions::Completions;
use crate::contacts::Contacts;
use crate::diff::Diff;
use crate::dump::Dump;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::hash::Hash;
use crate::heavy::Heavy;
use crate::info::Info;
use crate::man::Man;
use crate::overlap::Overlap;
use crate::reduce::Reduce;
use crate::render::Render;
use crate::run::Run;
use crate::toi::Toi;
use crate::verify::Verify;

/// Deterministic lockstep physics: run scenes, verify replays, compare states
#[derive(Debug, Parser)]
#[command(name = "verlock", version = version(), after_help = AFTER)]
pub(crate) struct Args {
    #[command(subcommand)]
    pub(crate) command: Command,

    /// Refuse files that are longer
    #[arg(long, global = true, value_name = "BYTES", default_value_t = 2 << 30)]
    pub(crate) limit: u64,
}

impl Args {
    /// What was typed. A number below 0 is the value of an option, which may refuse it, and no
    /// option.
    pub(crate) fn typed() -> Self {
        let matches = with_numbers_below_0(Self::command()).get_matches();
        Self::from_arg_matches(&matches).unwrap_or_else(|error| error.exit())
    }
}

fn with_numbers_below_0(command: clap::Command) -> clap::Command {
    let command = command.mut_args(|arg| {
        let has_value = !arg.is_positional() && arg.get_action().takes_values();
        if has_value { arg.allow_negative_numbers(true) } else { arg }
    });
    command.mut_subcommands(with_numbers_below_0)
}

const AFTER: &str = "\
A FILE or PATH may be `-`: stdin or stdout. A tick T means the state before tick T is stepped.

Exit codes:
  0  verified, equal, done
  1  a divergence or difference was found
  2  wrong usage, or a file could not be read or written
  3  damaged, unsupported or over a limit: nothing proven";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Run(Run),
    Verify(Verify),
    Heavy(Heavy),
    Info(Info),
    Hash(Hash),
    Bisect(Bisect),
    Diff(Diff),
    Dump(Dump),
    Render(Render),
    Overlap(Overlap),
    Toi(Toi),
    Contacts(Contacts),
    Reduce(Reduce),
    Completions(Completions),
    Man(Man),
}

impl Command {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        match self {
            Self::Run(run) => run.execute(limit, out),
            Self::Verify(verify) => verify.execute(limit, out),
            Self::Heavy(heavy) => heavy.execute(limit, out),
            Self::Info(info) => info.execute(limit, out),
            Self::Hash(hash) => hash.execute(limit, out),
            Self::Bisect(bisect) => bisect.execute(limit, out),
            Self::Diff(diff) => diff.execute(limit, out),
            Self::Dump(dump) => dump.execute(limit, out),
            Self::Render(render) => render.execute(limit, out),
            Self::Overlap(overlap) => overlap.execute(limit, out),
            Self::Toi(toi) => toi.execute(limit, out),
            Self::Contacts(contacts) => contacts.execute(limit, out),
            Self::Reduce(reduce) => reduce.execute(limit, out),
            Self::Completions(completions) => completions.execute(out),
            Self::Man(man) => man.execute(out),
        }
    }
}

fn version() -> String {
    let (package, snapshot, replay) = (env!("CARGO_PKG_VERSION"), Snapshot::FORMAT, Replay::FORMAT);
    format!(
        "{package} (SIM_VERSION {SIM_VERSION}, snapshot format {snapshot}, replay format {replay})"
    )
}
