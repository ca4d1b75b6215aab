//! Intersect / Mathematical: sections by planes.

use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Path, Tree, TreeBuilder, Value, cast};
use katydid_geometry::brep::BrepSections;
use katydid_geometry::intersect::surface_plane;
use katydid_geometry::{Brep, Curve, Interval, Mesh, MeshSections, Plane, Point3, PolylineCurve, Vector3};

use super::planes;
use crate::transform::around;

/// Groups in groups beyond this depth are left out.
const DEEPEST: usize = 100;

/// So many planes cut a mesh before it is asked whether to go on.
const AT_ONCE: usize = 64;

/// The polylines in which a plane cuts a mesh.
fn of_mesh(mesh: &Mesh, plane: &Plane) -> Result<Vec<Value>, Message> {
    Ok(polylines(mesh.section(plane)?).collect())
}

fn polylines(chains: Vec<Vec<Point3>>) -> impl Iterator<Item = Value> {
    chains.into_iter().filter_map(|c| PolylineCurve::new(c).ok()).map(|c| Curve::from(c).into())
}

/// The Breps that were cut last, prepared for more planes.
type Kept = RefCell<Vec<(Shared<Brep>, Rc<BrepSections>)>>;
/// How many Breps are kept.
const KEPT: usize = 32;

/// A Brep prepared to be cut, once in a run.
fn sections(context: &Context<'_>, brep: &Shared<Brep>) -> Result<Rc<BrepSections>, Message> {
    let kept = context.prepared(|| Ok(Kept::default()))?;
    let same = |other: &Shared<Brep>| Shared::ptr_eq(other, brep) || **other == **brep;
    if let Some((_, found)) = kept.borrow().iter().find(|(other, _)| same(other)) {
        return Ok(found.clone());
    }
    context.check()?;
    let made = BrepSections::new(brep.clone(), &context.tolerance());
    let made = Rc::new(made.map_err(|e| Message::warning(e.to_string()))?);
    let mut kept = kept.borrow_mut();
    if kept.len() >= KEPT {
        kept.remove(0);
    }
    kept.push((brep.clone(), made.clone()));
    Ok(made)
}

/// The curves in which a plane cuts a Brep, and the points where it touches it.
fn of_brep(
    context: &Context<'_>,
    brep: &BrepSections,
    plane: &Plane,
) -> Result<(Vec<Value>, Vec<Point3>), Message> {
    let section = brep.cut(plane).map_err(|e| Message::warning(e.to_string()))?;
    if !section.complete {
        context.warn("A face lies so close to the plane that some curves may be missing");
    }
    Ok((section.curves.into_iter().map(Value::from).collect(), section.points))
}

/// What a plane cuts out of a thing: points of curves, curves of surfaces and meshes.
fn cut(context: &Context<'_>, shape: &Value, plane: &Plane, depth: usize) -> Result<Vec<Value>, Message> {
    let to = |kind| cast::value(shape, kind, context.rules());
    Ok(match shape {
        Value::Brep(brep) => of_brep(context, sections(context, brep)?.as_ref(), plane)?.0,
        Value::Kept(_) if shape.brep().is_some() => match shape.brep() {
            Some(brep) => {
                let brep = brep.map_err(Message::warning)?;
                of_brep(context, sections(context, &brep)?.as_ref(), plane)?.0
            }
            None => Vec::new(),
        },
        Value::Surface(surface) => {
            let section = surface_plane(surface, plane, &context.tolerance())?;
            if !section.complete {
                context.warn("The surface lies so close to the plane that some curves may be missing");
            }
            section.curves.into_iter().map(Value::from).collect()
        }
        Value::Mesh(mesh) => of_mesh(mesh, plane)?,
        Value::Group(group) if depth < DEEPEST => {
            let mut all = Vec::new();
            for member in group.members.iter().flatten() {
                all.extend(cut(context, member, plane, depth + 1)?);
            }
            all
        }
        Value::Box(_) => match to(Kind::Mesh) {
            Some(Value::Mesh(mesh)) => of_mesh(&mesh, plane)?,
            _ => Vec::new(),
        },
        Value::Curve(_) | Value::Line(_) | Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) => {
            match to(Kind::Curve) {
                Some(Value::Curve(curve)) => {
                    let places = planes::places_in(context, &curve, plane)?;
                    places.iter().map(|&t| curve.point_at(t).into()).collect()
                }
                _ => Vec::new(),
            }
        }
        Value::Point(p) if plane.signed_distance(*p).abs() <= context.tolerance().absolute => {
            vec![(*p).into()]
        }
        Value::Point(_) => Vec::new(),
        other => {
            return Err(Message::error(format!(
                "Sections of a {} are not supported yet: only of curves, Breps, boxes and meshes",
                other.kind().name()
            )));
        }
    })
}

