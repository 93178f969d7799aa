//! What the commands about meshes share.

use std::sync::Arc;

use verlock::collision::{FeatureId, FeatureKind};
use verlock::geometry::TriangleMesh;

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
