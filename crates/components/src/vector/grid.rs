//! Vector / Grid: regular grids. A branch holds a column of the grid.

use std::f64::consts::TAU;
use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::{Item, Tree, TreeBuilder};
use katydid_elementary::Elementary;
use katydid_geometry::{
    Arc, Circle, Curve, Interval, Line, Plane, Point3, PolyCurve, PolylineCurve, Rectangle,
};

/// A grid's extent as a count.
fn extent(n: i32) -> Result<usize, Message> {
    match usize::try_from(n) {
        Ok(n) if n > 0 => Ok(n),
        _ => Err(Message::error(format!("An extent of {n} makes no grid: it must be at least 1"))),
    }
}

fn positive(size: f64) -> Result<f64, Message> {
    if size > 0.0 && size.is_finite() {
        Ok(size)
    } else {
        Err(Message::error(format!("A size of {size} makes no grid: it must be greater than 0")))
    }
}

/// A tree with a branch a column and an item a row.
fn columns<T: Item>(
    context: &Context<'_>,
    columns: usize,
    rows: usize,
    make: impl Fn(f64, f64) -> Result<T, Message>,
) -> Result<Tree, Message> {
    let total = columns.saturating_mul(rows);
    context.items(total)?;
    context.bytes(total.saturating_mul(size_of::<T>()))?;
    let start = context.path().child(context.iteration());
    let mut tree = TreeBuilder::<T>::new();
    for a in 0..columns {
        context.check()?;
        tree.branch(start.child(a));
        for b in 0..rows {
            tree.push(Some(make(a as f64, b as f64)?));
        }
    }
    Ok(tree.finish())
}

fn rectangles(
    context: &Context<'_>,
    plane: Plane,
    [sx, sy]: [f64; 2],
    [ex, ey]: [i32; 2],
) -> Result<(Tree, Tree), Message> {
    let (ex, ey) = (extent(ex)?, extent(ey)?);
    let (sx, sy) = (positive(sx)?, positive(sy)?);
    let at = |a: f64, b: f64| plane.at(a * sx, b * sy, 0.0);
    let cells = if context.is_wanted(0) {
        columns(context, ex, ey, |a, b| {
            let plane = plane.with_origin(at(a, b));
            Ok(Rectangle { plane, x: Interval::new(0.0, sx), y: Interval::new(0.0, sy) })
        })?
    } else {
        Tree::empty()
    };
    Ok((cells, columns(context, ex + 1, ey + 1, |a, b| Ok(at(a, b)))?))
}

/// A closed polyline through corners.
fn outline(mut corners: Vec<Point3>) -> Result<Shared<Curve>, Message> {
    corners.extend(corners.first().copied());
    Ok(Shared::new(PolylineCurve::new(corners)?.into()))
}

/// A grid of squares, a branch a column.
#[component(
    "717a1e25-a075-4530-bc80-d43ecc2500d9",
    name = "Square",
    nick = "SqGrid",
    at = "Vector/Grid",
    also("40efea60-1902-4c28-8020-27abbb7a1449")
)]
#[output("Cells", "C", "The squares, Ex branches of Ey.", kind = Rectangle)]
#[output("Points", "P", "Their corners, Ex + 1 branches of Ey + 1.", kind = Point)]
fn square(
    context: &Context<'_>,
    /// The grid begins at its origin and follows its axes.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The side of a square; greater than 0.
    #[port("Size", "S", default = 1.0)]
    size: f64,
    /// The number of squares along x, at least 1.
    #[port("Extent X", "Ex", default = 5)]
    extent_x: i32,
    /// The number of squares along y, at least 1.
    #[port("Extent Y", "Ey", default = 5)]
    extent_y: i32,
) -> Result<(Tree, Tree), Message> {
    rectangles(context, plane, [size, size], [extent_x, extent_y])
}

