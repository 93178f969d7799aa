//! The vector of the simulation.

use core::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::Real;
use super::root::root_nearest_wide;

/// A point or a difference of points, in metres; a velocity, in metres a second; and so on.
///
/// Ordered by x, then y, then z. Operators panic on overflow in every profile, as those of
/// [`Real`] do. `serde` sees a tuple of three [`Real`]s.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
#[repr(C)]
pub struct Vec3 {
    /// To the right.
    pub x: Real,
    /// Up.
    pub y: Real,
    /// Towards the viewer.
    pub z: Real,
}

impl Vec3 {
    /// (0, 0, 0).
    pub const ZERO: Self = Self::from_ints(0, 0, 0);
    /// (1, 1, 1).
    pub const ONE: Self = Self::from_ints(1, 1, 1);
    /// (1, 0, 0).
    pub const X: Self = Self::from_ints(1, 0, 0);
    /// (0, 1, 0).
    pub const Y: Self = Self::from_ints(0, 1, 0);
    /// (0, 0, 1).
    pub const Z: Self = Self::from_ints(0, 0, 1);

    /// The vector (`x`, `y`, `z`).
    #[inline]
    #[must_use]
    pub const fn new(x: Real, y: Real, z: Real) -> Self {
        Self { x, y, z }
    }

    /// The vector with these raw components.
    #[inline]
    #[must_use]
    pub const fn from_raw(raw: [i64; 3]) -> Self {
        let [x, y, z] = raw;
        Self::new(Real::from_raw(x), Real::from_raw(y), Real::from_raw(z))
    }

    /// The integers behind the components.
    #[inline]
    #[must_use]
    pub const fn raw(self) -> [i64; 3] {
        [self.x.raw(), self.y.raw(), self.z.raw()]
    }

    /// The vector with these whole components.
    #[inline]
    #[must_use]
    pub const fn from_ints(x: i32, y: i32, z: i32) -> Self {
        Self::new(Real::from_int(x), Real::from_int(y), Real::from_int(z))
    }

    /// `self + other`, if every component fits.
    #[inline]
    #[must_use]
    pub fn checked_add(self, other: Self) -> Option<Self> {
        Some(Self {
            x: self.x.checked_add(other.x)?,
            y: self.y.checked_add(other.y)?,
            z: self.z.checked_add(other.z)?,
        })
    }

    /// `self - other`, if every component fits.
    #[inline]
    #[must_use]
    pub fn checked_sub(self, other: Self) -> Option<Self> {
        Some(Self {
            x: self.x.checked_sub(other.x)?,
            y: self.y.checked_sub(other.y)?,
            z: self.z.checked_sub(other.z)?,
        })
    }

    /// The dot product, summed exactly and rounded once; `None` if it does not fit.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> Option<Real> {
        let [a, b, c] = [(self.x, other.x), (self.y, other.y), (self.z, other.z)].map(product);
        // Each is at most 2^126. A sum that leaves 128 bits is brought back by no third product.
        Real::from_product(a.checked_add(b)?.checked_add(c)?)
    }

    /// The cross product, each component exact and rounded once; `None` if one does not fit.
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> Option<Self> {
        // At most 2^63 (2^63 - 1) + 2^126 = 2^127 - 2^63.
        let minor = |a, b, c, d| Real::from_product(product((a, b)) - product((c, d)));
        Some(Self {
            x: minor(self.y, other.z, self.z, other.y)?,
            y: minor(self.z, other.x, self.x, other.z)?,
            z: minor(self.x, other.y, self.y, other.x)?,
        })
    }

    /// The square of the length, exact, in units of 2^-48.
    #[inline]
    #[must_use]
    pub fn length_sq_wide(self) -> u128 {
        // At most 3 * 2^126.
        self.raw().map(|c| u128::from(c.unsigned_abs()).pow(2)).into_iter().sum()
    }

    /// The length, to nearest.
    ///
    /// # Panics
    ///
    /// In every profile if it exceeds [`Real::MAX`]; it cannot when |components| <= 2^62 raw.
    #[inline]
    #[must_use]
    pub fn length(self) -> Real {
        let root = i64::try_from(root_nearest_wide(self.length_sq_wide()));
        Real::from_raw(root.expect("Real overflow: length"))
    }

    /// The distance between two points, to nearest.
    ///
    /// # Panics
    ///
    /// In every profile if it, or a difference of components, does not fit; it does whenever
    /// both points have |components| <= 2^61 raw.
    #[inline]
    #[must_use]
    pub fn distance(self, other: Self) -> Real {
        (self - other).length()
    }
}

/// The exact product, in units of 2^-48; at most 2^126.
#[inline]
fn product((a, b): (Real, Real)) -> i128 {
    i128::from(a.raw()) * i128::from(b.raw())
}

impl Add for Vec3 {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vec3 {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Mul<Real> for Vec3 {
    type Output = Self;
    #[inline]
    fn mul(self, factor: Real) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}

impl Neg for Vec3 {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl AddAssign for Vec3 {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Vec3 {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl MulAssign<Real> for Vec3 {
    #[inline]
    fn mul_assign(&mut self, factor: Real) {
        *self = *self * factor;
    }
}

impl Serialize for Vec3 {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { x, y, z } = self;
        (x, y, z).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Vec3 {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Deserialize::deserialize(deserializer).map(|(x, y, z)| Self { x, y, z })
    }
}
