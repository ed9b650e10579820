//! Meshes of our own format: one that several objects share has a table of its own.

use std::collections::HashMap;
use std::sync::Arc;

use brt_geometry::Affine;
use brt_scene::{Mesh, Object, Scene, Shape};

use super::files::is_large;
use super::{Writer, color, push, push_vector, quoted};
use crate::write::numerals::number;

/// Names of the meshes that more than one object has, by their place in memory.
pub(super) struct SharedMeshes(HashMap<*const Mesh, String>);

impl SharedMeshes {
    /// Writes their tables, in the order of the objects.
    pub(super) fn write(scene: &Scene, out: &mut Writer) -> Self {
        let meshes = || {
            scene.objects.iter().filter_map(|object| match &object.shape {
                Shape::Mesh(mesh) => Some(mesh),
                _ => None,
            })
        };
        let mut uses: HashMap<*const Mesh, u32> = HashMap::new();
        meshes().for_each(|mesh| *uses.entry(Arc::as_ptr(mesh)).or_default() += 1);
        let mut names = HashMap::new();
        for mesh in meshes() {
            let at = Arc::as_ptr(mesh);
            let is_outside = out.outside.is_some() && is_large(mesh);
            if uses[&at] > 1 && !is_outside && !names.contains_key(&at) {
                let name = format!("m{}", names.len() + 1);
                out.header(&format!("[meshes.{name}]"));
                out.mesh(mesh);
                names.insert(at, name);
            }
        }
        Self(names)
    }

    /// The shape's fields of an object that is a mesh.
    pub(super) fn object(&self, object: &Object, mesh: &Arc<Mesh>, out: &mut Writer) {
        if object.transform != Affine::IDENTITY {
            let row = |[a, b, c, d]: [f64; 4]| {
                format!("[{}, {}, {}, {}]", number(a), number(b), number(c), number(d))
            };
            out.field("transform", &format!("[{}]", object.transform.rows().map(row).join(", ")));
        }
        let file = out.outside.as_mut().and_then(|outside| outside.mesh(mesh, object.name.as_deref()));
        match (file, self.0.get(&Arc::as_ptr(mesh))) {
            (Some(file), _) => out.field("import", &quoted(&file)),
            (None, Some(name)) => out.field("mesh", &format!("\"{name}\"")),
            (None, None) => out.mesh(mesh),
        }
    }
}

impl Writer<'_> {
    fn mesh(&mut self, mesh: &Mesh) {
        self.named_list("positions", &mesh.positions, |out, p| push_vector(out, *p));
        if !mesh.normals.is_empty() {
            self.named_list("normals", &mesh.normals, |out, n| push_vector(out, *n));
        }
        if !mesh.colors.is_empty() {
            self.named_list("colors", &mesh.colors, |out, c| out.push_str(&color(*c)));
        }
        if !mesh.texcoords.is_empty() {
            let pair = |out: &mut String, [u, v]: &[f64; 2]| {
                push(out, format_args!("[{}, {}]", number(*u), number(*v)));
            };
            self.named_list("texcoords", &mesh.texcoords, pair);
        }
        let triple = |out: &mut String, [a, b, c]: &[u32; 3]| push(out, format_args!("[{a}, {b}, {c}]"));
        self.named_list("triangles", &mesh.triangles, triple);
    }

    fn named_list<T>(&mut self, name: &str, items: &[T], item: impl Fn(&mut String, &T)) {
        self.text.push_str(name);
        self.text.push_str(" = ");
        self.list(items, item);
        self.text.push('\n');
    }
}
