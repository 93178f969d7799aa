//! Everything the library promises, by topic.

mod support;

/// Numbers against big-integer oracles.
mod math;
