//! Snapshots with sound hashes and unsound contents.

use verlock::constraint::HALF_SPACES_MAX;
use verlock::snapshot::{DecodeReason, FieldKind, Section};
use verlock::world::World;

use crate::support::alloc::peak;
use crate::support::container::{ENTRY, HEADER, Parts, seal};
use crate::support::spot::Spot;
use crate::support::worlds::{actions, command, small};

/// Refusing a small file takes no more memory than this, whatever the file claims.
const REFUSAL_MAX: u64 = 64 << 10;

/// Whatever a field holds, the snapshot is refused for it, or the world steps and stays sound.
#[test]
fn any_value_of_any_field_is_answered() {
    let parts = Parts::of(&small().save());
    let commands: Vec<_> = (0..).zip(actions()).map(|(i, action)| command(i, action)).collect();
    let (mut loaded, mut refused) = (0, 0);
    for spot in Spot::all(&parts) {
        for bits in spot.other_bits(&parts) {
            if spot.field.name == "tick" && bits == u64::MAX >> 1 {
                continue; // the last tick that loads: after a step it does not, and need not
            }
            let file = spot.with(&parts, bits).file();
            match World::load(&file) {
                Ok(mut world) => {
                    loaded += 1;
                    assert_eq!(world.save(), file, "{spot} = {bits:#x}");
                    for commands in [&[], &commands[..]] {
                        world.step(commands);
                        let sound = World::load(&world.save()).map(|_| ());
                        assert_eq!(sound, Ok(()), "{spot} = {bits:#x}, after a step");
                    }
                }
                Err(error) => {
                    refused += 1;
                    let explained = explains(error.reason, &spot, spot.is_alive(&parts));
                    assert!(explained, "{spot} = {bits:#x}: {error}");
                    let sections = parts.table_end() as u64 + 16..file.len() as u64;
                    assert!(sections.contains(&error.offset), "{spot} = {bits:#x}: {error}");
                }
            }
        }
    }
    assert!(loaded > 3000 && refused > 3000, "{loaded} loaded, {refused} refused");
}

/// Whether an error can be about this field.
fn explains(reason: DecodeReason, spot: &Spot, is_alive: bool) -> bool {
    let name = spot.field.name;
    match reason {
        DecodeReason::Record => {
            let strict = matches!(spot.field.kind, FieldKind::Bool | FieldKind::Variant(_));
            strict || name.starts_with("normal") || name == "generation" || !is_alive
        }
        DecodeReason::OutOfRange(range) => {
            let own = name.starts_with(range.field) || spot.section.name() == range.field;
            // Another field can be out of range because of this one.
            let other = matches!(
                (name, range.field),
                ("tick_rate", "phase" | "damping")
                    | ("substeps", "phase")
                    | ("displacement_max", "displacement")
                    | ("a.index" | "a.generation", "b")
                    | ("form", "carry count")
                    | ("rest_length", "slack")
                    | ("generation", "a" | "b" | "corners" | "position of a free slot")
            );
            own || other || !is_alive && range.field == "position of a free slot"
        }
        _ => false,
    }
}

/// A table that claims other sections than there are is refused before anything is allocated.
#[test]
fn any_claim_of_the_table_is_answered() {
    let sound = small().save();
    let rows = Section::ALL.len();
    for row in 0..rows {
        let at = HEADER + row * ENTRY;
        let claims = [(at, 4), (at + 4, 4), (at + 8, 8), (at + 16, 8)];
        for ((at, width), value) in claims.into_iter().flat_map(|claim| {
            let values = [0, 1, 2, 1 << 20, 1 << 31, u64::from(u32::MAX), 1 << 40, 1 << 63];
            values.into_iter().chain([u64::MAX]).map(move |value| (claim, value))
        }) {
            let mut file = sound.clone();
            file[at..at + width].copy_from_slice(&value.to_le_bytes()[..width]);
            if file != sound {
                is_refused(&seal(file));
            }
        }
        // Claims that agree with one another.
        for count in [1_u64 << 20, 1 << 32, 1 << 58] {
            let mut file = sound.clone();
            let size = u64::from(Section::ALL[row].record_size());
            let Some(length) = count.checked_mul(size) else { continue };
            file[at + 8..at + 16].copy_from_slice(&count.to_le_bytes());
            file[at + 16..at + 24].copy_from_slice(&length.to_le_bytes());
            assert_eq!(is_refused(&seal(file)), DecodeReason::Truncated);
        }
    }
}

