//! `--pixel X,Y`: what is seen in one pixel.
//!
//! The pixel is rendered just as in the whole picture, so that whatever is odd about it shows again; of the rest, only the
//! tile that it lies in.

use std::fmt;

use brt::image::{PixelRows, straight};
use brt::{
    Certificate, CheckedScene, KeptRows, Layer, LayerRows, RenderError, Renderer, Rows, Run, SampleState,
    Settings, Transfer, Window,
};

use super::options::Options;
use crate::context::Context;
use crate::exit::{Failure, Outcome, wrong_use};
use crate::output;
use crate::progress::NoBar;

/// Prints what is seen in a pixel.
pub(super) fn show(
    options: &Options,
    context: &Context,
    scene: CheckedScene,
    mut settings: Settings,
    [x, y]: [u64; 2],
) -> Result<Outcome, Failure> {
    let [width, height] = settings.size;
    if x >= width || y >= height {
        return Err(wrong_use(format!("pixel {x},{y} is outside the picture of {width}×{height}")));
    }
    settings.layers = Layer::ALL.to_vec();
    let transfer = if options.linear { Transfer::Linear } else { Transfer::Srgb };
    let mut sink = KeptRows::new(transfer);
    let renderer = Renderer::new(scene);
    let run = Run { progress: Some(&NoBar), ..options.run(context) };
    let (camera, window) = (&renderer.scene().camera, Window::pixel(x, y));
    match renderer.render(camera, window, &settings, &run, &mut sink) {
        Ok(_) => {}
        Err(RenderError::Cancelled) => return Err(Failure::Interrupted),
        Err(error) => return Err(error.into()),
    }
    let found = sink.rows.pop().ok_or_else(|| anyhow::anyhow!("pixel {x},{y} was not rendered"))?;
    output::line(&format!("pixel    {x},{y} of {width}×{height} ×{}", settings.samples.per_pixel()))?;
    let surfaces = renderer.prepared(settings.accelerator, &run)?.surfaces();
    let object_of = |surface: u32| surfaces.get(surface as usize).map(|surface| surface.object);
    for line in describe(&found, renderer.scene(), object_of, transfer) {
        output::line(&line)?;
    }
    Ok(Outcome::Done)
}

/// `object_of` a surface, if there is one.
fn describe(
    found: &Rows,
    scene: &CheckedScene,
    object_of: impl Fn(u32) -> Option<usize>,
    transfer: Transfer,
) -> Vec<String> {
    let layer = |layer: &LayerRows| {
        Some(match layer {
            LayerRows::Surface(v) => format!("surface  {}", surface(v[0], scene, object_of(v[0]))),
            LayerRows::Depth(v) => format!("depth    {}", v[0]),
            LayerRows::Normal(v) => format!("normal   {}", triple(v[0])),
            LayerRows::History(v) => format!("history  {:016x}", v[0].0),
            LayerRows::State(v) => format!("state    {}", state(v[0])),
            LayerRows::Certificates(v) => format!("unproven {}", unproven(v[0]?)),
        })
    };
    let mut lines: Vec<String> = found.layers.iter().filter_map(layer).collect();
    let seen = covering(found.pixels());
    lines.push(format!("color    {}", color(seen.0, transfer)));
    lines.extend(found.alpha.iter().map(|_| format!("alpha    {}", seen.1)));
    if let Some(full) = found.full_pixels().map(covering) {
        lines.push(format!("full     {}", color(full.0, transfer)));
        lines.extend(found.full_alpha.iter().map(|_| format!("         alpha {}", full.1)));
        let level = |c: f32| 255.0 * transfer.encode(f64::from(c));
        let colors = seen.0.iter().zip(full.0).map(|(&a, b)| (level(a) - level(b)).abs());
        let alpha = 255.0 * f64::from(seen.1 - full.1).abs();
        lines.push(format!("error    {:.3} levels", colors.fold(alpha, f64::max)));
    }
    lines
}

/// The colour of what covers a single pixel, and its alpha.
fn covering(pixel: PixelRows) -> ([f32; 3], f32) {
    let alpha = pixel.alpha.map_or(1.0, |alpha| alpha[0]);
    (straight(pixel.colors[0], alpha), alpha)
}

fn surface(id: u32, scene: &CheckedScene, object: Option<usize>) -> String {
    let Some(index) = object else {
        return "none: the background".to_owned();
    };
    let Some(object) = scene.objects.get(index) else { return id.to_string() };
    let name = object.name.as_ref().map(|name| format!(" \"{name}\"")).unwrap_or_default();
    let material = scene.materials.get(object.material.0 as usize).map_or("", |m| m.name.as_str());
    format!("{id}, of object {index}: {}{name}, material \"{material}\"", object.shape.kind())
}

/// As the layer `certificates` calls it.
fn unproven(certificate: Certificate) -> &'static str {
    match certificate {
        Certificate::Color => "linear colour",
        Certificate::Size => "too few samples",
        others => others.name(),
    }
}

fn state(state: SampleState) -> &'static str {
    match state {
        SampleState::Traced => "traced",
        SampleState::Shaded => "shaded",
        SampleState::Filled => "filled",
        SampleState::Pending => "pending",
    }
}

fn color(linear: [f32; 3], transfer: Transfer) -> String {
    let mut codes = [0_u8; 3];
    transfer.quantize_8(&linear, &mut codes);
    format!("{} linear, {} of 255 stored", triple(linear), triple(codes))
}

fn triple<T: fmt::Display>([a, b, c]: [T; 3]) -> String {
    format!("{a} {b} {c}")
}
