//! The command as a shell sees it: arguments, files, streams and exit codes.
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::float_arithmetic,
    clippy::format_push_string,
    reason = "tests compare with floats, and print little"
)]

/// Where two recordings part.
mod bisect;
/// Where two meshes touch.
mod contacts;
/// Files whose hashes are repaired after a change.
mod container;
/// Two states compared.
mod diff;
/// Streams, limits, and files that must not be overwritten.
mod files;
/// Every tick in every way.
mod heavy;
/// What a file is and holds.
mod inspect;
/// Two meshes that intersect, or do not.
mod overlap;
/// What stands in for a mesh, and how far off it is.
mod reduce;
/// Pictures: sizes, sheets, films, goldens.
mod render;
/// Scenes stepped and recorded.
mod run;
/// A folder of its own for every test.
mod sandbox;
/// Manual pages and completions.
mod scripts;
/// When one mesh that moves touches another.
mod toi;
/// Replays stepped again.
mod verify;
