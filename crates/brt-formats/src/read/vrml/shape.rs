//! Shapes and their materials.

use std::collections::HashMap;

use brt_geometry::{Vec3, vec3};
use brt_scene::{Material, MaterialId, Shape};

use super::faces;
use super::syntax::Node;
use crate::common::Cost;
use crate::import::{Affine, Draft, Geometry, Stop, srgb};

/// Materials that are in the scene already, by the numbers that they were made of.
#[derive(Default)]
pub(super) struct Shapes(HashMap<Vec<u64>, MaterialId>);

impl Shapes {
    /// Adds a shape.
    pub(super) fn add(&mut self, node: &Node, place: &Affine, draft: &mut Draft) -> Result<(), Stop> {
        let Some(geometry) = node.node("geometry") else { return Ok(()) };
        let material = self.material(node.node("appearance"), draft)?;
        match geometry.kind.as_str() {
            "IndexedFaceSet" => faces::add(geometry, place, material, draft),
            "Box" => Ok(draft.add_geometry(cuboid(geometry).moved(place), None, material, None)?),
            "Sphere" => {
                let radius = geometry.number("radius", 1.0) * scale(geometry, place, draft);
                self.round(
                    Shape::Sphere { center: place.origin, radius },
                    radius > 0.0,
                    material,
                    geometry,
                    draft,
                )
            }
            "Cylinder" => {
                let radius = geometry.number("radius", 1.0) * scale(geometry, place, draft);
                let [base, top] = axis(geometry, place);
                let capped = geometry.is("top", true) && geometry.is("bottom", true);
                let is_seen = radius > 0.0 && base != top;
                self.round(Shape::Cylinder { base, top, radius, capped }, is_seen, material, geometry, draft)
            }
            "Cone" => {
                let base_radius = geometry.number("bottomRadius", 1.0) * scale(geometry, place, draft);
                let [base, top] = axis(geometry, place);
                let capped = geometry.is("bottom", true);
                let cone = Shape::Cone { base, base_radius, top, top_radius: 0.0, capped };
                self.round(cone, base_radius > 0.0 && base != top, material, geometry, draft)
            }
            kind => {
                let kind: String = kind.chars().take(40).collect();
                draft.notices.note(&format!("{kind} ignored"), geometry.span.clone());
                Ok(())
            }
        }
    }

    fn round(
        &self,
        shape: Shape,
        is_seen: bool,
        material: MaterialId,
        node: &Node,
        draft: &mut Draft,
    ) -> Result<(), Stop> {
        if !is_seen {
            draft.notices.note("shapes without an extent left out", node.span.clone());
            return Ok(());
        }
        Ok(draft.add_shape(shape, material, None)?)
    }

    /// What a shape costs wherever it is used, about.
    pub(super) fn bytes(node: &Node) -> u64 {
        let Some(geometry) = node.node("geometry") else { return 0 };
        match geometry.kind.as_str() {
            // Corners are points of their own.
            "IndexedFaceSet" => {
                let corners = geometry.numbers("coordIndex").len() as u64;
                corners * Cost::Point.bytes() + corners / 4 * Cost::Triangle.bytes()
            }
            "Box" => 12 * Cost::Triangle.bytes(),
            _ => Cost::Shape.bytes(),
        }
    }

    fn material(&mut self, appearance: Option<&Node>, draft: &mut Draft) -> Result<MaterialId, Stop> {
        if let Some(texture) = appearance.and_then(|a| a.node("texture")) {
            draft.notices.note("textures ignored", texture.span.clone());
        }
        let Some(node) = appearance.and_then(|a| a.node("material")) else {
            return Ok(draft.plain());
        };
        let color = |name: &str, default: f64| node.three(name).unwrap_or([default; 3]);
        let (diffuse, specular, emissive) =
            (color("diffuseColor", 0.8), color("specularColor", 0.0), color("emissiveColor", 0.0));
        let shine = node.number("shininess", 0.2).clamp(0.0, 1.0);
        let transparency = node.number("transparency", 0.0).clamp(0.0, 1.0);
        let mut key: Vec<u64> =
            [diffuse, specular, emissive].concat().into_iter().map(f64::to_bits).collect();
        key.extend([shine.to_bits(), transparency.to_bits()]);
        if let Some(&known) = self.0.get(&key) {
            return Ok(known);
        }
        let mut ours = Material::matte("material", srgb(diffuse));
        ours.specular = 0.5 * specular.iter().sum::<f64>().clamp(0.0, 3.0) / 3.0;
        ours.exponent = (128.0 * shine).max(1.0);
        // What shines by itself alone is drawn so; elsewhere exporters write it beside the colour.
        if diffuse == [0.0; 3] && emissive != [0.0; 3] {
            (ours.color, ours.ambient, ours.diffuse) = (srgb(emissive), 1.0, 0.0);
        }
        if transparency > 0.0 {
            ours.transmission = transparency;
            ours.diffuse *= 1.0 - transparency;
            ours.ambient *= 1.0 - transparency;
            ours.casts_shadow = transparency < 0.5;
        }
        let id = draft.add_material(ours)?;
        self.0.insert(key, id);
        Ok(id)
    }
}

/// The factor for radii; where it is not the same in all directions, the mean stands in.
fn scale(node: &Node, place: &Affine, draft: &mut Draft) -> f64 {
    place.uniform_scale().unwrap_or_else(|| {
        draft
            .notices
            .note("round shapes scaled differently along their axes: shown with the mean", node.span.clone());
        (place.x.length() + place.y.length() + place.z.length()) / 3.0
    })
}

/// Both ends of a shape around y.
fn axis(node: &Node, place: &Affine) -> [Vec3; 2] {
    let half = 0.5 * node.number("height", 2.0);
    [-half, half].map(|y| place.point(vec3(0.0, y, 0.0)))
}

fn cuboid(node: &Node) -> Geometry {
    let [x, y, z] = node.three("size").unwrap_or([2.0; 3]).map(|side| 0.5 * side);
    let corner = |i: u32| {
        let sign = |bit: u32| if i & bit == 0 { -1.0 } else { 1.0 };
        vec3(sign(1) * x, sign(2) * y, sign(4) * z)
    };
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Geometry {
        positions: (0..8).map(corner).collect(),
        triangles: quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect(),
        ..Geometry::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_box_faces_outwards() {
        let Geometry { positions, triangles, .. } = cuboid(&Node::default());
        for t in triangles {
            let [a, b, c] = t.map(|i| positions[i as usize]);
            assert!((b - a).cross(c - a).dot(a + b + c) > 0.0, "{t:?}");
        }
    }
}
