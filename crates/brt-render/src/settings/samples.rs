//! How many samples a pixel has, and how they become one.

/// Samples per pixel: a square number, so that they form a regular grid over the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Samples {
    /// One, in the middle of the pixel.
    #[default]
    One,
    /// 2 × 2.
    Four,
    /// 4 × 4.
    Sixteen,
    /// 8 × 8.
    SixtyFour,
    /// 16 × 16: what the others are measured against.
    TwoHundredFiftySix,
}

impl Samples {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::One, Self::Four, Self::Sixteen, Self::SixtyFour, Self::TwoHundredFiftySix];

    /// Samples along each side of a pixel.
    pub fn per_side(self) -> u32 {
        match self {
            Self::One => 1,
            Self::Four => 2,
            Self::Sixteen => 4,
            Self::SixtyFour => 8,
            Self::TwoHundredFiftySix => 16,
        }
    }

    /// Samples per pixel.
    pub fn per_pixel(self) -> u32 {
        self.per_side() * self.per_side()
    }
}

/// How samples become pixels. Weights of a pixel sum up to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Filter {
    /// The mean of the pixel's own samples.
    #[default]
    Box,
    /// A Gaussian of standard deviation ½ pixel, cut off 1 pixel from the pixel's middle in each direction. Samples weigh
    /// by column and row, without their shifts from there: these cancel over a pixel.
    Gaussian,
}

impl Filter {
    /// How many pixels beyond its own a sample reaches.
    pub(crate) fn margin(self) -> u32 {
        match self {
            Self::Box => 0,
            Self::Gaussian => 1,
        }
    }
}
