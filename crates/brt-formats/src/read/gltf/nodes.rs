//! The node hierarchy: meshes, cameras and lights in their places.

use std::collections::{HashMap, HashSet};

use brt_geometry::vec3;
use brt_scene::{Camera, Projection};
use gltf::{Document, Node};

use super::buffers::Buffers;
use super::light::Lights;
use super::material::Surface;
use super::mesh;
use crate::common::Cost;
use crate::import::{Affine, CREASE_DEG, Crease, Draft, Graph, Instances, Part, Stop, fault};

/// Adds what the file's default scene shows; its first one if none is the default, all nodes if there is none.
pub(super) fn add(
    document: &Document,
    buffers: &Buffers,
    surfaces: &[Surface],
    draft: &mut Draft,
) -> Result<(), Stop> {
    let scene = document.default_scene().or_else(|| document.scenes().next());
    let nodes: Vec<Node> = document.nodes().collect();
    let roots = scene.iter().flat_map(|scene| scene.nodes().map(|node| node.index()));
    let instances = Instances::count(&Nodes(&nodes), roots, draft.budget)?;
    let shared = shared_meshes(document);
    let mut walk = Walk { buffers, surfaces, shared, lights: Lights::default(), instances };
    match scene {
        Some(scene) => {
            for node in scene.nodes() {
                walk.node(&node, &Affine::IDENTITY, draft)?;
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

/// Meshes that are used more than once; their parts are filled in when they are met.
fn shared_meshes(document: &Document) -> HashMap<usize, Option<Vec<Part>>> {
    let mut uses = HashMap::<usize, u32>::new();
    for mesh in document.nodes().filter_map(|node| node.mesh()) {
        *uses.entry(mesh.index()).or_default() += 1;
    }
    let is_shared = |count: u32| count > 1 || !is_tree(document);
    uses.into_iter().filter(|&(_, count)| is_shared(count)).map(|(mesh, _)| (mesh, None)).collect()
}

/// Has every node one parent at most, as the format demands?
fn is_tree(document: &Document) -> bool {
    let mut seen = HashSet::new();
    document
        .nodes()
        .flat_map(|node| node.children().map(|child| child.index()).collect::<Vec<_>>())
        .all(|i| seen.insert(i))
}

/// What is counted before it is walked through.
struct Nodes<'d>(&'d [Node<'d>]);

impl Graph for Nodes<'_> {
    type Node = usize;

    fn shown(&self, node: usize) -> Result<Option<u64>, Stop> {
        let Some(node) = self.0.get(node) else { return Ok(None) };
        if node.mesh().is_none() && node.camera().is_none() && node.light().is_none() {
            return Ok(None);
        }
        let primitives = node.mesh().into_iter().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>());
        let bytes =
            primitives.map(|primitive| mesh::bytes(&primitive)).fold(Cost::Use.bytes(), u64::saturating_add);
        Ok(Some(bytes))
    }

    fn below(&self, node: usize) -> Vec<usize> {
        let children = |node: &Node| node.children().map(|child| child.index()).collect();
        self.0.get(node).map_or_else(Vec::new, children)
    }

    fn fault(&self, node: usize, what: &str) -> Stop {
        fault(format!("node {node} {what}"), None)
    }
}

struct Walk<'b> {
    buffers: &'b Buffers<'b>,
    surfaces: &'b [Surface],
    shared: HashMap<usize, Option<Vec<Part>>>,
    lights: Lights,
    instances: Instances<usize>,
}

impl Walk<'_> {
    fn node(&mut self, node: &Node, outer: &Affine, draft: &mut Draft) -> Result<(), Stop> {
        let i = node.index();
        if !self.instances.shows(i) {
            return Ok(());
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
            self.node(&child, &place, draft)?;
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
                    draft.spend_again(parts)?;
                    parts.clone()
                }
                None => {
                    let parts = self.parts(mesh, &Affine::IDENTITY, name, draft)?;
                    self.shared.insert(mesh.index(), Some(parts.clone()));
                    parts
                }
            };
            return Ok(draft.place(&parts, transform, name)?);
        }
        let parts = self.parts(mesh, place, name, draft)?;
        Ok(draft.place(&parts, brt_geometry::Affine::IDENTITY, name)?)
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
