//! The programs that take part.

use brt::Format;
use std::process::Command;

use super::process::{Patience, RunError, run};

/// A ray tracer of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Peer {
    PovRay,
    Tachyon,
}

/// Is a peer here?
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Presence {
    /// With this version.
    Installed(String),
    Absent,
    /// It is there, but does not work.
    Broken(String),
}

impl Peer {
    pub(super) const ALL: [Self; 2] = [Self::PovRay, Self::Tachyon];

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::PovRay => "POV-Ray",
            Self::Tachyon => "Tachyon",
        }
    }

    /// The command, which is the Debian package's name, too.
    pub(super) fn command(self) -> &'static str {
        match self {
            Self::PovRay => "povray",
            Self::Tachyon => "tachyon",
        }
    }

    /// The format of its scenes.
    pub(super) fn format(self) -> Format {
        match self {
            Self::PovRay => Format::Pov,
            Self::Tachyon => Format::Dat,
        }
    }

    /// Asks it for its version.
    pub(super) fn presence(self, patience: Patience) -> Result<Presence, RunError> {
        let option = match self {
            Self::PovRay => "--version",
            Self::Tachyon => "-version",
        };
        match run(Command::new(self.command()).arg(option), patience) {
            Ok(ended) => Ok(Presence::Installed(self.version_in(&ended.said))),
            // Tachyon says its version and ends with 255.
            Err(RunError::Failed { said, .. }) if self == Self::Tachyon && !said.is_empty() => {
                Ok(Presence::Installed(self.version_in(&said)))
            }
            Err(RunError::Missing) => Ok(Presence::Absent),
            Err(RunError::Cancelled) => Err(RunError::Cancelled),
            Err(error) => Ok(Presence::Broken(error.to_string())),
        }
    }

    /// The first word with a number and a dot in a line of its own words; POV-Ray talks of files before.
    fn version_in(self, said: &str) -> String {
        let is_version = |word: &&str| word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.');
        let lines = said.lines().map(str::trim);
        let line = match self {
            Self::PovRay => lines.into_iter().find_map(|line| line.strip_prefix("POV-Ray ")),
            Self::Tachyon => lines.into_iter().find(|line| line.split_whitespace().any(|w| is_version(&w))),
        };
        line.and_then(|line| line.split_whitespace().find(is_version))
            .unwrap_or("of unknown version")
            .to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn versions_are_found_in_what_peers_say() {
        let said =
            "povray: cannot open the file /a/3.7/povray.conf\nPOV-Ray 3.7.0.10.unofficial\n\nother 1.2";
        assert_eq!(Peer::PovRay.version_in(said), "3.7.0.10.unofficial");
        assert_eq!(Peer::Tachyon.version_in("0.99\n"), "0.99");
        assert_eq!(Peer::Tachyon.version_in("hello"), "of unknown version");
    }
}
