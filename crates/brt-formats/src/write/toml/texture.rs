//! The field `texture` of a material.

use std::collections::HashMap;
use std::sync::Arc;

use base64::Engine as _;
use brt_scene::{Texels, Texture, TextureAlpha, TextureFilter, Wrap};

use super::{Writer, quoted};
use crate::write::numerals::number;

/// Pictures that stand in the text, by name: the last of each.
pub(super) type InlinePictures = HashMap<String, *const Texels>;

impl Writer<'_> {
    pub(super) fn texture(&mut self, texture: &Texture) {
        let mut fields = vec![match &mut self.outside {
            Some(outside) => format!("file = {}", quoted(&outside.picture(&texture.picture))),
            None => self.inline_picture(&texture.picture),
        }];
        if texture.wrap != [Wrap::default(); 2] {
            let [u, v] = texture.wrap.map(word);
            fields.push(if u == v {
                format!("wrap = \"{u}\"")
            } else {
                format!("wrap = [\"{u}\", \"{v}\"]")
            });
        }
        if texture.filter == TextureFilter::Nearest {
            fields.push("filter = \"nearest\"".to_owned());
        }
        if texture.transform.map(|row| row.map(f64::to_bits))
            != Texture::PLAIN.map(|row| row.map(f64::to_bits))
        {
            let row = |[a, b, c]: [f64; 3]| format!("[{}, {}, {}]", number(a), number(b), number(c));
            fields.push(format!("transform = [{}]", texture.transform.map(row).join(", ")));
        }
        match texture.alpha {
            TextureAlpha::Ignored => {}
            TextureAlpha::Blend => fields.push("alpha = \"blend\"".to_owned()),
            TextureAlpha::Mask(cutoff) => fields.push(format!("mask = {}", number(cutoff))),
        }
        self.field("texture", &format!("{{ {} }}", fields.join(", ")));
    }

    /// The picture itself; where it stands in the text already, its name is enough.
    fn inline_picture(&mut self, texels: &Arc<Texels>) -> String {
        let name = quoted(&texels.name);
        if self.pictures.insert(texels.name.clone(), Arc::as_ptr(texels)) == Some(Arc::as_ptr(texels)) {
            return format!("file = {name}");
        }
        let data = base64::engine::general_purpose::STANDARD.encode(png(texels));
        format!("name = {name}, data = \"{data}\"")
    }
}

fn word(wrap: Wrap) -> &'static str {
    match wrap {
        Wrap::Repeat => "repeat",
        Wrap::Mirror => "mirror",
        Wrap::Clamp => "clamp",
    }
}

/// The bytes of a PNG file; none for what the scene's check refuses.
pub(super) fn png(texels: &Texels) -> Vec<u8> {
    let mut bytes = Vec::new();
    let pixels = texels.rgba.as_flattened();
    if texels.rgba.len() as u64 == u64::from(texels.width) * u64::from(texels.height) {
        let mut encoder = png::Encoder::new(&mut bytes, texels.width, texels.height);
        encoder.set_color(png::ColorType::Rgba);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::Fast);
        // Writing to memory does not fail.
        let _ = encoder.write_header().and_then(|mut writer| writer.write_image_data(pixels));
    }
    bytes
}
