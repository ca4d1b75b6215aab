//! Files written and read again, in every format, and by a reader that is not ours.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod common;

use common::{round, sample, summary};
use katydid_exchange::{Error, Format, Options, PointSet, Scene, Shape, Thing, read, write};
use katydid_geometry::{Point3, Vector3};

const READ: [Format; 5] = [Format::Obj, Format::Stl, Format::Ply, Format::Glb, Format::Gltf];

fn written(scene: &Scene, format: Format, options: &Options) -> Vec<u8> {
    let mut bytes = Vec::new();
    write(scene, format, options, &mut bytes).unwrap();
    bytes
}

#[test]
fn what_is_written_is_read_again() {
    let scene = sample();
    for format in READ {
        for ascii in [false, true] {
            let bytes = written(&scene, format, &Options { ascii, ..Options::default() });
            let back = read(&bytes, format).unwrap();
            assert_eq!(back.left_out, [], "{format:?}");
            // STL and glTF are of single precision, and glTF measures in metres.
            let single = matches!(format, Format::Stl | Format::Glb | Format::Gltf);
            let scale = if matches!(format, Format::Glb | Format::Gltf) { 1000.0 } else { 1.0 };
            let (ours, theirs) = (summary(&scene, 1.0), summary(&back, scale));
            let near = |a: f64, b: f64| (a - b).abs() <= if single { 1e-4 } else { 1e-12 } * (1.0 + a.abs());
            assert!(near(ours.area, theirs.area), "{format:?}: {ours:?} {theirs:?}");
            assert_eq!(ours.meshes.min(1), theirs.meshes.min(1), "{format:?}");
            if format != Format::Stl {
                assert!(near(ours.length, theirs.length), "{format:?}: {ours:?} {theirs:?}");
                let [a, b] = [ours.bounds, theirs.bounds];
                assert!(
                    a.min.distance_to(b.min) < 1e-3 && a.max.distance_to(b.max) < 1e-3,
                    "{format:?}: {a:?} {b:?}"
                );
            }
        }
    }
}

#[test]
fn names_layers_and_colours_come_back_where_the_format_has_them() {
    let scene = sample();
    for format in [Format::Glb, Format::Gltf] {
        let back = read(&written(&scene, format, &Options::default()), format).unwrap();
        let names: Vec<&str> = back.things.iter().map(|thing| thing.name.as_str()).collect();
        assert_eq!(names.iter().filter(|name| **name == "mesh \"<&>\" ü\n").count(), 1, "{names:?}");
        let thing = back.things.iter().find(|thing| thing.name.starts_with("mesh")).unwrap();
        assert_eq!(thing.colour, Some([200, 30, 7, 128]));
        let layer = &back.layers[thing.layer.unwrap()];
        assert_eq!(
            (layer.name.as_str(), layer.parent.map(|i| back.layers[i].name.as_str())),
            ("inner", Some("outer"))
        );
    }
    let back = read(&written(&scene, Format::Obj, &Options::default()), Format::Obj).unwrap();
    let mesh = back.things.iter().find(|thing| thing.name.starts_with("mesh")).unwrap();
    assert_eq!(mesh.name, "mesh_\"<&>\"_ü_");
    assert_eq!(back.layers[mesh.layer.unwrap()].name, "inner");
}

#[test]
fn colours_of_vertices_come_back() {
    let colours = vec![[0, 1, 2, 255], [3, 128, 254, 255], [255, 77, 40, 255]];
    let points = vec![Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 2.0, 0.0)];
    let set = PointSet { points, normals: vec![Vector3::Z; 3], colours };
    let scene = Scene { things: vec![Thing::named("cloud", Shape::Points(set.clone()))], ..Scene::default() };
    for format in [Format::Obj, Format::Ply, Format::Glb, Format::Gltf] {
        let back = read(&written(&scene, format, &Options::default()), format).unwrap();
        let [Thing { shape: Shape::Points(found), .. }] = back.things.as_slice() else {
            panic!("{format:?}: {back:?}")
        };
        assert_eq!(found.colours, set.colours, "{format:?}");
        if format != Format::Obj {
            assert_eq!(found.normals, set.normals, "{format:?}");
        }
    }
}

