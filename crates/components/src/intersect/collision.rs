//! Intersect / Physical: what touches what.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_geometry::intersect::{curve_curve, curve_with_surface, nearest_to_shape};
use katydid_geometry::{BoundingBox, Curve, Mesh, MeshSettings, MeshTree, Point3, Surface};

/// Something that can touch, prepared to be asked often.
struct Body {
    bounds: BoundingBox,
    shape: Shape,
}

enum Shape {
    Point(Point3),
    Curve(Shared<Curve>),
    /// A surface, and a mesh next to it for what is no curve, with how far that strays.
    Surface(Shared<Surface>, std::cell::OnceCell<(MeshTree, f64)>),
    Mesh(Box<MeshTree>),
}

impl Body {
    fn new(context: &Context<'_>, value: &Value) -> Result<Option<Self>, Message> {
        let to = |kind| cast::value(value, kind, context.rules());
        let mesh = |mesh: &Mesh| {
            mesh.bounding_box()
                .map(|bounds| Self { bounds, shape: Shape::Mesh(Box::new(MeshTree::new(mesh))) })
        };
        Ok(match value {
            Value::Point(p) => {
                Some(Self { bounds: BoundingBox { min: *p, max: *p }, shape: Shape::Point(*p) })
            }
            Value::Surface(surface) => Some(Self {
                bounds: surface.bounding_box()?,
                shape: Shape::Surface(surface.clone(), std::cell::OnceCell::new()),
            }),
            Value::Mesh(m) => mesh(m),
            // A Brep by a mesh within the tolerance, or a thousandth of its size where that is more.
            Value::Brep(_) | Value::Kept(_) if value.brep().is_some() => match value.brep() {
                Some(brep) => {
                    let brep = brep.map_err(Message::warning)?;
                    let size = brep.bounds_of_faces().map_or(1.0, |b| b.diagonal().length());
                    let fine = context.tolerance().absolute.max(1e-3 * size);
                    let made = brep.mesh_unless(&MeshSettings::within(fine), &context.stop());
                    mesh(&made.and_then(|made| made.to_mesh())?)
                }
                None => None,
            },
            _ => match (to(Kind::Curve), to(Kind::Mesh)) {
                (Some(Value::Curve(curve)), _) => {
                    Some(Self { bounds: curve.bounding_box(), shape: Shape::Curve(curve) })
                }
                (_, Some(Value::Mesh(m))) => mesh(&m),
                _ => {
                    context
                        .warn(format!("Whether a {} touches anything is not known yet", value.kind().name()));
                    None
                }
            },
        })
    }

    fn all(context: &Context<'_>, list: &List<'_, Geometry>) -> Result<Vec<Option<Self>>, Message> {
        list.iter()
            .map(|item| match item {
                Some(Geometry(value)) => {
                    context.check()?;
                    Self::new(context, &value)
                }
                None => Ok(None),
            })
            .collect()
    }

    fn meets(&self, context: &Context<'_>, other: &Self) -> Result<bool, Message> {
        let tolerance = context.tolerance().absolute;
        if self.bounds.distance_to_box(&other.bounds) > tolerance {
            return Ok(false);
        }
        Ok(match (&self.shape, &other.shape) {
            (Shape::Point(p), shape) | (shape, Shape::Point(p)) => match shape {
                Shape::Point(q) => p.distance_to(*q) <= tolerance,
                Shape::Curve(curve) => curve.closest_point(*p)?.distance <= tolerance,
                Shape::Surface(surface, _) => surface.closest_point(*p)?.distance <= tolerance,
                Shape::Mesh(tree) => tree.nearest(*p)?.distance_to(*p) <= tolerance,
            },
            (Shape::Curve(a), Shape::Curve(b)) => !curve_curve(a, b, tolerance)?.is_empty(),
            (Shape::Curve(curve), Shape::Surface(surface, _))
            | (Shape::Surface(surface, _), Shape::Curve(curve)) => {
                let found = curve_with_surface(curve, surface, tolerance)?;
                !(found.crossings.is_empty() && found.overlaps.is_empty())
            }
            (Shape::Curve(curve), Shape::Mesh(tree)) | (Shape::Mesh(tree), Shape::Curve(curve)) => {
                nearest_to_shape(curve, tolerance, |p| tree.nearest(p))?.distance <= tolerance
            }
            (a, b) => {
                let ((a, s), (b, t)) = (a.skin(tolerance)?, b.skin(tolerance)?);
                a.meets(b, tolerance + s + t)
            }
        })
    }
}

