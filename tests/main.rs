//! Everything the library promises, by topic.

mod support;

/// What each command does and what it is refused for.
mod commands;
/// What the fuzzers start from, without a fuzzer.
mod corpus;
/// Every fixture scene as it was accepted; saved, moved and threaded meanwhile.
mod golden;
/// Laws for random and for hostile worlds.
mod laws;
/// Numbers against big-integer oracles.
mod math;
/// Free motion against the textbook, and the limits of a world.
mod motion;
/// Constraints and contacts against the textbook and a naive twin.
mod relaxation;
/// Recordings that prove themselves, and those that do not.
mod replay;
/// Worlds as bytes: identity, damage, hostile contents, hashes, differences.
mod snapshot;
