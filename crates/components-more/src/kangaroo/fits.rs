//! Goals-Co and their kin: points pulled to the plane, line, circle, sphere or shape that fits them best.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary as _;
use katydid_geometry::{Circle, Line, Mesh, MeshFace, Plane, Point3, Vector3};

use super::goal::finite;
use super::thresholds::{DEPENDENT, SHORTEST, SMALLEST_TURN};
use super::{Goal, Pull, Rule};

/// What points are fitted with.
#[derive(Debug)]
enum Fit {
    Plane,
    Line,
    Circle,
    Sphere,
}

#[derive(Debug)]
struct Fitted {
    fit: Fit,
    strength: f64,
}

/// The centre and radius of the sphere that fits points best by the algebraic distance; in a plane, of the circle (I. Kåsa,
/// *A circle fitting procedure*, 1976). Solved about the mean by symmetric eigenvectors would lose flat sets: here the normal
/// equations of three unknowns, in the frame of the plane for a circle.
fn circle_in(plane: &Plane, points: &[Point3]) -> Option<Circle> {
    let flat: Vec<[f64; 2]> = points
        .iter()
        .map(|p| {
            let [u, v, _] = plane.coordinates(*p);
            [u, v]
        })
        .collect();
    let n = flat.len() as f64;
    let (mu, mv) = (flat.iter().map(|p| p[0]).sum::<f64>() / n, flat.iter().map(|p| p[1]).sum::<f64>() / n);
    let (mut uu, mut uv, mut vv, mut uw, mut vw, mut ww) = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    for [u, v] in &flat {
        let (u, v) = (u - mu, v - mv);
        let w = u * u + v * v;
        uu += u * u;
        uv += u * v;
        vv += v * v;
        uw += u * w;
        vw += v * w;
        ww += w;
    }
    let determinant = uu * vv - uv * uv;
    if !(determinant.abs() > DEPENDENT * (uu + vv) * (uu + vv)) {
        return None;
    }
    let (a, b) = (0.5 * (uw * vv - vw * uv) / determinant, 0.5 * (vw * uu - uw * uv) / determinant);
    let radius = (ww / n + a * a + b * b).sqrt();
    Some(Circle { plane: plane.with_origin(plane.at(mu + a, mv + b, 0.0)), radius })
}

/// The centre and radius of the sphere that fits points best by the algebraic distance.
fn sphere_of(points: &[Point3]) -> Option<(Point3, f64)> {
    let mean = Point3::mean(points)?;
    let (mut m, mut right, mut sum) = ([[0.0_f64; 3]; 3], [0.0_f64; 3], 0.0);
    for p in points {
        let d = *p - mean;
        let (v, w) = ([d.x, d.y, d.z], d.length_squared());
        for (row, x) in m.iter_mut().zip(v) {
            row.iter_mut().zip(v).for_each(|(cell, y)| *cell += x * y);
        }
        right.iter_mut().zip(v).for_each(|(r, x)| *r += x * w);
        sum += w;
    }
    let [a, b, c] = m.map(|[x, y, z]| Vector3::new(x, y, z));
    let determinant = a.dot(b.cross(c));
    let scale = sum / 3.0;
    if !(determinant.abs() > DEPENDENT * scale * scale * scale) {
        return None;
    }
    // Cramer's rule on rows of a symmetric matrix: its inverse has the cross products as columns.
    let half = (b.cross(c) * right[0] + c.cross(a) * right[1] + a.cross(b) * right[2]) / (2.0 * determinant);
    Some((mean + half, (sum / points.len() as f64 + half.length_squared()).sqrt()))
}

/// The straight line through the mean along which points spread most.
fn line_of(points: &[Point3]) -> Option<(Point3, Vector3)> {
    let mean = Point3::mean(points)?;
    let ends = [points.first()?, points.last()?];
    let mut axis =
        (*ends[1] - *ends[0]).unitized().or_else(|| points.iter().find_map(|p| (*p - mean).unitized()))?;
    // Power iteration on the covariance: the ratio of a spread to the next is large for points that are near a line.
    for _ in 0..30 {
        let turned = points.iter().fold(Vector3::ZERO, |sum, p| {
            let d = *p - mean;
            sum + d * d.dot(axis)
        });
        axis = turned.unitized().unwrap_or(axis);
    }
    Some((mean, axis))
}

fn pull_each(points: &[Point3], pulls: &mut [Pull], strength: f64, to: impl Fn(Point3) -> Point3) {
    for (p, pull) in points.iter().zip(pulls) {
        *pull = Pull::new(to(*p) - *p, strength);
    }
}

fn on_sphere(centre: Point3, radius: f64, p: Point3) -> Point3 {
    match (p - centre).unitized() {
        Some(way) => centre + way * radius,
        None => p,
    }
}

