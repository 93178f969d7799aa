//! What differs between two snapshots.

use core::fmt;

use super::{Section, Snapshot, Value};

/// One difference between two snapshots.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Difference {
    /// Where.
    pub section: Section,
    /// What differs there.
    pub values: Values,
}

/// The two sides of a difference.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Values {
    /// The sections have different numbers of records; the common ones are compared too.
    Counts {
        /// The first snapshot's.
        a: u64,
        /// The second snapshot's.
        b: u64,
    },
    /// A field of one object differs.
    Field {
        /// The object's slot.
        index: u64,
        /// The field.
        field: &'static str,
        /// The first snapshot's value.
        a: Value,
        /// The second snapshot's value.
        b: Value,
    },
}

/// All differences, by section, object and field. Sections with equal hashes are skipped.
pub fn diff<'a>(a: &'a Snapshot<'a>, b: &'a Snapshot<'a>) -> impl Iterator<Item = Difference> + 'a {
    let differ = |section: &Section| a.part_hash(*section) != b.part_hash(*section);
    Section::ALL.into_iter().filter(differ).flat_map(move |section| {
        let counts = (a.count(section), b.count(section));
        let unequal = (counts.0 != counts.1).then_some(Values::Counts { a: counts.0, b: counts.1 });
        let size = section.record_size() as usize;
        let records = a.bytes(section).chunks(size).zip(b.bytes(section).chunks(size));
        let changed = (0..).zip(records).filter(|(_, (a, b))| a != b).map(|(index, _)| index);
        let fields =
            changed.flat_map(move |index| {
                let pairs = a.record(section, index).zip(b.record(section, index));
                pairs.filter(|((_, a), (_, b))| a != b).map(move |((field, a), (_, b))| {
                    Values::Field { index, field: field.name, a, b }
                })
            });
        unequal.into_iter().chain(fields).map(move |values| Difference { section, values })
    })
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let section = self.section;
        match self.values {
            Values::Counts { a, b } => write!(f, "{section}: {a} records against {b}"),
            Values::Field { index, field, a, b } => {
                let digits = 2 * a.kind.width() as usize;
                let (raw_a, raw_b) = (a.raw, b.raw);
                write!(f, "{section} {index} {field}: {a} against {b} ")?;
                write!(f, "(raw 0x{raw_a:0digits$x} against 0x{raw_b:0digits$x})")
            }
        }
    }
}
