//! The last words of a rendering.

use std::io;

use brt::{Judge, Method, Rendered, Settings, Target, Verification};

use super::options::Options;
use super::targets::Targets;
use crate::output;

/// Prints the verification where it was asked for, and the summary where it is seen. Those who want it quiet hear of
/// pixels above the limit only.
pub(super) fn show(
    options: &Options,
    targets: &Targets,
    settings: &Settings,
    rendered: &Rendered,
    total: f64,
) -> io::Result<()> {
    let to_stdout = targets.picture.target == Some(Target::Stdout)
        || targets.stats.as_deref().is_some_and(crate::scene_input::is_dash);
    if let (true, Some(found)) = (options.verifies(), &rendered.verification)
        && (!options.quiet || found.above > 0 || options.is_over_limit(found.comparison.max_error))
    {
        let line = verification(found);
        if to_stdout {
            output::note(&line);
        } else {
            output::line(&line)?;
        }
        if let Some(limit) = options.max_error.filter(|_| options.is_over_limit(found.comparison.max_error)) {
            output::note(&format!("the greatest error is above the {limit} that --max-error allows"));
        }
    }
    if options.verbose {
        output::note(&details(options, rendered));
    }
    if !options.quiet && (options.verbose || output::errors_are_seen()) {
        output::note(&last_line(targets, settings, rendered, total));
    }
    Ok(())
}

/// The line to cite. The error is rounded up: what is cited holds.
fn verification(found: &Verification) -> String {
    let Verification { comparison, limit, above, worst: [x, y] } = found;
    let greatest = (comparison.max_error * 100.0).ceil() / 100.0;
    let levels = levels(greatest);
    let place = if *above > 0 { format!(", worst at {x},{y}") } else { String::new() };
    format!(
        "{} pixels checked, greatest error {greatest:.2} {levels}, {} above {limit}{place}",
        grouped(comparison.pixels),
        grouped(*above)
    )
}

fn levels(count: f64) -> &'static str {
    if count == 1.0 { "level" } else { "levels" }
}

/// `a.png 4096×4096 ×16 · 1.8 s · 1.4 % traced · border Δ 16`
fn last_line(targets: &Targets, settings: &Settings, rendered: &Rendered, total: f64) -> String {
    let name = match &targets.picture.target {
        Some(Target::File(path)) => format!("{} ", path.display()),
        Some(Target::Stdout) | None => String::new(),
    };
    let [width, height] = settings.size;
    let pixels = rendered.stats.pixels;
    format!(
        "{name}{width}×{height} ×{} · {} · {} traced · {}",
        settings.samples.per_pixel(),
        duration(total),
        percent(pixels.traced, pixels.total),
        method(&settings.method),
    )
}

fn method(method: &Method) -> String {
    match method {
        Method::PixelSelected(settings) => format!("pixel-selected Δ {}", settings.delta.0),
        Method::Border(settings) => match settings.judge {
            Judge::Deviation(delta) => format!("border Δ {}", delta.0),
            Judge::Variance(delta) => format!("border Δ {} of variance", delta.0),
            Judge::Difference(delta) => format!("border Δ {} of difference", delta.0),
        },
        Method::Pencil(settings) => {
            format!("pencil, filled pixels within {} {}", settings.tolerance, levels(settings.tolerance))
        }
        Method::Certified(settings) if settings.tolerance == 0.0 => "every pixel as traced".to_owned(),
        Method::Certified(settings) => {
            format!("every pixel within {} {}", settings.tolerance, levels(settings.tolerance))
        }
        others => others.name().to_owned(),
    }
}

/// Where the time went and how much was done.
fn details(options: &Options, rendered: &Rendered) -> String {
    let brt::Stats { seconds, rays, primitive_tests, .. } = rendered.stats;
    format!(
        "prepare {}, render {}, encode {}, instructions: {}\nrays: {} camera, {} shadow, {} mirror, {} refracted; {} primitive tests",
        duration(seconds.prepare),
        duration(seconds.render),
        duration(rendered.encode_seconds),
        options.simd.instructions(),
        grouped(rays.camera),
        grouped(rays.shadow),
        grouped(rays.mirror),
        grouped(rays.refracted),
        grouped(primitive_tests),
    )
}

fn duration(seconds: f64) -> String {
    match seconds {
        s if s < 0.1 => format!("{:.0} ms", 1000.0 * s),
        s if s < 100.0 => format!("{s:.1} s"),
        s => format!("{:.0} min {:02.0} s", (s / 60.0).floor(), (s % 60.0).floor()),
    }
}

fn percent(part: u64, whole: u64) -> String {
    if part == whole {
        return "100 %".to_owned();
    }
    format!("{:.1} %", 100.0 * part as f64 / whole as f64)
}

/// Digits in groups of three.
fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let first = digits.len() % 3;
    let mut groups: Vec<&str> = Vec::new();
    if first > 0 {
        groups.push(&digits[..first]);
    }
    groups.extend((first..digits.len()).step_by(3).map(|i| &digits[i..i + 3]));
    groups.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;
    use brt::Comparison;

    #[test]
    fn numbers_read_well() {
        assert_eq!(grouped(16_777_216), "16,777,216");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(0), "0");
        assert_eq!(duration(0.0123), "12 ms");
        assert_eq!(duration(1.84), "1.8 s");
        assert_eq!(duration(125.0), "2 min 05 s");
        assert_eq!(percent(14, 1000), "1.4 %");
        assert_eq!(percent(7, 7), "100 %");
    }

    #[test]
    fn cited_errors_are_rounded_up() {
        let cited = |pixels, max_error, limit, above| {
            let comparison = Comparison { pixels, max_error, ..Comparison::default() };
            verification(&Verification { comparison, limit, above, worst: [3, 4] })
        };
        assert_eq!(cited(4096, 0.901, 1.0, 0), "4,096 pixels checked, greatest error 0.91 levels, 0 above 1");
        assert_eq!(cited(9, 0.999, 1.0, 0), "9 pixels checked, greatest error 1.00 level, 0 above 1");
        assert_eq!(
            cited(10, 37.5, 0.25, 2),
            "10 pixels checked, greatest error 37.50 levels, 2 above 0.25, worst at 3,4"
        );
    }
}
