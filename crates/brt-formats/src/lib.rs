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

mod budget;
mod dat;
mod error;
mod foreign;
mod format;
mod gltf;
mod import;
mod limits;
mod load;
mod losses;
mod machine;
mod meshes;
mod nff;
mod numerals;
mod obj;
mod off;
mod ply;
mod pov;
mod problems;
mod stl;
mod threemf;
mod toml;
mod view;
mod vrml;
mod words;
mod write;

pub use error::{LimitExceeded, LoadError, OnlyRead, ParseError};
pub use foreign::Foreign;
pub use format::Format;
pub use limits::Limits;
pub use load::{Given, Imported, Loaded, import, load, load_as, parse};
pub use toml::write_toml;
pub use write::{FileBeside, Written, write, write_beside};
