//! What the commands about meshes share.

use std::sync::Arc;

use verlock::collision::{FeatureId, FeatureKind, MeshShape};
use verlock::geometry::{Aabb, Surface, TriangleMesh};
use verlock::{Real, Vec3};

use crate::count::counted;
use crate::failure::{Failure, tell};
use crate::input::Input;

/// The mesh of a file. Faces without an area are legal, but seldom meant.
pub(crate) fn mesh(input: &Input) -> Result<Arc<TriangleMesh>, Failure> {
    let mesh = input.mesh()?;
    let degenerate: Vec<_> = mesh.degenerate_faces().collect();
    if let Some(first) = degenerate.first() {
        let count = counted(degenerate.len() as u64, "face");
        tell(format_args!("{}: {count} without an area, the first is {first}", input.name()));
    }
    Ok(Arc::new(mesh))
}

/// Refuses a length, the value of an option, within which more pairs of faces are near one another
/// than can be looked at.
pub(crate) fn check_pairs(
    [a, b]: &[MeshShape; 2],
    option: &str,
    length: Real,
    most: usize,
) -> Result<(), Failure> {
    let reach = Vec3::new(length, length, length);
    let (mut count, mut near) = (0, Vec::new());
    for triangle in (0..).map(|face| a.triangle(face)).take(a.mesh().faces().len()) {
        let bounds = triangle.bounds();
        b.faces_near(&Aabb::new(bounds.min() - reach, bounds.max() + reach), &mut near);
        count += near.len();
        if count > most {
            let what = format!("{option} {length}: more than {most} pairs of faces are as near");
            return Err(Failure::usage(what));
        }
    }
    Ok(())
}

/// What a feature is called, as in `vertex 12`: counted from 0, edges in the order of their
/// vertices.
pub(crate) fn feature_name(feature: FeatureId) -> String {
    let kind = match feature.kind() {
        FeatureKind::Vertex => "vertex",
        FeatureKind::Edge => "edge",
        FeatureKind::Face => "face",
    };
    format!("{kind} {}", feature.index())
}
