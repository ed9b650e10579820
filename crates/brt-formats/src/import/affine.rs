//! Where a part stands in its whole.

use brt_geometry::{Vec3, vec3};

/// `p ↦ x·p.x + y·p.y + z·p.z + origin`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Affine {
    pub(crate) x: Vec3,
    pub(crate) y: Vec3,
    pub(crate) z: Vec3,
    pub(crate) origin: Vec3,
}

impl Affine {
    pub(crate) const IDENTITY: Self =
        Self { x: vec3(1.0, 0.0, 0.0), y: vec3(0.0, 1.0, 0.0), z: vec3(0.0, 0.0, 1.0), origin: Vec3::ZERO };

    pub(crate) fn translation(origin: Vec3) -> Self {
        Self { origin, ..Self::IDENTITY }
    }

    pub(crate) fn scaling(factors: Vec3) -> Self {
        let Self { x, y, z, origin } = Self::IDENTITY;
        Self { x: x * factors.x, y: y * factors.y, z: z * factors.z, origin }
    }

    /// Around an axis by an angle in radians (Rodrigues 1840); nothing where the axis has no length.
    pub(crate) fn rotation(axis: Vec3, angle: f64) -> Self {
        let Some(n) = axis.try_normalize() else { return Self::IDENTITY };
        let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
        let turned = |v: Vec3| v * cosine + n.cross(v) * sine + n * (n.dot(v) * (1.0 - cosine));
        let Self { x, y, z, origin } = Self::IDENTITY;
        Self { x: turned(x), y: turned(y), z: turned(z), origin }
    }

    /// First `inner`, then this.
    pub(crate) fn after(&self, inner: &Self) -> Self {
        Self {
            x: self.direction(inner.x),
            y: self.direction(inner.y),
            z: self.direction(inner.z),
            origin: self.point(inner.origin),
        }
    }

    pub(crate) fn point(&self, p: Vec3) -> Vec3 {
        self.direction(p) + self.origin
    }

    pub(crate) fn direction(&self, d: Vec3) -> Vec3 {
        self.x * d.x + self.y * d.y + self.z * d.z
    }

    /// As the transform of an object, if it is one: flat ones are none.
    pub(crate) fn as_transform(&self) -> Option<brt_geometry::Affine> {
        let transform = brt_geometry::Affine { axes: [self.x, self.y, self.z], offset: self.origin };
        (transform.is_finite() && transform.determinant() != 0.0).then_some(transform)
    }

    /// A normal, times a positive factor: by the cofactors, which exist for flattened parts too.
    pub(crate) fn normal(&self, n: Vec3) -> Vec3 {
        let cofactors = self.y.cross(self.z) * n.x + self.z.cross(self.x) * n.y + self.x.cross(self.y) * n.z;
        if self.mirrors() { -cofactors } else { cofactors }
    }

    /// Does it turn left hands into right ones?
    pub(crate) fn mirrors(&self) -> bool {
        self.x.cross(self.y).dot(self.z) < 0.0
    }

    /// The factor by which it enlarges, if it is the same in all directions up to rounding.
    pub(crate) fn uniform_scale(&self) -> Option<f64> {
        /// Files round to about six digits.
        const ROUNDING: f64 = 1.0 / 8192.0;
        let (x, y, z) = (self.x.length(), self.y.length(), self.z.length());
        let small = |a: f64| a.abs() <= ROUNDING * x * x;
        let square = [self.x.dot(self.y), self.y.dot(self.z), self.z.dot(self.x)].into_iter().all(small);
        (square && small(x * (x - y)) && small(x * (x - z)) && x > 0.0).then_some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_after_a_shift() {
        let turn = Affine::rotation(vec3(0.0, 0.0, 2.0), std::f64::consts::FRAC_PI_2);
        let both = turn.after(&Affine::translation(vec3(1.0, 0.0, 0.0)));
        assert!((both.point(Vec3::ZERO) - vec3(0.0, 1.0, 0.0)).length() < 1e-12);
        assert!(both.uniform_scale().is_some_and(|s| (s - 1.0).abs() < 1e-12));
    }

    #[test]
    fn normals_stay_normal_and_outside() {
        let flat = Affine::scaling(vec3(1.0, 2.0, -3.0));
        assert!(flat.mirrors() && flat.uniform_scale().is_none());
        // The plane x + y = 0 becomes x + y/2 = 0.
        let n = flat.normal(vec3(1.0, 1.0, 0.0)).normalize();
        assert!((n - vec3(2.0, 1.0, 0.0).normalize()).length() < 1e-12, "{n:?}");
    }
}