/// A Brep that is kept as it was written, read once for all planes; anything else as it is.
fn readable(shape: Value) -> Result<Value, Message> {
    match (&shape, shape.brep()) {
        (Value::Kept(_), Some(brep)) => Ok(Value::Brep(brep.map_err(Message::warning)?)),
        _ => Ok(shape),
    }
}

/// The sections of a thing, a branch for each plane.
fn contours(context: &Context<'_>, shape: &Value, planes: &[Plane]) -> Result<Tree, Message> {
    if let (Value::Mesh(mesh), Some(first)) = (shape, planes.first()) {
        return mesh_contours(context, mesh, first.z_axis, planes);
    }
    let start: Path = context.path().child(context.iteration());
    let mut out = TreeBuilder::<Value>::new();
    let mut made = 0_usize;
    for (k, plane) in planes.iter().enumerate() {
        context.check()?;
        out.branch(start.child(k));
        let curves = cut(context, shape, plane, 0)?;
        made = made.saturating_add(curves.len());
        context.items(made)?;
        curves.into_iter().for_each(|curve| out.push(Some(curve)));
    }
    Ok(out.finish())
}

/// The sections of a mesh by parallel planes, a branch for each.
fn mesh_contours(
    context: &Context<'_>,
    mesh: &Mesh,
    normal: Vector3,
    planes: &[Plane],
) -> Result<Tree, Message> {
    let start: Path = context.path().child(context.iteration());
    let sections = MeshSections::new(mesh, normal)?;
    let mut out = TreeBuilder::<Value>::new();
    let (mut made, mut branch) = (0_usize, 0_usize);
    for some in planes.chunks(AT_ONCE) {
        context.check()?;
        for chains in sections.at(some)? {
            out.branch(start.child(branch));
            branch += 1;
            made = made.saturating_add(chains.len());
            context.items(made)?;
            polylines(chains).for_each(|curve| out.push(Some(curve)));
        }
    }
    Ok(out.finish())
}

/// Cuts a thing with parallel planes at equal distances: those through a point and at every multiple of the distance
/// on both sides of it that meet the thing.
///
/// Breps give curves, meshes and boxes polylines, and curves points. Where a flat part lies in a plane its outline
/// is given.
#[component(
    "3b112fb6-3eba-42d2-ba75-0f903c18faab",
    name = "Contour",
    nick = "Contour",
    at = "Intersect/Mathematical"
)]
#[output("Contours", "C", "The sections, a branch for each plane, in the direction of the normal.")]
fn contour(
    context: &Context<'_>,
    /// The curve, Brep, box or mesh.
    #[port("Shape", "S")]
    shape: Geometry,
    /// A point that a plane goes through.
    #[port("Point", "P", default = Point3::ORIGIN)]
    point: Point3,
    /// The normal of the planes; its length does not matter.
    #[port("Direction", "N", default = Vector3::new(0.0, 0.0, 1.0))]
    direction: Vector3,
    /// The distance from plane to plane, above 0.
    #[port("Distance", "D")]
    distance: f64,
) -> Result<Tree, Message> {
    let first = Plane::from_normal(point, direction)?;
    let shape = Geometry(readable(shape.0)?);
    let Some(extent) = around(&shape.0, &first) else {
        return match &shape.0 {
            Value::Kept(_) => contours(context, &shape.0, &[first]),
            other => Err(Message::warning(format!("A {} has no extent to cut", other.kind().name()))),
        };
    };
    contours(context, &shape.0, &planes::row(context, &first, extent.z, distance)?)
}

