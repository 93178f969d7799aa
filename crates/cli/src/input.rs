//! A file that is given to a command.

use std::fmt::Display;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use verlock::replay::Replay;
use verlock::scene::Scene;
use verlock::snapshot::Snapshot;

use crate::failure::Failure;

/// A file's name and bytes.
#[derive(Debug)]
pub(crate) struct Input {
    name: String,
    bytes: Vec<u8>,
}

/// A file by what it holds.
#[derive(Debug)]
pub(crate) enum Kind<'a> {
    Snapshot(Snapshot<'a>),
    Replay(Replay<'a>),
    Scene(Scene),
}

impl Input {
    pub(crate) fn new(name: String, bytes: Vec<u8>) -> Self {
        Self { name, bytes }
    }

    /// Reads a file, or stdin for `-`, of at most `limit` bytes.
    pub(crate) fn read(path: &Path, limit: u64) -> Result<Self, Failure> {
        let name = name(path);
        let failed = |error| Failure::io(&name, &error);
        let mut size = 0;
        let source: Box<dyn Read> = if is_dash(path) {
            Box::new(io::stdin().lock())
        } else {
            let file = File::open(path).map_err(failed)?;
            size = file.metadata().map_err(failed)?.len();
            Box::new(file)
        };
        let mut bytes = Vec::new();
        if size <= limit {
            source.take(limit.saturating_add(1)).read_to_end(&mut bytes).map_err(failed)?;
        }
        // Pipes and devices have no size, and a file may grow.
        if size.max(bytes.len() as u64) > limit {
            return Err(Failure::unproven(name, format_args!("longer than --limit {limit}")));
        }
        Ok(Self::new(name, bytes))
    }

    /// As messages call it.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    pub(crate) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Finds out what the file holds, and checks its layout and hashes.
    pub(crate) fn open(&self) -> Result<Kind<'_>, Failure> {
        let bytes = &self.bytes;
        if bytes.starts_with(&Snapshot::MAGIC) {
            Snapshot::parse(bytes).map(Kind::Snapshot).map_err(|error| self.unproven(error))
        } else if bytes.starts_with(&Replay::MAGIC) {
            Replay::parse(bytes).map(Kind::Replay).map_err(|error| self.unproven(error))
        } else {
            self.scene().map(Kind::Scene)
        }
    }

    /// Reads the file as a scene.
    pub(crate) fn scene(&self) -> Result<Scene, Failure> {
        let Ok(text) = str::from_utf8(&self.bytes) else {
            return Err(self.unproven("offset 0: not a snapshot, a replay or the text of a scene"));
        };
        Scene::parse(text).map_err(|error| self.unproven(error))
    }

    /// This file cannot be used.
    pub(crate) fn unproven(&self, why: impl Display) -> Failure {
        Failure::unproven(&self.name, why)
    }
}

/// Whether a path stands for stdin or stdout.
pub(crate) fn is_dash(path: &Path) -> bool {
    path == Path::new("-")
}

fn name(path: &Path) -> String {
    if is_dash(path) { "stdin".into() } else { path.display().to_string() }
}
