//! Exact predicates: on which side a point is.
//!
//! Signs of determinants in integers that are wide enough, so there is neither an epsilon nor a
//! filter: 128 bits for points within 131 km of one another, 192 and more beyond. What they say is
//! the truth for any [`Real`]s (Shewchuk, *Adaptive Precision Floating-Point Arithmetic and Fast
//! Robust Geometric Predicates*, 1997, names them and does the same for floats).

use core::cmp::Ordering;

use crate::math::determinant::{Full, Middle, Width, sign_of_det2, sign_of_det3};
use crate::math::{Real, Vec3};

/// On which side of the line from `a` to `b` the point `c` is: `Greater` to the left, where the
/// turn from `a` over `b` to `c` is counter-clockwise; `Equal` on the line. Exact. O(1).
///
/// ```
/// use core::cmp::Ordering;
/// use verlock::Real;
/// use verlock::geometry::orient2d;
///
/// let [a, b, c] = [(0, 0), (3, 1), (6, 2)].map(|(x, y)| [x, y].map(Real::from_int));
/// assert_eq!(orient2d(a, b, c), Ordering::Equal);
/// assert_eq!(orient2d(a, b, [c[0], c[1] + Real::ULP]), Ordering::Greater);
/// ```
#[inline]
#[must_use]
pub fn orient2d(a: [Real; 2], b: [Real; 2], c: [Real; 2]) -> Ordering {
    let [a, b, c] = [a, b, c].map(|point| point.map(Real::raw));
    let difference = |p: [i64; 2], k: usize| i128::from(p[k]) - i128::from(a[k]);
    let [u, v] = [b, c].map(|p| [0, 1].map(|k| difference(p, k)));
    // Differences below 2^62 make products below 2^124.
    if u.iter().chain(&v).all(|d| d.unsigned_abs() < 1 << 62) {
        return (u[0] * v[1] - u[1] * v[0]).cmp(&0);
    }
    sign_of_det2(a, b, c)
}

/// On which side of the plane through `a`, `b` and `c` the point `d` is: `Greater` where
/// `(b - a) x (c - a)` points, whence the turn from `a` over `b` to `c` is counter-clockwise;
/// `Equal` on the plane, and wherever these three lie on one line. Exact. O(1).
///
/// ```
/// use core::cmp::Ordering;
/// use verlock::{Real, Vec3};
/// use verlock::geometry::orient3d;
///
/// let [a, b, c] = [Vec3::ZERO, Vec3::X, Vec3::Y];
/// assert_eq!(orient3d(a, b, c, Vec3::new(Real::ONE, Real::ONE, Real::ULP)), Ordering::Greater);
/// ```
#[inline]
#[must_use]
pub fn orient3d(a: Vec3, b: Vec3, c: Vec3, d: Vec3) -> Ordering {
    let [a, b, c, d] = [a, b, c, d].map(Vec3::raw);
    let mut wraps = false;
    let [u, v, w] = [b, c, d].map(|p| {
        [0, 1, 2].map(|k| {
            let (difference, wrapped) = p[k].overflowing_sub(a[k]);
            wraps |= wrapped;
            difference
        })
    });
    // No bit above these: the points span less than twice as much, for differences have two signs.
    let bits = [u, v, w].iter().flatten().fold(0, |bits, &c| bits | (c ^ (c >> 63)));
    if wraps || bits >> 41 != 0 {
        sign_of_det3(a, b, c, d)
    } else if bits >> 30 != 0 {
        Full::sign(&Full::cross(u, v), w).cmp(&0)
    } else {
        Middle::sign(&Middle::cross(u, v), w).cmp(&0)
    }
}
