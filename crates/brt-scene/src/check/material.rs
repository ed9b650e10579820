//! Is a material fit to be rendered?

use super::{FINITE, Found, GREATEST_COORDINATE, check_length, fault, is_in_range};
use crate::{Material, Texture, TextureAlpha};

pub(super) fn check_material(m: &Material, found: Found) {
    let factors = [
        ("ambient", m.ambient),
        ("diffuse", m.diffuse),
        ("specular", m.specular),
        ("exponent", m.exponent),
        ("reflection", m.reflection),
        ("transmission", m.transmission),
    ];
    for (field, value) in factors {
        if !(0.0..=GREATEST_COORDINATE).contains(&value) {
            found(field, fault(format!("`{field}` is {value}"), "a finite number of at least 0"));
        }
    }
    check_length("index_of_refraction", m.index_of_refraction, found);
    if !m.color.is_finite() {
        found("color", fault("a channel is not a finite number", "three finite numbers"));
    }
    if !m.emission.is_finite() {
        found("emission", fault("a channel is not a finite number", "three finite numbers"));
    }
    if !(0.0..=1.0).contains(&m.opacity) {
        found("opacity", fault(format!("`opacity` is {}", m.opacity), "a number from 0 to 1"));
    }
    if let Some(checker) = &m.checker {
        check_length("checker", checker.size, found);
        if !checker.color.is_finite() {
            found("checker", fault("a channel is not a finite number", "three finite numbers"));
        }
    }
    if let Some(texture) = &m.texture {
        check_texture(texture, found);
    }
}

fn check_texture(texture: &Texture, found: Found) {
    let texels = &*texture.picture;
    let count = u64::from(texels.width) * u64::from(texels.height);
    if count == 0 || texels.rgba.len() as u64 != count {
        let message = format!("{} texels for {} × {}", texels.rgba.len(), texels.width, texels.height);
        found("texture", fault(message, "a picture of at least one texel"));
    }
    if texture.transform.iter().flatten().any(|&c| !is_in_range(c)) {
        found("texture", fault("a number of the transform is not finite or too large", FINITE));
    }
    if let TextureAlpha::Mask(cutoff) = texture.alpha
        && !(0.0..=1.0).contains(&cutoff)
    {
        found("texture", fault(format!("the mask's cutoff is {cutoff}"), "a number from 0 to 1"));
    }
}