impl Rule for Fitted {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        match self.fit {
            Fit::Plane => {
                if let Ok((plane, _)) = Plane::fit(points) {
                    pull_each(points, pulls, self.strength, |p| plane.closest_point(p));
                }
            }
            Fit::Line => {
                if let Some((mean, axis)) = line_of(points) {
                    pull_each(points, pulls, self.strength, |p| mean + axis * (p - mean).dot(axis));
                }
            }
            Fit::Circle => {
                let fitted = Plane::fit(points).ok().and_then(|(plane, _)| circle_in(&plane, points));
                if let Some(circle) = fitted {
                    let (plane, radius) = (circle.plane, circle.radius);
                    let to = |p: Point3| on_sphere(plane.origin, radius, plane.closest_point(p));
                    pull_each(points, pulls, self.strength, to);
                }
            }
            Fit::Sphere => {
                if let Some((centre, radius)) = sphere_of(points) {
                    pull_each(points, pulls, self.strength, |p| on_sphere(centre, radius, p));
                }
            }
        }
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        match self.fit {
            Fit::Plane => Plane::fit(points).ok().map(|(plane, _)| Value::from(plane)),
            Fit::Line => {
                let (mean, axis) = line_of(points)?;
                let along = points.iter().map(|p| (*p - mean).dot(axis));
                let (low, high) = along.fold((0.0, 0.0), |(a, b): (f64, f64), x| (a.min(x), b.max(x)));
                Some(Value::from(Line::new(mean + axis * low, mean + axis * high)))
            }
            Fit::Circle => circle_in(&Plane::fit(points).ok()?.0, points).map(Value::from),
            Fit::Sphere => None,
        }
    }
}

fn fitted(name: &'static str, fit: Fit, points: Vec<Point3>, strength: f64) -> Result<Value, Message> {
    Goal::item(name, points, Fitted { fit, strength: finite(strength, "The strength")? })
}

/// Pulls points to the plane that fits them best. Stands for Kangaroo 2's CoPlanar.
#[component(
    "8f78572b-7fd0-4795-b444-3de3ca5933ae",
    name = "CoPlanar",
    nick = "CoPlanar",
    at = "Kangaroo2/Goals-Co"
)]
#[output("C", "C", "The goal, for a solver.")]
fn coplanar(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    fitted("Kangaroo goal: CoPlanar", Fit::Plane, points.present().collect(), strength)
}

/// Pulls points to the straight line that fits them best. Stands for Kangaroo 2's CoLinear.
#[component(
    "236d3928-a06f-4c60-bd2d-787691421391",
    name = "CoLinear",
    nick = "CoLinear",
    at = "Kangaroo2/Goals-Co"
)]
#[output("C", "C", "The goal, for a solver.")]
fn colinear(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    fitted("Kangaroo goal: CoLinear", Fit::Line, points.present().collect(), strength)
}

/// Pulls points to the circle that fits them best. Stands for Kangaroo 2's CoCircular.
#[component(
    "6e9f7437-714b-4140-99e8-0842de58f59c",
    name = "CoCircular",
    nick = "CoCircular",
    at = "Kangaroo2/Goals-Co"
)]
#[output("C", "C", "The goal, for a solver.")]
fn cocircular(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    fitted("Kangaroo goal: CoCircular", Fit::Circle, points.present().collect(), strength)
}

/// Pulls points to the sphere that fits them best. Stands for Kangaroo 2's CoSpherical.
#[component(
    "dd500398-727a-466f-9b51-83634266a83a",
    name = "CoSpherical",
    nick = "CoSpherical",
    at = "Kangaroo2/Goals-Co"
)]
#[output("C", "C", "The goal, for a solver.")]
fn cospherical(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    fitted("Kangaroo goal: CoSpherical", Fit::Sphere, points.present().collect(), strength)
}

/// The corners of the quads of a mesh.
fn quads(mesh: &Mesh) -> impl Iterator<Item = Vec<Point3>> + '_ {
    let quads = mesh.faces().iter().enumerate().filter(|(_, face)| matches!(face, MeshFace::Quad(_)));
    quads.filter_map(|(i, _)| mesh.face_points(i))
}

/// Makes the quads of a mesh flat: a goal for each, of the points nearest to a plane. Stands for Kangaroo 2's Planarize.
#[component(
    "e29cdc8a-b58e-4854-aa1d-f09b43a9b6a3",
    name = "Planarize",
    nick = "Planarize",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("P", "P", "The goals, for a solver, in order of the quads.")]
fn planarize(
    context: &Context<'_>,
    /// The mesh; its triangles are flat anyway.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Vec<Value>, Message> {
    context.items(mesh.faces().len())?;
    quads(mesh).map(|points| fitted("Kangaroo goal: Planarize", Fit::Plane, points, strength)).collect()
}

/// Makes a quad have a circle through its corners. Stands for Kangaroo 2's CyclicQuad.
#[component(
    "15ab0db0-5093-4a37-854a-cee70457a847",
    name = "CyclicQuad",
    nick = "CyclicQuad",
    at = "Kangaroo2/Goals-Mesh",
    old
)]
#[output("C", "C", "The goal, for a solver.")]
fn cyclic_quad(
    /// A corner.
    #[port("P0", "P0")]
    a: Point3,
    /// The next corner.
    #[port("P1", "P1")]
    b: Point3,
    /// The next corner.
    #[port("P2", "P2")]
    c: Point3,
    /// The last corner.
    #[port("P3", "P3")]
    d: Point3,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    fitted("Kangaroo goal: CyclicQuad", Fit::Circle, vec![a, b, c, d], strength)
}

