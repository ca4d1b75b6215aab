//! Surface / Freeform: pipes.

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Curve, construct};

use super::warning;

/// How a number stands for what closes the ends.
fn caps(number: i32) -> Result<construct::PipeCap, Message> {
    match number {
        0 => Ok(construct::PipeCap::None),
        1 => Ok(construct::PipeCap::Flat),
        2 => Ok(construct::PipeCap::Round),
        other => Err(Message::error(format!("There are no caps of type {other}: 0 none, 1 flat, 2 round"))),
    }
}

/// A pipe of one radius around a curve.
///
/// Around lines and arcs it is exact, along other curves within the tolerance. At kinks its parts meet in the plane
/// half-way between both directions. A closed curve has no ends to cap.
#[component(
    "c277f778-6fdf-4890-8f78-347efb23c406",
    name = "Pipe",
    nick = "Pipe",
    at = "Surface/Freeform",
    also("e58817d1-11f9-44e5-b204-322cf3cbc118")
)]
#[output("Pipe", "P", "The pipe.", kind = Brep)]
fn pipe(
    context: &Context<'_>,
    /// The curve in its middle.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Its radius.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
    /// What closes its ends: 0 nothing, 1 discs, 2 hemispheres.
    #[port("Caps", "E", default = 0)]
    ends: i32,
) -> Result<Vec<Value>, Message> {
    let made = construct::pipe(curve, radius, caps(ends)?, &context.tolerance()).map_err(warning)?;
    Ok(vec![Value::from(made)])
}

/// A pipe around a curve whose radius changes.
///
/// The radius goes over smoothly from one of the given places to the next; before the first and after the last it
/// stays. With fewer radii than parameters the last one is used again. A radius of 0 gives a tip; between the ends it
/// leaves two pipes that touch there. A negative radius is an error.
#[component(
    "888f9c3c-f1e1-4344-94b0-5ee6a45aee11",
    name = "Pipe Variable",
    nick = "VPipe",
    at = "Surface/Freeform"
)]
#[output("Pipe", "P", "The pipe.", kind = Brep)]
fn pipe_variable(
    context: &Context<'_>,
    /// The curve in its middle.
    #[port("Curve", "C")]
    curve: &Curve,
    /// Parameters of the curve at which a radius is given.
    #[port("Parameters", "t")]
    parameters: List<f64>,
    /// The radii there, 0 or more.
    #[port("Radii", "R")]
    radii: List<f64>,
    /// What closes its ends: 0 nothing, 1 discs, 2 hemispheres.
    #[port("Caps", "E", default = 0)]
    ends: i32,
) -> Result<Vec<Value>, Message> {
    let (places, radii): (Vec<f64>, Vec<f64>) = (parameters.present().collect(), radii.present().collect());
    let Some(last) = radii.last() else { return Err(Message::warning("A pipe needs a radius")) };
    let given: Vec<(f64, f64)> =
        places.iter().enumerate().map(|(k, t)| (*t, *radii.get(k).unwrap_or(last))).collect();
    let made = construct::pipe_variable(curve, &given, caps(ends)?, &context.tolerance()).map_err(warning)?;
    Ok(vec![Value::from(made)])
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Curve, Line, Plane, Point3, PolylineCurve};

    use crate::surface::trial::{breps, mesh_volume};

    fn line() -> Line {
        Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 5.0))
    }

    #[test]
    fn volumes_of_pipes() {
        let flat = breps(Trial::of("Pipe").item(line()).item(2.0).item(1));
        assert!(flat[0].is_solid() && flat[0].is_valid());
        assert!((mesh_volume(&flat[0]) - 20.0 * PI).abs() < 1e-2);
        let round = breps(Trial::of("Pipe").item(line()).item(2.0).item(2));
        assert!((mesh_volume(&round[0]) - (20.0 + 32.0 / 3.0) * PI).abs() < 2e-2);
        let ring = breps(Trial::of("Pipe").item(Circle { plane: Plane::XY, radius: 5.0 }).item(1.0).item(0));
        assert!(ring[0].is_solid());
        assert!((mesh_volume(&ring[0]) - 10.0 * PI * PI).abs() < 2e-2);
        let bent = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 3.0, 0.0]].map(Point3::from);
        let bent: Curve = PolylineCurve::new(bent.to_vec()).unwrap().into();
        let bent = breps(Trial::of("Pipe").item(bent).item(0.5).item(1));
        // Mitred at right angles: what one side lacks the other has.
        assert!((mesh_volume(&bent[0]) - 0.25 * PI * 7.0).abs() < 1e-2);
        assert!(bent[0].is_solid() && bent[0].is_valid());
    }

    #[test]
    fn radii_that_are_none() {
        for radius in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(!Trial::of("Pipe").item(line()).item(radius).message().is_empty());
        }
        assert!(Trial::of("Pipe").item(line()).item(1.0).item(3).message().contains("type 3"));
        let spool = breps(Trial::of("Pipe Variable").item(line()).list([0.0, 1.0]).list([1.0, 2.0]).item(1));
        assert!(spool[0].is_solid() && spool[0].is_valid());
        let needle = breps(Trial::of("Pipe Variable").item(line()).list([0.0, 5.0]).list([0.0, 1.0]).item(1));
        assert!(needle[0].is_solid() && needle[0].is_valid() && needle[0].faces().len() == 2);
        assert!(
            !Trial::of("Pipe Variable").item(line()).list([0.0, 0.0]).list([1.0, 2.0]).message().is_empty()
        );
    }
}
