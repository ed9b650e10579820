//! Triangles with all that files say about their points.

use std::collections::{BTreeMap, HashMap};

use brt_geometry::{FACET_ANGLE, Vec3};
use brt_image::Rgb;
use brt_scene::Mesh;

use super::affine::Affine;
use super::crease::Crease;
use crate::common::{Budget, Halt};

/// A mesh under construction. Lists per point are empty or as long as `positions`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Geometry {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) normals: Vec<Vec3>,
    pub(crate) colors: Vec<Rgb>,
    pub(crate) texcoords: Vec<[f64; 2]>,
    pub(crate) triangles: Vec<[u32; 3]>,
}

impl Geometry {
    /// Leaves out triangles without an area, which have no normal, and says how many.
    pub(crate) fn drop_degenerate(&mut self) -> u64 {
        let before = self.triangles.len();
        let positions = &self.positions;
        self.triangles.retain(|&t| normal_of(positions, t).is_some());
        (before - self.triangles.len()) as u64
    }

    /// The shapes it makes when no normals are given: points are smooth where faces meet at less than the angle.
    ///
    /// What turns out flat becomes a shape of its own without normals, since plain facets are cheaper to trace and to
    /// prove things about.
    pub(crate) fn smoothed(self, crease: &Crease, budget: &Budget) -> Result<Vec<Self>, Halt> {
        let smooth = crease.split(&self.positions, &self.triangles, budget)?;
        let is_flat = |t: &[u32; 3]| {
            let face = normal_of(&self.positions, t.map(|i| smooth.sources[i as usize]));
            t.iter()
                .all(|&i| face.is_some_and(|n| n.cross(smooth.normals[i as usize]).length() < FACET_ANGLE))
        };
        let (flat, round): (Vec<[u32; 3]>, Vec<[u32; 3]>) = smooth.triangles.iter().partition(|t| is_flat(t));
        let flat = flat.iter().map(|t| t.map(|i| smooth.sources[i as usize])).collect();
        let flat = Self { normals: Vec::new(), ..self.part(flat) };
        let gathered = self.gather(&smooth.sources, smooth.normals);
        drop(self);
        let round = gathered.part(round);
        Ok([flat, round].into_iter().filter(|part| !part.triangles.is_empty()).collect())
    }

    /// Points picked by index, with normals of their own.
    fn gather(&self, sources: &[u32], normals: Vec<Vec3>) -> Self {
        Self {
            positions: pick(&self.positions, sources),
            normals,
            colors: pick(&self.colors, sources),
            texcoords: pick(&self.texcoords, sources),
            triangles: Vec::new(),
        }
    }

    /// These triangles and the points that they use.
    pub(crate) fn part(&self, mut triangles: Vec<[u32; 3]>) -> Self {
        let mut sources = Vec::new();
        if triangles.len() < self.positions.len() / 32 {
            // A few of many points: a list of all of them would be filled for each of many parts.
            let mut used = HashMap::new();
            for i in triangles.iter_mut().flatten() {
                *i = *used.entry(*i).or_insert_with(|| next(&mut sources, *i));
            }
        } else {
            let mut used = vec![u32::MAX; self.positions.len()];
            for i in triangles.iter_mut().flatten() {
                let new = &mut used[*i as usize];
                if *new == u32::MAX {
                    *new = next(&mut sources, *i);
                }
                *i = *new;
            }
        }
        let normals = pick(&self.normals, &sources);
        Self { triangles, ..self.gather(&sources, normals) }
    }

    /// Parts by colour, where points have colours.
    ///
    /// Triangles of one colour make parts of their own, of which more can be proven; the others keep the colours of their
    /// points. So do all where there are very many colours.
    pub(crate) fn by_color(self) -> Vec<(Option<Rgb>, Self)> {
        const MOST_PARTS: usize = 64;
        if self.colors.is_empty() {
            return vec![(None, self)];
        }
        let mut even: BTreeMap<[u64; 3], Vec<[u32; 3]>> = BTreeMap::new();
        let mut mixed = Vec::new();
        for &t in &self.triangles {
            let [a, b, c] = t.map(|i| <[f64; 3]>::from(self.colors[i as usize]).map(f64::to_bits));
            match a == b && b == c {
                true => even.entry(a).or_default().push(t),
                false => mixed.push(t),
            }
        }
        if even.len() > MOST_PARTS {
            return vec![(Some(Rgb::WHITE), self)];
        }
        let color_of = |t: &[u32; 3]| self.colors[t[0] as usize];
        let plain = |part: Self| Self { colors: Vec::new(), ..part };
        let mut parts: Vec<(Option<Rgb>, Self)> =
            even.into_values().map(|part| (Some(color_of(&part[0])), plain(self.part(part)))).collect();
        if !mixed.is_empty() {
            parts.push((Some(Rgb::WHITE), self.part(mixed)));
        }
        parts
    }

