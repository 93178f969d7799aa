//! A file that is given to a command.

use std::fmt::Display;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use verlock::replay::{HashLog, Replay};
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
    Scene(Box<Scene>),
    Hashes(HashLog),
}

/// What a file seems to be.
enum Looks<'a> {
    Snapshot,
    Replay,
    Hashes(&'a str),
    Text(&'a str),
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

    /// Reads two files, at most one of them from stdin.
    pub(crate) fn read_two(a: &Path, b: &Path, limit: u64) -> Result<[Self; 2], Failure> {
        if is_dash(a) && is_dash(b) {
            return Err(Failure::usage("only one of two files can be stdin"));
        }
        Ok([Self::read(a, limit)?, Self::read(b, limit)?])
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
        match self.look() {
            Some(Looks::Snapshot) => {
                let snapshot =
                    Snapshot::parse(&self.bytes).map_err(|error| self.unproven(error))?;
                Ok(Kind::Snapshot(snapshot))
            }
            Some(Looks::Replay) => self.replay().map(Kind::Replay),
            Some(Looks::Hashes(text)) => {
                text.parse().map(Kind::Hashes).map_err(|error| self.unproven(error))
            }
            Some(Looks::Text(_)) => self.scene().map(|scene| Kind::Scene(Box::new(scene))),
            None => Err(self.unproven("offset 0: not a snapshot, a replay or a text")),
        }
    }

    /// Reads the file as a scene.
    pub(crate) fn scene(&self) -> Result<Scene, Failure> {
        let Some(Looks::Text(text)) = self.look() else {
            return Err(self.other_kind("a scene"));
        };
        // Meshes lie beside the scene; those of a scene from stdin where the command runs.
        let folder = Path::new(&self.name).parent().unwrap_or(Path::new(""));
        let load = |name: &str| {
            let path = folder.join(name);
            read_mesh(&path).ok_or_else(|| format!("{}: cannot be read", path.display()))
        };
        Scene::parse_with(text, load).map_err(|error| self.unproven(error))
    }

    /// Reads the file as a replay.
    pub(crate) fn replay(&self) -> Result<Replay<'_>, Failure> {
        match self.look() {
            Some(Looks::Replay) | None => {
                Replay::parse(&self.bytes).map_err(|error| self.unproven(error))
            }
            _ => Err(self.other_kind("a replay")),
        }
    }

    /// This file is of another kind than is wanted.
    pub(crate) fn other_kind(&self, wanted: &str) -> Failure {
        let found = match self.look() {
            Some(Looks::Snapshot) => "a snapshot",
            Some(Looks::Replay) => "a replay",
            Some(Looks::Hashes(_)) => "a hash log",
            Some(Looks::Text(_)) => "a text, as scenes are",
            None => "of no known kind",
        };
        self.unproven(format_args!("offset 0: it is {found}, and {wanted} is wanted"))
    }

    /// What its first bytes say that it is; `None` if they say nothing.
    fn look(&self) -> Option<Looks<'_>> {
        let bytes = &self.bytes;
        if bytes.starts_with(&Snapshot::MAGIC) {
            return Some(Looks::Snapshot);
        }
        if bytes.starts_with(&Replay::MAGIC) {
            return Some(Looks::Replay);
        }
        let text = str::from_utf8(bytes).ok().filter(|text| !text.is_empty())?;
        let line = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#'));
        // No scene begins with a number, nor with a comment of this kind.
        let digit = line.is_some_and(|line| line.starts_with(|c: char| c.is_ascii_digit()));
        Some(if digit { Looks::Hashes(text) } else { Looks::Text(text) })
    }

    /// This file cannot be used.
    pub(crate) fn unproven(&self, why: impl Display) -> Failure {
        Failure::unproven(&self.name, why)
    }
}

/// The longest mesh file that is read, in bytes.
const MESH_MAX: u64 = 256 << 20;

/// The text of a mesh file; `None` if there is no such file, or it is too long or no text.
fn read_mesh(path: &Path) -> Option<String> {
    let mut text = String::new();
    let read = File::open(path).ok()?.take(MESH_MAX + 1).read_to_string(&mut text).ok()?;
    (read as u64 <= MESH_MAX).then_some(text)
}

/// Whether a path stands for stdin or stdout.
pub(crate) fn is_dash(path: &Path) -> bool {
    path == Path::new("-")
}

fn name(path: &Path) -> String {
    if is_dash(path) { "stdin".into() } else { path.display().to_string() }
}
