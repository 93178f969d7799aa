//! Floor 8: a world as bytes, and its hash.
//!
//! A snapshot is a [container](Container): a header, a table of sections, the hash of both, then
//! the sections, each a flat array of little-endian records. `FORMAT.md` describes every byte. The
//! hash of the table covers the hash of every section, so it is the hash of the whole state:
//! [`World::hash`](crate::world::World::hash) computes just that, without making the bytes.
//!
//! Complexity: saving, loading and hashing are O(state). Sections that did not change since they
//! were last hashed cost nothing.

mod codec;
mod container;
mod diff;
mod error;
mod load;
mod save;
mod schema;

pub use crate::store::{Hash, ParseHashError};
pub(crate) use codec::{decode_record, decode_rows, encode_record};
pub use container::{Container, Entry};
pub(crate) use container::{ContainerKind, ContainerWriter};
pub use diff::{Difference, Values, diff};
pub use error::{DecodeError, DecodeReason};
pub use load::Snapshot;
pub use schema::{Field, FieldKind, Section, Value};

/// Names the rules of the simulation. It changes whenever any world could step differently, so that
/// what an older version recorded is refused instead of being called a divergence.
pub const SIM_VERSION: u32 = 1;
