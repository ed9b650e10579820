//! Pictures in memory, and where two of them differ.

use std::fmt;

use brt_formats::write_toml;
use brt_image::Transfer;
use brt_render::{
    Certificate, KeptRows, LayerRows, RayHistory, Renderer, Rows, Run, SampleState, Settings, Stats, Window,
    render,
};
use brt_scene::{CheckedScene, Scene};

/// A picture with the layers that were asked for; the others are empty.
#[derive(Clone, Debug, Default)]
pub struct Rendered {
    /// Width and height.
    pub size: [u32; 2],
    /// Linear RGB, row by row.
    pub colors: Vec<[f32; 3]>,
    /// How much of each pixel is covered, if the backdrop is transparent.
    pub alpha: Vec<f32>,
    /// The same by full ray tracing, if the settings ask for it.
    pub full: Vec<[f32; 3]>,
    /// Alpha by full ray tracing, if there are both.
    pub full_alpha: Vec<f32>,
    /// Surfaces, `u32::MAX` for the background.
    pub surface: Vec<u32>,
    /// Depths, infinite for the background.
    pub depth: Vec<f32>,
    /// Shading normals.
    pub normal: Vec<[f32; 3]>,
    /// Ray histories.
    pub history: Vec<RayHistory>,
    /// States.
    pub state: Vec<SampleState>,
    /// Certificates that failed.
    pub certificates: Vec<Option<Certificate>>,
    /// Counts.
    pub stats: Stats,
}

/// The scene, which must be fit to be rendered.
///
/// # Panics
/// If it is not.
pub fn checked(scene: &Scene) -> CheckedScene {
    match scene.clone().checked() {
        Ok(scene) => scene,
        Err(problems) => panic!("not fit to be rendered: {problems:?}"),
    }
}

/// Renders a picture of a scene that is fit to be rendered.
pub fn render_to_image(scene: &Scene, settings: &Settings, run: &Run) -> (Vec<[f32; 3]>, Stats) {
    let rendered = render_with_layers(scene, settings, run);
    (rendered.colors, rendered.stats)
}

/// Renders a picture with its layers, to be stored as sRGB.
///
/// # Panics
/// See [`render_stored`].
pub fn render_with_layers(scene: &Scene, settings: &Settings, run: &Run) -> Rendered {
    render_stored(scene, settings, run, Transfer::Srgb)
}

/// Renders a picture with its layers, to be stored with a transfer function.
///
/// # Panics
/// If the renderer fails, or rows come out of order, twice or not at all.
pub fn render_stored(scene: &Scene, settings: &Settings, run: &Run, transfer: Transfer) -> Rendered {
    let mut kept = KeptRows::new(transfer);
    let stats = match render(&checked(scene), settings, run, &mut kept) {
        Ok(stats) => stats,
        Err(error) => panic!("no picture: {error}"),
    };
    Rendered::of(kept.rows, settings.size.map(|side| side as u32), stats)
}

/// Renders a window of the picture that the scene's camera takes, with its layers, to be stored as sRGB.
///
/// # Panics
/// See [`render_stored`].
pub fn render_window(renderer: &Renderer, window: Window, settings: &Settings, run: &Run) -> Rendered {
    let mut rows: Vec<Rows> = Vec::new();
    match renderer.render(&renderer.scene().camera, window, settings, run, &mut rows) {
        Ok(stats) => Rendered::of(rows, [window.width, window.height], stats),
        Err(error) => panic!("no picture: {error}"),
    }
}

impl Rendered {
    /// Joins rows, which must be all and in order.
    fn of(kept: Vec<Rows>, size: [u32; 2], stats: Stats) -> Self {
        let mut picture = Self { size, stats, ..Self::default() };
        let mut next = 0;
        for rows in kept {
            assert_eq!(rows.first, next, "rows out of order");
            assert_eq!(rows.width, size[0]);
            next += rows.count();
            picture.colors.extend(&rows.colors);
            picture.alpha.extend(rows.alpha.iter().flatten());
            picture.full.extend(rows.full.iter().flatten());
            picture.full_alpha.extend(rows.full_alpha.iter().flatten());
            rows.layers.iter().for_each(|layer| picture.append(layer));
        }
        assert_eq!(next, size[1], "rows are missing");
        picture
    }

    /// A part of it; counts are those of the whole.
    #[must_use]
    pub fn cropped(&self, x: u32, y: u32, [width, height]: [u32; 2]) -> Self {
        fn part<T: Copy>(values: &[T], rows: &[std::ops::Range<usize>]) -> Vec<T> {
            if values.is_empty() {
                return Vec::new();
            }
            rows.iter().flat_map(|row| values[row.clone()].iter().copied()).collect()
        }
        let row = |row: u32| self.index(x, y + row)..self.index(x, y + row) + width as usize;
        let rows: Vec<_> = (0..height).map(row).collect();
        Self {
            size: [width, height],
            colors: part(&self.colors, &rows),
            alpha: part(&self.alpha, &rows),
            full: part(&self.full, &rows),
            full_alpha: part(&self.full_alpha, &rows),
            surface: part(&self.surface, &rows),
            depth: part(&self.depth, &rows),
            normal: part(&self.normal, &rows),
            history: part(&self.history, &rows),
            state: part(&self.state, &rows),
            certificates: part(&self.certificates, &rows),
            stats: self.stats,
        }
    }

