//! Transform / Array: copies in rows, boxes and rings.

use std::f64::consts::TAU;

use katydid_component::{Context, Message, component};
use katydid_data::Geometry;
use katydid_geometry::{Box3, Curve, Interval, Plane, Rectangle, Vector3, Xform};

type Copies = Result<(Vec<Option<Geometry>>, Vec<Xform>), Message>;

fn count(n: i32) -> Result<usize, Message> {
    match usize::try_from(n) {
        Ok(n) if n > 0 => Ok(n),
        _ => Err(Message::error(format!("A count of {n} makes no copies: it must be at least 1"))),
    }
}

/// One copy a transform; without geometry only the transforms.
fn copies(context: &Context<'_>, geometry: Option<Geometry>, maps: Vec<Xform>) -> Copies {
    let mut out = Vec::new();
    if let Some(Geometry(value)) = geometry {
        for map in &maps {
            context.check()?;
            out.push(Some(Geometry(value.transformed(map)?)));
        }
    }
    Ok((out, maps))
}

/// Copies in a row, each a step farther than the one before. The original is the first.
#[component(
    "e87db220-a0a0-4d67-a405-f97fd14b2d7a",
    name = "Linear Array",
    nick = "ArrLinear",
    at = "Transform/Array"
)]
#[output("Geometry", "G", "The copies in order.")]
#[output("Transform", "X", "What takes the original to each copy.")]
fn linear_array(
    context: &Context<'_>,
    /// What to copy.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The step from copy to copy.
    #[port("Direction", "D", default = Vector3::new(10.0, 0.0, 0.0))]
    direction: Vector3,
    /// The number of copies, at least 1.
    #[port("Count", "N", default = 10)]
    n: i32,
) -> Result<(Vec<Option<Geometry>>, Vec<Xform>), Message> {
    let n = count(n)?;
    context.items(n)?;
    copies(context, geometry, (0..n).map(|i| Xform::translation(direction * i as f64)).collect())
}

/// Copies in rows and columns, as far apart as the sides of a cell. The original is the first; a column comes after the
/// other.
#[component(
    "e521f7c8-92f4-481c-888b-eea109e3d6e9",
    name = "Rectangular Array",
    nick = "ArrRec",
    at = "Transform/Array"
)]
#[output("Geometry", "G", "The copies, column by column.")]
#[output("Transform", "X", "What takes the original to each copy.")]
fn rectangular_array(
    context: &Context<'_>,
    /// What to copy.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// Its sides are the steps.
    #[port("Cell", "C", default = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 10.0), y: Interval::new(0.0, 5.0) })]
    cell: Rectangle,
    /// The number of copies along the cell's x axis, at least 1.
    #[port("X Count", "X", default = 6)]
    nx: i32,
    /// The number along its y axis, at least 1.
    #[port("Y Count", "Y", default = 3)]
    ny: i32,
) -> Result<(Vec<Option<Geometry>>, Vec<Xform>), Message> {
    let (x, y) = (cell.plane.x_axis * cell.x.length(), cell.plane.y_axis * cell.y.length());
    lattice(context, geometry, [x, y, Vector3::ZERO], [nx, ny, 1])
}

/// Copies in three directions, as far apart as the sides of a cell. The original is the first; z runs fastest.
#[component(
    "9f6f954c-ba7b-4428-bf1e-1768cdff666c",
    name = "Box Array",
    nick = "ArrBox",
    at = "Transform/Array"
)]
#[output("Geometry", "G", "The copies.")]
#[output("Transform", "X", "What takes the original to each copy.")]
fn box_array(
    context: &Context<'_>,
    /// What to copy.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// Its sides are the steps.
    #[port("Cell", "C", default = Box3 { plane: Plane::XY, x: Interval::new(0.0, 10.0), y: Interval::new(0.0, 5.0), z: Interval::new(0.0, 2.0) })]
    cell: Box3,
    /// The number of copies along the cell's x axis, at least 1.
    #[port("X Count", "X", default = 4)]
    nx: i32,
    /// The number along its y axis, at least 1.
    #[port("Y Count", "Y", default = 1)]
    ny: i32,
    /// The number along its z axis, at least 1.
    #[port("Z Count", "Z", default = 2)]
    nz: i32,
) -> Result<(Vec<Option<Geometry>>, Vec<Xform>), Message> {
    let plane = &cell.plane;
    let steps =
        [plane.x_axis * cell.x.length(), plane.y_axis * cell.y.length(), plane.z_axis * cell.z.length()];
    lattice(context, geometry, steps, [nx, ny, nz])
}

fn lattice(
    context: &Context<'_>,
    geometry: Option<Geometry>,
    [x, y, z]: [Vector3; 3],
    [nx, ny, nz]: [i32; 3],
) -> Copies {
    let (nx, ny, nz) = (count(nx)?, count(ny)?, count(nz)?);
    context.items(nx.saturating_mul(ny).saturating_mul(nz))?;
    let mut maps = Vec::new();
    for i in 0..nx {
        for j in 0..ny {
            for k in 0..nz {
                maps.push(Xform::translation(x * i as f64 + y * j as f64 + z * k as f64));
            }
        }
    }
    copies(context, geometry, maps)
}

