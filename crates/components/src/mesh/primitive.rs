//! Mesh / Primitive.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Colour;
use katydid_geometry::{Box3, Interval, Mesh, MeshFace, Plane, Point3, Rectangle};

use super::{colours, count, room, shared};

/// A mesh from vertices and faces.
///
/// A face that names a vertex that is not there is left out, with a warning.
#[component(
    "e2c0f9db-a862-4bd9-810c-ef2610e7a56f",
    name = "Construct Mesh",
    nick = "ConMesh",
    at = "Mesh/Primitive"
)]
#[output("Mesh", "M", "The mesh.")]
fn construct_mesh(
    context: &Context<'_>,
    /// The vertices, numbered from 0.
    #[port("Vertices", "V", default = [Point3::ORIGIN, Point3::new(10.0, 0.0, 0.0), Point3::new(10.0, 10.0, 0.0), Point3::new(0.0, 10.0, 0.0)])]
    vertices: List<Point3>,
    /// The faces: three or four vertex numbers each, counter-clockwise seen from outside.
    #[port("Faces", "F", default = MeshFace::Quad([0, 1, 2, 3]))]
    faces: List<MeshFace>,
    /// Colours of the vertices, repeated in order when there are fewer.
    #[port("Colours", "C", optional)]
    colours_: List<Colour>,
) -> Result<Shared<Mesh>, Message> {
    let vertices: Vec<Point3> = vertices.present().collect();
    let there = |face: &MeshFace| face.indices().iter().all(|&i| (i as usize) < vertices.len());
    let given = faces.present().count();
    let faces: Vec<MeshFace> = faces.present().filter(there).collect();
    if faces.len() < given {
        context.warn("A face names a vertex that does not exist and is left out");
    }
    let mesh = Mesh::new(vertices, faces)?.with_normals();
    Ok(shared(mesh.with_colours(&colours(&colours_))))
}

/// A mesh face of three corners.
#[component(
    "5a4ddedd-5af9-49e5-bace-12910a8b9366",
    name = "Mesh Triangle",
    nick = "Triangle",
    at = "Mesh/Primitive"
)]
#[output("Face", "F", "The face.")]
fn mesh_triangle(
    /// The number of the first vertex, from 0.
    #[port("Corner A", "A", default = 0)]
    a: i32,
    /// The number of the second vertex.
    #[port("Corner B", "B", default = 1)]
    b: i32,
    /// The number of the third vertex.
    #[port("Corner C", "C", default = 2)]
    c: i32,
) -> Result<MeshFace, Message> {
    let [a, b, c] = numbers([a, b, c])?;
    Ok(MeshFace::Triangle([a, b, c]))
}

/// A mesh face of four corners.
#[component("1cb59c86-7f6b-4e52-9a0c-6441850e9520", name = "Mesh Quad", nick = "Quad", at = "Mesh/Primitive")]
#[output("Face", "F", "The face.")]
fn mesh_quad(
    /// The number of the first vertex, from 0.
    #[port("Corner A", "A", default = 0)]
    a: i32,
    /// The number of the second vertex.
    #[port("Corner B", "B", default = 1)]
    b: i32,
    /// The number of the third vertex.
    #[port("Corner C", "C", default = 2)]
    c: i32,
    /// The number of the fourth vertex.
    #[port("Corner D", "D", default = 3)]
    d: i32,
) -> Result<MeshFace, Message> {
    Ok(MeshFace::Quad(numbers([a, b, c, d])?))
}

/// Vertex numbers, which are not negative.
fn numbers<const N: usize>(corners: [i32; N]) -> Result<[u32; N], Message> {
    let mut out = [0; N];
    for (place, corner) in out.iter_mut().zip(corners) {
        *place = u32::try_from(corner).map_err(|_| {
            Message::error(format!("A vertex number of {corner} is not possible: they begin at 0"))
        })?;
    }
    Ok(out)
}

/// A mesh with other vertex colours. Fewer colours than vertices are repeated in order.
#[component(
    "d2cedf38-1149-4adc-8dbf-b06571cb5106",
    name = "Mesh Colours",
    nick = "MCol",
    at = "Mesh/Primitive"
)]
#[output("Mesh", "M", "The coloured mesh.")]
fn mesh_colours(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The colours; none removes those that were.
    #[port("Colours", "C")]
    colours_: List<Colour>,
) -> Shared<Mesh> {
    shared(mesh.with_colours(&colours(&colours_)))
}