/// Cuts a thing with parallel planes: at offsets from a plane, or, without offsets, at distances from plane to plane.
#[component(
    "246cda78-5e88-4087-ba09-ae082bbc4af8",
    name = "Contour (ex)",
    nick = "Contour",
    at = "Intersect/Mathematical"
)]
#[output("Contours", "C", "The sections, a branch for each plane.")]
fn contour_ex(
    context: &Context<'_>,
    /// The curve, Brep, box or mesh.
    #[port("Shape", "S")]
    shape: Geometry,
    /// The plane that the others are parallel to.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The places of the planes along the plane's normal.
    #[port("Offsets", "O", optional)]
    offsets: List<f64>,
    /// How far each plane is from the one before, the first from the plane itself.
    #[port("Distances", "D", optional)]
    distances: List<f64>,
) -> Result<Tree, Message> {
    let shape = readable(shape.0)?;
    contours(context, &shape, &planes::placed(&plane, &offsets, &distances)?)
}

/// The polylines in which a plane cuts a mesh. Sections of closed meshes are closed.
///
/// Where faces lie in the plane their outline is given; where the mesh only touches it, nothing.
#[component(
    "3b1ae469-0e9b-461d-8c30-fa5a7de8b7a9",
    name = "Mesh | Plane",
    nick = "Sec",
    at = "Intersect/Mathematical"
)]
#[output("Curves", "C", "The polylines.")]
fn mesh_plane(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The plane, without end.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<Vec<Shared<Curve>>, Message> {
    let chains = mesh.section(&plane)?;
    context.items(chains.len())?;
    let curves = chains.into_iter().filter_map(|c| PolylineCurve::new(c).ok());
    Ok(curves.map(|c| Shared::new(c.into())).collect())
}

/// The curves in which a plane cuts a Brep: closed ones where the Brep is closed.
///
/// A face that lies in the plane gives its outline; where a face or an edge only touches the plane there is no curve.
#[component(
    "4fe828e8-fa95-4cc5-9a8c-c33856ecc783",
    name = "Brep | Plane",
    nick = "Sec",
    at = "Intersect/Mathematical"
)]
#[output("Curves", "C", "The curves, joined where they meet.")]
#[output("Points", "P", "Points where a corner or an edge only touches the plane.")]
fn brep_plane(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B", kind = Brep)]
    brep: Value,
    /// The plane, without end.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<(Vec<Value>, Vec<Point3>), Message> {
    if let (Value::Brep(_) | Value::Kept(_) | Value::Box(_), Some(brep)) = (&brep, brep.brep()) {
        let brep = brep.map_err(Message::warning)?;
        return of_brep(context, sections(context, &brep)?.as_ref(), &plane);
    }
    let curves = cut(context, &brep, &plane, 0)?;
    let mut points = Vec::new();
    if let (Value::Surface(surface), true) = (&brep, curves.is_empty()) {
        let [u, v] = katydid_geometry::Direction::BOTH.map(|d| surface.domain(d));
        let ends = |d: Interval| [d.start, d.end];
        for u in ends(u) {
            for v in ends(v) {
                let p = surface.point_at(u, v);
                let on = plane.signed_distance(p).abs() <= context.tolerance().absolute;
                if on && points.iter().all(|q: &Point3| q.distance_to(p) > context.tolerance().absolute) {
                    points.push(p);
                }
            }
        }
    }
    Ok((curves, points))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Tree, Value};
    use katydid_geometry::{
        Box3, Circle, Cylinder, Interval, Mesh, Plane, PlaneSurface, Point3, Sphere, Surface, Vector3,
    };

    fn lengths(curves: &Tree) -> Vec<String> {
        Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").tree(curves.clone()).texts(0)
    }

    fn cube() -> Box3 {
        let side = Interval::new(0.0, 2.0);
        Box3 { plane: Plane::XY, x: side, y: side, z: side }
    }

    #[test]
    fn planes_in_a_row() {
        let contour = |shape: Value, d: f64| {
            Trial::of_guid("3b112fb6-3eba-42d2-ba75-0f903c18faab").item(shape).default().default().item(d)
        };
        let tube: Surface = Cylinder::new(Plane::XY, 1.0, Interval::new(-1.0, 1.0)).unwrap().into();
        let rings = contour(tube.into(), 0.5).run().outputs[0].clone();
        let around = |k: i32| format!("{{0;0;{k}}}: 6.283185");
        assert_eq!(lengths(&rings), [0, 1, 2, 3, 4].map(around));
        let mesh = Mesh::cuboid(&cube(), 3, 3, 3).unwrap();
        let squares = contour(mesh.into(), 1.0).run().outputs[0].clone();
        assert_eq!(lengths(&squares), ["{0;0;0}: 8", "{0;0;1}: 8", "{0;0;2}: 8"]);
        assert_eq!(lengths(&contour(cube().into(), 1.0).run().outputs[0]), lengths(&squares));
        let upright = Circle { plane: Plane::XZ, radius: 1.0 };
        let points: Vec<String> = contour(upright.into(), 1.0)
            .texts(0)
            .iter()
            .map(|t| t.replace("-0,", "0,").replace("-0}", "0}"))
            .collect();
        assert_eq!(points, ["{0;0;0}: {0, 0, -1}", "{0;0;1}: {1, 0, 0}, {-1, 0, 0}", "{0;0;2}: {0, 0, 1}"]);
        assert!(contour(cube().into(), 0.0).message().contains("greater than 0"));
    }

    #[test]
    fn solids() {
        let can = katydid_geometry::construct::cylinder(
            &Cylinder::new(Plane::XY, 1.0, Interval::new(0.0, 2.0)).unwrap(),
            [true; 2],
        );
        let can = Value::from(can.unwrap());
        let cuts = Trial::of_guid("3b112fb6-3eba-42d2-ba75-0f903c18faab").item(can.clone()).default();
        let cuts = cuts.item(Vector3::Z).item(1.0).run().outputs[0].clone();
        assert_eq!(lengths(&cuts), [0, 1, 2].map(|k| format!("{{0;0;{k}}}: 6.283185")));
        let section = Trial::of("Brep | Plane").item(can).item(Plane::YZ).run().outputs;
        assert_eq!(lengths(&section[0]), ["{0;0}: 8"]);
        let block = Trial::of("Brep | Plane").item(cube()).item(Plane::XY).run().outputs;
        assert_eq!(lengths(&block[0]), ["{0;0}: 8"]);
    }

    #[test]
    fn planes_in_places() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 5.0).unwrap().into();
        let ex = Trial::of_guid("246cda78-5e88-4087-ba09-ae082bbc4af8").item(ball.clone()).default();
        let cuts = ex.list([3.0, -4.0, 9.0]).run().outputs[0].clone();
        assert_eq!(lengths(&cuts), ["{0;0;0}: 25.132741", "{0;0;1}: 18.849556", "{0;0;2}:"]);
        let steps = Trial::of_guid("246cda78-5e88-4087-ba09-ae082bbc4af8").item(ball.clone()).default();
        let steps = steps.tree(Tree::empty()).list([3.0, 1.0]).run().outputs[0].clone();
        assert_eq!(lengths(&steps), ["{0;0;0}: 25.132741", "{0;0;1}: 18.849556"]);
        let section = Trial::of("Brep | Plane").item(ball.clone()).item(Plane::YZ.offset(3.0)).run().outputs;
        assert_eq!(lengths(&section[0]), ["{0;0}: 25.132741"]);
        let side = Interval::new(0.0, 2.0);
        let flat: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let corner = Plane::from_normal(Point3::ORIGIN, Vector3::new(1.0, 1.0, 0.0)).unwrap();
        let touched = Trial::of("Brep | Plane").item(flat).item(corner).run().outputs;
        assert_eq!(texts(&touched[1]), ["{0;0}: {0, 0, 0}"]);
        let mesh = Mesh::cuboid(&cube(), 1, 1, 1).unwrap();
        let cut = Trial::of("Mesh | Plane").item(mesh.clone()).item(Plane::YZ.offset(0.5)).run().outputs;
        assert_eq!(lengths(&cut[0]), ["{0;0}: 8"]);
        assert_eq!(
            Trial::of("Mesh | Plane").item(mesh).item(Plane::YZ.offset(3.0)).run().outputs[0].item_count(),
            0
        );
    }
}
