//! Why numbers are not a shape.

use core::fmt;

/// Why numbers are not a shape.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum ShapeError {
    /// A coordinate is beyond [`Triangle::COORDINATE_MAX`](super::Triangle::COORDINATE_MAX), or a
    /// step not above 0.
    OutOfRange(&'static str),
    /// It spans more than [`Triangle::SPAN_MAX`](super::Triangle::SPAN_MAX) along an axis.
    TooLong,
    /// A radius or a thickness is below 0.
    Negative(&'static str),
    /// A radius or a thickness is above [`Sphere::RADIUS_MAX`](super::Sphere::RADIUS_MAX).
    TooLarge(&'static str),
    /// A normal is not of length 1.
    NotUnit(&'static str),
    /// It has no volume.
    Flat,
    /// It is turned inside out.
    Mirrored,
    /// There are too many of something, or too few.
    WrongCount(&'static str),
}

impl fmt::Display for ShapeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutOfRange(field) => write!(f, "{field} out of range"),
            Self::TooLong => f.write_str("shape spans 131072 m or more"),
            Self::Negative(field) => write!(f, "{field} is below 0"),
            Self::TooLarge(field) => write!(f, "{field} is above 32768 m"),
            Self::NotUnit(field) => write!(f, "{field} is not of length 1"),
            Self::Flat => f.write_str("shape has no volume"),
            Self::Mirrored => f.write_str("shape is turned inside out"),
            Self::WrongCount(field) => write!(f, "{field} are too many or too few"),
        }
    }
}

impl core::error::Error for ShapeError {}
