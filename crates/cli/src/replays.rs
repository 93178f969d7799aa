//! Which files are verified.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::input::is_dash;

/// The file itself, or all `*.replay` below a folder, sorted. A folder without any would verify by
/// comparing nothing, so it fails.
pub(crate) fn replays(path: &Path) -> Result<Vec<PathBuf>, Failure> {
    if is_dash(path) || !path.is_dir() {
        return Ok(vec![path.into()]);
    }
    let mut found = Vec::new();
    collect(path, &mut found).map_err(|error| Failure::io(path.display(), &error))?;
    if found.is_empty() {
        return Err(Failure::unproven(path.display(), "no *.replay in this folder"));
    }
    found.sort();
    Ok(found)
}

/// Adds the replays below a folder. Links to folders are not followed: they may lead back.
fn collect(folder: &Path, found: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = entry.path();
        if entry.file_type()?.is_dir() {
            collect(&path, found)?;
        } else if path.extension().is_some_and(|extension| extension == "replay") {
            found.push(path);
        }
    }
    Ok(())
}
