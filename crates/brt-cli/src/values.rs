//! Values on the command line.

use std::ffi::OsStr;

use brt::framing::{Up, View};
use brt::{BitDepth, Format, PictureLayer, Rgb, Samples, SimdLevel, Transfer, rgb};
use bytesize::ByteSize;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Arg, Command};

/// `WIDTHxHEIGHT` in pixels.
pub(crate) fn size(text: &str) -> Result<[u32; 2], String> {
    let expected = || "expected WIDTHxHEIGHT in pixels, such as 1920x1080".to_owned();
    let (width, height) = text.split_once(['x', 'X', '×']).ok_or_else(expected)?;
    let side = |text: &str| text.parse::<u32>().ok().filter(|&n| n > 0).ok_or_else(expected);
    Ok([side(width)?, side(height)?])
}

/// `X,Y` of a pixel.
pub(crate) fn pixel(text: &str) -> Result<[u32; 2], String> {
    let expected = || "expected X,Y counted from 0 at the left and the top, such as 10,20".to_owned();
    let (x, y) = text.split_once(',').ok_or_else(expected)?;
    let coordinate = |text: &str| text.trim().parse::<u32>().map_err(|_| expected());
    Ok([coordinate(x)?, coordinate(y)?])
}

/// A view by its name or its angles.
pub(crate) fn view(text: &str) -> Result<View, String> {
    if let Some((_, view)) = View::NAMED.into_iter().find(|(name, _)| *name == text) {
        return Ok(view);
    }
    let degrees = |text: &str| text.trim().parse::<f64>().ok().filter(|n| n.is_finite());
    let angles = text.split_once(',').and_then(|(a, e)| Some((degrees(a)?, degrees(e)?)));
    match angles {
        Some((azimuth_deg, elevation_deg)) if elevation_deg.abs() <= 90.0 => {
            Ok(View::Angles { azimuth_deg, elevation_deg })
        }
        _ => {
            let names: Vec<&str> = View::NAMED.iter().map(|(name, _)| *name).collect();
            Err(format!("expected {} or AZIMUTH,ELEVATION in degrees, such as -30,20", names.join(", ")))
        }
    }
}

/// A signed axis.
pub(crate) fn up(text: &str) -> Result<Up, String> {
    let name = text.to_ascii_lowercase();
    let named = |(known, _): &(&str, Up)| *known == name || known.strip_prefix('+') == Some(&name);
    let found = Up::ALL.into_iter().find(named);
    found.map(|(_, up)| up).ok_or_else(|| "expected one of +x, -x, +y, -y, +z, -z".to_owned())
}

/// A size in bytes, with a unit or without.
pub(crate) fn bytes(text: &str) -> Result<u64, String> {
    let expected = |_| "expected a size such as 512MiB, 2GB or 1073741824 (bytes)".to_owned();
    text.parse::<ByteSize>().map(|size| size.as_u64()).map_err(expected)
}

/// How many.
pub(crate) fn count(text: &str) -> Result<u64, String> {
    text.parse().map_err(|_| "expected a whole number, at least 0".to_owned())
}

/// A finite number above 0.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|n| n.is_finite() && *n > 0.0);
    number.ok_or_else(|| "expected a number above 0".to_owned())
}

/// An sRGB colour as linear light.
pub(crate) fn color(text: &str) -> Result<Rgb, String> {
    const NAMES: [(&str, u32); 12] = [
        ("black", 0x00_0000),
        ("white", 0xff_ffff),
        ("grey", 0x80_8080),
        ("gray", 0x80_8080),
        ("silver", 0xc0_c0c0),
        ("red", 0xd0_3030),
        ("orange", 0xe0_8020),
        ("yellow", 0xe8_d040),
        ("green", 0x40_a040),
        ("blue", 0x30_60c0),
        ("purple", 0x80_40a0),
        ("brown", 0x80_5030),
    ];
    let by_name = NAMES.iter().find(|(name, _)| *name == text).map(|(_, code)| *code);
    let digits = text.strip_prefix('#').filter(|d| d.len() == 6 && d.bytes().all(|b| b.is_ascii_hexdigit()));
    let code = by_name.or_else(|| u32::from_str_radix(digits?, 16).ok());
    let code = code.ok_or_else(|| {
        let names: Vec<&str> = NAMES.iter().map(|(name, _)| *name).collect();
        format!("expected #rrggbb or one of {}", names.join(", "))
    })?;
    let channel = |shift: u32| Transfer::Srgb.decode(f64::from(code >> shift & 255) / 255.0);
    Ok(rgb(channel(16), channel(8), channel(0)))
}

/// What is behind everything.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Background {
    /// This colour, also in mirrors.
    Color(Rgb),
    /// Nothing.
    Transparent,
}

/// A colour, or `transparent`.
pub(crate) fn background(text: &str) -> Result<Background, String> {
    if text == "transparent" {
        return Ok(Background::Transparent);
    }
    color(text).map(Background::Color).map_err(|expected| format!("{expected}, or transparent"))
}

