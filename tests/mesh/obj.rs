//! OBJ files: what is read, what is refused and with which words, and what reading takes.

use proptest::collection::vec;
use proptest::prelude::*;
use verlock::geometry::{MeshError, TriangleMesh};
use verlock::math::DecimalError;
use verlock::scene::{Obj, ObjError, ObjFault, ObjPart};
use verlock::{Real, Vec3};

use super::{any_mesh, cases, fixtures};
use crate::support::alloc::peak;

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

fn read(text: &str) -> Obj {
    Obj::parse(text).unwrap_or_else(|error| panic!("{error}: {text}"))
}

/// The faces that a text adds to a triangle's vertices.
fn faces(text: &str) -> Vec<[u32; 3]> {
    read(&format!("{TRIANGLE}{text}")).mesh().faces().to_vec()
}

#[test]
fn fixtures_are_read_and_written_back() {
    let files = fixtures("meshes");
    assert_eq!(files.len(), 5);
    for (path, text) in files {
        let obj = read(&text);
        assert_eq!(read(&obj.to_string()), obj, "{path}");
        assert!(!obj.parts().is_empty(), "{path}");
    }
}

#[test]
fn refused_fixtures_say_why() {
    let files = fixtures("refused");
    assert!(files.len() >= 24, "only {}", files.len());
    for (path, text) in files {
        let expected = text.lines().next().and_then(|line| line.strip_prefix("# "));
        let error = Obj::parse(&text).expect_err(&path);
        assert_eq!(Some(error.to_string().as_str()), expected, "{path}");
    }
}

#[test]
fn errors_are_typed() {
    let error = |text: &str| Obj::parse(text).map_err(|ObjError { line, why }| (line, why)).err();
    let why = DecimalError::UnexpectedByte { offset: 0, byte: b'N' };
    assert_eq!(error("\n\nv 1 2 NaN"), Some((3, ObjFault::Number { coordinate: "z", why })));
    assert_eq!(error("v 1\n\n"), Some((1, ObjFault::Missing { coordinate: "y" })));
    assert_eq!(error(""), Some((1, ObjFault::Mesh(MeshError::NoFace))));
    let short = format!("{TRIANGLE}f 1 -1\n");
    assert_eq!(error(&short), Some((4, ObjFault::FewCorners)));
}

#[test]
fn coordinates_are_the_nearest_to_their_text() {
    // Through f64 the first would end in 4.
    let obj = read("v 1000000000.0000002 -3e-8 .5\nf 1 1 1");
    assert_eq!(obj.mesh().vertices(), [Vec3::from_raw([16_777_216_000_000_003, -1, 1 << 23])]);
    let more = "v 1 2.5 -3 1.0\nv +1 2.50 -3. 0.1 0.2 0.3\nv 1e0 25e-1 -.3E+1 1 0 0 0\nf 1 2 3";
    let half = Real::parse("2.5").expect("a decimal");
    let same = Vec3::new(Real::ONE, half, Real::from_int(-3));
    assert_eq!(read(more).mesh().vertices(), [same; 3]);
}

#[test]
fn faces_are_written_in_many_ways() {
    for face in
        ["f 1 2 3", "f 1/7 2/8 3/9", "f 1//4 2//5 3//6", "f 1/7/4 2/8/5 3/9/6", "f 1/ 2/ 3/"]
    {
        assert_eq!(faces(face), [[0, 1, 2]], "{face}");
    }
    assert_eq!(faces("f -3 -2 -1\nv 5 5 5\nf -1 1 -2"), [[0, 1, 2], [3, 0, 2]]);
    assert_eq!(faces("f 1 2 3 2"), [[0, 1, 2], [0, 2, 1]], "a fan");
    assert_eq!(faces("f 3 1 2 2 1"), [[2, 0, 1], [2, 1, 1], [2, 1, 0]]);
    assert_eq!(faces("f +1 02 3"), [[0, 1, 2]]);
}

