//! Mesh / Util: meshes of surfaces and simple solids.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Geometry, Kind, MeshSettings, Value, cast};
use katydid_geometry::{Box3, Brep, Containment, Direction, Mesh, MeshFace, Side, Surface};

use super::{count, room, shared};
use crate::prepared;

/// What becomes a mesh.
enum Shape {
    Surface(Shared<Surface>),
    Brep(Shared<Brep>),
    Box(Box3),
    Mesh(Shared<Mesh>),
}

/// The faces, box or mesh that a geometry is or stands for.
fn shape(context: &Context<'_>, geometry: &Value) -> Result<Shape, Message> {
    match geometry {
        Value::Surface(surface) => Ok(Shape::Surface(surface.clone())),
        Value::Box(shape) => Ok(Shape::Box(**shape)),
        Value::Mesh(mesh) => Ok(Shape::Mesh(mesh.clone())),
        other => match cast::value(other, Kind::Brep, context.rules()) {
            Some(Value::Surface(surface)) => Ok(Shape::Surface(surface)),
            Some(value) => match value.brep() {
                Some(brep) => Ok(Shape::Brep(brep.map_err(Message::warning)?)),
                None => Err(Message::error(format!("A {} has no surface to mesh", other.kind()))),
            },
            None => Err(Message::error(format!("A {} has no surface to mesh", other.kind()))),
        },
    }
}

/// A mesh over a surface with equal numbers of faces along each line.
///
/// Of a trimmed surface the faces outside its trims are left out.
#[component(
    "58cf422f-19f7-42f7-9619-fc198c51c657",
    name = "Mesh Surface",
    nick = "Mesh UV",
    at = "Mesh/Util"
)]
#[output("Mesh", "M", "The mesh; its vertices run along v first.")]
fn mesh_surface(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    brep: Shared<Brep>,
    /// The number of faces along u, at least 1.
    #[port("U Count", "U", default = 5)]
    u_count: i32,
    /// The number of faces along v, at least 1.
    #[port("V Count", "V", default = 5)]
    v_count: i32,
    /// Whether faces are kept that are partly outside the trims, as their corners tell; without trims this changes
    /// nothing.
    #[port("Overhang", "H", default = true)]
    overhang: bool,
    /// Whether the faces are spaced by length along the middle lines of the surface rather than by parameter.
    #[port("Equalize", "Q", default = false)]
    equalize: bool,
) -> Result<Shared<Mesh>, Message> {
    let ([_], Some(surface)) = (brep.faces(), brep.face_surface(0)) else {
        return Err(Message::error("A Brep of several faces is no surface: take it apart"));
    };
    let counts = [count(u_count, "The U count")?, count(v_count, "The V count")?];
    room(context, counts[0].saturating_mul(counts[1]))?;
    let line = |direction: Direction| -> Result<Vec<f64>, Message> {
        let (domain, n) = (surface.domain(direction), counts[direction.index()]);
        if equalize {
            let across = surface.domain(direction.other()).middle();
            // A middle line that is a point has no lengths to go by.
            let curve = surface.isocurve(direction, across);
            if let Ok(mut parameters) = curve.and_then(|c| c.divide_by_count(n)) {
                parameters.truncate(n);
                parameters.push(domain.end);
                if let Some(first) = parameters.first_mut() {
                    *first = domain.start;
                }
                return Ok(parameters);
            }
        }
        let inner = (0..n).map(|k| domain.at(k as f64 / n as f64));
        Ok(inner.chain([domain.end]).collect())
    };
    let (us, vs) = (line(Direction::U)?, line(Direction::V)?);
    let whole = Mesh::surface_grid(surface, &us, &vs)?;
    if brep.as_surface().is_some() {
        return Ok(shared(whole));
    }
    let search = prepared::brep(context, &brep)?;
    let near =
        1e-9 * Direction::BOTH.map(|d| surface.domain(d).length()).into_iter().fold(f64::MAX, f64::min);
    let mut inside = Vec::with_capacity(us.len() * vs.len());
    for &u in &us {
        context.check()?;
        for &v in &vs {
            inside.push(search.covers(0, u, v, near)? != Containment::Outside);
        }
    }
    let stays = |face: &&MeshFace| {
        let mut corners = face.indices().iter().map(|&k| inside.get(k as usize) == Some(&true));
        if overhang { corners.any(|is| is) } else { corners.all(|is| is) }
    };
    let kept: Vec<MeshFace> = whole.faces().iter().filter(stays).copied().collect();
    if kept.is_empty() {
        return Err(Message::warning(
            "No face of the grid lies within the trims: higher counts may find some",
        ));
    }
    Ok(shared(whole.part(&kept)?))
}