    /// Leaves out texture coordinates that say nothing; are there any?
    pub(crate) fn drop_wild_texcoords(&mut self) -> bool {
        /// Beyond this a `f64` tells no texel of a large picture from the next.
        const GREATEST: f64 = 1e9;
        let wild = self.texcoords.iter().flatten().any(|c| c.is_nan() || c.abs() > GREATEST);
        if wild {
            self.texcoords.clear();
        }
        wild
    }

    /// The same somewhere else.
    pub(crate) fn moved(mut self, to: &Affine) -> Self {
        self.positions.iter_mut().for_each(|p| *p = to.point(*p));
        self.normals.iter_mut().for_each(|n| *n = to.normal(*n).try_normalize().unwrap_or_default());
        if to.mirrors() {
            self.triangles.iter_mut().for_each(|t| t.swap(1, 2));
        }
        self
    }

    /// As a mesh of the scene.
    pub(crate) fn into_mesh(self) -> Mesh {
        let Self { positions, normals, colors, texcoords, triangles } = self;
        Mesh { positions, normals, colors, texcoords, triangles }
    }
}

fn next(sources: &mut Vec<u32>, source: u32) -> u32 {
    sources.push(source);
    (sources.len() - 1) as u32
}

fn pick<T: Copy>(all: &[T], sources: &[u32]) -> Vec<T> {
    if all.is_empty() { Vec::new() } else { sources.iter().map(|&i| all[i as usize]).collect() }
}

/// Unit normal of a triangle with an area.
pub(super) fn normal_of(positions: &[Vec3], [a, b, c]: [u32; 3]) -> Option<Vec3> {
    if a == b || b == c || c == a {
        return None;
    }
    let [a, b, c] = [a, b, c].map(|i| positions[i as usize]);
    let normal = (b - a).cross(c - a);
    // Coordinates that are no numbers or overflow here make no area either.
    normal.try_normalize()
}

#[cfg(test)]
mod tests {
    use brt_geometry::vec3;

    use super::super::CREASE_DEG;
    use super::*;
    use crate::common::Limits;

    /// A prism of `n` sides around z, closed by fans.
    fn prism(n: u32) -> Geometry {
        let ring = |z: f64| {
            (0..n).map(move |i| {
                let a = f64::from(i) * std::f64::consts::TAU / f64::from(n);
                vec3(libm::cos(a), libm::sin(a), z)
            })
        };
        let positions: Vec<Vec3> = ring(0.0).chain(ring(1.0)).collect();
        let sides = (0..n).flat_map(|i| {
            let j = (i + 1) % n;
            [[i, j, j + n], [i, j + n, i + n]]
        });
        let caps = (1..n - 1).flat_map(|i| [[0, i + 1, i], [n, n + i, n + i + 1]]);
        Geometry { triangles: sides.chain(caps).collect(), positions, ..Geometry::default() }
    }

    #[test]
    fn a_many_sided_prism_is_round_with_flat_caps() {
        let parts = prism(24).smoothed(&Crease::new(CREASE_DEG), &Budget::new(&Limits::default())).unwrap();
        let [flat, round] = &parts[..] else { panic!("caps and side") };
        assert_eq!((flat.triangles.len(), round.triangles.len()), (44, 48));
        assert!(flat.normals.is_empty());
        for (p, n) in round.positions.iter().zip(&round.normals) {
            assert!((vec3(p.x, p.y, 0.0) - *n).length() < 1e-9, "{p:?} {n:?}");
        }
    }

    #[test]
    fn a_box_is_flat() {
        let parts = prism(4).smoothed(&Crease::new(CREASE_DEG), &Budget::new(&Limits::default())).unwrap();
        assert_eq!(parts.len(), 1);
        assert!(parts[0].normals.is_empty());
        assert_eq!((parts[0].positions.len(), parts[0].triangles.len()), (8, 12));
    }

    #[test]
    fn triangles_without_an_area_are_left_out() {
        let mut geometry = prism(4);
        geometry.triangles.extend([[0, 0, 1], [2, 1, 2]]);
        assert_eq!(geometry.drop_degenerate(), 2);
        assert_eq!(geometry.triangles.len(), 12);
    }
}
