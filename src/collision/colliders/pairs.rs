//! What may touch what.

use alloc::vec::Vec;

use super::{ColliderId, Colliders, Filter};
use crate::collision::distance::grown;
use crate::collision::margin::counted;
use crate::math::Real;

impl Colliders {
    /// Which colliders may touch, the lower id first, sorted: those whose layers agree both ways,
    /// and whose boxes are not more than `margin` apart along any axis, in metres; it counts as in
    /// [`collide`](crate::collision::collide). A half-space has no box, and is near everything.
    ///
    /// O(n log n + k) for n colliders and k pairs of boxes that are as near, or O(n sqrt n + k)
    /// where many have moved since.
    ///
    /// ```
    /// use verlock::collision::{Colliders, collide};
    /// use verlock::geometry::{Cuboid, HalfSpace, Sphere};
    /// use verlock::math::UnitVec3;
    /// use verlock::{Vec3, real};
    ///
    /// let mut colliders = Colliders::new();
    /// let floor = colliders.insert(HalfSpace::new(Vec3::ZERO, UnitVec3::Y)?.into())?;
    /// let chest = colliders.insert(Cuboid::upright(Vec3::Y, Vec3::ONE)?.into())?;
    /// let ball = Sphere::new(Vec3::from_ints(0, 3, 0), real!("1"))?;
    /// let ball = colliders.insert(ball.into())?;
    ///
    /// let margin = real!("0.005");
    /// let mut manifolds = Vec::new();
    /// let mut touching = Vec::new();
    /// for [a, b] in colliders.pairs(margin) {
    ///     let [Some(one), Some(other)] = [a, b].map(|id| colliders.get(id)) else { continue };
    ///     manifolds.clear();
    ///     collide(&one.shape, &other.shape, margin, &mut manifolds);
    ///     if !manifolds.is_empty() {
    ///         touching.push([a, b]);
    ///     }
    /// }
    /// assert_eq!(touching, [[floor, chest], [chest, ball]]);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    #[must_use]
    pub fn pairs(&self, margin: Real) -> Vec<[ColliderId; 2]> {
        let margin = counted(margin);
        let mut pairs = Vec::new();
        for (id, collider) in self.iter() {
            let region = collider.shape.bounds().map(|bounds| grown(&bounds, margin));
            let filter = Filter { layers: collider.layers, ..Filter::ALL };
            let near = self.near(region, &filter).map(|(other, _)| other);
            pairs.extend(near.filter(|&other| other > id).map(|other| [id, other]));
        }
        pairs
    }
}
