//! Numbers as options take them.

use verlock::Real;
use verlock::math::DecimalError;

/// A number, also with an exponent.
pub(crate) fn number(text: &str) -> Result<Real, String> {
    Real::parse_scientific(text.trim()).map_err(|error| match error {
        DecimalError::OutOfRange => "numbers are below 2^39 either way".into(),
        _ => "a number is expected: 2, -0.5 or 1e-3".into(),
    })
}

/// A length of 0 or more, in metres.
pub(crate) fn length(text: &str) -> Result<Real, String> {
    let length = number(text)?;
    if length < Real::ZERO { Err("is below 0".into()) } else { Ok(length) }
}

/// A whole number that is neither too small nor too large.
pub(crate) fn count_from<const LEAST: u32>(text: &str) -> Result<u32, String> {
    let count = text.parse().ok().filter(|&count| count >= LEAST);
    count.ok_or_else(|| format!("a whole number from {LEAST} to {} is expected", u32::MAX))
}
