//! Surface / Util: surfaces trimmed as others are.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_geometry::{Brep, Surface};

use super::warning;

/// The only piece, or with a warning the largest of several.
fn largest(context: &Context<'_>, pieces: Vec<Brep>) -> Result<Value, Message> {
    if pieces.len() > 1 {
        context.warn("The trims leave several pieces of the surface: only the largest is given");
    }
    let size = |brep: &Brep| brep.area_properties(1e-3, || true).map_or(0.0, |found| found.amount);
    let best = pieces.into_iter().max_by(|a, b| size(a).total_cmp(&size(b)));
    best.map(Value::from).ok_or_else(|| Message::warning("The trims leave nothing of the surface"))
}

fn one_face(brep: &Brep) -> Result<(), Message> {
    match brep.faces() {
        [_] => Ok(()),
        _ => Err(Message::error("The source has several faces: take it apart")),
    }
}

/// Trims a surface as another one is trimmed, by their parameters: each domain counts from 0 to 1.
#[component("5d192b90-1ae3-4439-bbde-b05976fc4ac3", name = "Copy Trim", nick = "Trim", at = "Surface/Util")]
#[output("Surface", "S", "The target with the trims of the source.", kind = Surface)]
fn copy_trim(
    context: &Context<'_>,
    /// The surface with the trims.
    #[port("Source", "S")]
    source: Shared<Brep>,
    /// The surface to trim; trims of its own do not count.
    #[port("Target", "T")]
    target: &Surface,
) -> Result<Value, Message> {
    one_face(&source)?;
    largest(context, source.copied_trims(0, target, &context.tolerance()).map_err(warning)?)
}

/// Trims a surface along the edges of another one, which are pulled to it.
#[component("a1da39b7-6387-4522-bf2b-2eaee6b14072", name = "Retrim", nick = "Retrim", at = "Surface/Util")]
#[output("Surface", "S", "The target with the trims.", kind = Surface)]
fn retrim(
    context: &Context<'_>,
    /// The surface with the edges.
    #[port("Source", "S")]
    source: Shared<Brep>,
    /// The surface to trim; trims of its own do not count.
    #[port("Target", "T")]
    target: &Surface,
) -> Result<Value, Message> {
    one_face(&source)?;
    largest(context, source.retrimmed(0, target, &context.tolerance()).map_err(warning)?)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Brep, Circle, Interval, Plane, PlaneSurface, Surface, Tolerance};

    fn ring(height: f64) -> Value {
        let round = |r: f64| Circle { plane: Plane::XY.offset(height), radius: r }.into();
        Brep::planar_faces(&[round(2.0), round(1.0)], &Tolerance::default())
            .unwrap()
            .breps
            .swap_remove(0)
            .into()
    }

    #[test]
    fn trims_travel() {
        let wide = Interval::new(-4.0, 4.0);
        let target: Surface = PlaneSurface::new(Plane::XY, wide, wide).unwrap().into();
        let area = |trial: Trial| {
            let made = trial.run().outputs.swap_remove(0);
            Trial::of("Area").tree(made).texts(0).join("")
        };
        // The ring's domains run from −2 to 2: on the target all is twice as large.
        let copied = Trial::of("Copy Trim").item(ring(3.0)).item(target.clone());
        assert_eq!(area(copied), format!("{{0}}: {:.6}", 12.0 * std::f64::consts::PI));
        let pulled = Trial::of("Retrim").item(ring(3.0)).item(target);
        let found: f64 = area(pulled).trim_start_matches("{0}: ").parse().unwrap();
        assert!((found - 3.0 * std::f64::consts::PI).abs() < 0.02, "{found}");
        let uv = |x: f64| katydid_geometry::Point3::new(x, 0.0, 0.0);
        let inside = |x: f64| Trial::of("Point In Trim").item(ring(0.0)).item(uv(x)).texts(0).join("");
        assert_eq!([inside(0.5), inside(1.5)], ["{0}: False", "{0}: True"]);
        let isos = Trial::of("Iso Curve").item(ring(0.0)).item(uv(0.0)).run().outputs;
        assert_eq!(isos[0].item_count(), 2);
    }
}
