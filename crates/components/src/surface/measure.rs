//! Surface / Analysis: areas and volumes.

use katydid_component::{Context, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_geometry::Point3;

/// The area of a surface, a mesh, a box, or the region inside a closed flat curve.
///
/// A curve that is open or not flat has none: a warning.
#[component(
    "2e205f24-9279-47b2-b414-d06dcd0b21a7",
    name = "Area",
    nick = "Area",
    at = "Surface/Analysis",
    also("86b28a7e-94d9-4791-8306-e13e10d5f8d5")
)]
#[output("Area", "A", "Its area.")]
#[output("Centroid", "C", "The centroid of the area.")]
fn area(
    context: &Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(Option<f64>, Option<Point3>), Message> {
    match &geometry.0 {
        Value::Mesh(mesh) => {
            let (area, center) = mesh.area_and_centroid();
            Ok((Some(area), center))
        }
        Value::Surface(surface) => {
            let found = surface.area().map_err(|e| Message::warning(e.to_string()))?;
            Ok((Some(found.area), Some(found.centroid)))
        }
        Value::Box(b) => Ok((Some(b.area().abs()), Some(b.center()))),
        Value::Rectangle(r) => Ok((Some(r.area().abs()), Some(r.center()))),
        Value::Circle(c) => Ok((Some(std::f64::consts::PI * c.radius * c.radius), Some(c.center()))),
        Value::Kept(object) => {
            Err(Message::error(format!("The area of a {} cannot be measured yet", object.class_name())))
        }
        other => match cast::value(other, Kind::Curve, context.rules()) {
            Some(Value::Curve(curve)) => {
                let found = curve.area_and_centroid(context.tolerance().absolute);
                let (area, center) = found.map_err(|e| Message::warning(e.to_string()))?;
                Ok((Some(area), Some(center)))
            }
            _ => Err(Message::warning(format!("A {} has no area", other.kind()))),
        },
    }
}

/// The volume inside a closed mesh, a box, a sphere or a torus.
///
/// The volume of an open mesh means nothing: a warning. That of other closed surfaces cannot be measured yet.
#[component(
    "224f7648-5956-4b26-80d9-8d771f3dfd5d",
    name = "Volume",
    nick = "Volume",
    at = "Surface/Analysis",
    also("7c0523e8-79c9-45a2-8777-cf0d46bc5432")
)]
#[output("Volume", "V", "Its volume.")]
#[output("Centroid", "C", "The centroid of the volume.")]
fn volume(
    context: &Context<'_>,
    /// The geometry.
    #[port("Geometry", "G")]
    geometry: Geometry,
) -> Result<(Option<f64>, Option<Point3>), Message> {
    match &geometry.0 {
        Value::Mesh(mesh) => {
            if !mesh.is_closed() {
                context.warn("The mesh is open: its volume means nothing");
            }
            let (volume, center) = mesh.volume_and_centroid();
            Ok((Some(volume.abs()), center))
        }
        Value::Surface(surface) if surface.is_solid() => {
            let tolerance = context.tolerance().absolute;
            if let Some(sphere) = surface.as_sphere(tolerance) {
                Ok((Some(sphere.volume()), Some(sphere.center())))
            } else if let Some(torus) = surface.as_torus(tolerance) {
                Ok((Some(torus.volume()), Some(torus.plane.origin)))
            } else {
                Err(Message::error("The volume of this surface cannot be measured yet"))
            }
        }
        Value::Surface(_) => Err(Message::warning("An open surface has no volume")),
        Value::Box(b) => Ok((Some(b.volume().abs()), Some(b.center()))),
        Value::Kept(object) => {
            Err(Message::error(format!("The volume of a {} cannot be measured yet", object.class_name())))
        }
        other => Err(Message::warning(format!("A {} has no volume", other.kind()))),
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Box3, Circle, Interval, Line, Mesh, Plane, Point3};

    #[test]
    fn areas_and_volumes() {
        let unit = Interval::new(0.0, 2.0);
        let b = Box3 { plane: Plane::XY, x: unit, y: unit, z: unit };
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        let area = |v: katydid_data::Value| Trial::of("Area").item(v).texts(0).join("");
        assert_eq!(area(circle.into()), "{0}: 3.141593");
        assert_eq!(area(b.into()), "{0}: 24");
        assert_eq!(area(Mesh::cuboid(&b, 1, 1, 1).unwrap().into()), "{0}: 24");
        let line = Line::new(Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0));
        assert!(Trial::of("Area").item(line).message().contains("open"));
        let volume = |v: katydid_data::Value| Trial::of("Volume").item(v);
        assert_eq!(volume(Mesh::cuboid(&b, 2, 2, 2).unwrap().into()).texts(0), ["{0}: 8"]);
        assert_eq!(volume(b.into()).texts(1), ["{0}: {1, 1, 1}"]);
        assert!(volume(circle.into()).message().contains("no volume"));
    }
}