    /// The first pixel of the picture or of a layer that differs in any bit.
    pub fn first_difference(&self, actual: &Self) -> Option<Difference> {
        let size = self.size;
        first_difference(size, &self.colors, &actual.colors)
            .or_else(|| first_difference(size, &self.alpha, &actual.alpha))
            .or_else(|| first_difference(size, &self.full, &actual.full))
            .or_else(|| first_difference(size, &self.full_alpha, &actual.full_alpha))
            .or_else(|| first_difference(size, &self.surface, &actual.surface))
            .or_else(|| first_difference(size, &self.depth, &actual.depth))
            .or_else(|| first_difference(size, &self.normal, &actual.normal))
            .or_else(|| first_difference(size, &self.history, &actual.history))
            .or_else(|| first_difference(size, &self.state, &actual.state))
            .or_else(|| first_difference(size, &self.certificates, &actual.certificates))
    }

    fn append(&mut self, layer: &LayerRows) {
        match layer {
            LayerRows::Surface(rows) => self.surface.extend(rows),
            LayerRows::Depth(rows) => self.depth.extend(rows),
            LayerRows::Normal(rows) => self.normal.extend(rows),
            LayerRows::History(rows) => self.history.extend(rows),
            LayerRows::State(rows) => self.state.extend(rows),
            LayerRows::Certificates(rows) => self.certificates.extend(rows),
        }
    }

    /// The position of a pixel in the vectors.
    pub fn index(&self, x: u32, y: u32) -> usize {
        (y * self.size[0] + x) as usize
    }
}

/// The first pixel at which two pictures differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Column and row.
    pub pixel: [u32; 2],
    /// What should be there.
    pub expected: String,
    /// What is there.
    pub actual: String,
    /// Number of pixels that differ.
    pub count: usize,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { pixel: [x, y], expected, actual, count } = self;
        write!(f, "pixel {x},{y} is {actual}, expected {expected} ({count} pixels differ)")
    }
}

/// Values that are the same only if all their bits are.
pub trait SameBits: fmt::Debug {
    /// Are all bits the same?
    fn same_bits(&self, other: &Self) -> bool;
}

impl SameBits for f32 {
    fn same_bits(&self, other: &Self) -> bool {
        self.to_bits() == other.to_bits()
    }
}

impl SameBits for [f32; 3] {
    fn same_bits(&self, other: &Self) -> bool {
        self.map(f32::to_bits) == other.map(f32::to_bits)
    }
}

impl SameBits for u32 {
    fn same_bits(&self, other: &Self) -> bool {
        self == other
    }
}

impl SameBits for RayHistory {
    fn same_bits(&self, other: &Self) -> bool {
        self == other
    }
}

impl SameBits for Option<Certificate> {
    fn same_bits(&self, other: &Self) -> bool {
        self == other
    }
}

impl SameBits for SampleState {
    fn same_bits(&self, other: &Self) -> bool {
        self == other
    }
}

/// Where two layers or pictures of one size differ first.
///
/// # Panics
/// If they are not of one size.
pub fn first_difference<T: SameBits>(
    size: [impl Into<u64>; 2],
    expected: &[T],
    actual: &[T],
) -> Option<Difference> {
    let [width, _] = size.map(Into::into);
    assert_eq!(expected.len(), actual.len(), "pictures of two sizes");
    let mut differing = (0..expected.len()).filter(|&i| !expected[i].same_bits(&actual[i]));
    let first = differing.next()?;
    Some(Difference {
        pixel: [first as u64 % width, first as u64 / width].map(|place| place as u32),
        expected: format!("{:?}", expected[first]),
        actual: format!("{:?}", actual[first]),
        count: 1 + differing.count(),
    })
}

/// How to see a difference again: the command, and the scene if it is not long.
pub fn replay_hint(scene: &Scene, settings: &Settings, difference: &Difference) -> String {
    const LONGEST: usize = 20_000;
    let ([width, height], [x, y]) = (settings.size, difference.pixel);
    let method = settings.method.name();
    let samples = settings.samples.per_pixel();
    let text = write_toml(scene);
    let text = if text.len() > LONGEST { "(a long scene)" } else { &text };
    format!(
        "{difference}\nreplay: brt render scene.toml --size {width}x{height} --samples {samples} \
         --method {method} --pixel {x},{y}\nwith {settings:?}\nscene.toml:\n{text}"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_difference_is_found_with_its_pixel_and_number() {
        let a = [[0.0_f32; 3], [f32::NAN; 3], [1.0; 3], [2.0; 3]];
        let mut b = a;
        assert_eq!(first_difference([2_u32; 2], &a, &b), None);
        (b[2][1], b[3][0]) = (f32::from_bits(1.0_f32.to_bits() + 1), -2.0);
        let difference = first_difference([2_u32; 2], &a, &b).unwrap();
        assert_eq!((difference.pixel, difference.count), ([0, 1], 2));
        // −0 and 0 are two values.
        assert!(first_difference([1_u32; 2], &[0.0], &[-0.0]).is_some());
    }
}
