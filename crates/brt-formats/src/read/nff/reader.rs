//! The commands of an NFF file, one after the other.

use std::ops::Range;

use brt_geometry::Vec3;
use brt_image::Rgb;
use brt_scene::{Diagnostic, Object, Shape};

use super::fill::Fills;
use super::patches::{Corner, Patches};
use super::polygon::{Polygon, polygon_shape};
use crate::common::{Budget, Cost, Halt, Problems, Word, Words};

/// The view as far as the file gives it.
#[derive(Default)]
pub(super) struct View {
    pub(super) from: Option<Vec3>,
    pub(super) at: Option<Vec3>,
    pub(super) up: Option<Vec3>,
    pub(super) angle: Option<f64>,
    pub(super) size: Option<[u32; 2]>,
    pub(super) span: Option<Range<usize>>,
    pub(super) size_span: Option<Range<usize>>,
}

/// A light; without a colour where the file leaves it to the number of lights.
pub(super) struct PlainLight {
    pub(super) position: Vec3,
    pub(super) color: Option<Rgb>,
    pub(super) span: Range<usize>,
}

/// What has been read so far.
pub(super) struct Reader<'b> {
    words: Words<'b>,
    budget: &'b Budget<'b>,
    patches: Option<Patches>,
    pub(super) problems: Problems,
    pub(super) view: View,
    pub(super) background: Rgb,
    pub(super) lights: Vec<PlainLight>,
    pub(super) fills: Fills,
    pub(super) objects: Vec<Object>,
    pub(super) spans: Vec<Range<usize>>,
}

/// Why a command was not read to its end.
pub(super) enum Stop {
    Fault(Diagnostic),
    Halt(Halt),
}

impl From<Diagnostic> for Stop {
    fn from(fault: Diagnostic) -> Self {
        Self::Fault(fault)
    }
}

impl From<Halt> for Stop {
    fn from(halt: Halt) -> Self {
        Self::Halt(halt)
    }
}

const COMMANDS: [&[u8]; 14] = [
    b"v",
    b"from",
    b"at",
    b"up",
    b"angle",
    b"hither",
    b"resolution",
    b"b",
    b"l",
    b"f",
    b"s",
    b"c",
    b"p",
    b"pp",
];

impl<'b> Reader<'b> {
    pub(super) fn new(bytes: &'b [u8], budget: &'b Budget<'b>) -> Self {
        Self {
            words: Words::new(bytes),
            budget,
            patches: None,
            problems: Problems::default(),
            view: View::default(),
            background: Rgb::BLACK,
            lights: Vec::new(),
            fills: Fills::default(),
            objects: Vec::new(),
            spans: Vec::new(),
        }
    }

    /// Reads all commands. After an error it goes on at the next command, to find further ones.
    pub(super) fn read_commands(&mut self) -> Result<(), Halt> {
        let mut understood = false;
        while let Some(word) = self.words.next() {
            self.budget.go_on()?;
            if !COMMANDS.contains(&word.bytes) {
                self.skip_unknown(&word);
                continue;
            }
            understood = true;
            match self.command(&word) {
                Ok(()) => {}
                Err(Stop::Halt(halt)) => return Err(halt),
                Err(Stop::Fault(fault)) => {
                    self.problems.push(fault);
                    if self.problems.is_full() {
                        break;
                    }
                    self.go_to_command();
                }
            }
        }
        self.finish_patches();
        if !understood {
            let message = "there is no NFF command in this file";
            self.problems.push(Diagnostic::error(message, None).expecting("lines such as `s 0 0 0 1`"));
        }
        Ok(())
    }

    fn command(&mut self, word: &Word) -> Result<(), Stop> {
        if word.bytes != b"pp" {
            self.finish_patches();
        }
        let start = word.span.start;
        match word.bytes {
            b"v" => self.view.span = Some(word.span.clone()),
            b"from" => self.view.from = Some(self.words.vector("`from x y z`")?),
            b"at" => self.view.at = Some(self.words.vector("`at x y z`")?),
            b"up" => self.view.up = Some(self.words.vector("`up x y z`")?),
            b"angle" => self.view.angle = Some(self.words.number("the angle in degrees")?),
            b"hither" => drop(self.words.number("the distance of the near plane")?),
            b"resolution" => self.resolution(start)?,
            b"b" => self.background = self.words.color("the background, `b red green blue`")?,
            b"l" => self.light(start)?,
            b"f" => self.fill(start)?,
            b"s" => self.sphere(start)?,
            b"c" => self.cone(start)?,
            b"p" => self.polygon(start)?,
            _ => self.patch(start)?,
        }
        Ok(())
    }

    fn skip_unknown(&mut self, word: &Word) {
        let span = Some(word.span.clone());
        let message = if word.is_number() {
            format!("the number {} belongs to no command: left out", word.excerpt())
        } else {
            // The rest of its line belongs to it.
            self.words.skip_line();
            format!("`{}` is not understood: the rest of its line is left out", word.excerpt())
        };
        self.problems.push(Diagnostic::warning(message, span));
    }

    fn go_to_command(&mut self) {
        while let Some(word) = self.words.peek() {
            if COMMANDS.contains(&word.bytes) {
                return;
            }
            self.words.next();
        }
    }

