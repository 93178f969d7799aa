//! Everything the library promises, by topic.
#![allow(
    clippy::disallowed_methods,
    clippy::disallowed_types,
    clippy::expect_used,
    clippy::float_arithmetic,
    clippy::panic,
    clippy::pedantic,
    clippy::print_stdout,
    clippy::unwrap_used,
    unreachable_pub,
    reason = "tests compare with floats, and fail by panicking"
)]

mod support;

/// Hierarchies of volumes over meshes.
mod bvh;
/// Nearest points against rational numbers.
mod closest;
/// Bodies of meshes: cloth, ropes and plants.
mod cloth;
/// What each command does and what it is refused for.
mod commands;
/// What the fuzzers start from, without a fuzzer.
mod corpus;
/// Exact predicates and triangles against oracles of big integers.
mod detector;
/// What a renderer is told.
mod draw;
/// Every fixture scene as it was accepted; saved, moved and threaded meanwhile.
mod golden;
/// Convex hulls against looking at every plane; what fits around points.
mod hull;
/// Laws for random and for hostile worlds.
mod laws;
/// Where convex shapes touch, against twins in floats.
mod manifold;
/// Numbers against big-integer oracles.
mod math;
/// Triangle meshes: their limits, what touches in them, OBJ files that are read or refused.
mod mesh;
/// Free motion against the textbook, and the limits of a world.
mod motion;
/// Candidate pairs: every partition against every pair.
mod partition;
/// Distances, casts and sets of shapes against twins in floats.
mod query;
/// Meshes of fewer faces, and how far they are from what they stand for.
mod reduction;
/// Constraints and contacts against the textbook and a naive twin.
mod relaxation;
/// Recordings that prove themselves, and those that do not.
mod replay;
/// Scene text: numbers, errors, every fixture.
mod scene;
/// Round shapes, boxes and half-spaces: their limits and bounds.
mod shapes;
/// Worlds as bytes: identity, damage, hostile contents, hashes, differences.
mod snapshot;
/// What is soft: springs, ropes, what tears, volumes, cloth in the wind.
mod soft;
/// Meshes and height fields that touch.
mod surface;
/// The shape of the tree: floors, lengths, papers that tell the truth.
mod tidy;
/// Times of impact against roots in big integers and against sampling; landing before them.
mod toi;
