//! Floor 0: how objects are kept.
//!
//! An object lives in a numbered slot. A [`Handle`] names a slot *and* the generation of its
//! tenant, so that a handle to something removed is recognised instead of reaching its successor.
//! The lowest free slot is handed out first: which slot an object gets is a function of the history
//! alone.

// `Slots` hands the slots out. A `Column` holds seldom changed records, shared between clones; a
// `Table` gives such records handles; a `Memo` keeps a derived value until its source changes.
mod column;
mod handle;
mod hash;
mod memo;
mod slots;
mod table;

pub(crate) use column::Column;
pub use handle::Handle;
pub(crate) use handle::slot_index;
pub(crate) use hash::Hasher;
pub use hash::{Hash, ParseHashError};
pub(crate) use memo::Memo;
pub(crate) use slots::Slots;
pub(crate) use table::Table;
