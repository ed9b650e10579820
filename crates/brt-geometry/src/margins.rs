//! The constants that proofs about rays and primitives rest on, each with its inequality; and the limits of what a scene may say.
//!
//! ε is 2⁻⁵², by half of which IEEE 754 rounds at most. D is the distance from where a ray starts to the farthest point of a
//! primitive, S the size of the scene; coordinates are at most 4.5 S, for scenes far from the origin are moved there.
//!
//! Each constant has a *safety*: of many random cases, measured against exact arithmetic, the worst needs more than this part of it
//! and no more than all of it. So a constant that is divided by its safety breaks a test (`margins/used.rs`), and none is added
//! without a measurement.

#[cfg(test)]
mod used;

/// A constant of a page of margins, for its tests.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Margin {
    pub name: &'static str,
    pub safety: f64,
}

impl Margin {
    /// Holds the share of the constant that was needed against its safety.
    ///
    /// # Panics
    /// If more was needed than there is, or so little that a far smaller constant would do.
    pub fn check(&self, used: f64) {
        let Self { name, safety } = self;
        assert!(used <= 1.0, "{name}: {used:.3} times as much is needed");
        assert!(used * safety > 1.0, "{name}: 1/{:.0} of it is needed; its safety is {safety}", 1.0 / used);
    }
}

