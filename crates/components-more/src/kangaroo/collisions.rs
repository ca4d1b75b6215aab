//! Goals-Col: spheres, thick segments and points that keep out of each other and of shapes.

use std::collections::{HashMap, HashSet};
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Kind, Value, cast};
use katydid_geometry::{
    CancellationToken, ClosestOnCurve, Containment, Curve, Line, Mesh, MeshTree, Plane, Point3, Vector3,
};

use super::goal::finite;
use super::thresholds::{DEPENDENT, MOST_COLLIDERS, MOST_PAIRS, ON_CURVE, SHORTEST};
use super::{Goal, Pull, Rule};

/// Adds a pull to one that is there: the weighted mean of both.
fn add(pulls: &mut [Pull], i: usize, by: Vector3, weight: f64) {
    if let Some(pull) = pulls.get_mut(i) {
        let whole = pull.weight + weight;
        if whole != 0.0 {
            *pull = Pull::new((pull.by * pull.weight + by * weight) / whole, whole);
        }
    }
}

#[derive(Debug)]
struct Spheres {
    radius: f64,
    strength: f64,
}

impl Rule for Spheres {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        // Cells as wide as a sphere: only neighbours in cells next to each other can touch.
        let wide = 2.0 * self.radius;
        let cell = |p: Point3| [p.x, p.y, p.z].map(|x| (x / wide).floor() as i64);
        let mut cells: HashMap<[i64; 3], Vec<usize>> = HashMap::with_capacity(points.len());
        for (i, p) in points.iter().enumerate() {
            // Where all are in one cell this is long.
            if i % 256 == 0 && CancellationToken::is_over() {
                return;
            }
            let [x, y, z] = cell(*p);
            for (dx, dy, dz) in (0..27).map(|k| (k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)) {
                let key = [x.saturating_add(dx), y.saturating_add(dy), z.saturating_add(dz)];
                for &j in cells.get(&key).map_or(&[][..], Vec::as_slice) {
                    let Some(q) = points.get(j) else { continue };
                    let way = *p - *q;
                    let distance = way.length();
                    if distance < wide && distance > SHORTEST {
                        let off = way * (0.5 * (wide - distance) / distance);
                        add(pulls, i, off, self.strength);
                        add(pulls, j, -off, self.strength);
                    }
                }
            }
            cells.entry([x, y, z]).or_default().push(i);
        }
    }

    fn is_mutual(&self) -> bool {
        true
    }
}

/// Keeps spheres of one size out of each other. Stands for Kangaroo 2's SphereCollide.
#[component(
    "4b106d6a-0e09-4edc-941c-27d734ac4d59",
    name = "SphereCollide",
    nick = "SC",
    at = "Kangaroo2/Goals-Col"
)]
#[output("S", "S", "The goal, for a solver.")]
fn sphere_collide(
    /// The centres of the spheres.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// Their radius, in units.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Message::error(format!("The radius is {radius}: it must be greater than 0")));
    }
    let rule = Spheres { radius, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: SphereCollide", points.present().collect(), rule)
}

/// Thick segments and spheres, which are segments of no length.
#[derive(Debug)]
struct Thick {
    radii: Vec<f64>,
    ignored: HashSet<(usize, usize)>,
    strength: f64,
}

