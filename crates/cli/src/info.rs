//! `verlock info`: what a file is.

use std::io::Write;
use std::path::PathBuf;

use serde_json::{Value, json};
use verlock::replay::{HashLog, Replay};
use verlock::scene::Scene;
use verlock::snapshot::{Section, Snapshot};
use verlock::{Hash, SIM_VERSION};

use crate::exit::Exit;
use crate::failure::Failure;
use crate::input::{Input, Kind};
use crate::report::Report;
use crate::state::{recorded_hash, simulation, span};

/// Bytes of a row of the table that snapshots and replays begin with; see `FORMAT.md`.
const ROW: usize = 40;
/// No table has more rows.
const SECTIONS_MAX: u32 = 32;

/// Tell what a snapshot, replay, scene or hash log is and holds
///
/// Its versions, ticks, the number of objects (of a replay, at its start), and its sections with
/// their sizes and hashes. Of a snapshot or replay that is damaged, or of other rules, what its
/// header and table say.
#[derive(Debug, clap::Args)]
pub(crate) struct Info {
    /// Snapshot, replay, scene or hash log
    path: PathBuf,

    /// Print JSON
    #[arg(long)]
    json: bool,
}

impl Info {
    pub(crate) fn execute(self, limit: u64, out: &mut dyn Write) -> Result<Exit, Failure> {
        let input = Input::read(&self.path, limit)?;
        let report = input.open().and_then(|kind| match kind {
            Kind::Snapshot(snapshot) => of_snapshot(&input, &snapshot),
            Kind::Replay(replay) => Ok(of_replay(&input, &replay)),
            Kind::Scene(scene) => of_scene(&input, &scene),
            Kind::Hashes(log) => Ok(of_hashes(&input, &log)),
        });
        let (report, failure) = match report {
            Ok(report) => (report, None),
            Err(failure) => match of_header(&input) {
                Some(report) => (report, Some(failure)),
                None => return Err(failure),
            },
        };
        report.print(self.json, out)?;
        failure.map_or(Ok(Exit::Fine), Err)
    }
}

/// What a file says of itself that cannot be read, nothing of which is proven.
fn of_header(input: &Input) -> Option<Report> {
    let bytes = input.bytes();
    let magic = bytes.first_chunk::<8>()?;
    let kinds = [(Snapshot::MAGIC, "snapshot"), (Replay::MAGIC, "replay")];
    let (_, kind) = kinds.into_iter().find(|(known, _)| known == magic)?;
    let mut report = begin(kind, input, None);
    report.add("readable", false);
    report.add("format", number(bytes, 8));
    report.add("sim_version", number(bytes, 12));
    let rows = number(bytes, 16).unwrap_or(0).min(SECTIONS_MAX);
    let rows = bytes.get(24..).unwrap_or_default().chunks_exact(ROW).take(rows as usize);
    let row = |row: &[u8]| {
        let wide = |at| Some(u64::from_le_bytes(*row.get(at..)?.first_chunk()?));
        let hash = row.last_chunk().map(|bytes| Hash::from_bytes(*bytes).to_string());
        json!({ "kind": number(row, 0), "records": wide(8), "bytes": wide(16), "hash": hash })
    };
    report.add("sections", rows.map(row).collect::<Vec<_>>());
    Some(report)
}

/// A number of 32 bits, if the bytes go so far.
fn number(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?))
}

fn begin(kind: &str, input: &Input, format: Option<u32>) -> Report {
    let mut report = Report::default();
    report.add("kind", kind);
    report.add("bytes", input.bytes().len());
    if let Some(format) = format {
        report.add("format", format);
        // Files of other rules do not get this far.
        report.add("sim_version", SIM_VERSION);
    }
    report
}

fn of_snapshot(input: &Input, snapshot: &Snapshot<'_>) -> Result<Report, Failure> {
    let world = snapshot.load().map_err(|error| input.undecoded(error))?;
    let mut report = begin("snapshot", input, Some(Snapshot::FORMAT));
    report.add("tick", snapshot.tick());
    report.add_counts("", &world);
    report.add("hash", snapshot.hash().to_string());
    let row = |part: Section| {
        let bytes = snapshot.bytes(part).len();
        section(part.name(), snapshot.count(part), bytes as u64, snapshot.part_hash(part))
    };
    report.add("sections", Section::ALL.map(row).to_vec());
    Ok(report)
}

fn of_replay(input: &Input, replay: &Replay<'_>) -> Report {
    let mut report = begin("replay", input, Some(Replay::FORMAT));
    report.add("name", simulation(replay));
    report.add("version", replay.version());
    report.add("first_tick", replay.first_tick());
    report.add("ticks", replay.len());
    report.add("inputs", replay.input_count());
    report.add("keyframes", replay.keyframe_ticks().count());
    // The start of a game is its own affair.
    if let Ok(world) = Snapshot::parse(replay.start_bytes()).and_then(|start| start.load()) {
        report.add_counts("start_", &world);
    }
    report.add("last_hash", recorded_hash(replay, span(replay)[1]).map(|hash| hash.to_string()));
    let rows = replay.sections();
    let rows = rows.map(|(name, entry)| section(name, entry.count, entry.length, entry.hash));
    report.add("sections", rows.collect::<Vec<_>>());
    report
}

fn of_scene(input: &Input, scene: &Scene) -> Result<Report, Failure> {
    let world = input.world(scene)?;
    let mut report = begin("scene", input, None);
    report.add("ticks", scene.ticks());
    report.add_counts("", &world);
    report.add("hash", world.hash().to_string());
    Ok(report)
}

fn of_hashes(input: &Input, log: &HashLog) -> Report {
    let mut report = begin("hash log", input, None);
    report.add("states", log.iter().count());
    let span = log.span();
    report.add("first_tick", span.map(|[first, _]| first));
    report.add("last_tick", span.map(|[_, last]| last));
    report.add("last_hash", log.iter().last().map(|(_, hash)| hash.to_string()));
    report
}

fn section(name: &str, records: u64, bytes: u64, hash: Hash) -> Value {
    json!({ "name": name, "records": records, "bytes": bytes, "hash": hash.to_string() })
}
