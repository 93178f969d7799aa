use verlock::replay::Replay;

use crate::container::{repair, sections};
use crate::sandbox::{Outcome, Sandbox};

/// The sections of a replay by their place in the file.
const START: usize = 1;
const TICK: usize = 2;
const INPUT: usize = 3;
const STATE: usize = 5;
/// Bytes of a tick's record; its last 16 are the hash of the state.
const RECORD: usize = 32;

/// Verifies `a.replay` after a change that its hashes do not give away.
fn verify_changed(sandbox: &Sandbox, change: impl FnOnce(&mut Vec<u8>)) -> Outcome {
    let mut bytes = sandbox.read("a.replay");
    change(&mut bytes);
    repair(&mut bytes);
    sandbox.write("changed.replay", &bytes);
    sandbox.run(&["verify", "changed.replay"])
}

/// What was compared is told, for each replay and in total.
#[test]
fn recorded_is_verified() {
    let sandbox = Sandbox::recorded("verify-good");
    let report = sandbox.run(&["verify", "a.replay"]).expect(0);
    assert_eq!(
        report.text(),
        "a.replay: verified: 6 ticks, 2 particles, 1 constraint\n\
         1 replay verified: 6 ticks, 12 particle states, 6 constraint states compared\n"
    );
    assert_eq!(report.stderr, "");
    let json = sandbox.run(&["verify", "a.replay", "--json"]).expect(0).json();
    assert_eq!(json["replays"][0]["verdict"], "verified");
    assert_eq!(json["particle_states"], 12);
}

/// A folder stands for the replays below it in order; without any it compares nothing.
#[test]
fn folders_are_searched() {
    let sandbox = Sandbox::recorded("verify-folder");
    let replay = sandbox.read("a.replay");
    for file in ["f/z.replay", "f/b/c.replay", "f/b/not.txt"] {
        sandbox.write(file, &replay);
    }
    let report = sandbox.run(&["verify", "f"]).expect(0);
    let order = ["f/b/c.replay: v", "f/z.replay: v", "2 replays verified: 12 ticks"];
    assert!(report.text().lines().zip(order).all(|(line, start)| line.starts_with(start)));
    assert_eq!(report.text().lines().count(), 3);

    sandbox.write("g/not.txt", &replay);
    sandbox.run(&["verify", "g"]).expect(3).says("g: no *.replay in this folder: nothing proven");
}

/// A changed command is found in its own tick.
#[test]
fn changed_command_is_found() {
    let sandbox = Sandbox::recorded("verify-command");
    let report = verify_changed(&sandbox, |bytes| {
        let last = sections(bytes)[INPUT].end - 1;
        bytes[last] ^= 0x40; // of the impulse in tick 4
    });
    let report = report.expect(1);
    let start = "changed.replay: diverged: tick 4: the inputs differ: recorded ";
    assert!(report.text().starts_with(start), "{}", report.text());
    assert!(report.text().ends_with(
        "0 replays verified, 1 diverged: 4 ticks, 8 particle states, 4 constraint states compared\n"
    ));
}

/// A changed hash is found in its tick. Only a keyframe knows what has the hash, and it differs in
/// nothing here.
#[test]
fn changed_hash_is_found() {
    let sandbox = Sandbox::recorded("verify-hash");
    for tick in 0..6 {
        let report = verify_changed(&sandbox, |bytes| {
            let end = sections(bytes)[TICK].start + (tick + 1) * RECORD;
            bytes[end - 1] ^= 1;
        });
        let start = format!("changed.replay: diverged: tick {tick}: the state differs: recorded ");
        assert!(report.expect(1).text().starts_with(&start));
    }
}

/// A changed keyframe is found, and told apart field by field.
#[test]
fn changed_keyframe_is_found() {
    let sandbox = Sandbox::recorded("verify-keyframe");
    let change = |bytes: &mut Vec<u8>| {
        let states = sections(bytes)[STATE].clone();
        let length = states.len() / 3;
        let keyframe = &mut bytes[states.start + length..][..length];
        let displacement = sections(keyframe)[3].start;
        keyframe[displacement + 12] ^= 1; // x of particle 1
        repair(keyframe);
    };
    let report = verify_changed(&sandbox, change).expect(1);
    let text = report.text();
    assert!(text.contains("diverged: tick 3: the keyframe differs: recorded "), "{text}");
    let line = text.lines().find(|line| line.starts_with("  displacement 1 x: "));
    assert!(line.is_some_and(|line| line.contains("(raw 0x")), "{text}");
    let json = sandbox.run(&["verify", "changed.replay", "--json"]).expect(1).json();
    let divergence = &json["replays"][0]["divergence"];
    assert_eq!(divergence["tick"], 3);
    assert_eq!(divergence["kind"], "keyframe");
    assert_eq!(divergence["differences"][0]["section"], "displacement");
}

