//! SubDs.

use katydid_geometry::subd::{FromMesh, SubD, SubDNet, SubDVertex};
use katydid_geometry::{BoundingBox, Brep, Mesh, Point3, Tolerance, Vector3};
use serde_json::Value as Json;

use super::answer::Outcome;
use super::table::Endpoints;
use crate::Fault;
use crate::wire::{Members, Read, Subdivision};

pub(super) fn enter(table: &mut Endpoints) {
    table.add("subd/createfrommesh-mesh", |m: Mesh| of_mesh(&m, Options::default()));
    table.add("subd/createfrommesh-mesh_subdcreationoptions", |m: Mesh, options: Option<Options>| {
        of_mesh(&m, options.unwrap_or_default())
    });
    // How faces are packed is up to the kernel, and extraordinary vertices have one treatment only.
    table.add("subd/tobrep-subd_subdtobrepoptions", |s: Subdivision| to_brep(&s.0));
    table.add("subd/interpolatesurfacepoints-subd_point3darray", |s: Subdivision, points: Vec<Point3>| {
        interpolating(&s.0, &points).map(|subd| (true, Subdivision(subd)))
    });
    table.add("subd/offset-subd_double_bool", |s: Subdivision, distance: f64, solid: bool| {
        if solid {
            return Err(Fault::not_supported("offset SubDs closed to solids"));
        }
        offset(&s.0, distance).map(Subdivision)
    });
}

/// The surface as a brep, near it by the document's tolerance, or by a small share of its size where that is more.
fn to_brep(subd: &SubD) -> Outcome<Brep> {
    let points = subd.net().vertices().iter().map(|vertex| vertex.point);
    let size = BoundingBox::from_points(points).map_or(0.0, |bounds| bounds.diagonal().length());
    Ok(subd.to_brep(Tolerance::default().absolute.max(1e-4 * size))?)
}

/// The SubD with its control points so that the surface goes through points, one for each vertex.
fn interpolating(subd: &SubD, points: &[Point3]) -> Outcome<SubD> {
    let net = subd.net();
    if points.len() != net.vertices().len() {
        let (given, wanted) = (points.len(), net.vertices().len());
        return Err(Fault::bad_request(format!("surfacePoints has {given} points for {wanted} vertices")));
    }
    let moved = |(vertex, point): (&SubDVertex, &Point3)| SubDVertex { point: *point, ..vertex.clone() };
    let vertices = net.vertices().iter().zip(points).map(moved).collect();
    let moved = SubDNet::from_parts(vertices, net.edges().to_vec(), net.faces().to_vec())?;
    Ok(SubD::new(moved.interpolating()?.0))
}

/// The SubD with its control points moved along the normals of the control net: at each the mean of the unit normals of
/// the faces around it.
fn offset(subd: &SubD, distance: f64) -> Outcome<SubD> {
    let net = subd.net();
    let point = |v: usize| net.vertices().get(v).map_or(Point3::ORIGIN, |vertex| vertex.point);
    let normals = (0..net.faces().len()).map(|face| {
        let corners: Vec<Point3> = net.corners(face).map(point).collect();
        let middle = net.face_middle(face);
        let next = corners.iter().cycle().skip(1);
        let turned = corners.iter().zip(next).map(|(a, b)| (*a - middle).cross(*b - middle));
        turned.sum::<Vector3>().unitized().unwrap_or(Vector3::ZERO)
    });
    let normals: Vec<Vector3> = normals.collect();
    let moved = net.vertices().iter().map(|vertex| {
        let around = vertex.faces.iter().filter_map(|face| normals.get(*face));
        let normal = around.copied().sum::<Vector3>().unitized();
        let none = || Fault::bad_request("the control net has a vertex without a normal");
        Ok(SubDVertex { point: vertex.point + normal.ok_or_else(none)? * distance, ..vertex.clone() })
    });
    let vertices = moved.collect::<Outcome<Vec<_>>>()?;
    Ok(SubD::new(SubDNet::from_parts(vertices, net.edges().to_vec(), net.faces().to_vec())?))
}

/// `SubDCreationOptions`, as far as they are heeded.
#[derive(Default)]
struct Options {
    creases: bool,
    corners: bool,
    interpolate: bool,
}

impl Read for Options {
    fn read(json: &Json) -> Result<Self, Fault> {
        let members = Members::of(json)?;
        // 0 is unset, 1 none, 2 at double edges, or at corners of one face.
        let creases: i32 = members.read_or("InteriorCreaseTest", 0)?;
        let corners: i32 = members.read_or("ConvexCornerTest", 0)?;
        let interpolate = members.read_or("InterpolateMeshVertices", false)?;
        Ok(Self { creases: creases >= 2, corners: corners >= 2, interpolate })
    }

    fn type_name() -> String {
        "SubDCreationOptions".into()
    }
}

fn of_mesh(mesh: &Mesh, options: Options) -> Outcome<Subdivision> {
    let net = SubDNet::from_mesh(mesh, &FromMesh { creases: options.creases, corners: options.corners })?;
    let net = if options.interpolate { net.interpolating()?.0 } else { net };
    Ok(Subdivision(SubD::new(net)))
}
