//! Hashes as lines of text.

use verlock::Hash;
use verlock::replay::{HashLog, HashLogError, HashLogReason, Replay, bisect};

use super::record;
use crate::support::fixture::{Fixture, read};

/// What is written is read back; comments, gaps and notes are skipped.
#[test]
fn a_log_survives_its_text() {
    let bytes = record(9, 4).replay();
    let log = HashLog::of(&Replay::parse(&bytes).expect("a sound replay"));
    assert_eq!(log.span(), Some([2, 11]));
    assert_eq!(log.iter().count(), 10);
    let text = log.to_string();
    assert_eq!(text.lines().count(), 10);
    assert_eq!(text.parse(), Ok(log.clone()));
    let noted = format!("# a comment\n\n{}", text.replace('\n', " world=01234567 ...\r\n"));
    assert_eq!(noted.parse(), Ok(log));
    assert_eq!("".parse(), Ok(HashLog::default()));
}

/// A state that is hashed again, after a rollback, replaces the one before.
#[test]
fn the_last_hash_counts() {
    let mut log = HashLog::default();
    assert_eq!(log.span(), None);
    for (tick, hash) in [(7, 1), (5, 2), (7, 3)] {
        log.insert(tick, Hash(hash));
    }
    assert_eq!(log.iter().collect::<Vec<_>>(), [(5, Hash(2)), (7, Hash(3))]);
    assert_eq!((log.at(7), log.at(6)), (Some(Hash(3)), None));
}

/// A line that is none is named, with what is wrong with it.
#[test]
fn bad_lines_are_named() {
    let good = format!("3 {}\n", Hash(3));
    let cases = [
        ("x", HashLogReason::Tick),
        (&Hash(u128::MAX).to_string(), HashLogReason::Tick),
        ("-4 0", HashLogReason::Tick),
        ("18446744073709551616 0", HashLogReason::Tick),
        ("4", HashLogReason::Hash),
        ("4 0123456789abcdef", HashLogReason::Hash),
        ("4 0123456789abcdef0123456789abcdeg", HashLogReason::Hash),
        (&format!("3 {}", Hash(3)), HashLogReason::Order),
        (&format!("2 {}", Hash(3)), HashLogReason::Order),
    ];
    for (line, reason) in cases {
        let text = format!("# first\n{good}{line}\n");
        assert_eq!(text.parse::<HashLog>(), Err(HashLogError { line: 3, reason }), "{line}");
    }
}

/// The golden files are hash logs with notes, and the recordings agree with them.
#[test]
fn golden_files_are_logs() {
    for Fixture { name, .. } in Fixture::all() {
        let golden = String::from_utf8(read(&format!("golden/{name}.hashes"))).expect("a text");
        let golden: HashLog = golden.parse().expect("a hash log");
        let bytes = read(&format!("replays/{name}.replay"));
        let recorded = HashLog::of(&Replay::parse(&bytes).expect("a sound replay"));
        let found = bisect(&golden, &recorded);
        assert!(found.is_equal() && found.compared > 4, "{name}: {found:?}");
    }
}
