//! What the fuzz targets share: the laws they assert, how they make files that look right, and how
//! they measure memory.

pub mod laws;
pub mod memory;
pub mod mutator;
