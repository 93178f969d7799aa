//! Mutations of snapshots and replays that get past their hashes.

use verlock::math::Pcg;

use crate::laws::container::{ENTRY, HEADER, record_again, repair, sections};

/// The fuzzer's own mutation of `data[..size]` to at most `max_size` bytes; returns the new size.
pub type Mutate = fn(data: &mut [u8], size: usize, max_size: usize) -> usize;

/// Mutates a file in place: mostly inside a section or by whole records, with right hashes; now and
/// then anywhere, with whatever hashes come of it. Returns the new size.
pub fn mutate(data: &mut [u8], size: usize, max_size: usize, seed: u32, by: Mutate) -> usize {
    let mut random = Pcg::new(seed.into(), 0);
    let mut file = data[..size].to_vec();
    if random.below(8) == 0 || sections(&file).is_empty() {
        anywhere(&mut file, max_size, by);
    } else {
        while {
            within(&mut file, max_size, &mut random, by);
            random.below(2) == 0
        } {}
        repair(&mut file);
        if random.below(4) > 0 {
            record_again(&mut file);
        }
    }
    file.truncate(max_size);
    data[..file.len()].copy_from_slice(&file);
    file.len()
}

fn anywhere(file: &mut Vec<u8>, max_size: usize, by: Mutate) {
    if max_size == 0 {
        return; // the fuzzer cannot make nothing of nothing
    }
    let size = file.len().min(max_size);
    file.resize(max_size, 0);
    let size = by(file, size, max_size);
    file.truncate(size);
}

fn within(file: &mut Vec<u8>, max_size: usize, random: &mut Pcg, by: Mutate) {
    let all = sections(file);
    let Some(section) = pick(random, all.len()) else { return anywhere(file, max_size, by) };
    let room = max_size.saturating_sub(file.len());
    let mut payload = file[all[section].clone()].to_vec();
    match random.below(4) {
        0 => anywhere(file, file.len(), by),
        1 => records(file, room, section, random),
        // A snapshot inside a replay is mutated like one outside.
        _ if sections(&payload).len() > 1 => {
            within(&mut payload, all[section].len() + room, random, by);
            replace(file, section, &payload);
        }
        _ => {
            let grown = payload.len() + room.min(2 * record_size(file, section));
            anywhere(&mut payload, grown, by);
            replace(file, section, &payload);
        }
    }
}

/// Drops, doubles or copies a record, in all sections that have as many: they belong together.
fn records(file: &mut Vec<u8>, room: usize, section: usize, random: &mut Pcg) {
    let count = |file: &[u8], k: usize| sections(file)[k].len() / record_size(file, k);
    let like = count(file, section);
    let (Some(from), Some(to)) = (pick(random, like), pick(random, like)) else { return };
    let action = random.below(3);
    let row: usize = (0..sections(file).len()).map(|k| record_size(file, k)).sum();
    for k in 0..sections(file).len() {
        let size = record_size(file, k);
        if count(file, k) != like {
            continue;
        }
        let payload = file[sections(file)[k].clone()].to_vec();
        let mut rows: Vec<&[u8]> = payload.chunks(size).collect();
        match action {
            0 => drop(rows.remove(from)),
            1 if room >= row => rows.insert(to, rows[from]),
            _ => rows[to] = rows[from],
        }
        replace(file, k, &rows.concat());
    }
}

/// Bytes of the records of a section, as its row tells; at least 1.
fn record_size(bytes: &[u8], section: usize) -> usize {
    let raw = bytes[HEADER + section * ENTRY + 4..].first_chunk();
    let size = raw.map_or(1, |raw| u32::from_le_bytes(*raw));
    usize::try_from(size).unwrap_or(1).max(1)
}

/// Replaces a section by the whole records of `payload`; the hashes are wrong afterwards.
fn replace(bytes: &mut Vec<u8>, section: usize, payload: &[u8]) {
    let size = record_size(bytes, section);
    let count = payload.len() / size;
    let payload = &payload[..count * size];
    bytes.splice(sections(bytes)[section].clone(), payload.iter().copied());
    let row = HEADER + section * ENTRY;
    for (at, number) in [(8, count), (16, payload.len())] {
        bytes[row + at..row + at + 8].copy_from_slice(&(number as u64).to_le_bytes());
    }
}

fn pick(random: &mut Pcg, count: usize) -> Option<usize> {
    let count = u32::try_from(count).ok().filter(|&count| count > 0)?;
    usize::try_from(random.below(count)).ok()
}
