//! Hashes of bytes.

use core::fmt;
use core::str::FromStr;

use xxhash_rust::xxh3::{Xxh3Default, xxh3_128};

/// XXH3-128 of some bytes: finds accidents, not forgers.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug, Default)]
pub struct Hash(pub u128);

impl Hash {
    /// The hash of these bytes, seed 0.
    #[must_use]
    pub fn of(bytes: &[u8]) -> Self {
        Self(xxh3_128(bytes))
    }

    /// As files store it.
    #[must_use]
    pub const fn to_bytes(self) -> [u8; 16] {
        self.0.to_le_bytes()
    }

    /// From what a file stores.
    #[must_use]
    pub const fn from_bytes(bytes: [u8; 16]) -> Self {
        Self(u128::from_le_bytes(bytes))
    }
}

/// The hash of bytes that come piece by piece.
#[derive(Default)]
pub(crate) struct Hasher(Xxh3Default);

impl Hasher {
    /// Appends bytes.
    pub(crate) fn write(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// The [hash](Hash::of) of all of them.
    pub(crate) fn finish(&self) -> Hash {
        Hash(self.0.digest128())
    }
}

/// A text is not a hash: 32 hexadecimal digits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ParseHashError;

impl FromStr for Hash {
    type Err = ParseHashError;

    fn from_str(text: &str) -> Result<Self, ParseHashError> {
        if text.len() != 32 || !text.bytes().all(|byte| byte.is_ascii_hexdigit()) {
            return Err(ParseHashError);
        }
        u128::from_str_radix(text, 16).map(Self).map_err(|_| ParseHashError)
    }
}

impl fmt::Display for Hash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:032x}", self.0)
    }
}

impl fmt::Display for ParseHashError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a hash has 32 hexadecimal digits")
    }
}

impl core::error::Error for ParseHashError {}