/// Makes constants, and a list of them, `ALL`, for tests.
#[doc(hidden)]
#[macro_export]
macro_rules! margins {
    ($($(#[$doc:meta])* $visibility:vis $name:ident = $value:expr, safety $safety:expr;)*) => {
        $(
            $(#[$doc])*
            #[doc = concat!("\n\nSafety: ", stringify!($safety), ".")]
            $visibility const $name: f64 = $value;
        )*
        /// All constants that have a safety.
        #[cfg(test)]
        pub(crate) const ALL: &[$crate::Margin] =
            &[$($crate::Margin { name: stringify!($name), safety: $safety }),*];
    };
}

margins! {
    /// Room for hits beside their rays, as a share of D + S: boxes of the tree grow by it times S, rays by it times D, shafts,
    /// extents and cells of the grid by it times both.
    ///
    /// Round primitives: a hit is found from the point of the ray nearest to the centre or the axis, and the chord there; it is
    /// beside by some 8 ε·D. Flat ones: the distance to the plane rounds by some 8 ε·(D + S), and along the ray by that over the
    /// sine, which is at least [`LEAST_SINE`]: 8·2.2·10⁻¹⁶ / 4·10⁻⁷ = 4.4·10⁻⁹. Planes that faces share are off by up to
    /// 2.5·10⁻⁷ S more. Together less than 10⁻⁶.
    pub BOX_MARGIN = 1e-6, safety 5000.0;

    /// Rays along a plane, closer to it than this (as a sine), do not meet what lies in it; nor do rays along the axis of a
    /// cylinder, or of a cone that is nearly one, meet its side. Nor are infinite planes met so far away that nothing is known
    /// of the place.
    ///
    /// What corners and rays are off by rounding, over this, is how far along a ray a hit may be from the primitive: less than
    /// [`BOX_MARGIN`], see there.
    pub LEAST_SINE = 4e-7, safety 5000.0;

    /// Corners of a face may be off its plane by this share of its size. Polygons that are not as flat are cut into triangles.
    ///
    /// A ray at [`LEAST_SINE`] meets the plane beside such a corner by this over the sine: 5·10⁻⁷ of the size, half of
    /// [`BOX_MARGIN`].
    pub FACE_FLATNESS = 2e-13, safety 4.0;

    /// A face whose area is this share of that of a square as long is, seen at a sine of this over the share, as thin as
    /// rounding makes it.
    ///
    /// Corners are seen where six roundings of ε/2 of their distance put them, and sides are products of two of them: an area
    /// as seen is off by some 24 ε of the square of what is seen.
    pub(crate) SLIVER_ROUNDINGS = 64.0 * f64::EPSILON, safety 200.0;

    /// The area of a polygon as seen, a sum of n products, rounds by less than n ε/2 + ε/2 of the sum of their sizes. Beyond that
    /// an area is no rounding. What [`RayBlock`](crate::RayBlock) is certain of is beyond [`BLOCK_ROUNDINGS`], far more.
    pub(crate) AREA_ROUNDINGS = 8.0 * f64::EPSILON, safety 32.0;

    /// Room of items in the cells of a grid, in [`BOX_MARGIN`]s of the grid's size S. Rays from farther away than this less 2
    /// sizes do not walk: D is then at most one more, and one is left for the rounding of the walk.
    pub(crate) GRID_ROOM = 64.0, safety 1.5;

    /// Distances along a grid's walk are taken shorter by this share. They are quotients of a difference: three roundings of
    /// ε/2. (What a boundary itself is off by lies within [`GRID_ROOM`].)
    pub(crate) WALK_MARGIN = 1e-9, safety 1e7;

    /// Distances in the tree's single precision are widened by this share: the near ones, which are taken shorter, have five
    /// roundings of 2⁻²⁴ (direction, its inverse, difference, product, and the shortening itself), less than eight.
    pub(crate) TREE_SLACK = 1.0 / (1 << 21) as f64, safety 4.0;

    /// The point of a ray at a distance rounds by ε/2 of each coordinate, and so does the point that it started from.
    pub(crate) START_ROUNDINGS = 4.0 * f64::EPSILON, safety 16.0;

    /// Where a box lies along the normal of a shaft's face, in single precision, as a share of three times the tree's reach, which
    /// is what three products sum up to: rounded normal, products and sums, nine roundings of 2⁻²⁴ of a reach at most, against
    /// 3·32.
    pub(crate) SHAFT_SLACK = 1.0 / (1 << 19) as f64, safety 40.0;

    /// The offset of a shaft's face in the tree's coordinates is a sum of four terms, whose products and sums round by ε/2 each.
    pub(crate) OFFSET_ROUNDINGS = 16.0 * f64::EPSILON, safety 24.0;

    /// The moment of a ray around the point that its direction was made of, as a share of the square of that direction's size: the
    /// direction rounds by ε/2 of its coordinates, and its products with the way to the point twice more.
    pub(crate) MOMENT_ROUNDINGS = 4.0 * f64::EPSILON, safety 8.0;

    /// What one operation on models adds to the remainder, as a share of its terms: IEEE 754 rounds each of them by ε/2, and what is
    /// added is rounded itself.
    pub(crate) MODEL_ROUNDING = 2.0 * f64::EPSILON, safety 12.0;

    /// By how much the side of an edge that a block of rays computes from moments, and what single rays compute for it, may
    /// differ together, as a share of their terms.
    ///
    /// A side is a determinant: twelve products of three factors, and differences of corners and origins; each side of the
    /// comparison rounds by fewer than 32 ε. For balls four times as much: the square of half a chord rounds by 2·l·8 ε·D, at
    /// most 16 ε·(D² + r²).
    pub(crate) BLOCK_ROUNDINGS = 64.0 * f64::EPSILON, safety 50.0;

    /// Coordinates, and scalar products of them, round by less than this share of the sum of their terms: three products and
    /// two sums, 5 ε/2; the rest is room for points that were themselves computed.
    pub COORDINATE_ROUNDING = 1e-12, safety 10_000.0;
}

/// Directions closer than this (in radians) count as parallel when a scene is checked and prepared.
pub const SMALLEST_ANGLE: f64 = 1e-9;

/// Lengths below this cannot be traced: their fourth powers must stay far from 0.
pub const SMALLEST_LENGTH: f64 = 1e-30;

/// Points of a polygon may be off its plane by this share of the polygon's size: files round to about six digits.
pub const POLYGON_FLATNESS: f64 = 1e-3;

/// Facets of a mesh without normals belong to one surface if their normals differ by less (in radians).
pub const FACET_ANGLE: f64 = 1e-6;

/// Directions of rays count as different where the square of the sine between them is more than this share. Nothing rests on it: a
/// shaft may have its sides anywhere.
pub(crate) const CLEARLY_ACROSS: f64 = 1e-12;

/// Hits beyond this distance (in units of the ray's direction) do not count. Finite, so that bounds can tell.
pub const FARTHEST: f64 = 1e300;
