use serde_json::json;

use crate::sandbox::Sandbox;

/// A triangle on the ground.
const FLOOR: &str = "v 0 0 0\nv 4 0 0\nv 0 0 4\nf 1 2 3\n";

/// A triangle above it that stands on its last corner.
const TIP: &str = "v 1 9 1\nv 2 9 1\nv 1 3 1\nf 1 2 3\n";

fn sandbox(name: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write("floor.obj", FLOOR.as_bytes());
    sandbox.write("tip.obj", TIP.as_bytes());
    sandbox
}

#[test]
fn a_corner_falls_on_a_face() {
    let sandbox = sandbox("toi-fall");
    let found = sandbox.run(&["toi", "tip.obj", "floor.obj", "--motion", "0,-4,0"]).expect(0);
    assert_eq!(found.text(), "0.75\nvertex 2, face 0\n");
    assert_eq!(found.stderr, "");
    let command = ["toi", "floor.obj", "tip.obj", "--motion=0, 12 ,0", "--json"];
    let features = [["face 0", "vertex 2"]];
    let hit = json!({ "v": 1, "hit": true, "t": "0.25", "features": features, "cut": false });
    assert_eq!(sandbox.run(&command).expect(0).json(), hit);
}

#[test]
fn a_corner_that_stops_short_touches_nothing() {
    let sandbox = sandbox("toi-miss");
    let short = ["toi", "tip.obj", "floor.obj", "--motion", "0,-2.9999999,0"];
    assert_eq!(sandbox.run(&short).expect(0).text(), "none\n");
    let none = json!({ "v": 1, "hit": false, "t": null, "features": [], "cut": false });
    assert_eq!(sandbox.run(&[&short[..], &["--json"]].concat()).expect(0).json(), none);
    // To the end is a touch, and so is to come near if that is what counts.
    let whole = ["toi", "tip.obj", "floor.obj", "--motion", "0,-3,0"];
    assert_eq!(sandbox.run(&whole).expect(0).text(), "1\nvertex 2, face 0\n");
    let near = sandbox.run(&[&whole[..], &["--gap", "1.5"]].concat()).expect(0);
    assert!(near.text().starts_with("0.5\nvertex 2, face 0\n"), "{}", near.text());
}

/// A third has no end in binary: the time is below it, by less than 2^-30, and printed exactly.
#[test]
fn times_are_exact_decimals_and_never_late() {
    let sandbox = sandbox("toi-third");
    let found = sandbox.run(&["toi", "tip.obj", "floor.obj", "--motion", "0,-9,0"]).expect(0);
    assert_eq!(
        found.text(),
        "0.33333333302289247512817382812500\nvertex 2, face 0\n".replace("00\n", "\n")
    );
}

#[test]
fn meshes_that_meet_touch_at_once() {
    let sandbox = sandbox("toi-start");
    sandbox.write("through.obj", TIP.replace("v 1 3 1", "v 1 -3 1").as_bytes());
    let found = sandbox.run(&["toi", "through.obj", "floor.obj", "--motion", "0,1,0"]).expect(0);
    assert_eq!(found.text().lines().next(), Some("0"));
    assert!(found.text().contains("face 0, face 0\n"), "{}", found.text());
}

#[test]
fn what_is_no_motion_is_refused() {
    let sandbox = sandbox("toi-refused");
    for motion in ["1,2", "1,2,x", "1,2,3,4", "", "0,99999999999999,0"] {
        let command = ["toi", "tip.obj", "floor.obj", "--motion", motion];
        let refused = sandbox.run(&command).expect(2);
        assert!(refused.stderr.contains("--motion"), "{}", refused.stderr);
    }
    let command = ["toi", "tip.obj", "floor.obj", "--motion", "0,68719476735,0"];
    sandbox.run(&command).expect(2).says("--motion: leads out of range");
    let command = ["toi", "tip.obj", "floor.obj", "--motion", "0,0,0", "--gap=-1"];
    assert!(sandbox.run(&command).expect(2).stderr.contains("is below 0"));
    let without = sandbox.run(&["toi", "tip.obj", "floor.obj"]).expect(2);
    assert!(without.stderr.contains("--motion"), "{}", without.stderr);
    sandbox.run(&["toi", "none.obj", "floor.obj", "--motion", "0,0,0"]).expect(2).says("none.obj");
}
