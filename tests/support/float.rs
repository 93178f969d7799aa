//! Floats in and out, for tests that compare with textbook formulas.

#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::float_arithmetic,
    reason = "textbook formulas are evaluated in floating point"
)]

use verlock::math::{Factor, Real, Unit, UnitVec3, Vec3};

/// Metres of one raw unit.
pub const ULP: f64 = 1.0 / 16_777_216.0;

pub fn real(v: f64) -> Real {
    Real::from_f64(v).expect("a number of a test fits")
}

pub fn vec3(v: [f64; 3]) -> Vec3 {
    Vec3::from_f64(v).expect("a vector of a test fits")
}

pub fn factor(v: f64) -> Factor {
    Factor::from_f64(v).expect("a factor of a test fits")
}

pub fn unit(v: f64) -> Unit {
    Unit::from_f64(v).expect("a share of a test fits")
}

pub fn direction(v: [f64; 3]) -> UnitVec3 {
    UnitVec3::normalize(vec3(v)).expect("a direction of a test has a length")
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + b s`.
pub fn add_scaled(a: [f64; 3], b: [f64; 3], s: f64) -> [f64; 3] {
    [a[0] + b[0] * s, a[1] + b[1] * s, a[2] + b[2] * s]
}

pub fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
