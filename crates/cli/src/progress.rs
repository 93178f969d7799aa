//! How far a long command is.

use std::io::{IsTerminal as _, stderr};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar on stderr, if that is a terminal; it goes when this does.
#[derive(Debug)]
pub(crate) struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// A bar for so many `units`, such as ticks.
    pub(crate) fn new(name: &str, count: u64, units: &str) -> Self {
        let shown = stderr().is_terminal();
        let target =
            if shown { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let style = format!("{{msg}} {{wide_bar}} {{pos}}/{{len}} {units}, {{eta}} left");
        let style = ProgressStyle::with_template(&style);
        let bar = ProgressBar::with_draw_target(Some(count), target).with_message(name.to_owned());
        Self { bar: bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())) }
    }

    /// One of them is done.
    pub(crate) fn step(&self) {
        self.bar.inc(1);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}
