use serde_json::json;

use crate::render::fixture;
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
    let at_once = sandbox.run(&[&whole[..], &["--gap", "4"]].concat()).expect(0);
    assert!(at_once.text().starts_with("0: within the gap at the start\n"), "{}", at_once.text());
}

/// All pairs of faces within the gap are looked at: one that makes that too many is refused, at
/// once, and so is one that is too wide for a search.
#[test]
fn gaps_that_reach_everything_are_refused() {
    let sandbox = sandbox("toi-gap");
    let meshes = ["pinion", "gear"].map(|name| fixture(&format!("meshes/{name}.obj")));
    let [a, b] = meshes.each_ref().map(|path| path.to_str().expect("a path"));
    let refused = |gap: &str| {
        let command = ["toi", a, b, "--motion", "-0.01,0,0", "--gap", gap];
        sandbox.run(&command).expect(2).stderr
    };
    for gap in ["0.2", "32768"] {
        let told = refused(gap);
        assert!(told.contains("--gap") && told.contains("pairs of faces are as near"), "{told}");
    }
    for gap in ["32768.00000006", "1e9"] {
        let told = refused(gap);
        assert!(told.contains("is above 32768"), "{told}");
    }
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
    assert_eq!(found.text().lines().next(), Some("0: they touch at the start"));
    assert!(found.text().contains("face 0, face 0\n"), "{}", found.text());
}

/// Of many pairs that touch some are listed and the others counted; JSON has them all.
#[test]
fn long_lists_are_cut_and_counted() {
    let sandbox = sandbox("toi-many");
    let command = ["toi", "gear.obj", "gear.obj", "--motion", "0,1,0"];
    sandbox.write("gear.obj", &std::fs::read(fixture("meshes/gear.obj")).expect("a mesh"));
    let told = sandbox.run(&command).expect(0);
    let all = sandbox.run(&[&command[..], &["--json"]].concat()).expect(0).json();
    let all = all["features"].as_array().expect("a list").len();
    let last = told.text().lines().last().unwrap_or_default().replace(',', "");
    assert_eq!(last, format!("and {} more pairs", all - 12));
    assert_eq!(told.text().lines().count(), 1 + 12 + 1);
}

/// The example of the README: teeth that meet teeth, between the beginning and the end.
#[test]
fn gears_meet_where_they_are_pushed_together() {
    let sandbox = sandbox("toi-gears");
    let meshes = ["pinion", "gear"].map(|name| fixture(&format!("meshes/{name}.obj")));
    let [a, b] = meshes.each_ref().map(|path| path.to_str().expect("a path"));
    let told = sandbox.run(&["toi", a, b, "--motion", "-0.01,0,0", "--json"]).expect(0).json();
    assert_eq!((&told["hit"], &told["cut"]), (&json!(true), &json!(false)));
    let time: f64 = told["t"].as_str().expect("a time").parse().expect("a number");
    // 3 mm are missing, of 10.
    assert!((0.25..=0.35).contains(&time), "{time}");
}

/// A search that ends before it is certain says so, also to people.
#[test]
fn cut_searches_are_told() {
    let sandbox = sandbox("toi-cut");
    // A cube of 1 m two metres above another.
    let cube = fixture("meshes/cube.obj");
    let low = cube.to_str().expect("a path");
    let text = std::fs::read_to_string(&cube).expect("a mesh");
    let raised: Vec<String> = text
        .lines()
        .map(|line| match line.strip_prefix("v ").map(|rest| rest.split(' ').collect::<Vec<_>>()) {
            Some(place) => {
                let [x, y, z] = [0, 1, 2].map(|k| place[k].parse::<f64>().expect("a number"));
                format!("v {} {} {}", x + 0.13, y + 2.0, z + 0.07)
            }
            None => line.into(),
        })
        .collect();
    sandbox.write("high.obj", raised.join("\n").as_bytes());
    let command = ["toi", "high.obj", low, "--motion", "0,-3,0", "--gap", "0.1"];
    let is_cut = sandbox.run(&[&command[..], &["--json"]].concat()).expect(0).json()["cut"] == true;
    let told = sandbox.run(&command).expect(0);
    let first = told.text().lines().next().expect("a line");
    assert_eq!(first.ends_with(" or later: the search was cut short"), is_cut, "{first}");
}

#[test]
fn what_is_no_motion_is_refused() {
    let sandbox = sandbox("toi-refused");
    for motion in ["1,2", "1,2,x", "1,2,3,4", "", "0 1 0", "0,-1,", "0,99999999999999,0"] {
        let command = ["toi", "tip.obj", "floor.obj", "--motion", motion];
        let refused = sandbox.run(&command).expect(2);
        assert!(refused.stderr.contains("--motion"), "{}", refused.stderr);
    }
    let command = ["toi", "tip.obj", "floor.obj", "--motion", "0,68719476735,0"];
    sandbox.run(&command).expect(2).says("--motion: leads out of range");
    let command = ["toi", "tip.obj", "floor.obj", "--motion", "0,0,0", "--gap=-1"];
    assert!(sandbox.run(&command).expect(2).stderr.contains("is below 0"));
    let spaced = sandbox.run(&["toi", "tip.obj", "floor.obj", "--motion", "0 1 0"]).expect(2);
    assert!(spaced.stderr.contains("with commas between them"), "{}", spaced.stderr);
    let without = sandbox.run(&["toi", "tip.obj", "floor.obj"]).expect(2);
    assert!(without.stderr.contains("--motion"), "{}", without.stderr);
    sandbox.run(&["toi", "none.obj", "floor.obj", "--motion", "0,0,0"]).expect(2).says("none.obj");
}
