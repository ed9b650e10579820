//! Rectangles of samples that do not share sides.

use brt_geometry::Taylor;

use super::SamplePattern;

/// A rectangle of samples of the grid; `x1` and `y1` not included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Area {
    pub(crate) x0: u32,
    pub(crate) y0: u32,
    pub(crate) x1: u32,
    pub(crate) y1: u32,
}

impl Area {
    /// Is neither side longer?
    pub(crate) fn is_within(&self, side: u32) -> bool {
        self.x1 - self.x0 <= side && self.y1 - self.y0 <= side
    }

    pub(crate) fn sample_count(&self) -> u32 {
        (self.x1 - self.x0) * (self.y1 - self.y0)
    }

    /// Does another lie in it?
    pub(crate) fn contains(&self, other: &Self) -> bool {
        self.x0 <= other.x0 && self.x1 >= other.x1 && self.y0 <= other.y0 && self.y1 >= other.y1
    }

    /// Its quarters; halves of a line, itself of a sample.
    pub(crate) fn quarters(self) -> impl Iterator<Item = Self> {
        let halves = |a: u32, b: u32| {
            let middle = a + (b - a).div_ceil(2);
            [[a, middle], [middle, b]]
        };
        let columns = halves(self.x0, self.x1);
        halves(self.y0, self.y1)
            .into_iter()
            .flat_map(move |[y0, y1]| columns.map(|[x0, x1]| Self { x0, y0, x1, y1 }))
            .filter(|part| part.x0 < part.x1 && part.y0 < part.y1)
    }

    /// The smallest area around both.
    pub(crate) fn joined(&self, other: &Self) -> Self {
        Self {
            x0: self.x0.min(other.x0),
            y0: self.y0.min(other.y0),
            x1: self.x1.max(other.x1),
            y1: self.y1.max(other.y1),
        }
    }

    /// Positions of all its samples as models: from −1, where the first may be, to 1, where the last may be.
    pub(crate) fn coordinates(&self, pattern: &SamplePattern) -> [Taylor; 2] {
        let ([x, y], [half_x, half_y]) = (self.middle(), self.half_sides(pattern));
        [Taylor::linear(x, half_x, 0.0), Taylor::linear(y, 0.0, half_y)]
    }

    /// Its middle as a position. Halves of integers are exact, as are shifts.
    pub(crate) fn middle(&self) -> [f64; 2] {
        let middle = |a: u32, b: u32| 0.5 * (f64::from(a) + f64::from(b - 1));
        [middle(self.x0, self.x1), middle(self.y0, self.y1)]
    }

    /// How far from its middle samples may be.
    pub(crate) fn half_sides(&self, pattern: &SamplePattern) -> [f64; 2] {
        let half = |a: u32, b: u32| 0.5 * f64::from(b - 1 - a) + pattern.reach();
        [half(self.x0, self.x1), half(self.y0, self.y1)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quarters_tile_an_area() {
        let area = Area { x0: 3, y0: 5, x1: 8, y1: 6 };
        let parts: Vec<Area> = area.quarters().collect();
        assert_eq!(parts, [Area { x1: 6, ..area }, Area { x0: 6, ..area }]);
    }

    #[test]
    fn coordinates_reach_from_the_first_sample_to_the_last() {
        let area = Area { x0: 2, y0: 7, x1: 5, y1: 8 };
        let [x, y] = area.coordinates(&SamplePattern::new(1));
        assert_eq!((x.c, x.u, y.c, y.v), (3.0, 1.0, 7.0, 0.0));
        // Two by two to a pixel, each shifted by a quarter.
        let [x, y] = area.coordinates(&SamplePattern::new(2));
        assert_eq!((x.c, x.u, y.c, y.v), (3.0, 1.25, 7.0, 0.25));
    }
}
