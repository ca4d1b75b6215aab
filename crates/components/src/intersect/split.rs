//! Intersect / Physical: surfaces cut along curves.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::{Brep, Curve, Tolerance};

/// The curves that can be pulled to a face.
fn pulled(context: &Context<'_>, brep: &Brep, face: usize, curves: &[Curve]) -> Vec<Curve> {
    let tolerance = context.tolerance();
    let follows = |curve: &Curve| {
        brep.face_surface(face).is_some_and(|surface| surface.parameter_curve(curve, &tolerance).is_ok())
    };
    let kept: Vec<Curve> = curves.iter().filter(|curve| follows(curve)).cloned().collect();
    match curves.len() - kept.len() {
        0 => {}
        1 => context.warn("A curve cannot be pulled to the surface and was left out"),
        n => context.warn(format!("{n} curves cannot be pulled to the surface and were left out")),
    }
    kept
}

/// The pieces of a face. Curves that cannot be followed are told of, and the others cut all the same.
fn pieces(context: &Context<'_>, brep: &Brep, face: usize, curves: &[Curve]) -> Result<Vec<Brep>, Message> {
    let tolerance: Tolerance = context.tolerance();
    let cut = brep.face_split(face, curves, &tolerance).or_else(|_| {
        let kept = pulled(context, brep, face, curves);
        brep.face_split(face, &kept, &tolerance)
    });
    cut.map_err(|error| Message::warning(error.to_string()))
}

/// Cuts a surface along curves that lie on it.
///
/// Curves beside the surface are pulled to it. Where a curve ends inside a piece that it does not cut through, it leaves no
/// trace; a surface that nothing cuts comes back as it is. The pieces keep the whole surface and differ in their trims.
#[component(
    "7db14002-c09c-4d7b-9f80-e4e2b00dfa1d",
    name = "Surface Split",
    nick = "SrfSplit",
    at = "Intersect/Physical"
)]
#[output("Fragments", "F", "The pieces.", kind = Surface)]
fn surface_split(
    context: &Context<'_>,
    /// The surface to cut.
    #[port("Surface", "S")]
    surface: Shared<Brep>,
    /// The curves to cut along, all at once.
    #[port("Curves", "C")]
    curves: List<'_, Shared<Curve>>,
) -> Result<Vec<Value>, Message> {
    let curves: Vec<Curve> = curves.iter().flatten().map(|curve| Curve::clone(&curve)).collect();
    let mut out = Vec::new();
    for face in 0..surface.faces().len() {
        context.check()?;
        let pieces = pieces(context, &surface, face, &curves)?;
        context.items(out.len() + pieces.len())?;
        out.extend(pieces);
    }
    if out.len() <= 1 {
        return Ok(vec![Value::from(surface)]);
    }
    Ok(out.into_iter().map(Value::from).collect())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Circle, Curve, Interval, Line, Plane, PlaneSurface, Point3, Surface};

    fn square() -> Surface {
        let side = Interval::new(-2.0, 2.0);
        PlaneSurface::new(Plane::XY, side, side).unwrap().into()
    }

    fn line(from: [f64; 2], to: [f64; 2]) -> Curve {
        let at = |[x, y]: [f64; 2]| Point3::new(x, y, 0.0);
        Line::new(at(from), at(to)).into()
    }

    #[test]
    fn a_square_falls_into_four() {
        let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
        let made =
            Trial::of("Surface Split").item(square()).list([circle, line([-3.0, -3.0], [3.0, 3.0])]).run();
        let fragments = made.outputs.into_iter().next().unwrap();
        assert_eq!(fragments.item_count(), 4);
        let areas = Trial::of("Area").tree(fragments).texts(0).join(" ");
        assert_eq!(areas.matches("1.570796").count(), 2, "{areas}");
        assert_eq!(areas.matches("6.429204").count(), 2, "{areas}");
    }

    #[test]
    fn what_does_not_cut_through_leaves_the_surface() {
        let made = Trial::of("Surface Split").item(square()).list([line([-3.0, 0.0], [1.0, 0.0])]).run();
        assert_eq!(made.outputs[0].item_count(), 1);
        assert!(made.messages.is_empty(), "{:?}", made.messages);
    }
}
