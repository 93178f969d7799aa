//! Values of a state as JSON.

use serde_json::{Value as Json, json};
use verlock::snapshot::{Difference, Value, Values};

/// A field's value: as text, since JSON's numbers are floats to many, and as its bits.
pub(crate) fn value(value: &Value) -> Json {
    json!({ "value": value.to_string(), "raw": raw(value) })
}

/// The bits of a value in hexadecimal, all of its digits.
pub(crate) fn raw(value: &Value) -> String {
    let digits = 2 * value.kind.width() as usize;
    format!("0x{:0digits$x}", value.raw)
}

pub(crate) fn difference(difference: &Difference) -> Json {
    let section = difference.section.name();
    match difference.values {
        Values::Counts { a, b } => json!({ "section": section, "records": [a, b] }),
        Values::Field { index, field, a, b } => json!({
            "section": section, "index": index, "field": field, "a": value(&a), "b": value(&b),
        }),
    }
}
