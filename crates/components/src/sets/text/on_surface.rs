//! Sets / Text: letters as solids.

use std::sync::Arc;

use katydid_component::{Context, Message, component};
use katydid_data::{Kind, Value, cast};
use katydid_geometry::lettering::{self, Letter};
use katydid_geometry::{ArcLength, Brep, Curve, Plane, Point3, Vector3, Xform, construct};

use crate::prepared;

/// A text as solid letters that stand along a curve, flat on a surface.
///
/// The text begins at the start of the curve, and its lines run beside each other. Each letter is put where the middle
/// of its foot comes to lie on the curve, flat in the plane that touches the surface there, and reaches out of it along
/// the normal by the depth; without a depth it is a surface. A part of its own, the dot of an i, is a Brep of its own.
/// Letters beyond the end of the curve are left out. The letters are those of DejaVu Sans Condensed, whatever font is
/// asked for.
#[component(
    "28504f1f-a8d9-40c8-b8aa-529413456258",
    name = "Text On Surface",
    nick = "TextSrf",
    at = "Sets/Text"
)]
#[output("Symbols", "S", "The letters, from the first to the last.", kind = Brep)]
fn text_on_surface(
    context: &Context<'_>,
    /// The text.
    #[port("Text", "T")]
    text: Arc<str>,
    /// The name of a font. No font of the machine is used: the letters have one shape everywhere.
    #[port("Font", "F", default = "")]
    font: Arc<str>,
    /// How high a capital letter is, above 0.
    #[port("Height", "H", default = 1.0)]
    height: f64,
    /// How far the letters reach out of the surface; into it when it is negative, and 0 gives surfaces.
    #[port("Depth", "D", default = 0.0)]
    depth: f64,
    /// The curve that the letters stand on.
    #[port("Base Line", "B")]
    line: Arc<Curve>,
    /// A surface, Brep or mesh near the curve; without it the letters lie in the plane of the curve.
    #[port("Base Surface", "S", optional)]
    surface: Option<Value>,
) -> Result<Vec<Value>, Message> {
    if !(height > 0.0 && height.is_finite() && depth.is_finite()) {
        return Err(Message::error("The height must be greater than 0, and the depth finite"));
    }
    let name = font.trim();
    if !name.is_empty() && !name.to_lowercase().starts_with("dejavu sans") {
        context
            .tell(Message::remark(format!("The letters are those of DejaVu Sans Condensed, not of {name}")));
    }
    let carrier = Carrier::new(context, surface.as_ref(), &line)?;
    let tolerance = context.tolerance();
    let scale = height / lettering::capital_height();
    let along = ArcLength::new(&line);
    let (mut made, mut left) = (Vec::new(), 0_usize);
    for (row, words) in text.lines().enumerate() {
        for letter in lettering::letters(words)? {
            context.check()?;
            let middle = scale * (letter.start + 0.5 * letter.advance);
            if letter.outlines.is_empty() {
                continue;
            }
            if middle > along.total() {
                left += 1;
                continue;
            }
            let t = along.parameter_at(middle);
            let tangent =
                line.tangent_at(t).ok_or_else(|| Message::warning("The base line has no direction"))?;
            let frame = carrier.frame(line.point_at(t), tangent)?;
            let frame = frame.with_origin(frame.at(0.0, -LINE * scale * row as f64, 0.0));
            let curves = placed(&letter, &frame, scale)?;
            for face in Brep::planar_faces(&curves, &tolerance)?.breps {
                made.push(Value::from(solid(face, &frame, depth, &tolerance)?));
                context.items(made.len())?;
            }
        }
    }
    if left > 0 {
        context.warn(format!("{left} letters are left out: the base line is too short"));
    }
    Ok(made)
}

/// From line to line, in units of the type's size.
const LINE: f64 = 1.2;

/// The outlines of a letter on a frame in whose origin the middle of its foot lies.
fn placed(letter: &Letter, frame: &Plane, scale: f64) -> Result<Vec<Curve>, Message> {
    let back = Vector3::new(-(letter.start + 0.5 * letter.advance), 0.0, 0.0);
    let own = Plane::XY;
    let xform =
        Xform::plane_to_plane(&own, frame) * Xform::scale(Point3::ORIGIN, scale) * Xform::translation(back);
    let curves = letter.outlines.iter().map(|curve| curve.transformed(&xform));
    Ok(curves.collect::<Result<Vec<_>, _>>()?)
}

/// A face drawn out along the normal of its plane.
fn solid(
    face: Brep,
    frame: &Plane,
    depth: f64,
    tolerance: &katydid_geometry::Tolerance,
) -> Result<Brep, Message> {
    if depth.abs() <= tolerance.absolute {
        return Ok(face);
    }
    Ok(construct::extrude_brep(&face, frame.z_axis * depth, tolerance)?)
}

