//! Elements of a PLY file as the parser fills them.

use brt_image::Rgb;
use ply_rs_bw::ply::{Property, PropertyAccess, PropertyAccessResult};

use crate::import::srgb;

/// An element that is read over.
pub(super) struct Ignored;

impl PropertyAccess for Ignored {
    fn new() -> Self {
        Self
    }
}

/// A point.
#[derive(Default)]
pub(super) struct Vertex {
    pub(super) position: [f64; 3],
    pub(super) normal: [f64; 3],
    pub(super) texcoord: [f64; 2],
    /// From 0 to 1, usually sRGB.
    color: [f64; 3],
}

impl Vertex {
    pub(super) fn color(&self) -> Rgb {
        srgb(self.color)
    }

    /// The colour of a file that stores light.
    pub(super) fn light(&self) -> Rgb {
        self.color.into()
    }
}

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        let Self { position: [x, y, z], normal: [nx, ny, nz], color: [r, g, b], texcoord: [s, t] } = self;
        let (target, is_color) = match name {
            "x" => (x, false),
            "y" => (y, false),
            "z" => (z, false),
            "nx" => (nx, false),
            "ny" => (ny, false),
            "nz" => (nz, false),
            "s" | "u" | "texture_u" => (s, false),
            "t" | "v" | "texture_v" => (t, false),
            "red" => (r, true),
            "green" => (g, true),
            "blue" => (b, true),
            _ => return PropertyAccessResult::Ignored,
        };
        match number(&property, is_color) {
            Some(value) => *target = value,
            None => return PropertyAccessResult::UnsupportedType,
        }
        PropertyAccessResult::Set
    }
}

/// A face; indices may be negative in broken files.
#[derive(Default)]
pub(super) struct Face {
    pub(super) indices: Vec<i64>,
}

impl PropertyAccess for Face {
    fn new() -> Self {
        Self::default()
    }

    fn set_property(&mut self, name: &str, property: Property) -> PropertyAccessResult {
        if !matches!(name, "vertex_indices" | "vertex_index") {
            return PropertyAccessResult::Ignored;
        }
        self.indices = match property {
            Property::ListChar(list) => list.into_iter().map(i64::from).collect(),
            Property::ListUChar(list) => list.into_iter().map(i64::from).collect(),
            Property::ListShort(list) => list.into_iter().map(i64::from).collect(),
            Property::ListUShort(list) => list.into_iter().map(i64::from).collect(),
            Property::ListInt(list) => list.into_iter().map(i64::from).collect(),
            Property::ListUInt(list) => list.into_iter().map(i64::from).collect(),
            _ => return PropertyAccessResult::UnsupportedType,
        };
        PropertyAccessResult::Set
    }
}

/// A scalar; whole numbers that are colours are codes up to the greatest of their type.
fn number(property: &Property, is_color: bool) -> Option<f64> {
    let (value, greatest) = match property {
        Property::Char(v) => (f64::from(*v), 127.0),
        Property::UChar(v) => (f64::from(*v), 255.0),
        Property::Short(v) => (f64::from(*v), 255.0),
        Property::UShort(v) => (f64::from(*v), 65535.0),
        Property::Int(v) => (f64::from(*v), 255.0),
        Property::UInt(v) => (f64::from(*v), 255.0),
        Property::Float(v) => (f64::from(*v), 1.0),
        Property::Double(v) => (*v, 1.0),
        _ => return None,
    };
    Some(if is_color { value / greatest } else { value })
}
