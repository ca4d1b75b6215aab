//! Intersect / Mathematical: what is seen from a point.

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_elementary::Elementary;
use katydid_geometry::brep::ClosestOnBrep;
use katydid_geometry::intersect::curve_curve;
use katydid_geometry::{Curve, Line, MeshTree, Plane, Point3, Vector3};

use crate::vector::hit;

/// Something that stops a ray.
enum Obstacle {
    Curve(std::sync::Arc<Curve>),
    Brep(Box<ClosestOnBrep>),
    /// A mesh that is asked often.
    Tree(Box<MeshTree>),
    /// A mesh that is asked once.
    Mesh(std::sync::Arc<katydid_geometry::Mesh>),
}

impl Obstacle {
    /// The geometry as an obstacle for one ray, or for many; `None` for what stops none.
    fn new(context: &Context<'_>, value: &Value, many: bool) -> Option<Self> {
        let to = |kind| cast::value(value, kind, context.rules());
        let mesh = |mesh: std::sync::Arc<katydid_geometry::Mesh>| {
            if many { Self::Tree(Box::new(MeshTree::new(&mesh))) } else { Self::Mesh(mesh) }
        };
        match value {
            Value::Surface(_) | Value::Brep(_) | Value::Kept(_) => {
                let search = ClosestOnBrep::new(value.brep()?.ok()?).ok()?;
                Some(Self::Brep(Box::new(search)))
            }
            Value::Mesh(m) => Some(mesh(m.clone())),
            _ => match (to(Kind::Curve), to(Kind::Mesh)) {
                (Some(Value::Curve(curve)), _) => Some(Self::Curve(curve)),
                (_, Some(Value::Mesh(m))) => Some(mesh(m)),
                _ => None,
            },
        }
    }

    /// How far along the ray it is, at most as far as the ray reaches; parts of curves count where they come within the
    /// tolerance of it.
    fn distance(&self, context: &Context<'_>, ray: &Line) -> Result<Option<f64>, Message> {
        let (tolerance, reach) = (context.tolerance().absolute, ray.length());
        let first = |places: &mut dyn Iterator<Item = f64>| places.min_by(f64::total_cmp);
        let share = match self {
            Self::Curve(curve) => {
                let found = curve_curve(&Curve::from(*ray), curve, tolerance)?;
                let crossings = found.crossings.iter().map(|c| c.a);
                first(&mut crossings.chain(found.overlaps.iter().map(|o| o.a.start))).map(|t| t / reach)
            }
            Self::Brep(search) => {
                let found = search.curve_crossings(&Curve::from(*ray), tolerance)?;
                let crossings = found.crossings.iter().map(|c| c.t);
                first(&mut crossings.chain(found.overlaps.iter().map(|o| o.start))).map(|t| t / reach)
            }
            Self::Tree(tree) => tree.line_hits(ray.from, ray.direction(), [0.0, 1.0])?.first().map(|h| h.t),
            Self::Mesh(mesh) => {
                let hits = hit::triangles(mesh)
                    .filter_map(|t| hit::through_triangle(t, ray.from, ray.direction()))
                    .filter(|t| (0.0..=1.0).contains(t));
                first(&mut { hits })
            }
        };
        Ok(share.map(|x| x * reach))
    }
}

/// The obstacles of a list with their places in it.
fn obstacles(context: &Context<'_>, list: &List<'_, Geometry>, many: bool) -> Vec<(i32, Obstacle)> {
    let mut out = Vec::new();
    for (item, i) in list.iter().zip(0_i32..) {
        let Some(Geometry(value)) = item else { continue };
        match Obstacle::new(context, &value, many) {
            Some(obstacle) => out.push((i, obstacle)),
            None => context.warn(format!("A {} is no obstacle: it is looked through", value.kind().name())),
        }
    }
    out
}

/// Where a ray ends: at the first obstacle, with its place in the list, or as far as it reaches, with -1.
fn seen(
    context: &Context<'_>,
    obstacles: &[(i32, Obstacle)],
    from: Point3,
    direction: Vector3,
    radius: f64,
) -> Result<(Point3, f64, i32), Message> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Message::error(format!("Radius is {radius}, which must be greater than 0")));
    }
    let along = direction.unitized().ok_or_else(|| Message::warning("The ray has no direction"))?;
    let mut best = (radius, -1);
    for (i, obstacle) in obstacles {
        let ray = Line::new(from, from + along * best.0);
        if let Some(distance) = obstacle.distance(context, &ray)?
            && (distance < best.0 || best.1 < 0)
        {
            best = (distance, *i);
        }
    }
    Ok((from + along * best.0, best.0, best.1))
}

