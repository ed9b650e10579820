//! The model's XML, in one pass: resources and what is built of them.

use std::borrow::Cow;
use std::collections::HashMap;
use std::io::BufRead;

use brt_geometry::{Vec3, vec3};
use brt_image::Rgb;
use quick_xml::Reader;
use quick_xml::events::attributes::Attribute;
use quick_xml::events::{BytesStart, Event};
use quick_xml::name::QName;

use crate::import::{Affine, Draft, Stop, fault, srgb};

/// What the file describes.
#[derive(Default)]
pub(super) struct Model {
    pub(super) objects: HashMap<u32, Object>,
    /// Colours of property groups by their id.
    pub(super) colors: HashMap<u32, Vec<Rgb>>,
    pub(super) items: Vec<Component>,
}

/// An object: a mesh, or others put together.
#[derive(Default)]
pub(super) struct Object {
    pub(super) name: Option<String>,
    pub(super) positions: Vec<Vec3>,
    /// Corners of each triangle.
    pub(super) triangles: Vec<[u32; 3]>,
    pub(super) components: Vec<Component>,
    /// The property of triangles that have none of their own.
    property: Property,
    /// Those of the first triangles, as far as any has its own.
    properties: Vec<Property>,
}

impl Object {
    /// The property of a triangle.
    pub(super) fn property(&self, triangle: usize) -> Property {
        self.properties.get(triangle).copied().unwrap_or(self.property)
    }
}

/// A property group and indices in it, one per corner.
#[derive(Clone, Copy, Default, PartialEq)]
pub(super) struct Property {
    pub(super) group: Option<u32>,
    pub(super) indices: [u32; 3],
}

/// An object somewhere.
pub(super) struct Component {
    pub(super) object: u32,
    pub(super) transform: Affine,
}

/// Reads the model.
pub(super) fn read(bytes: &mut dyn BufRead, draft: &mut Draft) -> Result<Model, Stop> {
    let mut reader = Reader::from_reader(bytes);
    let mut buffer = Vec::new();
    let mut parser = Parser { model: Model::default(), object: None, group: None };
    loop {
        let position = reader.buffer_position();
        buffer.clear();
        match reader.read_event_into(&mut buffer) {
            Ok(Event::Start(tag) | Event::Empty(tag)) => parser.open(&tag, draft)?,
            Ok(Event::End(tag)) if tag.local_name().as_ref() == "object" => parser.end_object(),
            Ok(Event::Eof) => return Ok(parser.model),
            Ok(_) => {}
            Err(error) => {
                return Err(fault(format!("the model's XML is broken at byte {position}: {error}"), None));
            }
        }
    }
}

struct Parser {
    model: Model,
    object: Option<(u32, Object)>,
    /// The property group whose members follow.
    group: Option<u32>,
}

impl Parser {
    fn open(&mut self, tag: &BytesStart, draft: &mut Draft) -> Result<(), Stop> {
        let attributes = Attributes::of(tag)?;
        match tag.local_name().as_ref() {
            "object" => self.object(&attributes)?,
            "vertex" => {
                draft.expect(1, 0)?;
                let p = vec3(attributes.number("x")?, attributes.number("y")?, attributes.number("z")?);
                if let Some((_, object)) = &mut self.object {
                    object.positions.push(p);
                }
            }
            "triangle" => self.triangle(&attributes, draft)?,
            "component" => {
                let component = component(&attributes)?;
                if let Some((_, object)) = &mut self.object {
                    object.components.push(component);
                }
            }
            "item" => self.model.items.push(component(&attributes)?),
            "basematerials" | "colorgroup" => {
                let id = attributes.whole("id")?;
                if self.model.colors.insert(id, Vec::new()).is_some() {
                    return Err(fault(format!("two resources have the id {id}"), None));
                }
                self.group = Some(id);
            }
            "base" => self.color(attributes.text("displaycolor"), tag)?,
            "color" => self.color(attributes.text("color"), tag)?,
            "texture2dgroup" | "texture2d" | "multiproperties" | "compositematerials" | "beamlattice" => {
                self.group = None;
                let name = tag.local_name().as_ref().to_owned();
                draft.notices.note(&format!("`{name}` ignored"), "the resources".to_owned());
            }
            _ => {}
        }
        Ok(())
    }

    fn object(&mut self, attributes: &Attributes) -> Result<(), Stop> {
        let property = Property {
            group: attributes.optional("pid")?,
            indices: [attributes.optional("pindex")?.unwrap_or(0); 3],
        };
        let name = attributes.text("name").map(str::to_owned);
        self.object = Some((attributes.whole("id")?, Object { name, property, ..Object::default() }));
        Ok(())
    }