/// A mesh of a Brep, surface or box, as fine as the settings say.
///
/// The mesh of a solid is closed: faces have vertices in the same places along their edges. A mesh stays as it is.
#[component("60e7defa-8b21-4ee1-99aa-a9223d6134ff", name = "Mesh Brep", nick = "Mesh", at = "Mesh/Util")]
#[output("Mesh", "M", "The mesh.")]
fn mesh_brep(
    context: &Context<'_>,
    /// The Brep, surface, box or mesh.
    #[port("Brep", "B")]
    brep: Geometry,
    /// How fine: from one of the Settings components.
    #[port("Settings", "S", default = MeshSettings::SPEED)]
    settings: MeshSettings,
) -> Result<Shared<Mesh>, Message> {
    let brep = match shape(context, &brep.0)? {
        Shape::Mesh(mesh) => return Ok(mesh),
        Shape::Box(shape) => return boxed(context, &shape, &settings),
        Shape::Surface(surface) => Shared::new(Brep::from_surface((*surface).clone())?),
        Shape::Brep(brep) => brep,
    };
    if settings.max_edge > 0.0 {
        let size = brep.bounds_of_faces().map_or(0.0, |b| b.diagonal().length());
        let cells = (size / settings.max_edge).powi(2) * brep.faces().len() as f64;
        room(context, cells as usize)?;
    }
    let made = brep.mesh_unless(&fineness(&settings), &context.stop());
    context.check()?;
    let made = made?;
    room(context, made.triangle_count())?;
    Ok(shared(made.to_mesh()?))
}

/// A box under the settings: its sides are plane.
fn boxed(context: &Context<'_>, shape: &Box3, settings: &MeshSettings) -> Result<Shared<Mesh>, Message> {
    let lengths = [shape.x, shape.y, shape.z].map(|r| r.length().abs());
    let least =
        if settings.simple_planes { 1.0 } else { f64::from(settings.grid_min.max(0)).sqrt().ceil().max(1.0) };
    let along = |length: f64| {
        let by_edge = if settings.max_edge > 0.0 { (length / settings.max_edge).ceil() } else { 1.0 };
        if settings.simple_planes { 1.0 } else { by_edge.max(least) }
    };
    let [x, y, z] = lengths.map(along);
    room(context, (2.0 * (x * y + y * z + z * x)) as usize)?;
    Ok(shared(Mesh::cuboid(shape, x as usize, y as usize, z as usize)?))
}

/// The settings in the kernel's words.
fn fineness(settings: &MeshSettings) -> katydid_geometry::MeshSettings {
    let count = |n: i32| usize::try_from(n).unwrap_or(0);
    katydid_geometry::MeshSettings {
        max_distance: settings.tolerance,
        relative_tolerance: settings.relative_tolerance,
        min_distance: settings.min_tolerance,
        max_angle: settings.refine_angle,
        max_aspect: settings.aspect,
        min_edge: settings.min_edge,
        max_edge: settings.max_edge,
        min_count: count(settings.grid_min),
        max_count: count(settings.grid_max),
        refine: settings.refine,
        simple_planes: settings.simple_planes,
        jagged_seams: settings.jagged_seams,
    }
}

/// The coarsest mesh of a Brep, surface or box: one quad or triangle for each face, from corner to corner.
///
/// Only faces with three or four sides have one; a face that closes on itself has not. A mesh stays as it is.
#[component("c3f9cea5-6fd4-4db5-959b-08cd08ed9fe1", name = "Simple Mesh", nick = "SMesh", at = "Mesh/Util")]
#[output("Mesh", "M", "The mesh.")]
fn simple_mesh(
    context: &Context<'_>,
    /// The Brep, surface, box or mesh.
    #[port("Brep", "B")]
    brep: Geometry,
) -> Result<Shared<Mesh>, Message> {
    let surface = match shape(context, &brep.0)? {
        Shape::Mesh(mesh) => return Ok(mesh),
        Shape::Box(shape) => return Ok(shared(Mesh::cuboid(&shape, 1, 1, 1)?)),
        Shape::Brep(brep) => return simple(context, &brep),
        Shape::Surface(surface) => surface,
    };
    let closed = [Direction::U, Direction::V].iter().any(|d| surface.is_closed(*d));
    let points = Side::ALL.iter().filter(|s| surface.is_singular(**s)).count();
    if closed || points > 1 {
        return Err(Message::error("The face does not have three or four sides"));
    }
    let (u, v) = (surface.domain(Direction::U), surface.domain(Direction::V));
    let at = |u: f64, v: f64| surface.point_at(u, v);
    let mut corners = vec![at(u.start, v.start), at(u.end, v.start), at(u.end, v.end), at(u.start, v.end)];
    // The corner that follows a side without length is the same one again.
    let point = Side::ALL.iter().position(|s| surface.is_singular(*s));
    if let Some(k) = point {
        corners.remove((k + 1) % 4);
    }
    let face = if point.is_some() { MeshFace::Triangle([0, 1, 2]) } else { MeshFace::Quad([0, 1, 2, 3]) };
    Ok(shared(Mesh::new(corners, vec![face])?.with_normals()))
}

