//! Surface / Primitive and Analysis: boxes.

use katydid_component::{Context, List, Message, component};
use katydid_data::Geometry;
use katydid_geometry::{Box3, Interval, Plane, Point3, Rectangle, Vector3};

use super::named;
use crate::transform::around;

/// The smallest boxes along the axes of a plane that hold geometry: one for each piece, or, as the object's menu says,
/// one for all.
///
/// Exact for points, curves and meshes. What has no extent, or none that can be measured yet, gives a null and a warning.
#[component(
    "0bb3d234-9097-45db-9998-621639c87d3b",
    name = "Bounding Box",
    nick = "BBox",
    at = "Surface/Primitive"
)]
#[output("Box", "B", "The boxes where they are.")]
#[output("Box", "B", "The boxes in the plane's own coordinates, as if it were the world's xy plane.")]
fn bounding_box(
    context: &Context<'_>,
    /// The geometry; a null gives a null.
    #[port("Content", "C")]
    content: List<Geometry>,
    /// Gives the directions of the boxes.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> (Vec<Option<Box3>>, Vec<Option<Box3>>) {
    let union = union_wanted(context);
    bounds(context, &content, &plane, union)
}

/// The smallest boxes along the axes of a plane that hold geometry: one for each piece, or one for all.
#[component(
    "87df35c8-6e1d-4e2a-821a-7c1066714409",
    name = "Bounding Box",
    nick = "BBox",
    at = "Surface/Primitive",
    old
)]
#[output("Box", "B", "The boxes where they are.")]
#[output("Box", "B", "The boxes in the plane's own coordinates, as if it were the world's xy plane.")]
fn bounding_box_with_switch(
    context: &Context<'_>,
    /// The geometry; a null gives a null.
    #[port("Content", "C")]
    content: List<Geometry>,
    /// Whether one box holds all.
    #[port("Union", "U", default = false)]
    union: bool,
    /// Gives the directions of the boxes.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> (Vec<Option<Box3>>, Vec<Option<Box3>>) {
    bounds(context, &content, &plane, union)
}

/// The smallest boxes along the world's axes that hold geometry: one for each piece, or one for all.
#[component(
    "6aa8da2e-6f25-4585-8b37-aa44609beb46",
    name = "Bounding Box",
    nick = "BBox",
    at = "Surface/Primitive",
    old
)]
#[output("Box", "B", "The boxes.")]
fn bounding_box_along_world_axes(
    context: &Context<'_>,
    /// The geometry; a null gives a null.
    #[port("Content", "C")]
    content: List<Geometry>,
    /// Whether one box holds all.
    #[port("Union", "U", default = false)]
    union: bool,
) -> Vec<Option<Box3>> {
    bounds(context, &content, &Plane::XY, union).0
}

/// The smallest box along the world's axes that holds a piece of geometry.
#[component(
    "9d375779-649d-49f1-baaf-04560a51cd3d",
    name = "Bounding Box [OBSOLETE]",
    nick = "BBox",
    at = "Surface/Primitive",
    old
)]
#[output("Box", "B", "The box.")]
fn bounding_box_of_one(
    context: &Context<'_>,
    /// The geometry.
    #[port("Content", "C")]
    content: Geometry,
) -> Option<Box3> {
    let found = around(&content.0, &Plane::XY);
    if found.is_none() {
        context.warn(format!("A {} has no extent that can be measured yet", named(&content.0)));
    }
    found
}

/// Where files store that one box holds all: beside the other values of the object's menu.
fn union_wanted(context: &Context<'_>) -> bool {
    let settings = context.settings();
    let table = settings.child("ValueTable");
    [table, Some(settings)].into_iter().flatten().find_map(|chunk| chunk.bool("UnionBox")).unwrap_or(false)
}

type Boxes = Vec<Option<Box3>>;

fn bounds(context: &Context<'_>, content: &List<'_, Geometry>, plane: &Plane, union: bool) -> (Boxes, Boxes) {
    let boxes: Boxes = content
        .iter()
        .map(|piece| {
            let piece = piece?;
            let found = around(&piece.0, plane);
            if found.is_none() {
                context.warn(format!("A {} has no extent that can be measured yet", named(&piece.0)));
            }
            found
        })
        .collect();
    let boxes = if union {
        let all = boxes.into_iter().flatten().reduce(|a, b| Box3 {
            x: a.x.union(b.x),
            y: a.y.union(b.y),
            z: a.z.union(b.z),
            ..a
        });
        all.into_iter().map(Some).collect()
    } else {
        boxes
    };
    let own = boxes.iter().map(|b| b.map(|b| Box3 { plane: Plane::XY, ..b })).collect();
    (boxes, own)
}