/// The parameters of the nearest points of two segments (C. Ericson, *Real-time collision detection*, 2005, section 5.1.9).
fn nearest([a, b]: [Point3; 2], [c, d]: [Point3; 2]) -> [f64; 2] {
    let (u, v, w) = (b - a, d - c, a - c);
    let (uu, vv, vw) = (u.length_squared(), v.length_squared(), v.dot(w));
    if uu <= SHORTEST && vv <= SHORTEST {
        return [0.0, 0.0];
    }
    if uu <= SHORTEST {
        return [0.0, (vw / vv).clamp(0.0, 1.0)];
    }
    let uw = u.dot(w);
    if vv <= SHORTEST {
        return [(-uw / uu).clamp(0.0, 1.0), 0.0];
    }
    let uv = u.dot(v);
    let determinant = uu * vv - uv * uv;
    let s = if determinant > DEPENDENT * uu * vv {
        ((uv * vw - uw * vv) / determinant).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let t = (uv * s + vw) / vv;
    if t < 0.0 {
        [(-uw / uu).clamp(0.0, 1.0), 0.0]
    } else if t > 1.0 {
        [((uv - uw) / uu).clamp(0.0, 1.0), 1.0]
    } else {
        [s, t]
    }
}

impl Rule for Thick {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let pairs: Vec<[Point3; 2]> =
            points.chunks_exact(2).filter_map(|pair| pair.try_into().ok()).collect();
        // Swept along x: those whose boxes do not meet there are never compared.
        let radius = |i: usize| self.radii.get(i).copied().unwrap_or(0.0);
        let low = |i: usize, [a, b]: [Point3; 2]| a.x.min(b.x) - radius(i);
        let mut order: Vec<(f64, usize)> =
            pairs.iter().enumerate().map(|(i, pair)| (low(i, *pair), i)).collect();
        order.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        for (n, &(_, i)) in order.iter().enumerate() {
            let Some(&first) = pairs.get(i) else { continue };
            if n % 256 == 0 && CancellationToken::is_over() {
                return;
            }
            let high = first[0].x.max(first[1].x) + radius(i);
            for &(start, j) in order.iter().skip(n + 1) {
                if start > high {
                    break;
                }
                let Some(&second) = pairs.get(j) else { continue };
                if self.ignored.contains(&(i.min(j), i.max(j))) || first.iter().any(|p| second.contains(p)) {
                    continue;
                }
                let [s, t] = nearest(first, second);
                let (p, q) = (first[0].lerp(first[1], s), second[0].lerp(second[1], t));
                let way = p - q;
                let (distance, wanted) = (way.length(), radius(i) + radius(j));
                if distance < wanted && distance > SHORTEST {
                    let off = way * (0.5 * (wanted - distance) / distance);
                    for (k, share, sign) in [
                        (2 * i, 1.0 - s, 1.0),
                        (2 * i + 1, s, 1.0),
                        (2 * j, 1.0 - t, -1.0),
                        (2 * j + 1, t, -1.0),
                    ] {
                        add(pulls, k, off * sign, self.strength * share);
                    }
                }
            }
        }
    }

    fn is_mutual(&self) -> bool {
        true
    }
}

/// Keeps thick segments and spheres out of each other; segments that share an end do not collide. Stands for Kangaroo 2's
/// Collider.
#[component(
    "94bf912d-4d0c-4764-a100-5813a98a8b73",
    name = "Collider",
    nick = "Collider",
    at = "Kangaroo2/Goals-Col"
)]
#[output("C", "C", "The goal, for a solver.")]
fn collider(
    /// Segments and points.
    #[port("Objects", "Objects")]
    objects: List<Value>,
    /// The radius of each, in units; the last one is that of all that follow.
    #[port("Radii", "Radii", default = 1.0)]
    radii: List<f64>,
    /// The numbers of the first of pairs that do not collide.
    #[port("IgnoreA", "IgnoreA", optional)]
    ignore_first: List<i32>,
    /// The numbers of the second of these pairs.
    #[port("IgnoreB", "IgnoreB", optional)]
    ignore_second: List<i32>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let rules = Default::default();
    let mut points = Vec::new();
    for (k, object) in objects.present().enumerate() {
        let pair = match &object {
            Value::Point(p) => [*p, *p],
            other => match cast::value(other, Kind::Line, &rules) {
                Some(Value::Line(line)) => [line.from, line.to],
                _ => match cast::value(other, Kind::Point, &rules) {
                    Some(Value::Point(p)) => [p, p],
                    _ => return Err(Message::error(format!("Object {k} is neither a segment nor a point"))),
                },
            },
        };
        points.extend(pair);
    }
    if points.len() > 2 * MOST_COLLIDERS {
        return Err(Message::error(format!("{} objects are too many to collide", points.len() / 2)));
    }
    let mut sizes: Vec<f64> = radii.present().map(|r| finite(r, "A radius")).collect::<Result<_, _>>()?;
    let last = sizes.last().copied().ok_or_else(|| Message::error("There is no radius"))?;
    sizes.resize(points.len() / 2, last);
    let ignored = ignore_first.present().zip(ignore_second.present());
    let ignored = ignored.filter_map(|(a, b)| {
        let (a, b) = (usize::try_from(a).ok()?, usize::try_from(b).ok()?);
        Some((a.min(b), a.max(b)))
    });
    let rule =
        Thick { radii: sizes, ignored: ignored.collect(), strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: Collider", points, rule)
}

/// Points kept on one side of a closed curve in a plane.
#[derive(Debug)]
struct BesideCurve {
    curve: Shared<Curve>,
    plane: Plane,
    inside: bool,
    strength: f64,
}

impl Rule for BesideCurve {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let search = ClosestOnCurve::new(&self.curve);
        for (p, pull) in points.iter().zip(pulls) {
            let flat = self.plane.closest_point(*p);
            let Ok(side) = self.curve.contains_in_plane(flat, &self.plane, ON_CURVE) else { continue };
            let wrong = match side {
                Containment::Inside => !self.inside,
                Containment::Outside => self.inside,
                _ => false,
            };
            if wrong && let Ok(found) = search.nearest(flat) {
                *pull = Pull::new(found.point - flat, self.strength);
            }
        }
    }
}

