//! Surface / Freeform: faces that planar curves bound.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Brep, Curve};

use super::warning;

/// Planar surfaces bounded by the curves of a list: one for each closed curve.
///
/// A curve that lies wholly inside another one is a hole of it, curves inside holes bound surfaces again. Curves that
/// touch or overlap bound a surface each. Open curves are joined first where their ends meet. What is not planar or does
/// not close is left out with a warning.
#[component(
    "d51e9b65-aa4e-4fd6-976c-cef35d421d05",
    name = "Boundary Surfaces",
    nick = "Boundary",
    at = "Surface/Freeform"
)]
#[output("Surfaces", "S", "The surfaces, trimmed; normals are those of the curves, which run counter-clockwise.", kind = Surface)]
fn boundary_surfaces(
    context: &Context<'_>,
    /// The curves, all together.
    #[port("Edges", "E")]
    edges: List<Shared<Curve>>,
) -> Result<Vec<Option<Value>>, Message> {
    let curves: Vec<Curve> = edges.present().map(|curve| (*curve).clone()).collect();
    if curves.is_empty() {
        return Ok(vec![None]);
    }
    let found = Brep::planar_breps(&curves, &context.tolerance()).map_err(warning)?;
    match found.left.len() {
        0 => {}
        1 => context.warn("A curve is left out: it is not planar, not closed, or encloses nothing"),
        n => context
            .warn(format!("{n} curves are left out: they are not planar, not closed, or enclose nothing")),
    }
    if found.breps.is_empty() {
        return Ok(vec![None]);
    }
    context.items(found.breps.len())?;
    Ok(found.breps.into_iter().map(|brep| Some(Value::from(brep))).collect())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Curve, Interval, Line, Plane, Point3, Rectangle};

    use crate::surface::trial::{breps, mesh_area};

    fn ring(radius: f64, height: f64) -> Curve {
        Circle { plane: Plane::XY.offset(height), radius }.into()
    }

    #[test]
    fn holes_islands_and_planes() {
        let rings = [4.0, 1.0, 3.0, 2.0].map(|r| ring(r, 0.0));
        let made = breps(Trial::of("Boundary Surfaces").list(rings));
        assert_eq!(made.len(), 2);
        let area: f64 = made.iter().map(mesh_area).sum();
        assert!((area - PI * (16.0 - 9.0 + 4.0 - 1.0)).abs() < 1e-3, "{area}");
        let levels = breps(Trial::of("Boundary Surfaces").list([ring(1.0, 0.0), ring(1.0, 1.0)]));
        assert_eq!(levels.len(), 2);
        assert_eq!(Trial::of("Boundary Surfaces").list([ring(1.0, 0.0)]).texts(0), ["{0}: Trimmed Surface"]);
    }

    #[test]
    fn touching_and_overlapping_outlines_bound_a_surface_each() {
        let side = |x: f64, y: f64| Rectangle {
            plane: Plane::XY,
            x: Interval::new(x, x + 1.0),
            y: Interval::new(y, y + 1.0),
        };
        let squares: Vec<Rectangle> = (0..6).map(|k| side(f64::from(k % 3), f64::from(k / 3))).collect();
        let made = breps(Trial::of("Boundary Surfaces").list(squares.clone()));
        assert_eq!(made.len(), 6);
        assert!(made.iter().all(|brep| (mesh_area(brep) - 1.0).abs() < 1e-9));
        let overlapping = breps(Trial::of("Boundary Surfaces").list([side(0.0, 0.0), side(0.5, 0.5)]));
        assert_eq!(overlapping.len(), 2);
        assert_eq!(breps(Trial::of("Boundary Surfaces").list([side(0.0, 0.0), side(0.0, 0.0)])).len(), 2);
        // A corner in a corner touches the sides: it is no hole.
        let large = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 3.0), y: Interval::new(0.0, 3.0) };
        let made = breps(Trial::of("Boundary Surfaces").list([large, side(0.0, 0.0), side(1.5, 1.5)]));
        let area: f64 = made.iter().map(mesh_area).sum();
        assert_eq!(made.len(), 2);
        assert!((area - (9.0 - 1.0 + 1.0)).abs() < 1e-9, "{area}");
    }

    #[test]
    fn open_curves_join_and_others_are_left_out() {
        let side = |a: [f64; 2], b: [f64; 2]| {
            Curve::from(Line::new(Point3::new(a[0], a[1], 0.0), Point3::new(b[0], b[1], 0.0)))
        };
        let triangle =
            || vec![side([0.0, 0.0], [3.0, 0.0]), side([0.0, 4.0], [3.0, 0.0]), side([0.0, 4.0], [0.0, 0.0])];
        let made = breps(Trial::of("Boundary Surfaces").list(triangle()));
        assert_eq!(made.len(), 1);
        assert!((mesh_area(&made[0]) - 6.0).abs() < 1e-9);
        let mut with_stray = triangle();
        with_stray.push(side([10.0, 0.0], [11.0, 1.0]));
        assert!(Trial::of("Boundary Surfaces").list(with_stray).message().contains("left out"));
        let alone = || Trial::of("Boundary Surfaces").list([side([10.0, 0.0], [11.0, 1.0])]);
        assert_eq!(alone().texts(0), ["{0}: null"]);
        assert!(alone().message().contains("left out"));
    }

    #[test]
    fn a_rectangle_is_no_trimmed_surface() {
        let frame = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 2.0), y: Interval::new(0.0, 3.0) };
        assert_eq!(Trial::of("Boundary Surfaces").list([frame]).texts(0), ["{0}: Untrimmed Surface"]);
    }
}
