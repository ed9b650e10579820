//! From nodes to the scene.

use std::rc::Rc;

use brt_geometry::{Vec3, vec3};
use brt_scene::{Camera, Projection};

use super::shape::Shapes;
use super::syntax::Node;
use crate::Limits;
use crate::import::{Affine, Draft, Stop, fault};

/// Nodes that are visited at most: a node may be used many times.
const MOST_VISITS: u32 = 1_000_000;

/// Adds what the nodes show.
pub(super) fn build(nodes: &[Rc<Node>], draft: &mut Draft) -> Result<(), Stop> {
    let mut walk = Walk { shapes: Shapes::default(), visits: 0 };
    nodes.iter().try_for_each(|node| walk.node(node, &Affine::IDENTITY, 0, draft))
}

#[derive(Default)]
struct Walk {
    shapes: Shapes,
    visits: u32,
}

impl Walk {
    fn node(&mut self, node: &Node, outer: &Affine, depth: usize, draft: &mut Draft) -> Result<(), Stop> {
        self.visits += 1;
        if depth > Limits::NESTING || self.visits > MOST_VISITS {
            return Err(fault("groups nest too deep or are used too often", Some(node.span.clone())));
        }
        match node.kind.as_str() {
            "Transform" => {
                let inner = outer.after(&transform(node));
                self.children(node.nodes("children"), &inner, depth, draft)
            }
            "Group" | "Anchor" | "Collision" | "Billboard" => {
                self.children(node.nodes("children"), outer, depth, draft)
            }
            "Switch" => {
                let choice = node.number("whichChoice", -1.0);
                let chosen = if choice >= 0.0 { node.nodes("choice").get(choice as usize) } else { None };
                chosen.map_or(Ok(()), |child| self.node(child, outer, depth + 1, draft))
            }
            "LOD" => {
                node.nodes("level").first().map_or(Ok(()), |child| self.node(child, outer, depth + 1, draft))
            }
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

    fn children(
        &mut self,
        nodes: &[Rc<Node>],
        place: &Affine,
        depth: usize,
        draft: &mut Draft,
    ) -> Result<(), Stop> {
        nodes.iter().try_for_each(|child| self.node(child, place, depth + 1, draft))
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
