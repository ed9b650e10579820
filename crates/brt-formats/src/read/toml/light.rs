//! The tables `[[light]]`.

use brt_scene::Light;

use super::fields::Fields;
use super::value::{Value, color, number, one_of, vector};
use crate::common::Problems;

#[derive(Clone, Copy)]
enum Kind {
    Point,
    Spot,
    Directional,
}

const KINDS: [(&str, Kind); 3] =
    [("point", Kind::Point), ("spot", Kind::Spot), ("directional", Kind::Directional)];

// All fields are read before the first `?`, so that every error of a light is said.

/// Reads a light of the kind that the field `type` names.
pub(super) fn read_light(value: &Value, problems: &mut Problems) -> Option<Light> {
    let mut fields = Fields::of_value(value, "the light", problems)?;
    match fields.required("type", |v| one_of("type", v, &KINDS))? {
        Kind::Point => {
            fields.now_called("the point light");
            fields.only(&[&["type", "position", "color"]]);
            let position = fields.required("position", vector);
            let color = fields.required("color", color);
            Some(Light::Point { position: position?, color: color? })
        }
        Kind::Spot => read_spot(&mut fields),
        Kind::Directional => {
            fields.now_called("the directional light");
            fields.only(&[&["type", "direction", "color"]]);
            let direction = fields.required("direction", vector);
            let color = fields.required("color", color);
            Some(Light::Directional { direction: direction?, color: color? })
        }
    }
}

fn read_spot(fields: &mut Fields) -> Option<Light> {
    fields.now_called("the spot light");
    fields.only(&[&["type", "position", "direction", "color", "inner_deg", "outer_deg"]]);
    let position = fields.required("position", vector);
    let direction = fields.required("direction", vector);
    let color = fields.required("color", color);
    let inner_deg = fields.or("inner_deg", 0.0, number);
    let outer_deg = fields.required("outer_deg", number);
    Some(Light::Spot {
        position: position?,
        direction: direction?,
        color: color?,
        inner_deg: inner_deg?,
        outer_deg: outer_deg?,
    })
}