impl Shape {
    /// The mesh of a mesh, or one next to a surface, and how far it strays from it.
    fn skin(&self, tolerance: f64) -> Result<(&MeshTree, f64), Message> {
        match self {
            Self::Mesh(tree) => Ok((tree, 0.0)),
            Self::Surface(surface, made) => {
                if let Some((tree, miss)) = made.get() {
                    return Ok((tree, *miss));
                }
                let (mesh, miss) = surface.to_grid_mesh(tolerance)?;
                let (tree, miss) = made.get_or_init(|| (MeshTree::new(&mesh), miss));
                Ok((tree, *miss))
            }
            _ => Err(Message::error("Internal error: a curve has no skin")),
        }
    }
}

/// Whether a thing touches any of several others.
///
/// Points, curves, bare surfaces, boxes and meshes touch where they come within the tolerance of each other. What lies
/// wholly inside a closed thing does not touch it. Nulls touch nothing.
#[component(
    "bb6c6501-0500-4678-859b-b838348981d1",
    name = "Collision One|Many",
    nick = "ColOM",
    at = "Intersect/Physical"
)]
#[output("Collision", "C", "Whether it touches one.")]
#[output("Index", "I", "The place of the first that it touches in the list; -1 when there is none.")]
fn collision_one_many(
    context: &Context<'_>,
    /// The thing.
    #[port("Collider", "C")]
    collider: Geometry,
    /// The others.
    #[port("Obstacles", "O")]
    obstacles: List<Geometry>,
) -> Result<(bool, i32), Message> {
    let Some(body) = Body::new(context, &collider.0)? else { return Ok((false, -1)) };
    for (item, i) in obstacles.iter().zip(0_i32..) {
        context.check()?;
        let Some(Geometry(value)) = item else { continue };
        if let Some(other) = Body::new(context, &value)?
            && body.meets(context, &other)?
        {
            return Ok((true, i));
        }
    }
    Ok((false, -1))
}

/// Which things of a list touch each other.
///
/// Points, curves, bare surfaces, boxes and meshes touch where they come within the tolerance of each other. What lies
/// wholly inside a closed thing does not touch it. Nulls touch nothing.
#[component(
    "2168853c-acd8-4a63-9c9b-ecde9e239eae",
    name = "Collision Many|Many",
    nick = "ColMM",
    at = "Intersect/Physical"
)]
#[output("Collision", "C", "For each whether it touches another one.")]
#[output("Indices", "I", "For each the place of the first other one that it touches; -1 when there is none.")]
fn collision_many_many(
    context: &Context<'_>,
    /// The things.
    #[port("Colliders", "C")]
    colliders: List<Geometry>,
) -> Result<(Vec<bool>, Vec<i32>), Message> {
    let bodies = Body::all(context, &colliders)?;
    let mut first: Vec<i32> = vec![-1; bodies.len()];
    for (i, a) in bodies.iter().enumerate() {
        context.check()?;
        for (j, b) in bodies.iter().enumerate().skip(i + 1) {
            let (Some(a), Some(b)) = (a, b) else { continue };
            let known = |k: usize| first.get(k).is_some_and(|&n| n >= 0);
            if (known(i) && known(j)) || !a.meets(context, b)? {
                continue;
            }
            for (k, other) in [(i, j), (j, i)] {
                if let Some(place) = first.get_mut(k).filter(|n| **n < 0) {
                    *place = i32::try_from(other).unwrap_or(i32::MAX);
                }
            }
        }
    }
    Ok((first.iter().map(|&n| n >= 0).collect(), first))
}

