//! A scene that is written and read again is the same scene.

use std::sync::Arc;
use std::time::{Duration, Instant};

use crate::common::{EVERYTHING, good};
use brt_formats::{Format, Limits, parse, write_toml};
use brt_geometry::{Affine, Vec3, vec3};
use brt_image::{Rgb, rgb};
use brt_scene::{
    Axis, Camera, Checker, Highlight, Light, Material, MaterialId, Mesh, Object, Projection, Scene, Shape,
    Texels, Texture, TextureAlpha, TextureFilter, Wrap,
};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn a_random_scene_comes_back(scene in scene().prop_filter("valid", |s| s.check().is_empty())) {
        let text = write_toml(&scene);
        let (again, report) = parse(Format::Toml, text.as_bytes(), &Limits::default())
            .map_err(|error| TestCaseError::fail(format!("{error:?}\n{text}")))?;
        // Random objects cannot all show the texture of their material.
        prop_assert!(report.diagnostics.iter().all(|d| d.message.contains("texture not seen")));
        prop_assert_eq!(&*again, &scene);
        prop_assert_eq!(write_toml(&again), text);
    }
}

#[test]
fn everything_comes_back() {
    let (scene, _) = good(Format::Toml, EVERYTHING);
    assert_eq!(good(Format::Toml, &write_toml(&scene)).0, scene);
}

#[test]
fn materials_of_one_name_are_told_apart() {
    let (mut scene, _) = good(Format::Toml, EVERYTHING);
    for material in &mut scene.materials {
        material.name = "same".into();
    }
    let (again, _) = good(Format::Toml, &write_toml(&scene));
    assert_eq!(again.objects, scene.objects);
    assert_eq!(again.materials[0].name, "same");
    assert_ne!(again.materials[1].name, "same");
}

#[test]
fn a_mesh_of_100_000_triangles_is_written_and_read_fast() {
    const SIDE: u32 = 224;
    let (mut scene, _) = good(Format::Toml, EVERYTHING);
    let point = |i: u32| {
        let (x, y) = (f64::from(i % SIDE) / 7.0, f64::from(i / SIDE) / 7.0);
        vec3(x, y, libm::sin(x * 1.7) * libm::cos(y * 1.3))
    };
    let corner = (0..SIDE * SIDE).filter(|i| i % SIDE + 1 < SIDE && i / SIDE + 1 < SIDE);
    let mesh = Mesh {
        positions: (0..SIDE * SIDE).map(point).collect(),
        normals: (0..SIDE * SIDE).map(|i| point(i) + vec3(0.0, 0.0, 2.0)).collect(),
        triangles: corner.flat_map(|i| [[i, i + 1, i + SIDE], [i + 1, i + SIDE + 1, i + SIDE]]).collect(),
        ..Mesh::default()
    };
    assert!(mesh.triangles.len() > 99_000);
    scene.objects.push(Object::new(mesh.into(), MaterialId(0)));
    let start = Instant::now();
    let text = write_toml(&scene);
    let written = start.elapsed();
    let (again, _) = good(Format::Toml, &text);
    let read = start.elapsed() - written;
    assert_eq!(again, scene);
    assert!(text.lines().count() < 60_000);
    // About 0.03 and 0.2 s; generous for slow machines.
    assert!(written < Duration::from_secs(2) && read < Duration::from_secs(2), "{written:?} {read:?}");
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        -10.0..10.0,
        (-100_i32..100).prop_map(f64::from),
        any::<f64>().prop_filter("in range", |x| x.is_finite() && x.abs() < 1e30),
        Just(-0.0),
        Just(5e-324),
        Just(1e15),
        Just(999_999_999_999_999.0),
        Just(1e30),
    ]
}

fn positive() -> impl Strategy<Value = f64> {
    number().prop_map(|x| if x == 0.0 { 1.0 } else { x.abs() })
}

