//! Wb Define: pyramids, prisms and their like over regular polygons, and regular solids.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Value;
use katydid_elementary::Elementary;
use katydid_geometry::{Mesh, Plane, Point3, Vector3};

use super::outlines;
use super::tessellation::{Fill, fill};
use crate::lunchbox::Solid;
use crate::polygons::{Polygons, sides};

/// The most sides of a base.
const MOST_SIDES: i32 = 100_000;

/// A regular polygon and the point that tells where the top is.
struct Base {
    corners: Vec<Point3>,
    /// The middle of the same polygon, half a side further.
    between: Vec<Point3>,
    middle: Point3,
    /// From the middle of the base to the top.
    rise: Vector3,
    /// Whether the top lies where the plane's normal points.
    upwards: bool,
}

impl Base {
    fn new(
        plane: &Plane,
        width: f64,
        sides: i32,
        top: Option<Point3>,
        outside: bool,
    ) -> Result<Self, Message> {
        if !(3..=MOST_SIDES).contains(&sides) {
            return Err(Message::error(format!("A base of {sides} sides: there must be 3 to {MOST_SIDES}")));
        }
        if !(width > 0.0 && width.is_finite()) {
            return Err(Message::error(format!("The width is {width}: it must be above 0")));
        }
        let half = std::f64::consts::PI / f64::from(sides);
        let radius = if outside { width } else { width / half.cosine() };
        let middle = plane.origin;
        let rise = top.map_or(plane.z_axis * width, |top| top - middle);
        let height = rise.dot(plane.z_axis);
        if !(height.abs() > 0.0 && rise.length().is_finite()) {
            return Err(Message::error("The top lies in the plane of the base"));
        }
        let at = |turn: f64| {
            let (sin, cos) = turn.sine_cosine();
            plane.at(radius * cos, radius * sin, 0.0)
        };
        let ring = |shift: f64| (0..sides).map(|k| at((2.0 * f64::from(k) + shift) * half)).collect();
        Ok(Self { corners: ring(0.0), between: ring(1.0), middle, rise, upwards: height > 0.0 })
    }

    /// The base as the first points of a body.
    fn body(&self) -> Polygons {
        Polygons { points: self.corners.clone(), faces: Vec::new() }
    }

    /// The numbers of the corners of the base.
    fn ring(&self) -> Vec<usize> {
        (0..self.corners.len()).collect()
    }

    /// The mesh of a body whose sides look outwards where the top is above.
    fn finished(&self, context: &Context<'_>, mut body: Polygons) -> Result<Shared<Mesh>, Message> {
        if !self.upwards {
            body.faces.iter_mut().for_each(|face| face.reverse());
        }
        Ok(Shared::new(body.to_mesh(context)?))
    }
}

/// Triangles from each side of the base to a point.
fn cone(body: &mut Polygons, ring: &[usize], top: usize, turned: bool) {
    body.faces.extend(sides(ring).map(|(a, b)| if turned { vec![b, a, top] } else { vec![a, b, top] }));
}

/// Adds a face, or what fills it.
fn cap(body: &mut Polygons, mut ring: Vec<usize>, turned: bool, strategy: Fill) {
    if turned {
        ring.reverse();
    }
    let filled = fill(body, &ring, strategy);
    body.faces.extend(filled);
}

