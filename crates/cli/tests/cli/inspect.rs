use serde_json::Value;
use verlock::World;
use verlock::snapshot::Section;

use crate::bisect::faulty;
use crate::sandbox::Sandbox;

/// Every kind of file is recognised, with its versions, counts and sections.
#[test]
fn info_knows_every_kind() {
    let sandbox = Sandbox::recorded("info");
    for (file, kind, sections) in [
        ("a.ron", "scene", 0),
        ("a.snap", "snapshot", Section::ALL.len()),
        ("a.replay", "replay", 6),
    ] {
        let json = sandbox.run(&["info", file, "--json"]).expect(0).json();
        assert_eq!(json["kind"], kind);
        let when = if kind == "replay" { "start_" } else { "" };
        assert_eq!(json[format!("{when}particles")], 2);
        assert_eq!(json[format!("{when}distances")], 1);
        assert_eq!(json["sections"].as_array().map_or(0, Vec::len), sections, "{file}");
        let text = sandbox.run(&["info", file]).expect(0);
        assert!(text.text().starts_with(&format!("kind {kind}\n")), "{}", text.text());
        assert_eq!(text.text().matches("\nsections name=").count(), sections);
    }
    let json = sandbox.run(&["info", "a.replay", "--json"]).expect(0).json();
    assert_eq!(json["ticks"], 6);
    assert_eq!(json["inputs"], 2);
    assert_eq!(json["keyframes"], 3);
    assert_eq!(json["name"], "verlock.world");
    let last = sandbox.run(&["hash", "a.replay"]).expect(0);
    assert_eq!(json["last_hash"], last.text().trim());
    sandbox.run(&["run", "a.ron", "--hashes", "a.hashes"]).expect(0);
    let json = sandbox.run(&["info", "a.hashes", "--json"]).expect(0).json();
    let expected = serde_json::json!(["hash log", 7, 0, 6]);
    let found = ["kind", "states", "first_tick", "last_tick"].map(|name| json[name].clone());
    assert_eq!(Value::from(found.to_vec()), expected);
    sandbox.write("noise", &[0xff; 100]);
    sandbox.run(&["info", "noise"]).expect(3).says("of no known kind, and not UTF-8 at offset 0");
}

/// Texts are told apart by how they begin.
#[test]
fn texts_are_told_apart() {
    let sandbox = Sandbox::new("info-texts");
    let kind = |text: &str| {
        let report = sandbox.run_with(&["info", "-", "--json"], text.as_bytes()).expect(0);
        report.json()["kind"].as_str().expect("a kind").to_owned()
    };
    let hash = "0123456789abcdef0123456789abcdef";
    assert_eq!(kind("# a log of no state\n\n# so far\n"), "hash log");
    assert_eq!(kind("\n\n"), "hash log");
    assert_eq!(kind(&format!("# a log\n\n7 {hash}\n")), "hash log");
    assert_eq!(kind(&format!("\u{feff}7 {hash}\n")), "hash log");
    assert_eq!(kind("#![enable(implicit_some)]\n(version: 1)"), "scene");
    assert_eq!(kind("\u{feff}// a scene\n(version: 1)"), "scene");
    let markdown = b"# Notes\n\nVersion 2 is better.\n";
    let refused = |bytes: &[u8]| sandbox.run_with(&["info", "-"], bytes).expect(3);
    refused(markdown).says("stdin: it is a text, but neither a scene nor a hash log");
    refused(b"").says("stdin: is empty");
    refused(b"\xff\xfe(\0").says("it is UTF-16, and texts are read as UTF-8");
    refused(b"// caf\xe9\n(version: 1)").says("not UTF-8 at offset 6");
}

/// Of what cannot be read, the header and the table are told all the same.
#[test]
fn headers_are_told() {
    let sandbox = Sandbox::recorded("info-header");
    for (file, sections) in [("a.snap", Section::ALL.len()), ("a.replay", 6)] {
        let mut bytes = sandbox.read(file);
        bytes[12] = 7;
        let report = sandbox.run_with(&["info", "-", "--json"], &bytes).expect(3);
        assert_eq!(report.json()["sim_version"], 7);
        assert_eq!(report.json()["readable"], false);
        assert_eq!(report.json()["sections"].as_array().map_or(0, Vec::len), sections);
        report.says("made by SIM_VERSION 7");
        let cut = sandbox.run_with(&["info", "-"], &bytes[..30]).expect(3);
        assert!(cut.text().contains("\nsim_version 7\n"), "{}", cut.text());
        sandbox.run_with(&["info", "-"], &bytes[..9]).expect(3).says("offset 9");
    }
}

