//! Windows: the rectangle of a picture that is rendered.

use std::fmt;

/// A rectangle of a picture's pixels. The picture itself may be far larger than anything that is ever rendered whole.
#[doc(alias("crop", "region of interest", "viewport"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Window {
    /// First pixel column and row, counted from the picture's upper left corner.
    pub x: u64,
    /// See `x`.
    pub y: u64,
    /// Pixels per row.
    pub width: u32,
    /// Rows of pixels.
    pub height: u32,
}

impl Window {
    /// Greatest width and height in pixels: sample indices stay far below 2³².
    pub const GREATEST_SIDE: u32 = 1 << 24;

    /// Greatest width and height of a picture that windows are parts of, in pixels: positions of samples stay exact in `f64`.
    pub const GREATEST_PICTURE_SIDE: u64 = 1 << 40;

    /// All of a picture of this size; `None` if it is too large to be rendered at once.
    pub fn whole(size: [u64; 2]) -> Option<Self> {
        let side = |side: u64| u32::try_from(side).ok().filter(|side| *side <= Self::GREATEST_SIDE);
        Some(Self { x: 0, y: 0, width: side(size[0])?, height: side(size[1])? })
    }

    /// One pixel.
    pub fn pixel(x: u64, y: u64) -> Self {
        Self { x, y, width: 1, height: 1 }
    }

    /// Does it have pixels, all of them pixels of a picture of this size, and not too many?
    pub fn fits(&self, size: [u64; 2]) -> bool {
        let fits = |first: u64, length: u32, side: u64| {
            (1..=Self::GREATEST_SIDE).contains(&length)
                && first.checked_add(u64::from(length)).is_some_and(|end| end <= side)
        };
        fits(self.x, self.width, size[0]) && fits(self.y, self.height, size[1])
    }
}

impl fmt::Display for Window {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the window of {}×{} pixels at {},{}", self.width, self.height, self.x, self.y)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_lie_in_their_pictures() {
        let size = [1 << 40, 7];
        let window = Window { x: (1 << 40) - 5, y: 3, width: 5, height: 4 };
        assert!(window.fits(size));
        assert!(!Window { width: 6, ..window }.fits(size));
        assert!(!Window { y: 4, ..window }.fits(size));
        assert!(!Window { height: 0, ..window }.fits(size));
        assert!(!Window { x: u64::MAX, ..window }.fits(size));
        assert!(!Window { width: Window::GREATEST_SIDE + 1, x: 0, ..window }.fits(size));
    }

    #[test]
    fn what_is_too_large_is_not_rendered_whole() {
        assert_eq!(Window::whole([8, 9]), Some(Window { x: 0, y: 0, width: 8, height: 9 }));
        assert_eq!(Window::whole([1 << 25, 9]), None);
        assert_eq!(Window::whole([1 << 33, 9]), None);
    }
}
