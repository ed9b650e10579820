//! Colours as files store them.

use brt_image::{Rgb, Transfer, rgb};

/// Linear light of an sRGB colour with channels from 0 to 1.
pub(crate) fn srgb(channels: [f64; 3]) -> Rgb {
    let [r, g, b] = channels.map(|c| Transfer::Srgb.decode(c.clamp(0.0, 1.0)));
    rgb(r, g, b)
}
