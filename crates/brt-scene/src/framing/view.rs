//! Directions to look from, in terms of what is up.

use brt_geometry::{Vec3, vec3};

/// Which direction of a scene points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Up {
    /// (1, 0, 0)
    PlusX,
    /// (−1, 0, 0)
    MinusX,
    /// (0, 1, 0): animation and games.
    #[default]
    PlusY,
    /// (0, −1, 0)
    MinusY,
    /// (0, 0, 1): machines, printing and maps.
    PlusZ,
    /// (0, 0, −1)
    MinusZ,
}

impl Up {
    /// All of them, with the names that the command line has for them.
    pub const ALL: [(&'static str, Self); 6] = [
        ("+x", Self::PlusX),
        ("-x", Self::MinusX),
        ("+y", Self::PlusY),
        ("-y", Self::MinusY),
        ("+z", Self::PlusZ),
        ("-z", Self::MinusZ),
    ];

    /// The direction.
    pub fn direction(self) -> Vec3 {
        match self {
            Self::PlusX => vec3(1.0, 0.0, 0.0),
            Self::MinusX => vec3(-1.0, 0.0, 0.0),
            Self::PlusY => vec3(0.0, 1.0, 0.0),
            Self::MinusY => vec3(0.0, -1.0, 0.0),
            Self::PlusZ => vec3(0.0, 0.0, 1.0),
            Self::MinusZ => vec3(0.0, 0.0, -1.0),
        }
    }

    /// What is on the right for somebody who looks at the front: +x where it does not point up itself.
    fn right(self) -> Vec3 {
        match self {
            Self::PlusX | Self::MinusX => vec3(0.0, 1.0, 0.0),
            _ => vec3(1.0, 0.0, 0.0),
        }
    }
}

/// From where a scene is seen. The front is −y where +z is up (as in CAD) and +z where +y is up (as in glTF).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum View {
    /// From the front, the right and above, at the same angle to all three axes.
    #[default]
    Iso,
    /// From the front.
    Front,
    /// From behind.
    Back,
    /// From the left.
    Left,
    /// From the right.
    Right,
    /// From above, the front below in the picture.
    Top,
    /// From below, the front above in the picture.
    Bottom,
    /// From any side.
    Angles {
        /// Degrees around the up axis from the front towards the right.
        azimuth_deg: f64,
        /// Degrees above the horizon; below it if negative.
        elevation_deg: f64,
    },
}

impl View {
    /// The views that have a name.
    pub const NAMED: [(&'static str, Self); 7] = [
        ("iso", Self::Iso),
        ("front", Self::Front),
        ("back", Self::Back),
        ("left", Self::Left),
        ("right", Self::Right),
        ("top", Self::Top),
        ("bottom", Self::Bottom),
    ];

    /// Azimuth and elevation in degrees.
    fn angles(self) -> [f64; 2] {
        match self {
            // The diagonal of a cube rises by atan(1/√2).
            Self::Iso => [45.0, 35.264_389_682_754_654],
            Self::Front => [0.0, 0.0],
            Self::Back => [180.0, 0.0],
            Self::Left => [-90.0, 0.0],
            Self::Right => [90.0, 0.0],
            Self::Top => [0.0, 90.0],
            Self::Bottom => [0.0, -90.0],
            Self::Angles { azimuth_deg, elevation_deg } => [azimuth_deg, elevation_deg],
        }
    }

    /// The axes of a picture with this view: right, up, and towards the eye. Unit vectors.
    pub(super) fn axes(self, up: Up) -> [Vec3; 3] {
        let [azimuth, elevation] = self.angles().map(sine_and_cosine);
        let (vertical, right) = (up.direction(), up.right());
        let front = right.cross(vertical);
        let horizontal = front * azimuth[1] + right * azimuth[0];
        [
            right * azimuth[1] - front * azimuth[0],
            vertical * elevation[1] - horizontal * elevation[0],
            horizontal * elevation[1] + vertical * elevation[0],
        ]
    }
}

/// Exact at multiples of 90°, so that a box seen from the front shows one face only.
fn sine_and_cosine(degrees: f64) -> [f64; 2] {
    let turned = degrees.rem_euclid(360.0);
    match turned {
        0.0 => [0.0, 1.0],
        90.0 => [1.0, 0.0],
        180.0 => [0.0, -1.0],
        270.0 => [-1.0, 0.0],
        _ => [libm::sin(turned.to_radians()), libm::cos(turned.to_radians())],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_of_a_drawing_and_of_a_game() {
        let towards_eye = |view: View, up| view.axes(up)[2];
        assert_eq!(towards_eye(View::Front, Up::PlusZ), vec3(0.0, -1.0, 0.0));
        assert_eq!(towards_eye(View::Front, Up::PlusY), vec3(0.0, 0.0, 1.0));
        assert_eq!(towards_eye(View::Right, Up::PlusZ), vec3(1.0, 0.0, 0.0));
        assert_eq!(towards_eye(View::Top, Up::PlusY), vec3(0.0, 1.0, 0.0));
        // (1, 1, 1) / √3
        let iso = towards_eye(View::Iso, Up::PlusY);
        assert!((iso - vec3(1.0, 1.0, 1.0) * (1.0 / 3.0_f64.sqrt())).length() < 1e-12);
    }

    #[test]
    fn axes_are_right_handed_and_unit_from_everywhere() {
        for (_, up) in Up::ALL {
            for azimuth_deg in [-400.0, -90.0, 0.0, 17.0, 180.0] {
                for elevation_deg in [-90.0, -30.0, 0.0, 45.0, 90.0] {
                    let [r, u, d] = View::Angles { azimuth_deg, elevation_deg }.axes(up);
                    assert!((r.cross(u) - d).length() < 1e-12);
                    assert!((d.length() - 1.0).abs() < 1e-12);
                }
            }
        }
    }

    #[test]
    fn from_above_the_front_is_below() {
        assert_eq!(View::Top.axes(Up::PlusZ)[1], vec3(0.0, 1.0, 0.0));
        assert_eq!(View::Bottom.axes(Up::PlusZ)[1], vec3(0.0, -1.0, 0.0));
    }
}
