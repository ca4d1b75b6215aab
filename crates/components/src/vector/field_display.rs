//! Vector / Field: sections through fields, as coloured meshes.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::Colour;
use katydid_elementary::Elementary;
use katydid_geometry::{Field, Mesh, Plane, Rectangle, Vector3};

use crate::display::of_hue;

/// A mesh over a rectangle of about so many vertices, nearly square cells, coloured by the force at each.
fn section(
    context: &Context<'_>,
    field: &Field,
    rectangle: &Rectangle,
    samples: i32,
    colour: impl Fn(&[Vector3]) -> Vec<Colour>,
) -> Result<Arc<Mesh>, Message> {
    if samples < 4 {
        return Err(Message::error(format!("Samples is {samples}, which must be at least 4")));
    }
    context.bytes(usize::try_from(samples).unwrap_or(0).saturating_mul(128))?;
    let (width, height) = (rectangle.x.length().abs(), rectangle.y.length().abs());
    if !(width > 0.0 && height > 0.0) {
        return Err(Message::error("The section has no area"));
    }
    let samples = f64::from(samples);
    let along = (samples * width / height).sqrt().clamp(2.0, samples / 2.0).round();
    let cells = |n: f64| (n.max(2.0) - 1.0) as usize;
    let mesh = Mesh::plane(rectangle, cells(along), cells((samples / along).round()))?;
    let mut forces = Vec::with_capacity(mesh.vertices().len());
    for (i, p) in mesh.vertices().iter().enumerate() {
        if i % 1024 == 1023 {
            context.check()?;
        }
        forces.push(field.at(*p));
    }
    let colours: Vec<[u8; 4]> = colour(&forces).iter().map(|c| [c.r, c.g, c.b, c.a]).collect();
    Ok(Arc::new(mesh.with_colours(&colours)))
}

/// The largest of some numbers; 1 when all are 0.
fn scale(sizes: impl Iterator<Item = f64>) -> f64 {
    let largest = sizes.fold(0.0, f64::max);
    if largest > 0.0 { largest } else { 1.0 }
}

fn from_hue(hue: f64) -> Colour {
    let [r, g, b] = of_hue(hue).map(|x| (x * 255.0).round() as u8);
    Colour::rgb(r, g, b)
}

fn blend(a: Colour, b: Colour, t: f64) -> Colour {
    let mix = |a: u8, b: u8| (f64::from(a) * (1.0 - t) + f64::from(b) * t).round().clamp(0.0, 255.0) as u8;
    Colour { a: mix(a.a, b.a), r: mix(a.r, b.r), g: mix(a.g, b.g), b: mix(a.b, b.b) }
}

/// The strength of a field over a section, as colours from blue where there is no force over green to red where it is
/// strongest.
#[component(
    "55f9ce6a-490c-4f25-a536-a3d47b794752",
    name = "Scalar Display",
    nick = "FScalar",
    at = "Vector/Field"
)]
#[output("Display", "D", "A mesh over the section with a colour at each vertex.")]
fn scalar_display(
    context: &Context<'_>,
    /// The field.
    #[port("Field", "F")]
    field: &Field,
    /// Where to look.
    #[port("Section", "S")]
    section_: Rectangle,
    /// About how many vertices the mesh has, at least 4.
    #[port("Samples", "N", default = 100)]
    samples: i32,
) -> Result<Arc<Mesh>, Message> {
    section(context, field, &section_, samples, |forces| {
        let most = scale(forces.iter().map(|f| f.length()));
        forces.iter().map(|f| from_hue((1.0 - f.length() / most) * 2.0 / 3.0)).collect()
    })
}

/// The direction of a field over a section, as hues round the circle from red along the section's x axis. Where there
/// is no force along the section it is grey.
#[component(
    "5ba20fab-6d71-48ea-a98f-cb034db6bbdc",
    name = "Direction Display",
    nick = "FDir",
    at = "Vector/Field"
)]
#[output("Display", "D", "A mesh over the section with a colour at each vertex.")]
fn direction_display(
    context: &Context<'_>,
    /// The field.
    #[port("Field", "F")]
    field: &Field,
    /// Where to look.
    #[port("Section", "S")]
    section_: Rectangle,
    /// About how many vertices the mesh has, at least 4.
    #[port("Samples", "N", default = 100)]
    samples: i32,
) -> Result<Arc<Mesh>, Message> {
    let Plane { x_axis, y_axis, .. } = section_.plane;
    section(context, field, &section_, samples, |forces| {
        let hue = |f: &Vector3| {
            let (x, y) = (f.dot(x_axis), f.dot(y_axis));
            if x == 0.0 && y == 0.0 {
                Colour::rgb(128, 128, 128)
            } else {
                from_hue(y.arctangent_of(x) / std::f64::consts::TAU)
            }
        };
        forces.iter().map(hue).collect()
    })
}

