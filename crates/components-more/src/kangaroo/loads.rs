//! Forces: loads on points, wind and pressure on meshes, tension of a given size.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Mesh, Point3, Vector3};

use super::goal::finite;
use super::lines::{ends, place, segment};
use super::thresholds::SHORTEST;
use super::{Goal, Pull, Rule};

/// The same force on each point.
#[derive(Debug)]
pub(super) struct Force {
    pub(super) force: Vector3,
    pub(super) weight: f64,
}

impl Rule for Force {
    fn pull(&self, _: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        // A move times its weight is the force, whatever the weight.
        if self.weight != 0.0 {
            pulls.fill(Pull::new(self.force / self.weight, self.weight));
        }
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        points.first().map(|p| Value::Point(*p))
    }
}

fn load(point: &Value, force: Vector3, weight: f64) -> Result<Value, Message> {
    if !force.is_finite() {
        return Err(Message::error("The force is not finite"));
    }
    Goal::of_places("Kangaroo goal: Load", vec![place(point)?], Force { force, weight })
}

/// A force on a point. Stands for Kangaroo 2's Load.
#[component("2019c995-53af-4eb2-976d-95b1fdc823fa", name = "Load", nick = "Load", at = "Kangaroo2/Goals-Pt")]
#[output("U", "U", "The goal, for a solver.")]
fn load_with_weight(
    /// The point, or the number of its particle.
    #[port("P", "P")]
    point: Value,
    /// The force: against a spring of strength 1 it is the length by which the spring becomes longer.
    #[port("FV", "FV", default = Vector3::new(0.0, 0.0, -1.0))]
    force: Vector3,
    /// The force is multiplied by this.
    #[port("W", "W", default = 1.0)]
    weight: f64,
) -> Result<Value, Message> {
    load(&point, force * finite(weight, "The weight")?, 1.0)
}

/// A force on a point. Stands for an earlier Load of Kangaroo 2.
#[component(
    "580a1a0c-314d-4033-a54c-c129400b4b58",
    name = "Load",
    nick = "Load",
    at = "Kangaroo2/Goals-Pt",
    old
)]
#[output("U", "U", "The goal, for a solver.")]
fn load_plain(
    /// The point, or the number of its particle.
    #[port("P", "P")]
    point: Value,
    /// The force: against a spring of strength 1 it is the length by which the spring becomes longer.
    #[port("FV", "FV", default = Vector3::new(0.0, 0.0, -1.0))]
    force: Vector3,
) -> Result<Value, Message> {
    load(&point, force, 1.0)
}

/// The same force straight up on all vertices of a mesh, down where it is negative: a goal for each. Stands for Kangaroo 2's
/// VertexLoads.
#[component(
    "2b3f5029-cfec-4f95-96d1-757bd9c51da1",
    name = "VertexLoads",
    nick = "VertexLoads",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("L", "L", "The goals, for a solver, in order of the vertices.")]
fn vertex_loads(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The force on each vertex, up.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Vec<Value>, Message> {
    let force = Vector3::new(0.0, 0.0, finite(strength, "The strength")?);
    let merged = mesh.merged_indices();
    context.items(mesh.vertices().len())?;
    // Vertices in one place are one particle, which is loaded once.
    let own = mesh.vertices().iter().zip(&merged).enumerate().filter(|(i, (_, m))| *i == **m as usize);
    own.map(|(_, (p, _))| Goal::item("Kangaroo goal: Load", vec![*p], Force { force, weight: 1.0 })).collect()
}

/// A force along the normal of a triangle, in proportion to its area.
#[derive(Debug)]
pub(super) struct Pressure {
    pub(super) strength: f64,
}

impl Rule for Pressure {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let [a, b, c] = points else { return };
        // Half the cross product is area times normal; a third for each corner.
        let force = (*b - *a).cross(*c - *a) * (self.strength / 6.0);
        pulls.fill(Pull::new(force, 1.0));
    }
}

/// The triangles of a mesh: quads are cut from first to third corner.
pub(super) fn triangles(mesh: &Mesh) -> Vec<[Point3; 3]> {
    mesh.triangles().collect()
}

/// Pushes a mesh along its normals, in proportion to the area: a goal for each triangle; quads are two. Stands for
/// Kangaroo 2's Pressure.
#[component(
    "2e1fb4fb-22a8-4853-a9f5-ab65602aad77",
    name = "Pressure",
    nick = "Pressure",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("P", "P", "The goals, for a solver, in order of the triangles.")]
fn pressure(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The force on a unit of area.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Vec<Value>, Message> {
    let strength = finite(strength, "The strength")?;
    let triangles = triangles(mesh);
    context.items(triangles.len())?;
    triangles
        .into_iter()
        .map(|t| Goal::item("Kangaroo goal: Pressure", t.to_vec(), Pressure { strength }))
        .collect()
}

/// Wind on a triangle: the part of it along the normal, by the area that it meets.
#[derive(Debug)]
struct Wind {
    wind: Vector3,
}

impl Rule for Wind {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let [a, b, c] = points else { return };
        let area = (*b - *a).cross(*c - *a) * 0.5;
        if let Some(normal) = area.unitized() {
            pulls.fill(Pull::new(normal * (self.wind.dot(area) / 3.0), 1.0));
        }
    }
}

