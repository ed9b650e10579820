//! Points at the same place are one point.

use std::collections::HashMap;

use brt_geometry::Vec3;

/// Finds points by their exact coordinates.
#[derive(Default)]
pub(crate) struct Weld {
    /// The hash is a keyed one: files cannot be made so that it is slow.
    index: HashMap<[u64; 3], u32>,
    pub(crate) positions: Vec<Vec3>,
}

impl Weld {
    /// The index of the point at this place.
    pub(crate) fn point(&mut self, p: Vec3) -> u32 {
        // Adding 0 makes −0 to 0.
        let key = [p.x, p.y, p.z].map(|c| (c + 0.0).to_bits());
        let next = self.positions.len() as u32;
        *self.index.entry(key).or_insert_with(|| {
            self.positions.push(p);
            next
        })
    }

    /// For each point the first one at the same place.
    pub(crate) fn classes(positions: &[Vec3]) -> Vec<u32> {
        let mut weld = Self::default();
        positions.iter().map(|&p| weld.point(p)).collect()
    }
}
