use serde_json::json;

use crate::sandbox::Sandbox;

/// A triangle on the ground.
const FLOOR: &str = "v 0 0 0\nv 4 0 0\nv 0 0 4\nf 1 2 3\n";

/// Far away a triangle, then one that stands on edge and reaches through the ground.
const BLADE: &str = "v 90 0 0\nv 91 0 0\nv 90 1 0\nv 1 2 1\nv 1 -2 1\nv 1 0 5\nf 1 2 3\nf 4 5 6\n";

fn sandbox(name: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write("floor.obj", FLOOR.as_bytes());
    sandbox.write("blade.obj", BLADE.as_bytes());
    sandbox
}

#[test]
fn faces_that_intersect_are_listed() {
    let sandbox = sandbox("overlap-list");
    let found = sandbox.run(&["overlap", "floor.obj", "blade.obj"]).expect(0);
    assert_eq!(found.text(), "0 1 (1, 0, 1) (1, 0, 3)\n");
    assert_eq!(found.stderr, "");
    let found = sandbox.run(&["overlap", "blade.obj", "floor.obj", "--json"]).expect(0);
    let segment = [["1", "0", "1"], ["1", "0", "3"]];
    assert_eq!(found.json(), json!({ "v": 1, "pairs": [[1, 0]], "segments": [segment] }));
    // Whether or not there are any.
    sandbox.write("high.obj", FLOOR.replace(" 0 ", " 9 ").as_bytes());
    let found = sandbox.run(&["overlap", "high.obj", "blade.obj", "--json"]).expect(0);
    assert_eq!(found.json(), json!({ "v": 1, "pairs": [], "segments": [] }));
}

/// One step is 2^-24 m.
#[test]
fn touching_counts_and_a_step_beside_it_does_not() {
    let sandbox = sandbox("overlap-touch");
    let tip = |y: &str| format!("v 1 {y} 1\nv 1 9 1\nv 2 9 1\nf 1 2 3\n");
    for (y, found) in [("0", "0 0 (1, 0, 1)\n"), ("0.00000006", "")] {
        sandbox.write("tip.obj", tip(y).as_bytes());
        let listed = sandbox.run(&["overlap", "floor.obj", "tip.obj"]).expect(0);
        assert_eq!(listed.text(), found);
    }
}

/// A face of four corners is two.
#[test]
fn pairs_and_segments_are_in_one_order() {
    let sandbox = sandbox("overlap-order");
    sandbox.write("square.obj", b"v 0 0 0\nv 4 0 0\nv 4 0 4\nv 0 0 4\nf 1 2 3 4\n");
    let found = sandbox.run(&["overlap", "square.obj", "blade.obj", "--json"]).expect(0);
    let segments = json!([[["1", "0", "1"]], [["1", "0", "1"], ["1", "0", "4"]]]);
    assert_eq!(found.json(), json!({ "v": 1, "pairs": [[0, 1], [1, 1]], "segments": segments }));
    let found = sandbox.run(&["overlap", "square.obj", "blade.obj"]).expect(0);
    assert_eq!(found.text(), "0 1 (1, 0, 1)\n1 1 (1, 0, 1) (1, 0, 4)\n");
}

/// A mesh lies in its own planes.
#[test]
fn faces_of_one_plane_have_polygons_in_common() {
    let sandbox = sandbox("overlap-plane");
    let found = sandbox.run(&["overlap", "floor.obj", "floor.obj"]).expect(0);
    assert_eq!(found.text(), "0 0 (0, 0, 0) (0, 0, 4) (4, 0, 0)\n");
}

#[test]
fn faces_without_an_area_are_tested_and_named() {
    let sandbox = sandbox("overlap-flat");
    sandbox.write("needle.obj", b"v 1 1 1\nv 1 -1 1\nf 1 2 1\nf 1 1 1\n");
    let found = sandbox.run(&["overlap", "floor.obj", "needle.obj"]).expect(0);
    assert_eq!(found.text(), "0 0 (1, 0, 1)\n");
    found.says("needle.obj: 2 faces without an area, the first is 0");
}