/// A changed start diverges in the first tick, and the keyframe after it tells where.
#[test]
fn changed_start_is_found() {
    let sandbox = Sandbox::recorded("verify-start");
    sandbox.run(&["run", "a.ron", "--record", "a.replay", "--keyframes", "1", "--force"]).expect(0);
    let change = |bytes: &mut Vec<u8>| {
        let start = sections(bytes)[START].clone();
        let start = &mut bytes[start];
        let displacement = sections(start)[3].start;
        start[displacement + 20] ^= 0x10; // z of particle 1
        repair(start);
    };
    let report = verify_changed(&sandbox, change).expect(1);
    let text = report.text();
    assert!(text.contains("diverged: tick 0: the state differs: recorded "), "{text}");
    assert!(text.contains("\n  position 1 z: 0 against "), "{text}");
}

/// A replay made by other rules proves nothing and is not called a divergence.
#[test]
fn other_rules_prove_nothing() {
    let sandbox = Sandbox::recorded("verify-rules");
    let report = verify_changed(&sandbox, |bytes| bytes[12] = 7).expect(3);
    let report = report.says("offset 12: made by SIM_VERSION 7").says("nothing proven");
    assert!(!report.text().contains("diverged"));
}

/// Nor does one of a game, whose rules are not in this program.
#[test]
fn games_are_not_stepped() {
    let sandbox = Sandbox::recorded("verify-game");
    let mut bytes = sandbox.read("a.replay");
    let start = sections(&bytes)[0].start;
    let name = b"verlock.world";
    let at = bytes[start..].windows(name.len()).position(|part| part == name).expect("a name");
    bytes[start + at..][..name.len()].copy_from_slice(b"my.game\0\0\0\0\0\0");
    repair(&mut bytes);
    sandbox.write("game.replay", &bytes);
    let line = "recorded by \"my.game\" version 0; this program steps `verlock.world` only";
    for args in
        [&["verify", "game.replay"][..], &["heavy", "game.replay"], &["render", "game.replay"]]
    {
        let report = sandbox.run(args).expect(3).says(line);
        report.says("call `verlock::replay::verify::<YourGame>`: nothing proven");
    }
    let json = sandbox.run(&["bisect", "a.replay", "game.replay", "--json"]).expect(1).json();
    let simulations = serde_json::json!({ "a": "verlock.world 0", "b": "my.game 0" });
    assert_eq!(json["simulations"], simulations);
    let json = sandbox.run(&["bisect", "a.replay", "a.replay", "--json"]).expect(0).json();
    assert_eq!(json["simulations"], serde_json::Value::Null);
}

/// Neither does a damaged or cut one, nor what is no replay at all.
#[test]
fn damage_proves_nothing() {
    let sandbox = Sandbox::recorded("verify-damage");
    let replay = sandbox.read("a.replay");
    for offset in (0..replay.len()).step_by(97) {
        let mut bytes = replay.clone();
        bytes[offset] ^= 0x10;
        let why = if offset < 8 { "stdin: it is of no known kind" } else { "stdin: offset " };
        sandbox.run_with(&["verify", "-"], &bytes).expect(3).says(why);
        let cut = sandbox.run_with(&["verify", "-"], &replay[..offset.max(1)]).expect(3);
        cut.says("stdin: offset ").says("nothing proven");
    }
    sandbox.run(&["verify", "a.snap"]).expect(3).says("it is a snapshot, and a replay is wanted");
}

/// A failure does not stop the next replay; a divergence outweighs damage, and that a missing file.
#[test]
fn all_are_verified() {
    let sandbox = Sandbox::recorded("verify-all");
    let replay = sandbox.read("a.replay");
    assert!(Replay::parse(&replay).is_ok());
    sandbox.write("cut.replay", &replay[..100]);
    verify_changed(&sandbox, |bytes| {
        let last = sections(bytes)[INPUT].end - 1;
        bytes[last] ^= 0x40;
    });
    let report = sandbox.run(&["verify", "none.replay", "a.replay"]).expect(2);
    assert!(report.text().contains("1 replay verified, 1 unread: 6 ticks"), "{}", report.text());
    sandbox.run(&["verify", "none.replay", "cut.replay", "a.replay"]).expect(3);
    let all = ["none.replay", "cut.replay", "changed.replay", "a.replay"];
    let report = sandbox.run(&[&["verify"], &all[..]].concat()).expect(1);
    let total = "1 replay verified, 1 diverged, 1 unproven, 1 unread: 10 ticks";
    assert!(report.text().contains(total), "{}", report.text());
    let json = sandbox.run(&[&["verify", "--json"], &all[..]].concat()).expect(1).json();
    let verdicts: Vec<_> = (0..4).map(|index| json["replays"][index]["verdict"].clone()).collect();
    assert_eq!(verdicts, ["unread", "unproven", "diverged", "verified"]);
}
