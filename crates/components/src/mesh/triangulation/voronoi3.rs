//! Cells of nearest points in space.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::cloud::{ConvexPolyhedron, voronoi_cell_3d, voronoi_cells_3d};
use katydid_geometry::{BoundingBox, Box3, Mesh, Point3};

use super::{at_places, present};
use crate::mesh::shared;

/// A box of its own coordinates, and the given points in them.
fn local(bounds: &Box3, points: &[Point3]) -> (BoundingBox, Vec<Point3>) {
    let (x, y, z) = (bounds.x.ordered(), bounds.y.ordered(), bounds.z.ordered());
    let own =
        BoundingBox { min: Point3::new(x.start, y.start, z.start), max: Point3::new(x.end, y.end, z.end) };
    (own, points.iter().map(|&p| bounds.plane.coordinates(p).into()).collect())
}

/// The skin of a cell in a box's own coordinates.
fn skin(cell: ConvexPolyhedron, bounds: &Box3) -> Result<Shared<Mesh>, Message> {
    Ok(shared(cell.mapped(|p| bounds.plane.at(p.x, p.y, p.z)).to_mesh()?))
}

/// For every point the part of a box that is nearer to it than to all others.
///
/// Each cell comes as a closed mesh with flat faces. Of points in one place the first has the cell and the others a
/// null, with a warning; so has a point so far outside the box that nothing in it is nearest to it.
#[component(
    "ba9bb57a-61cf-4207-a1c4-994e371ba4f9",
    name = "Voronoi 3D",
    nick = "Voronoi³",
    at = "Mesh/Triangulation"
)]
#[output("Cells", "C", "The cells as closed meshes, in the order of the points.", kind = Brep)]
#[output("Boundary", "B", "For every cell whether it reaches the box's sides.")]
fn voronoi_3d(
    context: &Context<'_>,
    /// The points; a null has no cell.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The box that ends all cells. Without one that along the world axes around the points, larger by a tenth of its
    /// diagonal on every side.
    #[port("Box", "B", optional)]
    bounds: Option<Box3>,
) -> Result<(Vec<Option<Shared<Mesh>>>, Vec<Option<bool>>), Message> {
    let count = points.len();
    let (places, points) = present(&points);
    // A cell has about fifteen faces.
    context.items(count.saturating_mul(16))?;
    let around = || {
        let b = BoundingBox::from_points(points.iter().copied())?;
        let diagonal = b.diagonal().length();
        Some(Box3::from(b.inflated(if diagonal > 0.0 { 0.1 * diagonal } else { 1.0 })))
    };
    let Some(bounds) = bounds.or_else(around) else {
        return if points.is_empty() {
            Ok((vec![None; count], vec![None; count]))
        } else {
            Err(Message::error("A coordinate of a point is not a finite number"))
        };
    };
    let (own, sites) = local(&bounds, &points);
    let cells = voronoi_cells_3d(&sites, &own)?;
    if cells.iter().any(Option::is_none) {
        context.warn("Some points have no cell: they are in the place of others, or far outside the box");
    }
    let touches: Vec<Option<bool>> = cells.iter().map(|c| c.as_ref().map(|c| c.touches_border())).collect();
    let skins: Result<Vec<_>, Message> =
        cells.into_iter().map(|c| c.map(|c| skin(c, &bounds)).transpose()).collect();
    Ok((at_places(count, &places, skins?), at_places(count, &places, touches)))
}

/// The part of a box that is nearer to a point than to its neighbours, as a closed mesh with flat faces.
///
/// Neighbours in the point's own place are passed over. Null when nothing is left.
#[component(
    "7b181be1-30e7-4a97-915a-1b461741aef8",
    name = "Voronoi Cell",
    nick = "VCell",
    at = "Mesh/Triangulation"
)]
#[output("Cell", "C", "The cell as a closed mesh.", kind = Brep)]
fn voronoi_cell(
    /// The point inside the cell.
    #[port("Point", "P")]
    point: Point3,
    /// The points around it; nulls are left out.
    #[port("Neighbours", "N")]
    neighbours: List<Point3>,
    /// The box that ends the cell.
    #[port("Box", "B")]
    bounds: Box3,
) -> Result<Option<Shared<Mesh>>, Message> {
    let (_, others) = present(&neighbours);
    let (own, others) = local(&bounds, &others);
    let site = bounds.plane.coordinates(point).into();
    voronoi_cell_3d(site, &others, &own)?.map(|cell| skin(cell, &bounds)).transpose()
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Box3, Interval, Plane, Point3};

    fn bounds(plane: Plane) -> Box3 {
        let side = Interval::new(0.0, 4.0);
        Box3 { plane, x: side, y: side, z: side }
    }

    #[test]
    fn cells_of_a_box() {
        let points = [1.0, 1.0, 2.0].map(|x| Point3::new(x, 2.0, 2.0));
        let run = Trial::of("Voronoi 3D").list(points).item(bounds(Plane::XY)).run();
        assert_eq!(texts(&run.outputs[1]), ["{0;0}: True, null, True"]);
        assert!(run.messages[0].text.contains("no cell"));
        let volumes = Trial::of("Volume").tree(run.outputs[0].clone()).texts(0);
        assert!(volumes[0].starts_with("{0;0}: 24") && volumes[0].ends_with("40"), "{volumes:?}");
        // The box around the points, grown, in a tilted frame too.
        let many = (0..27).map(|i| Point3::new(f64::from(i % 3), f64::from(i / 3 % 3), f64::from(i / 9)));
        let run = Trial::of("Voronoi 3D").list(many).run();
        let inner = texts(&run.outputs[1])[0].matches("False").count();
        assert_eq!(inner, 1);
    }

    #[test]
    fn one_cell() {
        let frame = Plane::XZ.with_origin(Point3::new(0.0, 10.0, 0.0));
        let p = |x: f64, y: f64, z: f64| frame.at(x, y, z);
        let around = [p(4.0, 2.0, 2.0), p(2.0, 2.0, 2.0), p(2.0, 4.0, 2.0)];
        let cell = Trial::of("Voronoi Cell").item(p(2.0, 2.0, 2.0)).list(around).item(bounds(frame)).run();
        let volume = Trial::of("Volume").tree(cell.outputs[0].clone()).texts(0);
        assert_eq!(volume, ["{0}: 36"]);
        let far = Trial::of("Voronoi Cell").item(p(90.0, 2.0, 2.0)).list(around).item(bounds(frame));
        assert_eq!(far.texts(0), ["{0}: null"]);
        let flat = Box3 { z: Interval::new(1.0, 1.0), ..bounds(Plane::XY) };
        let trial = Trial::of("Voronoi 3D").list([Point3::ORIGIN]).item(flat);
        assert!(trial.message().contains("no volume"));
    }
}