#[test]
fn files_that_are_no_meshes_are_refused() {
    let sandbox = sandbox("overlap-refused");
    sandbox.write("nan.obj", b"v 0 0 0\nv 0 nan 0\nf 1 2 1\n");
    sandbox.write("index.obj", b"v 0 0 0\nf 1 2 3\n");
    sandbox.write("empty.obj", b"");
    sandbox.write("cut.obj", &FLOOR.as_bytes()[..FLOOR.len() - 3]);
    sandbox.write("bytes.obj", b"v 0 0 0\n\xff");
    let refused = [
        ("nan.obj", "nan.obj: line 2: y: "),
        ("index.obj", "index.obj: line 2: corner 2 names none of the 1 vertices above"),
        ("empty.obj", "empty.obj: is empty"),
        ("cut.obj", "cut.obj: line 4: face has fewer than 3 corners"),
        ("bytes.obj", "bytes.obj: offset 8: not UTF-8"),
    ];
    for (name, why) in refused {
        let refused = sandbox.run(&["overlap", "floor.obj", name]).expect(3).says(why);
        assert!(!refused.stderr.contains("nothing proven"), "{}", refused.stderr);
        sandbox.run(&["overlap", name, "floor.obj", "--json"]).expect(3).says(why);
    }
    sandbox.run(&["overlap", "floor.obj", "none.obj"]).expect(2).says("none.obj: ");
    sandbox.run(&["overlap", "-", "-"]).expect(2).says("stdin");
    sandbox.run(&["--limit", "9", "overlap", "floor.obj", "blade.obj"]).expect(3).says("longer");
}

/// What is something else is called by its name, both ways.
#[test]
fn other_kinds_are_named() {
    let sandbox = Sandbox::recorded("overlap-kinds");
    sandbox.write("floor.obj", FLOOR.as_bytes());
    sandbox.write("noted.obj", format!("# A floor.\no floor\n{FLOOR}").as_bytes());
    sandbox.write("a.png", b"\x89PNG\r\n\x1a\n");
    for (name, kind) in
        [("a.ron", "a text, as scenes are"), ("a.snap", "a snapshot"), ("a.png", "a picture")]
    {
        let why = format!("{name}: it is {kind}, and an OBJ mesh is wanted");
        sandbox.run(&["overlap", "floor.obj", name]).expect(3).says(&why);
    }
    for name in ["floor.obj", "noted.obj"] {
        let why = format!("{name}: it is an OBJ mesh, which `reduce --render` paints");
        sandbox.run(&["render", name, "-o", "picture.png"]).expect(3).says(&why);
    }
}

#[test]
fn both_meshes_are_painted() {
    let sandbox = sandbox("overlap-render");
    let command = ["overlap", "floor.obj", "blade.obj", "--render", "both.png"];
    let found = sandbox.run(&command).expect(0);
    assert_eq!(found.text(), "0 1 (1, 0, 1) (1, 0, 3)\n");
    let picture = sandbox.read("both.png");
    assert!(picture.starts_with(b"\x89PNG") && picture.len() > 1_000);
    sandbox.run(&command).expect(2).says("both.png: exists");
    sandbox.run(&[&command[..], &["--force"]].concat()).expect(0);
    assert_eq!(sandbox.read("both.png"), picture);
    let command = ["overlap", "floor.obj", "blade.obj", "--render", "-"];
    sandbox.run(&command).expect(2).says("stdout is for text");
    for name in ["both.gif", "both.jpg", "both"] {
        let command = ["overlap", "floor.obj", "blade.obj", "--render", name];
        sandbox.run(&command).expect(2).says(&format!("{name}: is no .png"));
    }
    // Pictures have a size and a view, and there is none.
    for option in [["--size", "99x99"], ["--view", "top"]] {
        let command = [&["overlap", "floor.obj", "blade.obj"], &option[..]].concat();
        let refused = sandbox.run(&command).expect(2);
        assert!(refused.stderr.contains("--render"), "{}", refused.stderr);
    }
    // A mesh is not taken for an old picture.
    sandbox.write("mesh.png", FLOOR.as_bytes());
    let command = ["overlap", "mesh.png", "blade.obj", "--render", "mesh.png", "--force"];
    sandbox.run(&command).expect(2).says("mesh.png: a mesh would be overwritten");
    assert_eq!(sandbox.read("mesh.png"), FLOOR.as_bytes());
}
