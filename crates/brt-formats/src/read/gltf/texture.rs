//! Pictures of base colours: inside a buffer, in the JSON itself, or in files beside it.

use std::borrow::Cow;

use brt_scene::{Texture, TextureAlpha, TextureFilter, Wrap};
use gltf::Document;
use gltf::json::Root;
use gltf::texture::{Info, MagFilter, WrappingMode};

use super::buffers::{Buffers, decoded, inline};
use crate::common::{Budget, excerpt};
use crate::import::{Beside, Draft, Pictures};

/// Reads the textures of a file.
pub(super) struct Textures<'f, 'b> {
    json: &'f Root,
    buffers: &'f Buffers<'b>,
    beside: &'f mut Beside<'b>,
    pictures: Pictures<'b>,
}

impl<'f, 'b> Textures<'f, 'b> {
    pub(super) fn new(
        document: &'f Document,
        buffers: &'f Buffers<'b>,
        beside: &'f mut Beside<'b>,
        budget: &'b Budget<'b>,
    ) -> Self {
        Self { json: document.as_json(), buffers, beside, pictures: Pictures::new(budget) }
    }

    /// The texture, its alpha ignored; `None` where it cannot be had, which is said.
    pub(super) fn read(&mut self, info: &Info, material: usize, draft: &mut Draft) -> Option<Texture> {
        let texture = info.texture();
        let place = format!("material {material}");
        let Some(image) = texture.source() else {
            draft.notices.note("texture without a PNG or JPEG picture ignored", place);
            return None;
        };
        let picture = match self.picture(image.index()) {
            Ok(picture) => picture,
            Err(why) => {
                draft.notices.note(&format!("picture of a texture cannot be read: {why}"), place);
                return None;
            }
        };
        let sampler = texture.sampler();
        let filter = match sampler.mag_filter() {
            Some(MagFilter::Nearest) => TextureFilter::Nearest,
            Some(MagFilter::Linear) | None => TextureFilter::Linear,
        };
        let transform = transform(info).unwrap_or_else(|| {
            draft.notices.note("transform of a texture that is not finite ignored", place);
            Texture::PLAIN
        });
        let wrap = [wrap(sampler.wrap_s()), wrap(sampler.wrap_t())];
        Some(Texture { picture, transform, wrap, filter, alpha: TextureAlpha::Ignored })
    }

    fn picture(&mut self, index: usize) -> crate::import::Picture {
        let image = self.json.images.get(index).ok_or("it is not in the file")?;
        let numbered = || format!("picture {index}");
        match (&image.uri, &image.buffer_view) {
            (Some(uri), _) if uri.starts_with("data:") => {
                self.pictures.get(&numbered(), || inline(uri).map(Cow::Owned))
            }
            (Some(uri), _) => {
                let name = decoded(uri);
                let beside = &mut *self.beside;
                let read = || beside.read(&name).map(Cow::Owned);
                self.pictures.get(&name, read).map_err(|why| format!("`{}`: {why}", excerpt(&name)))
            }
            (None, Some(view)) => {
                let bytes = self.view(view.value());
                self.pictures
                    .get(&numbered(), || bytes.map(Cow::Borrowed).ok_or("its bytes are missing".into()))
            }
            (None, None) => Err("it names no file".to_owned()),
        }
    }

    fn view(&self, index: usize) -> Option<&'f [u8]> {
        let view = self.json.buffer_views.get(index)?;
        let start = usize::try_from(view.byte_offset.map_or(0, |offset| offset.0)).ok()?;
        let length = usize::try_from(view.byte_length.0).ok()?;
        self.buffers.get(view.buffer.value())?.get(start..start.checked_add(length)?)
    }
}

/// Which of a mesh's texture coordinates a texture uses.
pub(super) fn texcoord_set(info: &Info) -> u32 {
    info.texture_transform().and_then(|transform| transform.tex_coord()).unwrap_or_else(|| info.tex_coord())
}

/// KHR_texture_transform: scaled, then turned, then moved. A turn that is positive is counter-clockwise with v downwards.
fn transform(info: &Info) -> Option<[[f64; 3]; 2]> {
    const GREATEST: f64 = 1e9;
    let Some(transform) = info.texture_transform() else { return Some(Texture::PLAIN) };
    let [x, y] = transform.offset().map(f64::from);
    let [across, down] = transform.scale().map(f64::from);
    let angle = f64::from(transform.rotation());
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    let rows = [[cosine * across, sine * down, x], [-sine * across, cosine * down, y]];
    rows.iter().flatten().all(|c| c.abs() <= GREATEST).then_some(rows)
}

fn wrap(mode: WrappingMode) -> Wrap {
    match mode {
        WrappingMode::Repeat => Wrap::Repeat,
        WrappingMode::MirroredRepeat => Wrap::Mirror,
        WrappingMode::ClampToEdge => Wrap::Clamp,
    }
}
