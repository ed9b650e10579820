//! A model under construction, and what becomes of it: a whole scene.

use std::collections::HashMap;
use std::ops::Range;
use std::sync::Arc;

use brt_geometry::vec3;
use brt_image::{Rgb, rgb};
use brt_scene::framing::{Framing, Up, framed_camera, studio_lights};
use brt_scene::{Camera, Diagnostic, Material, MaterialId, Mesh, Object, Projection, Report, Scene, Shape};

use super::{Crease, Geometry, Given, Imported, Notices};
use crate::common::{Budget, Cost, Halt, LimitExceeded, ParseError};

/// Colour of what a file gives no colour: a light grey with a touch of blue, linear RGB.
const PLAIN: Rgb = rgb(0.55, 0.6, 0.66);

/// What has been read of a model so far.
pub(crate) struct Draft<'b> {
    pub(crate) scene: Scene,
    pub(crate) given: Given,
    pub(crate) notices: Notices,
    /// Only geometry is wanted.
    bare: bool,
    pub(crate) budget: &'b Budget<'b>,
    /// Points and triangles that are spent already and not used yet.
    expected: [u64; 2],
    tints: HashMap<(MaterialId, [u64; 3]), MaterialId>,
}

/// A mesh and its material, which objects may share.
#[derive(Clone)]
pub(crate) struct Part {
    mesh: Arc<Mesh>,
    material: MaterialId,
}

/// The meshes of a file without their materials, and what was not understood.
pub(crate) struct Meshes {
    pub(crate) meshes: Vec<Arc<Mesh>>,
    pub(crate) report: Report,
}

/// Why a file is not read to its end.
#[derive(Debug)]
pub(crate) enum Stop {
    /// It is broken.
    Fault(Diagnostic),
    /// It is good so far, and yet it ends.
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

impl From<LimitExceeded> for Stop {
    fn from(limit: LimitExceeded) -> Self {
        Self::Halt(limit.into())
    }
}

/// The file is broken, and where.
pub(crate) fn fault(message: impl Into<String>, span: Option<Range<usize>>) -> Stop {
    Stop::Fault(Diagnostic::error(message, span))
}

impl<'b> Draft<'b> {
    pub(crate) fn new(budget: &'b Budget<'b>, up: Up) -> Self {
        let stand_in = Camera {
            eye: vec3(0.0, 0.0, 1.0),
            look_at: vec3(0.0, 0.0, 0.0),
            up: up.direction(),
            projection: Projection::Perspective { fov_deg: 45.0 },
        };
        Self {
            scene: Scene::new(stand_in),
            given: Given { up, ..Given::nothing() },
            notices: Notices::default(),
            bare: false,
            budget,
            expected: [0; 2],
            tints: HashMap::new(),
        }
    }

    /// A model of which only the geometry is wanted: no materials, colours stay with their points.
    pub(crate) fn bare(budget: &'b Budget<'b>) -> Self {
        Self { bare: true, ..Self::new(budget, Up::PlusZ) }
    }

    pub(crate) fn is_bare(&self) -> bool {
        self.bare
    }

    /// The material of all that the file gives no colour.
    pub(crate) fn plain(&mut self) -> MaterialId {
        let scene = &mut self.scene;
        *self.given.plain.get_or_insert_with(|| {
            let mut material = Material::matte("default", PLAIN);
            (material.specular, material.exponent) = (0.12, 30.0);
            scene.add_material(material)
        })
    }

    /// Spends what points and triangles cost before there is memory for them; [`parts`](Self::parts) uses that up.
    pub(crate) fn expect(&mut self, points: usize, triangles: usize) -> Result<(), Halt> {
        let [points, triangles] = [points as u64, triangles as u64];
        self.budget.spend(Cost::Point, points)?;
        self.budget.spend(self.triangle(), triangles)?;
        self.expected = [self.expected[0] + points, self.expected[1] + triangles];
        Ok(())
    }

    /// Spends what is not spent yet of points and triangles that are there.
    fn use_up(&mut self, points: usize, triangles: usize) -> Result<(), Halt> {
        let used = [points as u64, triangles as u64];
        let [more_points, more_triangles] = [0, 1].map(|i| used[i].saturating_sub(self.expected[i]));
        self.expected = [0, 1].map(|i| self.expected[i].saturating_sub(used[i]));
        self.budget.spend(Cost::Point, more_points)?;
        self.budget.spend(self.triangle(), more_triangles)
    }

    /// What a triangle costs. Those of a mesh that others show are spent where they are shown.
    fn triangle(&self) -> Cost {
        if self.bare { Cost::Listed } else { Cost::Triangle }
    }

    /// Adds a material.
    pub(crate) fn add_material(&mut self, material: Material) -> Result<MaterialId, Halt> {
        self.budget.spend(Cost::Material, 1)?;
        Ok(self.scene.add_material(material))
    }

    /// Adds triangles; those without normals become smooth where `crease` lets them.
    pub(crate) fn add_geometry(
        &mut self,
        geometry: Geometry,
        crease: Option<&Crease>,
        material: MaterialId,
        name: Option<&str>,
    ) -> Result<(), Halt> {
        let parts = self.parts(geometry, crease, material, name)?;
        self.place(&parts, brt_geometry::Affine::IDENTITY, name)
    }

