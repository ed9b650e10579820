//! Broken and hostile bytes: never a panic, never a hang.

mod common;

use std::time::{Duration, Instant};

use brt_formats::{Format, Limits, ParseError, parse};
use common::{EVERYTHING, NFF};

const FILES: [(Format, &str); 2] = [(Format::Toml, EVERYTHING), (Format::Nff, NFF)];

/// Whatever the bytes are, a scene that is returned is good, and an error says something.
fn survives(format: Format, bytes: &[u8]) {
    match parse(format, bytes, &Limits::default()) {
        Ok((scene, report)) => {
            assert_eq!(scene.check(), []);
            assert!(!report.has_errors());
        }
        Err(ParseError::Malformed(report)) => {
            assert!(report.has_errors());
            for span in report.diagnostics.iter().filter_map(|d| d.span.clone()) {
                assert!(span.start <= span.end && span.end <= bytes.len(), "{span:?} of {}", bytes.len());
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
}

#[test]
fn every_beginning_of_a_file() {
    for (format, text) in FILES {
        for end in 0..text.len() {
            survives(format, &text.as_bytes()[..end]);
        }
    }
}

#[test]
fn two_thousand_mutations() {
    for (format, text) in FILES {
        let mut random = Random(0x9E37_79B9_7F4A_7C15);
        for _ in 0..2000 {
            let mut bytes = text.as_bytes().to_vec();
            for _ in 0..=random.below(3) {
                mutate(&mut bytes, &mut random);
            }
            survives(format, &bytes);
        }
    }
}

#[test]
fn the_wrong_reader() {
    survives(Format::Nff, EVERYTHING.as_bytes());
    survives(Format::Toml, NFF.as_bytes());
    for format in Format::ALL {
        for bytes in [&b""[..], &[0; 1000], &[0xFF; 1000], b"\xef\xbb\xbf", b"\n\n\n", b"#", b"\r"] {
            survives(format, bytes);
        }
    }
}

#[test]
fn deep_nesting_is_an_error_and_no_overflow_of_the_stack() {
    const DEEP: usize = 100_000;
    for (open, close) in [("[", "]"), ("{a=", "}"), ("[{a=", "}]"), ("a.", ""), ("[[", "]]")] {
        for text in [
            format!("a = {}", open.repeat(DEEP)),
            format!("a = {}1{}", open.repeat(DEEP), close.repeat(DEEP)),
            format!("[{}b]\n", open.repeat(DEEP)),
            format!("{}b = 1\n", open.repeat(DEEP)),
        ] {
            let parsed = parse(Format::Toml, text.as_bytes(), &Limits::default());
            assert!(matches!(parsed, Err(ParseError::Malformed(_))));
        }
    }
}

#[test]
fn large_nonsense_is_read_in_time() {
    const COUNT: usize = 100_000;
    let camera = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov_deg = 45\n";
    let keys = |line: &dyn Fn(usize) -> String| (0..COUNT).map(line).collect::<String>();
    let texts = [
        format!("background = [{}0]\n{camera}", "0,".repeat(20 * COUNT)),
        format!("a = \"{}\"", "x".repeat(100 * COUNT)),
        keys(&|i| format!("key{i} = {i}\n")),
        keys(&|i| format!("[materials.m{i}]\nsize = 1\n")),
        keys(&|i| format!("[materials.m{i}.checker.a.b]\nsize = 1\n")),
        format!("{camera}{}", "[[object]]\ntype = \"sphere\"\nmaterial = \"m\"\n".repeat(COUNT)),
        format!("{camera}[[object]]\n{}", keys(&|i| format!("k{i} = 1\n"))),
        "?\n".repeat(COUNT),
        "s 0 0 0 x ".repeat(COUNT),
        "tess ".repeat(COUNT),
        "1 ".repeat(COUNT),
        format!("p {COUNT}\n{}", "0 1 2 ".repeat(COUNT)),
        format!("p {COUNT}\n{}", keys(&|i| format!("{} {} {}\n", i % 317, i % 211, i % 97))),
        format!("pp {COUNT}\n{}", keys(&|i| format!("{} {} {} 0 0 1\n", i % 317, i % 211, i % 97))),
        keys(&|i| format!("f {i} 0 0 1 0 1 0 1\ns 0 0 0 1\n")),
    ];
    for text in &texts {
        for format in Format::ALL {
            let start = Instant::now();
            survives(format, text.as_bytes());
            let took = start.elapsed();
            // Generous for slow machines; what it guards against takes hours.
            assert!(took < Duration::from_secs(20), "{took:?} for {format:?}: {}", &text[..60]);
        }
    }
}

/// xorshift64 (Marsaglia 2003): the same bytes on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % end.max(1) as u64) as usize
    }
}

fn mutate(bytes: &mut Vec<u8>, random: &mut Random) {
    let at = random.below(bytes.len());
    match random.below(5) {
        0 => bytes.iter_mut().skip(at).take(1).for_each(|b| *b ^= 1 << random.below(8)),
        1 => bytes.insert(at, random.below(256) as u8),
        2 => drop(bytes.drain(at..(at + 1 + random.below(20)).min(bytes.len()))),
        3 => {
            let end = (at + 1 + random.below(80)).min(bytes.len());
            let piece = bytes[at..end].to_vec();
            let target = random.below(bytes.len());
            bytes.splice(target..target, piece);
        }
        _ => replace_number(bytes, at, random),
    }
}

/// Replaces the first number from `at` on.
fn replace_number(bytes: &mut Vec<u8>, at: usize, random: &mut Random) {
    const NUMBERS: [&str; 14] = [
        "1e400",
        "1e308",
        "-1e308",
        "1e31",
        "1e-320",
        "nan",
        "inf",
        "-1",
        "0",
        "-0.0",
        "",
        "4294967295",
        "99999999999999999999",
        "0.5",
    ];
    let Some(start) = (at..bytes.len()).find(|&i| bytes[i].is_ascii_digit()) else { return };
    let length = bytes[start..].iter().take_while(|b| b.is_ascii_digit() || **b == b'.').count();
    let number = NUMBERS[random.below(NUMBERS.len())];
    bytes.splice(start..start + length, number.bytes());
}
