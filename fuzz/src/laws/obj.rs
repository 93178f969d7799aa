//! Any text is a mesh or is not.

use verlock::geometry::{Adjacency, TriangleMesh};
use verlock::scene::{Obj, ObjError};
use verlock::{Real, Vec3};

/// Tolerances of welds, raw: equal places only, a millimetre, a metre, everything.
const TOLERANCES: [i64; 4] = [0, 16_777, 1 << 24, i64::MAX];

/// A mesh is within its limits, is read back as it is written, agrees with its edges, and can be
/// welded; what is none says where. True if the text is a mesh.
pub fn obj(bytes: &[u8]) -> bool {
    let Ok(text) = std::str::from_utf8(bytes) else { return false };
    let obj = match Obj::parse(text) {
        Ok(obj) => obj,
        Err(error) => {
            is_somewhere(&error, text);
            return false;
        }
    };
    let mesh = obj.mesh();
    is_within_limits(mesh);
    agrees_with_its_edges(mesh);
    is_welded_once(mesh);
    let mut end = obj.parts().first().map_or(0, |part| part.faces.start);
    for part in obj.parts() {
        assert!(part.faces.start == end && part.faces.end > end, "a gap before {}", part.name);
        end = part.faces.end;
    }
    assert!(obj.parts().is_empty() || end as usize == mesh.faces().len(), "faces behind the last");
    assert_eq!(Obj::parse(&obj.to_string()).as_ref(), Ok(&obj), "read back");
    true
}

fn is_somewhere(error: &ObjError, text: &str) {
    let ObjError { line, why } = error;
    let lines = text.lines().count().max(1);
    assert!((1..=lines).contains(&(*line as usize)), "line of {error}");
    assert_ne!(why.to_string(), "");
}

/// The limits of a mesh, from their documentation.
fn is_within_limits(mesh: &TriangleMesh) {
    assert!(!mesh.faces().is_empty());
    let inside = |c: i64| (-1 << 60..=1 << 60).contains(&c);
    assert!(mesh.vertices().iter().all(|position| position.raw().into_iter().all(inside)));
    for corners in mesh.faces() {
        let [a, b, c] = corners.map(|vertex| mesh.vertices()[vertex as usize].raw());
        for (from, to) in [(a, b), (b, c), (c, a)] {
            assert!((0..3).all(|k| from[k].abs_diff(to[k]) < 1 << 41), "long face {corners:?}");
        }
    }
}

/// Every side of a face is found among the edges, and every edge among the neighbours.
fn agrees_with_its_edges(mesh: &TriangleMesh) {
    let adjacency = Adjacency::new(mesh);
    let components = adjacency.components();
    for (face, &[a, b, c]) in (0..).zip(mesh.faces()) {
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let found = adjacency.edge(from, to).is_some_and(|edge| edge.faces.contains(&face));
            assert_eq!(found, from != to, "side {from} {to} of face {face}");
            assert_eq!(components[from as usize], components[to as usize]);
        }
    }
    for edge in adjacency.edges() {
        let [a, b] = edge.ends;
        assert!(a < b && adjacency.neighbours(a).contains(&b), "{edge:?}");
        assert!(adjacency.neighbours(b).contains(&a), "{edge:?}");
    }
}

/// A weld leaves nothing to weld, and nothing in the place of another vertex.
fn is_welded_once(mesh: &TriangleMesh) {
    for tolerance in TOLERANCES.map(Real::from_raw) {
        let Ok(welded) = mesh.welded(tolerance) else { continue };
        assert_eq!(welded.faces().len(), mesh.faces().len());
        assert_eq!(welded.welded(tolerance).as_ref(), Ok(&welded), "welded twice");
        let mut places: Vec<Vec3> = welded.vertices().to_vec();
        places.sort_unstable();
        assert!(places.windows(2).all(|pair| pair[0] != pair[1]), "two in one place");
    }
}
