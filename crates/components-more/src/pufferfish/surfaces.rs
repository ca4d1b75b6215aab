//! Surfaces: domains, directions, offsets and what they are.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::construct::offset_surface;
use katydid_geometry::{Brep, Direction, Interval, Side, Surface};

/// A surface over 0 to 1 in both directions. Stands for Pufferfish's Reparameterize Surface; trims are left out.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f306a",
    name = "Reparameterize Surface",
    nick = "ReparamSrf",
    at = "Pufferfish/Surface"
)]
#[output("Reparameterized", "R", "The surface.")]
fn reparameterize(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
) -> Result<Shared<Surface>, Message> {
    let half = surface.with_domain(Direction::U, Interval::UNIT)?;
    Ok(Shared::new(half.with_domain(Direction::V, Interval::UNIT)?))
}

/// A surface whose directions change places, or are turned round. Stands for Pufferfish's Swap Surface Directions; the ports are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f306b",
    name = "Swap Surface Directions",
    nick = "SwapSrfDir",
    at = "Pufferfish/Surface"
)]
#[output("Swapped", "S", "The surface.")]
fn swap(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// Whether u and v change places.
    #[port("Swap UV", "UV", default = true)]
    swap: bool,
    /// Whether u is turned round.
    #[port("Reverse U", "U", default = false)]
    u: bool,
    /// Whether v is turned round.
    #[port("Reverse V", "V", default = false)]
    v: bool,
) -> Shared<Surface> {
    let mut turned = if swap { surface.transposed() } else { surface.clone() };
    if u {
        turned = turned.reversed(Direction::U);
    }
    if v {
        turned = turned.reversed(Direction::V);
    }
    Shared::new(turned)
}

/// The degrees of a surface. Stands for Pufferfish's Surface Degree.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f306c",
    name = "Surface Degree",
    nick = "SrfDeg",
    at = "Pufferfish/Surface"
)]
#[output("Degree U", "U", "The degree along u.")]
#[output("Degree V", "V", "The degree along v.")]
fn degree(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
) -> Result<(i32, i32), Message> {
    let [u, v] = surface.to_nurbs()?.degrees().map(|d| i32::try_from(d).unwrap_or(i32::MAX));
    Ok((u, v))
}

/// Whether a surface is closed, and in which directions. Stands for Pufferfish's Is Surface Closed; the outputs are our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f306d",
    name = "Is Surface Closed",
    nick = "SrfClsd",
    at = "Pufferfish/Surface"
)]
#[output("Closed", "C", "Whether it is closed in some direction.")]
#[output("Closed U", "U", "Whether it is along u.")]
#[output("Closed V", "V", "Whether it is along v.")]
fn is_closed(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
) -> (bool, bool, bool) {
    let (u, v) = (surface.is_closed(Direction::U), surface.is_closed(Direction::V));
    (u || v, u, v)
}

/// Whether an edge of a surface is a point. Stands for Pufferfish's Is Surface Collapsed.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f306e",
    name = "Is Surface Collapsed",
    nick = "SrfCollapsed",
    at = "Pufferfish/Surface"
)]
#[output("Collapsed", "C", "Whether one is.")]
fn is_collapsed(
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
) -> bool {
    [Side::South, Side::East, Side::North, Side::West].into_iter().any(|side| surface.is_singular(side))
}

/// Whether the faces of a polysurface close it. Stands for Pufferfish's Is Polysurface Closed.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f306f",
    name = "Is Polysurface Closed",
    nick = "PsrfClsd",
    at = "Pufferfish/Surface"
)]
#[output("Closed", "C", "Whether they do.")]
fn is_solid(
    /// The polysurface.
    #[port("Polysurface", "P")]
    brep: Shared<Brep>,
) -> bool {
    brep.is_solid()
}

/// Offsets a surface, to one side or both. Stands for Pufferfish's Offset Surface; solids are not supported, and trims are left out.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f3070",
    name = "Offset Surface",
    nick = "OffSrf",
    at = "Pufferfish/Surface"
)]
#[output("Offset", "O", "The offsets.")]
fn offset(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: &Surface,
    /// The distance, in units.
    #[port("Distance", "D", default = 1.0)]
    distance: f64,
    /// A second distance, of the other sign for the other side.
    #[port("Both Sides", "B", optional)]
    other: Option<f64>,
    /// Whether a solid is made, which is not supported.
    #[port("Create Solid", "C", default = false)]
    solid: bool,
) -> Result<Vec<Shared<Surface>>, Message> {
    if solid {
        context.warn("Solids between offsets are not supported: the offsets are surfaces");
    }
    let of = |distance: f64| offset_surface(surface, distance, &context.tolerance()).map(Shared::new);
    let mut surfaces = vec![of(distance)?];
    if let Some(other) = other.filter(|d| *d != 0.0) {
        surfaces.push(of(other)?);
    }
    Ok(surfaces)
}