/// Sections that are missing, too many, doubled or in another order are refused.
#[test]
fn any_other_list_of_sections_is_refused() {
    let sound = Parts::of(&small().save());
    for index in 0..sound.parts.len() {
        let mut fewer = sound.clone();
        fewer.parts.remove(index);
        assert_eq!(is_refused(&fewer.file()), DecodeReason::Layout);
        let mut doubled = sound.clone();
        doubled.parts.insert(index, sound.parts[index].clone());
        assert_eq!(is_refused(&doubled.file()), DecodeReason::Layout);
        let mut swapped = sound.clone();
        swapped.parts.swap(index, (index + 1) % sound.parts.len());
        assert_eq!(is_refused(&swapped.file()), DecodeReason::Layout);
    }
    let mut more = sound.clone();
    let mut last = sound.parts[sound.parts.len() - 1].clone();
    last.kind += 1;
    more.parts.push(last);
    assert_eq!(is_refused(&more.file()), DecodeReason::Layout);
}

/// Sections whose numbers of records do not fit one another are refused.
#[test]
fn any_other_number_of_records_is_refused() {
    let sound = Parts::of(&small().save());
    for section in Section::ALL {
        let size = section.record_size() as usize;
        let mut fewer = sound.clone();
        let bytes = fewer.section(section as u32);
        bytes.truncate(bytes.len() - size);
        // No carries at all are the ones of a list of distances that has changed.
        if section != Section::Carry || !bytes.is_empty() {
            is_refused(&fewer.file());
        }
        let mut more = sound.clone();
        let bytes = more.section(section as u32);
        bytes.extend_from_within(..size);
        is_refused(&more.file());
    }
}

/// A world cannot be loaded with more objects than it can come to have.
#[test]
fn too_many_objects_are_refused() {
    let mut parts = Parts::of(&small().save());
    for section in [Section::HalfSpaceSlot, Section::HalfSpace] {
        let size = section.record_size() as usize;
        let bytes = parts.section(section as u32);
        let alive = bytes[size..].to_vec();
        bytes.extend(alive.repeat(HALF_SPACES_MAX - 2));
    }
    let loaded = World::load(&parts.file()).expect("as many as there can be");
    assert_eq!(loaded.half_spaces().count(), HALF_SPACES_MAX - 1);
    for section in [Section::HalfSpaceSlot, Section::HalfSpace] {
        let size = section.record_size() as usize;
        parts.section(section as u32).extend_from_within(size..);
    }
    match is_refused(&parts.file()) {
        DecodeReason::OutOfRange(range) => assert_eq!(range.field, "half-space count"),
        reason => unreachable!("{reason}"),
    }
}

/// Loading takes memory in proportion to what is there.
#[test]
fn loading_takes_memory_for_what_is_there() {
    let mut parts = Parts::of(&small().save());
    for section in &mut parts.parts[1..5] {
        let size = section.size as usize;
        // Slot 5: the last, which is alive.
        let alive = section.bytes[5 * size..].to_vec();
        section.bytes.extend(alive.repeat(20_000));
    }
    let file = parts.file();
    let (world, used) = peak(|| World::load(&file).expect("a sound snapshot"));
    assert_eq!(world.particles().len(), 20_005);
    let most = 2 * file.len() as u64;
    assert!(used <= most, "{used} bytes for a file of {}", file.len());
}

fn is_refused(file: &[u8]) -> DecodeReason {
    let (result, used) = peak(|| World::load(file).map(|_| ()));
    let error = result.expect_err("an unsound file");
    assert!(error.offset <= file.len() as u64, "{error}");
    assert!(used <= REFUSAL_MAX, "{used} bytes allocated before {error}");
    error.reason
}
