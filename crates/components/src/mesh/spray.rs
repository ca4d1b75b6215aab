//! Mesh / Primitive: colours sprayed from points.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Colour;
use katydid_geometry::{Mesh, Point3};

use super::shared;

/// Colours the vertices of a mesh from coloured points: each vertex takes all colours, the near ones more, by the
/// square of their distance.
#[component(
    "edcf10e1-02a0-48a4-ae2d-70c50d903dc8",
    name = "Mesh Spray",
    nick = "MSpray",
    at = "Mesh/Primitive"
)]
#[output("Mesh", "M", "The coloured mesh.")]
fn mesh_spray(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
    /// Their colours, repeated in order when there are fewer.
    #[port("Colours", "C")]
    colours: List<Colour>,
) -> Result<Shared<Mesh>, Message> {
    let list: Vec<Colour> = colours.present().collect();
    let points: Vec<Point3> = points.present().collect();
    if list.is_empty() || points.is_empty() {
        return Err(Message::error("Spraying takes at least one point and one colour"));
    }
    let sources: Vec<(Point3, [u8; 4])> =
        points.into_iter().zip(list.iter().cycle()).map(|(p, c)| (p, [c.r, c.g, c.b, c.a])).collect();
    let mut colours = Vec::with_capacity(mesh.vertices().len());
    for vertex in mesh.vertices() {
        context.check()?;
        colours.push(mixed(*vertex, &sources));
    }
    Ok(shared(mesh.with_colours(&colours)))
}

/// The mean of colours weighted by the inverse square of their distance (D. Shepard, *A two-dimensional interpolation
/// function for irregularly-spaced data*, ACM National Conference 1968); at a point its own colour.
fn mixed(at: Point3, sources: &[(Point3, [u8; 4])]) -> [u8; 4] {
    let (mut sum, mut weights) = ([0.0_f64; 4], 0.0_f64);
    for (p, colour) in sources {
        let weight = 1.0 / (*p - at).length_squared();
        if weight.is_infinite() {
            return *colour;
        }
        weights += weight;
        sum.iter_mut().zip(colour).for_each(|(s, &c)| *s += weight * f64::from(c));
    }
    sum.map(|s| (s / weights).round().clamp(0.0, 255.0) as u8)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Colour, Value};
    use katydid_geometry::{Interval, Mesh, Plane, Point3, Rectangle};

    #[test]
    fn near_colours_count_more() {
        let side = Interval::new(0.0, 2.0);
        let sheet = Mesh::plane(&Rectangle { plane: Plane::XY, x: side, y: Interval::UNIT }, 2, 1).unwrap();
        let points = [Point3::ORIGIN, Point3::new(2.0, 0.0, 0.0)];
        let spray = || Trial::of("Mesh Spray").item(sheet.clone());
        let made = spray().list(points).list([Colour::rgb(200, 0, 0), Colour::rgb(0, 0, 100)]).run();
        let Some(Value::Mesh(made)) = made.outputs[0].column().get(0) else { panic!() };
        assert_eq!(made.colours()[0], [200, 0, 0, 255]);
        assert_eq!(made.colours()[1], [100, 0, 50, 255]);
        // Distances 1 and √5: a sixth of the way from the near colour to the far one.
        assert_eq!(made.colours()[3], [167, 0, 17, 255]);
        assert!(spray().list(points).list(Vec::<Colour>::new()).message().contains("at least one"));
    }
}
