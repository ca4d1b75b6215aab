//! Cells that hold few points each.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Tree, TreeBuilder};
use katydid_geometry::cloud::{OcTree, QuadTree};
use katydid_geometry::{Box3, CancellationToken, Curve, Error, Interval, Plane, Point3, Rectangle};

use super::{flat, place, present};

/// So many cells at most for every point and group.
const CELLS_A_POINT: usize = 256;

fn group_size(group: i32) -> Result<usize, Message> {
    match usize::try_from(group) {
        Ok(n) if n > 0 => Ok(n),
        _ => Err(Message::error(format!("The group is {group}: it must be at least 1"))),
    }
}

/// Cuts the rectangle around points into quarters, and those again, until no cell holds more than a group of points.
///
/// The cells cover the rectangle; those without points are there too. Points in one place stay together however many.
#[component(
    "8102032b-9699-4949-ab12-3017a31d1062",
    name = "QuadTree",
    nick = "QT",
    at = "Mesh/Triangulation"
)]
#[output("Quads", "Q", "The cells, a branch each.", kind = Curve)]
#[output("Points", "P", "The points in each cell, a branch a cell.", kind = Point)]
fn quad_tree(
    context: &Context<'_>,
    /// The points; nulls are left out.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The plane of the cells: points count where they stand seen along its normal.
    #[port("Plane", "Pl", default = Plane::XY)]
    plane: Plane,
    /// Whether the cells are squares.
    #[port("Square", "S", default = true)]
    square: bool,
    /// The most points in a cell, at least 1.
    #[port("Group", "G", default = 1)]
    group: i32,
) -> Result<(Tree, Tree), Message> {
    let group = group_size(group)?;
    let (_, points) = present(&points);
    let sites: Vec<[f64; 2]> = flat(&points, &plane).into_iter().map(Into::into).collect();
    let tree = QuadTree::new(&sites, group, square, CELLS_A_POINT.saturating_mul(points.len()))?;
    context.items(tree.leaves().len())?;
    let (mut cells, mut inside) = (TreeBuilder::<Shared<Curve>>::new(), TreeBuilder::<Point3>::new());
    for (k, leaf) in tree.leaves().iter().enumerate() {
        if CancellationToken::is_over() {
            return Err(Error::Stopped.into());
        }
        let path = place(context).child(k);
        let range = |c: usize| Interval::new(leaf.min[c], leaf.max[c]);
        let cell = Rectangle { plane, x: range(0), y: range(1) }.to_polyline()?;
        cells.branch(path.clone());
        cells.push(Some(Shared::new(cell.into())));
        inside.branch(path);
        leaf.points.iter().for_each(|&i| inside.push(points.get(i as usize).copied()));
    }
    Ok((cells.finish(), inside.finish()))
}

/// Cuts the box around points into eighths, and those again, until no cell holds more than a group of points.
///
/// The cells cover the box; those without points are there too. Points in one place stay together however many.
#[component("a59a68ad-fdd6-41dd-88f0-d7a6fb8d2e16", name = "OcTree", nick = "OcT", at = "Mesh/Triangulation")]
#[output("Boxes", "B", "The cells, along the world axes, a branch each.", kind = Box)]
#[output("Points", "P", "The points in each cell, a branch a cell.", kind = Point)]
fn oc_tree(
    context: &Context<'_>,
    /// The points; nulls are left out.
    #[port("Points", "P")]
    points: List<Point3>,
    /// Whether the cells are cubes.
    #[port("Square", "S", default = true)]
    square: bool,
    /// The most points in a cell, at least 1.
    #[port("Group", "G", default = 1)]
    group: i32,
) -> Result<(Tree, Tree), Message> {
    let group = group_size(group)?;
    let (_, points) = present(&points);
    let sites: Vec<[f64; 3]> = points.iter().map(|&p| p.into()).collect();
    let tree = OcTree::new(&sites, group, square, CELLS_A_POINT.saturating_mul(points.len()))?;
    context.items(tree.leaves().len())?;
    let (mut cells, mut inside) = (TreeBuilder::<Box3>::new(), TreeBuilder::<Point3>::new());
    for (k, leaf) in tree.leaves().iter().enumerate() {
        if CancellationToken::is_over() {
            return Err(Error::Stopped.into());
        }
        let path = place(context).child(k);
        let range = |c: usize| Interval::new(leaf.min[c], leaf.max[c]);
        cells.branch(path.clone());
        cells.push(Some(Box3 { plane: Plane::XY, x: range(0), y: range(1), z: range(2) }));
        inside.branch(path);
        leaf.points.iter().for_each(|&i| inside.push(points.get(i as usize).copied()));
    }
    Ok((cells.finish(), inside.finish()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Plane, Point3};

    fn points() -> [Point3; 4] {
        [[0.0, 0.0, 0.0], [8.0, 0.0, 0.0], [0.5, 0.5, 0.0], [8.0, 4.0, 8.0]].map(Point3::from)
    }

    #[test]
    fn quarters_of_quarters() {
        let run = Trial::of("QuadTree").list(points()).item(Plane::XY).item(false).item(1).run();
        let inside = texts(&run.outputs[1]);
        assert_eq!(run.outputs[0].branch_count(), run.outputs[1].branch_count());
        assert_eq!(run.outputs[1].item_count(), 4);
        assert!(inside.iter().all(|b| b.matches('{').count() <= 2));
        let run = Trial::of("QuadTree").list(points()).item(Plane::XY).item(true).item(4).run();
        let area = Trial::of("Area").tree(run.outputs[0].clone()).texts(0);
        assert_eq!(area.len(), 1);
        assert!(area[0].ends_with(": 64"), "{area:?}");
        let zero = Trial::of("QuadTree").list(points()).item(Plane::XY).item(true).item(0);
        assert!(zero.message().contains("at least 1"));
    }

    #[test]
    fn eighths_of_eighths() {
        let run = Trial::of("OcTree").list(points()).item(true).item(2).run();
        assert_eq!((run.outputs[0].item_count(), run.outputs[1].item_count()), (8, 4));
        let same = Trial::of("OcTree").list([Point3::ORIGIN; 5]).item(true).item(2).run();
        assert_eq!((same.outputs[0].item_count(), same.outputs[1].item_count()), (1, 5));
        let none = Trial::of("OcTree").gaps::<Point3>([None]).item(true).item(2).run();
        assert_eq!(none.outputs[0].item_count(), 0);
    }
}
