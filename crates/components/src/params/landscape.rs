//! Params / Util: the landscape of an optimiser.

use std::sync::Arc;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Mesh, Point3, Rectangle};

/// Shows numbers as heights over a rectangle: a grid with so many numbers a row, the first row along the lower side.
///
/// Numbers that fill no whole row are left out. At least two rows of two are wanted; nulls count as 0.
#[component(
    "fe9db51e-1ac6-4298-b9dc-6acf3008c8f2",
    name = "Fitness Landscape",
    nick = "LScape",
    at = "Params/Util"
)]
#[output("Landscape", "L", "The landscape.")]
fn fitness_landscape(
    context: &Context<'_>,
    /// Where the landscape lies.
    #[port("Bounds", "B")]
    bounds: Rectangle,
    /// The heights.
    #[port("Values", "V")]
    values: List<f64>,
    /// How many heights make a row.
    #[port("Count", "N")]
    count: i32,
) -> Result<Arc<Mesh>, Message> {
    let columns = crate::sets::count(count, "Count")?;
    let rows = values.len().checked_div(columns).unwrap_or(0);
    if columns < 2 || rows < 2 {
        return Err(Message::error("A landscape needs at least two rows of two numbers"));
    }
    context.bytes(values.len().saturating_mul(128))?;
    let flat = Mesh::plane(&bounds, columns - 1, rows - 1)?;
    let normal = bounds.plane.z_axis;
    let heights = values.iter().map(|h| h.filter(|h| h.is_finite()).unwrap_or(0.0));
    let vertices: Vec<Point3> = flat.vertices().iter().zip(heights).map(|(p, h)| *p + normal * h).collect();
    Ok(Arc::new(Mesh::new(vertices, flat.faces().to_vec())?.with_normals()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Interval, Plane, Point3, Rectangle};

    #[test]
    fn numbers_are_heights() {
        let bounds = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 2.0), y: Interval::new(0.0, 1.0) };
        let values = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 9.0];
        let trial = |n: i32| Trial::of("Fitness Landscape").item(bounds).list(values).item(n);
        let Some(Value::Mesh(mesh)) = trial(3).run().outputs[0].column().get(0) else { panic!() };
        assert_eq!(mesh.vertices().len(), 6);
        assert_eq!(mesh.vertices()[5], Point3::new(2.0, 1.0, 5.0));
        assert!(trial(5).message().contains("two rows"));
        assert!(trial(0).message().contains("two rows"));
        assert!(trial(-1).message().contains("negative"));
    }
}
