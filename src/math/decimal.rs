//! Decimal text to fixed point and back, exactly.

use core::fmt;

/// Why a text is not a number of the type asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DecimalError {
    /// There is no digit.
    Empty,
    /// A byte stands where the grammar of the method has none.
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
    match scan(text) {
        Ok(whole) => nearest(text, whole, bits),
        Err(error) => Err(error),
    }
}

/// The same for decimals as other programs print them, see [`Real::parse_scientific`].
///
/// [`Real::parse_scientific`]: super::Real::parse_scientific
pub(super) const fn parse_scientific(text: &[u8], bits: u32) -> Result<i128, DecimalError> {
    match scan_scientific(text) {
        Ok((digits, whole)) => nearest(digits, whole, bits),
        Err(error) => Err(error),
    }
}

/// Where digits can begin: behind the sign, if there is one.
const fn sign_end(text: &[u8]) -> usize {
    (!text.is_empty() && (text[0] == b'+' || text[0] == b'-')) as usize
}

/// The error of a byte that no number has in this place.
const fn unexpected(text: &[u8], at: usize) -> DecimalError {
    let offset = if at > u32::MAX as usize { u32::MAX } else { at as u32 };
    DecimalError::UnexpectedByte { offset, byte: text[at] }
}

/// Checks the grammar; counts the digits of the whole part.
const fn scan(text: &[u8]) -> Result<i64, DecimalError> {
    let start = sign_end(text);
    if text.len() == start {
        return Err(DecimalError::Empty);
    }
    let (mut whole, mut pointed) = (0, false);
    let mut i = start;
    while i < text.len() {
        let digit = text[i].is_ascii_digit();
        let separates = text[i] == b'_' || text[i] == b'.' && !pointed;
        let between = i > start
            && text[i - 1].is_ascii_digit()
            && i + 1 < text.len()
            && text[i + 1].is_ascii_digit();
        if !(digit || separates && between) {
            return Err(unexpected(text, i));
        }
        pointed |= text[i] == b'.';
        whole += (digit && !pointed) as i64;
        i += 1;
    }
    Ok(whole)
}

/// Checks the grammar with an exponent; gives the text in front of it, and how many of the digits
/// there belong to the whole part once the point has been moved.
const fn scan_scientific(text: &[u8]) -> Result<(&[u8], i64), DecimalError> {
    let start = sign_end(text);
    let point = digits_end(text, start);
    let pointed = point < text.len() && text[point] == b'.';
    let end = if pointed { digits_end(text, point + 1) } else { point };
    if end == start + pointed as usize {
        return Err(if end == text.len() { DecimalError::Empty } else { unexpected(text, end) });
    }
    let whole = (point - start).cast_signed() as i64;
    let (digits, exponent) = text.split_at(end);
    if exponent.is_empty() {
        return Ok((digits, whole));
    }
    let (_, power) = exponent.split_at(1);
    let first = sign_end(power);
    let last = digits_end(power, first);
    if !exponent[0].eq_ignore_ascii_case(&b'e') || last == first {
        return Err(unexpected(text, end));
    }
    if last < power.len() {
        return Err(unexpected(text, end + 1 + last));
    }
    // A text has fewer than 2^56 digits, and the point is moved by less than 2^60.
    let moved = moves(power, first);
    Ok((digits, if power[0] == b'-' { whole - moved } else { whole + moved }))
}

/// The first place from `at` on that holds no digit.
const fn digits_end(text: &[u8], at: usize) -> usize {
    let mut end = at;
    while end < text.len() && text[end].is_ascii_digit() {
        end += 1;
    }
    end
}

/// By how many digits the point is moved, from the digits of the exponent. From 2^56 on more of
/// them say nothing new: no text has that many digits to move the point over.
const fn moves(text: &[u8], at: usize) -> i64 {
    let mut places = 0;
    let mut i = at;
    while i < text.len() && places < 1 << 56 {
        places = places * 10 + (text[i] - b'0') as i64;
        i += 1;
    }
    places
}

/// The nearest integer to `2^bits` times the number with these digits, the first `place` of which
/// are its whole part. Below 0, `-place` zeros stand between the point and the first digit.
///
/// Behind the point, `n = bits + 1` digits are all that rounding needs. Let D be these and f the
/// whole fraction, so that `f = (D + e) / 10^n` with `0 <= e < 1`. Then `f 2^n = (D + e) / 5^n`,
/// and as D is an integer its floor is that of `D / 5^n`: later digits cannot matter.
const fn nearest(text: &[u8], mut place: i64, bits: u32) -> Result<i128, DecimalError> {
    assert!(bits <= 30, "decimal: more than 30 fraction bits");
    let last = -(bits as i64 + 1);
    let (mut whole, mut fraction) = (0_u128, 0_u128);
    let mut i = 0;
    // Behind the last digit of a whole part that an exponent makes longer come zeros.
    while place > last && (i < text.len() || place > 0 && whole > 0) {
        let byte = if i < text.len() { text[i] } else { b'0' };
        i += 1;
        if !byte.is_ascii_digit() {
            continue;
        }
        let digit = (byte - b'0') as u128;
        if place > 0 {
            whole = whole * 10 + digit;
        } else {
            fraction = fraction * 10 + digit; // below 10^31 < 2^103
        }
        if whole >> 64 != 0 {
            return Err(DecimalError::OutOfRange);
        }
        place -= 1;
    }
    if fraction > 0 && place > last {
        fraction *= 10_u128.pow((place - last).cast_unsigned() as u32); // n places in all
    }
    let half_units = fraction / 5_u128.pow(bits + 1);
    // Below 2^94, and `half_units` at most 2^31.
    let magnitude = ((whole << bits) + ((half_units + 1) >> 1)).cast_signed();
    Ok(if text[0] == b'-' { -magnitude } else { magnitude })
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
