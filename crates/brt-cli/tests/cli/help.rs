//! Help mentions every option that scripts rely on.

use crate::bench::Bench;

fn mentions(command: &str, options: &[&str]) {
    let help = Bench::new().done(&format!("{command} --help"));
    assert_eq!(help.errors, "");
    for option in options {
        assert!(lists(help.text(), option), "brt {command} --help lacks {option}:\n{}", help.text());
    }
}

/// Does a line, or a value in a list of values, begin with this word or these words?
fn lists(help: &str, words: &str) -> bool {
    help.lines().any(|line| {
        let line = line.trim_start();
        let rest = line.strip_prefix("- ").unwrap_or(line).strip_prefix(words);
        rest.is_some_and(|rest| rest.chars().next().is_none_or(|next| " :.[".contains(next)))
    })
}

#[test]
fn of_render() {
    mentions(
        "render",
        &[
            "<SCENE>",
            "[OUT]",
            "-o, --output",
            "-s, --size",
            "-j, --threads",
            "--method",
            "full",
            "pixel-selected",
            "border",
            "--samples",
            "--filter",
            "--max-depth",
            "--bits",
            "--compression",
            "--layers",
            "--stats",
            "--verify",
            "--max-error",
            "--pixel",
            "--linear",
            "--no-save",
            "-q, --quiet",
            "-v, --verbose",
        ],
    );
    mentions(
        "render",
        &[
            "Paper:",
            "--delta",
            "--judge",
            "--regions",
            "--history",
            "--block",
            "--icps",
            "--accelerator",
            "Limits:",
            "--max-memory",
            "--allow-expansion",
            "--max-pixels",
        ],
    );
}

/// Options for tests and measurements stand in the long help only.
#[test]
fn the_short_help_leaves_out_what_hardly_anybody_needs() {
    let help = |option: &str| Bench::new().done(&format!("render {option}")).text().to_owned();
    assert!(help("--help").contains("--simd <LEVEL>"));
    let short = help("-h");
    assert!(short.contains("--threads") && !short.contains("--simd"), "{short}");
}

#[test]
fn of_the_others() {
    mentions("compare", &["<REF>", "<TEST>", "--json", "--max-error", "--heat-map", "--max-pixels"]);
    mentions("inspect", &["<SCENE>", "--json", "--max-memory", "--allow-expansion"]);
    mentions("convert", &["<IN>", "[OUT]", "-o, --output", "-s, --size", "-q, --quiet"]);
    assert!(Bench::new().done("peers --help").text().contains("[default: 512,1024,2048]"));
    let convert = Bench::new().done("convert --help");
    assert!([".pov", ".dat"].iter().all(|name| convert.text().contains(name)), "{}", convert.text());
    mentions(
        "peers",
        &["[SCENES]", "-o, --output", "--sizes", "--repeat", "--timeout", "--plain", "--record", "--label"],
    );
    mentions("paper", &["-o, --output", "--sizes", "--repeat", "--scene", "--quick", "--max-memory"]);
    mentions("scene", &["[NAME]", "--size", "-o, --output"]);
    mentions("formats", &["Usage"]);
    mentions("", &["render", "compare", "inspect", "convert", "scene", "formats", "paper", "peers"]);
}

#[test]
fn the_default_method_is_the_one_that_promises_most() {
    let help = Bench::new().done("render --help");
    assert!(help.text().contains("[default: certified]"));
}
