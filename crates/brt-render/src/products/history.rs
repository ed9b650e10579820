//! Ray histories: the shape of a sample's ray tree.

/// The ray tree of a sample, condensed to 64 bits.
///
/// Takes part: the surface and side met at each level, total reflection, the end by depth, which lights are seen
/// (optionally by what they are hidden), and the cell of a chequered pattern. Two different trees get the same value
/// with a chance of about 2⁻⁶⁴; the methods that compare histories are heuristic themselves.
#[doc(alias = "intersection history")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct RayHistory(pub u64);

/// A step of a ray history.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Step {
    /// The ray met nothing.
    Background,
    /// The ray met a surface from its front or back.
    Surface { surface: u32, from_behind: bool },
    /// The hit lies in this square of a chequered pattern.
    Cell(u64),
    /// A light is seen.
    Lit,
    /// A light is not seen; with [`HistoryKind::Shadower`](crate::HistoryKind) the surface that hides it.
    Hidden(u32),
    /// A ray was not followed because of the depth limit.
    DepthEnd,
    /// Total reflection.
    TotalReflection,
    /// A light is seen through this surface, which is not wholly there.
    Crossed(u32),
}

impl RayHistory {
    /// Adds a step.
    #[inline(always)]
    pub(crate) fn push(&mut self, step: Step) {
        let (tag, value) = match step {
            Step::Background => (1, 0),
            Step::Surface { surface, from_behind } => (2, u64::from(surface) << 1 | u64::from(from_behind)),
            Step::Cell(cell) => (3, cell),
            Step::Lit => (4, 0),
            Step::Hidden(surface) => (5, u64::from(surface)),
            Step::DepthEnd => (6, 0),
            Step::TotalReflection => (7, 0),
            Step::Crossed(surface) => (8, u64::from(surface)),
        };
        let mixed =
            (self.0 ^ value.wrapping_mul(0xff51_afd7_ed55_8ccd) ^ tag).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        self.0 = mixed ^ mixed >> 29;
    }
}