/// A flat mesh of quads over a rectangle.
#[component(
    "8adbf481-7589-4a40-b490-006531ea001d",
    name = "Mesh Plane",
    nick = "MPlane",
    at = "Mesh/Primitive"
)]
#[output("Mesh", "M", "The mesh; vertices run row by row along x.")]
#[output("Area", "A", "The area of the rectangle.")]
fn mesh_plane(
    context: &Context<'_>,
    /// The rectangle.
    #[port("Boundary", "B", default = Rectangle { plane: Plane::XY, x: Interval::new(-10.0, 10.0), y: Interval::new(-10.0, 10.0) })]
    boundary: Rectangle,
    /// The number of faces along x, at least 1.
    #[port("Width count", "W", default = 10)]
    width: i32,
    /// The number of faces along y, at least 1.
    #[port("Height count", "H", default = 10)]
    height: i32,
) -> Result<(Shared<Mesh>, f64), Message> {
    let (x, y) = (count(width, "The width count")?, count(height, "The height count")?);
    room(context, x.saturating_mul(y))?;
    Ok((shared(Mesh::plane(&boundary, x, y)?), boundary.area().abs()))
}

/// A flat mesh of quads in a plane.
#[component(
    "dd8d834f-40f1-4a84-8e4b-9fa8efe7be41",
    name = "Mesh Plane",
    nick = "MPlane",
    at = "Mesh/Primitive",
    old
)]
#[output("Mesh", "M", "The mesh; vertices run row by row along x.")]
#[output("Area", "A", "Its area.")]
fn mesh_plane_of_sizes(
    context: &Context<'_>,
    /// The plane.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// The range along x; a number is a range from 0.
    #[port("Width", "W", default = Interval::new(0.0, 10.0))]
    width: Interval,
    /// The range along y; a number is a range from 0.
    #[port("Height", "H", default = Interval::new(0.0, 10.0))]
    height: Interval,
    /// The number of faces along x, at least 1.
    #[port("Width count", "Cw", default = 10)]
    width_count: i32,
    /// The number of faces along y, at least 1.
    #[port("Height count", "Ch", default = 10)]
    height_count: i32,
) -> Result<(Shared<Mesh>, f64), Message> {
    mesh_plane(context, Rectangle { plane: base, x: width, y: height }, width_count, height_count)
}

/// A mesh of quads around a box. Its sides share no vertices, so that the edges are sharp.
#[component("2696bd14-3fb5-4750-827f-86df6c31d664", name = "Mesh Box", nick = "MBox", at = "Mesh/Primitive")]
#[output("Mesh", "M", "The mesh.")]
fn mesh_box(
    context: &Context<'_>,
    /// The box.
    #[port("Base", "B", default = Box3 { plane: Plane::XY, x: Interval::new(-10.0, 10.0), y: Interval::new(-10.0, 10.0), z: Interval::new(-10.0, 10.0) })]
    base: Box3,
    /// The number of faces along x, at least 1.
    #[port("X Count", "X", default = 10)]
    x: i32,
    /// The number of faces along y, at least 1.
    #[port("Y Count", "Y", default = 10)]
    y: i32,
    /// The number of faces along z, at least 1.
    #[port("Z Count", "Z", default = 10)]
    z: i32,
) -> Result<Shared<Mesh>, Message> {
    let (x, y, z) = (count(x, "The X count")?, count(y, "The Y count")?, count(z, "The Z count")?);
    let sides = x.saturating_mul(y).saturating_add(y.saturating_mul(z)).saturating_add(z.saturating_mul(x));
    room(context, sides.saturating_mul(2))?;
    Ok(shared(Mesh::cuboid(&base, x, y, z)?))
}

/// A sphere of quads around an axis, with triangles at the poles.
#[component(
    "0a391eac-5048-443c-9c1b-f592299b6dd6",
    name = "Mesh Sphere",
    nick = "MSphere",
    at = "Mesh/Primitive"
)]
#[output("Mesh", "M", "The mesh.")]
fn mesh_sphere(
    context: &Context<'_>,
    /// Its origin is the centre, its normal the axis.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// Greater than 0.
    #[port("Radius", "R", default = 10.0)]
    radius: f64,
    /// The number of faces around, at least 3.
    #[port("U Count", "U", default = 10)]
    u: i32,
    /// The number of faces from pole to pole, at least 2.
    #[port("V Count", "V", default = 20)]
    v: i32,
) -> Result<Shared<Mesh>, Message> {
    let (u, v) = (count(u, "The U count")?, count(v, "The V count")?);
    room(context, u.saturating_mul(v))?;
    Ok(shared(Mesh::sphere(&base, radius, u, v)?))
}

