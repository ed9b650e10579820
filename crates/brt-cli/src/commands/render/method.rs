//! The chosen method with its settings; options of another method are refused.

use brt::{
    BorderSettings, CertifiedSettings, DeviationDelta, DifferenceDelta, Judge, Method, PencilSettings,
    PictureLayer, PixelSelectedSettings, VarianceDelta,
};

use super::options::{MethodName, Options};
use super::paper::JudgeName;
use crate::exit::{Failure, wrong_use};

/// Δ and the first block's side where none is given. Paper: P7, reading 4.
const DELTA: f64 = 16.0;
const BLOCK: u32 = 16;

/// The method that the options ask for.
pub(super) fn chosen(options: &Options) -> Result<Method, Failure> {
    let paper = &options.paper;
    check_belonging(options)?;
    let delta = paper.delta.unwrap_or(DELTA);
    let block = paper.block.unwrap_or(BLOCK);
    Ok(match options.method {
        MethodName::Full => Method::Full,
        MethodName::ItemBuffer => Method::ItemBuffer,
        MethodName::ScanLine => Method::ScanLine,
        MethodName::Pencil => Method::Pencil(PencilSettings {
            block: paper.block.unwrap_or(PencilSettings::default().block),
            tolerance: options.tolerance.unwrap_or(PencilSettings::default().tolerance),
        }),
        MethodName::Certified => Method::Certified(CertifiedSettings {
            tolerance: options.tolerance.unwrap_or(CertifiedSettings::default().tolerance),
        }),
        MethodName::PixelSelected => Method::PixelSelected(PixelSelectedSettings {
            block,
            delta: DifferenceDelta(delta),
            central_point: paper.icps,
        }),
        MethodName::Border => Method::Border(BorderSettings {
            block,
            judge: match paper.judge.unwrap_or_default() {
                JudgeName::Deviation => Judge::Deviation(DeviationDelta(delta)),
                JudgeName::Variance => Judge::Variance(VarianceDelta(delta)),
                JudgeName::Difference => Judge::Difference(DifferenceDelta(delta)),
            },
            regions: paper.regions.unwrap_or_default().into(),
        }),
    })
}

fn check_belonging(options: &Options) -> Result<(), Failure> {
    use MethodName::{Border, Certified, Pencil, PixelSelected};
    let Options { method, paper, .. } = options;
    let given: [(&str, bool, &[MethodName]); 8] = [
        ("--delta", paper.delta.is_some(), &[Border, PixelSelected]),
        ("--judge", paper.judge.is_some(), &[Border]),
        ("--regions", paper.regions.is_some(), &[Border]),
        ("--history", paper.history.is_some(), &[Border, PixelSelected]),
        ("--block", paper.block.is_some(), &[Border, PixelSelected, Pencil]),
        ("--tolerance", options.tolerance.is_some(), &[Certified, Pencil]),
        ("--icps", paper.icps, &[PixelSelected]),
        ("--layers certificates", options.layers.contains(&PictureLayer::Certificates), &[Certified]),
    ];
    for (option, is_given, methods) in given {
        if is_given && !methods.contains(method) {
            let names: Vec<_> = methods.iter().map(|m| format!("`--method {}`", m.name())).collect();
            let owners = names.join(" and ");
            let advice = match method {
                Certified if option == "--delta" => "; use `--tolerance`",
                _ => "",
            };
            let name = method.name();
            return Err(wrong_use(format!("`{option}` belongs to {owners}, not to `{name}`{advice}")));
        }
    }
    Ok(())
}