#[test]
fn an_empty_scene_is_a_file_too() {
    for format in Format::ALL {
        for ascii in [false, true] {
            let bytes = written(&Scene::default(), format, &Options { ascii, ..Options::default() });
            if format != Format::Svg {
                assert_eq!(read(&bytes, format).unwrap().things, [], "{format:?}");
            }
        }
    }
}

#[test]
fn nan_and_infinity_are_refused() {
    for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let thing = Thing::named("bad", Shape::Points(vec![Point3::new(0.0, x, 0.0)].into()));
        let scene = Scene { things: vec![thing], ..Scene::default() };
        for format in Format::ALL {
            let error = write(&scene, format, &Options::default(), &mut Vec::new()).unwrap_err();
            assert!(matches!(&error, Error::Coordinate { what, .. } if what == "bad"), "{error}");
        }
    }
}

#[test]
fn a_destination_that_fails_is_an_error() {
    struct Full;
    impl std::io::Write for Full {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::Error::other("the disk is full"))
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    for format in Format::ALL {
        let error = write(&sample(), format, &Options::default(), &mut Full).unwrap_err();
        assert!(error.to_string().contains("the disk is full"), "{format:?}: {error}");
    }
}

#[test]
fn the_gltf_crate_finds_nothing_wrong() {
    for format in [Format::Glb, Format::Gltf] {
        for scene in [sample(), Scene::default(), round()] {
            let bytes = written(&scene, format, &Options::default());
            let file = gltf::Gltf::from_slice(&bytes).unwrap();
            let blob = file.blob.as_deref().unwrap_or_default();
            let mut vertices = 0;
            for primitive in file.meshes().flat_map(|mesh| mesh.primitives().collect::<Vec<_>>()) {
                let reader = primitive.reader(|_| (format == Format::Glb).then_some(blob));
                let Some(positions) = reader.read_positions() else { continue };
                let bounds = primitive.bounding_box();
                for p in positions {
                    vertices += 1;
                    assert!((0..3).all(|i| bounds.min[i] <= p[i] && p[i] <= bounds.max[i]));
                }
                for n in reader.read_normals().into_iter().flatten() {
                    assert!((n.iter().map(|x| x * x).sum::<f32>() - 1.0).abs() < 1e-5);
                }
            }
            assert_eq!(vertices > 0, format == Format::Glb && !scene.things.is_empty());
        }
    }
}

#[test]
fn things_far_from_the_origin_keep_their_form() {
    // A millimetre's detail ten kilometres out is lost to single precision unless the thing has a place of its own.
    let far = Vector3::new(1e7, -2e7, 3e6);
    let points =
        vec![Point3::ORIGIN + far, Point3::new(0.001, 0.0, 0.0) + far, Point3::new(0.0, 0.002, 0.001) + far];
    let cloud = Thing::named("", Shape::Points(points.clone().into()));
    let scene = Scene { things: vec![cloud], ..Scene::default() };
    let back = read(&written(&scene, Format::Glb, &Options::default()), Format::Glb).unwrap();
    let [Thing { shape: Shape::Points(found), .. }] = back.things.as_slice() else { panic!("{back:?}") };
    for (a, b) in points.iter().zip(&found.points) {
        let b = Point3::ORIGIN + b.to_vector() * 1000.0;
        assert!(a.distance_to(b) < 1e-7, "{a:?} {b:?}");
    }
}

/// The list for the studio, as TypeScript.
fn studio_list() -> String {
    let names: Vec<String> = Format::ALL.iter().map(|format| format!("{:?}", format.extension())).collect();
    format!(
        "// From the table of formats in crates/exchange/src/format.rs. `KATYDID_REFRESH_PAGES=1 cargo test -p katydid-exchange`\n\
         // writes it.\n\n\
         /** The formats that geometry is exported in, beside Rhino's own and pictures. */\n\
         export const EXCHANGE_FORMATS = [{}] as const;\n",
        names.join(", ")
    )
}

#[test]
fn the_studio_offers_every_format() {
    let file =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studio/src/core/exchangeFormats.ts");
    if std::env::var_os("KATYDID_REFRESH_PAGES").is_some() {
        std::fs::write(&file, studio_list()).unwrap();
    }
    assert_eq!(std::fs::read_to_string(file).unwrap(), studio_list());
}