/// One polygon for each face of a brep that has three or four sides.
fn simple(context: &Context<'_>, brep: &Brep) -> Result<Shared<Mesh>, Message> {
    let vertices = brep.vertices().iter().map(|vertex| vertex.point).collect();
    let (mut faces, mut left) = (Vec::new(), 0);
    for face in brep.faces().iter().filter(|face| !face.deleted) {
        let corners = match face.loops.as_slice() {
            [only] => brep.loops().get(*only).map(|chain| chain.trims.as_slice()).unwrap_or_default(),
            _ => &[],
        };
        let trims = corners.iter().filter_map(|trim| brep.trims().get(*trim));
        let corners =
            trims.filter(|trim| trim.edge.is_some()).map(|trim| u32::try_from(trim.vertices[0]?).ok());
        let mut corners: Vec<u32> = corners.collect::<Option<_>>().unwrap_or_default();
        if face.reversed {
            corners.reverse();
        }
        let repeated = (1..corners.len()).any(|k| corners.iter().take(k).any(|c| Some(c) == corners.get(k)));
        match corners.as_slice() {
            [a, b, c] if !repeated => faces.push(MeshFace::Triangle([*a, *b, *c])),
            [a, b, c, d] if !repeated => faces.push(MeshFace::Quad([*a, *b, *c, *d])),
            _ => left += 1,
        }
    }
    if faces.is_empty() {
        return Err(Message::error("No face has three or four sides"));
    }
    if left > 0 {
        context.warn(format!("{left} faces do not have three or four sides"));
    }
    Ok(shared(Mesh::new(vertices, faces)?.with_normals()))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;
    use std::sync::Arc as Shared;

    use katydid_component::testing::Trial;
    use katydid_data::{MeshSettings, Value};
    use katydid_geometry::{
        Box3, Circle, Cone, Cylinder, Interval, Mesh, NurbsSurface, Plane, PlaneSurface, Point3, Sphere,
    };

    fn mesh(trial: Trial) -> Shared<Mesh> {
        match trial.run().outputs[0].column().get(0) {
            Some(Value::Mesh(m)) => m,
            other => panic!("{other:?}"),
        }
    }

    fn flat() -> katydid_geometry::Surface {
        PlaneSurface::new(Plane::XY, Interval::new(0.0, 4.0), Interval::new(0.0, 2.0)).unwrap().into()
    }

    fn ball() -> katydid_geometry::Surface {
        Sphere { plane: Plane::XY, radius: 3.0 }.into()
    }

    #[test]
    fn grids() {
        let grid = mesh(Trial::of("Mesh Surface").item(flat()).item(4).item(2));
        assert_eq!((grid.vertices().len(), grid.faces().len()), (15, 8));
        assert_eq!(grid.vertices()[1], Point3::new(0.0, 1.0, 0.0));
        assert!((grid.area() - 8.0).abs() < 1e-12);
        let ball = mesh(Trial::of("Mesh Surface").item(ball()).item(24).item(12).default().item(true));
        assert_eq!(ball.vertices().len(), 25 * 13);
        assert!(ball.is_closed() && ball.is_oriented());
        assert!((ball.volume() - 36.0 * PI).abs() < 0.04 * 36.0 * PI);
        assert!(Trial::of("Mesh Surface").item(flat()).item(0).message().contains("at least 1"));
    }

    /// On a ring of radii 1 and 2 the faces whose corners are all inside, or some.
    #[test]
    fn faces_beyond_trims() {
        let rings = [2.0, 1.0].map(|radius| Circle { plane: Plane::XY, radius });
        let ring = Trial::of("Boundary Surfaces").list(rings).run().outputs[0].column().get(0).unwrap();
        let on = |x: f64, y: f64| (1.0 - 1e-9..=2.0 + 1e-9).contains(&x.hypot(y));
        let at = |i: i32| f64::from(i) * 0.2 - 2.0;
        let corners =
            |i: i32, j: i32| [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)].map(|(i, j)| on(at(i), at(j)));
        let all = (0..400).map(|k| corners(k / 20, k % 20));
        let wanted =
            [all.clone().filter(|c| c.contains(&true)).count(), all.filter(|c| !c.contains(&false)).count()];
        for (overhang, wanted) in [true, false].into_iter().zip(wanted) {
            let trial = Trial::of("Mesh Surface").item(ring.clone()).item(20).item(20).item(overhang);
            let made = mesh(trial);
            assert_eq!(made.faces().len(), wanted);
            assert!((made.area() - 0.04 * wanted as f64).abs() < 1e-9);
        }
        let coarse = Trial::of("Mesh Surface").item(ring).item(1).item(1).item(false);
        assert!(coarse.message().contains("within the trims"));
    }

    #[test]
    fn equal_lengths() {
        // The corners of this strip are nearer in u at one end.
        let curve = katydid_geometry::NurbsCurve::clamped_uniform(
            2,
            &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [9.0, 0.0, 0.0]].map(Point3::from),
        );
        let strip =
            katydid_geometry::SumSurface::extrusion(curve.unwrap().into(), katydid_geometry::Vector3::Y);
        let strip: katydid_geometry::Surface = strip.unwrap().into();
        let by = |equal: bool| {
            mesh(Trial::of("Mesh Surface").item(strip.clone()).item(3).item(1).default().item(equal))
        };
        let xs = |m: &Mesh| m.vertices().iter().step_by(2).map(|p| p.x).collect::<Vec<_>>();
        assert!((xs(&by(true))[1] - 3.0).abs() < 1e-9 && (xs(&by(true))[2] - 6.0).abs() < 1e-9);
        assert!(xs(&by(false))[1] < 2.0);
    }

    #[test]
    fn by_settings() {
        let cells = |m: &Mesh| m.faces().len();
        assert_eq!(cells(&mesh(Trial::of("Mesh Brep").item(flat()))), 1);
        let fine = MeshSettings { simple_planes: false, relative_tolerance: 0.0, ..MeshSettings::SPEED };
        assert!(cells(&mesh(Trial::of("Mesh Brep").item(flat()).item(fine))) >= 16);
        let speed = mesh(Trial::of("Mesh Brep").item(ball()));
        let quality = mesh(Trial::of("Mesh Brep").item(ball()).item(MeshSettings::QUALITY));
        assert!(speed.is_closed() && quality.is_closed() && cells(&quality) > cells(&speed));
        let size = 6.0 * 3_f64.sqrt();
        assert!(speed.face_centers().iter().all(|p| 3.0 - p.to_vector().length() < 2.2 * 0.0005 * size));
        let side = Interval::new(0.0, 2.0);
        let cube = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        assert_eq!(cells(&mesh(Trial::of("Mesh Brep").item(cube))), 6);
        assert_eq!(cells(&mesh(Trial::of("Mesh Brep").item(cube).item(fine))), 96);
        assert!((mesh(Trial::of("Mesh Brep").item(cube)).volume() - 8.0).abs() < 1e-12);
        assert_eq!(*mesh(Trial::of("Mesh Brep").item((*speed).clone())), *speed);
        assert!(Trial::of("Mesh Brep").item(Point3::ORIGIN).message().contains("no surface"));
        let disc = mesh(Trial::of("Mesh Brep").item(Circle { plane: Plane::XY, radius: 1.0 }));
        assert!((disc.area() - PI).abs() < 0.1, "the inside of a closed flat curve");
    }

    #[test]
    fn one_face_each() {
        let simple = mesh(Trial::of("Simple Mesh").item(flat()));
        assert_eq!((simple.vertices().len(), simple.area()), (4, 8.0));
        let [a, b, c] = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 2.0, 0.0]].map(Point3::from);
        let triangle: katydid_geometry::Surface = NurbsSurface::from_corners(a, b, c, c).unwrap().into();
        let simple = mesh(Trial::of("Simple Mesh").item(triangle));
        assert_eq!((simple.vertices().len(), simple.area()), (3, 3.0));
        let tube: katydid_geometry::Surface = Cylinder::new(Plane::XY, 1.0, Interval::UNIT).unwrap().into();
        assert!(Trial::of("Simple Mesh").item(tube).message().contains("three or four"));
        let cone: katydid_geometry::Surface = Cone::new(Plane::XY, 1.0, 1.0).unwrap().into();
        assert!(Trial::of("Simple Mesh").item(cone).message().contains("three or four"));
    }
}