/// Wind on a mesh: each triangle is pushed along its normal by the part of the wind along it, times the area. Stands for
/// Kangaroo 2's Wind; the share of each triangle is our reading.
#[component(
    "928b2951-2a01-4b6b-8ccb-6fbeb3e490ad",
    name = "Wind",
    nick = "Wind",
    at = "Kangaroo2/Goals-Mesh"
)]
#[output("W", "W", "The goals, for a solver, in order of the triangles.")]
fn wind(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The direction of the wind, as long as it is strong.
    #[port("Wind", "W", default = Vector3::X)]
    wind: Vector3,
) -> Result<Vec<Value>, Message> {
    if !wind.is_finite() {
        return Err(Message::error("The wind is not finite"));
    }
    // The goals of the two triangles of a face take 1,080 bytes, measured from outside.
    context.bytes(mesh.faces().len().saturating_mul(1_100))?;
    let triangles = triangles(mesh);
    context.items(triangles.len())?;
    triangles.into_iter().map(|t| Goal::item("Kangaroo goal: Wind", t.to_vec(), Wind { wind })).collect()
}

/// The same tension at any length.
#[derive(Debug)]
struct Tension {
    tension: f64,
}

impl Rule for Tension {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let ([a, b], [p, q]) = (points, pulls) else { return };
        let way = *b - *a;
        let length = way.length();
        if length > SHORTEST {
            // A spring of no rest length whose stiffness is tension / length.
            let weight = 2.0 * self.tension / length;
            (*p, *q) = (Pull::new(way * 0.5, weight), Pull::new(way * -0.5, weight));
        }
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        segment(points)
    }
}

/// Pulls the ends of a segment together with the same force at any length. Stands for Kangaroo 2's ConstantTension.
#[component(
    "c9cf79b9-eced-4591-8f8e-641739df0211",
    name = "ConstantTension",
    nick = "CT",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("CT", "CT", "The goal, for a solver.")]
fn constant_tension(
    /// The segment: a curve counts by its ends.
    #[port("Line", "Line")]
    line: &Curve,
    /// The force; a negative one pushes the ends apart.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let rule = Tension { tension: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: ConstantTension", ends(line).to_vec(), rule)
}

/// Weight in proportion to length, half at each end.
#[derive(Debug)]
struct Weight {
    weight: f64,
}

impl Rule for Weight {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let [a, b] = points else { return };
        pulls.fill(Pull::new(Vector3::new(0.0, 0.0, -0.5 * self.weight * a.distance_to(*b)), 1.0));
    }

    fn shown(&self, points: &[Point3]) -> Option<Value> {
        segment(points)
    }
}

/// The weight of a segment, which grows with its length: half of it at each end, down along z. Stands for Kangaroo 2's
/// DynamicWeight1d.
#[component(
    "7db2c4c9-15b5-4378-8495-a8f9a8db5723",
    name = "DynamicWeight1d",
    nick = "DW",
    at = "Kangaroo2/Goals-Lin"
)]
#[output("DW", "DW", "The goal, for a solver.")]
fn dynamic_weight(
    /// The segment: a curve counts by its ends.
    #[port("Line", "Line")]
    line: &Curve,
    /// The weight of a unit of length.
    #[port("W", "W", default = 1.0)]
    weight: f64,
) -> Result<Value, Message> {
    let rule = Weight { weight: finite(weight, "The weight")? };
    Goal::item("Kangaroo goal: DynamicWeight1d", ends(line).to_vec(), rule)
}

/// A push away from a place in one step.
#[derive(Debug)]
struct Bomb {
    place: Point3,
    step: usize,
    strength: f64,
}

impl Rule for Bomb {
    fn pull(&self, points: &[Point3], _: &mut [f64], step: usize, pulls: &mut [Pull]) {
        if step != self.step {
            return;
        }
        for (p, pull) in points.iter().zip(pulls) {
            let way = *p - self.place;
            let squared = way.length_squared();
            if squared > SHORTEST * SHORTEST {
                *pull = Pull::new(way * (self.strength / squared), 1.0);
            }
        }
    }
}

/// Pushes points away from a place in one step of the solver, less the farther they are. Stands for Kangaroo 2's Bomb; that
/// the push falls with the distance is our reading.
#[component("2f3fd2e9-2cc4-47be-af5a-2f3916f76a92", name = "Bomb", nick = "B", at = "Kangaroo2/Goals-Pt")]
#[output("B", "B", "The goal, for a solver.")]
fn bomb(
    /// The place.
    #[port("Location", "Location")]
    place: Point3,
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The number of the step, from 0.
    #[port("Detonation", "Detonation", default = 10)]
    step: i32,
    /// How strong it is.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
    /// Not needed: each solve begins anew.
    #[port("Reset", "Reset", optional)]
    _reset: Option<bool>,
) -> Result<Value, Message> {
    if !place.is_finite() {
        return Err(Message::error("The location is not finite"));
    }
    let step = usize::try_from(step).unwrap_or(0);
    let rule = Bomb { place, step, strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: Bomb", points.present().collect(), rule)
}
