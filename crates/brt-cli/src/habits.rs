//! Hints for those who come from other ray tracers.

use std::ffi::OsString;
use std::path::Path;

/// Our subcommands.
const COMMANDS: [&str; 11] = [
    "render",
    "compare",
    "inspect",
    "convert",
    "scene",
    "formats",
    "paper",
    "peers",
    "completions",
    "man",
    "help",
];

/// What options of POV-Ray, Tachyon and others are called here: beginnings of words, and whether the whole word must
/// be the same.
const OPTIONS: &[(&str, Match, &str)] = &[
    ("+W", Match::Number, "the size is `--size WIDTHxHEIGHT` here"),
    ("+H", Match::Number, "the size is `--size WIDTHxHEIGHT` here"),
    ("+A", Match::Number, "`--samples 1|4|16|64` smooths edges here"),
    ("+R", Match::Number, "`--samples 1|4|16|64` smooths edges here"),
    ("+WT", Match::Number, "the number of threads is `--threads N` here"),
    ("+Q", Match::Number, "there is one quality here: pictures are always complete"),
    ("+MV", Match::Number, "options are listed by `brt render --help`"),
    ("+I", Match::Beginning, "the scene stands alone here: `brt render SCENE`"),
    ("+O", Match::Beginning, "the picture is `--output OUT` here"),
    ("+", Match::Beginning, "options begin with `-` here, see `brt render --help`"),
    ("-res", Match::Whole, "the size is `--size WIDTHxHEIGHT` here"),
    ("--resolution", Match::Whole, "the size is `--size WIDTHxHEIGHT` here"),
    ("--imgsize", Match::Beginning, "the size is `--size WIDTHxHEIGHT` here"),
    ("--width", Match::Whole, "the size is `--size WIDTHxHEIGHT` here"),
    ("--height", Match::Whole, "the size is `--size WIDTHxHEIGHT` here"),
    ("-aasamples", Match::Whole, "samples per pixel are `--samples 1|4|16|64` here"),
    ("--antialias", Match::Beginning, "samples per pixel are `--samples 1|4|16|64` here"),
    ("-numthreads", Match::Whole, "the number of threads is `--threads N` here"),
    ("-nosave", Match::Whole, "it is `--no-save` here"),
    ("-format", Match::Whole, "the output's extension names the format here: `-o out.png`"),
    ("-maxdepth", Match::Whole, "it is `--max-depth N` here"),
    ("-fullshade", Match::Whole, "pictures are always shaded fully here"),
    ("--spp", Match::Beginning, "samples per pixel are `--samples 1|4|16|64` here"),
];

/// How much of a word must be the same.
#[derive(Clone, Copy, PartialEq)]
enum Match {
    Whole,
    Beginning,
    /// The beginning, and then a digit, a point or nothing.
    Number,
}

/// A hint for a command line that went wrong, if it looks like somebody's habit.
pub(crate) fn hint(args: impl Iterator<Item = OsString>) -> Option<String> {
    let args: Vec<String> = args.map(|arg| arg.to_string_lossy().into_owned()).collect();
    forgotten_command(args.first()?)
        .or_else(|| split_verify(&args))
        .or_else(|| args.iter().find_map(|arg| foreign_option(arg)))
}

/// `--verify rows`
fn split_verify(args: &[String]) -> Option<String> {
    let which = args.windows(2).find(|pair| pair[0] == "--verify").map(|pair| pair[1].as_str());
    which
        .filter(|which| ["rows", "all"].contains(which))
        .map(|which| format!("did you mean `--verify={which}`?"))
}

/// `brt part.stl`
fn forgotten_command(first: &str) -> Option<String> {
    let path = Path::new(first);
    let is_file = !first.starts_with(['-', '+']) && (path.extension().is_some() || path.is_file());
    (is_file && !COMMANDS.contains(&first)).then(|| format!("did you mean `brt render {first}`?"))
}

fn foreign_option(arg: &str) -> Option<String> {
    let fits = |&&(name, how, _): &&(&str, Match, &str)| match (arg.strip_prefix(name), how) {
        (Some(rest), Match::Whole) => rest.is_empty(),
        (Some(_), Match::Beginning) => true,
        (Some(rest), Match::Number) => {
            rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') || rest.is_empty()
        }
        (None, _) => false,
    };
    OPTIONS.iter().find(fits).map(|(_, _, text)| (*text).to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn hint_for(line: &str) -> Option<String> {
        hint(line.split(' ').map(OsString::from))
    }

    #[test]
    fn habits_are_recognised() {
        for (line, part) in [
            ("render a.toml +W800 +H600", "--size"),
            ("render a.toml -res 800 600", "--size"),
            ("render a.toml -aasamples 12", "--samples"),
            ("render a.toml +A0.3", "--samples"),
            ("render a.toml +WT4", "--threads"),
            ("render a.toml --verify rows", "did you mean `--verify=rows`?"),
            ("part.stl", "did you mean `brt render part.stl`?"),
        ] {
            assert!(hint_for(line).is_some_and(|hint| hint.contains(part)), "{line}");
        }
    }

    #[test]
    fn our_own_options_get_no_hint() {
        for line in ["render a.toml --size 1x1", "render a.toml -o b.png", "compare a.png b.png --json"] {
            assert_eq!(hint_for(line), None, "{line}");
        }
    }
}