    /// The meshes that triangles become, for objects that share them.
    pub(crate) fn parts(
        &mut self,
        mut geometry: Geometry,
        crease: Option<&Crease>,
        material: MaterialId,
        name: Option<&str>,
    ) -> Result<Vec<Part>, Halt> {
        self.use_up(geometry.positions.len(), geometry.triangles.len())?;
        if geometry.normals.iter().any(|n| n.try_normalize().is_none()) {
            self.notices.note("normals of length 0 or not finite: computed instead", part(name));
            geometry.normals.clear();
        }
        if !self.bare && self.scene.materials[material.0 as usize].texture.is_none() {
            geometry.texcoords.clear();
        }
        // Smoothing groups are one per triangle and cannot lose any. A mesh that is only imported stays as it is.
        let keeps_all = crease.map_or(self.bare, Crease::has_groups);
        if !keeps_all {
            let flat = geometry.drop_degenerate();
            self.notices.note_many("triangles without an area left out", flat, part(name));
        }
        let parts = match crease {
            Some(crease) if geometry.normals.is_empty() => geometry.smoothed(crease, self.budget)?,
            _ => vec![geometry],
        };
        let bare = self.bare;
        let parts =
            parts.into_iter().flat_map(|part| if bare { vec![(None, part)] } else { part.by_color() });
        let parts = parts.filter(|(_, part)| !part.triangles.is_empty());
        let finished = parts.map(|(color, part)| {
            let material = color.map_or(Ok(material), |color| self.tinted(material, color))?;
            Ok(Part { mesh: Arc::new(part.into_mesh()), material })
        });
        finished.collect()
    }

    /// Adds parts somewhere.
    pub(crate) fn place(
        &mut self,
        parts: &[Part],
        at: brt_geometry::Affine,
        name: Option<&str>,
    ) -> Result<(), Halt> {
        self.budget.spend(Cost::Use, parts.len() as u64)?;
        self.scene.objects.extend(parts.iter().map(|part| Object {
            name: name.map(str::to_owned),
            transform: at,
            ..Object::new(Shape::Mesh(part.mesh.clone()), part.material)
        }));
        Ok(())
    }

    /// Spends what parts cost that are placed once more: they share their memory, but rendering copies their triangles.
    pub(crate) fn spend_again(&mut self, parts: &[Part]) -> Result<(), Halt> {
        parts.iter().try_for_each(|part| self.budget.spend(Cost::Triangle, part.mesh.triangles.len() as u64))
    }

    /// The same material, times a colour.
    fn tinted(&mut self, material: MaterialId, color: Rgb) -> Result<MaterialId, Halt> {
        let Self { scene, given, tints, budget, .. } = self;
        let key = (material, <[f64; 3]>::from(color).map(f64::to_bits));
        if let Some(&known) = tints.get(&key) {
            return Ok(known);
        }
        budget.spend(Cost::Material, 1)?;
        let mut tinted = scene.materials[material.0 as usize].clone();
        tinted.color = if given.plain == Some(material) { color } else { tinted.color * color };
        let id = scene.add_material(tinted);
        tints.insert(key, id);
        Ok(id)
    }

    /// Adds a shape that is no mesh.
    pub(crate) fn add_shape(
        &mut self,
        shape: Shape,
        material: MaterialId,
        name: Option<&str>,
    ) -> Result<(), Halt> {
        self.budget.spend(Cost::Shape, 1)?;
        self.scene.objects.push(Object { name: name.map(str::to_owned), ..Object::new(shape, material) });
        Ok(())
    }

    /// The meshes of a bare model.
    pub(crate) fn into_meshes(self) -> Meshes {
        let objects = self.scene.objects.into_iter();
        let meshes = objects.filter_map(|object| match object.shape {
            Shape::Mesh(mesh) => Some(mesh),
            _ => None,
        });
        Meshes { meshes: meshes.collect(), report: self.notices.into_report() }
    }

    /// What is said where a file was not read to its end.
    pub(crate) fn stopped(self, stop: Stop) -> ParseError {
        match stop {
            Stop::Halt(halt) => halt.into(),
            Stop::Fault(fault) => {
                let mut report = self.notices.into_report();
                report.push(fault);
                ParseError::Malformed(report)
            }
        }
    }

    /// Completes the scene: a camera that shows everything, lights and a white background where the file has none.
    pub(crate) fn finish(self) -> Result<Imported, ParseError> {
        let Self { mut scene, given, notices, budget, .. } = self;
        if scene.objects.is_empty() {
            let mut report = notices.into_report();
            report.push(Diagnostic::error("there is nothing to see in this file", None));
            return Err(ParseError::Malformed(report));
        }
        name_apart(&mut scene);
        budget.go_on()?;
        if !given.camera {
            scene.camera = framed_camera(&scene, &Framing::new(given.up));
        }
        if !given.lights {
            scene.lights = studio_lights(&scene.camera);
        }
        if !given.background {
            scene.background = Rgb::WHITE;
        }
        match scene.checked() {
            Ok(scene) => Ok(Imported { scene, report: notices.into_report(), given, files: Vec::new() }),
            Err(problems) => {
                let more = match problems.len() - 1 {
                    0 => String::new(),
                    others => format!(" (and {others} more)"),
                };
                let message = format!("{}{more}", problems[0].message);
                let mut report = notices.into_report();
                report.push(Diagnostic::error(message, None).expecting(problems[0].expected));
                Err(ParseError::Malformed(report))
            }
        }
    }
}

fn part(name: Option<&str>) -> String {
    name.map_or("a part without a name".to_owned(), |name| format!("`{name}`"))
}

/// Gives materials of the same name numbers: scenes are written by these names.
fn name_apart(scene: &mut Scene) {
    let mut seen = HashMap::<String, u32>::new();
    for material in &mut scene.materials {
        if material.name.is_empty() {
            "material".clone_into(&mut material.name);
        }
        let count = seen.entry(material.name.clone()).or_default();
        *count += 1;
        if *count > 1 {
            material.name = format!("{} ({count})", material.name);
        }
    }
}
