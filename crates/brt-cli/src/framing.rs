//! Options that put a scene into the picture.

use brt::framing::{Framing, Up, View, add_floor, framed_camera, studio_lights};
use brt::{Backdrop, Given, Rgb, Scene};
use clap::Args;

use crate::exit::{Failure, wrong_use};
use crate::values::{self, Background};

/// Options for looking at scenes, above all at those without a camera.
#[derive(Clone, Debug, Args)]
#[command(next_help_heading = "View")]
pub(crate) struct ViewOptions {
    /// From where: iso, front, back, left, right, top, bottom, or degrees AZIMUTH,ELEVATION from the front towards the
    /// right and upwards [default: the scene's camera, else iso]
    #[arg(long, value_name = "VIEW", value_parser = values::view, allow_hyphen_values = true)]
    pub(crate) view: Option<View>,
    /// Which direction points up: +x, -x, +y, -y, +z or -z [default: by format, +z for STL, PLY, OFF, 3MF and NFF, else +y]
    #[arg(long, value_name = "AXIS", value_parser = values::up, allow_hyphen_values = true)]
    up: Option<Up>,
    /// Enlargement of a framed view; at 1 everything is in the picture
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true, value_parser = values::positive)]
    zoom: Option<f64>,
    /// Parallel rays in a framed view, as in drawings
    #[arg(long)]
    parallel: bool,
    /// Put an endless floor under everything
    #[arg(long)]
    floor: bool,
    /// Four views in one picture: iso, front, right and top
    #[arg(long, conflicts_with_all = ["view", "pixel", "layers", "stats", "verify", "max_error", "no_save"])]
    pub(crate) sheet: bool,
    /// Colour of all that the file gives none: #rrggbb or a name, such as red, orange, green, blue or silver
    #[arg(long, value_name = "COLOR", value_parser = values::color)]
    color: Option<Rgb>,
    /// What is behind everything: #rrggbb, a name, or `transparent`, which gives .png and .exr an alpha; mirrors and glass
    /// still show the scene's own background then [default: the scene's, else white]
    #[arg(long, value_name = "COLOR", value_parser = values::background)]
    background: Option<Background>,
    /// Same as --background transparent
    #[arg(long, conflicts_with = "background")]
    no_background: bool,
}

/// Fits the view into a picture of this size if the file says nothing about the view.
pub(crate) fn frame(scene: &mut Scene, given: &Given, size: [u32; 2]) {
    if given.camera {
        return;
    }
    scene.camera = framed_camera(scene, &Framing { size, ..Framing::new(given.up) });
    if !given.lights {
        scene.lights = studio_lights(&scene.camera);
    }
}

impl ViewOptions {
    /// Changes the scene as the options ask for.
    pub(crate) fn apply(&self, scene: &mut Scene, given: &Given, size: [u32; 2]) -> Result<(), Failure> {
        self.paint(scene, given)?;
        if self.frames(given) {
            self.look(scene, given, self.view, size);
        }
        self.stand(scene, given);
        Ok(())
    }

    /// What the camera sees behind everything.
    pub(crate) fn backdrop(&self) -> Backdrop {
        if self.no_background || self.background == Some(Background::Transparent) {
            Backdrop::Transparent
        } else {
            Backdrop::Scene
        }
    }

    /// `--color` and the colour of `--background`
    pub(crate) fn paint(&self, scene: &mut Scene, given: &Given) -> Result<(), Failure> {
        if let Some(Background::Color(color)) = self.background {
            scene.background = color;
        }
        if let Some(color) = self.color {
            let Some(plain) = given.plain else {
                return Err(wrong_use("`--color` is for files without colours, and this one has its own"));
            };
            scene.materials[plain.0 as usize].color = color;
        }
        Ok(())
    }

    /// Looks at everything from a side, by default iso.
    pub(crate) fn look(&self, scene: &mut Scene, given: &Given, view: Option<View>, size: [u32; 2]) {
        let framing = Framing {
            view: view.unwrap_or_default(),
            up: self.up.unwrap_or(given.up),
            zoom: self.zoom.unwrap_or(1.0),
            parallel: self.parallel,
            size,
        };
        scene.camera = framed_camera(scene, &framing);
        if !given.lights {
            scene.lights = studio_lights(&scene.camera);
        }
    }

    /// `--floor`
    pub(crate) fn stand(&self, scene: &mut Scene, given: &Given) {
        if self.floor {
            add_floor(scene, self.up.unwrap_or(given.up));
        }
    }

    /// Is the view chosen here, and not by the file?
    fn frames(&self, given: &Given) -> bool {
        !given.camera || self.view.is_some() || self.up.is_some() || self.zoom.is_some() || self.parallel
    }
}
