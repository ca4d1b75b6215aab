//! Meshes, SubDs and point clouds that programs have written though they make no sense, and bytes that nobody vouches
//! for.
#![allow(clippy::unwrap_used, reason = "helpers of tests only")]

use katydid_3dm::{MeshObject, ModelObject, Ngon, Object, PointCloud, SubDObject};
use katydid_geometry::subd::{SubD, SubDNet};
use katydid_geometry::{Mesh, MeshFace, Point3};

const VERSIONS: [i32; 5] = [4, 50, 60, 70, 80];

fn square() -> MeshObject {
    let points = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.1));
    Mesh::new(points.to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap().into()
}

fn subd() -> SubDObject {
    let points = (0..9).map(|i| Point3::new(f64::from(i % 3), f64::from(i / 3), 0.3)).collect();
    let quads = [0, 1, 3, 4].map(|i| vec![i, i + 1, i + 4, i + 3]);
    SubDObject::from(&SubD::new(SubDNet::from_polygons(points, &quads).unwrap()))
}

fn written(object: &Object, version: i32) -> (i32, Vec<u8>) {
    let form = ModelObject::from(object.clone()).to_on_data(version).unwrap();
    (form.opennurbs, form.data)
}

/// What the bytes say is what was written, numbers that are none included: written again they are the same bytes.
#[test]
fn odd_meshes_come_back_byte_for_byte() {
    let nan = MeshObject {
        vertices: vec![[f32::NAN, f32::INFINITY, -0.0]; 4],
        double_vertices: vec![],
        ..square()
    };
    let cases: Vec<(&str, bool, MeshObject)> = vec![
        ("as it should be", true, square()),
        ("nothing at all", true, MeshObject::default()),
        ("vertices that are not numbers", false, nan),
        ("a face beyond the vertices", false, MeshObject { faces: vec![[0, 1, 2, 250]], ..square() }),
        ("a degenerate face", true, MeshObject { faces: vec![[1, 1, 1, 1]], ..square() }),
        ("faces without vertices", false, MeshObject { faces: vec![[0, 1, 2, 3]], ..MeshObject::default() }),
        ("two normals", true, MeshObject { normals: vec![[0.0, 0.0, 1.0]; 2], ..square() }),
        ("normals that are not numbers", true, MeshObject { normals: vec![[f32::NAN; 3]; 4], ..square() }),
        (
            "everything a vertex can have",
            true,
            MeshObject {
                normals: vec![[0.0, 0.0, 1.0]; 4],
                texture_coordinates: vec![[0.5, 0.25]; 4],
                curvatures: vec![[1.0, -1.0]; 4],
                colours: vec![[1, 2, 3, 4]; 4],
                surface_parameters: vec![[3.0, 4.0]; 4],
                ngons: vec![Ngon { vertices: vec![0, 1, 2], faces: vec![0] }],
                closed: Some(false),
                manifold: 1,
                oriented: 2,
                solid: 3,
                ..square()
            },
        ),
    ];
    for (name, fits_the_kernel, mesh) in cases {
        assert_eq!(mesh.to_mesh().is_ok(), fits_the_kernel, "{name}");
        let object = Object::Mesh(Box::new(mesh));
        for version in VERSIONS {
            let (opennurbs, bytes) = written(&object, version);
            let back = ModelObject::from_on_data(version, opennurbs, &bytes).unwrap();
            let again = back.to_on_data(version).unwrap();
            assert!(again.data == bytes, "{name} as {version}");
        }
    }
}

#[test]
fn clouds_keep_what_makes_no_sense() {
    let cloud = PointCloud {
        points: vec![Point3::new(f64::NAN, 1.0, f64::INFINITY); 3],
        colours: vec![[1, 2, 3, 0]; 2],
        values: vec![0.5; 3],
        plane: std::array::from_fn(|i| i as f64),
        bounds: [[0.0; 3], [2.0; 3]],
        flags: 3,
        ..PointCloud::default()
    };
    for version in VERSIONS {
        let (opennurbs, bytes) = written(&Object::PointCloud(cloud.clone()), version);
        let Object::PointCloud(back) = Object::from_on_data(version, opennurbs, &bytes).unwrap() else {
            panic!("a cloud comes back as something else");
        };
        assert_eq!((&back.colours, &back.values, back.plane), (&cloud.colours, &cloud.values, cloud.plane));
        assert_eq!((back.bounds, back.flags, back.points.len()), (cloud.bounds, cloud.flags, 3));
    }
}

#[test]
fn subds_come_back_from_meshes_that_stand_for_them_too() {
    let subd = subd();
    let object = Object::SubD(Box::new(subd.clone()));
    for version in [4, 50, 60, 70, 80] {
        let (opennurbs, bytes) = written(&object, version);
        let Object::SubD(back) = Object::from_on_data(version, opennurbs, &bytes).unwrap() else {
            panic!("a SubD comes back as something else");
        };
        assert_eq!(back.levels, subd.levels, "{version}");
        assert_eq!(back.to_subd().unwrap(), subd.to_subd().unwrap());
        assert!(written(&Object::SubD(back), version).1 == bytes, "{version}");
    }
    // Without faces there is no mesh to stand for one.
    let empty = Object::SubD(Box::default());
    for version in [4, 50] {
        assert!(empty.check_writable(version).unwrap_err().to_string().contains("a SubD"));
        assert!(empty.to_on_data(version).is_err());
    }
}

/// Every place of a body overwritten with what counts and sizes fear most: an error or another object, never a
/// panic, nor memory that the bytes do not pay for.
#[test]
fn broken_counts_are_survived() {
    let mesh: MeshObject = Mesh::new(
        (0..300).map(|i| Point3::new(f64::from(i) / 3.0, f64::from(i % 7), 0.1)).collect(),
        (0..298).map(|i| MeshFace::Triangle([i, i + 1, i + 2])).collect(),
    )
    .unwrap()
    .into();
    let mesh = MeshObject {
        ngons: vec![Ngon { vertices: vec![0, 1, 2], faces: vec![0] }],
        parameters: Some(Box::default()),
        ..mesh
    };
    let objects = [
        Object::Mesh(Box::new(mesh)),
        Object::SubD(Box::new(subd())),
        Object::PointCloud(PointCloud::from(vec![Point3::ORIGIN; 9])),
    ];
    for object in objects {
        for version in [50, 60, 70, 80] {
            let Ok(form) = object.to_on_data(version) else { continue };
            for lie in [0, 1, 0x7F, 0xFFFF, 0x7FFF_FFFF, 0x8000_0000, u32::MAX] {
                for place in
                    (0..form.data.len().saturating_sub(4)).step_by(if form.data.len() > 3000 { 3 } else { 1 })
                {
                    let mut bytes = form.data.clone();
                    bytes[place..place + 4].copy_from_slice(&u32::to_le_bytes(lie));
                    if let Ok(Object::SubD(read)) = Object::from_on_data(version, form.opennurbs, &bytes) {
                        let _ = read.to_subd();
                    }
                }
            }
            for end in 0..form.data.len().min(2000) {
                assert!(Object::from_on_data(version, form.opennurbs, &form.data[..end]).is_err());
            }
        }
    }
}
