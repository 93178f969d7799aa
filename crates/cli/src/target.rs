//! A file that a command writes.

use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use crate::failure::Failure;
use crate::input::is_dash;

/// Where to write, and whether a file may be replaced.
#[derive(Debug)]
pub(crate) struct Target {
    path: PathBuf,
    force: bool,
}

impl Target {
    /// Refuses a file that is there, and one in a folder that is not, so that nothing is computed
    /// in vain.
    pub(crate) fn new(path: PathBuf, force: bool) -> Result<Self, Failure> {
        let target = Self { path, force };
        let folder = target.path.parent().filter(|folder| !folder.as_os_str().is_empty());
        if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
            let path = target.path.display();
            return Err(Failure::usage(format!("{path}: there is no folder {}", folder.display())));
        }
        if !force && !target.is_stdout() && target.path.symlink_metadata().is_ok() {
            return Err(target.occupied());
        }
        Ok(target)
    }

    /// As [`new`](Self::new); refuses also to overwrite files that were read.
    pub(crate) fn beside(path: &Path, force: bool, read: &[&Path]) -> Result<Self, Failure> {
        let target = Self::new(path.to_owned(), force)?;
        if read.iter().any(|file| target.is(file)) {
            let path = path.display();
            return Err(Failure::usage(format!("{path}: a mesh would be overwritten")));
        }
        Ok(target)
    }

    pub(crate) fn is_stdout(&self) -> bool {
        is_dash(&self.path)
    }

    /// Whether this is where another path leads too.
    pub(crate) fn is(&self, path: &Path) -> bool {
        let [a, b] = [&self.path, path].map(fs::canonicalize);
        !self.is_stdout() && !is_dash(path) && a.is_ok_and(|a| b.is_ok_and(|b| a == b))
    }

    /// Writes the whole file.
    pub(crate) fn write(&self, bytes: &[u8], out: &mut dyn Write) -> Result<(), Failure> {
        if self.is_stdout() {
            return Ok(out.write_all(bytes)?);
        }
        let file = if self.force {
            File::create(&self.path)
        } else {
            OpenOptions::new().write(true).create_new(true).open(&self.path)
        };
        let written = file.and_then(|mut file| file.write_all(bytes));
        written.map_err(|error| Failure::io(self.path.display(), &error))
    }

    fn occupied(&self) -> Failure {
        Failure::usage(format!("{}: exists, and --force is not given", self.path.display()))
    }
}
