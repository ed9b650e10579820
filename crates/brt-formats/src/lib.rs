//! Scene files: bytes in, a [`Scene`](brt_scene::Scene) and a [`Report`](brt_scene::Report) out.
//!
//! What the next stage may rely on: a scene that this crate returns has passed
//! [`Scene::check`](brt_scene::Scene::check) without a finding. What a file says and we leave out or replace is a
//! warning in the report, with its place in the file. Reading is bounded by [`Limits`], never recurses without
//! bound, never panics, and prints nothing: whoever shows a report draws it over [`Loaded::text`].
//!
//! Scenes are written, too ([`write()`]): exactly in our own format, and for other ray tracers as well as they can show
//! them; what they cannot is a warning in the report.
//!
//! ```
//! use brt_formats::{Format, Limits, parse, write_toml};
//!
//! let text = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfov_deg = 45\n";
//! let (scene, report) = parse(Format::Toml, text.as_bytes(), &Limits::default()).unwrap();
//! assert!(report.diagnostics.is_empty());
//! assert_eq!(parse(Format::Toml, write_toml(&scene).as_bytes(), &Limits::default()).unwrap().0, scene);
//! ```

// What only the formats use that are left out.
#![cfg_attr(
    not(all(feature = "gltf", feature = "ply", feature = "threemf")),
    allow(dead_code, unused_imports)
)]

mod common;
mod import;
mod load;
mod read;
mod write;

pub use common::{Foreign, Format, LimitExceeded, Limits, LoadError, OnlyRead, ParseError};
pub use import::{Given, Imported};
pub use load::{Loaded, import, load, load_as, parse};
pub use write::{FileBeside, Written, write, write_beside, write_toml};
