//! A folder of its own for every test, and the command running in it.

use std::fs;
use std::io::Write as _;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use serde_json::Value;

/// Two particles at a rope, one of them pushed in tick 3.
pub(crate) const SCENE: &str = "(
    version: 1,
    ticks: 6,
    particles: [(pinned: true), (position: (1, 0, 0))],
    distances: [(a: 0, b: 1)],
    timeline: [
        (tick: 3, action: Impulse(particle: 1, impulse: (0, 0, 1))),
        (tick: 4, action: Impulse(particle: 9, impulse: (0, 0, 1))),
    ],
)";

pub(crate) struct Sandbox {
    folder: PathBuf,
}

/// What the command returned and wrote.
#[derive(Debug)]
pub(crate) struct Outcome {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: Vec<u8>,
    pub(crate) stderr: String,
}

impl Sandbox {
    /// An empty folder with the scene `a.ron`.
    pub(crate) fn new(name: &str) -> Self {
        let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder for the test");
        let sandbox = Self { folder };
        sandbox.write("a.ron", SCENE.as_bytes());
        sandbox
    }

    /// A sandbox with the recording `a.replay` and the snapshot `a.snap` of its end.
    pub(crate) fn recorded(name: &str) -> Self {
        let sandbox = Self::new(name);
        let files = ["--record", "a.replay", "--keyframes", "2", "--save", "a.snap"];
        sandbox.run(&[&["run", "a.ron"], &files[..]].concat()).expect(0);
        sandbox
    }

    pub(crate) fn path(&self, file: &str) -> PathBuf {
        self.folder.join(file)
    }

    pub(crate) fn write(&self, file: &str, bytes: &[u8]) {
        let path = self.path(file);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("a file to write");
    }

    pub(crate) fn read(&self, file: &str) -> Vec<u8> {
        fs::read(self.path(file)).expect("a file to read")
    }

    pub(crate) fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_verlock"));
        command.args(args).current_dir(&self.folder);
        command
    }

    pub(crate) fn run(&self, args: &[&str]) -> Outcome {
        self.run_with(args, &[])
    }

    /// Runs the command with these bytes on stdin.
    pub(crate) fn run_with(&self, args: &[&str], stdin: &[u8]) -> Outcome {
        let mut command = self.command(args);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = command.spawn().expect("the command to start");
        // A command that does not read it closes the pipe.
        let _ = child.stdin.take().expect("a pipe").write_all(stdin);
        let output = child.wait_with_output().expect("the command to end");
        let stderr = String::from_utf8(output.stderr).expect("UTF-8");
        Outcome { code: output.status.code(), stdout: output.stdout, stderr }
    }
}

impl Outcome {
    /// Checks the exit code.
    pub(crate) fn expect(self, code: i32) -> Self {
        assert_eq!(self.code, Some(code), "{self:?}\n{}", self.text());
        self
    }

    /// Checks that a message for people says this.
    pub(crate) fn says(self, text: &str) -> Self {
        let named = self.stderr.starts_with("verlock: ");
        assert!(named && self.stderr.contains(text), "{text:?} is not in {}", self.stderr);
        self
    }

    pub(crate) fn text(&self) -> &str {
        str::from_utf8(&self.stdout).unwrap_or("not UTF-8")
    }

    pub(crate) fn json(&self) -> Value {
        serde_json::from_slice(&self.stdout).expect("JSON")
    }
}