/// The meshes of one set that come too near to those of another.
///
/// Each such pair is given once, as a ball around all places where the two are within the distance of each other.
#[component(
    "4439a51b-8d24-4924-b8e2-f77e7f8f5bec",
    name = "Clash",
    nick = "Clash",
    at = "Intersect/Physical"
)]
#[output("Clash Count", "N", "The number of pairs.")]
#[output("Clash Points", "P", "For each the centre of the ball.")]
#[output("Clash Radii", "R", "Its radius.")]
#[output("First Index", "i", "The place of the mesh in the first set.")]
#[output("Second index", "j", "The place of the mesh in the second set.")]
fn clash(
    context: &Context<'_>,
    /// The first set.
    #[port("First Set", "A")]
    first: List<Shared<Mesh>>,
    /// The second set.
    #[port("Second Set", "B")]
    second: List<Shared<Mesh>>,
    /// How near is too near; 0 for meshes that meet.
    #[port("Distance", "D", default = 0.0)]
    distance: f64,
    /// Not more pairs than this are looked for.
    #[port("Result Limit", "L", default = 100)]
    limit: i32,
) -> Result<(i32, Vec<Point3>, Vec<f64>, Vec<i32>, Vec<i32>), Message> {
    /// Places that a ball is laid around; more would not make it another.
    const MOST: usize = 100_000;
    if !(distance >= 0.0 && distance.is_finite()) {
        return Err(Message::error(format!("Distance is {distance}, which must be at least 0")));
    }
    let limit = usize::try_from(limit).unwrap_or(0);
    let prepared = |list: &List<'_, Shared<Mesh>>| -> Vec<Option<(BoundingBox, MeshTree)>> {
        list.iter().map(|m| m.and_then(|m| Some((m.bounding_box()?, MeshTree::new(&m))))).collect()
    };
    let (a, b) = (prepared(&first), prepared(&second));
    let mut out = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    'pairs: for (one, i) in a.iter().zip(0_i32..) {
        for (other, j) in b.iter().zip(0_i32..) {
            if out.0.len() >= limit {
                break 'pairs;
            }
            let (Some((p, one)), Some((q, other))) = (one, other) else { continue };
            context.check()?;
            if p.distance_to_box(q) > distance {
                continue;
            }
            let found = one.clashes(other, distance, MOST);
            let Some(around) = BoundingBox::from_points(found.iter().map(|c| c.point)) else { continue };
            let center = around.center();
            let reach = |c: &katydid_geometry::MeshClash| c.point.distance_to(center) + 0.5 * c.distance;
            out.0.push(center);
            out.1.push(found.iter().map(reach).fold(0.0, f64::max));
            out.2.push(i);
            out.3.push(j);
        }
    }
    Ok((i32::try_from(out.0.len()).unwrap_or(i32::MAX), out.0, out.1, out.2, out.3))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Box3, Circle, Interval, Line, Mesh, Plane, Point3, Sphere, Surface};

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn cube(x: f64) -> Box3 {
        let unit = Interval::new(0.0, 1.0);
        Box3 { plane: Plane::XY, x: Interval::new(x, x + 1.0), y: unit, z: unit }
    }

    fn mesh(x: f64) -> Mesh {
        Mesh::cuboid(&cube(x), 2, 2, 2).unwrap()
    }

    fn ball(x: f64) -> Surface {
        Sphere::around(p(x, 0.5, 0.5), 1.0).unwrap().into()
    }

    #[test]
    fn one_and_many() {
        let line = Line::new(p(-1.0, 0.5, 0.5), p(9.0, 0.5, 0.5));
        let all: Vec<Value> = vec![
            p(4.0, 4.0, 4.0).into(),
            mesh(20.0).into(),
            Line::new(p(0.0, 0.0, 0.0), p(0.0, 0.0, 9.0)).into(),
            ball(6.0).into(),
            mesh(2.0).into(),
        ];
        let hit = |thing: Value, n: usize| {
            let others = all.clone().into_iter().take(n);
            Trial::of("Collision One|Many").item(thing).list(others).texts(1).join("")
        };
        assert_eq!(hit(line.into(), 5), "{0}: 3");
        assert_eq!(hit(line.into(), 3), "{0}: -1");
        assert_eq!(hit(mesh(2.5).into(), 5), "{0}: 4");
        assert_eq!(hit(cube(6.3).into(), 5), "{0}: 3");
        assert_eq!(hit(ball(7.5).into(), 5), "{0}: 3");
        assert_eq!(hit(ball(8.5).into(), 5), "{0}: -1");
        assert_eq!(hit(p(5.0, 0.5, 0.5).into(), 5), "{0}: 3");
        assert_eq!(hit(Circle { plane: Plane::XY, radius: 2.5 }.into(), 5), "{0}: 4");
        // Inside is not touching.
        let small = Surface::from(Sphere::around(p(6.0, 0.5, 0.5), 0.2).unwrap());
        assert_eq!(hit(small.into(), 5), "{0}: -1");
    }

    #[test]
    fn many_and_many() {
        let things: Vec<Value> =
            vec![mesh(0.0).into(), ball(9.0).into(), cube(0.5).into(), ball(10.5).into()];
        let found = Trial::of("Collision Many|Many").list(things).run().outputs;
        assert_eq!(texts(&found[0]), ["{0}: True, True, True, True"]);
        assert_eq!(texts(&found[1]), ["{0}: 2, 3, 0, 1"]);
        let alone = Trial::of("Collision Many|Many").gaps([Some(Value::from(mesh(0.0))), None]);
        assert_eq!(alone.texts(1), ["{0}: -1, -1"]);
    }

    #[test]
    fn clashes() {
        let clash = |d: f64, n: i32| {
            Trial::of("Clash").list([mesh(0.0), mesh(9.0)]).list([mesh(0.5), mesh(1.5)]).item(d).item(n)
        };
        let met = clash(0.0, 9).run().outputs;
        assert_eq!((texts(&met[0]), texts(&met[4])), (vec!["{0}: 1".into()], vec!["{0;0}: 0".into()]));
        assert_eq!(texts(&met[3]), ["{0;0}: 0"]);
        assert_eq!(clash(0.5, 9).texts(0), ["{0}: 2"]);
        assert_eq!(clash(0.5, 1).texts(0), ["{0}: 1"]);
        assert!(clash(-1.0, 1).message().contains("at least 0"));
    }
}
