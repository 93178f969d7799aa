//! verlock
#![cfg_attr(not(feature = "std"), no_std)]
extern crate alloc;

pub mod constraint;
pub mod math;
pub mod particle;
pub mod replay;
pub mod snapshot;
pub mod store;
pub mod world;
