use verlock::World;
use verlock::replay::Recorder;
use verlock::snapshot::Section;

use crate::bisect::faulty;
use crate::container::{repair, sections};
use crate::sandbox::{SCENE, Sandbox};

/// A sandbox with a second recording, `b.replay`, in which the push is stronger.
fn pushed(name: &str) -> Sandbox {
    let sandbox = Sandbox::recorded(name);
    sandbox.write("b.ron", SCENE.replacen("(0, 0, 1)", "(0, 0, 2)", 1).as_bytes());
    sandbox.run(&["run", "b.ron", "--record", "b.replay", "--save", "b.snap"]).expect(0);
    sandbox
}

/// Equal states are equal in whatever file they are.
#[test]
fn equal_states() {
    let sandbox = Sandbox::recorded("diff-equal");
    for (a, b) in [("a.snap", "a.snap"), ("a.replay", "a.snap"), ("a.snap", "a.ron")] {
        let report = sandbox.run(&["diff", a, b]).expect(0);
        assert!(report.text().starts_with("equal at tick 6: "), "{}", report.text());
    }
    sandbox.run_with(&["diff", "-", "a.replay"], &sandbox.read("a.snap")).expect(0);
    let json = sandbox.run(&["diff", "a.replay", "a.replay", "--json"]).expect(0).json();
    assert_eq!(json["count"], 0);
}

/// Of replays the first tick that differs is found, and in it object, field, values and bits.
#[test]
fn first_difference_is_found() {
    let sandbox = pushed("diff-first");
    let report = sandbox.run(&["diff", "a.replay", "b.replay"]).expect(1);
    // The push is in tick 3: what it did is in the state of tick 4.
    let (head, lines) = report.text().split_once('\n').expect("lines");
    assert!(head.contains(" differences at tick 4: "), "{head}");
    let position = lines.lines().find(|line| line.starts_with("position 1 z: "));
    assert!(position.is_some_and(|line| line.contains(" against ") && line.contains("(raw 0x")));
    assert!(!lines.contains("position 0"), "{lines}");
    sandbox.run(&["diff", "a.replay", "b.replay", "--tick", "3"]).expect(0);
    sandbox.run(&["diff", "a.snap", "b.snap"]).expect(1);
}

/// What a machine stored is what it had, whatever stepping gives here.
#[test]
fn stored_states_are_compared() {
    let sandbox = faulty("diff-stored", "1");
    let report = sandbox.run(&["diff", "a.replay", "b.replay"]).expect(1);
    assert!(report.text().contains(" differences at tick 4: "), "{}", report.text());
    assert_eq!(report.stderr, "");
    let json = sandbox.run(&["diff", "a.replay", "b.replay", "--json"]).expect(1).json();
    assert_eq!(json["origins"], serde_json::json!(["stored", "stored"]));
    assert_eq!(json["as_recorded"], serde_json::json!([true, true]));
    let json = sandbox.run(&["diff", "a.ron", "b.replay", "--json"]).expect(1).json();
    assert_eq!(json["ticks"], serde_json::json!([4, 4]));
    assert_eq!(json["origins"], serde_json::json!(["stepped", "stored"]));
}

/// A stored state that no world can have is compared all the same: only a fault makes such a one.
#[test]
fn impossible_states_are_compared() {
    let sandbox = faulty("diff-impossible-state", "1");
    let mut bytes = sandbox.read("b.replay");
    let states = sections(&bytes)[5].clone();
    let length = states.len() / 6;
    let state = &mut bytes[states.start + 3 * length..][..length]; // of tick 4
    let place = Section::ALL.iter().position(|section| *section == Section::Particle);
    let particles = sections(state)[place.expect("a section")].start;
    let mass = particles + Section::Particle.record_size() as usize;
    state[mass..mass + 8].fill(0); // of particle 1
    repair(state);
    repair(&mut bytes);
    sandbox.write("b.replay", &bytes);
    let report = sandbox.run(&["diff", "a.replay", "b.replay"]).expect(1);
    let line = "particle 1 mass: 1 against 0 (raw 0x0000000001000000 against 0x0000000000000000)";
    assert!(report.text().lines().any(|found| found == line), "{}", report.text());
    report.says("b.replay: tick 4: the stored state is another one than recorded");
}

