//! Vector: early grids and clouds, kept for old files.

use std::f64::consts::TAU;

use katydid_component::{Context, Message, component};
use katydid_elementary::Elementary;
use katydid_geometry::{Interval, Plane, Point3, Rectangle, Vector3};

use crate::sets::{count, dotnet_random::DotNetRandom};

/// A grid of squares as flat lists, column by column. An early form of Square.
#[component(
    "99f1e47c-978d-468f-bb3d-a3df44552a8e",
    name = "Grid Rectangular [OBSOLETE]",
    nick = "RecGrid",
    at = "Vector/Point",
    old
)]
#[output("Grid", "G", "The corners.")]
#[output("Cells", "C", "The squares.")]
#[output("Centers", "M", "Their middles.")]
fn early_rectangular_grid(
    context: &Context<'_>,
    /// The plane of the grid; its origin is the first corner.
    #[port("Base plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The number of cells along x, at least 1.
    #[port("X count", "X", default = 10)]
    x: i32,
    /// The number of cells along y, at least 1.
    #[port("Y count", "Y", default = 10)]
    y: i32,
    /// The side of a cell, above 0.
    #[port("Grid Size", "S", default = 1.0)]
    size: f64,
) -> Result<(Vec<Point3>, Vec<Rectangle>, Vec<Point3>), Message> {
    let (nx, ny) = (count(x, "X count")?, count(y, "Y count")?);
    if nx == 0 || ny == 0 || !(size > 0.0 && size.is_finite()) {
        return Err(Message::error("A grid needs at least one cell each way, of a size greater than 0"));
    }
    let total = nx.saturating_add(1).saturating_mul(ny.saturating_add(1));
    context.items(total.saturating_mul(3))?;
    context.bytes(total.saturating_mul(size_of::<Rectangle>()))?;
    let at =
        |i: usize, j: usize, half: f64| plane.at((i as f64 + half) * size, (j as f64 + half) * size, 0.0);
    let places = |nx: usize, ny: usize| (0..nx).flat_map(move |i| (0..ny).map(move |j| (i, j)));
    let side = Interval::new(0.0, size);
    Ok((
        places(nx + 1, ny + 1).map(|(i, j)| at(i, j, 0.0)).collect(),
        places(nx, ny)
            .map(|(i, j)| Rectangle { plane: plane.with_origin(at(i, j, 0.0)), x: side, y: side })
            .collect(),
        places(nx, ny).map(|(i, j)| at(i, j, 0.5)).collect(),
    ))
}

/// Random points on a sphere, everywhere equally likely.
#[component(
    "fd68754e-6c60-44b2-9927-0a58146e0250",
    name = "Spherical Cloud",
    nick = "SphCloud",
    at = "Vector/Grid",
    old
)]
#[output("Cloud", "C", "The points.")]
#[output("Normals", "N", "The direction from the centre to each.")]
fn spherical_cloud(
    context: &Context<'_>,
    /// The centre of the sphere.
    #[port("Center", "C")]
    center: Point3,
    /// Its radius, above 0.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
    /// How many points, 0 or more.
    #[port("Count", "N", default = 100)]
    n: i32,
) -> Result<(Vec<Point3>, Vec<Vector3>), Message> {
    let n = count(n, "Count")?;
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Message::error(format!("Radius is {radius}, which must be greater than 0")));
    }
    context.items(n.saturating_mul(2))?;
    context.bytes(n.saturating_mul(2 * size_of::<Point3>()))?;
    // Slices of equal height have equal area (Archimedes).
    let mut random = DotNetRandom::new(0);
    let mut direction = || {
        let (z, turn) = (2.0 * random.next_double() - 1.0, TAU * random.next_double());
        let r = (1.0 - z * z).max(0.0).sqrt();
        Vector3::new(r * turn.cosine(), r * turn.sine(), z)
    };
    let normals: Vec<Vector3> = (0..n).map(|_| direction()).collect();
    Ok((normals.iter().map(|v| center + *v * radius).collect(), normals))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::Point3;

    #[test]
    fn grids() {
        let out = Trial::of("Grid Rectangular [OBSOLETE]").default().item(2).item(1).item(2.0).run().outputs;
        assert_eq!(out[0].item_count(), 6);
        assert_eq!(texts(&out[2]), ["{0;0}: {1, 1, 0}, {3, 1, 0}"]);
        assert_eq!(texts(&out[1]), ["{0;0}: Rectangle (w=2, h=2), Rectangle (w=2, h=2)"]);
        assert!(
            Trial::of("Grid Rectangular [OBSOLETE]").default().item(0).message().contains("at least one")
        );
    }

    #[test]
    fn clouds_lie_on_their_sphere() {
        let center = Point3::new(1.0, 2.0, 3.0);
        let out = Trial::of("Spherical Cloud").item(center).item(2.0).item(1000).run().outputs;
        let mut above = 0;
        for item in out[0].column().iter() {
            let Some(Value::Point(p)) = item else { panic!() };
            assert!((p.distance_to(center) - 2.0).abs() < 1e-12);
            above += usize::from(p.z > 3.0);
        }
        assert!((450..550).contains(&above), "{above}");
        assert_eq!(out[1].item_count(), 1000);
        assert!(Trial::of("Spherical Cloud").item(center).item(0.0).message().contains("Radius"));
    }
}
