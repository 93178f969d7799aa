use crate::bisect::faulty;
use crate::container::{repair, sections};
use crate::sandbox::{SCENE, Sandbox};

/// Scenes and replays are stepped in every way; what was compared is told.
#[test]
fn sound_files() {
    let sandbox = Sandbox::recorded("heavy-sound");
    let report = sandbox.run(&["heavy", "a.ron", "a.replay", "--exact"]).expect(0);
    assert_eq!(
        report.text(),
        "a.ron: sound: 6 ticks\na.replay: sound: 6 ticks\n2 files sound: 12 ticks in 4 ways each\n"
    );
    assert_eq!(report.stderr, "");
    let report = sandbox.run_with(&["heavy", "-"], SCENE.as_bytes()).expect(0);
    assert!(report.text().starts_with("stdin: sound: 6 ticks\n"), "{}", report.text());
}

/// A folder stands for its scenes and replays; the order is theirs with any number of jobs.
#[test]
fn folders_are_searched() {
    let sandbox = Sandbox::recorded("heavy-folder");
    let replay = sandbox.read("a.replay");
    for index in 0..5 {
        sandbox.write(&format!("f/{index}.replay"), &replay);
        sandbox.write(&format!("f/{index}.scene.ron"), SCENE.as_bytes());
    }
    sandbox.write("f/not.txt", b"");
    let one = sandbox.run(&["heavy", "f", "--json"]).expect(0);
    let four = sandbox.run(&["heavy", "f", "--json", "--jobs", "4"]).expect(0);
    assert_eq!(one.text(), four.text());
    let json = one.json();
    assert_eq!((&json["sound"], &json["ticks"]), (&10.into(), &60.into()));
    assert_eq!(json["files"][1]["path"], "f/0.scene.ron");
    sandbox.write("g/not.txt", b"");
    sandbox.run(&["heavy", "g"]).expect(3).says("no *.replay or *.scene.ron in this folder");
}

/// A recording that says something else is found in its tick.
#[test]
fn other_recordings_are_found() {
    let sandbox = faulty("heavy-other", "2");
    let report = sandbox.run(&["heavy", "b.replay", "a.replay"]).expect(1);
    let text = report.text();
    assert!(text.starts_with("b.replay: diverged: state of tick 4: "), "{text}");
    assert!(text.ends_with("1 file sound, 1 diverged: 9 ticks in 4 ways each\n"), "{text}");
    let json = sandbox.run(&["heavy", "b.replay", "--json"]).expect(1).json();
    assert_eq!(json["files"][0]["divergence"]["tick"], 4);
}

/// What cannot be stepped proves nothing; other files are stepped all the same.
#[test]
fn impossible_files() {
    let sandbox = Sandbox::recorded("heavy-impossible");
    let mut bytes = sandbox.read("a.replay");
    let input = sections(&bytes)[3].start;
    bytes[input + 8] = 99; // no such action
    repair(&mut bytes);
    sandbox.write("bad.replay", &bytes);
    sandbox.run(&["heavy", "bad.replay"]).expect(3).says("bad.replay: offset ");
    sandbox.run(&["run", "a.ron", "--ticks", "0", "--record", "empty.replay"]).expect(0);
    sandbox.run(&["heavy", "a.replay", "--jobs", "0"]).expect(2);
    sandbox.run(&["heavy", "empty.replay"]).expect(3).says("no ticks: nothing proven");
    let report = sandbox.run(&["heavy", "a.snap", "none", "a.replay"]).expect(3);
    assert!(report.text().contains("1 file sound, 1 unproven, 1 unread: 6 ticks"));
    report.says("it is a snapshot, and a scene or a replay is wanted");
}
