//! Surface / Freeform: sections swept along rails, and curves turned along one.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, Line, construct};

use super::warning;

fn sections(curves: &List<'_, Shared<Curve>>) -> Result<Vec<Curve>, Message> {
    let sections: Vec<Curve> = curves.present().map(|curve| (*curve).clone()).collect();
    if sections.is_empty() { Err(Message::warning("A sweep needs a section")) } else { Ok(sections) }
}

/// The surface that sections draw on their way along a rail.
///
/// Each section belongs to the place of the rail nearest to its start; between two the shape goes over from one to
/// the other. Sections turn about the rail as little as possible.
#[component("bb6666e7-d0f4-41ec-a257-df2371619f13", name = "Sweep1", nick = "Swp1", at = "Surface/Freeform")]
#[output("Brep", "S", "The swept faces, joined.", kind = Brep)]
fn sweep1(
    context: &Context<'_>,
    /// The curve along which sections are moved.
    #[port("Rail", "R")]
    rail: &Curve,
    /// The sections.
    #[port("Sections", "S")]
    curves: List<Shared<Curve>>,
    /// What becomes of sections at kinks of the rail: 0 nothing, 1 they are cut half-way between both directions, 2
    /// they are turned there.
    #[port("Miter", "M", default = 1)]
    miter: i32,
) -> Result<Vec<Value>, Message> {
    let miter = match miter {
        0 => construct::Miter::None,
        1 => construct::Miter::Trim,
        2 => construct::Miter::Rotate,
        other => {
            return Err(Message::error(format!(
                "There is no mitre of type {other}: 0 none, 1 trim, 2 rotate"
            )));
        }
    };
    let options = construct::SweepOptions { miter, ..construct::SweepOptions::default() };
    let made =
        construct::sweep_one(rail, &sections(&curves)?, &options, &context.tolerance()).map_err(warning)?;
    Ok(made.into_iter().map(Value::from).collect())
}

/// The surface that sections draw on their way along two rails, whose distance is their width.
#[component("75164624-395a-4d24-b60b-6bf91cab0194", name = "Sweep2", nick = "Swp2", at = "Surface/Freeform")]
#[output("Brep", "S", "The swept faces, joined.", kind = Brep)]
fn sweep2(
    context: &Context<'_>,
    /// The first curve along which sections are moved.
    #[port("Rail 1", "R¹")]
    first: &Curve,
    /// The second one.
    #[port("Rail 2", "R²")]
    second: &Curve,
    /// The sections.
    #[port("Sections", "S")]
    curves: List<Shared<Curve>>,
    /// Whether sections keep their height; else it is scaled as their width.
    #[port("Same Height", "H", default = false)]
    same_height: bool,
) -> Result<Vec<Value>, Message> {
    let sections = sections(&curves)?;
    let made = construct::sweep_two([first, second], &sections, same_height, &context.tolerance());
    Ok(made.map_err(warning)?.into_iter().map(Value::from).collect())
}

/// A curve turned about an axis so that it follows a rail.
///
/// It is turned towards each place of the rail and scaled away from the axis as the rail's distance goes.
#[component(
    "d8d68c35-f869-486d-adf3-69ee3cc2d501",
    name = "Rail Revolution",
    nick = "RailRev",
    at = "Surface/Freeform"
)]
#[output("Surface", "S", "The surface: u runs along the rail, v along the curve.", kind = Brep)]
fn rail_revolution(
    context: &Context<'_>,
    /// The profile.
    #[port("Curve", "P")]
    profile: &Curve,
    /// The curve that it follows.
    #[port("Rail", "R")]
    rail: &Curve,
    /// The axis.
    #[port("Axis", "A")]
    axis: Line,
    /// Whether heights along the axis are scaled as the rail's height goes; else they stay.
    #[port("Scale", "S", default = false)]
    scale: bool,
) -> Result<Value, Message> {
    let made = construct::rail_revolve(profile, rail, axis, scale, &context.tolerance());
    Ok(Value::from(made.map_err(warning)?))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3, PolylineCurve};

    use crate::surface::trial::{breps, mesh_area};

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    #[test]
    fn along_one_rail() {
        let rail = Line::new(p(0.0, 0.0, 0.0), p(0.0, 0.0, 4.0));
        let ring = Circle { plane: Plane::XY, radius: 1.0 };
        let tube = breps(Trial::of("Sweep1").item(rail).list([ring]));
        assert!((mesh_area(&tube[0]) - 8.0 * PI).abs() < 1e-2);
        let bent: Curve =
            PolylineCurve::new(vec![p(0.0, 0.0, 0.0), p(0.0, 0.0, 4.0), p(4.0, 0.0, 4.0)]).unwrap().into();
        let bent = |miter: i32| breps(Trial::of("Sweep1").item(bent.clone()).list([ring]).item(miter));
        assert_eq!(bent(1).len(), 1);
        assert_eq!(bent(0).len(), 2);
        assert!(bent(1).iter().chain(&bent(2)).all(katydid_geometry::Brep::is_valid));
        assert!(Trial::of("Sweep1").item(rail).list([ring]).item(7).message().contains("type 7"));
        assert!(Trial::of("Sweep1").item(rail).list(Vec::<Circle>::new()).message().contains("section"));
    }

    #[test]
    fn along_two_rails() {
        let rails = [0.0, 2.0].map(|x| Line::new(p(x, 0.0, 0.0), p(x, 5.0, 0.0)));
        let section = Line::new(p(0.0, 0.0, 0.0), p(2.0, 0.0, 0.0));
        let flat = breps(Trial::of("Sweep2").item(rails[0]).item(rails[1]).list([section]));
        assert!((mesh_area(&flat[0]) - 10.0).abs() < 1e-6);
    }

    #[test]
    fn along_a_rail_about_an_axis() {
        let axis = Line::new(p(0.0, 0.0, 0.0), p(0.0, 0.0, 1.0));
        let rail = Circle { plane: Plane::XY, radius: 2.0 };
        let profile = Line::new(p(2.0, 0.0, 0.0), p(2.0, 0.0, 3.0));
        let tube = breps(Trial::of("Rail Revolution").item(profile).item(rail).item(axis));
        assert!((mesh_area(&tube[0]) - 12.0 * PI).abs() < 1e-2);
        let on_axis = Line::new(p(0.0, 0.0, 0.0), p(0.0, 0.0, 3.0));
        assert!(!Trial::of("Rail Revolution").item(profile).item(on_axis).item(axis).message().is_empty());
    }
}
