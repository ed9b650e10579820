//! The first hit of a single ray, by a search: what the perspective image is checked against.

use brt_geometry::Ray;

use super::search::Search;
use crate::products::{Carrier, PreparedScene};

/// What a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstSeen {
    /// Position in [`PreparedScene::surfaces`].
    pub surface: u32,
    /// Distance in units of the ray's direction; along the view for the rays of a camera.
    pub depth: f64,
}

impl PreparedScene {
    /// What a ray meets first, `None` for the background.
    pub fn first_seen(&self, ray: &Ray) -> Option<FirstSeen> {
        let met = Search::new(self).closest(ray, Carrier::NOWHERE)?;
        Some(FirstSeen { surface: self.infos[met.primitive as usize].surface, depth: met.t })
    }
}
