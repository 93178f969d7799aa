use crate::container::{repair, sections};
use crate::sandbox::{SCENE, Sandbox};

/// The sections of a replay by their place in the file.
const TICK: usize = 2;
const INPUT: usize = 3;
/// Bytes of a tick's record; the last 16 are the hash of the state, those before are the inputs'.
const RECORD: usize = 32;

/// A sandbox with two recordings of the same commands with so many ticks between keyframes:
/// `b.replay` is of a machine on which the push in tick 3 came out twice as strong.
pub(crate) fn faulty(name: &str, keyframes: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write("pushed.ron", SCENE.replacen("(0, 0, 1)", "(0, 0, 2)", 1).as_bytes());
    for (scene, replay) in [("a.ron", "a.replay"), ("pushed.ron", "b.replay")] {
        let args = ["run", scene, "--record", replay, "--keyframes", keyframes];
        sandbox.run(&args).expect(0);
    }
    let a = sandbox.read("a.replay");
    let mut b = sandbox.read("b.replay");
    let (from, to) = (sections(&a), sections(&b));
    b[to[INPUT].clone()].copy_from_slice(&a[from[INPUT].clone()]);
    for at in (0..to[TICK].len()).step_by(RECORD) {
        let (from, to) = (from[TICK].start + at, to[TICK].start + at);
        b[to..to + RECORD - 16].copy_from_slice(&a[from..from + RECORD - 16]);
    }
    repair(&mut b);
    sandbox.write("b.replay", &b);
    sandbox
}

/// The same recording is equal in whatever file it is.
#[test]
fn equal_recordings() {
    let sandbox = Sandbox::recorded("bisect-equal");
    sandbox.run(&["run", "a.ron", "--hashes", "a.hashes"]).expect(0);
    for (a, b) in [
        ("a.replay", "a.replay"),
        ("a.replay", "a.ron"),
        ("a.ron", "a.ron"),
        ("a.hashes", "a.replay"),
        ("a.ron", "a.hashes"),
    ] {
        let json = sandbox.run(&["bisect", a, b, "--json"]).expect(0).json();
        assert_eq!(json["equal"], true, "{a} {b}");
        assert_eq!(json["compared_states"], 7, "{a} {b}");
    }
    let report = sandbox.run_with(&["bisect", "-", "a.ron"], &sandbox.read("a.replay")).expect(0);
    assert!(report.text().starts_with("equal true\ncompared_states 7\n"), "{}", report.text());
}

/// Another step is found, with the last equal state, the sections, whom this machine agrees with,
/// and what to do next, which works.
#[test]
fn another_step_is_found() {
    let sandbox = faulty("bisect-step", "1");
    let json = sandbox.run(&["bisect", "a.replay", "b.replay", "--json"]).expect(1).json();
    assert_eq!((&json["tick"], &json["last_equal_tick"]), (&4.into(), &3.into()));
    assert_eq!((&json["cause"], &json["different_states"]), (&"step".into(), &3.into()));
    assert_eq!(json["this_machine"], "agrees with a");
    assert_eq!(json["sections"], serde_json::json!(["position", "displacement", "carry"]));
    let swapped = sandbox.run(&["bisect", "b.replay", "a.replay", "--json"]).expect(1).json();
    assert_eq!(swapped["this_machine"], "agrees with b");
    let next = json["next"].as_str().expect("a command");
    assert_eq!(next, "verlock diff a.replay b.replay --tick 4");
    let args: Vec<&str> = next.split(' ').skip(1).collect();
    let text = sandbox.run(&args).expect(1);
    assert!(text.text().contains("\nposition 1 z: "), "{}", text.text());
}

/// A machine whose state is not in its file is told from one whose is.
#[test]
fn unknown_states_are_told() {
    let sandbox = faulty("bisect-unknown", "3");
    let json = sandbox.run(&["bisect", "a.replay", "b.replay", "--json"]).expect(1).json();
    assert_eq!(json["known_states"], serde_json::json!({ "a": true, "b": false }));
    assert_eq!((&json["tick"], json.get("sections")), (&4.into(), None));
    assert_eq!(json["next"], "verlock diff a.replay b.replay");
    let missing = json["missing_states"][0].as_str().expect("a text");
    assert!(missing.starts_with("b.replay holds no state of tick 4: record it again"), "{missing}");
    assert!(missing.contains("`run --keyframes 4`"), "{missing}");

    // Whatever is told is explained.
    let help = sandbox.run(&["bisect", "--help"]).expect(0);
    for key in json.as_object().expect("an object").keys() {
        let explained = help.text().lines().any(|line| {
            let (names, _) = line.trim().split_once("  ").unwrap_or_default();
            names.split(", ").any(|name| name == key)
        });
        assert!(explained, "{key} in {}", help.text());
    }
}

/// Other inputs are to blame for another state.
#[test]
fn inputs_are_blamed() {
    let sandbox = faulty("bisect-inputs", "0");
    let report = sandbox.run(&["bisect", "a.ron", "pushed.ron"]).expect(1);
    for line in ["tick 4", "cause inputs", "different_inputs_tick 3"] {
        assert!(report.text().lines().any(|found| found == line), "{}", report.text());
    }
}

/// Hash logs tell the tick and no more; gaps and lengths are seen.
#[test]
fn hash_logs_are_compared() {
    let sandbox = faulty("bisect-logs", "0");
    for (scene, log) in [("a.ron", "a.hashes"), ("pushed.ron", "b.hashes")] {
        sandbox.run(&["run", scene, "--hashes", log]).expect(0);
    }
    let json = sandbox.run(&["bisect", "a.hashes", "b.hashes", "--json"]).expect(1).json();
    assert_eq!((&json["tick"], &json["cause"]), (&4.into(), &"unknown".into()));
    assert_eq!(json["next"], serde_json::Value::Null);
    let json = sandbox.run(&["bisect", "b.replay", "b.hashes", "--json"]).expect(0).json();
    assert_eq!(json["compared_states"], 7);
    let all = String::from_utf8(sandbox.read("a.hashes")).expect("a text");
    let some: Vec<&str> = all.lines().step_by(3).take(2).collect();
    sandbox.write("some.hashes", some.join("\n").as_bytes());
    let json = sandbox.run(&["bisect", "some.hashes", "a.replay", "--json"]).expect(1).json();
    assert_eq!((&json["compared_states"], &json["different_states"]), (&2.into(), &0.into()));
    assert_eq!(json["a"]["last_tick"], 3);
}

/// What cannot be compared proves nothing, and says why.
#[test]
fn nothing_to_compare() {
    let sandbox = Sandbox::recorded("bisect-nothing");
    let hash = "0123456789abcdef0123456789abcdef";
    sandbox.write("late.hashes", format!("1000 {hash}\n").as_bytes());
    sandbox.write("bad.hashes", format!("# made by hand\n7 {hash}\n6 {hash}\n").as_bytes());
    sandbox.write("far.hashes", format!("{} {hash}\n", u64::MAX).as_bytes());
    sandbox.run(&["bisect", "a.replay", "late.hashes"]).expect(3).says("no tick in common with");
    sandbox.run(&["bisect", "a.replay", "bad.hashes"]).expect(3).says("bad.hashes: line 3: its");
    sandbox.run(&["bisect", "a.ron", "far.hashes"]).expect(3).says("a.ron: no scene is stepped");
    let report = sandbox.run(&["bisect", "a.replay", "a.snap"]).expect(3);
    report.says("it is a snapshot, and a replay, a hash log or a scene is wanted");
    sandbox.run(&["bisect", "-", "-"]).expect(2).says("stdin");
}
