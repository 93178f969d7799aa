//! The one place that names bincode: records to little-endian bytes of fixed width, and back.
//!
//! Payloads hold no strings, lists or maps, so a record never makes the decoder allocate.

use alloc::borrow::Cow;
use alloc::vec::Vec;

use bincode::config::{self, Configuration, Fixint, Limit, LittleEndian};
use bincode::enc::write::Writer;
use bincode::error::EncodeError;
use bytemuck::Pod;
use serde::Serialize;
use serde::de::DeserializeOwned;

/// No record is longer.
const RECORD_MAX: usize = 4096;

const CONFIG: Configuration<LittleEndian, Fixint, Limit<RECORD_MAX>> =
    config::standard().with_little_endian().with_fixed_int_encoding().with_limit::<RECORD_MAX>();

struct Sink<'a>(&'a mut Vec<u8>);

impl Writer for Sink<'_> {
    fn write(&mut self, bytes: &[u8]) -> Result<(), EncodeError> {
        self.0.extend_from_slice(bytes);
        Ok(())
    }
}

/// Appends a record.
///
/// # Panics
/// When the decoder could not read it back: the record takes no byte or more than 4,096, or its
/// serialization fails. A game's own inputs are the only records that could.
pub(crate) fn encode_record<T: Serialize>(record: &T, out: &mut Vec<u8>) {
    let before = out.len();
    let done = bincode::serde::encode_into_writer(record, Sink(out), CONFIG);
    let length = out.len() - before;
    assert!(
        done.is_ok() && (1..=RECORD_MAX).contains(&length),
        "a record that cannot be read back"
    );
}

/// Reads one record from the front of `bytes`; its length too.
pub(crate) fn decode_record<T: DeserializeOwned>(bytes: &[u8]) -> Option<(T, usize)> {
    bincode::serde::decode_from_slice(bytes, CONFIG).ok()
}

/// Records one after the other.
pub(crate) fn encode_rows<T: Serialize>(rows: &[T]) -> Vec<u8> {
    let mut out = Vec::new();
    for row in rows {
        encode_record(row, &mut out);
    }
    out
}

/// The same for numbers without padding: where memory has the order of the file, without a copy.
pub(crate) fn encode_numbers<T: Pod + Serialize>(rows: &[T]) -> Cow<'_, [u8]> {
    if cfg!(target_endian = "little") {
        Cow::Borrowed(bytemuck::cast_slice(rows))
    } else {
        Cow::Owned(encode_rows(rows))
    }
}

/// Reads records of `size` bytes that fill `bytes`; the error is the offset of a bad one.
pub(crate) fn decode_rows<T: DeserializeOwned>(bytes: &[u8], size: usize) -> Result<Vec<T>, u64> {
    let mut rows = Vec::with_capacity(bytes.len() / size);
    for (index, record) in bytes.chunks(size).enumerate() {
        match decode_record(record) {
            Some((row, length)) if length == size => rows.push(row),
            _ => return Err((index * size) as u64),
        }
    }
    Ok(rows)
}
