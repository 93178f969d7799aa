use crate::sandbox::Sandbox;

/// The corners of a cube of 2 m.
const CUBE: &str = "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nv 0 0 2\nv 2 0 2\nv 0 2 2\nv 2 2 2\n\
    f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

/// A square sheet of 32 triangles.
fn sheet() -> String {
    let mut text = String::new();
    for (x, y) in (0..5).flat_map(|y| (0..5).map(move |x| (x, y))) {
        text += &format!("v {x} {y} 0\n");
    }
    for first in (0..4).flat_map(|y| (1..5).map(move |x| 5 * y + x)) {
        text += &format!("f {first} {} {} {}\n", first + 1, first + 6, first + 5);
    }
    text
}

fn sandbox(name: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write("cube.obj", CUBE.as_bytes());
    sandbox.write("sheet.obj", sheet().as_bytes());
    sandbox
}

#[test]
fn triangles_are_reduced() {
    let sandbox = sandbox("reduce-triangles");
    let found = sandbox.run(&["reduce", "sheet.obj", "--triangles", "2", "--json"]).expect(0);
    let told = found.json();
    assert_eq!(told["proxy"], "triangles");
    assert_eq!([&told["mesh_faces"], &told["faces"], &told["vertices"]], [32, 2, 4]);
    assert_eq!(told["of_mesh"]["at_least"], "0");
    assert_eq!(found.stderr, "");
    let found = sandbox.run(&["reduce", "sheet.obj", "--triangles", "2"]).expect(0);
    assert!(found.text().starts_with("proxy triangles\nmesh_faces 32\n"), "{}", found.text());
    // Neither the same again.
    let found = sandbox.run(&["reduce", "sheet.obj", "--triangles", "33"]).expect(0);
    found.says("sheet.obj: has 32 triangles already");
    // A closed part has four faces at least.
    let found = sandbox.run(&["reduce", "cube.obj", "--triangles", "1", "--json"]).expect(0);
    assert_eq!(found.json()["faces"], 4);
    found.says("4 triangles: with fewer, parts or holes would be lost");
}

/// How far a shape around a cube is from it is known: a hull of all corners not at all, a ball at
/// the middles of its faces.
#[test]
fn shapes_around_a_cube_are_as_far_off_as_they_are() {
    let sandbox = sandbox("reduce-fit");
    let metres = |told: &serde_json::Value, at: &str| -> f64 {
        let text = told.pointer(at).and_then(|value| value.as_str()).expect("a length");
        text.parse().expect("a number")
    };
    for (args, deviation) in [
        (["--hull", "8"], 0.0),
        (["--fit", "box"], 0.0),
        (["--fit", "sphere"], 3.0_f64.sqrt() - 1.0),
    ] {
        let command = [&["reduce", "cube.obj", "--json"], &args[..]].concat();
        let told = sandbox.run(&command).expect(0).json();
        let found = metres(&told, "/deviation");
        // What is round is measured to within 1/256 of its radius.
        assert!((deviation..deviation + 0.02).contains(&found), "{args:?}: {found}");
        assert!((metres(&told, "/beyond_hull") - deviation).abs() < 1e-6, "{args:?}");
        assert!(metres(&told, "/of_proxy/at_least") <= deviation + 1e-6, "{args:?}");
    }
    let told = sandbox.run(&["reduce", "cube.obj", "--fit", "sphere", "--json"]).expect(0).json();
    assert_eq!(told["shape"]["center"], "1,1,1");
    let found = sandbox.run(&["reduce", "cube.obj", "--fit", "capsule", "--json"]).expect(0);
    let told = found.json();
    if told["shape"]["ends"][0] == told["shape"]["ends"][1] {
        found.says("is a sphere");
    }
    assert!(metres(&told, "/shape/radius") >= 2.0_f64.sqrt() - 1e-6);
}

/// What is written is a mesh: the same as is told of, and closed.
#[test]
fn what_stands_in_is_written() {
    let sandbox = sandbox("reduce-output");
    for args in [["--triangles", "9"], ["--hull", "6"], ["--fit", "capsule"], ["--fit", "box"]] {
        let command = [&["reduce", "cube.obj", "-o", "out.obj", "--force"], &args[..]].concat();
        sandbox.run(&command).expect(0);
        let text = String::from_utf8(sandbox.read("out.obj")).expect("a text");
        let mut sides = vec![];
        for face in text.lines().filter_map(|line| line.strip_prefix("f ")) {
            let corners: Vec<u32> = face.split(' ').map(|c| c.parse().expect("a place")).collect();
            sides.extend([0, 1, 2].map(|k| [corners[k], corners[(k + 1) % 3]]));
        }
        assert!(!sides.is_empty(), "{args:?}");
        assert!(sides.iter().all(|&[a, b]| sides.contains(&[b, a])), "{args:?}: not closed");
        // On stdout it is alone, and what is told of it elsewhere.
        let command = [&["reduce", "cube.obj", "-o", "-"], &args[..]].concat();
        let outcome = sandbox.run(&command).expect(0);
        assert_eq!(outcome.text(), text);
        assert!(outcome.stderr.contains("\ndeviation "), "{}", outcome.stderr);
    }
}