fn vector() -> impl Strategy<Value = Vec3> {
    [number(), number(), number()].prop_map(Vec3::from)
}

fn direction() -> impl Strategy<Value = Vec3> {
    vector().prop_filter("has a length", |v| v.try_normalize().is_some())
}

fn color() -> impl Strategy<Value = Rgb> {
    [positive(), positive(), positive()].prop_map(Rgb::from)
}

fn camera() -> impl Strategy<Value = Camera> {
    let projection = prop_oneof![
        (0.1..179.0).prop_map(|fov_deg| Projection::Perspective { fov_deg }),
        positive().prop_map(|extent| Projection::Orthographic { extent }),
    ];
    (vector(), direction(), projection).prop_map(|(eye, up, projection)| Camera {
        eye,
        look_at: vec3(-eye.y, 1.5, eye.x),
        up,
        projection,
    })
}

fn light() -> impl Strategy<Value = Light> {
    prop_oneof![
        (vector(), color()).prop_map(|(position, color)| Light::Point { position, color }),
        (vector(), direction(), color(), 0.0..90.0, 90.0..=180.0).prop_map(
            |(position, direction, color, inner_deg, outer_deg)| Light::Spot {
                position,
                direction,
                color,
                inner_deg,
                outer_deg
            }
        ),
        (direction(), color()).prop_map(|(direction, color)| Light::Directional { direction, color }),
    ]
}

fn name() -> impl Strategy<Value = String> {
    prop_oneof![any::<String>(), "[a-z]{1,8}", Just(String::new()), Just("\u{0}\u{7f}\u{85}\r\n\"'\\".into())]
}

fn material(name: String) -> impl Strategy<Value = Material> {
    let axis = prop_oneof![Just(Axis::X), Just(Axis::Y), Just(Axis::Z)];
    let checker = (color(), positive(), axis).prop_map(|(color, size, axis)| Checker { color, size, axis });
    let highlight = prop_oneof![Just(Highlight::Phong), Just(Highlight::Blinn)];
    let factors = vec(positive(), 7);
    let looks = (color(), 0.0..=1.0, option::of(texture()));
    (color(), option::of(checker), factors, highlight, any::<bool>(), looks).prop_map(
        move |(color, checker, f, highlight, casts_shadow, (emission, opacity, texture))| Material {
            emission,
            opacity,
            texture,
            name: name.clone(),
            color: rgb(-color.r, color.g, color.b),
            checker,
            ambient: f[0],
            diffuse: f[1],
            specular: f[2],
            exponent: f[3],
            highlight,
            reflection: f[4],
            transmission: f[5],
            index_of_refraction: f[6],
            casts_shadow,
        },
    )
}

fn texture() -> impl Strategy<Value = Texture> {
    let picture = (name(), 1_u32..4, 1_u32..4).prop_flat_map(|(name, width, height)| {
        vec(any::<[u8; 4]>(), (width * height) as usize)
            .prop_map(move |rgba| Arc::new(Texels { name: name.clone(), width, height, rgba }))
    });
    let wrap = || prop_oneof![Just(Wrap::Repeat), Just(Wrap::Mirror), Just(Wrap::Clamp)];
    let filter = prop_oneof![Just(TextureFilter::Nearest), Just(TextureFilter::Linear)];
    let alpha = prop_oneof![
        Just(TextureAlpha::Ignored),
        Just(TextureAlpha::Blend),
        (0.0..=1.0).prop_map(TextureAlpha::Mask)
    ];
    let row = || [number(), number(), number()];
    let transform = prop_oneof![Just(Texture::PLAIN), [row(), row()]];
    (picture, transform, [wrap(), wrap()], filter, alpha).prop_map(
        |(picture, transform, wrap, filter, alpha)| Texture { picture, transform, wrap, filter, alpha },
    )
}

