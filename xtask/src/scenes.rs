//! Scenes by file or name.

use std::path::Path;

use anyhow::{Context, Result};
use brt_formats::{Limits, load};
use brt_image::Transfer;
use brt_procedural as procedural;
use brt_render::{KeptRows, Layer, LayerRows, RayOrder, Rows, Run, Settings, Stats, render};
use brt_scene::{CheckedScene, Scene};

/// The seed scenes.
pub(crate) const SEED: [&str; 3] = ["scenes/seed/a.toml", "scenes/seed/b.toml", "scenes/seed/c.toml"];

/// A scene file, or a procedural scene of that name at its usual size.
pub(crate) fn open(name: &str) -> Result<Scene> {
    open_sized(name, None)
}

/// The same at a size, which only procedural scenes can choose.
pub(crate) fn open_sized(name: &str, size: Option<u32>) -> Result<Scene> {
    match procedural::find(name) {
        Some(scene) => scene.build(size).with_context(|| format!("cannot build {name}")),
        None => Ok(load(Path::new(name), &Limits::default())
            .with_context(|| format!("cannot read {name}"))?
            .scene
            .into_inner()),
    }
}

/// The scene, if it can be rendered.
pub(crate) fn fit(scene: &Scene) -> Result<CheckedScene> {
    scene.clone().checked().map_err(|problems| anyhow::anyhow!("{}", problems[0]))
}

/// Renders a scene into memory, joined to whole layers; full ray tracing ray by ray, so that it shares no lookup with what
/// is held against it.
pub(crate) fn render_whole(scene: &Scene, settings: &Settings) -> Result<(Vec<[f32; 3]>, Vec<Rows>, Stats)> {
    render_stored(scene, settings, Transfer::Srgb)
}

/// The same for a picture that is stored with a transfer function.
pub(crate) fn render_stored(
    scene: &Scene,
    settings: &Settings,
    transfer: Transfer,
) -> Result<(Vec<[f32; 3]>, Vec<Rows>, Stats)> {
    let mut kept = KeptRows::new(transfer);
    let scene = fit(scene)?;
    let stats = render(&scene, settings, &Run { rays: RayOrder::Single, ..Run::default() }, &mut kept)?;
    let colors = kept.rows.iter().flat_map(|r| r.colors.iter().copied()).collect();
    Ok((colors, kept.rows, stats))
}

/// Settings of a square picture with some layers.
pub(crate) fn square(size: u32, layers: &[Layer]) -> Settings {
    Settings { layers: layers.to_vec(), ..Settings::new([size, size]) }
}

/// One layer of all rows.
pub(crate) fn layer<T: Clone>(
    rows: &[Rows],
    index: usize,
    take: impl Fn(&LayerRows) -> Option<&Vec<T>>,
) -> Vec<T> {
    rows.iter().filter_map(|r| take(&r.layers[index])).flatten().cloned().collect()
}
