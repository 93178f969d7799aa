//! Simple shapes around convex hulls: what stands for a mesh where all of it would be too much.
//!
//! Whatever a search finds, the last step is exact: the shape contains every vertex, and so all of
//! the hull. Searches work in integers and take the first of equals, so that the same hull gives
//! the same shape, and the hull elsewhere the same shape elsewhere.
//!
//! ```
//! use verlock::geometry::{ConvexHull, fit_capsule};
//! use verlock::{Vec3, real};
//!
//! let ends = [Vec3::ZERO, Vec3::from_ints(3, 4, 0)];
//! let rod = ConvexHull::cylinder(ends, real!("0.1"), 12)?;
//! let capsule = fit_capsule(&rod)?;
//! assert!(capsule.shape.radius() < real!("0.11"));
//! assert!(capsule.deviation < real!("0.1"));
//! # Ok::<(), verlock::geometry::ShapeError>(())
//! ```

mod axis;
mod ball;
mod capsule;
mod cuboid;
mod frame;
mod hull;
mod outward;
mod rectangle;
mod sphere;
mod tighten;

pub use capsule::fit_capsule;
pub use cuboid::fit_cuboid;
pub use hull::fit_hull;
pub use sphere::fit_sphere;

use crate::math::Real;

/// A shape around a hull.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Fit<S> {
    /// It contains the hull.
    pub shape: S,
    /// The greatest distance of a point of the shape from the hull, in metres. Wrong by at most
    /// 2^-28 of the hull's size and two raw units.
    pub deviation: Real,
}
