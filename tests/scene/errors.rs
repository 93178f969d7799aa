//! What is no scene, and what is said about it.

use verlock::scene::{Scene, SceneError};

/// Reads and builds a scene that is wrong.
pub fn refused(text: &str) -> SceneError {
    match Scene::parse(text).and_then(|scene| scene.build()) {
        Ok(_) => panic!("accepted: {text}"),
        Err(error) => error,
    }
}

#[test]
fn what_is_no_decimal_is_refused_where_it_stands() {
    let wrong = [
        "NaN",
        "inf",
        "-inf",
        "1e3",
        "0x10",
        "1.5f64",
        "'5'",
        "\"\"",
        "\" 5\"",
        "true",
        ".5",
        "550000000000",
        "-550000000000",
        "()",
        "(5)",
        "[5]",
        "Some(5)",
        "1..2",
        "340282366920938463463374607431768211456",
    ];
    for number in wrong {
        let text = format!("(\n  version: 1,\n  particles: [(mass: {number})],\n)");
        match refused(&text) {
            SceneError::Syntax { line: 3, column: 16.., .. } => {}
            error => panic!("{number}: {error}"),
        }
    }
}

/// Scenes that are wrong, and what is said about them.
const WRONG: &[(&str, &str)] = &[
    ("", "line 1, column 1: Expected opening `(` for struct `Scene`"),
    ("(version: 2)", "line 1, column 11: scenes of this version are not supported, only 1"),
    ("()", "line 1, column 2: Unexpected missing field named `version` in `Scene`"),
    ("(version: 1,\n seed: 5 ticks: 3)", "line 2, column 10: Expected comma"),
    (
        "(version: 1, particles: [(mass: 1.5, wings: 2)])",
        "line 1, column 38: Unexpected field named `wings` in `Particle`, expected one of \
         `position`, `velocity`, `mass`, `gravity_scale`, `acceleration`, `pinned`, \
         `enabled`, or `user` instead",
    ),
    (
        "(version: 1, config: (damping: 1.5e3))",
        "line 1, column 37: unexpected byte 'e' at offset 3GRAMMAR",
    ),
    (
        "(version: 1, particles: [(), (), (), (mass: 0)])",
        "particles[3].mass is 0, allowed 0.001 to 1000000",
    ),
    (
        "(version: 1, particles: [(position: (68719476736.5, 0, 0))])",
        "particles[0].position is 68719476736.5, allowed -68719476736 to 68719476736",
    ),
    (
        "(version: 1, origin: (0, 500000000000, 0), ropes: [(), (to: (0, 500000000000, 0))])",
        "ropes[1].to is out of range",
    ),
    ("(version: 1, config: (substeps: 0))", "config.substeps is 0, allowed 1 to 64"),
    ("(version: 1, ropes: [(particles: 1)])", "ropes[0].particles is 1, allowed 2 to 4294967295"),
    ("(version: 1, ropes: [(particles: 3, pinned: [3])])", "ropes[0].pinned is 3, allowed 0 to 2"),
    (
        "(version: 1, ropes: [(to: (0, 1025, 0))])",
        "ropes[0].to: a link is 1025, allowed 0.00000006 to 1024",
    ),
    ("(version: 1, ropes: [(mass: (1, -1))])", "ropes[0].mass is -1, allowed 0.001 to 1000000"),
    ("(version: 1, nets: [(columns: 0)])", "nets[0].columns is 0, allowed 2 to 4294967295"),
    ("(version: 1, clouds: [(min: (0, 0, 2))])", "clouds[0].max is 1, allowed 2 to 68719476736"),
    (
        "(version: 1, clouds: [(speed: -1)])",
        "clouds[0].speed is -1, allowed 0 to 549755813887.99999994",
    ),
    ("(version: 1, storm: (spawns: 65537))", "storm.spawns is 65537, allowed 0 to 65536"),
    (
        "(version: 1, particles: [()], distances: [(a: 0, b: 1)])",
        "distances[0].b names nothing alive",
    ),
    (
        "(version: 1, half_spaces: [(normal: (0, 0.00000001, 0))])",
        "line 1, column 54: the zero vector has no direction",
    ),
    (
        "(version: 1, origin: (0, 1, 0), timeline: [(tick: 1, action: \
         Teleport(particle: 0, position: (0, 549755813887, 0)))])",
        "timeline[0].position is out of range",
    ),
    ("(version: 1, config: (damping: 100))", "config.damping is 100, allowed 0 to 60"),
    (
        "(version: 1, particles: [(gravity_scale: -17)])",
        "particles[0].gravity_scale is -17, allowed -16 to 16",
    ),
    ("(version: 1, ropes: [(from: (1, 0, 0))])", "ropes[0].to: the ends coincide"),
    ("(version: 1, nets: [(edge_v: (0, 0, 0))])", "nets[0].edge_v: the ends coincide"),
    (
        "(version: 1, nets: [(edge_u: (2000, 0, 0))])",
        "nets[0].edge_u or edge_v: a link is 2000, allowed 0.00000006 to 1024",
    ),
    ("(version: 1, clouds: [(count: 1, speed: 1000000)])", "clouds[0].speed is out of range"),
    (
        "(version: 1, particles: [()], distances: [(a: 0, b: 0)])",
        "distances[0].b names the same particle twice",
    ),
    (
        "(version: 1, particles: [(), ()], distances: [(a: 0, b: 1)])",
        "distances[0].rest_length: the ends coincide",
    ),
    (
        "(version: 1, particles: [(), ()], faces: [(corners: (0, 1, 0))])",
        "faces[0].corners names the same particle twice",
    ),
    (
        "(version: 1, cloths: [(mesh: Grid(CELL, corners: (1, 0, 0)))])",
        "line 1, column 94: Unexpected field named `corners` in `Grid`, expected one of \
         `corner`, `edge_u`, `edge_v`, `columns`, or `rows` instead",
    ),
    (
        "(version: 1, cloths: [(mesh: Grid(CELL), pinned: Places([3, 4]))])",
        "cloths[0].pinned is 4, allowed 0 to 3",
    ),
    (
        "(version: 1, cloths: [(mesh: Grid(CELL), compliance: 0.5)])",
        "cloths[0].compliance: cloths have no such field",
    ),
    (
        "(version: 1, cloths: [(mesh: Grid(CELL)), (mesh: Grid(CELL), spread: 2)])",
        "cloths[1].spread: cloths have no such field",
    ),
    (
        "(version: 1, cloths: [(mesh: Grid(CELL), bending: 1.5)])",
        "cloths[0].bending is 1.5, allowed 0 to 1",
    ),
    (
        "(version: 1, cloths: [(mesh: File(\"a.obj\"))])",
        "cloths[0].mesh: a.obj: only `parse_with` reads files",
    ),
    (
        "(version: 1, plants: [(mesh: Grid(CELL), pinned: Top, attachments: true)])",
        "plants[0].attachments: plants have no such field",
    ),
    ("(version: 1, plants: [(mesh: Grid(CELL))])", "plants[0].pinned names nothing"),
    (
        "(version: 1, plants: [(mesh: Grid(CELL), pinned: Top, spread: 0)])",
        "plants[0].spread is 0, allowed 0.00000006 to 1024",
    ),
    (
        "(version: 1, timeline: [(tick: 1, action: SetWind(0, 0, 1))])",
        "line 1, column 51: expected the name of a field, found `0`",
    ),
    (
        "(version: 1, timeline: [(tick: 1, act: 0)])",
        "line 1, column 35: Unexpected field named `act` in `Command`, expected one of `tick`, \
         `player`, or `action` instead",
    ),
];

/// A grid of one cell.
const CELL: &str = "edge_u: (1, 0, 0), edge_v: (0, 1, 0), columns: 2, rows: 2";

#[test]
fn errors_say_where_and_what() {
    for (text, expected) in WRONG {
        let error = refused(&text.replace("CELL", CELL)).to_string();
        let grammar = ": numbers are decimals like -12.5, with a digit first and no exponent";
        assert_eq!(error, expected.replace("GRAMMAR", grammar), "{text}");
    }
}

/// A byte order mark is no mistake, and a grid has its corner where nets have theirs.
#[test]
fn near_misses_are_read() {
    let hung = |mesh: &str| {
        let text = format!("\u{feff}(version: 1, cloths: [(mesh: Grid({CELL}{mesh})])");
        let scene = Scene::parse(&text).unwrap_or_else(|error| panic!("{error}"));
        scene.build().expect("a world").hash()
    };
    assert_eq!(hung(", corner: (0, 5, 0))"), hung("), at: (0, 5, 0)"));
    assert_eq!(hung(", corner: (0, 2, 0)), at: (0, 3, 0)"), hung("), at: (0, 5, 0)"));
    assert_ne!(hung(")"), hung("), at: (0, 5, 0)"));
}
