//! Charts as SVG, to stand inside a page.
//!
//! Colours are CSS variables (`--s0` … `--s5`, `--ink`, `--grid`, `--paper`) that the page sets for light and dark;
//! lines differ in dashes and markers too, so that no reader needs the colours.

mod axis;

use std::fmt::Write;

pub(crate) use axis::Axis;
use axis::Scale;

/// Size of a chart without its legend, in units that are shown as pixels.
const WIDTH: f64 = 540.0;
const HEIGHT: f64 = 350.0;
const LEFT: f64 = 68.0;
const RIGHT: f64 = 16.0;
const TOP: f64 = 36.0;
const BOTTOM: f64 = 52.0;
/// Legend: height of a row, room for a line with its marker, mean width of a letter.
const ROW: f64 = 21.0;
const SWATCH: f64 = 46.0;
const LETTER: f64 = 7.1;

/// A chart with lines.
#[derive(Clone, Debug)]
pub(crate) struct Chart {
    pub(crate) title: String,
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) lines: Vec<Line>,
}

/// A line with markers at its points.
#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub(crate) name: String,
    pub(crate) points: Vec<(f64, f64)>,
    pub(crate) look: Look,
}

/// How a line looks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Look {
    /// Which of the page's six colours; `None` for a thin grey guide without markers.
    pub(crate) color: Option<usize>,
    pub(crate) dash: Dash,
    pub(crate) marker: Marker,
}

/// How a line is broken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dash {
    Solid,
    Broken,
    Dotted,
    /// Markers alone.
    None,
}

/// What stands at the points of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Marker {
    Disc,
    Ring,
    Square,
    Triangle,
    Diamond,
    Cross,
}

impl Look {
    /// A thin grey line to compare slopes with.
    pub(crate) const GUIDE: Self = Self { color: None, dash: Dash::Dotted, marker: Marker::Disc };

    pub(crate) fn new(color: usize, dash: Dash, marker: Marker) -> Self {
        Self { color: Some(color), dash, marker }
    }

    fn stroke(self) -> String {
        self.color.map_or_else(|| "var(--guide)".to_owned(), |c| format!("var(--s{})", c % 6))
    }
}

impl Chart {
    /// The chart as an SVG element. Points that are not finite, or not positive on a logarithmic axis, are left out.
    pub(crate) fn svg(&self) -> String {
        let shown: Vec<Line> = self.lines.iter().map(|line| self.visible(line)).collect();
        let points = || shown.iter().flat_map(|line| line.points.iter());
        let x = self.x.scale(points().map(|p| p.0), LEFT, WIDTH - RIGHT);
        let y = self.y.scale(points().map(|p| p.1), HEIGHT - BOTTOM, TOP);
        let (legend, rows) = self.legend();
        let height = HEIGHT + ROW * rows as f64 + 6.0;
        let mut svg = format!(
            "<svg class=\"chart\" viewBox=\"0 0 {WIDTH} {height:.0}\" role=\"img\" aria-label=\"{0}\">\n\
             <text class=\"title\" x=\"{LEFT}\" y=\"20\">{0}</text>\n",
            escape(&self.title)
        );
        svg.push_str(&frame(&x, &y));
        svg.push_str(&self.axis_labels());
        for line in &shown {
            svg.push_str(&drawn(line, &x, &y));
        }
        svg.push_str(&legend);
        svg.push_str("</svg>\n");
        svg
    }

    fn visible(&self, line: &Line) -> Line {
        let fits = |&(x, y): &(f64, f64)| self.x.can_show(x) && self.y.can_show(y);
        Line { points: line.points.iter().copied().filter(fits).collect(), ..line.clone() }
    }

    fn axis_labels(&self) -> String {
        let (middle_x, middle_y) = ((LEFT + WIDTH - RIGHT) / 2.0, (TOP + HEIGHT - BOTTOM) / 2.0);
        format!(
            "<text class=\"label\" x=\"{middle_x}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n\
             <text class=\"label\" transform=\"translate(16 {middle_y}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
            HEIGHT - 10.0,
            escape(&self.x.label),
            escape(&self.y.label)
        )
    }

    /// Entries in rows below the chart, and the number of rows.
    fn legend(&self) -> (String, usize) {
        let (mut svg, mut x, mut row) = (String::new(), LEFT, 0);
        for line in &self.lines {
            let width = SWATCH + LETTER * line.name.chars().count() as f64 + 14.0;
            if x > LEFT && x + width > WIDTH {
                (x, row) = (LEFT, row + 1);
            }
            let y = HEIGHT + ROW * row as f64 + 8.0;
            let swatch = [(x, y), (x + SWATCH - 12.0, y)];
            svg.push_str(&path(&swatch, line.look));
            svg.push_str(&marker((x + (SWATCH - 12.0) / 2.0, y), line.look));
            let _ = writeln!(
                svg,
                "<text class=\"legend\" x=\"{:.1}\" y=\"{:.1}\">{}</text>",
                x + SWATCH - 4.0,
                y + 4.5,
                escape(&line.name)
            );
            x += width;
        }
        (svg, row + usize::from(!self.lines.is_empty()))
    }
}

