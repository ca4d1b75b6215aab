//! Goals-On: points that stay on a curve, a mesh, a plane, or above the floor.

use std::sync::Arc as Shared;

use katydid_component::{List, Message, component};
use katydid_data::Value;
use katydid_geometry::{ClosestOnCurve, Curve, Mesh, MeshTree, Plane, Point3, Vector3};

use super::goal::finite;
use super::{Goal, Pull, Rule};

/// Points pulled to the nearest place of a curve.
#[derive(Debug)]
pub(super) struct OnCurve {
    pub(super) curve: Shared<Curve>,
    pub(super) strength: f64,
}

impl Rule for OnCurve {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        let search = ClosestOnCurve::new(&self.curve);
        for (p, pull) in points.iter().zip(pulls) {
            if let Ok(found) = search.nearest(*p) {
                *pull = Pull::new(found.point - *p, self.strength);
            }
        }
    }
}

/// Keeps points on a curve. Stands for Kangaroo 2's OnCurve.
#[component(
    "8b4dbe32-0c6c-4304-972e-3f60ed613114",
    name = "OnCurve",
    nick = "OnCurve",
    at = "Kangaroo2/Goals-On"
)]
#[output("P", "P", "The goal, for a solver.")]
fn on_curve(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The curve.
    #[port("Curve", "Curve")]
    curve: Shared<Curve>,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let strength = finite(strength, "The strength")?;
    Goal::item("Kangaroo goal: OnCurve", points.present().collect(), OnCurve { curve, strength })
}

/// Points pulled to the nearest place of a mesh.
#[derive(Debug)]
pub(super) struct OnMesh {
    pub(super) tree: MeshTree,
    pub(super) strength: f64,
}

impl Rule for OnMesh {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        for (p, pull) in points.iter().zip(pulls) {
            if let Ok(found) = self.tree.nearest(*p) {
                *pull = Pull::new(found - *p, self.strength);
            }
        }
    }
}

/// Keeps points on a mesh. Stands for Kangaroo 2's OnMesh.
#[component(
    "6c1c3018-487b-4573-afc5-3af263ae5808",
    name = "OnMesh",
    nick = "OnMesh",
    at = "Kangaroo2/Goals-On"
)]
#[output("P", "P", "The goal, for a solver.")]
fn on_mesh(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let strength = finite(strength, "The strength")?;
    let rule = OnMesh { tree: MeshTree::new(mesh), strength };
    Goal::item("Kangaroo goal: OnMesh", points.present().collect(), rule)
}

/// Points pulled to a plane.
#[derive(Debug)]
struct OnPlane {
    plane: Plane,
    strength: f64,
}

impl Rule for OnPlane {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        for (p, pull) in points.iter().zip(pulls) {
            *pull = Pull::new(self.plane.closest_point(*p) - *p, self.strength);
        }
    }
}

/// Keeps points on a plane. Stands for Kangaroo 2's OnPlane.
#[component(
    "d4d13384-1914-42ed-b1f2-687c1959bd14",
    name = "OnPlane",
    nick = "OnPlane",
    at = "Kangaroo2/Goals-On"
)]
#[output("P", "P", "The goal, for a solver.")]
fn on_plane(
    /// The points.
    #[port("Points", "Points")]
    points: List<Point3>,
    /// The plane.
    #[port("Plane", "Plane", default = Plane::XY)]
    plane: Plane,
    /// The strength.
    #[port("Strength", "Strength", default = 1.0)]
    strength: f64,
) -> Result<Value, Message> {
    let strength = finite(strength, "The strength")?;
    if !plane.is_finite() {
        return Err(Message::error("The plane is not finite"));
    }
    Goal::item("Kangaroo goal: OnPlane", points.present().collect(), OnPlane { plane, strength })
}

/// Points kept from falling below z = 0.
#[derive(Debug)]
pub(super) struct Floor {
    pub(super) strength: f64,
}

impl Rule for Floor {
    fn pull(&self, points: &[Point3], _: &mut [f64], _: usize, pulls: &mut [Pull]) {
        for (p, pull) in points.iter().zip(pulls).filter(|(p, _)| p.z < 0.0) {
            *pull = Pull::new(Vector3::new(0.0, 0.0, -p.z), self.strength);
        }
    }
}

/// Keeps points from falling below z = 0. Stands for Kangaroo 2's FloorFriction; its friction is not computed, as points
/// come to rest in one solve.
#[component(
    "780a08f2-c42d-4b8e-b8c9-8b3e09c318d0",
    name = "FloorFriction",
    nick = "Floor",
    at = "Kangaroo2/Goals-Pt"
)]
#[output("Floor", "F", "The goal, for a solver.")]
fn floor_friction(
    context: &katydid_component::Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
    /// How much friction there is; only 0 is computed.
    #[port("Limit", "L", default = 0.0)]
    limit: f64,
    /// The strength.
    #[port("Strength", "S", default = 1000.0)]
    strength: f64,
) -> Result<Value, Message> {
    if limit != 0.0 {
        context.tell(Message::remark("Friction is not supported: the points slide freely on the floor"));
    }
    let rule = Floor { strength: finite(strength, "The strength")? };
    Goal::item("Kangaroo goal: FloorFriction", points.present().collect(), rule)
}

/// Keeps all particles of a solver from falling below z = 0. Stands for Kangaroo 2's Floor.
#[component(
    "14ac13f4-c22d-487c-be01-c6daf952f1be",
    name = "Floor",
    nick = "Floor",
    at = "Kangaroo2/Goals-Pt"
)]
#[output("H", "H", "The goal, for a solver.")]
fn floor(
    /// The strength.
    #[port("Strength", "Strength", default = 1000.0)]
    strength: f64,
) -> Result<Value, Message> {
    Ok(Goal::everywhere("Kangaroo goal: Floor", Floor { strength: finite(strength, "The strength")? }))
}
