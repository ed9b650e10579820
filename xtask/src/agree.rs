//! Does the perspective image show what rays meet first?

use anyhow::{Result, ensure};
use brt_procedural as procedural;
use brt_render::{
    Accelerator, BorderSettings, Layer, LayerRows, Method, PreparedCamera, Renderer, Run, SampleGrid,
    Samples, Settings,
};

use crate::scenes::{SEED, fit, layer, open, render_whole, square};

pub(crate) fn run(size: u32, names: &[String]) -> Result<()> {
    let all = SEED.into_iter().chain(procedural::ALL.iter().map(|p| p.name)).map(String::from);
    let names = if names.is_empty() { all.collect() } else { names.to_vec() };
    let mut differences = 0;
    for name in &names {
        let found = count_differences(name, size)?;
        println!("{name}: {} samples, {found} differences", u64::from(size) * u64::from(size));
        differences += found;
    }
    ensure!(differences == 0, "the perspective image differs from first hits on {differences} samples");
    Ok(())
}

fn count_differences(name: &str, size: u32) -> Result<u64> {
    let scene = open(name)?;
    let method = Method::Border(BorderSettings::default());
    let settings = Settings { method, ..square(size, &[Layer::Surface, Layer::Depth]) };
    let (_, rows, _) = render_whole(&scene, &settings)?;
    let surfaces = layer(&rows, 0, |l| if let LayerRows::Surface(v) = l { Some(v) } else { None });
    let depths = layer(&rows, 1, |l| if let LayerRows::Depth(v) = l { Some(v) } else { None });

    let renderer = Renderer::new(fit(&scene)?);
    let prepared = renderer.prepared(Accelerator::Bvh, &Run::default())?;
    let grid = SampleGrid::new([size, size], Samples::One);
    let camera = PreparedCamera::new(&scene.camera, prepared.origin(), &grid);
    let differs = |i: &u32| {
        let ray = camera.ray(f64::from(i % size), f64::from(i / size));
        let seen = prepared.first_seen(&ray);
        let expected = seen.map_or((u32::MAX, f32::INFINITY), |s| (s.surface, s.depth as f32));
        expected != (surfaces[*i as usize], depths[*i as usize])
    };
    Ok((0..size * size).filter(differs).count() as u64)
}
