//! `vibank completions SHELL` and `vibank man`

use clap::CommandFactory;
use clap_complete::Shell;

use super::{Failure, Outcome};

/// Print the completions of a shell, or the manual page.
///
/// Example: vibank completions bash > vibank.bash
#[derive(clap::Args)]
pub(crate) struct Arguments {
    /// The shell whose completions are printed.
    #[arg(required_unless_present = "man")]
    shell: Option<Shell>,
    /// Print the manual page instead.
    #[arg(long)]
    man: bool,
}

pub(crate) fn run(arguments: &Arguments) -> Result<Outcome, Failure> {
    let mut command = super::Arguments::command();
    // Both write where there is always room: one of them panics where there is none.
    let mut text = Vec::new();
    if arguments.man {
        let page = clap_mangen::Man::new(command);
        page.render(&mut text)
            .map_err(|error| Failure::new(format!("cannot write: {error}")))?;
    } else if let Some(shell) = arguments.shell {
        clap_complete::generate(shell, &mut command, "vibank", &mut text);
    }
    println!("{}", String::from_utf8_lossy(&text).trim_end());
    Ok(Outcome::Done)
}