    fn resolution(&mut self, start: usize) -> Result<(), Stop> {
        const WHAT: &str = "the picture's size, `resolution width height`";
        let size = [self.words.whole(WHAT)?, self.words.whole(WHAT)?];
        self.budget.limits().allow_picture(size).map_err(Halt::from)?;
        self.view.size = Some(size);
        self.view.size_span = Some(start..self.words.position());
        Ok(())
    }

    fn light(&mut self, start: usize) -> Result<(), Stop> {
        let position = self.words.vector("the light's place, `l x y z`")?;
        let has_color = self.words.peek().is_some_and(|word| word.is_number());
        let color = if has_color { Some(self.words.color("the light's colour")?) } else { None };
        self.lights.push(PlainLight { position, color, span: start..self.words.position() });
        Ok(())
    }

    fn fill(&mut self, start: usize) -> Result<(), Stop> {
        self.budget.spend(Cost::Material, 1)?;
        self.fills.read(&mut self.words, start, &mut self.problems)?;
        // Some programs add the name of a texture, which must not be taken for a command.
        if self.words.line_goes_on()
            && let Some(word) = self.words.peek()
            && !word.is_number()
            && !COMMANDS.contains(&word.bytes)
        {
            self.words.skip_line();
            let message = format!("the texture `{}` is left out", word.excerpt());
            self.problems.push(Diagnostic::warning(message, Some(word.span)));
        }
        Ok(())
    }

    fn sphere(&mut self, start: usize) -> Result<(), Stop> {
        const WHAT: &str = "a sphere, `s x y z radius`";
        let center = self.words.vector(WHAT)?;
        let radius = self.words.number(WHAT)?.abs();
        let shape = Shape::Sphere { center, radius };
        self.add_unless(radius == 0.0, "a sphere without a radius", shape, start)
    }

    fn cone(&mut self, start: usize) -> Result<(), Stop> {
        const WHAT: &str = "a cone, `c x y z radius` and `x y z radius` again";
        let base = self.words.vector(WHAT)?;
        // A negative radius means that the inside is seen; here both sides are.
        let base_radius = self.words.number(WHAT)?.abs();
        let top = self.words.vector(WHAT)?;
        let top_radius = self.words.number(WHAT)?.abs();
        let shape = if base_radius == top_radius {
            Shape::Cylinder { base, top, radius: base_radius, capped: false }
        } else {
            Shape::Cone { base, base_radius, top, top_radius, capped: false }
        };
        let is_flat = (top - base).try_normalize().is_none() && base.is_finite() && top.is_finite();
        let is_thin = base_radius == 0.0 && top_radius == 0.0;
        self.add_unless(is_flat || is_thin, "a cone without a height or a radius", shape, start)
    }

    fn polygon(&mut self, start: usize) -> Result<(), Stop> {
        const WHAT: &str = "a point of the polygon, `x y z`";
        let count = self.words.whole("the number of points, `p count`")?;
        let mut points = Vec::new();
        for _ in 0..count {
            self.budget.spend(Cost::Point, 1)?;
            points.push(self.words.vector(WHAT)?);
        }
        let span = start..self.words.position();
        match polygon_shape(points) {
            Polygon::Flat(shape) => self.add(shape, span),
            Polygon::Bent(mesh) => {
                let message = "the polygon's points are not in one plane: cut into triangles";
                self.problems.push(Diagnostic::warning(message, Some(span.clone())));
                self.budget.spend(Cost::Triangle, mesh.triangles.len() as u64)?;
                self.add(mesh.into(), span)
            }
            Polygon::Nothing(why) => {
                self.left_out(why, span);
                Ok(())
            }
        }
    }

    fn patch(&mut self, start: usize) -> Result<(), Stop> {
        const WHAT: &str = "a point and normal of the patch, `x y z nx ny nz`";
        let count = self.words.whole("the number of points, `pp count`")?;
        let mut corners = Vec::new();
        for _ in 0..count {
            self.budget.spend(Cost::Point, 1)?;
            corners.push(Corner { position: self.words.vector(WHAT)?, normal: self.words.vector(WHAT)? });
        }
        self.budget.spend(Cost::Triangle, corners.len() as u64)?;
        let span = start..self.words.position();
        let patches = self.patches.get_or_insert_with(|| Patches::new(start));
        if let Err(why) = patches.add(&corners) {
            self.left_out(why, span);
        }
        Ok(())
    }

    /// Patches that follow each other are one mesh, which ends before any other command.
    fn finish_patches(&mut self) {
        if let Some(patches) = self.patches.take()
            && !patches.mesh.triangles.is_empty()
        {
            let span = patches.start..patches.start + 2;
            self.put(patches.mesh.into(), span);
        }
    }

    fn add_unless(&mut self, empty: bool, what: &str, shape: Shape, start: usize) -> Result<(), Stop> {
        let span = start..self.words.position();
        if empty {
            self.left_out(what, span);
            return Ok(());
        }
        self.add(shape, span)
    }

    fn add(&mut self, shape: Shape, span: Range<usize>) -> Result<(), Stop> {
        self.budget.spend(Cost::Shape, 1)?;
        self.put(shape, span);
        Ok(())
    }

    fn put(&mut self, shape: Shape, span: Range<usize>) {
        let material = self.fills.current(&span, &mut self.problems);
        self.objects.push(Object::new(shape, material));
        self.spans.push(span);
    }

    fn left_out(&mut self, what: &str, span: Range<usize>) {
        self.problems.push(Diagnostic::warning(format!("{what}: left out"), Some(span)));
    }
}