/// Where a machine's own state is only known by its hash, the next one that it stored is compared;
/// where it stored none, what stepping gives, with a word of warning.
#[test]
fn unknown_states_are_passed_over() {
    let sandbox = faulty("diff-unknown", "3");
    let report = sandbox.run(&["diff", "a.replay", "b.replay"]).expect(1);
    assert!(report.text().contains(" differences at tick 6: "), "{}", report.text());
    report.says("differ from tick 4 on").says("b.replay had then").says("tick 6 is the first");
    let json = sandbox.run(&["diff", "a.replay", "b.replay", "--json"]).expect(1).json();
    assert!(json["notes"][0].as_str().is_some_and(|note| note.contains("tick 6 is the first")));

    let report = sandbox.run(&["diff", "a.replay", "b.replay", "--tick", "5"]).expect(1);
    report.says("b.replay: tick 5: stepping again gives another state than recorded");
}

/// Where a machine's own state is only known by its hash, that hash is compared: states that differ
/// are never called equal because stepping gives the other one.
#[test]
fn recorded_hashes_are_compared() {
    let sandbox = faulty("diff-hashes-only", "0");
    let good = sandbox.run(&["hash", "a.replay", "--tick", "4"]).expect(0);
    let bad = sandbox.run(&["hash", "b.replay", "--tick", "4"]).expect(0);
    let (good, bad) = (good.text().trim(), bad.text().trim());
    let line = format!(
        "tick 4: recorded hashes differ ({good} against {bad}); b.replay holds no state of it\n"
    );
    sandbox.run(&["run", "a.ron", "--ticks", "4", "--save", "a4.snap"]).expect(0);
    sandbox.run(&["run", "pushed.ron", "--ticks", "4", "--save", "b4.snap"]).expect(0);
    for (a, tick) in
        [("a.replay", &[][..]), ("a.replay", &["--tick", "4"]), ("a4.snap", &[]), ("a.ron", &[])]
    {
        let report = sandbox.run(&[&["diff", a, "b.replay"], tick].concat()).expect(1);
        assert_eq!(report.text(), line, "{a}");
        report.says("b.replay: tick 4: stepping again gives another state than recorded");
    }
    let json = sandbox.run(&["diff", "a4.snap", "b.replay", "--json"]).expect(1).json();
    assert_eq!(json["equal"], false);
    assert_eq!(json["recorded_hashes"], serde_json::json!([good, bad]));

    // The same hash, but no state that has it can be shown.
    let report = sandbox.run(&["diff", "b4.snap", "b.replay"]).expect(3);
    let head = format!("tick 4: recorded hashes are equal ({bad}), but b.replay holds no state");
    assert!(report.text().starts_with(&head), "{}", report.text());
    let json = sandbox.run(&["diff", "b4.snap", "b.replay", "--json"]).expect(3).json();
    assert_eq!(json["equal"], serde_json::Value::Null);
}

/// Recordings with other inputs, or with other stored bytes, are not equal.
#[test]
fn recordings_differ_in_more_than_hashes() {
    let sandbox = Sandbox::recorded("diff-more");
    let mut bytes = sandbox.read("a.replay");
    let last = sections(&bytes)[5].end - 1;
    bytes[last] ^= 1;
    repair(&mut bytes);
    sandbox.write("stored.replay", &bytes);
    sandbox.run(&["diff", "a.replay", "stored.replay"]).expect(3).says("damaged");
    let other =
        SCENE.replacen("particle: 9, impulse: (0, 0, 1)", "particle: 9, impulse: (0, 0, 2)", 1);
    sandbox.write("b.ron", other.as_bytes());
    let report = sandbox.run(&["diff", "a.replay", "b.ron"]).expect(1);
    report.says("though not this state: the inputs of tick 4 differ");
}

