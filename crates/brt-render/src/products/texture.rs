//! Pictures on meshes, as the tracers want them.

use brt_image::{Rgb, Transfer, rgb};
use brt_scene::{Texture, TextureAlpha, TextureFilter, Wrap};

/// A texture, with a table that turns its codes into linear light.
#[derive(Clone, Debug)]
pub(crate) struct PreparedTexture {
    texture: Texture,
    linear: Box<[f64; 256]>,
}

/// What a texture shows at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TextureSample {
    /// Linear.
    pub(crate) color: Rgb,
    /// The share that is there.
    pub(crate) opacity: f64,
    /// The texel that the point lies in: what ray histories tell apart.
    pub(crate) texel: u64,
}

impl PreparedTexture {
    pub(crate) fn new(texture: &Texture) -> Self {
        let linear = std::array::from_fn(|code| Transfer::Srgb.decode(code as f64 / 255.0));
        Self { texture: texture.clone(), linear: Box::new(linear) }
    }

    /// May it leave out something of the surface?
    pub(crate) fn has_holes(&self) -> bool {
        self.texture.alpha != TextureAlpha::Ignored
    }

    /// What is at these texture coordinates.
    pub(crate) fn sample(&self, [u, v]: [f64; 2]) -> TextureSample {
        let [x, y] = self.texture.transform.map(|[a, b, c]| a * u + b * v + c);
        let (width, height) = (self.texture.picture.width, self.texture.picture.height);
        let (x, y) = (x * f64::from(width), y * f64::from(height));
        let [r, g, b, alpha] = match self.texture.filter {
            TextureFilter::Nearest => self.texel(x.floor(), y.floor()),
            TextureFilter::Linear => self.mixed(x - 0.5, y - 0.5),
        };
        let opacity = match self.texture.alpha {
            TextureAlpha::Ignored => 1.0,
            TextureAlpha::Blend => alpha,
            TextureAlpha::Mask(cutoff) => f64::from(u8::from(alpha >= cutoff)),
        };
        // Casts of floats saturate, so points far away lie in the last texel.
        let texel = (x.floor() as i64 as u64).rotate_left(32) ^ y.floor() as i64 as u64;
        TextureSample { color: rgb(r, g, b), opacity, texel }
    }

    /// Four texels around a point, mixed; texels' middles are whole numbers here.
    fn mixed(&self, x: f64, y: f64) -> [f64; 4] {
        let (left, top) = (x.floor(), y.floor());
        let (right_share, bottom_share) = (x - left, y - top);
        let mix = |a: [f64; 4], b: [f64; 4], share: f64| {
            std::array::from_fn::<f64, 4, _>(|c| a[c] * (1.0 - share) + b[c] * share)
        };
        let row = |y: f64| mix(self.texel(left, y), self.texel(left + 1.0, y), right_share);
        mix(row(top), row(top + 1.0), bottom_share)
    }

    /// A texel by whole numbers, however far beyond the edges.
    fn texel(&self, column: f64, row: f64) -> [f64; 4] {
        let [across, down] = self.texture.wrap;
        let picture = &*self.texture.picture;
        let (x, y) = (wrapped(column, picture.width, across), wrapped(row, picture.height, down));
        let [r, g, b, alpha] = picture.rgba[y * picture.width as usize + x];
        let [r, g, b] = [r, g, b].map(|code| self.linear[usize::from(code)]);
        [r, g, b, f64::from(alpha) / 255.0]
    }
}

/// Where in a row of `count` texels one lies that may be beyond it.
fn wrapped(index: f64, count: u32, wrap: Wrap) -> usize {
    let n = f64::from(count);
    let inside = match wrap {
        Wrap::Repeat => index.rem_euclid(n),
        Wrap::Mirror => {
            let there = index.rem_euclid(2.0 * n);
            if there < n { there } else { 2.0 * n - 1.0 - there }
        }
        Wrap::Clamp => index,
    };
    // Casts saturate, and what is no number becomes 0.
    (inside as usize).min(count as usize - 1)
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use brt_scene::Texels;

    use super::*;

    /// Black and white over red and half a green.
    fn four() -> Texture {
        let rgba = vec![[0, 0, 0, 255], [255; 4], [255, 0, 0, 255], [0, 255, 0, 128]];
        Texture::new(Arc::new(Texels { name: "four".to_owned(), width: 2, height: 2, rgba }))
    }

    #[test]
    fn the_upper_left_corner_is_the_first_texel() {
        let texture = PreparedTexture::new(&Texture { filter: TextureFilter::Nearest, ..four() });
        assert_eq!(texture.sample([0.01, 0.01]).color, Rgb::BLACK);
        assert_eq!(texture.sample([0.99, 0.01]).color, Rgb::WHITE);
        assert_eq!(texture.sample([0.01, 0.99]).color, rgb(1.0, 0.0, 0.0));
    }

    #[test]
    fn texels_are_mixed_in_linear_light() {
        let texture = PreparedTexture::new(&four());
        assert_eq!(texture.sample([0.5, 0.25]).color, rgb(0.5, 0.5, 0.5));
        assert_eq!(texture.sample([0.25, 0.25]).color, Rgb::BLACK);
        // Beyond the edge lies the other side.
        assert_eq!(texture.sample([0.0, 0.25]).color, rgb(0.5, 0.5, 0.5));
    }

    #[test]
    fn what_lies_beyond_the_edges() {
        let places = |wrap| [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0].map(|i| wrapped(i, 3, wrap));
        assert_eq!(places(Wrap::Repeat), [0, 1, 2, 0, 1, 2, 0, 1]);
        assert_eq!(places(Wrap::Mirror), [2, 1, 0, 0, 1, 2, 2, 1]);
        assert_eq!(places(Wrap::Clamp), [0, 0, 0, 0, 1, 2, 2, 2]);
        for wrap in [Wrap::Repeat, Wrap::Mirror, Wrap::Clamp] {
            for index in [1e300, -1e300, f64::INFINITY, f64::NAN] {
                assert!(wrapped(index, 3, wrap) < 3, "{wrap:?} {index}");
            }
        }
    }

    #[test]
    fn alpha_is_a_share_or_a_mask() {
        let alpha = |alpha| {
            let texture = Texture { filter: TextureFilter::Nearest, alpha, ..four() };
            PreparedTexture::new(&texture).sample([0.99, 0.99]).opacity
        };
        assert_eq!(alpha(TextureAlpha::Ignored), 1.0);
        assert_eq!(alpha(TextureAlpha::Blend), 128.0 / 255.0);
        assert_eq!([alpha(TextureAlpha::Mask(0.5)), alpha(TextureAlpha::Mask(0.6))], [1.0, 0.0]);
    }

    #[test]
    fn coordinates_are_moved() {
        // A quarter turn about the picture's middle: the upper right texel comes to the upper left corner.
        let transform = [[0.0, -1.0, 1.0], [1.0, 0.0, 0.0]];
        let texture = Texture { transform, filter: TextureFilter::Nearest, ..four() };
        assert_eq!(PreparedTexture::new(&texture).sample([0.01, 0.01]).color, Rgb::WHITE);
    }
}