/// A grid of rectangles, a branch a column.
#[component(
    "1a25aae0-0b56-497a-85b2-cc5bf7e4b96b",
    name = "Rectangular",
    nick = "RecGrid",
    at = "Vector/Grid",
    also("fdedcd0a-ad40-4307-959d-d2891e2f533e")
)]
#[output("Cells", "C", "The rectangles, Ex branches of Ey.", kind = Rectangle)]
#[output("Points", "P", "Their corners, Ex + 1 branches of Ey + 1.", kind = Point)]
fn rectangular(
    context: &Context<'_>,
    /// The grid begins at its origin and follows its axes.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The width of a rectangle; greater than 0.
    #[port("Size X", "Sx", default = 1.0)]
    size_x: f64,
    /// The height of a rectangle; greater than 0.
    #[port("Size Y", "Sy", default = 2.0)]
    size_y: f64,
    /// The number of rectangles along x, at least 1.
    #[port("Extent X", "Ex", default = 10)]
    extent_x: i32,
    /// The number of rectangles along y, at least 1.
    #[port("Extent Y", "Ey", default = 5)]
    extent_y: i32,
) -> Result<(Tree, Tree), Message> {
    rectangles(context, plane, [size_x, size_y], [extent_x, extent_y])
}

/// A grid of regular hexagons that fill the plane, a branch a column. Every other column stands half a cell higher.
#[component("125dc122-8544-4617-945e-bb9a0c101c50", name = "Hexagonal", nick = "HexGrid", at = "Vector/Grid")]
#[output("Cells", "C", "The hexagons, Ex branches of Ey.", kind = Curve)]
#[output("Points", "P", "Their centres, Ex branches of Ey.", kind = Point)]
fn hexagonal(
    context: &Context<'_>,
    /// The first hexagon lies about its origin.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The radius of a hexagon, which is its side; greater than 0.
    #[port("Size", "S", default = 1.0)]
    size: f64,
    /// The number of columns, at least 1.
    #[port("Extent X", "Ex", default = 5)]
    extent_x: i32,
    /// The number of hexagons in a column, at least 1.
    #[port("Extent Y", "Ey", default = 5)]
    extent_y: i32,
) -> Result<(Tree, Tree), Message> {
    let (ex, ey, size) = (extent(extent_x)?, extent(extent_y)?, positive(size)?);
    let pitch = 3f64.sqrt() * size;
    let center = |a: f64, b: f64| (1.5 * size * a, pitch * (b + 0.5 * (a % 2.0)));
    let cells = if context.is_wanted(0) {
        columns(context, ex, ey, |a, b| {
            let (x, y) = center(a, b);
            outline(
                (0..6)
                    .map(|k| {
                        let (sin, cos) = (TAU / 6.0 * f64::from(k)).sine_cosine();
                        plane.at(x + size * cos, y + size * sin, 0.0)
                    })
                    .collect(),
            )
        })?
    } else {
        Tree::empty()
    };
    let centers = columns(context, ex, ey, |a, b| {
        let (x, y) = center(a, b);
        Ok(plane.at(x, y, 0.0))
    })?;
    Ok((cells, centers))
}

/// A grid of regular hexagons as the earliest versions had it, in lists.
///
/// What its size counts is not documented: here it is the number of columns, and of hexagons in each.
#[component(
    "8ce6a747-6d36-4bd4-8af0-9a1081df417d",
    name = "Grid Hexagonal [OBSOLETE]",
    nick = "HexGrid",
    at = "Vector/Point",
    old
)]
#[output("Grid", "G", "The corners of the hexagons, each once.")]
#[output("Cells", "C", "The hexagons.")]
#[output("Centers", "M", "Their centres.")]
#[expect(clippy::type_complexity, reason = "the outputs of the component")]
fn old_hexagonal(
    context: &Context<'_>,
    /// The first hexagon lies about its origin.
    #[port("Base plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The radius of a hexagon, which is its side; greater than 0.
    #[port("Radius", "R", default = 1.0)]
    radius: f64,
    /// The number of columns, and of hexagons in a column; at least 1.
    #[port("Grid Size", "S", default = 5)]
    size: i32,
) -> Result<(Vec<Point3>, Vec<Shared<Curve>>, Vec<Point3>), Message> {
    /// The corners about a centre, in halves of the radius and of the pitch.
    const CORNERS: [[i64; 2]; 6] = [[2, 0], [1, 1], [-1, 1], [-2, 0], [-1, -1], [1, -1]];
    let (n, radius) = (extent(size)?, positive(radius)?);
    let total = n.saturating_mul(n);
    context.items(total.saturating_mul(6))?;
    context.bytes(total.saturating_mul(6 * size_of::<Point3>()))?;
    context.tell(Message::remark(
        "What the size of this old grid counts is not documented: columns and rows here",
    ));
    let at = |[x, y]: [i64; 2]| plane.at(0.5 * radius * x as f64, 0.5 * 3f64.sqrt() * radius * y as f64, 0.0);
    let (mut seen, mut corners) = (std::collections::HashSet::new(), Vec::new());
    let (mut cells, mut centers) = (Vec::with_capacity(total), Vec::with_capacity(total));
    for a in 0..i64::from(size) {
        context.check()?;
        for b in 0..i64::from(size) {
            let center = [3 * a, 2 * b + a % 2];
            let around = CORNERS.map(|[x, y]| [center[0] + x, center[1] + y]);
            corners.extend(around.iter().filter(|corner| seen.insert(**corner)).map(|corner| at(*corner)));
            cells.push(outline(around.map(at).to_vec())?);
            centers.push(at(center));
        }
    }
    Ok((corners, cells, centers))
}

