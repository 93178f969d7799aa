//! Decimal text to fixed point and back, exactly.

use core::fmt;

/// Why a text is not a number of the type asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecimalError {
    /// There is no digit.
    Empty,
    /// A byte stands where the grammar has none: `[+-]digits[.digits]`, `_` between digits.
    UnexpectedByte {
        /// Its position, from 0; texts beyond 4 GiB all say `u32::MAX`.
        offset: u32,
        /// The byte itself.
        byte: u8,
    },
    /// The number does not fit the type.
    OutOfRange,
}

impl fmt::Display for DecimalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => f.write_str("decimal has no digit"),
            Self::UnexpectedByte { offset, byte } => {
                write!(f, "unexpected byte '{}' at offset {offset}", byte.escape_ascii())
            }
            Self::OutOfRange => f.write_str("decimal is out of range"),
        }
    }
}

impl core::error::Error for DecimalError {}

/// The integer nearest to `text * 2^bits`, ties away from zero, for `bits <= 30`.
///
/// Exact for any number of digits. Whole parts of 2^64 and more are out of range; the result is
/// below 2^94, its caller narrows it.
pub(super) const fn parse(text: &[u8], bits: u32) -> Result<i128, DecimalError> {
    assert!(bits <= 30, "decimal: more than 30 fraction bits");
    let (start, point) = match scan(text) {
        Ok(found) => found,
        Err(error) => return Err(error),
    };
    let mut whole: u128 = 0;
    let mut i = start;
    while i < point {
        if text[i] != b'_' {
            whole = whole * 10 + (text[i] - b'0') as u128;
        }
        if whole >> 64 != 0 {
            return Err(DecimalError::OutOfRange);
        }
        i += 1;
    }
    // Below 2^94, and `half_units` at most 2^31.
    let magnitude = ((whole << bits) + ((half_units(text, point, bits) + 1) >> 1)).cast_signed();
    Ok(if text[0] == b'-' { -magnitude } else { magnitude })
}

/// Checks the grammar; finds the first digit and the end of the whole part.
const fn scan(text: &[u8]) -> Result<(usize, usize), DecimalError> {
    let signed = !text.is_empty() && (text[0] == b'+' || text[0] == b'-');
    let start = signed as usize;
    if text.len() == start {
        return Err(DecimalError::Empty);
    }
    let mut point = text.len();
    let mut i = start;
    while i < text.len() {
        let separates = text[i] == b'_' || text[i] == b'.' && point == text.len();
        let between = i > start
            && text[i - 1].is_ascii_digit()
            && i + 1 < text.len()
            && text[i + 1].is_ascii_digit();
        if !(text[i].is_ascii_digit() || separates && between) {
            let offset = if i > u32::MAX as usize { u32::MAX } else { i as u32 };
            return Err(DecimalError::UnexpectedByte { offset, byte: text[i] });
        }
        if text[i] == b'.' {
            point = i;
        }
        i += 1;
    }
    Ok((start, point))
}

/// `floor(f * 2^n)` of the fraction `f` behind the point, with n = `bits` + 1: all that rounding
/// to `bits` bits needs.
///
/// Let D be the first n decimal digits, so that `f = (D + e) / 10^n` with `0 <= e < 1`. Then
/// `f 2^n = (D + e) / 5^n`, and as D is an integer its floor is that of `D / 5^n`: later digits
/// cannot matter. D < 10^31 < 2^103.
const fn half_units(text: &[u8], point: usize, bits: u32) -> u128 {
    let mut wanted = bits + 1;
    let mut digits: u128 = 0;
    let mut i = point + 1;
    while i < text.len() && wanted > 0 {
        if text[i] != b'_' {
            digits = digits * 10 + (text[i] - b'0') as u128;
            wanted -= 1;
        }
        i += 1;
    }
    digits * 10u128.pow(wanted) / 5u128.pow(bits + 1)
}

/// Writes `raw / 2^bits` as the shortest decimal that [`parse`] reads back as `raw`, for
/// `1 <= bits <= 30`. Of those, the nearest to the value.
pub(super) fn write(raw: i64, bits: u32, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let whole = raw.unsigned_abs() >> bits;
    let (digits, places) = shortest_fraction(raw.unsigned_abs() & ((1 << bits) - 1), bits);
    let text = match places {
        0 => alloc::format!("{whole}"),
        _ => alloc::format!("{whole}.{digits:0places$}"),
    };
    f.pad_integral(raw >= 0, "", &text)
}

/// The fewest decimal places that pin `fraction / 2^bits` down, and the digits in them.
///
/// With k places the nearest decimal `c / 10^k` reads back if it is closer than half a unit; if
/// it does not, no k places do. (Exactly half a unit takes more than `bits` places.) The loop
/// ends at the latest when `10^k > 2^bits`, k = 10, where products stay below
/// `2^30 * 10^10 < 2^64`.
fn shortest_fraction(fraction: u64, bits: u32) -> (u64, usize) {
    let mut power: u64 = 1;
    let mut places = 0;
    loop {
        let exact = fraction * power;
        let digits = (exact + (1 << (bits - 1))) >> bits;
        if 2 * exact.abs_diff(digits << bits) < power {
            return (digits, places);
        }
        power *= 10;
        places += 1;
    }
}