/// Keeps points outside or inside a closed curve, seen along the normal of a plane. Stands for Kangaroo 2's
/// CurvePointCollide.
#[component(
    "02b1c69b-b3f7-4528-988e-449a59963e5e",
    name = "CurvePointCollide",
    nick = "CPC",
    at = "Kangaroo2/Goals-Col"
)]
#[output("S", "S", "The goal, for a solver.")]
fn curve_point_collide(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The closed curve, flat.
    #[port("Curve", "Curve")]
    curve: Shared<Curve>,
    /// The plane; the curve is seen along its normal.
    #[port("Plane", "Pl", default = Plane::XY)]
    plane: Plane,
    /// Whether the points stay inside; else outside.
    #[port("Inside", "In", default = false)]
    inside: bool,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let curve = Shared::new(curve.transformed(&katydid_geometry::Xform::planar_projection(&plane))?);
    let strength = finite(strength, "The strength")?;
    let rule = BesideCurve { curve, plane, inside, strength };
    Goal::item("Kangaroo goal: CurvePointCollide", points.present().collect(), rule)
}

/// Points kept on one side of a closed mesh.
#[derive(Debug)]
struct BesideMesh {
    tree: MeshTree,
    inside: bool,
    strength: f64,
}

impl Rule for BesideMesh {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        for (p, pull) in points.iter().zip(pulls) {
            let wrong = match self.tree.containment(*p, 0.0) {
                Containment::Inside => !self.inside,
                Containment::Outside => self.inside,
                _ => false,
            };
            if wrong && let Ok(found) = self.tree.nearest(*p) {
                *pull = Pull::new(found - *p, self.strength);
            }
        }
    }
}

/// Keeps points outside or inside a closed mesh, which is not moved itself. Stands for Kangaroo 2's SolidPointCollide.
#[component(
    "763c5b56-3dc6-4fe0-be7b-6b60cd27f744",
    name = "SolidPointCollide",
    nick = "SPC",
    at = "Kangaroo2/Goals-Col"
)]
#[output("S", "S", "The goal, for a solver.")]
fn solid_point_collide(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The closed mesh.
    #[port("Solid", "Solid")]
    solid: &Mesh,
    /// Whether the points stay inside; else outside.
    #[port("Inside", "In", default = false)]
    inside: bool,
    /// Whether the mesh is left where it is; that it is moved too is not supported.
    #[port("Unidirectional", "Uni", default = true)]
    fixed: bool,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    if !fixed {
        context.tell(Message::remark("A solid that is moved by the points is not supported: it stays"));
    }
    let rule = BesideMesh { tree: MeshTree::new(solid), inside, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: SolidPointCollide", points.present().collect(), rule)
}

/// The segments between all pairs of points.
pub(super) fn pairs(points: &[Point3]) -> Result<Vec<Line>, Message> {
    if points.len().saturating_mul(points.len()) / 2 > MOST_PAIRS {
        return Err(Message::error(format!("{} points have too many pairs", points.len())));
    }
    let pair = |(i, a): (usize, &Point3)| {
        let a = *a;
        points.iter().skip(i + 1).map(move |b| Line::new(a, *b))
    };
    Ok(points.iter().enumerate().flat_map(pair).collect())
}
