//! What several topics need.

#![allow(unreachable_pub, reason = "a test binary has no outside")]

pub mod alloc;
pub mod blueprint;
pub mod container;
pub mod fixture;
pub mod float;
pub mod frame;
#[path = "../../examples/meshes/shapes/mod.rs"]
pub mod meshes;
pub mod momentum;
pub mod random;
pub mod spot;
pub mod twin;
pub mod worlds;
