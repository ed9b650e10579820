//! Writes a scene in our own format, so that reading it gives exactly the same scene.

mod files;
mod mesh;
mod texture;

use std::collections::HashSet;
use std::fmt::Write as _;

use brt_geometry::Vec3;
use brt_image::Rgb;
use brt_scene::{Axis, Camera, Highlight, Light, Material, Object, Projection, Scene, Shape};

use crate::write::numerals::{joined, number};
use files::Outside;
use mesh::SharedMeshes;
use texture::InlinePictures;

pub(super) use files::write_beside;

/// The scene as text in our own format.
///
/// For every scene whose check finds nothing, reading the text gives an equal scene; only materials that share
/// their name with an earlier one are renamed. Pictures stand in the text, too.
pub fn write_toml(scene: &Scene) -> String {
    let mut out = Writer::default();
    out.scene(scene);
    out.text
}

/// The text under construction.
#[derive(Default)]
pub(super) struct Writer<'w> {
    pub(super) text: String,
    /// Where large things go, if not into the text.
    pub(super) outside: Option<Outside<'w>>,
    pub(super) pictures: InlinePictures,
}

impl Writer<'_> {
    pub(super) fn scene(&mut self, scene: &Scene) {
        if let Some([width, height]) = scene.size {
            self.field("size", &format!("[{width}, {height}]"));
        }
        self.field("max_depth", &scene.max_depth.to_string());
        self.field("background", &color(scene.background));
        self.camera(&scene.camera);
        for light in &scene.lights {
            self.light(light);
        }
        let names = unique_names(&scene.materials);
        for (material, name) in scene.materials.iter().zip(&names) {
            self.material(material, name);
        }
        let meshes = SharedMeshes::write(scene, self);
        for object in &scene.objects {
            let material = names.get(object.material.0 as usize).map_or("", String::as_str);
            self.object(object, material, &meshes);
        }
    }

    pub(super) fn header(&mut self, header: &str) {
        self.text.push('\n');
        self.text.push_str(header);
        self.text.push('\n');
    }

    pub(super) fn field(&mut self, key: &str, value: &str) {
        for part in [key, " = ", value, "\n"] {
            self.text.push_str(part);
        }
    }

    fn camera(&mut self, camera: &Camera) {
        self.header("[camera]");
        self.field("eye", &vector(camera.eye));
        self.field("look_at", &vector(camera.look_at));
        self.field("up", &vector(camera.up));
        match camera.projection {
            Projection::Perspective { fov_deg } => self.field("fov_deg", &number(fov_deg)),
            Projection::Orthographic { extent } => {
                self.field("projection", "\"orthographic\"");
                self.field("extent", &number(extent));
            }
        }
    }

    fn light(&mut self, light: &Light) {
        self.header("[[light]]");
        match light {
            Light::Point { position, color: c } => {
                self.field("type", "\"point\"");
                self.field("position", &vector(*position));
                self.field("color", &color(*c));
            }
            Light::Spot { position, direction, color: c, inner_deg, outer_deg } => {
                self.field("type", "\"spot\"");
                self.field("position", &vector(*position));
                self.field("direction", &vector(*direction));
                self.field("color", &color(*c));
                self.field("inner_deg", &number(*inner_deg));
                self.field("outer_deg", &number(*outer_deg));
            }
            Light::Directional { direction, color: c } => {
                self.field("type", "\"directional\"");
                self.field("direction", &vector(*direction));
                self.field("color", &color(*c));
            }
        }
    }

    fn material(&mut self, material: &Material, name: &str) {
        self.header(&format!("[materials.{}]", key(name)));
        self.field("color", &color(material.color));
        if let Some(checker) = &material.checker {
            let axis = match checker.axis {
                Axis::X => "x",
                Axis::Y => "y",
                Axis::Z => "z",
            };
            let (second, size) = (color(checker.color), number(checker.size));
            self.field("checker", &format!("{{ color = {second}, size = {size}, axis = \"{axis}\" }}"));
        }
        self.field("ambient", &number(material.ambient));
        self.field("diffuse", &number(material.diffuse));
        self.field("specular", &number(material.specular));
        self.field("exponent", &number(material.exponent));
        self.field(
            "highlight",
            match material.highlight {
                Highlight::Phong => "\"phong\"",
                Highlight::Blinn => "\"blinn\"",
            },
        );
        self.field("reflection", &number(material.reflection));
        self.field("transmission", &number(material.transmission));
        self.field("index_of_refraction", &number(material.index_of_refraction));
        self.field("casts_shadow", &material.casts_shadow.to_string());
        if material.emission != Rgb::BLACK {
            self.field("emission", &color(material.emission));
        }
        if material.opacity != 1.0 {
            self.field("opacity", &number(material.opacity));
        }
        if let Some(texture) = &material.texture {
            self.texture(texture);
        }
    }

    fn object(&mut self, object: &Object, material: &str, meshes: &SharedMeshes) {
        self.header("[[object]]");
        self.field("type", &quoted(object.shape.kind()));
        if let Some(name) = &object.name {
            self.field("name", &quoted(name));
        }
        self.field("material", &quoted(material));
        match &object.shape {
            Shape::Mesh(mesh) => meshes.object(object, mesh, self),
            shape => self.shape(shape),
        }
    }

    fn shape(&mut self, shape: &Shape) {
        match shape {
            Shape::Sphere { center, radius } => {
                self.field("center", &vector(*center));
                self.field("radius", &number(*radius));
            }
            Shape::Plane { normal, distance } => {
                self.field("normal", &vector(*normal));
                self.field("distance", &number(*distance));
            }
            Shape::Polygon { outline, holes } => self.polygon(outline, holes),
            Shape::Disc { center, normal, radius } => {
                self.field("center", &vector(*center));
                self.field("normal", &vector(*normal));
                self.field("radius", &number(*radius));
            }
            Shape::Cylinder { base, top, radius, capped } => {
                self.field("base", &vector(*base));
                self.field("top", &vector(*top));
                self.field("radius", &number(*radius));
                self.field("capped", &capped.to_string());
            }
            Shape::Cone { base, base_radius, top, top_radius, capped } => {
                self.field("base", &vector(*base));
                self.field("base_radius", &number(*base_radius));
                self.field("top", &vector(*top));
                self.field("top_radius", &number(*top_radius));
                self.field("capped", &capped.to_string());
            }
            // Written with what objects share.
            Shape::Mesh(_) => {}
        }
    }

    fn polygon(&mut self, outline: &[Vec3], holes: &[Vec<Vec3>]) {
        self.text.push_str("outline = ");
        self.list(outline, |out, p| push_vector(out, *p));
        self.text.push('\n');
        if !holes.is_empty() {
            self.text.push_str("holes = [\n");
            for hole in holes {
                self.list(hole, |out, p| push_vector(out, *p));
                self.text.push_str(",\n");
            }
            self.text.push_str("]\n");
        }
    }

    /// A list on one line where it is short, else several items a line.
    pub(super) fn list<T>(&mut self, items: &[T], item: impl Fn(&mut String, &T)) {
        const A_LINE: usize = 5;
        let long = items.len() > A_LINE;
        self.text.push('[');
        for (i, value) in items.iter().enumerate() {
            if long && i % A_LINE == 0 {
                self.text.push_str("\n    ");
            }
            item(&mut self.text, value);
            if long && i % A_LINE == A_LINE - 1 {
                self.text.push(',');
            } else if long || i + 1 < items.len() {
                self.text.push_str(", ");
            }
        }
        if long {
            self.text.truncate(self.text.trim_end().len());
            self.text.push('\n');
        }
        self.text.push(']');
    }
}

