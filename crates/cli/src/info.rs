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
use crate::state::{recorded_hash, span};

/// Tell what a snapshot, replay, scene or hash log is and holds
///
/// Its versions, ticks, the number of objects at its start, and its sections with their sizes and
/// hashes.
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
        let report = match input.open()? {
            Kind::Snapshot(snapshot) => of_snapshot(&input, &snapshot)?,
            Kind::Replay(replay) => of_replay(&input, &replay),
            Kind::Scene(scene) => of_scene(&input, &scene)?,
            Kind::Hashes(log) => of_hashes(&input, &log),
        };
        report.print(self.json, out)?;
        Ok(Exit::Fine)
    }
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
    let world = snapshot.load().map_err(|error| input.unproven(error))?;
    let mut report = begin("snapshot", input, Some(Snapshot::FORMAT));
    report.add("tick", snapshot.tick());
    report.add_counts(&world);
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
    let name = replay.name();
    report.add("name", String::from_utf8_lossy(&name).trim_end_matches('\0'));
    report.add("version", replay.version());
    report.add("first_tick", replay.first_tick());
    report.add("ticks", replay.len());
    report.add("inputs", replay.input_count());
    report.add("keyframes", replay.keyframe_ticks().count());
    // The start of a game is its own affair.
    if let Ok(world) = Snapshot::parse(replay.start_bytes()).and_then(|start| start.load()) {
        report.add_counts(&world);
    }
    report.add("hash", recorded_hash(replay, span(replay)[1]).map(|hash| hash.to_string()));
    let rows = replay.sections();
    let rows = rows.map(|(name, entry)| section(name, entry.count, entry.length, entry.hash));
    report.add("sections", rows.collect::<Vec<_>>());
    report
}

fn of_scene(input: &Input, scene: &Scene) -> Result<Report, Failure> {
    let world = scene.build().map_err(|error| input.unproven(error))?;
    let mut report = begin("scene", input, None);
    report.add("ticks", scene.ticks());
    report.add_counts(&world);
    report.add("hash", world.hash().to_string());
    Ok(report)
}

fn of_hashes(input: &Input, log: &HashLog) -> Report {
    let mut report = begin("hash log", input, None);
    report.add("states", log.iter().count());
    let span = log.span();
    report.add("first_tick", span.map(|[first, _]| first));
    report.add("last_tick", span.map(|[_, last]| last));
    report.add("hash", log.iter().last().map(|(_, hash)| hash.to_string()));
    report
}

fn section(name: &str, records: u64, bytes: u64, hash: Hash) -> Value {
    json!({ "name": name, "records": records, "bytes": bytes, "hash": hash.to_string() })
}