/// The rays of one isovist.
fn around(
    context: &Context<'_>,
    plane: &Plane,
    count: i32,
    radius: f64,
    list: &List<'_, Geometry>,
) -> Result<Vec<(Point3, f64, i32)>, Message> {
    let n = usize::try_from(count).ok().filter(|&n| n > 0);
    let n = n.ok_or_else(|| Message::error(format!("Count is {count}: there must be at least 1 ray")))?;
    context.items(n.saturating_mul(3))?;
    let obstacles = obstacles(context, list, true);
    let mut out = Vec::with_capacity(n);
    for k in 0..n {
        context.check()?;
        let angle = std::f64::consts::TAU * k as f64 / n as f64;
        let direction = plane.x_axis * angle.cosine() + plane.y_axis * angle.sine();
        out.push(seen(context, &obstacles, plane.origin, direction, radius)?);
    }
    Ok(out)
}

/// What is seen all around from a point in a plane: evenly spread rays, each as far as the first obstacle or its reach.
///
/// Rays stop at curves, surfaces, boxes and meshes. Curves stop those that come within the tolerance of them.
#[component(
    "cab92254-1c79-4e5a-9972-0a4412b35c88",
    name = "IsoVist",
    nick = "IVist",
    at = "Intersect/Mathematical"
)]
#[output("Points", "P", "Where the rays end, counter-clockwise from the plane's x axis.")]
#[output("Distance", "D", "How long they are.")]
#[output("Index", "I", "For each the place of the obstacle in the list; -1 where there is none.")]
fn isovist(
    context: &Context<'_>,
    /// Its origin is the eye.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The number of rays, at least 1.
    #[port("Count", "N", default = 100)]
    count: i32,
    /// How far rays reach, above 0.
    #[port("Radius", "R")]
    radius: f64,
    /// What stops them.
    #[port("Obstacles", "O", optional)]
    obstacles: List<Geometry>,
) -> Result<(Vec<Point3>, Vec<f64>, Vec<i32>), Message> {
    let rays = around(context, &plane, count, radius, &obstacles)?;
    Ok((
        rays.iter().map(|r| r.0).collect(),
        rays.iter().map(|r| r.1).collect(),
        rays.iter().map(|r| r.2).collect(),
    ))
}

/// What is seen all around from a point in a plane. An early form of the component of the same name.
#[component(
    "c08ac8f7-cf90-4cdb-9862-2ba66b8408ef",
    name = "IsoVist",
    nick = "IVist",
    at = "Intersect/Mathematical",
    old
)]
#[output("Points", "P", "Where the rays end, counter-clockwise from the plane's x axis.")]
#[output("Distance", "D", "How long they are.")]
#[output("Hits", "H", "For each whether an obstacle stops it.")]
fn early_isovist(
    context: &Context<'_>,
    /// Its origin is the eye.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The number of rays, at least 1.
    #[port("Count", "N", default = 100)]
    count: i32,
    /// How far rays reach, above 0.
    #[port("Radius", "R")]
    radius: f64,
    /// What stops them.
    #[port("Obstacles", "O", optional)]
    obstacles: List<Geometry>,
) -> Result<(Vec<Point3>, Vec<f64>, Vec<bool>), Message> {
    let rays = around(context, &plane, count, radius, &obstacles)?;
    Ok((
        rays.iter().map(|r| r.0).collect(),
        rays.iter().map(|r| r.1).collect(),
        rays.iter().map(|r| r.2 >= 0).collect(),
    ))
}

/// How far one ray goes: to the first obstacle or as far as it reaches.
///
/// Rays stop at curves, surfaces, boxes and meshes. Curves stop those that come within the tolerance of them.
#[component(
    "93d0dcbc-6207-4745-aaf7-fe57a880f959",
    name = "IsoVist Ray",
    nick = "IVRay",
    at = "Intersect/Mathematical"
)]
#[output("Point", "P", "Where the ray ends.")]
#[output("Distance", "D", "How long it is.")]
#[output("Index", "I", "The place of the obstacle in the list; -1 when there is none.")]
fn isovist_ray(
    context: &Context<'_>,
    /// A line from the eye in the direction of the ray; its length does not matter.
    #[port("Sample", "S")]
    sample: Line,
    /// How far the ray reaches, above 0.
    #[port("Radius", "R")]
    radius: f64,
    /// What stops it.
    #[port("Obstacles", "O", optional)]
    list: List<Geometry>,
) -> Result<(Point3, f64, i32), Message> {
    seen(context, &obstacles(context, &list, false), sample.from, sample.direction(), radius)
}

