//! Primitives that are given more than once.

use std::collections::HashMap;

use brt_geometry::{Primitive, Vec3};

use crate::products::{Carrier, PreparedMaterial, PrimitiveInfo};

/// What is the same for the same part of a carrier, however it is described. Coordinates by their bits.
#[derive(PartialEq, Eq, Hash)]
enum Part {
    /// All of it: a ball, an infinite plane.
    Whole,
    /// Corners, sorted.
    Outline(Vec<[u64; 3]>),
    Disc([u64; 3], u64),
    Between(u64, u64),
}

/// For each primitive: is it one that came before, once more, so that nothing can be seen of it?
///
/// Nothing is seen of it if the other ends the view, or is of the same material: given twice, a veil is no denser. But it counts
/// if it hides light where the other does not, and if both are faces of glass that look to opposite sides: there glass touches
/// glass.
pub(in crate::prepare) fn duplicates(
    primitives: &[Primitive],
    infos: &[PrimitiveInfo],
    carriers: &[Carrier],
    materials: &[PreparedMaterial],
) -> Vec<bool> {
    let mut users = vec![0_u32; primitives.len()];
    carriers.iter().for_each(|carrier| users[carrier.index()] += 1);
    let stands_for = |other: usize, id: usize| {
        let hides_more = infos[id].casts_shadow && !infos[other].casts_shadow;
        let material = &materials[infos[other].material as usize];
        let is_contact = material.transmission > 0.0 && looks_away(&primitives[other], &primitives[id]);
        // What is interpolated between corners may differ: a mask whose holes are elsewhere.
        let is_same =
            infos[id].material == infos[other].material && infos[id].is_plain() && infos[other].is_plain();
        (is_same || material.ends_view()) && !hides_more && !is_contact
    };
    let mut kept: HashMap<(Carrier, Part), Vec<usize>> = HashMap::new();
    let mut is_duplicate = vec![false; primitives.len()];
    for (id, (primitive, carrier)) in primitives.iter().zip(carriers).enumerate() {
        if users[carrier.index()] == 1 {
            continue;
        }
        let others = kept.entry((*carrier, part_of(primitive))).or_default();
        is_duplicate[id] = others.iter().any(|&other| stands_for(other, id));
        if !is_duplicate[id] {
            others.push(id);
        }
    }
    is_duplicate
}

fn looks_away(a: &Primitive, b: &Primitive) -> bool {
    a.plane().zip(b.plane()).is_some_and(|(a, b)| a.normal.dot(b.normal) < 0.0)
}

fn part_of(primitive: &Primitive) -> Part {
    match primitive {
        Primitive::Sphere(_) | Primitive::Plane(_) => Part::Whole,
        Primitive::Triangle(face) => outline(&face.corners),
        Primitive::Polygon(face) => outline(&face.corners),
        Primitive::Disc(disc) => Part::Disc(bits(disc.center), disc.radius.to_bits()),
        Primitive::Cylinder(side) => Part::Between(side.low.to_bits(), side.high.to_bits()),
        Primitive::Cone(side) => Part::Between(side.low.to_bits(), side.high.to_bits()),
    }
}

/// A convex outline is known by its corners, whichever comes first and whichever way round they go.
fn outline(corners: &[Vec3]) -> Part {
    let mut corners: Vec<[u64; 3]> = corners.iter().map(|&corner| bits(corner)).collect();
    corners.sort_unstable();
    Part::Outline(corners)
}

/// Zeros of both signs are one place.
fn bits(p: Vec3) -> [u64; 3] {
    [p.x, p.y, p.z].map(|x| (x + 0.0).to_bits())
}