/// Copies in a ring, counter-clockwise about a plane's normal. The original is the first.
#[component(
    "fca5ad7e-ecac-401d-a357-edda0a251cbc",
    name = "Polar Array",
    nick = "ArrPolar",
    at = "Transform/Array"
)]
#[output("Geometry", "G", "The copies in order.")]
#[output("Transform", "X", "What takes the original to each copy.")]
fn polar_array(
    context: &Context<'_>,
    /// What to copy.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The plane of the ring, with its middle at the origin.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The number of copies, at least 1.
    #[port("Count", "N", default = 10)]
    n: i32,
    /// The part of the turn that the copies share out, in radians.
    #[port("Angle", "A", default = TAU)]
    angle: f64,
) -> Result<(Vec<Option<Geometry>>, Vec<Xform>), Message> {
    let n = count(n)?;
    context.items(n)?;
    let step = angle / n as f64;
    let maps = (0..n).map(|i| Xform::rotation(step * i as f64, plane.z_axis, plane.origin));
    copies(context, geometry, maps.collect::<Result<_, _>>()?)
}

/// Copies along a curve, equal lengths apart, each turned as the curve turns, with as little twist as possible.
///
/// The original goes along from the start of the curve, where the first copy is.
#[component(
    "c6f23658-617f-4ac8-916d-d0d9e7241b25",
    name = "Curve Array",
    nick = "ArrCurve",
    at = "Transform/Array"
)]
#[output("Geometry", "G", "The copies in order.")]
#[output("Transform", "X", "What takes the original to each copy.")]
fn curve_array(
    context: &Context<'_>,
    /// What to copy.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The curve to follow.
    #[port("Curve", "C")]
    curve: &Curve,
    /// The number of copies, at least 1; both ends of an open curve get one.
    #[port("Count", "N", default = 10)]
    n: i32,
) -> Result<(Vec<Option<Geometry>>, Vec<Xform>), Message> {
    let n = count(n)?;
    context.items(n)?;
    let parameters = match n {
        1 => vec![curve.domain().start],
        n if curve.is_closed() => curve.divide_by_count(n)?,
        n => curve.divide_by_count(n - 1)?,
    };
    let missing = || Message::error("The curve has no direction at one of the copies");
    let frames: Option<Vec<Plane>> = curve.perpendicular_frames(&parameters).into_iter().collect();
    let frames = frames.ok_or_else(missing)?;
    let first = *frames.first().ok_or_else(missing)?;
    copies(context, geometry, frames.iter().map(|frame| Xform::plane_to_plane(&first, frame)).collect())
}

/// Copies in the segments of a ring, each the mirror image of its neighbours. The original belongs in the first segment,
/// which begins on the plane's x axis. An even number of segments closes without a seam.
#[component(
    "b90eaa92-6e38-4054-a915-afcf486224b3",
    name = "Kaleidoscope",
    nick = "KScope",
    at = "Transform/Array"
)]
#[output("Geometry", "G", "The copies in order.")]
#[output("Transform", "X", "What takes the original to each copy.")]
fn kaleidoscope(
    context: &Context<'_>,
    /// What to copy.
    #[port("Geometry", "G")]
    geometry: Option<Geometry>,
    /// The plane of the ring, with its middle at the origin.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The number of segments, at least 1.
    #[port("Segments", "S", default = 10)]
    segments: i32,
) -> Result<(Vec<Option<Geometry>>, Vec<Xform>), Message> {
    let n = count(segments)?;
    context.items(n)?;
    let step = TAU / n as f64;
    let mirror = Xform::in_frame(&plane, plane.x_axis, -plane.y_axis, plane.z_axis);
    let mut maps = Vec::with_capacity(n);
    for k in 0..n {
        // Mirrored in its first edge the segment lies one step behind.
        let turns = if k % 2 == 0 { k } else { k + 1 };
        let turn = Xform::rotation(step * turns as f64, plane.z_axis, plane.origin)?;
        maps.push(if k % 2 == 0 { turn } else { turn * mirror });
    }
    copies(context, geometry, maps)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Line, Plane, Point3, Vector3};

    #[test]
    fn rows_and_boxes() {
        let p = Point3::new(1.0, 0.0, 0.0);
        let row = Trial::of("Linear Array").item(p).item(Vector3::Y).item(3).texts(0);
        assert_eq!(row, ["{0;0}: {1, 0, 0}, {1, 1, 0}, {1, 2, 0}"]);
        assert!(Trial::of("Linear Array").item(p).item(Vector3::Y).item(0).message().contains("at least 1"));
        let none = Trial::of("Linear Array").tree(katydid_data::Tree::empty()).item(Vector3::Y).item(3).run();
        assert_eq!((none.outputs[0].item_count(), none.outputs[1].item_count()), (0, 3));
        let cells = Trial::of("Rectangular Array").item(p).default().item(2).item(2).texts(0);
        assert_eq!(cells, ["{0;0}: {1, 0, 0}, {1, 5, 0}, {11, 0, 0}, {11, 5, 0}"]);
        let boxes = Trial::of("Box Array").item(p).default().item(1).item(2).item(2).texts(0);
        assert_eq!(boxes, ["{0;0}: {1, 0, 0}, {1, 0, 2}, {1, 5, 0}, {1, 5, 2}"]);
    }

    #[test]
    fn rings_and_curves() {
        let p = Point3::new(1.0, 0.0, 0.0);
        let ring = Trial::of("Polar Array").item(p).item(Plane::XY).item(2).texts(0);
        assert_eq!(ring, ["{0;0}: {1, 0, 0}, {-1, 0, 0}"]);
        let line = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 4.0));
        let along = Trial::of("Curve Array").item(p).item(line).item(3).texts(0);
        assert_eq!(along, ["{0;0}: {1, 0, 0}, {1, 0, 2}, {1, 0, 4}"]);
        let q = Point3::new(1.0, 0.5, 0.0);
        let scope = Trial::of("Kaleidoscope").item(q).item(Plane::XY).item(4).texts(0);
        assert_eq!(scope, ["{0;0}: {1, 0.5, 0}, {-1, 0.5, 0}, {-1, -0.5, 0}, {1, -0.5, 0}"]);
    }
}
