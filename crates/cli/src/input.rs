//! A file that is given to a command.

use std::fmt::Display;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use verlock::World;
use verlock::geometry::TriangleMesh;
use verlock::replay::{HashLog, Replay, Simulation as _};
use verlock::scene::{Obj, Scene};
use verlock::snapshot::{DecodeError, DecodeReason, Snapshot};

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
    Scene(&'a str),
    /// A text that begins as OBJ files do.
    Mesh,
    /// A PNG or a GIF.
    Picture,
    /// A text, but none of these.
    Text,
    /// No text, from this offset on.
    Bytes(usize),
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
            return Err(Failure::unusable(name, format_args!("longer than --limit {limit}")));
        }
        if bytes.is_empty() {
            return Err(Failure::unusable(name, "is empty"));
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
            Looks::Snapshot => {
                let snapshot =
                    Snapshot::parse(&self.bytes).map_err(|error| self.undecoded(error))?;
                Ok(Kind::Snapshot(snapshot))
            }
            Looks::Replay => self.replay().map(Kind::Replay),
            Looks::Hashes(text) => {
                text.parse().map(Kind::Hashes).map_err(|error| self.unproven(error))
            }
            Looks::Scene(_) => self.scene().map(|scene| Kind::Scene(Box::new(scene))),
            Looks::Mesh | Looks::Picture | Looks::Text | Looks::Bytes(_) => {
                Err(self.other_kind("a snapshot, a replay, a scene or a hash log"))
            }
        }
    }

    /// Reads the file as a scene.
    pub(crate) fn scene(&self) -> Result<Scene, Failure> {
        let Looks::Scene(text) = self.look() else {
            return Err(self.other_kind("a scene"));
        };
        // Meshes lie beside the scene; those of a scene from stdin where the command runs.
        let folder = Path::new(&self.name).parent().unwrap_or(Path::new(""));
        let load = |name: &str| read_mesh(&folder.join(name));
        Scene::parse_with(text, load).map_err(|error| self.refused(error))
    }

    /// The world that a scene of this file starts with.
    pub(crate) fn world(&self, scene: &Scene) -> Result<World, Failure> {
        scene.build().map_err(|error| self.refused(error))
    }

    /// Reads the file as a replay.
    pub(crate) fn replay(&self) -> Result<Replay<'_>, Failure> {
        match self.look() {
            Looks::Replay => Replay::parse(&self.bytes).map_err(|error| self.undecoded(error)),
            _ => Err(self.other_kind("a replay")),
        }
    }

    /// Reads the file as an OBJ mesh.
    pub(crate) fn mesh(&self) -> Result<TriangleMesh, Failure> {
        let is_other = match self.look() {
            Looks::Snapshot | Looks::Replay | Looks::Picture => true,
            Looks::Hashes(text) => text.parse::<HashLog>().is_ok_and(|log| log.span().is_some()),
            Looks::Scene(text) => {
                let mut lines = text.lines().map(str::trim);
                lines.any(|line| line.starts_with('(') || line.starts_with("#!["))
            }
            Looks::Bytes(_) => self.is_utf_16(),
            Looks::Mesh | Looks::Text => false,
        };
        if is_other {
            return Err(self.other_kind("an OBJ mesh"));
        }
        let text = str::from_utf8(&self.bytes).map_err(|error| {
            self.refused(format_args!("offset {}: not UTF-8", error.valid_up_to()))
        })?;
        Ok(Obj::parse(text).map_err(|error| self.refused(error))?.into_mesh())
    }

    /// This file is of another kind than is wanted.
    pub(crate) fn other_kind(&self, wanted: &str) -> Failure {
        let found = match self.look() {
            Looks::Snapshot => "a snapshot".into(),
            Looks::Replay => "a replay".into(),
            Looks::Hashes(_) => "a hash log".into(),
            Looks::Scene(_) => "a text, as scenes are".into(),
            Looks::Mesh => "an OBJ mesh, which `reduce --render` paints".into(),
            Looks::Picture => "a picture".into(),
            Looks::Text => "a text, but neither a scene nor a hash log".into(),
            Looks::Bytes(_) if self.is_utf_16() => "UTF-16, and texts are read as UTF-8".into(),
            Looks::Bytes(offset) => format!("of no known kind, and not UTF-8 at offset {offset}"),
        };
        Failure::unusable(&self.name, format_args!("it is {found}, and {wanted} is wanted"))
    }

    /// What its first bytes say that it is.
    fn look(&self) -> Looks<'_> {
        let bytes = &self.bytes;
        if bytes.starts_with(&Snapshot::MAGIC) {
            return Looks::Snapshot;
        }
        if bytes.starts_with(&Replay::MAGIC) {
            return Looks::Replay;
        }
        if bytes.starts_with(b"\x89PNG") || bytes.starts_with(b"GIF8") {
            return Looks::Picture;
        }
        let text = match str::from_utf8(bytes) {
            Ok(text) => text.strip_prefix('\u{feff}').unwrap_or(text),
            Err(error) => return Looks::Bytes(error.valid_up_to()),
        };
        // Scenes begin neither with a number nor with a comment of this kind, but for RON's own.
        let filled = || text.lines().map(str::trim).filter(|line| !line.is_empty());
        let is_hashes = filled()
            .find(|line| !line.starts_with('#'))
            .is_none_or(|line| line.starts_with(|c: char| c.is_ascii_digit()));
        let statement = filled().find(|line| !line.starts_with('#'));
        let word = statement.and_then(|line| line.split_whitespace().next());
        if word.is_some_and(|word| STATEMENTS.contains(&word)) {
            return Looks::Mesh;
        }
        let comment = filled().next().filter(|line| line.starts_with('#'));
        match comment {
            Some(line) if line.starts_with("#![") => Looks::Scene(text),
            _ if is_hashes => Looks::Hashes(text),
            Some(_) => Looks::Text,
            None => Looks::Scene(text),
        }
    }

    /// Whether it begins with the mark of that encoding.
    fn is_utf_16(&self) -> bool {
        self.bytes.starts_with(&[0xff, 0xfe]) || self.bytes.starts_with(&[0xfe, 0xff])
    }

    /// What is in this file cannot be had, and says why.
    pub(crate) fn refused(&self, error: impl Display) -> Failure {
        Failure::unusable(&self.name, error)
    }

    /// The bytes of this file are not what they should be.
    pub(crate) fn undecoded(&self, error: DecodeError) -> Failure {
        if let DecodeReason::Simulation { .. } = error.reason {
            let name = String::from_utf8_lossy(&World::NAME);
            let name = name.trim_end_matches('\0');
            let error = error.to_string();
            let error = error.trim_end_matches(": nothing proven");
            let hint = "for others call `verlock::replay::verify::<YourGame>`";
            return self
                .unproven(format_args!("{error}; this program steps `{name}` only, {hint}"));
        }
        self.unproven(error)
    }

    /// This file cannot be used, of which a proof was wanted.
    pub(crate) fn unproven(&self, why: impl Display) -> Failure {
        Failure::unproven(&self.name, why)
    }
}

/// What an OBJ file begins with, but for comments.
const STATEMENTS: [&str; 9] = ["v", "vn", "vt", "f", "g", "o", "s", "mtllib", "usemtl"];

/// The longest mesh file that is read, in bytes.
const MESH_MAX: u64 = 256 << 20;

/// The text of a mesh file, or its name and why it cannot be had.
fn read_mesh(path: &Path) -> Result<String, String> {
    let mut text = String::new();
    let read = File::open(path).and_then(|file| file.take(MESH_MAX + 1).read_to_string(&mut text));
    match read {
        Ok(read) if read as u64 > MESH_MAX => {
            Err(format!("{}: longer than {MESH_MAX} bytes", path.display()))
        }
        Ok(_) => Ok(text),
        Err(error) => Err(format!("{}: {error}", path.display())),
    }
}

/// Whether a path stands for stdin or stdout.
pub(crate) fn is_dash(path: &Path) -> bool {
    path == Path::new("-")
}

fn name(path: &Path) -> String {
    if is_dash(path) { "stdin".into() } else { path.display().to_string() }
}
