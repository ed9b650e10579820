//! Runs a program, measures its processor time, and never waits for ever.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use thiserror::Error;
use wait_timeout::ChildExt;

/// How often a wish to stop is looked for.
const SLICE: Duration = Duration::from_millis(100);
/// How much of what a program said is kept, from its end.
const KEPT_BYTES: u64 = 4000;

/// How long a run may take.
#[derive(Clone, Copy)]
pub(super) struct Patience<'a> {
    pub(super) timeout: Duration,
    pub(super) cancel: Option<&'a AtomicBool>,
}

/// A run that ended well.
#[derive(Debug)]
pub(super) struct Ended {
    /// Processor time in user mode, of the program and all that it started; by the clock where the system does not say.
    pub(super) user_seconds: f64,
    /// The end of what it said.
    pub(super) said: String,
}

/// A run that did not.
#[derive(Debug, Error)]
pub(super) enum RunError {
    #[error("was not found")]
    Missing,
    #[error("did not end within {0:?} and was stopped")]
    TimedOut(Duration),
    #[error("failed ({status}): {said}")]
    Failed { status: ExitStatus, said: String },
    #[error("stopped")]
    Cancelled,
    #[error("cannot be run: {0}")]
    Io(io::Error),
}

impl From<io::Error> for RunError {
    fn from(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::NotFound { Self::Missing } else { Self::Io(error) }
    }
}

/// Runs a program to its end. Runs must not overlap: processor time is known for all children together.
pub(super) fn run(command: &mut Command, patience: Patience) -> Result<Ended, RunError> {
    let mut said = tempfile::tempfile()?;
    command.stdin(Stdio::null()).stdout(said.try_clone()?).stderr(said.try_clone()?);
    own_group(command);
    let (clock, before) = (Instant::now(), user_seconds_of_children());
    let mut child = command.spawn()?;
    let status = match wait(&mut child, patience) {
        Ok(status) => status,
        Err(error) => {
            stop(&mut child);
            return Err(error);
        }
    };
    let after = user_seconds_of_children();
    let user_seconds = before.zip(after).map_or(clock.elapsed().as_secs_f64(), |(b, a)| a - b);
    let said = tail(&mut said).unwrap_or_default();
    if status.success() { Ok(Ended { user_seconds, said }) } else { Err(RunError::Failed { status, said }) }
}

fn wait(child: &mut Child, patience: Patience) -> Result<ExitStatus, RunError> {
    let begin = Instant::now();
    loop {
        let left = patience.timeout.saturating_sub(begin.elapsed());
        if let Some(status) = child.wait_timeout(left.min(SLICE))? {
            return Ok(status);
        }
        if patience.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return Err(RunError::Cancelled);
        }
        if left.is_zero() {
            return Err(RunError::TimedOut(patience.timeout));
        }
    }
}

fn tail(file: &mut File) -> io::Result<String> {
    let length = file.seek(SeekFrom::End(0))?;
    file.seek(SeekFrom::Start(length.saturating_sub(KEPT_BYTES)))?;
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    Ok(String::from_utf8_lossy(&bytes).trim().to_owned())
}

/// A program may be a script that starts others: a group of its own lets all of them be stopped.
#[cfg(unix)]
fn own_group(command: &mut Command) {
    use std::os::unix::process::CommandExt;
    command.process_group(0);
}

#[cfg(not(unix))]
fn own_group(_: &mut Command) {}

fn stop(child: &mut Child) {
    #[cfg(unix)]
    if let Ok(group) = i32::try_from(child.id()) {
        use nix::sys::signal::{Signal, killpg};
        // What has ended in the meantime needs no stopping.
        let _ = killpg(nix::unistd::Pid::from_raw(group), Signal::SIGKILL);
    }
    let _ = child.kill();
    let _ = child.wait();
}

#[cfg(unix)]
fn user_seconds_of_children() -> Option<f64> {
    use nix::sys::resource::{UsageWho, getrusage};
    let time = getrusage(UsageWho::RUSAGE_CHILDREN).ok()?.user_time();
    Some(time.tv_sec() as f64 + 1e-6 * time.tv_usec() as f64)
}

#[cfg(not(unix))]
fn user_seconds_of_children() -> Option<f64> {
    None
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    fn patience(milliseconds: u64) -> Patience<'static> {
        Patience { timeout: Duration::from_millis(milliseconds), cancel: None }
    }

    fn shell(script: &str) -> Command {
        let mut command = Command::new("/bin/sh");
        command.args(["-c", script]);
        command
    }

    #[test]
    fn what_a_program_says_and_how_it_ends_is_known() {
        assert_eq!(run(&mut shell("echo a; echo b >&2"), patience(20_000)).unwrap().said, "a\nb");
        let error = run(&mut shell("echo no such scene; exit 3"), patience(20_000)).unwrap_err();
        assert!(error.to_string().contains("no such scene"), "{error}");
        let absent = run(&mut Command::new("brt-no-such-program"), patience(20_000));
        assert!(matches!(absent, Err(RunError::Missing)));
    }

    #[test]
    fn nothing_hangs_and_nothing_is_left_running() {
        let begin = Instant::now();
        let error = run(&mut shell("sleep 600 & sleep 600"), patience(150)).unwrap_err();
        assert!(matches!(error, RunError::TimedOut(_)));
        let cancel = AtomicBool::new(true);
        let patience = Patience { timeout: Duration::from_secs(600), cancel: Some(&cancel) };
        assert!(matches!(run(&mut shell("sleep 600"), patience), Err(RunError::Cancelled)));
        assert!(begin.elapsed() < Duration::from_secs(60));
    }
}