/// A state that is not the recorded one is not called by the recorded hash, nor hidden behind it.
#[test]
fn other_states_have_two_hashes() {
    let sandbox = faulty("hash-other", "0");
    let args = ["hash", "b.replay", "--tick", "4"];
    let recorded = sandbox.run(&args).expect(0);
    let recorded = recorded.text().trim();
    let both = sandbox.run(&[&args[..], &["--parts"]].concat()).expect(1);
    let lines: Vec<_> = both.text().lines().take(2).collect();
    let stepped = sandbox.run(&["hash", "a.replay", "--tick", "4"]).expect(0);
    assert_eq!(lines, [format!("{recorded} recorded"), format!("{} state", stepped.text().trim())]);
    let json = sandbox.run(&[&args[..], &["--parts", "--json"]].concat()).expect(1).json();
    assert_eq!(
        (&json["recorded_hash"], &json["hash"]),
        (&recorded.into(), &stepped.text().trim().into())
    );
}

/// The hash of a file is that of its world, and its parts are those of the world.
#[test]
fn hash_is_that_of_the_world() {
    let sandbox = Sandbox::recorded("hash");
    let world = World::load(&sandbox.read("a.snap")).expect("a world");
    let parts = world.part_hashes().map(|(section, hash)| format!("{hash} {section}\n"));
    let parts = format!("{} state\n{}", world.hash(), parts.concat());
    let tick = ["--parts", "--tick", "6"];
    for file in ["a.snap", "a.replay", "a.ron"] {
        assert_eq!(sandbox.run(&[&["hash", file], &tick[..]].concat()).expect(0).text(), parts);
    }
    assert_eq!(sandbox.run(&["hash", "a.replay"]).expect(0).text(), format!("{}\n", world.hash()));
    for (args, parts) in [(&["--json"][..], false), (&["--json", "--parts"], true)] {
        let json = sandbox.run(&[&["hash", "a.replay"], args].concat()).expect(0).json();
        assert_eq!((&json["tick"], &json["hash"]), (&6.into(), &world.hash().to_string().into()));
        let part = world.part_hashes()[0].1.to_string();
        assert_eq!(json["parts"]["world"], if parts { part.into() } else { Value::Null });
    }
    sandbox.run(&["run", "a.ron", "--hashes", "a.hashes"]).expect(0);
    let logged = sandbox.run(&["hash", "a.hashes"]).expect(0);
    assert_eq!(logged.text(), format!("{}\n", world.hash()));
    sandbox.run(&["hash", "a.hashes", "--tick", "7"]).expect(2).says("it goes from 0 to 6");
    sandbox
        .run(&["hash", "a.hashes", "--parts"])
        .expect(3)
        .says("it is a hash log, and a snapshot");
    sandbox.run(&["hash", "a.replay", "--tick", "7"]).expect(2).says("it goes from 0 to 6");
    sandbox.run(&["hash", "a.snap", "--tick", "5"]).expect(2).says("it goes from 6 to 6");
}

/// A dump has a line, or a JSON value, for every field of every record.
#[test]
fn dump_has_every_field() {
    let sandbox = Sandbox::recorded("dump");
    let records = [1, 2, 2, 2, 2, 1, 1, 0, 0, 1];
    let fields = Section::ALL.map(|section| section.fields().len());
    let lines: usize =
        records.into_iter().zip(fields).map(|(records, fields)| records * fields).sum();
    for file in ["a.snap", "a.replay"] {
        assert_eq!(sandbox.run(&["dump", file]).expect(0).text().lines().count(), lines);
    }
    let json = sandbox.run(&["dump", "a.snap", "--json"]).expect(0).json();
    for (section, (records, fields)) in
        Section::ALL.into_iter().zip(records.into_iter().zip(fields))
    {
        let rows = json[section.name()].as_array().expect("a list");
        assert_eq!(rows.len(), records, "{section}");
        assert!(rows.iter().all(|row| row.as_object().is_some_and(|row| row.len() == fields)));
    }
    assert_eq!(json["tick"], 6);
}

/// One section at one tick; the start of the scene is there with its values and bits.
#[test]
fn dump_of_a_section() {
    let sandbox = Sandbox::recorded("dump-section");
    let start = "position 0 x: 0 (raw 0x0000000000000000)\n\
                 position 0 y: 0 (raw 0x0000000000000000)\n\
                 position 0 z: 0 (raw 0x0000000000000000)\n\
                 position 1 x: 1 (raw 0x0000000001000000)\n\
                 position 1 y: 0 (raw 0x0000000000000000)\n\
                 position 1 z: 0 (raw 0x0000000000000000)\n";
    for file in ["a.ron", "a.replay"] {
        let dump = sandbox.run(&["dump", file, "--tick", "0", "--section", "position"]).expect(0);
        assert_eq!(dump.text(), start);
    }
    sandbox.run(&["dump", "a.snap", "--section", "nowhere"]).expect(2);
}
