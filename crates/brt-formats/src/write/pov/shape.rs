//! Shapes of POV-Ray.

use brt_geometry::Vec3;
use brt_scene::{Mesh, Object, Scene, Shape};

use super::{Writer, comment, number, vector};

const OPEN_GLASS: &str = "POV-Ray takes what a ray has entered from its path, we from the side of the surface; glass of open shapes differs";

const SMOOTH: &str = "POV-Ray lights smooth meshes where only the facet is turned away from the light; they differ a little there";

const COLORS: &str = "colours of points are left out";

impl Writer {
    pub(super) fn object(&mut self, object: &Object, scene: &Scene) {
        if let Some(name) = &object.name {
            self.line(format_args!("// {}", comment(name)));
        }
        let index = object.material.0;
        let material = &scene.materials[index as usize];
        let shadow = if material.casts_shadow { "" } else { " no_shadow" };
        if material.transmission > 0.0 && material.index_of_refraction != 1.0 && is_open(&object.shape) {
            self.losses.note_for(OPEN_GLASS, format!("material `{}`", material.name));
        }
        if matches!(&object.shape, Shape::Mesh(mesh) if !mesh.colors.is_empty()) {
            self.losses.note_for(COLORS, format!("material `{}`", material.name));
        }
        let shape = match &object.shape {
            Shape::Mesh(mesh) if mesh.triangles.is_empty() => return,
            Shape::Mesh(mesh) if !mesh.normals.is_empty() => {
                self.losses.note_for(SMOOTH, format!("material `{}`", material.name));
                mesh_text(&mesh.placed(&object.transform))
            }
            Shape::Mesh(mesh) => mesh_text(&mesh.placed(&object.transform)),
            shape => shape_text(shape),
        };
        self.line(format_args!("{shape} material {{ M{index} }}{shadow} }}"));
    }
}

/// Does it enclose nothing?
fn is_open(shape: &Shape) -> bool {
    match shape {
        Shape::Sphere { .. } | Shape::Plane { .. } | Shape::Mesh(_) => false,
        Shape::Polygon { .. } | Shape::Disc { .. } => true,
        Shape::Cylinder { capped, .. } | Shape::Cone { capped, .. } => !capped,
    }
}

/// The shape without its closing brace.
fn shape_text(shape: &Shape) -> String {
    match shape {
        Shape::Sphere { center, radius } => format!("sphere {{ {}, {}", vector(*center), number(*radius)),
        Shape::Plane { normal, distance } => {
            let unit = normal.try_normalize().unwrap_or_default();
            format!("plane {{ {}, {}", vector(unit), number(distance / normal.length()))
        }
        Shape::Polygon { outline, holes } => polygon(outline, holes),
        Shape::Disc { center, normal, radius } => {
            format!("disc {{ {}, {}, {}", vector(*center), vector(*normal), number(*radius))
        }
        Shape::Cylinder { base, top, radius, capped } => {
            let open = if *capped { "" } else { " open" };
            format!("cylinder {{ {}, {}, {}{open}", vector(*base), vector(*top), number(*radius))
        }
        Shape::Cone { base, base_radius, top, top_radius, capped } => {
            let [low, high] = [number(*base_radius), number(*top_radius)];
            let open = if *capped { "" } else { " open" };
            format!("cone {{ {}, {low}, {}, {high}{open}", vector(*base), vector(*top))
        }
        Shape::Mesh(mesh) => mesh_text(mesh),
    }
}

/// Loops are closed by their first point; what lies in an odd number of them belongs to the polygon.
fn polygon(outline: &[Vec3], holes: &[Vec<Vec3>]) -> String {
    if let ([a, b, c], true) = (outline, holes.is_empty()) {
        return format!("triangle {{ {}, {}, {}", vector(*a), vector(*b), vector(*c));
    }
    let loops = || std::iter::once(outline).chain(holes.iter().map(Vec::as_slice));
    let points: Vec<String> =
        loops().flat_map(|ring| ring.iter().chain(ring.first())).map(|p| vector(*p)).collect();
    format!("polygon {{ {}, {}", points.len(), points.join(", "))
}

fn mesh_text(mesh: &Mesh) -> String {
    let mut out = "mesh2 {\n".to_owned();
    let block = |out: &mut String, name: &str, items: Vec<String>| {
        out.push_str(&format!("  {name} {{ {},\n    {} }}\n", items.len(), items.join(",\n    ")));
    };
    block(&mut out, "vertex_vectors", mesh.positions.iter().map(|p| vector(*p)).collect());
    if !mesh.normals.is_empty() {
        block(&mut out, "normal_vectors", mesh.normals.iter().map(|n| vector(*n)).collect());
    }
    let face = |[a, b, c]: &[u32; 3]| format!("<{a}, {b}, {c}>");
    block(&mut out, "face_indices", mesh.triangles.iter().map(face).collect());
    out.push(' ');
    out
}