/// How far one ray goes. An early form of the component of the same name.
#[component(
    "769f5b35-1780-4823-b593-118ecc3560e0",
    name = "IsoVist Ray",
    nick = "IVRay",
    at = "Intersect/Mathematical",
    old
)]
#[output("Point", "P", "Where the ray ends.")]
#[output("Distance", "D", "How long it is.")]
#[output("Hit", "H", "Whether an obstacle stops it.")]
fn early_isovist_ray(
    context: &Context<'_>,
    /// A line from the eye in the direction of the ray; its length does not matter.
    #[port("Sample", "S")]
    sample: Line,
    /// How far the ray reaches, above 0.
    #[port("Radius", "R")]
    radius: f64,
    /// What stops it.
    #[port("Obstacles", "O", optional)]
    list: List<Geometry>,
) -> Result<(Point3, f64, bool), Message> {
    let obstacles = obstacles(context, &list, false);
    let (point, distance, i) = seen(context, &obstacles, sample.from, sample.direction(), radius)?;
    Ok((point, distance, i >= 0))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::{Tree, Value};
    use katydid_geometry::{Box3, Interval, Line, Mesh, Plane, Point3, Sphere, Surface};

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn things() -> Vec<Value> {
        let cube = |x: f64| Box3 {
            plane: Plane::XY,
            x: Interval::new(x, x + 1.0),
            y: Interval::new(-1.0, 1.5),
            z: Interval::new(-1.0, 1.5),
        };
        vec![
            Line::new(p(9.0, -5.0, 0.0), p(9.0, 5.0, 0.0)).into(),
            Mesh::cuboid(&cube(4.0), 1, 1, 1).unwrap().into(),
            Surface::from(Sphere::around(p(0.0, 5.0, 0.0), 2.0).unwrap()).into(),
            cube(-7.0).into(),
        ]
    }

    #[test]
    fn all_around() {
        let view =
            |guid: &str| Trial::of_guid(guid).default().item(4).item(20.0).list(things()).run().outputs;
        let new = view("cab92254-1c79-4e5a-9972-0a4412b35c88");
        let ends = texts(&new[0]).join("").replace("-0,", "0,");
        assert_eq!(ends, "{0;0}: {4, 0, 0}, {0, 3, 0}, {-6, 0, 0}, {0, -20, 0}");
        assert_eq!(texts(&new[1]), ["{0;0}: 4, 3, 6, 20"]);
        assert_eq!(texts(&new[2]), ["{0;0}: 1, 2, 3, -1"]);
        let old = view("c08ac8f7-cf90-4cdb-9862-2ba66b8408ef");
        assert_eq!(texts(&old[2]), ["{0;0}: True, True, True, False"]);
        let none = Trial::of("IsoVist").default().item(0).item(20.0).tree(Tree::empty());
        assert!(none.message().contains("at least 1"));
    }

    #[test]
    fn one_ray() {
        let look = |to: Point3| Trial::of("IsoVist Ray").item(Line::new(p(0.0, 0.0, 0.0), to));
        let hit = look(p(0.1, 0.0, 0.0)).item(20.0).list(things()).run().outputs;
        assert_eq!((texts(&hit[1]), texts(&hit[2])), (vec!["{0}: 4".into()], vec!["{0}: 1".into()]));
        let short = look(p(0.1, 0.0, 0.0)).item(3.0).list(things()).run().outputs;
        assert_eq!(
            (texts(&short[0]), texts(&short[2])),
            (vec!["{0}: {3, 0, 0}".into()], vec!["{0}: -1".into()])
        );
        let curve = look(p(9.0, 2.0, 0.0)).item(20.0).list(things().into_iter().take(1));
        assert_eq!(curve.texts(0), ["{0}: {9, 2, 0}"]);
        let old = Trial::of_guid("769f5b35-1780-4823-b593-118ecc3560e0")
            .item(Line::new(p(0.0, 0.0, 0.0), p(1.0, 0.0, 0.0)));
        assert_eq!(old.item(20.0).list(things()).texts(2), ["{0}: True"]);
        assert!(look(p(0.0, 0.0, 0.0)).item(1.0).list(things()).message().contains("direction"));
        assert!(look(p(1.0, 0.0, 0.0)).item(-1.0).list(things()).message().contains("greater than 0"));
    }
}
