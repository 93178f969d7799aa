//! Which files a command looks at.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::input::is_dash;

/// How the names of replays end.
pub(crate) const REPLAY: &str = ".replay";
/// How the names of scenes end.
pub(crate) const SCENE: &str = ".scene.ron";

/// The file itself, or all below a folder whose names end like one of these, sorted. A folder
/// without any would pass by comparing nothing, so it fails.
pub(crate) fn files(path: &Path, endings: &[&str]) -> Result<Vec<PathBuf>, Failure> {
    if is_dash(path) || !path.is_dir() {
        return Ok(vec![path.into()]);
    }
    let mut found = Vec::new();
    collect(path, endings, &mut found).map_err(|error| Failure::io(path.display(), &error))?;
    if found.is_empty() {
        let endings: Vec<_> = endings.iter().map(|ending| format!("*{ending}")).collect();
        let why = format!("no {} in this folder", endings.join(" or "));
        return Err(Failure::unproven(path.display(), why));
    }
    found.sort();
    Ok(found)
}

/// Adds the files below a folder. Links to folders are not followed: they may lead back.
fn collect(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = entry.path();
        if entry.file_type()?.is_dir() {
            collect(&path, endings, found)?;
        } else if endings
            .iter()
            .any(|end| path.as_os_str().as_encoded_bytes().ends_with(end.as_bytes()))
        {
            found.push(path);
        }
    }
    Ok(())
}
