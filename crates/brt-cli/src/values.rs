//! Values on the command line.

use brt::{BitDepth, PictureLayer, Samples};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

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

/// A finite number, at least 0.
pub(crate) fn not_negative(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|n| n.is_finite() && *n >= 0.0);
    number.ok_or_else(|| "expected a number, at least 0".to_owned())
}

/// Samples per pixel.
pub(crate) fn samples() -> impl TypedValueParser<Value = Samples> {
    let counts =
        Samples::ALL.map(|s| PossibleValue::new(["1", "4", "16", "64"][s.per_side().ilog2() as usize]));
    PossibleValuesParser::new(counts).map(|text| {
        let named = |s: &Samples| s.per_pixel().to_string() == text;
        Samples::ALL.into_iter().find(named).unwrap_or_default()
    })
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
    fn limits_are_finite() {
        assert_eq!(not_negative("0.5"), Ok(0.5));
        for text in ["-1", "nan", "inf", "x"] {
            assert!(not_negative(text).is_err(), "{text}");
        }
    }
}
