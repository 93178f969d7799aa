//! Numbers in scene files.
//!
//! A decimal becomes fixed point from its source text: a detour through a float would lose the last
//! digits of a position far from the origin.

use core::str::FromStr;

use ron::value::RawValue;
use serde::de::Error;
use serde::{Deserialize, Deserializer};

use crate::math::wide::round_div_wide;
use crate::math::{DecimalError, Pcg, Real, UnitVec3, Vec3};
use crate::particle::{Particle, RangeError, check_in};

/// A decimal, plain or quoted.
struct Decimal<T>(T);

/// How numbers are written.
const GRAMMAR: &str = "numbers are decimals like -12.5, with a digit first and no exponent";

/// A mass, or a range of masses.
#[derive(Clone, Copy, Debug)]
pub(super) struct Masses {
    pub(super) first: Real,
    pub(super) last: Real,
}

impl<'de, T: FromStr<Err = DecimalError>> Deserialize<'de> for Decimal<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = source(deserializer)?;
        let unquoted = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
        unquoted.unwrap_or(text).parse().map(Self).map_err(|error| match error {
            DecimalError::OutOfRange => D::Error::custom(error),
            _ => D::Error::custom(format_args!("{error}: {GRAMMAR}")),
        })
    }
}

/// The source text of a value, without blanks and comments around it.
fn source<'de, D: Deserializer<'de>>(deserializer: D) -> Result<&'de str, D::Error> {
    <&RawValue>::deserialize(deserializer).map(|raw| raw.trim().get_ron())
}

/// A decimal.
pub(super) fn decimal<'de, D, T>(deserializer: D) -> Result<T, D::Error>
where
    D: Deserializer<'de>,
    T: FromStr<Err = DecimalError>,
{
    Decimal::deserialize(deserializer).map(|Decimal(number)| number)
}

/// A value that may be left out, but needs no `Some` around it where it stands.
pub(super) fn present<'de, D, T>(deserializer: D) -> Result<Option<T>, D::Error>
where
    D: Deserializer<'de>,
    T: Deserialize<'de>,
{
    T::deserialize(deserializer).map(Some)
}

/// A decimal that may be left out.
pub(super) fn present_decimal<'de, D, T>(deserializer: D) -> Result<Option<T>, D::Error>
where
    D: Deserializer<'de>,
    T: FromStr<Err = DecimalError>,
{
    present(deserializer).map(|found| found.map(|Decimal(number)| number))
}

/// Three decimals: `(1, 2.5, -3)`.
pub(super) fn vector<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec3, D::Error> {
    let (Decimal(x), Decimal(y), Decimal(z)) = Deserialize::deserialize(deserializer)?;
    Ok(Vec3 { x, y, z })
}

/// A vector of any length but 0, made a unit vector.
pub(super) fn direction<'de, D: Deserializer<'de>>(deserializer: D) -> Result<UnitVec3, D::Error> {
    let direction = UnitVec3::normalize(vector(deserializer)?);
    direction.ok_or_else(|| D::Error::custom("the zero vector has no direction"))
}

impl<'de> Deserialize<'de> for Masses {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = source(deserializer)?;
        let (first, last) = if text.starts_with('(') {
            let pair: Result<(Decimal<Real>, Decimal<Real>), _> = ron::from_str(text);
            pair.map(|(Decimal(first), Decimal(last))| (first, last))
        } else {
            ron::from_str(text).map(|Decimal(mass)| (mass, mass))
        }
        .map_err(|error| D::Error::custom(error.code))?;
        Ok(Self { first, last })
    }
}

impl Masses {
    /// Checks both ends of the range.
    pub(super) fn validate(self) -> Result<(), RangeError> {
        let range = Particle::MASS_MIN..=Particle::MASS_MAX;
        check_in(self.first, range.clone(), "mass")?;
        check_in(self.last, range, "mass")
    }

    /// The mass after `part` of `whole` steps from the first to the last.
    pub(super) fn step(self, part: u32, whole: u32) -> Real {
        let Self { first, last } = self;
        let way = i128::from(last.raw()) - i128::from(first.raw());
        Real::from_raw(first.raw() + share(way, part, whole))
    }

    /// Draws a mass from the range.
    pub(super) fn draw(self, random: &mut Pcg) -> Real {
        draw(random, self.first, self.last)
    }
}

impl Default for Masses {
    fn default() -> Self {
        Self { first: Real::ONE, last: Real::ONE }
    }
}

/// The vector after `part` of `whole` steps along `edge`; `part <= whole`.
pub(super) fn step(edge: Vec3, part: u32, whole: u32) -> Vec3 {
    Vec3::from_raw(edge.raw().map(|way| share(i128::from(way), part, whole)))
}

/// `way * part / whole`, nearest, of the way between two masses or two positions: below 2^62.
#[expect(clippy::cast_possible_truncation, reason = "no more than the way")]
fn share(way: i128, part: u32, whole: u32) -> i64 {
    round_div_wide(way * i128::from(part), i128::from(whole)) as i64
}

/// A number `lo <= r < hi`, or `lo` if there is none.
pub(super) fn draw(random: &mut Pcg, lo: Real, hi: Real) -> Real {
    if lo < hi { random.real(lo, hi) } else { lo }
}

/// A point of the box between two corners.
pub(super) fn draw_point(random: &mut Pcg, min: Vec3, max: Vec3) -> Vec3 {
    let x = draw(random, min.x, max.x);
    let y = draw(random, min.y, max.y);
    let z = draw(random, min.z, max.z);
    Vec3 { x, y, z }
}

/// Moves an absolute position by the scene's origin.
pub(super) fn shift(
    position: &mut Vec3,
    origin: Vec3,
    field: &'static str,
) -> Result<(), RangeError> {
    *position = position.checked_add(origin).ok_or(RangeError::new(field))?;
    Ok(())
}
