//! Signals of the system, without handlers: they are blocked, and one thread waits for them.

/// A wish to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Signal {
    /// The terminal went away.
    #[cfg_attr(not(unix), expect(dead_code, reason = "not known there"))]
    HangUp,
    /// Ctrl-C.
    Interrupt,
    /// From `kill`, `timeout` and batch systems.
    #[cfg_attr(not(unix), expect(dead_code, reason = "not known there"))]
    Terminate,
}

impl Signal {
    /// What shells show for a process that a signal ended.
    pub(crate) fn exit_code(self) -> u8 {
        match self {
            Self::HangUp => 128 + 1,
            Self::Interrupt => 128 + 2,
            Self::Terminate => 128 + 15,
        }
    }
}

pub(crate) use system::{end_by, on_first};

#[cfg(unix)]
mod system {
    use std::{fs, process, thread};

    use nix::sys::signal::{SigSet, Signal as Number, raise};

    use super::Signal;

    const STOPPING: [(Number, Signal); 3] = [
        (Number::SIGHUP, Signal::HangUp),
        (Number::SIGINT, Signal::Interrupt),
        (Number::SIGTERM, Signal::Terminate),
    ];

    /// Runs `act` on a thread of its own when the first signal comes that asks to stop. Signals that are ignored, as
    /// `nohup` and shells do for commands in the background, stay so.
    ///
    /// Where this cannot be set up, signals end the process at once.
    pub(crate) fn on_first(act: impl FnOnce(Signal) + Send + 'static) {
        // Blocked, it does not end the process: the write that goes beyond the limit fails instead, and is reported.
        let _ = SigSet::from(Number::SIGXFSZ).thread_block();
        let ignored = ignored_signals();
        let heard = STOPPING.map(|(number, _)| number).into_iter().filter(|number| !is_in(ignored, *number));
        let heard: SigSet = heard.collect();
        // Threads that are started from here on inherit the mask, so that this one alone takes signals.
        if heard.iter().next().is_none() || heard.thread_block().is_err() {
            return;
        }
        let wait = move || {
            let signal = heard.wait().ok().and_then(known);
            if let Some(signal) = signal {
                act(signal);
            }
        };
        if thread::Builder::new().name("signals".to_owned()).spawn(wait).is_err() {
            // Signals must end the process then.
            let _ = heard.thread_unblock();
        }
    }

    /// Ends the process as the signal would have done: nothing is flushed, nothing can hang.
    pub(crate) fn end_by(signal: Signal) -> ! {
        if let Some((number, _)) = STOPPING.into_iter().find(|(_, known)| *known == signal) {
            let _ = SigSet::from(number).thread_unblock();
            let _ = raise(number);
        }
        process::abort()
    }

    fn known(number: Number) -> Option<Signal> {
        STOPPING.into_iter().find(|(known, _)| *known == number).map(|(_, signal)| signal)
    }

    /// A bit for each signal that is ignored, the lowest for number 1.
    ///
    /// Linux keeps blocked signals even if they are ignored, so it must be asked; other systems throw them away.
    fn ignored_signals() -> u64 {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0)
    }

    fn is_in(mask: u64, number: Number) -> bool {
        mask >> (number as i32 - 1) & 1 == 1
    }
}

#[cfg(not(unix))]
mod system {
    use std::process;

    use super::Signal;

    /// Runs `act` on a thread of its own at the first Ctrl-C. Where this cannot be set up, that ends the process at once.
    pub(crate) fn on_first(act: impl FnOnce(Signal) + Send + 'static) {
        let mut act = Some(act);
        let _ = ctrlc::set_handler(move || {
            if let Some(act) = act.take() {
                act(Signal::Interrupt);
            }
        });
    }

    /// Ends the process, flushing nothing.
    pub(crate) fn end_by(_: Signal) -> ! {
        process::abort()
    }
}
