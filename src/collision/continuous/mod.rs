//! When shapes in motion first touch.

mod mesh_motion;
mod time_of_impact;

pub use mesh_motion::MeshMotion;
pub use time_of_impact::TimeOfImpact;