/// What is told of meshes is laid out alike, a name a line.
#[test]
fn json_is_laid_out_alike() {
    let sandbox = sandbox("reduce-json");
    for command in [
        &["reduce", "cube.obj", "--hull", "8"][..],
        &["contacts", "cube.obj", "sheet.obj"],
        &["toi", "cube.obj", "sheet.obj", "--motion", "0,0,1"],
    ] {
        let told = sandbox.run(&[command, &["--json"]].concat()).expect(0);
        let lines = told.text().lines().filter(|line| line.starts_with("  \""));
        assert_eq!(lines.count(), told.json().as_object().expect("names").len(), "{command:?}");
    }
}

#[test]
fn both_are_painted() {
    let sandbox = sandbox("reduce-render");
    let command = ["reduce", "cube.obj", "--fit", "sphere", "--render", "both.png"];
    sandbox.run(&command).expect(0);
    let picture = sandbox.read("both.png");
    assert!(picture.starts_with(b"\x89PNG") && picture.len() > 1_000);
    sandbox.run(&command).expect(2).says("both.png: exists");
    let side = [&command[..5], &["side.png", "--view", "side"]].concat();
    sandbox.run(&side).expect(0);
    assert_ne!(sandbox.read("side.png"), picture);
}

#[test]
fn what_makes_no_sense_is_refused() {
    let sandbox = sandbox("reduce-refused");
    for args in [
        &[][..],
        &["--triangles", "0"],
        &["--hull", "3"],
        &["--fit", "cone"],
        &["--hull", "8", "--triangles", "8"],
        &["--hull", "8", "--render", "-"],
        &["--hull", "8", "--render", "both.gif"],
        &["--hull", "8", "--output", "cube.obj", "--force"],
        &["--hull", "8", "--output", "hull.txt"],
        &["--hull", "8", "--size", "99x99"],
    ] {
        sandbox.run(&[&["reduce", "cube.obj"], args].concat()).expect(2);
    }
    // Numbers below 0 are values of options, which say what they want.
    let large = ["--triangles", "4294967296"];
    for [option, value] in [["--triangles", "-5"], ["--hull", "-1"], ["--hull", "3"], large] {
        let refused = sandbox.run(&["reduce", "cube.obj", option, value]).expect(2);
        let least = if option == "--hull" { 4 } else { 1 };
        let what = format!("a whole number from {least} to 4294967295 is expected");
        assert!(refused.stderr.contains(&what), "{}", refused.stderr);
    }
    for args in [["contacts", "--margin"], ["toi", "--gap"]] {
        let command = [args[0], "cube.obj", "cube.obj", args[1], "-1"];
        let refused = sandbox.run(&command).expect(2);
        assert!(refused.stderr.contains("is below 0"), "{}", refused.stderr);
    }
    sandbox.run(&["reduce", "none.obj", "--hull", "8"]).expect(2).says("none.obj: ");
    // A sheet has no volume.
    for args in [["--hull", "8"], ["--fit", "box"], ["--fit", "sphere"]] {
        let flat = sandbox.run(&[&["reduce", "sheet.obj"], &args[..]].concat()).expect(3);
        flat.says("sheet.obj: all vertices lie in one plane");
    }
    assert_eq!(sandbox.read("cube.obj"), CUBE.as_bytes());
    // At the end of the world there is no room for what is round.
    let edge = CUBE_AT_THE_EDGE;
    sandbox.write("edge.obj", edge.as_bytes());
    for fit in ["sphere", "capsule"] {
        let found = sandbox.run(&["reduce", "edge.obj", "--fit", fit]).expect(3);
        found.says("edge.obj: the shape around it reaches beyond 2^36 m");
    }
}

const CUBE_AT_THE_EDGE: &str = "\
v 68719476730 0 0
v 68719476736 0 0
v 68719476730 6 0
v 68719476730 0 6
f 1 2 3
f 1 2 4
f 1 3 4
f 2 3 4
";
