use verlock::scene::Scene;

use crate::sandbox::{SCENE, Sandbox};

/// The report tells ticks, objects, events and the hash that stepping in this process gives.
#[test]
fn tells_what_happened() {
    let sandbox = Sandbox::new("run-tells");
    let scene = Scene::parse(SCENE).expect("a scene");
    let mut world = scene.build().expect("a world");
    for _ in 0..6 {
        let commands = scene.commands(&world);
        world.step(&commands);
    }
    let hash = world.hash();
    let report = format!(
        "tick 6\nparticles 2\ndistances 1\nvolumes 0\nfaces 0\nhalf_spaces 0\n\
         events refused=1\nhash {hash}\n"
    );
    assert_eq!(sandbox.run(&["run", "a.ron"]).expect(0).text(), report);

    let json = sandbox.run(&["run", "a.ron", "--json", "--events"]).expect(0).json();
    assert_eq!(json["hash"], hash.to_string());
    assert_eq!(json["events"]["refused"], 1);
    assert_eq!(json["log"][0]["kind"], "refused");
    assert_eq!(json["log"][0]["tick"], 4);
}

/// `--ticks` replaces the scene's own length, `--events` tells each event on a line.
#[test]
fn length_and_events() {
    let sandbox = Sandbox::new("run-length");
    let report = sandbox.run(&["run", "a.ron", "--ticks", "2"]).expect(0);
    assert!(report.text().starts_with("tick 2\n") && report.text().contains("events none\n"));
    let report = sandbox.run(&["run", "a.ron", "--events"]).expect(0);
    assert!(report.text().starts_with("tick 4: command 0 of player 0 refused: "), "{report:?}");
}

/// Commands of the timeline that do nothing are told on stderr, by their places in the file.
#[test]
fn idle_commands_are_told() {
    let sandbox = Sandbox::new("run-idle");
    let report = sandbox.run(&["run", "a.ron"]).expect(0);
    let refused = "verlock: a.ron: timeline[1]: tick 4: refused: particle names nothing alive\n";
    assert_eq!(report.stderr, refused);
    let report = sandbox.run(&["run", "a.ron", "--ticks", "4"]).expect(0);
    assert_eq!(report.stderr, "verlock: a.ron: timeline[1]: tick 4 is not reached\n");
    let late = SCENE.replacen("tick: 3", "tick: 5", 1);
    sandbox.write("late.ron", late.as_bytes());
    let report = sandbox.run(&["run", "late.ron", "--ticks", "5"]).expect(0);
    report.says("timeline[1]: tick 4: refused").says("timeline[0]: tick 5 is not reached");
}

/// Objects and events of every kind have a name of their own.
#[test]
fn kinds_are_named() {
    let sandbox = Sandbox::new("run-kinds");
    let scene = "(
        version: 1,
        ticks: 3,
        config: (displacement_max: 0.5),
        particles: [
            (pinned: true), (position: (1, 0, 0)), (position: (0, 1, 0)), (position: (0, 0, 1)),
            (position: (68719476735, 0, 0), velocity: (100, 0, 0), acceleration: (9000, 0, 0)),
        ],
        distances: [(a: 0, b: 1, rest_length: 0.5, stiffness: 0.1, tear_strain: 0.1)],
        volumes: [(corners: (0, 1, 2, 3))],
        faces: [(corners: (0, 1, 2)), (corners: (0, 2, 3))],
        timeline: [
            (tick: 1, action: Remove(object: Particle(3))),
            (tick: 2, action: SpawnParticle(particle: (position: (9, 9, 9)))),
            (tick: 2, action: Remove(object: Particle(9))),
        ],
    )";
    sandbox.write("b.ron", scene.as_bytes());
    let started = sandbox.run(&["info", "b.ron", "--json"]).expect(0).json();
    assert_eq!((&started["volumes"], &started["faces"]), (&1.into(), &2.into()));
    let ended = sandbox.run(&["run", "b.ron", "--json"]).expect(0).json();
    assert_eq!((&ended["volumes"], &ended["faces"]), (&0.into(), &1.into()));
    let kinds: Vec<_> = ended["events"].as_object().expect("kinds").keys().collect();
    let all = ["broken", "displacement-clamped", "refused", "removed", "spawned", "world-limit"];
    assert_eq!(kinds, all);
}

/// The files hold what the report tells; a replay without ticks proves nothing.
#[test]
fn files_hold_the_run() {
    let sandbox = Sandbox::recorded("run-files");
    sandbox.run(&["run", "a.ron", "--hashes", "a.hashes"]).expect(0);
    let hashes = String::from_utf8(sandbox.read("a.hashes")).expect("UTF-8");
    assert_eq!(hashes.lines().count(), 7, "the states before and after six ticks");
    for (tick, line) in hashes.lines().enumerate() {
        let tick = tick.to_string();
        let recorded = sandbox.run(&["hash", "a.replay", "--tick", &tick]).expect(0);
        assert_eq!(format!("{line}\n"), format!("{tick} {}", recorded.text()));
    }
    let last = hashes.lines().last().expect("a line");
    let saved = sandbox.run(&["hash", "a.snap"]).expect(0);
    assert_eq!(last.strip_prefix("6 "), Some(saved.text().trim()));

    sandbox.run(&["run", "a.ron", "--ticks", "0", "--record", "empty.replay"]).expect(0);
    sandbox.run(&["verify", "empty.replay"]).expect(3).says("nothing proven");
}

/// A text that is no scene is refused with its place.
#[test]
fn bad_scenes_are_refused() {
    let sandbox = Sandbox::recorded("run-bad");
    sandbox.write("bad.ron", b"(version: 1,\n colour: 3)");
    sandbox.run(&["run", "bad.ron"]).expect(3).says("bad.ron: line 2, column ");
    sandbox.run(&["run", "a.replay"]).expect(3).says("it is a replay, and a scene is wanted");
    sandbox.write("far/b.ron", b"(version: 1, cloths: [(mesh: File(\"none.obj\"))])");
    let report = sandbox.run(&["run", "far/b.ron"]).expect(3).says("cloths[0].mesh: ");
    let path = std::path::Path::new("far").join("none.obj").display().to_string();
    let report = report.says(&format!("{path}: No such file"));
    assert!(!report.stderr.contains("nothing proven"), "{}", report.stderr);
    sandbox.write("far/none.obj", &[b'v', 0xff]);
    sandbox.run(&["run", "far/b.ron"]).expect(3).says(&path).says("UTF-8");
    sandbox.run(&["run", "none.ron"]).expect(2).says("none.ron: ");
}