/// A grid of equilateral triangles that point up and down in turn, a branch a column.
#[component(
    "86a9944b-dea5-4126-9433-9e95ff07927a",
    name = "Triangular",
    nick = "TriGrid",
    at = "Vector/Grid"
)]
#[output("Cells", "C", "The triangles, Ex branches of Ey.", kind = Curve)]
#[output("Points", "P", "Their centres, Ex branches of Ey.", kind = Point)]
fn triangular(
    context: &Context<'_>,
    /// The first triangle has a corner at its origin.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The side of a triangle; greater than 0.
    #[port("Size", "S", default = 1.0)]
    size: f64,
    /// The number of columns, half a side apart, at least 1.
    #[port("Extent X", "Ex", default = 5)]
    extent_x: i32,
    /// The number of triangles in a column, at least 1.
    #[port("Extent Y", "Ey", default = 5)]
    extent_y: i32,
) -> Result<(Tree, Tree), Message> {
    let (ex, ey, size) = (extent(extent_x)?, extent(extent_y)?, positive(size)?);
    let height = 0.75f64.sqrt() * size;
    let corners = |a: f64, b: f64| {
        let (x, low, high) = (0.5 * size * a, height * b, height * (b + 1.0));
        let flat = if (a + b) % 2.0 == 0.0 {
            [(x, low), (x + size, low), (x + 0.5 * size, high)]
        } else {
            [(x + 0.5 * size, low), (x + size, high), (x, high)]
        };
        flat.map(|(x, y)| plane.at(x, y, 0.0))
    };
    let cells = columns(context, ex, ey, |a, b| outline(corners(a, b).to_vec()))?;
    let centers = columns(context, ex, ey, |a, b| {
        let [p, q, r] = corners(a, b);
        Ok(p + ((q - p) + (r - p)) / 3.0)
    })?;
    Ok((cells, centers))
}

