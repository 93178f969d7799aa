use serde_json::json;

use crate::sandbox::Sandbox;

/// A triangle on the ground, seen from below, and one that stands on its corner half a metre above.
const FLOOR: &str = "v 0 0 0\nv 4 0 0\nv 0 0 4\nf 1 2 3\n";
const BLADE: &str = "v 1 0.5 1\nv 1 9 1\nv 2 9 1\nf 1 2 3\n";

fn sandbox(name: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write("floor.obj", FLOOR.as_bytes());
    sandbox.write("blade.obj", BLADE.as_bytes());
    sandbox
}

#[test]
fn contacts_are_listed() {
    let sandbox = sandbox("contacts-list");
    let contacts = |arguments: &[&str]| {
        let command = [&["contacts", "floor.obj", "blade.obj"], arguments].concat();
        sandbox.run(&command).expect(0)
    };
    let near = ["--two-sided", "--margin", "0.6"];
    assert_eq!(contacts(&near).text(), "face 0, vertex 0: 0.5 (0, 1, 0) (1, 0, 1) (1, 0.5, 1)\n");
    let contact = json!({
        "features": ["face 0", "vertex 0"], "separation": "0.5", "on_a": ["1", "0", "1"],
        "on_b": ["1", "0.5", "1"],
    });
    let manifold = json!({ "normal": ["0", "1", "0"], "contacts": [contact] });
    let found = contacts(&[&near[..], &["--json"]].concat()).json();
    assert_eq!(found, json!({ "v": 1, "manifolds": [manifold] }));
    // Too far apart, or too deep behind a face.
    assert_eq!(contacts(&["--two-sided", "--margin", "0.4"]).text(), "");
    assert_eq!(contacts(&["--margin", "0.6"]).text(), "");
}

#[test]
fn contacts_are_painted() {
    let sandbox = sandbox("contacts-render");
    let command = ["contacts", "floor.obj", "blade.obj", "--two-sided", "--margin", "1"];
    let painted = [&command[..], &["--render", "both.png"]].concat();
    sandbox.run(&painted).expect(0);
    assert!(sandbox.read("both.png").starts_with(b"\x89PNG"));
    sandbox.run(&painted).expect(2).says("both.png: exists");
    let over = [&command[..], &["--render", "floor.obj", "--force"]].concat();
    sandbox.run(&over).expect(2);
    assert_eq!(sandbox.read("floor.obj"), FLOOR.as_bytes());
    let refused = sandbox.run(&["contacts", "floor.obj", "blade.obj", "--margin", "-1"]).expect(2);
    assert!(refused.stderr.contains("is below 0"), "{}", refused.stderr);
    // Numbers are as in OBJ files.
    sandbox.run(&[&command[..4], &["--margin", "1e-3"]].concat()).expect(0);
}

/// All pairs of near faces are listed: a margin that makes that too many is refused, at once.
#[test]
fn margins_that_reach_everything_are_refused() {
    use std::fmt::Write;

    let sandbox = Sandbox::new("contacts-margin");
    let mut floor = String::new();
    for k in 0..60 * 60 {
        writeln!(floor, "v {} 0 {}", k % 60, k / 60).expect("a string");
    }
    for k in (1..59 * 60).filter(|k| k % 60 != 0) {
        writeln!(floor, "f {k} {} {}", k + 60, k + 1).expect("a string");
        writeln!(floor, "f {} {} {}", k + 1, k + 60, k + 61).expect("a string");
    }
    sandbox.write("grid.obj", floor.as_bytes());
    let command = ["contacts", "grid.obj", "grid.obj", "--margin", "200"];
    let refused = sandbox.run(&command).expect(2);
    assert!(refused.stderr.contains("more than 10000000 pairs"), "{}", refused.stderr);
    sandbox.run(&["contacts", "grid.obj", "grid.obj", "--margin", "2"]).expect(0);
}