/// Names of the materials, each made different from those before it.
fn unique_names(materials: &[Material]) -> Vec<String> {
    let mut taken: HashSet<String> = materials.iter().map(|m| m.name.clone()).collect();
    let mut seen = HashSet::new();
    let mut unique = |material: &Material| {
        if seen.insert(material.name.clone()) {
            return material.name.clone();
        }
        let mut numbered = (2_u64..).map(|n| format!("{} {n}", material.name));
        let name = numbered.find(|name| !taken.contains(name)).unwrap_or_default();
        taken.insert(name.clone());
        name
    };
    materials.iter().map(&mut unique).collect()
}

pub(super) fn push(out: &mut String, text: std::fmt::Arguments) {
    // Writing to a text cannot fail.
    let _ = out.write_fmt(text);
}

pub(super) fn push_vector(out: &mut String, v: Vec3) {
    push(out, format_args!("[{}]", joined(v, ", ")));
}

fn vector(v: Vec3) -> String {
    let mut out = String::new();
    push_vector(&mut out, v);
    out
}

pub(super) fn color(c: Rgb) -> String {
    vector(<[f64; 3]>::from(c).into())
}

fn key(name: &str) -> String {
    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !name.is_empty() && name.chars().all(bare) { name.to_owned() } else { quoted(name) }
}

/// A basic string of TOML.
pub(super) fn quoted(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\r' => out.push_str("\\r"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() => push(&mut out, format_args!("\\u{:04X}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
