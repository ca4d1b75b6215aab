//! Planes: tweens with a turn by quaternions, flips and offsets.

use katydid_component::{Context, List, Message, component};
use katydid_geometry::Plane;

use super::mix::{Mix, turned};
use super::tween::{consecutive, through, unsupported};
use super::weights::{Way, pairs, weights};

/// A plane between two. Stands for Pufferfish's Tween Two Planes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3025",
    name = "Tween Two Planes",
    nick = "Twn2Plns",
    at = "Pufferfish/Plane"
)]
#[output("Tween", "T", "The plane between.")]
fn two(
    context: &Context<'_>,
    /// What factor 0 gives.
    #[port("Plane A", "A")]
    a: Plane,
    /// What factor 1 gives.
    #[port("Plane B", "B")]
    b: Plane,
    /// 0 gives A, 1 gives B; other numbers go beyond them.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
    /// Whether the plane turns evenly about one axis; else its axes are blended.
    #[port("Quaternion", "Q", default = false)]
    quaternion: bool,
) -> Result<Plane, Message> {
    if !factor.is_finite() {
        return Err(Message::error("The factor is not finite"));
    }
    if quaternion {
        return turned(&a, &b, factor);
    }
    Plane::mix(&[(a, 1.0 - factor), (b, factor)], context.tolerance().absolute)
}

/// Planes between neighbours of a set. Stands for Pufferfish's Tween Consecutive Planes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3026",
    name = "Tween Consecutive Planes",
    nick = "TwnConPlns",
    at = "Pufferfish/Plane"
)]
#[output("Tween", "T", "The planes between.")]
fn consecutive_planes(
    context: &Context<'_>,
    /// The set.
    #[port("Planes", "Pl")]
    planes: List<Plane>,
    /// 0 gives the first of each two neighbours, 1 the second.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
    /// Whether what lies far apart counts more, which is not supported.
    #[port("Weighted", "W", default = false)]
    weighted: bool,
    /// Whether the set goes on from its last item to its first.
    #[port("Loopback", "L", default = false)]
    closed: bool,
    /// 1 goes straight between neighbours, more by curves.
    #[port("Degree", "D", default = 1)]
    degree: i32,
    /// The spacing of curves, which does not count here.
    #[port("Interpolation Type", "I", optional)]
    _spacing: Option<i32>,
    /// Whether planes turn evenly about one axis; else axes are blended.
    #[port("Quaternion", "Q", default = false)]
    quaternion: bool,
) -> Result<Vec<Plane>, Message> {
    unsupported(context, false, weighted);
    if !quaternion {
        return consecutive(context, &planes, factor, closed, degree > 1);
    }
    let all: Vec<Plane> = planes.present().collect();
    let between = pairs(all.len(), closed).into_iter().filter_map(|[i, j]| Some((all.get(i)?, all.get(j)?)));
    between.map(|(a, b)| turned(a, b, factor)).collect()
}

/// A plane on the way through a set. Stands for Pufferfish's Tween Through Planes.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3027",
    name = "Tween Through Planes",
    nick = "TwnThruPlns",
    at = "Pufferfish/Plane"
)]
#[output("Tween", "T", "The plane at the factor.")]
fn through_planes(
    context: &Context<'_>,
    /// The set.
    #[port("Planes", "Pl")]
    planes: List<Plane>,
    /// 0 gives the first plane, 1 the last.
    #[port("Factor", "F", default = 0.5)]
    factor: f64,
    /// Whether the factor goes from 0 to 1; else it counts the planes.
    #[port("Normalized", "N", default = true)]
    normalized: bool,
    /// Whether the way is divided by its length, which is not supported.
    #[port("Equalized", "E", default = false)]
    equalized: bool,
    /// Whether what lies far apart counts more, which is not supported.
    #[port("Weighted", "W", default = false)]
    weighted: bool,
    /// Whether the set goes on from its last item to its first.
    #[port("Loopback", "L", default = false)]
    closed: bool,
    /// 1 goes straight between neighbours, more by curves.
    #[port("Degree", "D", default = 1)]
    degree: i32,
    /// The spacing of curves, which does not count here.
    #[port("Interpolation Type", "I", optional)]
    _spacing: Option<i32>,
    /// Whether planes turn evenly about one axis between neighbours; else axes are blended.
    #[port("Quaternion", "Q", default = false)]
    quaternion: bool,
) -> Result<Plane, Message> {
    unsupported(context, equalized, weighted);
    let way = Way { normalized, closed, smooth: degree > 1 && !quaternion };
    if !quaternion {
        return through(context, &planes, factor, way);
    }
    let all: Vec<Plane> = planes.present().collect();
    match weights(all.len(), factor, way)?.as_slice() {
        [(i, _), (j, share)] => match (all.get(*i), all.get(*j)) {
            (Some(a), Some(b)) => turned(a, b, *share),
            _ => Err(Message::error("Internal error: no such plane")),
        },
        [(i, _)] => all.get(*i).copied().ok_or_else(|| Message::error("Internal error: no such plane")),
        _ => Err(Message::warning("There is nothing to blend")),
    }
}

/// Turns axes of a plane round. With two axes it turns half round the third; all three, or one, would make it left-handed, so z
/// follows. Stands for Pufferfish's Flip Plane; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3028",
    name = "Flip Plane",
    nick = "FlipPln",
    at = "Pufferfish/Plane"
)]
#[output("Flipped", "F", "The plane.")]
fn flip(
    /// The plane.
    #[port("Plane", "Pl")]
    plane: Plane,
    /// Whether x is turned round.
    #[port("X Axis", "X", default = false)]
    x: bool,
    /// Whether y is turned round.
    #[port("Y Axis", "Y", default = false)]
    y: bool,
    /// Whether z is turned round: x and y change places where neither is turned.
    #[port("Z Axis", "Z", default = true)]
    z: bool,
) -> Result<Plane, Message> {
    if z && !x && !y {
        return Ok(plane.flipped());
    }
    let sign = |turn: bool| if turn { -1.0 } else { 1.0 };
    Ok(Plane::from_axes(plane.origin, plane.x_axis * sign(x), plane.y_axis * sign(y))?)
}

/// Moves a plane along its axes. Stands for Pufferfish's Offset Plane; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3029",
    name = "Offset Plane",
    nick = "OffPln",
    at = "Pufferfish/Plane"
)]
#[output("Offset", "O", "The plane.")]
fn offset(
    /// The plane.
    #[port("Plane", "Pl")]
    plane: Plane,
    /// The distance, in units.
    #[port("Distance", "D", default = 1.0)]
    distance: f64,
    /// The axis: 0 is z, 1 is y, 2 is x.
    #[port("Axis", "A", default = 0)]
    axis: i32,
) -> Plane {
    let along = match axis {
        0 => plane.z_axis,
        1 => plane.y_axis,
        _ => plane.x_axis,
    };
    plane.with_origin(plane.origin + along * distance)
}