fn polygon() -> impl Strategy<Value = Shape> {
    let point = |z: f64| (-9.0..9.0, -9.0..9.0).prop_map(move |(x, y)| vec3(x, y, z));
    (number(), vec(0.0..1.0, 0..3)).prop_flat_map(move |(z, holes)| {
        let holes: Vec<_> = holes.iter().map(|_| vec(point(z), 3..12)).collect();
        (vec(point(z), 3..12), holes).prop_map(|(outline, holes)| Shape::Polygon { outline, holes })
    })
}

fn mesh() -> impl Strategy<Value = Shape> {
    let points = vec((vector(), direction(), color(), [number(), number()]), 1..12);
    (points, any::<bool>(), any::<bool>(), any::<bool>()).prop_flat_map(
        |(points, smooth, colored, textured)| {
            let index = 0..points.len() as u32;
            vec([index.clone(), index.clone(), index], 0..12).prop_map(move |triangles| {
                let positions = points.iter().map(|(p, ..)| *p).collect();
                let normals = if smooth { points.iter().map(|(_, n, ..)| *n).collect() } else { Vec::new() };
                let colors =
                    if colored { points.iter().map(|(_, _, c, _)| *c).collect() } else { Vec::new() };
                let texcoords = if textured { points.iter().map(|(.., t)| *t).collect() } else { Vec::new() };
                Shape::from(Mesh { positions, normals, colors, triangles, texcoords })
            })
        },
    )
}

fn shape() -> impl Strategy<Value = Shape> {
    let axis =
        || (vector(), vector()).prop_filter("has a length", |(a, b)| (*b - *a).try_normalize().is_some());
    prop_oneof![
        (vector(), positive()).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        (direction(), number()).prop_map(|(normal, distance)| Shape::Plane { normal, distance }),
        polygon(),
        (vector(), direction(), positive()).prop_map(|(center, normal, radius)| Shape::Disc {
            center,
            normal,
            radius
        }),
        (axis(), positive(), any::<bool>()).prop_map(|((base, top), radius, capped)| Shape::Cylinder {
            base,
            top,
            radius,
            capped
        }),
        (axis(), positive(), positive(), any::<bool>()).prop_map(
            |((base, top), base_radius, top_radius, capped)| Shape::Cone {
                base,
                base_radius,
                top,
                top_radius,
                capped
            }
        ),
        mesh(),
    ]
}

/// Every other mesh once more, mirrored and moved.
fn with_twins(mut objects: Vec<Object>) -> Vec<Object> {
    let rows = [[-1.0, 0.0, 0.25, 1e-9], [0.0, 1.0, 0.0, 0.1], [0.0, 0.0, 1.0 / 3.0, -7e9]];
    let is_mesh = |object: &&Object| matches!(object.shape, Shape::Mesh(_));
    let twins = objects.iter().filter(is_mesh).step_by(2);
    let twins = twins.map(|object| Object { transform: Affine::from_rows(rows), ..object.clone() });
    objects.extend(twins.collect::<Vec<_>>());
    objects
}

fn scene() -> impl Strategy<Value = Scene> {
    let side = 1_u32..=1 << 17;
    let size = prop_oneof![[side.clone(), side], Just([u32::MAX, 1])];
    let size = option::of(size);
    let materials = proptest::collection::btree_set(name(), 1..6)
        .prop_flat_map(|names| names.into_iter().rev().map(material).collect::<Vec<_>>());
    let objects = vec((option::of(name()), shape(), any::<prop::sample::Index>()), 0..8);
    (camera(), size, color(), 0_u32..=1000, vec(light(), 0..4), materials, objects).prop_map(
        |(camera, size, background, max_depth, lights, materials, objects)| {
            let id = |i: prop::sample::Index| MaterialId(i.index(materials.len()) as u32);
            let objects: Vec<_> = objects
                .into_iter()
                .map(|(name, shape, i)| Object { name, ..Object::new(shape, id(i)) })
                .collect();
            let objects = with_twins(objects);
            Scene { camera, size, background, max_depth, lights, materials, objects }
        },
    )
}
