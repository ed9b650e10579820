//! Broken scene files: whatever they hold, the command ends by itself, in time, with a message.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};

/// No variant may take longer.
const TIME_LIMIT: Duration = Duration::from_secs(10);

pub(crate) fn run(count: u32, brt: &Path, files: &[PathBuf]) -> Result<()> {
    let folder = std::env::temp_dir().join(format!("brt-mutate-{}", std::process::id()));
    fs::create_dir_all(&folder)?;
    let mut random = Random(0x5eed);
    let (mut ended, mut slowest) = ([0_u32; 2], Duration::ZERO);
    for number in 0..count {
        let source = &files[number as usize % files.len()];
        let bytes = fs::read(source).with_context(|| format!("cannot read {}", source.display()))?;
        let extension = source.extension().and_then(|e| e.to_str()).unwrap_or("toml");
        let variant = folder.join(format!("variant.{extension}"));
        fs::write(&variant, mutate(bytes, &mut random))?;
        let begin = Instant::now();
        let code = exit_code(brt, &variant)?;
        slowest = slowest.max(begin.elapsed());
        let kept = format!("kept as {}", variant.display());
        let code =
            code.with_context(|| format!("variant {number} of {} took too long, {kept}", source.display()))?;
        ensure!(code == 0 || code == 1, "variant {number} of {} ended with {code}, {kept}", source.display());
        ended[code as usize] += 1;
    }
    fs::remove_dir_all(&folder)?;
    println!(
        "{count} variants: {} rendered, {} refused, none crashed or hung; slowest {:.1} s",
        ended[0],
        ended[1],
        slowest.as_secs_f64()
    );
    Ok(())
}

/// `None` if it had to be killed; −1 if a signal ended it.
fn exit_code(brt: &Path, scene: &Path) -> Result<Option<i32>> {
    let arguments = ["-s", "16x16", "--samples", "1", "--method", "full", "--no-save", "-j", "1"];
    let mut child = Command::new(brt)
        .arg("render")
        .arg(scene)
        .args(arguments)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .with_context(|| format!("cannot run {}; build it with `cargo build --release`", brt.display()))?;
    let begin = Instant::now();
    while begin.elapsed() < TIME_LIMIT {
        if let Some(status) = child.try_wait()? {
            return Ok(Some(status.code().unwrap_or(-1)));
        }
        sleep(Duration::from_millis(1));
    }
    child.kill()?;
    child.wait()?;
    Ok(None)
}

/// One to four changes at random places.
fn mutate(mut bytes: Vec<u8>, random: &mut Random) -> Vec<u8> {
    const WORDS: [&str; 12] = [
        "nan",
        "inf",
        "-inf",
        "1e999",
        "-1",
        "0",
        "99999999999999999999",
        "\"",
        "[[",
        "1e-320",
        "\u{0}",
        "é",
    ];
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(12)).min(bytes.len());
        match random.below(5) {
            0 => drop(bytes.drain(at..end)),
            1 => drop(bytes.splice(at..end, WORDS[random.below(WORDS.len())].bytes())),
            2 => {
                let copy = bytes[at..end].to_vec();
                drop(bytes.splice(at..at, copy));
            }
            3 => bytes[at..end].iter_mut().for_each(|b| *b = b.wrapping_add(1)),
            _ if random.below(10) == 0 => bytes.truncate(at),
            _ => replace_number(&mut bytes, at, WORDS[random.below(6)]),
        }
    }
    bytes
}

/// Replaces the next number from `at` on.
fn replace_number(bytes: &mut Vec<u8>, at: usize, word: &str) {
    let is_digit = |b: &u8| b.is_ascii_digit() || *b == b'.';
    if let Some(start) = bytes[at..].iter().position(is_digit).map(|p| at + p) {
        let length = bytes[start..].iter().take_while(|b| is_digit(b)).count();
        drop(bytes.splice(start..start + length, word.bytes()));
    }
}

/// SplitMix64: the same variants on every machine.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ z >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ z >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ z >> 31) % bound.max(1) as u64) as usize
    }
}