/// What letters stand on.
struct Carrier<'a> {
    context: &'a Context<'a>,
    shape: Option<Value>,
    /// The normal where there is no shape.
    normal: Vector3,
}

impl<'a> Carrier<'a> {
    fn new(context: &'a Context<'a>, shape: Option<&Value>, line: &Curve) -> Result<Self, Message> {
        let tolerance = context.tolerance().absolute;
        let plane = Some(line).filter(|c| !c.is_linear(tolerance)).and_then(|c| c.plane(tolerance));
        let normal = plane.map_or(Vector3::Z, |plane| plane.z_axis);
        let normal = if normal.z < 0.0 { -normal } else { normal };
        let shape = match shape {
            None => None,
            Some(value @ (Value::Mesh(_) | Value::Surface(_))) => Some(value.clone()),
            Some(value) => match value.brep() {
                Some(brep) => Some(Value::Brep(brep.map_err(Message::warning)?)),
                None => {
                    let mesh = cast::value(value, Kind::Mesh, context.rules());
                    let kind = value.kind().name();
                    Some(mesh.ok_or_else(|| Message::error(format!("No letters stand on a {kind}")))?)
                }
            },
        };
        Ok(Self { context, shape, normal })
    }

    /// The plane of a letter at a point of the base line, x along it.
    fn frame(&self, p: Point3, tangent: Vector3) -> Result<Plane, Message> {
        let normal = self.normal_at(p)?;
        let x = tangent - normal * tangent.dot(normal);
        let along =
            x.unitized().ok_or_else(|| Message::warning("The base line stands upright on the surface"))?;
        Ok(Plane::from_axes(p, along, normal.cross(along))?)
    }

    fn normal_at(&self, p: Point3) -> Result<Vector3, Message> {
        let found = match &self.shape {
            None => Some(self.normal),
            Some(Value::Surface(surface)) => {
                let near = prepared::surface(self.context, surface)?.nearest(p)?;
                surface.normal_at(near.u, near.v)
            }
            Some(Value::Brep(brep)) => prepared::brep(self.context, brep)?.nearest(p)?.normal,
            Some(Value::Mesh(mesh)) => {
                let face = mesh.closest_point(p)?.face;
                mesh.face_normals().get(face).and_then(|n| n.unitized())
            }
            Some(_) => None,
        };
        found.ok_or_else(|| Message::warning("The surface has no normal below a letter"))
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Circle, Line, Plane, Point3};

    fn line(length: f64) -> Line {
        Line::new(Point3::ORIGIN, Point3::new(length, 0.0, 0.0))
    }

    fn trial(text: &str, depth: f64, length: f64) -> Trial {
        Trial::of("Text On Surface").item(text).item("").item(2.0).item(depth).item(line(length))
    }

    #[test]
    fn letters_are_solids_with_holes() {
        let out = trial("Li o", 0.5, 50.0).run();
        assert!(out.messages.is_empty(), "{:?}", out.messages);
        // The dot of the i is a part of its own, the blank nothing.
        assert_eq!(out.outputs[0].item_count(), 4);
        assert!(texts(&out.outputs[0])[0].contains("Closed Brep"), "{:?}", texts(&out.outputs[0]));
        let flat = trial("l", 0.0, 50.0).run().outputs[0].clone();
        let of = |name: &str, tree: katydid_data::Tree| -> f64 {
            let text = Trial::of(name).tree(tree).texts(0).concat();
            text.rsplit(": ").next().unwrap().parse().unwrap()
        };
        let area = of("Area", flat);
        let volume = of("Volume", trial("l", 0.5, 50.0).run().outputs[0].clone());
        assert!((volume - 0.5 * area).abs() < 1e-6 * area, "{volume} {area}");
    }

    #[test]
    fn they_stand_on_what_is_given() {
        let cylinder = Trial::of("Cylinder").item(Circle { plane: Plane::XY, radius: 5.0 }).run();
        let rim = Circle { plane: Plane::XY.offset(0.2), radius: 5.0 };
        let on = Trial::of("Text On Surface").item("HHHH").item("").item(0.4).item(0.1).item(rim);
        let out = on.tree(cylinder.outputs[0].clone()).run();
        assert!(out.messages.is_empty(), "{:?}", out.messages);
        assert_eq!(out.outputs[0].item_count(), 4);
        assert!(trial("long", 0.0, 2.0).message().contains("too short"));
        assert!(trial("x", 0.0, 9.0).item(1.5).message().contains("No letters stand on"));
        let font = Trial::of("Text On Surface").item("x").item("Arial").item(1.0).item(0.0).item(line(9.0));
        assert!(font.message().contains("not of Arial"));
        assert!(
            Trial::of("Text On Surface")
                .item("x")
                .item("")
                .item(0.0)
                .default()
                .item(line(1.0))
                .message()
                .contains("height")
        );
    }
}