#[test]
fn lines_are_written_in_many_ways() {
    let expected = read(&format!("{TRIANGLE}f 1 2 3\n"));
    for text in [
        "\u{feff}v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "  v\t0 0\t0 \n\n# v 9 9 9\nv 1 0 0 # here\nv 0 1 0#there\nf 1 2 3",
        "v 0 \\\n0 0\nv 1 \\ \r\n \\\r\n 0 0\nv 0 1 0\nf 1\\\n2 3 \\",
        "mtllib a.mtl b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 nan\nvn 0 0 x\nvp 1\ns off\n\
         usemtl \u{fc}\nl 1 2\np 1 99\nf 1 2 3\nlod 3\n",
    ] {
        assert_eq!(read(text), expected, "{text}");
    }
    let error = Obj::parse("v 0 \\\n0 0\n# \\\nv 0 \\ # a\n 1\nf 1 1 1").expect_err("one is short");
    assert_eq!(error.to_string(), "line 4: z is missing");
}

#[test]
fn names_belong_to_the_faces_below() {
    let obj = read(&format!(
        "{TRIANGLE}f 1 2 3\no none\ng  left\tarm \nf 1 2 3 1\n\ng\nf 1 1 1\no left \\\n arm # 2\n\
         g\\\no right\nf 2 2 2\nf 3 3 3\ng last"
    ));
    let part = |name: &str, faces| ObjPart { name: name.into(), faces };
    let expected = [part("left arm", 1..3), part("", 3..4), part("o right", 4..6)];
    assert_eq!(obj.parts(), expected);
    assert_eq!(read(&obj.to_string()), obj);
}

#[test]
fn one_line_too_many_is_refused_at_that_line() {
    let (v, f) = (TriangleMesh::VERTICES_MAX, TriangleMesh::FACES_MAX);
    let vertices = format!("#\n{}f 1 1 1\n", "v 0 0 0\n".repeat(v + 1));
    let error = Obj::parse(&vertices).expect_err("too many");
    let line = 2 + v as u32;
    assert_eq!(error, ObjError { line, why: MeshError::TooManyVertices.into() });

    let mut faces = format!("{TRIANGLE}f{}\n", " 1".repeat(f + 1));
    faces.push_str("f 1 2 3\nf 1 2 3\nf 1 2 3\n");
    let error = Obj::parse(&faces).expect_err("too many");
    assert_eq!(error, ObjError { line: 6, why: MeshError::TooManyFaces.into() });
}

#[test]
fn memory_is_in_proportion_and_bounded() {
    for line in ["v 0 0 0\n", "f 1 1 1\n", "f 1 1 1 1 1 1 1 1 1 1\n", "o\nf 1 1 1\n", "o a\n", "\n"]
    {
        let text = format!("{TRIANGLE}{}", line.repeat(20_000));
        let (_, bytes) = peak(|| Obj::parse(&text));
        assert!(bytes <= 32 * text.len() as u64, "{bytes} bytes for {line}");
    }
    // What is beyond the limit costs nothing.
    let fan = format!("{TRIANGLE}f{}", " 1".repeat(3 * TriangleMesh::FACES_MAX));
    let (result, bytes) = peak(|| Obj::parse(&fan));
    assert!(result.is_err());
    assert!(bytes <= 3 * 12 * TriangleMesh::FACES_MAX as u64, "{bytes} bytes");
}

/// Words of OBJ files, and what may stand in their place.
fn any_word() -> impl Strategy<Value = String> {
    let words = [
        "v", "f", "o", "g", "vt", "s", "#", "\\", "\\\n", "\n", "\r\n", "\n", "/", "0", "1", "2",
        "-1", "-2", "1/1", "1//", "1/2/3", "0.5", "1e-3", "1e30", "nan", "-", "\u{e9}", "",
    ];
    prop_oneof![
        4 => prop::sample::select(words.to_vec()).prop_map(String::from),
        1 => "[vf] [0-9.e-]{1,9} [0-9.e/-]{1,9} [0-9.e/-]{1,9}\n",
        1 => Just("v 1 2 3\nf 1 1 -1\n".to_owned()),
    ]
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn a_mesh_is_read_as_it_was_written(mesh in any_mesh()) {
        let obj = Obj::from(mesh.clone());
        prop_assert_eq!(Obj::parse(&obj.to_string()), Ok(obj));
    }

    #[test]
    fn any_text_is_a_mesh_or_names_a_line(words in vec(any_word(), 0..60)) {
        let text = words.join(" ");
        match Obj::parse(&text) {
            Ok(obj) => prop_assert_eq!(Obj::parse(&obj.to_string()), Ok(obj)),
            Err(ObjError { line, why }) => {
                prop_assert!((1..=text.lines().count().max(1)).contains(&(line as usize)));
                prop_assert_ne!(why.to_string(), "");
            }
        }
    }
}
