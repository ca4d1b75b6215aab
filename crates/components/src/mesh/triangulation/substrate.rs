//! Cracks that grow until they meet another.

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Line, Rectangle, substrate::substrate as grow};

use crate::sets::dotnet_random::DotNetRandom;

/// Lines that grow in a rectangle like cracks or streets: each starts on an earlier one, about at a right angle, and
/// ends where it meets another. The same seed gives the same lines.
#[component(
    "415750fd-c0ec-4411-84d0-01f28ab23066",
    name = "Substrate",
    nick = "Substrate",
    at = "Mesh/Triangulation"
)]
#[output("Substrate", "S", "The lines, in the order they grew; fewer than asked for when no room is left.")]
fn substrate(
    context: &Context<'_>,
    /// The rectangle.
    #[port("Border", "B")]
    border: Rectangle,
    /// The number of lines, not negative.
    #[port("Count", "N")]
    count: i32,
    /// The directions of the first lines, in radians from the rectangle's x axis.
    #[port("Angles", "A")]
    angles: List<f64>,
    /// How far later lines may be off a right angle, in radians.
    #[port("Deviation", "D")]
    deviation: f64,
    /// Any whole number; another one gives other lines.
    #[port("Seed", "S")]
    seed: i32,
) -> Result<Vec<Line>, Message> {
    let count = usize::try_from(count).map_err(|_| Message::error("The count must not be negative"))?;
    context.items(count)?;
    let angles: Vec<f64> = angles.present().collect();
    let mut random = DotNetRandom::new(seed);
    let lines = grow([border.x, border.y], count, &angles, deviation, || random.next_double())?;
    context.check()?;
    let at = |p: katydid_geometry::Point2| border.plane.at(p.x, p.y, 0.0);
    Ok(lines.into_iter().map(|[a, b]| Line::new(at(a), at(b))).collect())
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Interval, Plane, Rectangle};

    #[test]
    fn lines_grow_the_same_from_the_same_seed() {
        let square = Rectangle { plane: Plane::XZ, x: Interval::new(0.0, 5.0), y: Interval::new(1.0, 3.0) };
        let trial = |count: i32, seed: i32| {
            Trial::of("Substrate").item(square).item(count).list([0.0, 1.0]).item(0.1).item(seed)
        };
        let lines = trial(60, 3).run().outputs[0].clone();
        assert_eq!(lines.item_count(), 60);
        assert_eq!(trial(60, 3).texts(0), trial(60, 3).texts(0));
        assert_eq!(trial(60, 3).run().outputs[0], lines);
        assert_ne!(trial(60, 4).run().outputs[0], lines);
        assert!(trial(-1, 3).message().contains("negative"));
        assert_eq!(trial(0, 3).run().outputs[0].item_count(), 0);
    }
}