/// A box about the origin of a plane.
#[component(
    "28061aae-04fb-4cb5-ac45-16f3b66bc0a4",
    name = "Center Box",
    nick = "Box",
    at = "Surface/Primitive"
)]
#[output("Box", "B", "The box.")]
fn center_box(
    /// Its origin is the middle of the box.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// Half the size along the plane's x axis.
    #[port("X", "X", default = 1.0)]
    x: f64,
    /// Half the size along its y axis.
    #[port("Y", "Y", default = 1.0)]
    y: f64,
    /// Half the size along its normal.
    #[port("Z", "Z", default = 1.0)]
    z: f64,
) -> Box3 {
    let range = |half: f64| Interval::new(-half, half);
    Box3 { plane: base, x: range(x), y: range(y), z: range(z) }
}

/// A box along the axes of a plane.
#[component(
    "79aa7f47-397c-4d3f-9761-aaf421bb7f5f",
    name = "Domain Box",
    nick = "Box",
    at = "Surface/Primitive"
)]
#[output("Box", "B", "The box.")]
fn domain_box(
    /// The plane.
    #[port("Base", "B", default = Plane::XY)]
    base: Plane,
    /// From where to where along its x axis.
    #[port("X", "X", default = Interval::new(-2.0, 2.0))]
    x: Interval,
    /// From where to where along its y axis.
    #[port("Y", "Y", default = Interval::new(-0.5, 0.5))]
    y: Interval,
    /// From where to where along its normal.
    #[port("Z", "Z", default = Interval::new(0.0, 0.25))]
    z: Interval,
) -> Box3 {
    Box3 { plane: base, x, y, z }
}

/// The box along the axes of a plane with two corners diagonally across.
#[component(
    "2a43ef96-8f87-4892-8b94-237a47e8d3cf",
    name = "Box 2Pt",
    nick = "Box",
    at = "Surface/Primitive",
    also("9aef6eb4-98c3-4b0e-b875-1a7cb1bb1038")
)]
#[output("Box", "B", "The box.")]
fn box_2pt(
    /// A corner.
    #[port("Point A", "A")]
    a: Point3,
    /// The corner across.
    #[port("Point B", "B")]
    b: Point3,
    /// Gives the directions of the box.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<Box3, Message> {
    Box3::around(&plane, [a, b]).ok_or_else(|| Message::error("A corner is not finite"))
}

/// A box on a rectangle.
#[component(
    "d0a56c9e-2483-45e7-ab98-a450b97f1bc0",
    name = "Box Rectangle",
    nick = "BoxRec",
    at = "Surface/Primitive"
)]
#[output("Box", "B", "The box.")]
fn box_rectangle(
    /// The base.
    #[port("Rectangle", "R")]
    rectangle: Rectangle,
    /// From where to where along the rectangle's normal.
    #[port("Height", "H", default = Interval::new(0.0, 10.0))]
    height: Interval,
) -> Box3 {
    let Rectangle { plane, x, y } = rectangle;
    Box3 { plane, x, y, z: height }
}

/// The eight corners of a box: the bottom counter-clockwise from the smallest, then the top likewise.
#[component(
    "a10e8cdf-7c7a-4aac-aa70-ddb7010ab231",
    name = "Box Corners",
    nick = "Box Corners",
    at = "Surface/Analysis"
)]
#[output("Corner A", "A", "The corner at the start of x, y and z.")]
#[output("Corner B", "B", "The corner at the end of x.")]
#[output("Corner C", "C", "The corner at the ends of x and y.")]
#[output("Corner D", "D", "The corner at the end of y.")]
#[output("Corner E", "E", "The corner above A.")]
#[output("Corner F", "F", "The corner above B.")]
#[output("Corner G", "G", "The corner above C.")]
#[output("Corner H", "H", "The corner above D.")]
fn box_corners(
    /// The box.
    #[port("Box", "B")]
    shape: Box3,
) -> (Point3, Point3, Point3, Point3, Point3, Point3, Point3, Point3) {
    let [a, b, c, d, e, f, g, h] = shape.corners();
    (a, b, c, d, e, f, g, h)
}

/// The middle and the size of a box.
#[component(
    "af9cdb9d-9617-4827-bb3c-9efd88c76a70",
    name = "Box Properties",
    nick = "BoxProp",
    at = "Surface/Analysis"
)]
#[output("Center", "C", "Its middle.")]
#[output("Diagonal", "D", "From corner A to the corner across, G.")]
#[output("Area", "A", "The area of its sides.")]
#[output("Volume", "V", "Its volume.")]
#[output("Degeneracy", "d", "0 for a solid box, 1 for a flat one, 2 for a line, 3 for a point.")]
fn box_properties(
    /// The box.
    #[port("Box", "B")]
    shape: Box3,
) -> (Point3, Vector3, f64, f64, i32) {
    let [a, _, _, _, _, _, g, _] = shape.corners();
    let flat = [shape.x, shape.y, shape.z].iter().filter(|range| range.length() == 0.0).count();
    (shape.center(), g - a, shape.area().abs(), shape.volume().abs(), i32::try_from(flat).unwrap_or(3))
}