/// The frame, its grid and the numbers at it.
fn frame(x: &Scale, y: &Scale) -> String {
    let mut svg = String::new();
    let (bottom, right) = (HEIGHT - BOTTOM, WIDTH - RIGHT);
    for (at, text) in x.ticks() {
        let _ = writeln!(
            svg,
            "<path class=\"grid\" d=\"M{at:.1} {TOP}V{bottom}\"/>\
             <text class=\"tick\" x=\"{at:.1}\" y=\"{:.1}\" text-anchor=\"middle\">{}</text>",
            bottom + 18.0,
            escape(&text)
        );
    }
    for (at, text) in y.ticks() {
        let _ = writeln!(
            svg,
            "<path class=\"grid\" d=\"M{LEFT} {at:.1}H{right}\"/>\
             <text class=\"tick\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            LEFT - 8.0,
            at + 4.5,
            escape(&text)
        );
    }
    let _ = writeln!(svg, "<path class=\"frame\" d=\"M{LEFT} {TOP}V{bottom}H{right}\"/>");
    svg
}

fn drawn(line: &Line, x: &Scale, y: &Scale) -> String {
    let places: Vec<(f64, f64)> = line.points.iter().map(|p| (x.place(p.0), y.place(p.1))).collect();
    let mut svg = path(&places, line.look);
    for &place in &places {
        svg.push_str(&marker(place, line.look));
    }
    svg
}

fn path(places: &[(f64, f64)], look: Look) -> String {
    if look.dash == Dash::None {
        return String::new();
    }
    let mut d = String::new();
    for (i, (x, y)) in places.iter().enumerate() {
        let _ = write!(d, "{}{x:.1} {y:.1}", if i == 0 { 'M' } else { 'L' });
    }
    let dash = match look.dash {
        Dash::Solid | Dash::None => "",
        Dash::Broken => " stroke-dasharray=\"8 5\"",
        Dash::Dotted => " stroke-dasharray=\"2 4\"",
    };
    let width = if look.color.is_some() { 2.0 } else { 1.2 };
    format!("<path fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\"{dash} d=\"{d}\"/>\n", look.stroke())
}

fn marker((x, y): (f64, f64), look: Look) -> String {
    if look.color.is_none() {
        return String::new();
    }
    let color = look.stroke();
    let shape = |d: String| format!("<path fill=\"{color}\" d=\"{d}\"/>\n");
    match look.marker {
        Marker::Disc => format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"{color}\"/>\n"),
        Marker::Ring => format!(
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"var(--paper)\" stroke=\"{color}\" stroke-width=\"1.8\"/>\n"
        ),
        Marker::Square => shape(format!("M{:.1} {:.1}h7.4v7.4h-7.4z", x - 3.7, y - 3.7)),
        Marker::Triangle => shape(format!("M{x:.1} {:.1}l4.8 8.4h-9.6z", y - 5.2)),
        Marker::Diamond => shape(format!("M{x:.1} {:.1}l5.2 5.2l-5.2 5.2l-5.2 -5.2z", y - 5.2)),
        Marker::Cross => format!(
            "<path stroke=\"{color}\" stroke-width=\"2\" d=\"M{0:.1} {1:.1}l8 8m-8 0l8 -8\"/>\n",
            x - 4.0,
            y - 4.0
        ),
    }
}

/// A power of N as text: `N¹·⁹⁸`.
pub(crate) fn power_of_n(exponent: f64) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '.' => '·',
        digit => digit
            .to_digit(10)
            .map_or(digit, |d| ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][d as usize]),
    };
    format!("N{}", format!("{exponent:.2}").chars().map(raised).collect::<String>())
}

/// Text inside an element or attribute.
pub(crate) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(points: Vec<(f64, f64)>) -> String {
        let line = Line { name: "a < b".into(), points, look: Look::new(1, Dash::Broken, Marker::Square) };
        let (x, y) = (Axis::logarithmic("N"), Axis::linear("time / s"));
        Chart { title: "Two".into(), x, y, lines: vec![line] }.svg()
    }

    #[test]
    fn every_point_that_can_be_shown_has_its_marker_and_texts_are_escaped() {
        let svg = chart(vec![(128.0, 1.0), (256.0, 2.0), (0.0, 3.0), (512.0, f64::NAN)]);
        // Two of the points and one in the legend.
        assert_eq!(svg.matches("h7.4v7.4").count(), 3);
        assert!(svg.contains("a &lt; b") && svg.contains("stroke-dasharray"));
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }

    #[test]
    fn a_chart_without_points_is_still_a_chart() {
        assert!(chart(Vec::new()).contains("</svg>"));
    }
}
