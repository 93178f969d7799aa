//! Every small damage to a file, through the functions that the commands use.

#[path = "../tests/cli/container.rs"]
mod container;

use verlock::World;
use verlock::replay::Recorder;
use verlock::scene::Scene;

use crate::exit::Exit;
use crate::input::Input;
use crate::state::State;
use crate::verdict::Verdict;

const SCENE: &str = "(
    version: 1,
    particles: [(pinned: true), (position: (1, 0, 0))],
    distances: [(a: 0, b: 1)],
    timeline: [(tick: 1, action: Impulse(particle: 1, impulse: (0, 0, 1)))],
)";

fn record(ticks: u64) -> Recorder<World> {
    let scene = Scene::parse(SCENE).expect("a scene");
    let mut recorder = Recorder::new(scene.build().expect("a world"), 2);
    for _ in 0..ticks {
        let commands = scene.commands(recorder.simulation());
        recorder.step(&commands);
    }
    recorder
}

/// The bytes with each of their bits flipped, and where.
fn flips(bytes: &[u8]) -> impl Iterator<Item = (usize, Vec<u8>)> {
    (0..8 * bytes.len()).map(|bit| {
        let mut flipped = bytes.to_vec();
        flipped[bit / 8] ^= 1 << (bit % 8);
        (bit / 8, flipped)
    })
}

/// All shorter beginnings of the bytes, and the bytes with one more.
fn cuts(bytes: &[u8]) -> impl Iterator<Item = Vec<u8>> {
    let longer = [bytes, &[0]].concat();
    (0..bytes.len()).map(|end| bytes[..end].to_vec()).chain([longer])
}

fn is_unproven(bytes: Vec<u8>) -> bool {
    let input = Input::new("damaged".into(), bytes);
    State::at(&input, None).is_err_and(|failure| failure.exit() == Exit::Unproven)
}

/// A replay with a flipped bit, cut or with a byte too many proves nothing.
#[test]
fn damaged_replays_prove_nothing() {
    let replay = record(3).replay();
    assert!(matches!(Verdict::of(&replay, |_| {}), Verdict::Verified(_)));
    for (offset, bytes) in flips(&replay) {
        assert!(matches!(Verdict::of(&bytes, |_| {}), Verdict::Unproven(_)), "offset {offset}");
        assert!(is_unproven(bytes), "offset {offset}");
    }
    for bytes in cuts(&replay) {
        let length = bytes.len();
        assert!(matches!(Verdict::of(&bytes, |_| {}), Verdict::Unproven(_)), "{length} bytes");
        assert!(is_unproven(bytes), "{length} bytes");
    }
}

/// A snapshot with a flipped bit, cut or with a byte too many is no world.
#[test]
fn damaged_snapshots_are_refused() {
    let snapshot = record(3).simulation().save();
    assert!(!is_unproven(snapshot.clone()));
    for (offset, bytes) in flips(&snapshot) {
        assert!(is_unproven(bytes), "offset {offset}");
    }
    for bytes in cuts(&snapshot) {
        let length = bytes.len();
        assert!(is_unproven(bytes), "{length} bytes");
    }
}

/// With all hashes repaired, a flipped bit in any section is found by stepping or by checks; only
/// the distance between keyframes means nothing to a verification.
#[test]
fn replays_with_repaired_hashes_do_not_verify() {
    let replay = record(3).replay();
    let sections = container::sections(&replay);
    let interval = sections[0].start + 20..sections[0].start + 24;
    let mut diverged = 0;
    for (offset, mut bytes) in flips(&replay).filter(|&(offset, _)| offset >= sections[0].start) {
        container::repair(&mut bytes);
        match Verdict::of(&bytes, |_| {}) {
            Verdict::Verified(_) => assert!(interval.contains(&offset), "offset {offset}"),
            Verdict::Diverged(..) => diverged += 1,
            Verdict::Unproven(_) => assert!(!interval.contains(&offset), "offset {offset}"),
        }
    }
    // The hashes of three ticks and one command, all of their bits.
    assert!(diverged >= 8 * (3 * 24 + 44), "{diverged}");
}
