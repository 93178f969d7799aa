//! stdout whose reader may leave.

use std::io::{self, ErrorKind, StdoutLock, Write};

/// stdout. Once its reader is gone, the rest is dropped without an error: the command goes on, so
/// that `verlock verify replays | head` still returns what it found.
#[derive(Debug)]
pub(crate) struct Pipe<W> {
    writer: W,
}

impl Pipe<StdoutLock<'static>> {
    pub(crate) fn stdout() -> Self {
        Self { writer: io::stdout().lock() }
    }
}

impl<W: Write> Write for Pipe<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        unless_broken(self.writer.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        unless_broken(self.writer.flush(), ())
    }
}

fn unless_broken<T>(result: io::Result<T>, done: T) -> io::Result<T> {
    match result {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(done),
        other => other,
    }
}
