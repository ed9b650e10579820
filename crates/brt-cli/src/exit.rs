//! How the command ends: exit codes and the last words.

use std::error::Error;
use std::io;
use std::process::ExitCode;

use crate::interrupt::Interrupt;
use crate::{habits, output};

/// The command did what was asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outcome {
    /// And nothing is to be said.
    Done,
    /// But a measured error is over the stated limit.
    OverLimit,
}

/// The command did not do what was asked.
#[derive(Debug)]
pub(crate) enum Failure {
    /// The command line cannot be understood.
    CommandLine(clap::Error),
    /// It asks for what makes no sense.
    WrongUse(String),
    /// A file, the machine or a limit stands against it.
    CouldNot {
        /// What it is.
        error: anyhow::Error,
        /// What may help.
        hint: Option<String>,
    },
    /// The same, and all has been said.
    Reported,
    /// A signal stopped it.
    Interrupted,
    /// The reader of its output went away: nobody misses the rest.
    Unread,
}

impl<E: Into<anyhow::Error>> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::CouldNot { error: error.into(), hint: None }
    }
}

/// A failure by wrong use.
pub(crate) fn wrong_use(message: impl Into<String>) -> Failure {
    Failure::WrongUse(message.into())
}

/// Runs the command and says how it ended.
pub(crate) fn run(interrupt: &Interrupt, command: impl FnOnce() -> Result<Outcome, Failure>) -> ExitCode {
    let code = match (command(), interrupt.exit_code()) {
        (Ok(Outcome::Done), _) => 0,
        (Ok(Outcome::OverLimit), _) => 3,
        // Whatever went wrong did so because everything was given up.
        (Err(_), Some(code)) => {
            interrupt.tell();
            code
        }
        (Err(failure), None) => {
            report(&failure);
            failure.code()
        }
    };
    ExitCode::from(code)
}

impl Failure {
    /// Why something could not be written. A reader that went away is no error.
    pub(crate) fn of_writing(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::Unread,
            _ => error.into(),
        }
    }

    fn code(&self) -> u8 {
        match self {
            Self::Unread => 0,
            Self::CouldNot { .. } | Self::Reported | Self::Interrupted => 1,
            Self::CommandLine(_) | Self::WrongUse(_) => 2,
        }
    }
}

fn report(failure: &Failure) {
    match failure {
        Failure::CommandLine(error) => {
            // There is nobody to tell that it cannot be told.
            let _ = error.print();
        }
        Failure::WrongUse(message) => output::error(message),
        Failure::CouldNot { error, hint } => {
            output::error(&with_causes(error.as_ref()));
            if let Some(hint) = hint {
                output::hint(hint);
            }
        }
        Failure::Interrupted | Failure::Reported | Failure::Unread => {}
    }
    if failure.code() == 2
        && let Some(hint) = habits::hint(std::env::args_os().skip(1))
    {
        output::hint(&hint);
    }
}

/// The message and its causes, those left out that the message tells already.
fn with_causes(error: &(dyn Error + 'static)) -> String {
    let mut message = error.to_string();
    let mut cause = error.source();
    while let Some(error) = cause {
        let text = error.to_string();
        if !message.contains(&text) {
            message = format!("{message}: {text}");
        }
        cause = error.source();
    }
    message
}