macro_rules! solid {
    ($(#[$help:meta])* $function:ident, $guid:literal, $name:literal, $nick:literal, $build:expr) => {
        $(#[$help])*
        #[component($guid, name = $name, nick = $nick, at = "Weaverbird/Wb Define")]
        #[output("OutMesh", "O", "The mesh.")]
        #[allow(clippy::too_many_arguments, reason = "the ports of the component")]
        fn $function(
            context: &Context<'_>,
            /// The plane of the base.
            #[port("Plane", "P", default = Plane::XY)]
            plane: Plane,
            /// The radius of the circle around or in the base.
            #[port("Width", "W", default = 1.0)]
            width: f64,
            /// How many sides the base has.
            #[port("NumberOfSides", "S", default = 4)]
            sides: i32,
            /// The top: the point of a pyramid, the middle of the upper polygon of a prism. Without it the top stands as high
            /// above the plane as the base is wide.
            #[port("TopPoint", "T", optional)]
            top: Option<Point3>,
            /// Whether the circle goes through the corners of the base, or touches its sides.
            #[port("BasePolygonMethod", "C", default = true)]
            outside: bool,
            /// How polygons are filled: 0 not, 1 triangles and quads as they are and others by a fan, 2 a fan about the middle, 3
            /// triangles from the first corner, 4 and 5 triangles to and fro, 6 quads side by side, 7 quads about the middle.
            #[port("FillStrategy", "F", default = 1)]
            strategy: i32,
        ) -> Result<Shared<Mesh>, Message> {
            let strategy = Fill::of(strategy)?;
            let base = Base::new(&plane, width, sides, top, outside)?;
            context.items(base.corners.len().saturating_mul(4))?;
            let mut body = base.body();
            let build: fn(&Base, &mut Polygons, Fill) = $build;
            build(&base, &mut body, strategy);
            base.finished(context, body)
        }
    };
}

solid!(
    /// A pyramid over a regular polygon. Stands for Weaverbird's Mesh Pyramid.
    pyramid, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b51", "Mesh Pyramid", "wbPyramid",
    |base, body, strategy| {
        let ring = base.ring();
        body.points.push(base.middle + base.rise);
        cone(body, &ring, ring.len(), false);
        cap(body, ring, true, strategy);
    }
);
solid!(
    /// Two pyramids on one regular polygon, on either side of it. Stands for Weaverbird's Mesh Dipyramid; that the lower point
    /// mirrors the upper one in the middle of the polygon is our reading, and nothing is filled.
    dipyramid, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b52", "Mesh Dipyramid", "wbDipyramid",
    |base, body, _| {
        let ring = base.ring();
        body.points.extend([base.middle + base.rise, base.middle - base.rise]);
        cone(body, &ring, ring.len(), false);
        cone(body, &ring, ring.len() + 1, true);
    }
);
solid!(
    /// A prism over a regular polygon. Stands for Weaverbird's Mesh Prism.
    prism, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b53", "Mesh Prism", "wbPrism",
    |base, body, strategy| {
        let ring = base.ring();
        let n = ring.len();
        body.points.extend(base.corners.iter().map(|p| *p + base.rise));
        body.faces.extend(sides(&ring).map(|(a, b)| vec![a, b, b + n, a + n]));
        cap(body, ring.iter().map(|i| i + n).collect(), false, strategy);
        cap(body, ring, true, strategy);
    }
);
solid!(
    /// An antiprism over a regular polygon: the upper polygon is turned by half a side, with triangles between. Stands for
    /// Weaverbird's Mesh Antiprism.
    antiprism, "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b54", "Mesh Antiprism", "wbAntiprism",
    |base, body, strategy| {
        let ring = base.ring();
        let n = ring.len();
        body.points.extend(base.between.iter().map(|p| *p + base.rise));
        for (a, b) in sides(&ring) {
            body.faces.extend([vec![a, b, a + n], vec![b, b + n, a + n]]);
        }
        cap(body, ring.iter().map(|i| i + n).collect(), false, strategy);
        cap(body, ring, true, strategy);
    }
);

/// The faces of a regular solid about the origin of a plane, in its axes.
///
/// # Errors
/// The radius is not above 0.
fn regular(solid: Solid, plane: &Plane, radius: f64) -> Result<Polygons, Message> {
    if !(radius > 0.0 && radius.is_finite()) {
        return Err(Message::error(format!("The radius is {radius}: it must be above 0")));
    }
    let at = |v: &Vector3| plane.at(radius * v.x, radius * v.y, radius * v.z);
    let loops: Vec<Vec<Point3>> = solid.rings(0.0).iter().map(|ring| ring.iter().map(at).collect()).collect();
    Ok(Polygons::of_loops(&loops))
}

/// A regular icosahedron, of 20 triangles, as a mesh. Stands for Weaverbird's Mesh Mesh Icosahedron; how it is turned in the plane is
/// our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b57",
    name = "Mesh Mesh Icosahedron",
    nick = "wbIcosahedron",
    at = "Weaverbird/Wb Define"
)]
#[output("OutMesh", "O", "The mesh.")]
fn mesh_icosahedron(
    context: &Context<'_>,
    /// The plane: its origin is the middle.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The distance of the corners from the middle.
    #[port("Radius", "W", default = 1.0)]
    radius: f64,
) -> Result<Shared<Mesh>, Message> {
    Ok(Shared::new(regular(Solid::Icosahedron, &plane, radius)?.to_mesh(context)?))
}

/// A regular dodecahedron as 12 closed polylines, its faces. Stands for Weaverbird's Polylines Dodecahedron; how it is turned in the
/// plane is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1b58",
    name = "Polylines Dodecahedron",
    nick = "wbDodecahedron",
    at = "Weaverbird/Wb Define"
)]
#[output("OutPolylines", "P", "The polylines.", kind = Curve)]
fn polylines_dodecahedron(
    /// The plane: its origin is the middle.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
    /// The distance of the corners from the middle.
    #[port("Radius", "W", default = 1.0)]
    radius: f64,
) -> Result<Vec<Value>, Message> {
    Ok(outlines(&regular(Solid::Dodecahedron, &plane, radius)?))
}