/// A grid of rings cut into equal sectors, a branch a ring, from the innermost.
#[component(
    "66eedc35-187d-4dab-b49b-408491b1255f",
    name = "Radial",
    nick = "RadGrid",
    at = "Vector/Grid",
    also("773183d0-8c00-4fe4-a38c-f8d2408b7415")
)]
#[output("Cells", "C", "The cells, Er branches of Ep.", kind = Curve)]
#[output("Points", "P", "The corners: a branch with the centre, then one of Ep points for each ring.", kind = Point)]
fn radial(
    context: &Context<'_>,
    /// The rings lie about its origin; the first sector begins on its x axis.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The width of a ring; greater than 0.
    #[port("Size", "S", default = 1.0)]
    size: f64,
    /// The number of rings, at least 1.
    #[port("Extent R", "Er", default = 5)]
    extent_r: i32,
    /// The number of sectors, at least 2.
    #[port("Extent P", "Ep", default = 10)]
    extent_p: i32,
) -> Result<(Tree, Tree), Message> {
    let (rings, sectors, size) = (extent(extent_r)?, extent(extent_p)?, positive(size)?);
    if sectors < 2 {
        return Err(Message::error("A radial grid needs at least 2 sectors"));
    }
    let step = TAU / sectors as f64;
    let at = |ring: f64, sector: f64| {
        let (sin, cos) = (step * (sector % sectors as f64)).sine_cosine();
        plane.at(ring * size * cos, ring * size * sin, 0.0)
    };
    let cells = columns(context, rings, sectors, |ring, sector| {
        let arc = |ring: f64| {
            let circle = Circle::new(plane, ring * size)?;
            Arc::new(circle, Interval::new(step * sector, step * (sector + 1.0)))
        };
        let side = |from: Point3, to: Point3| Curve::from(Line::new(from, to));
        let mut segments = vec![side(at(ring, sector), at(ring + 1.0, sector)), arc(ring + 1.0)?.into()];
        segments.push(side(at(ring + 1.0, sector + 1.0), at(ring, sector + 1.0)));
        if ring > 0.0 {
            segments.push(Curve::from(arc(ring)?).reversed());
        }
        Ok(Shared::new(Curve::from(PolyCurve::new(segments)?)))
    })?;
    let mut points = TreeBuilder::<Point3>::new();
    let start = context.path().child(context.iteration());
    points.branch(start.child(0));
    points.push(Some(plane.origin));
    for ring in 1..=rings {
        points.branch(start.child(ring));
        for sector in 0..sectors {
            points.push(Some(at(ring as f64, sector as f64)));
        }
    }
    Ok((cells, points.finish()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Plane, Point3};

    #[test]
    fn squares_and_rectangles() {
        let trial = || Trial::of_guid("717a1e25-a075-4530-bc80-d43ecc2500d9").item(Plane::XY).item(2.0);
        let grid = trial().item(1).item(2).run();
        assert_eq!(texts(&grid.outputs[0]), ["{0;0;0}: Rectangle (w=2, h=2), Rectangle (w=2, h=2)"]);
        assert_eq!(texts(&grid.outputs[1])[1], "{0;0;1}: {2, 0, 0}, {2, 2, 0}, {2, 4, 0}");
        assert!(trial().item(0).message().contains("at least 1"));
        let rectangles = Trial::of("Rectangular").default().item(1.0).item(3.0).item(2).item(1).texts(1);
        assert_eq!(rectangles[2], "{0;0;2}: {2, 0, 0}, {2, 3, 0}");
    }

    #[test]
    fn several_planes_have_branches_of_their_own() {
        let trial = Trial::of_guid("717a1e25-a075-4530-bc80-d43ecc2500d9").list([Plane::XY, Plane::XZ]);
        assert_eq!(trial.item(1.0).item(1).item(1).texts(1)[2], "{0;1;0}: {0, 0, 0}, {0, 0, 1}");
    }

    #[test]
    fn hexagons_as_in_the_golden_case() {
        let grid = Trial::of("Hexagonal").item(Plane::XY).item(1.4).item(42).item(30).run();
        let points = grid.outputs[1].flatten();
        let cloud = [Point3::new(10.0, 25.0, 0.0), Point3::new(74.0, 63.0, 0.0)];
        let near = Trial::of("Closest Point").tree(points).list(cloud).texts(2);
        assert!(near[0].starts_with("{0}: 26.925824, 24.690817, 22.495175, 20.351642, 18.27856"));
        assert_eq!(
            texts(&Trial::of("Hexagonal").item(Plane::XY).item(1.0).item(1).item(1).run().outputs[0]).len(),
            1
        );
    }

    #[test]
    fn the_old_grid_is_the_new_one_in_lists() {
        let old = Trial::of("Grid Hexagonal [OBSOLETE]").default().item(2.0).item(3).run();
        let new = Trial::of("Hexagonal").default().item(2.0).item(3).item(3).run();
        let centers = |tree: &katydid_data::Tree| -> Vec<String> {
            texts(&tree.flatten()).iter().map(|line| line.split_once(": ").unwrap().1.to_owned()).collect()
        };
        assert_eq!(centers(&old.outputs[2]), centers(&new.outputs[1]));
        assert_eq!(old.outputs[1].item_count(), 9);
        // Nine hexagons with 16 shared sides are a plane net: V − E + F = 1 with E = 54 − 16 and F = 9.
        assert_eq!(old.outputs[0].item_count(), 1 + 54 - 16 - 9);
        assert!(
            Trial::of("Grid Hexagonal [OBSOLETE]")
                .default()
                .item(2.0)
                .item(0)
                .message()
                .contains("at least 1")
        );
    }

    #[test]
    fn triangles_and_rings() {
        let triangles = Trial::of("Triangular").item(Plane::XY).item(3.0).item(2).item(1).texts(1);
        assert_eq!(triangles, ["{0;0;0}: {1.5, 0.866025, 0}", "{0;0;1}: {3, 1.732051, 0}"]);
        let radial = || Trial::of("Radial").default().item(2.0).item(2).item(4);
        assert_eq!(radial().texts(1)[0], "{0;0;0}: {0, 0, 0}");
        assert!(radial().texts(1)[2].starts_with("{0;0;2}: {4, 0, 0}, {0, 4, 0}"));
        assert_eq!(radial().texts(0).len(), 2);
        assert!(radial().run().messages.is_empty());
    }
}
