//! Border Ray Tracing: stills whose cost grows with the borders in the picture, not with its pixels.
//!
//! This is the front door: it names what users of the library need, and renders scenes to files. A tour:
//!
//! **1. A scene** is plain data ([`Scene`], [`Camera`], [`Light`], [`Material`], [`Object`], [`Shape`]). It is read
//! from a file ([`load`], [`parse`]), taken from the [`library`], or built in code.
//!
//! ```
//! use brt::*;
//!
//! let mut scene = Scene::new(Camera {
//!     eye: vec3(0.0, 2.0, 8.0),
//!     look_at: vec3(0.0, 1.0, 0.0),
//!     up: vec3(0.0, 1.0, 0.0),
//!     projection: Projection::Perspective { fov_deg: 40.0 },
//! });
//! scene.lights.push(Light::Directional { direction: vec3(1.0, -2.0, -1.0), color: Rgb::WHITE });
//! let clay = scene.add_material(Material::matte("clay", rgb(0.9, 0.35, 0.2)));
//! scene.add(Shape::Sphere { center: vec3(0.0, 1.0, 0.0), radius: 1.0 }, clay);
//! let scene = scene.checked().expect("a scene without faults");
//!
//! // **2. Settings** say what is rendered, a [`Run`] how. Nothing in a run changes a byte of the picture.
//! let settings = Settings { method: Method::Border(BorderSettings::default()), ..Settings::new([64, 64]) };
//! let run = Run { threads: 1, ..Run::default() };
//!
//! // **3. Rows** stream to a [`Sink`], here to memory.
//! let mut rows: Vec<Rows> = Vec::new();
//! let stats = render(&scene, &settings, &run, &mut rows)?;
//! assert_eq!(stats.pixels.total, 64 * 64);
//! assert!(stats.pixels.traced < stats.pixels.total / 2);
//!
//! // **4. Files** appear only when complete, with their layers beside them.
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("clay.png");
//! let output = Output { layers: vec![PictureLayer::State], ..Output::to_file(&path)? };
//! render_to_files(&scene, &settings, &run, &output)?;
//!
//! // **5. Comparison** is in levels of 255 of the stored values.
//! let picture = image::read_picture(&path, image::PictureLimits::default())?;
//! assert_eq!(image::compare(&picture, &picture)?.max_error, 0.0);
//! assert!(folder.path().join("clay.state.png").exists());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The crates behind it are open as [`geometry`], [`image`], [`scene`], [`formats`] and [`rendering`].

mod files;
mod layer_paint;
mod layers;
pub mod library;
mod measure;
mod output;
mod picture_files;

pub use files::{RenderFilesError, Rendered, render_into, render_to_files};
pub use layers::PictureLayer;
pub use measure::Verification;
pub use output::{Output, OutputError};

pub use brt_formats as formats;
pub use brt_geometry as geometry;
pub use brt_image as image;
pub use brt_render as rendering;
pub use brt_scene as scene;
pub use brt_scene::framing;

pub use brt_formats::{
    FileBeside, Format, Given, Imported, Limits, LoadError, Loaded, Written, import, load, load_as, parse,
    write, write_beside, write_toml,
};
pub use brt_geometry::{SimdLevel, Vec3, vec3};
pub use brt_image::{
    BitDepth, Channels, Comparison, Compression, Encoding, FileSet, PictureFormat, PictureSize, Rgb, Target,
    Transfer, rgb,
};
pub use brt_render::{
    Accelerator, Backdrop, BorderSettings, Certificate, CertificateCounts, CertifiedSettings, CheckedPixels,
    DeviationDelta, DifferenceDelta, Filter, HistoryKind, Judge, KeptRows, Layer, LayerRows, Method,
    PencilSettings, PixelSelectedSettings, Progress, RayHistory, RayOrder, Regions, RenderError, Renderer,
    Rows, Run, SampleState, Samples, Settings, Sink, SinkError, Stats, Tries, VarianceDelta, Window, render,
    thread_pool,
};
pub use brt_scene::{
    Camera, CheckedScene, Diagnostic, Light, Material, MaterialId, Mesh, Object, Projection, Report, Scene,
    Severity, Shape,
};
