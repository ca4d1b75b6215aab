//! Cells of nearest points in a plane.

use std::sync::Arc as Shared;

use katydid_component::{Context, Each, List, ManyLists, Message, component};
use katydid_geometry::cloud::{ConvexPolygon, Voronoi};
use katydid_geometry::{CancellationToken, Curve, Error, Plane, Point2, Point3, Rectangle};

use super::{at_places, flat, plane_of, present};

const DUPLICATES: &str = "Some points fall on others and have no cell of their own";

/// The rectangle around points, larger by `margin` on every side, or, without one, by a tenth of its longer side.
fn around(sites: &[Point2], margin: Option<f64>) -> Result<ConvexPolygon, Message> {
    let first = sites.first().copied().unwrap_or_default();
    let (mut low, mut high) = (first, first);
    for p in sites {
        low = Point2::new(low.x.min(p.x), low.y.min(p.y));
        high = Point2::new(high.x.max(p.x), high.y.max(p.y));
    }
    let side = (high.x - low.x).max(high.y - low.y);
    let margin = margin.unwrap_or(if side > 0.0 { 0.1 * side } else { 1.0 });
    let corners = [
        (low.x - margin, low.y - margin),
        (high.x + margin, low.y - margin),
        (high.x + margin, high.y + margin),
        (low.x - margin, high.y + margin),
    ];
    Ok(ConvexPolygon::new(&corners.map(|(x, y)| Point2::new(x, y)))?)
}

/// For every point the part of a plane that is nearer to it than to all others.
///
/// Points off the plane count where they stand when seen along its normal. Of points that fall on one place the first
/// has the cell and the others a null, with a warning.
#[component(
    "a4011be0-1c91-45bd-8280-17dd3a9f46f1",
    name = "Voronoi",
    nick = "Voronoi",
    at = "Mesh/Triangulation",
    also("ee9261ab-75a4-478f-b483-a50b755b07fd")
)]
#[output("Cells", "C", "A closed outline for every point, in their order; null where nothing is left.")]
fn voronoi(
    context: &Context<'_>,
    /// The points; a null has no cell.
    #[port("Points", "P")]
    points: List<Point3>,
    /// How far a cell reaches from its point at most, greater than 0: arcs end it there. Without one cells meet.
    #[port("Radius", "R", optional)]
    radius: Option<f64>,
    /// The rectangle that ends all cells. Without one that around the points, larger by the radius or, without a
    /// radius, by a tenth of its longer side.
    #[port("Boundary", "B", optional)]
    boundary: Option<Rectangle>,
    /// The plane; without one that of the rectangle, or the one nearest to the points.
    #[port("Plane", "Pl", optional)]
    plane: Option<Plane>,
) -> Result<Vec<Option<Shared<Curve>>>, Message> {
    let count = points.len();
    let (places, points) = present(&points);
    context.items(count)?;
    if radius.is_some_and(|r| !(r > 0.0 && r.is_finite())) {
        return Err(Message::error("The radius must be greater than 0"));
    }
    if points.is_empty() {
        return Ok(at_places(count, &[], []));
    }
    let plane = plane.or(boundary.map(|b| b.plane)).unwrap_or_else(|| plane_of(&points));
    let sites = flat(&points, &plane);
    let border = match boundary {
        Some(b) => ConvexPolygon::new(&flat(&b.corners(), &plane))?,
        None => around(&sites, radius)?,
    };
    let diagram = Voronoi::new(&sites, &border)?;
    if diagram.has_duplicates() {
        context.warn(DUPLICATES);
    }
    let cells: Result<Vec<_>, Message> =
        (0..diagram.len()).map(|i| Ok(diagram.outline(i, &plane, radius)?.map(Shared::new))).collect();
    Ok(at_places(count, &places, cells?))
}

/// Nested diagrams: each set of points cuts the cells of the set before it into cells.
///
/// A point cuts the one cell in which it lies. Cells without points of the next set are not in its diagram.
#[component(
    "9d4854fe-70db-4863-967b-4120d0b6d2e4",
    name = "Voronoi Groups",
    nick = "VorGroup",
    at = "Mesh/Triangulation"
)]
#[output("Diagram 1", "D1", "The cells of these points, in their order; null for one outside all cells.")]
fn voronoi_groups(
    context: &Context<'_>,
    /// The rectangle around all cells; points count where they stand seen along its normal.
    #[port("Boundary", "B")]
    boundary: Rectangle,
    /// The points of a set; nulls have no cell.
    #[port("Generation 1", "G1")]
    generations: ManyLists<Point3>,
) -> Result<Each<Vec<Option<Shared<Curve>>>>, Message> {
    let border = ConvexPolygon::new(&flat(&boundary.corners(), &boundary.plane))?;
    nested(context, &boundary.plane, border, &generations)
}

/// Nested diagrams inside the rectangle around all points in a plane: an early form of the component of the same name.
#[component(
    "ab454a50-debf-46d1-9bd1-82648416a802",
    name = "Voronoi Groups",
    nick = "VorGroup",
    at = "Mesh/Triangulation",
    old
)]
#[output("Diagram 1", "D1", "The cells of these points, in their order; null for one outside all cells.")]
fn early_voronoi_groups(
    context: &Context<'_>,
    /// The plane of the cells.
    #[port("Plane", "P")]
    plane: Plane,
    /// The points of a set; nulls have no cell.
    #[port("Generation 1", "G1")]
    generations: ManyLists<Point3>,
) -> Result<Each<Vec<Option<Shared<Curve>>>>, Message> {
    let all: Vec<Point3> = generations.iter().flat_map(|list| list.present()).collect();
    let border = around(&flat(&all, &plane), None)?;
    nested(context, &plane, border, &generations)
}