/// The plane of a box and where it lies in it.
#[component(
    "db7d83b1-2898-4ef9-9be5-4e94b4e2048d",
    name = "Deconstruct Box",
    nick = "DeBox",
    at = "Surface/Analysis"
)]
#[output("Plane", "P", "Its plane.")]
#[output("X", "X", "From where to where along the plane's x axis.")]
#[output("Y", "Y", "From where to where along its y axis.")]
#[output("Z", "Z", "From where to where along its normal.")]
fn deconstruct_box(
    /// The box.
    #[port("Box", "B")]
    shape: Box3,
) -> (Plane, Interval, Interval, Interval) {
    (shape.plane, shape.x, shape.y, shape.z)
}

/// A place in a box by fractions of its sides.
#[component(
    "13b40e9c-3aed-4669-b2e8-60bd02091421",
    name = "Evaluate Box",
    nick = "Box",
    at = "Surface/Analysis"
)]
#[output("Plane", "Pl", "The box's plane moved there.")]
#[output("Point", "Pt", "The point.")]
#[output("Include", "I", "Whether it lies in the box or on its skin.")]
fn evaluate_box(
    /// The box.
    #[port("Box", "B")]
    shape: Box3,
    /// Along x, 0 to 1 inside.
    #[port("U parameter", "U", default = 0.5)]
    u: f64,
    /// Along y.
    #[port("V parameter", "V", default = 0.5)]
    v: f64,
    /// Along z.
    #[port("W parameter", "W", default = 0.5)]
    w: f64,
) -> (Plane, Point3, bool) {
    let point = shape.at(u, v, w);
    let inside = [u, v, w].iter().all(|x| (0.0..=1.0).contains(x));
    (shape.plane.with_origin(point), point, inside)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_definition::archive::Chunk;
    use katydid_geometry::{Circle, Interval, Plane, Point3, Rectangle};

    #[test]
    fn bounding_boxes() {
        let points = || [[0.0, 0.0, 0.0], [4.0, 2.0, 1.0]].map(Point3::from);
        let each = Trial::of("Bounding Box").list(points()).texts(0);
        assert_eq!(each, ["{0;0}: Box (x=0, y=0, z=0), Box (x=0, y=0, z=0)"]);
        let mut settings = Chunk::new("Container");
        let mut table = Chunk::new("ValueTable");
        table.set("UnionBox", true);
        settings.set_child(table);
        let all = Trial::of("Bounding Box").list(points()).settings(settings).run();
        assert_eq!(texts(&all.outputs[0]), ["{0;0}: Box (x=4, y=2, z=1)"]);
        let circle = Circle { plane: Plane::XY.offset(5.0), radius: 3.0 };
        let turned = Trial::of("Bounding Box").item(circle).item(Plane::XZ).texts(0);
        assert_eq!(turned, ["{0;0}: Box (x=6, y=0, z=6)"]);
        let old = Trial::of_guid("87df35c8-6e1d-4e2a-821a-7c1066714409").list(points()).item(true);
        assert_eq!(old.texts(1), ["{0;0}: Box (x=4, y=2, z=1)"]);
        let older = Trial::of_guid("6aa8da2e-6f25-4585-8b37-aa44609beb46").list(points()).item(true);
        assert_eq!(older.texts(0), ["{0;0}: Box (x=4, y=2, z=1)"]);
    }

    #[test]
    fn making_and_reading_boxes() {
        assert_eq!(
            Trial::of("Center Box").item(Plane::XY).item(1.0).item(2.0).item(3.0).texts(0),
            ["{0}: Box (x=2, y=4, z=6)"]
        );
        let domain = || Trial::of("Domain Box").item(Plane::XY).item(2.0).item(3.0).item(4.0);
        assert_eq!(domain().texts(0), ["{0}: Box (x=2, y=3, z=4)"]);
        let corners = Trial::of("Box 2Pt").item(Point3::ORIGIN).item(Point3::new(-1.0, 2.0, 3.0));
        assert_eq!(corners.texts(0), ["{0}: Box (x=1, y=2, z=3)"]);
        let r = Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
        assert_eq!(Trial::of("Box Rectangle").item(r).texts(0), ["{0}: Box (x=1, y=1, z=10)"]);
        let made = || domain().run().outputs[0].clone();
        assert_eq!(Trial::of("Box Corners").tree(made()).texts(6), ["{0}: {2, 3, 4}"]);
        assert_eq!(Trial::of("Box Properties").tree(made()).texts(3), ["{0}: 24"]);
        assert_eq!(Trial::of("Box Properties").item(Point3::ORIGIN).texts(4), ["{0}: 3"]);
        assert_eq!(Trial::of("Deconstruct Box").tree(made()).texts(2), ["{0}: 0 To 3"]);
        assert_eq!(Trial::of("Evaluate Box").tree(made()).texts(1), ["{0}: {1, 1.5, 2}"]);
        assert_eq!(Trial::of("Evaluate Box").tree(made()).item(1.5).texts(2), ["{0}: False"]);
    }
}