/// `--max` cuts the list, not the count; JSON tells the same.
#[test]
fn list_is_cut() {
    let sandbox = pushed("diff-max");
    let all = sandbox.run(&["diff", "a.snap", "b.snap"]).expect(1);
    let cut = sandbox.run(&["diff", "a.snap", "b.snap", "--max", "1"]).expect(1);
    assert_eq!(cut.text().lines().count(), 2);
    assert_eq!(cut.text().lines().next(), all.text().lines().next());
    let json = sandbox.run(&["diff", "a.snap", "b.snap", "--json"]).expect(1).json();
    let differences = json["differences"].as_array().expect("a list");
    assert_eq!(differences.len(), all.text().lines().count() - 1);
    assert_eq!(json["count"], differences.len());
    assert!(differences.iter().all(|difference| difference["a"]["raw"] != difference["b"]["raw"]));
}

/// A recorded hash that stepping does not give is a difference too, and told as such.
#[test]
fn wrong_recording_differs() {
    let sandbox = Sandbox::recorded("diff-wrong");
    let mut bytes = sandbox.read("a.replay");
    let hash = sections(&bytes)[2].start + 3 * 32 - 1;
    bytes[hash] ^= 1;
    repair(&mut bytes);
    sandbox.write("wrong.replay", &bytes);
    let report = sandbox.run(&["diff", "a.replay", "wrong.replay"]).expect(1);
    assert!(report.text().starts_with("tick 3: recorded hashes differ ("), "{}", report.text());
    report.says("wrong.replay: tick 3: stepping again gives another state than recorded");
}

/// A recording that goes on where the other ends is not equal to it.
#[test]
fn longer_recording_differs() {
    let sandbox = Sandbox::recorded("diff-longer");
    sandbox.run(&["run", "a.ron", "--ticks", "9", "--record", "long.replay"]).expect(0);
    sandbox.run(&["diff", "a.replay", "long.replay"]).expect(1).says("ticks 0 to 6 against 0 to 9");
}

/// Replays without a common tick compare nothing.
#[test]
fn nothing_in_common() {
    let sandbox = Sandbox::recorded("diff-nothing");
    sandbox.run(&["run", "a.ron", "--ticks", "5", "--record", "early.replay"]).expect(0);
    let end = World::load(&sandbox.read("a.snap")).expect("a world");
    let mut recorder = Recorder::new(end, 0);
    recorder.step(&[]);
    sandbox.write("late.replay", &recorder.replay());
    let report = sandbox.run(&["diff", "early.replay", "late.replay"]).expect(3);
    report.says("no tick in common").says("nothing proven");
}

/// States that are not there or not sound are not compared.
#[test]
fn impossible_comparisons() {
    let sandbox = Sandbox::recorded("diff-impossible");
    sandbox.run(&["diff", "a.snap", "a.ron", "--tick", "2"]).expect(2).says("tick 2 is not in it");
    sandbox.run(&["run", "a.ron", "--hashes", "a.hashes"]).expect(0);
    let report = sandbox.run(&["diff", "a.snap", "a.hashes"]).expect(3);
    report.says("a.hashes: it is a hash log, and a snapshot, a replay or a scene is wanted");
    let report = sandbox.run(&["diff", "a.hashes", "a.replay"]).expect(3);
    report.says("a.hashes: it is a hash log, and a snapshot, a replay or a scene is wanted");
    sandbox.run(&["diff", "-", "-"]).expect(2).says("stdin");
    sandbox.write("cut.snap", &sandbox.read("a.snap")[..50]);
    sandbox.run(&["diff", "a.snap", "cut.snap"]).expect(3).says("cut.snap: offset 50");
}