/// A sphere of six grids of quads, as a cube blown up.
#[component(
    "76f85ee4-5a88-4511-8ba7-30df07e50533",
    name = "Mesh Sphere Ex",
    nick = "MSphereEx",
    at = "Mesh/Primitive"
)]
#[output("Mesh", "M", "The mesh.")]
fn mesh_sphere_ex(
    context: &Context<'_>,
    /// Its origin is the centre.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// Greater than 0.
    #[port("Radius", "R", default = 10.0)]
    radius: f64,
    /// The number of faces along an edge of the cube, at least 1.
    #[port("Count", "C", default = 5)]
    faces: i32,
) -> Result<Shared<Mesh>, Message> {
    let n = count(faces, "The count")?;
    room(context, n.saturating_mul(n).saturating_mul(6))?;
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Message::error("The radius must be greater than 0"));
    }
    let side = Interval::new(-1.0, 1.0);
    let cube = Mesh::cuboid(&Box3 { plane: base, x: side, y: side, z: side }, n, n, n)?;
    let out = |p: &Point3| (*p - base.origin).with_length(radius).map_or(*p, |v| base.origin + v);
    let sphere = Mesh::new(cube.vertices().iter().map(out).collect(), cube.faces().to_vec())?;
    Ok(shared(sphere.with_normals()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Colour, Value};
    use katydid_geometry::{MeshFace, Point3};

    #[test]
    fn constructed() {
        assert_eq!(Trial::of("Construct Mesh").texts(0), ["{0}: Mesh (V:4  F:1)"]);
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
        let points = || points.map(Point3::from);
        let made = |faces: [&str; 2]| Trial::of("Construct Mesh").list(points()).list(faces);
        assert_eq!(made(["Q{0,1,2,3}", "T{1,2,4}"]).texts(0), ["{0}: Mesh (V:5  F:2)"]);
        let outside = made(["Q{0,1,2,3}", "T{1,2,9}"]);
        assert!(outside.message().contains("does not exist"));
        let red = Colour::rgb(255, 0, 0);
        let coloured =
            Trial::of("Construct Mesh").list(points()).list([MeshFace::Triangle([0, 1, 2])]).list([red]);
        let coloured = coloured.run().outputs[0].column().get(0);
        assert!(matches!(coloured, Some(Value::Mesh(m)) if m.colours() == [[255, 0, 0, 255]; 5]));
    }

    #[test]
    fn faces_and_shapes() {
        assert_eq!(Trial::of("Mesh Triangle").item(1).item(4).item(2).texts(0), ["{0}: T{1;4;2}"]);
        assert_eq!(Trial::of("Mesh Quad").texts(0), ["{0}: Q{0;1;2;3}"]);
        assert!(Trial::of("Mesh Quad").item(-1).message().contains("begin at 0"));
        assert_eq!(Trial::of("Mesh Plane").texts(1), ["{0}: 400"]);
        assert_eq!(Trial::of("Mesh Plane").default().item(2).item(3).texts(0), ["{0}: Mesh (V:12  F:6)"]);
        assert!(Trial::of("Mesh Plane").default().item(0).message().contains("at least 1"));
        let sizes = Trial::of_guid("dd8d834f-40f1-4a84-8e4b-9fa8efe7be41").default().item(4.0).item(3.0);
        assert_eq!(sizes.texts(1), ["{0}: 12"]);
        assert_eq!(Trial::of("Mesh Box").texts(0), ["{0}: Mesh (V:726  F:600)"]);
        assert_eq!(Trial::of("Mesh Sphere").texts(0), ["{0}: Mesh (V:192  F:200)"]);
        assert_eq!(Trial::of("Mesh Sphere Ex").texts(0), ["{0}: Mesh (V:216  F:150)"]);
        let plane = Trial::of("Mesh Plane").run().outputs[0].clone();
        let painted =
            Trial::of("Mesh Colours").tree(plane).list([Colour::rgb(1, 2, 3), Colour::rgb(4, 5, 6)]);
        assert!(matches!(painted.run().outputs[0].column().get(0),
            Some(Value::Mesh(m)) if m.colours()[2] == [1, 2, 3, 255]));
    }
}