/// Values that help lists and errors name, all of them: one that is spelled alike may be far off.
#[derive(Clone)]
struct Listed<T> {
    parse: fn(&str) -> Result<T, String>,
    values: fn() -> Vec<PossibleValue>,
}

impl<T: Clone + Send + Sync + 'static> TypedValueParser for Listed<T> {
    type Value = T;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<T, clap::Error> {
        TypedValueParser::parse_ref(&self.parse, command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new((self.values)().into_iter()))
    }
}

/// Extensions of all formats that are read.
fn readable() -> impl Iterator<Item = (&'static str, Format)> {
    let formats = Format::ALL.into_iter().filter(|format| format.reads());
    formats.flat_map(|format| format.extensions().iter().map(move |name| (*name, format)))
}

/// A scene format by one of its extensions.
pub(crate) fn input_format() -> impl TypedValueParser<Value = Format> {
    let parse = |text: &str| {
        let found = readable().find(|(name, _)| *name == text);
        let names = || readable().map(|(name, _)| name).collect::<Vec<_>>().join(", ");
        found.map(|(_, format)| format).ok_or_else(|| format!("expected one of {}", names()))
    };
    let values = || readable().map(|(name, format)| PossibleValue::new(name).help(format.name())).collect();
    Listed { parse, values }
}

/// A finite number, at least 0.
pub(crate) fn not_negative(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|n| n.is_finite() && *n >= 0.0);
    number.ok_or_else(|| "expected a number, at least 0".to_owned())
}

/// Samples per pixel.
pub(crate) fn samples() -> impl TypedValueParser<Value = Samples> {
    let parse = |text: &str| {
        let named = |s: &Samples| s.per_pixel().to_string() == text;
        Samples::ALL.into_iter().find(named).ok_or_else(|| "expected 1, 4, 16, 64 or 256".to_owned())
    };
    let values = || ["1", "4", "16", "64", "256"].map(PossibleValue::new).into();
    Listed { parse, values }
}

/// Vector instructions by their name.
pub(crate) fn simd_level() -> impl TypedValueParser<Value = SimdLevel> {
    let summary = |level| match level {
        SimdLevel::Widest => "The widest that the machine has",
        SimdLevel::Avx2 => "AVX2, else the next lower ones",
        SimdLevel::Baseline => "Those that every machine of its kind has",
    };
    let names = SimdLevel::ALL.map(|level| PossibleValue::new(level.name()).help(summary(level)));
    PossibleValuesParser::new(names).try_map(|name| name.parse::<SimdLevel>())
}

/// Bits of a channel.
pub(crate) fn bits() -> impl TypedValueParser<Value = BitDepth> {
    PossibleValuesParser::new(["8", "16"])
        .map(|text| if text == "16" { BitDepth::Sixteen } else { BitDepth::Eight })
}

/// A layer by its name.
pub(crate) fn layer() -> impl TypedValueParser<Value = PictureLayer> {
    let names = PictureLayer::ALL.map(|layer| PossibleValue::new(layer.name()).help(layer.summary()));
    PossibleValuesParser::new(names).try_map(|name| PictureLayer::from_name(&name).ok_or("no such layer"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_two_positive_numbers() {
        assert_eq!(size("64x48"), Ok([64, 48]));
        assert_eq!(size("64×48"), Ok([64, 48]));
        for text in ["64", "64x", "x64", "0x64", "64x-1", "64x64x64", "99999999999x1", ""] {
            assert!(size(text).is_err(), "{text}");
        }
    }

    #[test]
    fn pixels_count_from_zero() {
        assert_eq!(pixel("0,17"), Ok([0, 17]));
        assert!(pixel("1").is_err());
        assert!(pixel("-1,2").is_err());
    }

    #[test]
    fn views_have_names_or_angles() {
        assert_eq!(view("top"), Ok(View::Top));
        assert_eq!(view("-30,20"), Ok(View::Angles { azimuth_deg: -30.0, elevation_deg: 20.0 }));
        assert!(view("30").is_err() && view("0,91").is_err() && view("nan,0").is_err());
        assert_eq!(up("+z"), Ok(Up::PlusZ));
        assert_eq!(up("-Y"), Ok(Up::MinusY));
        assert_eq!(up("z"), Ok(Up::PlusZ));
        assert!(up("w").is_err());
    }

    #[test]
    fn colors_are_codes_or_names() {
        assert_eq!(color("#ffffff"), Ok(rgb(1.0, 1.0, 1.0)));
        assert_eq!(color("black"), Ok(rgb(0.0, 0.0, 0.0)));
        assert_eq!(background("white"), Ok(Background::Color(rgb(1.0, 1.0, 1.0))));
        assert_eq!(background("transparent"), Ok(Background::Transparent));
        assert!(background("mauve").is_err_and(|message| message.ends_with("brown, or transparent")));
        assert!(color("#fff").is_err() && color("#+12345").is_err() && color("mauve").is_err());
    }

    #[test]
    fn limits_are_finite() {
        assert_eq!(not_negative("0.5"), Ok(0.5));
        for text in ["-1", "nan", "inf", "x"] {
            assert!(not_negative(text).is_err(), "{text}");
        }
    }
}