fn nested(
    context: &Context<'_>,
    plane: &Plane,
    border: ConvexPolygon,
    generations: &ManyLists<'_, Point3>,
) -> Result<Each<Vec<Option<Shared<Curve>>>>, Message> {
    context.items(generations.iter().map(List::len).fold(0, usize::saturating_add))?;
    let mut parents = vec![border];
    let mut out = Vec::with_capacity(generations.len());
    for list in generations {
        let (places, points) = present(list);
        let mut sites: Vec<(usize, Point2)> = places.iter().copied().zip(flat(&points, plane)).collect();
        let mut cells: Vec<Option<Shared<Curve>>> = vec![None; list.len()];
        let mut children = Vec::new();
        for parent in &parents {
            context.check()?;
            // A point on a common border goes to the first cell.
            let (inside, rest) = sites.into_iter().partition(|&(_, p)| parent.contains(p));
            sites = rest;
            let inside: Vec<(usize, Point2)> = inside;
            let diagram = Voronoi::new(&inside.iter().map(|s| s.1).collect::<Vec<_>>(), parent)?;
            if diagram.has_duplicates() {
                context.warn(DUPLICATES);
            }
            for (i, &(place, _)) in inside.iter().enumerate() {
                if CancellationToken::is_over() {
                    return Err(Error::Stopped.into());
                }
                if let Some(slot) = cells.get_mut(place) {
                    *slot = diagram.outline(i, plane, None)?.map(Shared::new);
                }
                // What rounding leaves without area is no cell to cut further.
                children.extend(ConvexPolygon::new(diagram.cell(i)).ok());
            }
        }
        parents = children;
        out.push(cells);
    }
    Ok(Each(out))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Interval, Plane, Point3, Rectangle};

    fn row() -> [Point3; 3] {
        [1.0, 3.0, 7.0].map(|x| Point3::new(x, 1.0, 5.0))
    }

    fn rectangle() -> Rectangle {
        Rectangle { plane: Plane::XY, x: Interval::new(0.0, 10.0), y: Interval::new(0.0, 2.0) }
    }

    fn areas(trial: Trial) -> Vec<String> {
        Trial::of("Area").tree(trial.run().outputs[0].clone()).texts(0)
    }

    #[test]
    fn cells_in_a_rectangle() {
        let trial = || Trial::of("Voronoi").list(row()).default().item(rectangle());
        assert_eq!(areas(trial().item(Plane::XY)), ["{0;0}: 4, 6, 10"]);
        assert_eq!(areas(trial()), ["{0;0}: 4, 6, 10"]);
        // Without anything else the rectangle around the points, larger by 0.6.
        assert_eq!(areas(Trial::of("Voronoi").list(row())), ["{0;0}: 1.92, 3.6, 3.12"]);
    }

    #[test]
    fn cells_of_a_radius() {
        let trial = |r: f64| Trial::of("Voronoi").list(row()).item(r);
        let disc = areas(trial(0.5));
        assert_eq!(disc, ["{0;0}: 0.785398, 0.785398, 0.785398"]);
        assert!(trial(0.0).message().contains("greater than 0"));
        let cut = areas(trial(2.0));
        // A disc of radius 2 without a segment at distance 1: 4(π − π/3) + √3.
        let expected = 4.0 * (std::f64::consts::PI * 2.0 / 3.0) + 3.0_f64.sqrt();
        assert!(cut[0].starts_with(&format!("{{0;0}}: {expected:.5}")[..12]), "{cut:?} {expected}");
    }

    #[test]
    fn nulls_and_equal_points() {
        let points = [Some(row()[0]), None, Some(row()[0]), Some(row()[2])];
        let run = Trial::of("Voronoi").gaps(points).default().item(rectangle()).run();
        let cells = texts(&run.outputs[0]);
        assert_eq!(cells[0].matches("Curve").count(), 2, "{cells:?}");
        assert!(run.messages[0].text.contains("fall on others"));
        let flat = Rectangle { y: Interval::new(1.0, 1.0), ..rectangle() };
        assert!(Trial::of("Voronoi").list(row()).default().item(flat).message().contains("no area"));
    }

    #[test]
    fn nested_diagrams() {
        let second = [0.5, 1.5, 6.0, 30.0].map(|x| Point3::new(x, 0.5, 0.0));
        let trial = |n: usize| {
            Trial::of("Voronoi Groups").item(rectangle()).list(row()).list(second).outputs(2).run().outputs[n]
                .clone()
        };
        assert_eq!(Trial::of("Area").tree(trial(0)).texts(0), ["{0;0}: 4, 6, 10"]);
        assert_eq!(Trial::of("Area").tree(trial(1)).texts(0)[0].matches(',').count(), 3);
        assert!(Trial::of("Area").tree(trial(1)).texts(0)[0].starts_with("{0;0}: 2, 2, 10"));
        let early =
            Trial::of_guid("ab454a50-debf-46d1-9bd1-82648416a802").item(Plane::XY).list(row()).outputs(1);
        assert_eq!(texts(&early.run().outputs[0])[0].matches("Curve").count(), 3);
    }
}