/// The part of a field that goes through a section, as colours: white where nothing does, one colour for forces along
/// the section's normal and one for those against it.
#[component(
    "bf106e4c-68f4-476f-b05b-9c15fb50e078",
    name = "Perpendicular Display",
    nick = "FPerp",
    at = "Vector/Field"
)]
#[output("Display", "D", "A mesh over the section with a colour at each vertex.")]
fn perpendicular_display(
    context: &Context<'_>,
    /// The field.
    #[port("Field", "F")]
    field: &Field,
    /// Where to look.
    #[port("Section", "S")]
    section_: Rectangle,
    /// About how many vertices the mesh has, at least 4.
    #[port("Samples", "N", default = 100)]
    samples: i32,
    /// The colour of the strongest force along the normal.
    #[port("Positive Colour", "C+", default = Colour::rgb(255, 0, 0))]
    positive: Colour,
    /// The colour of the strongest force against it.
    #[port("Negative Colour", "C-", default = Colour::rgb(0, 0, 255))]
    negative: Colour,
) -> Result<Arc<Mesh>, Message> {
    let normal = section_.plane.z_axis;
    section(context, field, &section_, samples, |forces| {
        let most = scale(forces.iter().map(|f| f.dot(normal).abs()));
        let white = Colour::rgb(255, 255, 255);
        let colour = |f: &Vector3| {
            let through = f.dot(normal) / most;
            blend(white, if through < 0.0 { negative } else { positive }, through.abs())
        };
        forces.iter().map(colour).collect()
    })
}

/// Draws the forces of a field over a section as arrows.
#[component(
    "08619b6d-f9c4-4cb2-adcd-90959f08dc0d",
    name = "Tensor Display",
    nick = "FTensor",
    at = "Vector/Field"
)]
fn tensor_display(
    /// The field.
    #[port("Field", "F")]
    _field: &Field,
    /// Where to look.
    #[port("Section", "S")]
    _section: Rectangle,
    /// About how many arrows to draw.
    #[port("Samples", "N", default = 1000)]
    _samples: i32,
) {
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Colour, Tree, Value};
    use katydid_geometry::{Interval, Line, Mesh, Plane, Point3, Rectangle, Vector3};

    fn square() -> Rectangle {
        let side = Interval::new(-1.0, 1.0);
        Rectangle { plane: Plane::XY, x: side, y: side }
    }

    fn wind(v: Vector3) -> Tree {
        let line = Line::new(Point3::ORIGIN, v.to_point());
        Trial::of("Vector Force").item(line).run().outputs[0].clone()
    }

    fn mesh(name: &str, field: Tree) -> Mesh {
        match Trial::of(name).tree(field).item(square()).item(25).run().outputs[0].column().get(0) {
            Some(Value::Mesh(mesh)) => (*mesh).clone(),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn sections_are_coloured() {
        let along = mesh("Direction Display", wind(Vector3::Y));
        assert_eq!(along.vertices().len(), 25);
        // A quarter turn from red: between yellow and green.
        assert!(along.colours().iter().all(|c| *c == [128, 255, 0, 255]));
        let through = mesh("Perpendicular Display", wind(-Vector3::Z));
        assert!(through.colours().iter().all(|c| *c == [0, 0, 255, 255]));
        let flat = mesh("Perpendicular Display", wind(Vector3::X));
        assert!(flat.colours().iter().all(|c| *c == [255, 255, 255, 255]));
        let charge = Trial::of("Point Charge").item(Point3::new(-1.0, -1.0, 0.5)).run().outputs[0].clone();
        let strength = mesh("Scalar Display", charge.clone());
        assert_eq!(strength.colours()[0], [255, 0, 0, 255]);
        let last = strength.colours()[24];
        assert!(last[2] == 255 && last[0] == 0, "{last:?}");
        assert!(Trial::of("Tensor Display").tree(charge).item(square()).run().outputs.is_empty());
        let few = Trial::of("Scalar Display").tree(wind(Vector3::X)).item(square()).item(1);
        assert!(few.message().contains("at least 4"));
        assert_eq!(
            super::blend(Colour::rgb(0, 0, 0), Colour::rgb(200, 100, 0), 0.5),
            Colour::rgb(100, 50, 0)
        );
    }
}
