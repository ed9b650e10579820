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
/// Not if it hides light where the first does not. Nor if both are faces of glass that look to opposite sides: there glass
/// touches glass.
pub(in crate::prepare) fn duplicates(
    primitives: &[Primitive],
    infos: &[PrimitiveInfo],
    carriers: &[Carrier],
    materials: &[PreparedMaterial],
) -> Vec<bool> {
    let mut users: HashMap<Carrier, u32> = HashMap::with_capacity(primitives.len());
    carriers.iter().for_each(|carrier| *users.entry(*carrier).or_default() += 1);
    let mut first_of: HashMap<(Carrier, Part), usize> = HashMap::new();
    let mut is_duplicate = vec![false; primitives.len()];
    for (id, (primitive, carrier)) in primitives.iter().zip(carriers).enumerate() {
        if users[carrier] == 1 {
            continue;
        }
        let first = *first_of.entry((*carrier, part_of(primitive))).or_insert(id);
        let hides_more = infos[id].casts_shadow && !infos[first].casts_shadow;
        let ends_view = materials[infos[first].material as usize].ends_view();
        let is_contact = !ends_view && looks_away(&primitives[first], primitive);
        is_duplicate[id] = first != id && !hides_more && !is_contact;
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
