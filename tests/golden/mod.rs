//! Every fixture scene does what it did when it was accepted, to the bit.

mod restore;
mod shift;
#[cfg(all(feature = "parallel", not(target_family = "wasm")))]
mod threads;
mod typed;

use std::collections::BTreeSet;
use std::fmt::Write;

use verlock::replay::{Recorder, Replay, verify};
use verlock::snapshot::Section;
use verlock::world::World;
use verlock::{Hash, SIM_VERSION};

use crate::support::fixture::{Fixture, is_blessing, read, write};

/// Ticks from one line of a golden file to the next.
const CHECKPOINT: u64 = 10;

/// Ticks from one keyframe of a recorded replay to the next.
const KEYFRAME: u32 = 100;

/// Worlds with longer snapshots are recorded without keyframes, to keep the files small.
const KEYFRAME_MAX: usize = 16 << 10;

/// What became of a scene.
struct Run {
    hashes: String,
    replay: Vec<u8>,
}

impl Run {
    /// Steps a scene to its end and records it.
    fn of(fixture: &Fixture) -> Self {
        let Fixture { name, scene } = fixture;
        let world = scene.build().expect("a good scene");
        let interval = if world.save().len() > KEYFRAME_MAX { 0 } else { KEYFRAME };
        let mut hashes = format!(
            "# {name}.scene.ron, SIM_VERSION {SIM_VERSION}; accepted by BLESS=1 cargo test golden\n\
             # tick, hash of the world, running hash of the worlds of all ticks; then the parts\n\
             # that changed since the line before, by the first digits of their hashes\n"
        );
        let mut recorder = Recorder::new(world, interval);
        let mut running = Hash::default();
        let mut parts = [Hash::default(); Section::ALL.len()];
        for tick in 0..=scene.ticks() {
            let world = recorder.simulation();
            let hash = world.hash();
            running = Hash::of(&[running.to_bytes(), hash.to_bytes()].concat());
            if tick % CHECKPOINT == 0 || tick == scene.ticks() {
                write!(hashes, "{tick} {hash} {running}").expect("a string takes all");
                for ((section, found), last) in world.part_hashes().into_iter().zip(&mut parts) {
                    if found != *last {
                        let digits = &found.to_string()[..8];
                        write!(hashes, " {section}={digits}").expect("a string takes all");
                        *last = found;
                    }
                }
                hashes.push('\n');
            }
            if tick < scene.ticks() {
                let commands = scene.commands(world);
                recorder.step(&commands);
            }
        }
        Self { hashes, replay: recorder.replay() }
    }
}

fn hashes_path(name: &str) -> String {
    format!("golden/{name}.hashes")
}

fn replay_path(name: &str) -> String {
    format!("replays/{name}.replay")
}

/// Hashes and recording of every scene are those that were accepted.
#[test]
fn scenes_are_as_accepted() {
    let blessing = is_blessing();
    let mut report = vec![];
    for fixture in Fixture::all() {
        let name = &fixture.name;
        let run = Run::of(&fixture);
        if blessing {
            write(&hashes_path(name), run.hashes.as_bytes());
            write(&replay_path(name), &run.replay);
        }
        report.extend(difference(name, &read(&hashes_path(name)), &run));
        if read(&replay_path(name)) != run.replay {
            report.push(format!("{name}: the recording differs{}", first_tick(name, &run)));
        }
    }
    assert!(
        report.is_empty(),
        "\n{}\nIf this is meant: change SIM_VERSION and the CHANGELOG, then\n\
         BLESS=1 cargo test golden",
        report.join("\n")
    );
}

/// The first line in which the hashes differ, and which parts do there.
fn difference(name: &str, accepted: &[u8], run: &Run) -> Option<String> {
    let accepted = String::from_utf8_lossy(accepted).replace('\r', "");
    if accepted == run.hashes {
        return None;
    }
    let lines = accepted.lines().zip(run.hashes.lines());
    let Some((old, new)) = lines.into_iter().find(|(old, new)| old != new) else {
        return Some(format!("{name}: {} has another number of lines", hashes_path(name)));
    };
    let words = |line: &str| line.split(' ').skip(3).map(String::from).collect::<BTreeSet<_>>();
    let changed: BTreeSet<_> = words(old)
        .symmetric_difference(&words(new))
        .filter_map(|word| word.split('=').next().map(String::from))
        .collect();
    let changed: Vec<_> = changed.into_iter().collect();
    let parts = if changed.is_empty() { "none".into() } else { changed.join(", ") };
    Some(format!("{name}: parts that differ: {parts}\n  accepted {old}\n  found    {new}"))
}

/// The first tick whose hash is not the recorded one.
fn first_tick(name: &str, run: &Run) -> String {
    let accepted = read(&replay_path(name));
    let old = match Replay::parse(&accepted) {
        Ok(old) => old,
        Err(error) => return format!(": {error}"),
    };
    let new = Replay::parse(&run.replay).expect("what was recorded just now");
    let last = old.len().max(new.len());
    let differs = |tick: &u64| old.hash_after(*tick) != new.hash_after(*tick);
    match (0..last).find(differs) {
        None => ", but no hash does".into(),
        Some(tick) => {
            let [old, new] = [old, new].map(|replay| match replay.hash_after(tick) {
                Some(hash) => hash.to_string(),
                None => "nothing".into(),
            });
            format!(", first after tick {tick}: accepted {old}, found {new}")
        }
    }
}

/// Every recorded replay verifies, and belongs to a scene.
#[test]
fn replays_verify() {
    if is_blessing() {
        return; // they are being written
    }
    let fixtures = Fixture::all();
    let files = std::fs::read_dir(crate::support::fixture::path("replays"));
    let files = files.expect("the folder of replays").count();
    assert_eq!(files, fixtures.len(), "replays, one a scene");
    for Fixture { name, scene } in fixtures {
        let bytes = read(&replay_path(&name));
        let replay = Replay::parse(&bytes).expect("a sound replay");
        assert_eq!(replay.len(), scene.ticks(), "{name}");
        let mut ticks = 0;
        let result = verify::<World>(&replay, |_| ticks += 1);
        assert_eq!(result, Ok(()), "{name}");
        assert_eq!(ticks, scene.ticks(), "{name}");
    }
}

/// A difference is noticed, and its tick and part are named.
#[test]
fn a_difference_is_noticed() {
    let fixture = Fixture::read("pendulum");
    let run = Run::of(&fixture);
    assert_eq!(difference("pendulum", run.hashes.as_bytes(), &run), None);
    let line = run.hashes.lines().find(|line| line.starts_with("50 ")).expect("tick 50");
    let (before, part) = line.split_once(" position=").expect("a moving world");
    let other = format!("{before} position=xxxxxxxx{}", &part[8..]);
    let accepted = run.hashes.replace(line, &other);
    let found = difference("pendulum", accepted.as_bytes(), &run).expect("a difference");
    assert!(found.contains("parts that differ: position\n"), "{found}");
    assert!(found.contains("accepted 50 "), "{found}");
    let longer = format!("{}one more line\n", run.hashes);
    assert!(difference("pendulum", longer.as_bytes(), &run).is_some());
}
