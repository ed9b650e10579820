//! The methods and accelerators that are compared. What is built later gets its line here.

use brt::{
    Accelerator, BorderSettings, CertifiedSettings, DeviationDelta, DifferenceDelta, Judge, Method,
    PencilSettings, PixelSelectedSettings, Regions, VarianceDelta,
};

/// The threshold of Figs. 1–4, in levels. Paper: P7.
pub(crate) const DELTA: f64 = 16.0;
/// The thresholds of Fig. 5 and Picture 1. Paper: P7.
pub(crate) const DELTAS: [f64; 6] = [4.0, 8.0, 16.0, 32.0, 64.0, 128.0];

/// Border ray tracing by one reading of the judgement (docs/paper/claims.md, reading 2), or PSRT.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Selection {
    Deviation,
    Variance,
    Difference,
    Psrt,
}

impl Selection {
    pub(crate) const ALL: [Self; 4] = [Self::Deviation, Self::Variance, Self::Difference, Self::Psrt];
    /// The readings of border ray tracing.
    pub(crate) const READINGS: [Self; 3] = [Self::Deviation, Self::Variance, Self::Difference];

    /// In tables.
    pub(crate) fn key(self) -> &'static str {
        match self {
            Self::Deviation => "border-deviation",
            Self::Variance => "border-variance",
            Self::Difference => "border-difference",
            Self::Psrt => "pixel-selected",
        }
    }

    /// In legends.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Deviation => "BRT, deviation",
            Self::Variance => "BRT, variance",
            Self::Difference => "BRT, difference",
            Self::Psrt => "PSRT",
        }
    }

    /// The method at a threshold.
    pub(crate) fn method(self, delta: f64) -> Method {
        self.method_with(delta, Regions::Separate)
    }

    /// The method at a threshold, with a way to treat two regions. PSRT knows none.
    pub(crate) fn method_with(self, delta: f64, regions: Regions) -> Method {
        let judge = match self {
            Self::Deviation => Judge::Deviation(DeviationDelta(delta)),
            Self::Variance => Judge::Variance(VarianceDelta(delta)),
            Self::Difference => Judge::Difference(DifferenceDelta(delta)),
            Self::Psrt => {
                let delta = DifferenceDelta(delta);
                return Method::PixelSelected(PixelSelectedSettings { delta, ..Default::default() });
            }
        };
        Method::Border(BorderSettings { judge, regions, ..Default::default() })
    }
}

/// Certified within a level.
pub(crate) fn certified() -> Method {
    Method::Certified(CertifiedSettings { tolerance: 1.0 })
}

/// The three families of speed-ups. Paper: P1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    Standard,
    Interpolation,
    Hybrid,
}

/// A method of a family; without settings it is not built.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FamilyMethod {
    pub(crate) name: &'static str,
    pub(crate) family: Family,
    pub(crate) method: Option<fn() -> Method>,
}

/// The methods that P1 names.
pub(crate) const METHODS: [FamilyMethod; 6] = [
    FamilyMethod { name: "full", family: Family::Standard, method: Some(|| Method::Full) },
    FamilyMethod {
        name: "pixel-selected",
        family: Family::Interpolation,
        method: Some(|| Selection::Psrt.method(DELTA)),
    },
    FamilyMethod {
        name: "border",
        family: Family::Interpolation,
        method: Some(|| Selection::Deviation.method(DELTA)),
    },
    FamilyMethod {
        name: "pencil",
        family: Family::Interpolation,
        method: Some(|| Method::Pencil(PencilSettings::default())),
    },
    FamilyMethod { name: "item-buffer", family: Family::Hybrid, method: Some(|| Method::ItemBuffer) },
    FamilyMethod { name: "scan-line", family: Family::Hybrid, method: Some(|| Method::ScanLine) },
];

/// The space divisions that P1 names, after none.
pub(crate) const ACCELERATORS: [(&str, Option<Accelerator>); 4] = [
    ("none", Some(Accelerator::None)),
    ("extents", Some(Accelerator::Extents)),
    ("grid", Some(Accelerator::Grid)),
    ("bvh", Some(Accelerator::Bvh)),
];

/// The two conditions of Figs. 1, 2 and 4: the paper's, and today's.
pub(crate) const CONDITIONS: [(&str, Accelerator); 2] =
    [("none", Accelerator::None), ("bvh", Accelerator::Bvh)];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_reading_is_the_default_of_border() {
        assert_eq!(Selection::Deviation.method(DELTA), Method::Border(BorderSettings::default()));
        assert_eq!(Selection::Psrt.method(DELTA), Method::PixelSelected(PixelSelectedSettings::default()));
    }
}
