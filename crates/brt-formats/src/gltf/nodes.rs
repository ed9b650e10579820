//! The node hierarchy: meshes, cameras and lights in their places.

use std::collections::HashMap;

use brt_geometry::vec3;
use brt_scene::{Camera, Projection};
use gltf::{Document, Node};

use super::buffers::Buffers;
use super::light::Lights;
use super::material::Surface;
use super::mesh;
use crate::Limits;
use crate::import::{Affine, CREASE_DEG, Crease, Draft, Part, Stop, fault};

/// Nodes that are visited at most: a node may be the child of many.
const MOST_VISITS: u32 = 1_000_000;

/// Adds what the file's default scene shows; its first one if none is the default, all nodes if there is none.
pub(super) fn add(
    document: &Document,
    buffers: &Buffers,
    surfaces: &[Surface],
    draft: &mut Draft,
) -> Result<(), Stop> {
    let mut walk =
        Walk { buffers, surfaces, shared: shared_meshes(document), lights: Lights::default(), visits: 0 };
    match document.default_scene().or_else(|| document.scenes().next()) {
        Some(scene) => {
            for node in scene.nodes() {
                walk.node(&node, &Affine::IDENTITY, 0, draft)?;
            }
        }
        None => {
            for mesh in document.meshes() {
                walk.mesh(&mesh, &Affine::IDENTITY, None, draft)?;
            }
        }
    }
    walk.lights.finish(draft);
    Ok(())
}

/// Meshes that more than one node has; their parts are filled in when they are met.
fn shared_meshes(document: &Document) -> HashMap<usize, Option<Vec<Part>>> {
    let mut uses = HashMap::<usize, u32>::new();
    for mesh in document.nodes().filter_map(|node| node.mesh()) {
        *uses.entry(mesh.index()).or_default() += 1;
    }
    uses.into_iter().filter(|&(_, count)| count > 1).map(|(mesh, _)| (mesh, None)).collect()
}

struct Walk<'b> {
    buffers: &'b Buffers<'b>,
    surfaces: &'b [Surface],
    shared: HashMap<usize, Option<Vec<Part>>>,
    lights: Lights,
    visits: u32,
}

impl Walk<'_> {
    fn node(&mut self, node: &Node, outer: &Affine, depth: usize, draft: &mut Draft) -> Result<(), Stop> {
        let i = node.index();
        self.visits += 1;
        if depth > Limits::NESTING || self.visits > MOST_VISITS {
            return Err(fault(format!("node {i} nests too deep, or contains itself"), None));
        }
        let place = outer.after(&local(node));
        if let Some(mesh) = node.mesh() {
            let name = node.name().or_else(|| mesh.name());
            self.mesh(&mesh, &place, name, draft)?;
        }
        if let Some(camera) = node.camera() {
            if draft.given.camera {
                draft.notices.note("cameras after the first ignored", format!("node {i}"));
            } else if let Some(camera) = eye(&camera, &place) {
                draft.scene.camera = camera;
                draft.given.camera = true;
            }
        }
        if let Some(light) = node.light() {
            self.lights.add(&light, &place);
        }
        for child in node.children() {
            self.node(&child, &place, depth + 1, draft)?;
        }
        Ok(())
    }

    fn mesh(
        &mut self,
        mesh: &gltf::Mesh,
        place: &Affine,
        name: Option<&str>,
        draft: &mut Draft,
    ) -> Result<(), Stop> {
        if let (Some(known), Some(transform)) = (self.shared.get(&mesh.index()), place.as_transform()) {
            let parts = match known {
                Some(parts) => {
                    draft.expect_again(parts)?;
                    parts.clone()
                }
                None => {
                    let parts = self.parts(mesh, &Affine::IDENTITY, name, draft)?;
                    self.shared.insert(mesh.index(), Some(parts.clone()));
                    parts
                }
            };
            draft.place(&parts, transform, name);
            return Ok(());
        }
        let parts = self.parts(mesh, place, name, draft)?;
        draft.place(&parts, brt_geometry::Affine::IDENTITY, name);
        Ok(())
    }

    /// The primitives of a mesh somewhere.
    fn parts(
        &self,
        mesh: &gltf::Mesh,
        place: &Affine,
        name: Option<&str>,
        draft: &mut Draft,
    ) -> Result<Vec<Part>, Stop> {
        let mut parts = Vec::new();
        for primitive in mesh.primitives() {
            let part = format!("primitive {} of mesh {}", primitive.index(), mesh.index());
            let surface = primitive.material().index().and_then(|i| self.surfaces.get(i));
            let texcoords = surface.and_then(|surface| surface.texcoords);
            let read = mesh::geometry(&primitive, texcoords, &part, self.buffers, draft)?;
            let Some(geometry) = read else { continue };
            let material = surface.map_or_else(|| draft.plain(), |surface| surface.material);
            let geometry = if *place == Affine::IDENTITY { geometry } else { geometry.moved(place) };
            parts.extend(draft.parts(geometry, Some(&Crease::new(CREASE_DEG)), material, name)?);
        }
        Ok(parts)
    }
}

fn local(node: &Node) -> Affine {
    let [x, y, z, origin] =
        node.transform().matrix().map(|c| vec3(f64::from(c[0]), f64::from(c[1]), f64::from(c[2])));
    Affine { x, y, z, origin }
}

/// A camera looks along −z. Cameras without a direction are none.
fn eye(camera: &gltf::Camera, place: &Affine) -> Option<Camera> {
    let forward = place.direction(vec3(0.0, 0.0, -1.0)).try_normalize()?;
    let up = place.direction(vec3(0.0, 1.0, 0.0)).try_normalize()?;
    let eye = place.origin;
    let distance = eye.length().max(1.0);
    let projection = match camera.projection() {
        gltf::camera::Projection::Perspective(p) => {
            // Theirs is vertical, ours across the shorter side.
            let aspect = p.aspect_ratio().map_or(1.0, f64::from);
            let slope = libm::tan(0.5 * f64::from(p.yfov())) * aspect.min(1.0);
            Projection::Perspective { fov_deg: 2.0 * libm::atan(slope).to_degrees() }
        }
        gltf::camera::Projection::Orthographic(o) => {
            Projection::Orthographic { extent: 2.0 * f64::from(o.xmag().min(o.ymag())) }
        }
    };
    Some(Camera { eye, look_at: eye + forward * distance, up, projection })
}
