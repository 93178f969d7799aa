//! What partitions refuse, and that it changes nothing.

use verlock::geometry::Aabb;
use verlock::partition::{ID_MAX, Object};
use verlock::{Real, Vec3};

use super::{PartitionError, all};

fn cube(x: i32) -> Object {
    Aabb::new(Vec3::from_ints(x, 0, 0), Vec3::from_ints(x + 1, 1, 1)).into()
}

#[test]
fn misuse_is_refused() {
    let beyond = Vec3::new(Real::ZERO, Real::from_raw(Object::COORDINATE_MAX + 1), Real::ZERO);
    let bounds = Object { bounds: Aabb::new(Vec3::ZERO, beyond), centre: Vec3::ZERO };
    let below = Object { bounds: Aabb::new(Vec3::ZERO, -beyond), centre: Vec3::ZERO };
    let centre = Object { centre: beyond, ..cube(0) };
    let lowest = Object { centre: Vec3::new(Real::MIN, Real::ZERO, Real::ZERO), ..cube(0) };
    let [no_bounds, no_centre] =
        ["bounds", "centre"].map(|field| Err(PartitionError::OutOfRange { field }));
    let refused =
        [(bounds, no_bounds), (below, no_bounds), (centre, no_centre), (lowest, no_centre)];
    for (name, mut partition) in all() {
        assert_eq!(partition.update(0, cube(0)), Err(PartitionError::UnknownId), "{name}");
        assert_eq!(partition.remove(0), Err(PartitionError::UnknownId), "{name}");
        assert_eq!(partition.remove(u32::MAX), Err(PartitionError::UnknownId), "{name}");
        partition.insert(0, cube(0)).expect("inserted");
        partition.insert(2, cube(1)).expect("inserted");
        for id in [ID_MAX + 1, u32::MAX] {
            assert_eq!(partition.insert(id, cube(0)), Err(PartitionError::IdTooLarge), "{name}");
            assert_eq!(partition.update(id, cube(0)), Err(PartitionError::UnknownId), "{name}");
        }
        assert_eq!(partition.insert(2, cube(9)), Err(PartitionError::IdTaken), "{name}");
        assert_eq!(partition.update(1, cube(0)), Err(PartitionError::UnknownId), "{name}");
        assert_eq!(partition.remove(1), Err(PartitionError::UnknownId), "{name}");
        for (object, answer) in refused {
            assert_eq!(partition.insert(1, object), answer, "{name}");
            assert_eq!(partition.update(2, object), answer, "{name}");
        }
        assert_eq!(partition.pairs(), [[0, 2]], "{name}");
        assert_eq!((partition.object(1), partition.object(2)), (None, Some(cube(1))), "{name}");
        assert_eq!((partition.len(), partition.validate()), (2, Ok(())), "{name}");
    }
}

/// A free id can be taken again, at once.
#[test]
fn ids_are_used_again() {
    for (name, mut partition) in all() {
        for id in [0, 1, 2, ID_MAX] {
            partition.insert(id, cube(0)).expect("inserted");
        }
        assert_eq!(partition.pairs().len(), 6, "{name}");
        partition.remove(1).expect("removed");
        partition.insert(1, cube(9)).expect("inserted");
        assert_eq!(partition.pairs(), [[0, 2], [0, ID_MAX], [2, ID_MAX]], "{name}");
        for id in [0, 1, 2, ID_MAX] {
            partition.remove(id).expect("removed");
        }
        assert!(partition.is_empty() && partition.pairs().is_empty(), "{name}");
        assert_eq!(partition.validate(), Ok(()), "{name}");
    }
}

/// What is refused is told in a line that names the field.
#[test]
fn errors_name_the_field() {
    let lines = [
        (PartitionError::IdTooLarge, "id: above 1048575"),
        (PartitionError::IdTaken, "id: taken by another object"),
        (PartitionError::UnknownId, "id: no object has it"),
        (PartitionError::OutOfRange { field: "centre" }, "centre: beyond 2^36 m"),
    ];
    for (error, line) in lines {
        assert_eq!(error.to_string(), line);
    }
}
