//! `verlock man`: manual pages.

use std::fs;
use std::io::Write;
use std::path::PathBuf;

use clap::{Command, CommandFactory as _};
use clap_mangen::Man as Page;

use crate::args::Args;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::target::Target;

/// Print the manual page, or write those of all commands into a folder
#[derive(Debug, clap::Args)]
pub(crate) struct Man {
    /// Folder for verlock.1, verlock-run.1 and so on
    #[arg(value_name = "DIR")]
    folder: Option<PathBuf>,

    /// Overwrite files
    #[arg(long)]
    force: bool,
}

impl Man {
    pub(crate) fn execute(self, out: &mut dyn Write) -> Result<Exit, Failure> {
        let mut command = Args::command();
        let Some(folder) = &self.folder else {
            out.write_all(&render(command)?)?;
            return Ok(Exit::Fine);
        };
        fs::create_dir_all(folder).map_err(|error| Failure::io(folder.display(), &error))?;
        command.build();
        let subcommands = command.get_subcommands().filter(|sub| sub.get_name() != "help");
        let names = subcommands.map(|sub| (sub.clone(), format!("verlock-{}", sub.get_name())));
        let mut pages = vec![(command.clone(), "verlock".to_owned())];
        pages.extend(names);
        let targets =
            pages.iter().map(|(_, name)| Target::new(folder.join(format!("{name}.1")), self.force));
        // All are looked at before the first is written.
        let targets = targets.collect::<Result<Vec<_>, _>>()?;
        for ((page, name), target) in pages.into_iter().zip(targets) {
            target.write(&render(page.name(name))?, out)?;
        }
        Ok(Exit::Fine)
    }
}

fn render(command: Command) -> Result<Vec<u8>, Failure> {
    let mut page = Vec::new();
    Page::new(command).render(&mut page)?;
    Ok(page)
}