    fn end_object(&mut self) {
        if let Some((id, object)) = self.object.take() {
            self.model.objects.insert(id, object);
        }
    }

    fn triangle(&mut self, attributes: &Attributes, draft: &mut Draft) -> Result<(), Stop> {
        draft.expect(0, 1)?;
        let Some((_, object)) = &mut self.object else { return Ok(()) };
        let corners = [attributes.whole("v1")?, attributes.whole("v2")?, attributes.whole("v3")?];
        let first = attributes.optional("p1")?;
        let property = match (attributes.optional("pid")?.or(object.property.group), first) {
            (group, Some(first)) => {
                let other = |name| Ok::<u32, Stop>(attributes.optional(name)?.unwrap_or(first));
                Property { group, indices: [first, other("p2")?, other("p3")?] }
            }
            (_, None) => object.property,
        };
        if property != object.property {
            object.properties.resize(object.triangles.len(), object.property);
            object.properties.push(property);
        }
        object.triangles.push(corners);
        Ok(())
    }

    fn color(&mut self, text: Option<&str>, tag: &BytesStart) -> Result<(), Stop> {
        let Some(id) = self.group else { return Ok(()) };
        let Some(color) = text.and_then(hex) else {
            let name = tag.local_name().as_ref().to_owned();
            return Err(fault(format!("`{name}` of resource {id} has no colour, expected `#RRGGBB`"), None));
        };
        self.model.colors.entry(id).or_default().push(color);
        Ok(())
    }
}

fn component(attributes: &Attributes) -> Result<Component, Stop> {
    let transform = match attributes.text("transform") {
        None => Affine::IDENTITY,
        Some(text) => {
            let numbers: Vec<f64> = text.split_ascii_whitespace().map_while(|n| n.parse().ok()).collect();
            let Ok(m) = <[f64; 12]>::try_from(numbers) else {
                return Err(fault("a transform that is not of twelve numbers", None));
            };
            let row = |i: usize| vec3(m[3 * i], m[3 * i + 1], m[3 * i + 2]);
            Affine { x: row(0), y: row(1), z: row(2), origin: row(3) }
        }
    };
    Ok(Component { object: attributes.whole("objectid")?, transform })
}

/// `#RRGGBB` or `#RRGGBBAA`.
fn hex(text: &str) -> Option<Rgb> {
    let digits = text.trim().strip_prefix('#').filter(|d| d.len() == 6 || d.len() == 8)?;
    let code = u32::from_str_radix(digits.get(..6)?, 16).ok()?;
    let channel = |shift: u32| f64::from(code >> shift & 255) / 255.0;
    Some(srgb([channel(16), channel(8), channel(0)]))
}

/// The attributes of a tag, without prefixes.
struct Attributes<'t> {
    tag: &'t BytesStart<'t>,
    values: Vec<(QName<'t>, Cow<'t, str>)>,
}

impl<'t> Attributes<'t> {
    fn of(tag: &'t BytesStart) -> Result<Self, Stop> {
        let name = || tag.local_name().as_ref().to_owned();
        let mut values = Vec::with_capacity(4);
        for attribute in tag.attributes().with_checks(false) {
            let Attribute { key, value } =
                attribute.map_err(|error| fault(format!("attributes of `{}`: {error}", name()), None))?;
            values.push((key, value));
        }
        Ok(Self { tag, values })
    }

    fn text(&self, key: &str) -> Option<&str> {
        self.values.iter().find(|(k, _)| k.local_name().as_ref() == key).map(|(_, value)| &**value)
    }

    fn number(&self, key: &str) -> Result<f64, Stop> {
        self.text(key).and_then(|text| text.trim().parse().ok()).ok_or_else(|| self.missing(key, "a number"))
    }

    fn whole(&self, key: &str) -> Result<u32, Stop> {
        self.optional(key)?.ok_or_else(|| self.missing(key, "a whole number"))
    }

    fn optional(&self, key: &str) -> Result<Option<u32>, Stop> {
        let parsed =
            self.text(key).map(|text| text.trim().parse().map_err(|_| self.missing(key, "a whole number")));
        parsed.transpose()
    }

    fn missing(&self, key: &str, expected: &str) -> Stop {
        fault(format!("`{}` has no `{key}`, expected {expected}", self.tag.local_name().as_ref()), None)
    }
}