/// Makes the quads of a mesh have circles through their corners: a goal for each. Stands for Kangaroo 2's CyclicQuad.
#[component(
    "5d81faae-befc-4c12-b558-beaf2ebee8f1",
    name = "CyclicQuad",
    nick = "CyclicQuad",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("C", "C", "The goals, for a solver, in order of the quads.")]
fn cyclic_quads(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Vec<Value>, Message> {
    context.items(mesh.faces().len())?;
    quads(mesh).map(|points| fitted("Kangaroo goal: CyclicQuad", Fit::Circle, points, strength)).collect()
}

/// Points that keep their shape: turned and moved as a whole.
#[derive(Debug)]
struct Rigid {
    shape: Vec<Vector3>,
    strength: f64,
}

impl Rule for Rigid {
    fn memory(&self) -> Vec<f64> {
        vec![0.0, 0.0, 0.0, 1.0]
    }

    fn pull(&self, points: &[Point3], memory: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let (Some(mean), Ok(turn)) = (Point3::mean(points), <&mut [f64; 4]>::try_from(memory)) else {
            return;
        };
        // The rotation that fits best, from the one before (M. Müller and others, *A robust method to extract the rotational
        // part of deformations*, 2016).
        for _ in 0..20 {
            let (mut across, mut along) = (Vector3::ZERO, 0.0);
            for (shape, p) in self.shape.iter().zip(points) {
                let turned = rotated(*turn, *shape);
                across += turned.cross(*p - mean);
                along += turned.dot(*p - mean);
            }
            let omega = across / (along.abs() + SHORTEST);
            let angle = omega.length();
            if !(angle > SMALLEST_TURN) {
                break;
            }
            let half = 0.5 * angle;
            let axis = omega * (half.sine() / angle);
            *turn = product([axis.x, axis.y, axis.z, half.cosine()], *turn);
        }
        for ((shape, p), pull) in self.shape.iter().zip(points).zip(pulls) {
            *pull = Pull::new(mean + rotated(*turn, *shape) - *p, self.strength);
        }
    }
}

/// A vector turned by a unit quaternion (x, y, z, w).
fn rotated([x, y, z, w]: [f64; 4], v: Vector3) -> Vector3 {
    let axis = Vector3::new(x, y, z);
    let twice = axis.cross(v) * 2.0;
    v + twice * w + axis.cross(twice)
}

/// The turn `b` followed by `a`, of unit length.
fn product(a: [f64; 4], b: [f64; 4]) -> [f64; 4] {
    let ([ax, ay, az, aw], [bx, by, bz, bw]) = (a, b);
    let q = [
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    ];
    let size = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    if size > 0.0 { q.map(|x| x / size) } else { [0.0, 0.0, 0.0, 1.0] }
}

fn rigid(points: Vec<Point3>, strength: f64) -> Result<Value, Message> {
    let mean = Point3::mean(&points).ok_or_else(|| Message::error("There are no points"))?;
    let shape = points.iter().map(|p| *p - mean).collect();
    Goal::item(
        "Kangaroo goal: RigidBody",
        points,
        Rigid { shape, strength: finite(strength, "The strength")? },
    )
}

/// Keeps points in the shape that they have to each other: they move and turn as a whole. Stands for Kangaroo 2's
/// RigidPointSet; the frame is not computed with.
#[component(
    "8aa5774d-422a-433b-9a3f-667946bde157",
    name = "RigidPointSet",
    nick = "RigidPointSet",
    at = "Kangaroo2/Goals-6dof"
)]
#[output("RigidBody", "RB", "The goal, for a solver.")]
#[output("Plane", "P", "The frame where it is at first.")]
fn rigid_point_set(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The frame; one at the middle of the points, along the axes of the world, when nothing is given.
    #[port("Plane", "Plane", optional)]
    plane: Option<Plane>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<(Value, Plane), Message> {
    let points: Vec<Point3> = points.present().collect();
    let middle = Point3::mean(&points).unwrap_or(Point3::ORIGIN);
    Ok((rigid(points, strength)?, plane.unwrap_or_else(|| Plane::XY.with_origin(middle))))
}

/// Keeps a mesh in its shape, and points with it: all move and turn as a whole. Stands for an earlier RigidBody of Kangaroo 2.
#[component(
    "559ec10e-2671-4bba-b5a7-11816e8fb17b",
    name = "RigidBody",
    nick = "RigidBody",
    at = "Kangaroo2/Goals"
)]
#[output("RigidBody", "RB", "The goal, for a solver.")]
fn rigid_body(
    /// The mesh.
    #[port("Part", "Part")]
    mesh: &Mesh,
    /// Points that are fixed to it.
    #[port("Points", "Points", optional)]
    points: List<Point3>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    rigid(mesh.vertices().iter().copied().chain(points.present()).collect(), strength)
}
