//! From nodes to the scene.

use std::hash::{Hash, Hasher};
use std::marker::PhantomData;
use std::ptr;
use std::rc::Rc;

use brt_geometry::{Vec3, vec3};
use brt_scene::{Camera, Projection};

use super::shape::Shapes;
use super::syntax::Node;
use crate::common::Cost;
use crate::import::{Affine, Draft, Graph, Instances, Stop, fault};

/// Adds what the nodes show.
pub(super) fn build(nodes: &[Rc<Node>], draft: &mut Draft) -> Result<(), Stop> {
    let instances =
        Instances::count(&Nodes(PhantomData), nodes.iter().map(|node| ByPlace(node)), draft.budget)?;
    let mut walk = Walk { shapes: Shapes::default(), instances };
    nodes.iter().try_for_each(|node| walk.node(node, &Affine::IDENTITY, draft))
}

/// The nodes right below that are shown, if it is a node that groups others.
fn group(node: &Node) -> Option<&[Rc<Node>]> {
    match node.kind.as_str() {
        "Transform" | "Group" | "Anchor" | "Collision" | "Billboard" => Some(node.nodes("children")),
        "Switch" => {
            let choice = node.number("whichChoice", -1.0);
            let chosen = if choice >= 0.0 { node.nodes("choice").get(choice as usize) } else { None };
            Some(chosen.map_or(&[], std::slice::from_ref))
        }
        "LOD" => Some(node.nodes("level").get(..1).unwrap_or_default()),
        _ => None,
    }
}

/// A node that is told from others by where it lies in memory: equal ones may stand in several places of a file.
#[derive(Clone, Copy)]
struct ByPlace<'n>(&'n Node);

impl PartialEq for ByPlace<'_> {
    fn eq(&self, other: &Self) -> bool {
        ptr::eq(self.0, other.0)
    }
}

impl Eq for ByPlace<'_> {}

impl Hash for ByPlace<'_> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        ptr::hash(self.0, state);
    }
}

/// What is counted before it is walked through.
struct Nodes<'n>(PhantomData<&'n Node>);

impl<'n> Graph for Nodes<'n> {
    type Node = ByPlace<'n>;

    fn shown(&self, node: ByPlace<'n>) -> Result<Option<u64>, Stop> {
        let is_group = group(node.0).is_some();
        let bytes = if node.0.kind == "Shape" { Shapes::bytes(node.0) } else { 0 };
        Ok((!is_group).then_some(bytes.saturating_add(Cost::Use.bytes())))
    }

    fn below(&self, node: ByPlace<'n>) -> Vec<ByPlace<'n>> {
        group(node.0).unwrap_or_default().iter().map(|node| ByPlace(node)).collect()
    }

    fn fault(&self, node: ByPlace<'n>, what: &str) -> Stop {
        fault(format!("`{}` {what}", node.0.kind), Some(node.0.span.clone()))
    }
}

struct Walk<'n> {
    shapes: Shapes,
    instances: Instances<ByPlace<'n>>,
}

impl<'n> Walk<'n> {
    fn node(&mut self, node: &'n Node, outer: &Affine, draft: &mut Draft) -> Result<(), Stop> {
        if !self.instances.shows(ByPlace(node)) {
            return Ok(());
        }
        if let Some(children) = group(node) {
            let inner = if node.kind == "Transform" { outer.after(&transform(node)) } else { *outer };
            return children.iter().try_for_each(|child| self.node(child, &inner, draft));
        }
        match node.kind.as_str() {
            "Shape" => self.shapes.add(node, outer, draft),
            "Viewpoint" => {
                viewpoint(node, outer, draft);
                Ok(())
            }
            "WorldInfo" | "NavigationInfo" => Ok(()),
            kind => {
                let kind: String = kind.chars().take(40).collect();
                draft.notices.note(&format!("{kind} ignored"), node.span.clone());
                Ok(())
            }
        }
    }
}

/// T · C · R · SR · S · −SR · −C, as the standard has it.
fn transform(node: &Node) -> Affine {
    let vector = |name: &str, default: Vec3| node.three(name).map_or(default, Vec3::from);
    let rotation = |name: &str| match node.numbers(name) {
        &[x, y, z, angle, ..] => Affine::rotation(vec3(x, y, z), angle),
        _ => Affine::IDENTITY,
    };
    let center = vector("center", Vec3::ZERO);
    let turned = match node.numbers("scaleOrientation") {
        &[x, y, z, angle, ..] => {
            (Affine::rotation(vec3(x, y, z), angle), Affine::rotation(vec3(x, y, z), -angle))
        }
        _ => (Affine::IDENTITY, Affine::IDENTITY),
    };
    let scaled = turned.0.after(&Affine::scaling(vector("scale", Vec3::splat(1.0)))).after(&turned.1);
    Affine::translation(vector("translation", Vec3::ZERO) + center)
        .after(&rotation("rotation"))
        .after(&scaled)
        .after(&Affine::translation(-center))
}

/// The first viewpoint is where the file is seen from.
fn viewpoint(node: &Node, outer: &Affine, draft: &mut Draft) {
    if draft.given.camera {
        draft.notices.note("viewpoints after the first ignored", node.span.clone());
        return;
    }
    let turn = match node.numbers("orientation") {
        &[x, y, z, angle, ..] => Affine::rotation(vec3(x, y, z), angle),
        _ => Affine::IDENTITY,
    };
    let position = node.three("position").map_or(vec3(0.0, 0.0, 10.0), Vec3::from);
    let direction = |d| outer.direction(turn.direction(d)).try_normalize();
    let (Some(forward), Some(up)) = (direction(vec3(0.0, 0.0, -1.0)), direction(vec3(0.0, 1.0, 0.0))) else {
        return;
    };
    let eye = outer.point(position);
    let fov_deg = node.number("fieldOfView", std::f64::consts::FRAC_PI_4).to_degrees();
    let look_at = eye + forward * eye.length().max(1.0);
    draft.scene.camera = Camera { eye, look_at, up, projection: Projection::Perspective { fov_deg } };
    draft.given.camera = true;
}
