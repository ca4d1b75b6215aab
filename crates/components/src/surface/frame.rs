//! Surface / Freeform: surfaces inside a frame of curves.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, construct};

use super::warning;

/// A surface whose sides are two, three or four curves.
///
/// The curves may come in any order and direction; between three and four the surface is the Coons patch, between two
/// it is ruled.
#[component(
    "36132830-e2ef-4476-8ea1-6a43922344f0",
    name = "Edge Surface",
    nick = "EdgeSrf",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface.", kind = Brep)]
fn edge_surface(
    context: &Context<'_>,
    /// The first side.
    #[port("Curve A", "A")]
    a: &Curve,
    /// The second side.
    #[port("Curve B", "B")]
    b: &Curve,
    /// The third side; without it and the fourth the surface is ruled.
    #[port("Curve C", "C")]
    c: Option<Shared<Curve>>,
    /// The fourth side; without it the surface has three.
    #[port("Curve D", "D")]
    d: Option<Shared<Curve>>,
) -> Result<Value, Message> {
    let mut sides = vec![a.clone(), b.clone()];
    sides.extend([c, d].into_iter().flatten().map(|side| (*side).clone()));
    Ok(Value::from(construct::edge_surface(&sides, &context.tolerance()).map_err(warning)?))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Line, Point3};

    use crate::surface::trial::{breps, mesh_area};

    #[test]
    fn frames_of_lines() {
        let p = |x: f64, y: f64| Point3::new(x, y, 0.0);
        let sides = [
            Line::new(p(0.0, 0.0), p(4.0, 0.0)),
            Line::new(p(0.0, 3.0), p(4.0, 3.0)),
            Line::new(p(4.0, 3.0), p(4.0, 0.0)),
            Line::new(p(0.0, 0.0), p(0.0, 3.0)),
        ];
        let quad = Trial::of("Edge Surface").item(sides[0]).item(sides[1]).item(sides[2]).item(sides[3]);
        assert!((mesh_area(&breps(quad)[0]) - 12.0).abs() < 1e-9);
        let ruled = Trial::of("Edge Surface").item(sides[0]).item(sides[1]);
        assert!((mesh_area(&breps(ruled)[0]) - 12.0).abs() < 1e-9);
        let third = Line::new(p(4.0, 0.0), p(0.0, 3.0));
        let triangle = Trial::of("Edge Surface").item(sides[0]).item(third).item(sides[3]);
        assert!((mesh_area(&breps(triangle)[0]) - 6.0).abs() < 1e-9);
        let apart = Trial::of("Edge Surface").item(sides[0]).item(sides[1]).item(sides[2]);
        assert!(apart.message().contains("end to end"));
    }
}
