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
    let [a, b, c, d] = [a.raw(), b.raw(), c.raw(), d.raw()];
    let (u, v, w) = (difference(b, a), difference(c, a), difference(d, a));
    let bits = extent(b, a) | extent(c, a) | extent(d, a);
    // Points whose differences from one of them have k bits span less than 2^(k + 1).
    if bits < 1 << 30 {
        Middle::sign(&Middle::cross(u, v), w).cmp(&0)
    } else if bits < 1 << 41 {
        Full::sign(&Full::cross(u, v), w).cmp(&0)
    } else {
        sign_of_det3(a, b, c, d)
    }
}

/// `p - o`, which may wrap.
#[inline]
fn difference(p: [i64; 3], o: [i64; 3]) -> [i64; 3] {
    [p[0].wrapping_sub(o[0]), p[1].wrapping_sub(o[1]), p[2].wrapping_sub(o[2])]
}

/// The bits of the magnitudes of `p - o` (for `-n` those of `n - 1`): all, where it wraps.
#[inline]
fn extent(p: [i64; 3], o: [i64; 3]) -> u64 {
    let along = |k: usize| {
        let (difference, wraps) = p[k].overflowing_sub(o[k]);
        (difference ^ (difference >> 63)) | -i64::from(wraps)
    };
    (along(0) | along(1) | along(2)).cast_unsigned()
}
