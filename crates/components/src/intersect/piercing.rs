//! Intersect / Mathematical and Physical: lines and curves that pierce surfaces and meshes.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_geometry::brep::BrepCrossing;
use katydid_geometry::{Brep, Curve, Line, Mesh, MeshTree, Point3, PolylineLimits, Vector3};

use crate::prepared;

/// The stretches and points that a curve and a Brep have in common.
type Meeting = (Vec<Shared<Curve>>, Vec<Point3>);

/// What a curve and a Brep have in common.
struct Piercing {
    crossings: Vec<BrepCrossing>,
    /// The stretches that lie in faces.
    curves: Vec<Shared<Curve>>,
}

impl Piercing {
    /// Where a curve meets a Brep; only there where it does so first, if that is wanted.
    fn new(context: &Context<'_>, curve: &Curve, brep: &Shared<Brep>, first: bool) -> Result<Self, Message> {
        let search = prepared::brep(context, brep)?;
        let mut found = search.curve_crossings(curve, context.tolerance().absolute)?;
        if !found.complete {
            context.warn("Curve and Brep lie so close together that some meetings may be missing");
        }
        if first {
            let point = found.crossings.first().map_or(f64::INFINITY, |c| c.t);
            let stretch = found.overlaps.first().map_or(f64::INFINITY, |o| o.start);
            found.crossings.truncate(usize::from(point <= stretch));
            found.overlaps.truncate(usize::from(stretch < point));
        }
        context.items(found.crossings.len().saturating_mul(6))?;
        let stretches = found.overlaps.iter().map(|o| curve.trimmed(*o).map(Shared::new));
        Ok(Self { curves: stretches.collect::<Result<_, _>>()?, crossings: found.crossings })
    }

    fn points(&self) -> Vec<Point3> {
        self.crossings.iter().map(|c| c.point).collect()
    }

    fn parameters(&self) -> Vec<Point3> {
        self.crossings.iter().map(|c| Point3::new(c.uv[0], c.uv[1], 0.0)).collect()
    }

    fn normals(&self) -> Vec<Option<Vector3>> {
        self.crossings.iter().map(|c| c.normal).collect()
    }

    fn meeting(self) -> Meeting {
        let points = self.points();
        (self.curves, points)
    }
}

/// Whether the object is set to give the first meeting only.
fn only_first(context: &Context<'_>) -> bool {
    context.settings().bool("LimitToFirst").unwrap_or(false)
}

/// Where a line between its ends meets a surface, in the order of the line.
///
/// Stretches of the line that lie in the surface are given as curves.
#[component(
    "a834e823-ae01-44d8-9066-c138eeb6f391",
    name = "Surface | Line",
    nick = "SLX",
    at = "Intersect/Mathematical"
)]
#[output("Curves", "C", "The stretches that lie in the surface.")]
#[output("Points", "P", "The points.")]
#[output("UV Points", "uv", "Their parameters on the surface, u as x and v as y.")]
#[output("Normal", "N", "The normals of the surface there, of length 1.")]
fn surface_line(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: Shared<Brep>,
    /// The line.
    #[port("Line", "L")]
    line: Line,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>, Vec<Point3>, Vec<Option<Vector3>>), Message> {
    let met = Piercing::new(context, &line.into(), &surface, only_first(context))?;
    Ok((met.curves.clone(), met.points(), met.parameters(), met.normals()))
}

/// Where a line between its ends meets a surface. Another form of the component of the same name.
#[component(
    "c2c73357-bfd2-45af-89ff-40ca02a3442f",
    name = "Surface | Line",
    nick = "SLX",
    at = "Intersect/Mathematical",
    old
)]
#[output("Curves", "C", "The stretches that lie in the surface.")]
#[output("Points", "P", "The points.")]
#[output("UV Points", "uv", "Their parameters on the surface, u as x and v as y.")]
#[output("Normal", "N", "The normals of the surface there, of length 1.")]
fn surface_line_first(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: Shared<Brep>,
    /// The line.
    #[port("Line", "L")]
    line: Line,
    /// Whether only the first meeting along the line is wanted.
    #[port("First", "F", default = false)]
    first: bool,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>, Vec<Point3>, Vec<Option<Vector3>>), Message> {
    let met = Piercing::new(context, &line.into(), &surface, first)?;
    Ok((met.curves.clone(), met.points(), met.parameters(), met.normals()))
}

/// Where a line between its ends meets a Brep, in the order of the line.
///
/// Trimmed parts do not count. A point on an edge is given once.
#[component(
    "ed0742f9-6647-4d95-9dfd-9ad17080ae9c",
    name = "Brep | Line",
    nick = "BLX",
    at = "Intersect/Mathematical"
)]
#[output("Curves", "C", "The stretches that lie in the Brep.")]
#[output("Points", "P", "The points.")]
fn brep_line(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The line.
    #[port("Line", "L")]
    line: Line,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    Ok(Piercing::new(context, &line.into(), &brep, only_first(context))?.meeting())
}

/// Where a line between its ends meets a Brep. Another form of the component of the same name.
#[component(
    "ff880808-6daf-4f6c-88c1-058120ad6ba9",
    name = "Brep | Line",
    nick = "BLX",
    at = "Intersect/Mathematical",
    old
)]
#[output("Curves", "C", "The stretches that lie in the Brep.")]
#[output("Points", "P", "The points.")]
fn brep_line_first(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The line.
    #[port("Line", "L")]
    line: Line,
    /// Whether only the first meeting along the line is wanted.
    #[port("First", "F", default = false)]
    first: bool,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    Ok(Piercing::new(context, &line.into(), &brep, first)?.meeting())
}

/// Where a curve meets a surface, in the order of the curve.
///
/// Stretches of the curve that lie in the surface are given as curves.
#[component(
    "68546dd0-aa82-471c-87e9-81cb16ac50ed",
    name = "Surface | Curve",
    nick = "SCX",
    at = "Intersect/Physical"
)]
#[output("Curves", "C", "The stretches that lie in the surface.")]
#[output("Points", "P", "The points.")]
#[output("UV Points", "uv", "Their parameters on the surface, u as x and v as y.")]
#[output("Normals", "N", "The normals of the surface there, of length 1.")]
#[output("Parameters", "t", "Their parameters on the curve.")]
#[output("Tangents", "T", "The directions of the curve there, of length 1.")]
fn surface_curve(
    context: &Context<'_>,
    /// The surface.
    #[port("Surface", "S")]
    surface: Shared<Brep>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<
    (Vec<Shared<Curve>>, Vec<Point3>, Vec<Point3>, Vec<Option<Vector3>>, Vec<f64>, Vec<Option<Vector3>>),
    Message,
> {
    let met = Piercing::new(context, curve, &surface, false)?;
    let places: Vec<f64> = met.crossings.iter().map(|c| c.t).collect();
    let tangents = places.iter().map(|&t| curve.tangent_at(t)).collect();
    Ok((met.curves.clone(), met.points(), met.parameters(), met.normals(), places, tangents))
}

/// Where a curve meets a Brep, in the order of the curve.
///
/// Trimmed parts do not count. A point on an edge is given once.
#[component(
    "20ef81e8-df15-4a0c-acf1-993a7607cafb",
    name = "Brep | Curve",
    nick = "BCX",
    at = "Intersect/Physical"
)]
#[output("Curves", "C", "The stretches that lie in the Brep.")]
#[output("Points", "P", "The points.")]
fn brep_curve(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(Vec<Shared<Curve>>, Vec<Point3>), Message> {
    Ok(Piercing::new(context, curve, &brep, false)?.meeting())
}

/// Where a curve passes through a mesh, in the order of the curve.
///
/// A bent curve is taken as a polyline within the tolerance. Stretches that run within a face give no points.
#[component(
    "19632848-4b95-4e5e-9e86-b79b47987a46",
    name = "Mesh | Curve",
    nick = "MCX",
    at = "Intersect/Physical"
)]
#[output("Points", "X", "The points.")]
#[output("Faces", "F", "For each the index of the face.")]
fn mesh_curve(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The curve.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(Vec<Point3>, Vec<i32>), Message> {
    let tolerance = context.tolerance().absolute;
    let corners = match curve.as_polyline() {
        Some(points) => points,
        None => curve.to_polyline(&PolylineLimits::within(tolerance))?.points().to_vec(),
    };
    let tree = MeshTree::new(mesh);
    let (mut points, mut faces): (Vec<Point3>, Vec<i32>) = (Vec::new(), Vec::new());
    let mut after = 0.0_f64;
    for w in corners.windows(2) {
        context.check()?;
        let &[a, b] = w else { continue };
        let near = 1e-9 * (1.0 + a.to_vector().length());
        for hit in tree.line_hits(a, b - a, [0.0, 1.0])? {
            // A corner of the curve in the mesh is one point of both its segments.
            let again = after <= near && points.last().is_some_and(|p| p.distance_to(hit.point) <= near);
            if !(again && hit.t * a.distance_to(b) <= near) {
                points.push(hit.point);
                faces.push(i32::try_from(hit.face).unwrap_or(i32::MAX));
                context.items(points.len().saturating_mul(2))?;
            }
        }
        after = points.last().map_or(f64::INFINITY, |p| p.distance_to(b));
    }
    if curve.is_closed() && points.len() > 1 && points.first().zip(points.last()).is_some_and(|(a, b)| a == b)
    {
        points.pop();
        faces.pop();
    }
    Ok((points, faces))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{
        Box3, Circle, Curve, Interval, Line, Mesh, Plane, PlaneSurface, Point3, PolylineCurve, Sphere,
        Surface,
    };

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    #[test]
    fn solids_are_pierced() {
        let side = Interval::new(0.0, 2.0);
        let block = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        let through = |from: Point3, to: Point3| {
            Trial::of("Brep | Line").item(block).item(Line::new(from, to)).run().outputs
        };
        assert_eq!(texts(&through(p(1.0, 1.0, -1.0), p(1.0, 1.0, 9.0))[1]), ["{0;0}: {1, 1, 0}, {1, 1, 2}"]);
        // Through an edge and a corner: each once.
        assert_eq!(through(p(-1.0, 1.0, -1.0), p(3.0, 1.0, 3.0))[1].item_count(), 2);
        assert_eq!(through(p(-1.0, -1.0, -1.0), p(3.0, 3.0, 3.0))[1].item_count(), 2);
        let along = through(p(-1.0, 1.0, 2.0), p(3.0, 1.0, 2.0));
        assert_eq!((along[0].item_count(), along[1].item_count()), (1, 0));
        let round: Curve = Circle::new(Plane::XY.with_origin(p(0.0, 0.0, 1.0)), 1.0).unwrap().into();
        let met = Trial::of("Brep | Curve").item(block).item(round).run().outputs;
        assert_eq!(met[1].item_count(), 2);
    }

    fn ball() -> Surface {
        Sphere::around(Point3::ORIGIN, 5.0).unwrap().into()
    }

    #[test]
    fn lines_through_surfaces() {
        let line = Line::new(p(3.0, 0.0, -9.0), p(3.0, 0.0, 9.0));
        let met = Trial::of("Surface | Line").item(ball()).item(line).run().outputs;
        assert_eq!(texts(&met[1]), ["{0;0}: {3, 0, -4}, {3, 0, 4}"]);
        let normals = texts(&met[3]).join("").replace("-0,", "0,");
        assert_eq!(normals, "{0;0}: {0.6, 0, -0.8}, {0.6, 0, 0.8}");
        let first = Trial::of_guid("c2c73357-bfd2-45af-89ff-40ca02a3442f").item(ball()).item(line).item(true);
        assert_eq!(first.texts(1), ["{0;0}: {3, 0, -4}"]);
        // The line has ends.
        let short = Line::new(p(3.0, 0.0, 0.0), p(3.0, 0.0, 9.0));
        assert_eq!(Trial::of("Brep | Line").item(ball()).item(short).texts(1), ["{0;0}: {3, 0, 4}"]);
        let old = Trial::of_guid("ff880808-6daf-4f6c-88c1-058120ad6ba9").item(ball()).item(line).item(true);
        assert_eq!(old.texts(1), ["{0;0}: {3, 0, -4}"]);
        let limited = Trial::of("Brep | Line").item(ball()).item(line).setting("LimitToFirst", true);
        assert_eq!(limited.texts(1), ["{0;0}: {3, 0, -4}"]);
        let side = Interval::new(0.0, 2.0);
        let flat: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let along = Line::new(p(-1.0, 1.0, 0.0), p(1.5, 1.0, 0.0));
        let stretch = Trial::of("Surface | Line").item(flat).item(along).run().outputs;
        let length = Trial::of_guid("c75b62fa-0a33-4da7-a5bd-03fd0068fd93").tree(stretch[0].clone());
        assert_eq!(length.texts(0), ["{0;0}: 1.5"]);
    }

    #[test]
    fn curves_through_surfaces() {
        let circle = Circle { plane: Plane::XZ.with_origin(p(5.0, 0.0, 0.0)), radius: 5.0 };
        let met = Trial::of("Surface | Curve").item(ball()).item(circle).run().outputs;
        assert_eq!(met.iter().map(|o| o.item_count()).collect::<Vec<_>>(), [0, 2, 2, 2, 2, 2]);
        assert_eq!(texts(&met[1]), ["{0;0}: {2.5, 0, 4.330127}, {2.5, 0, -4.330127}"]);
        let brep = Trial::of("Brep | Curve").item(ball()).item(circle);
        assert_eq!(brep.texts(1), ["{0;0}: {2.5, 0, 4.330127}, {2.5, 0, -4.330127}"]);
    }

    #[test]
    fn curves_through_meshes() {
        let side = Interval::new(0.0, 2.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 2, 2, 2).unwrap();
        let line = Line::new(p(-1.0, 0.7, 0.6), p(5.0, 0.7, 0.6));
        let met = Trial::of("Mesh | Curve").item(cube.clone()).item(line).run().outputs;
        assert_eq!(texts(&met[0]), ["{0;0}: {0, 0.7, 0.6}, {2, 0.7, 0.6}"]);
        assert_eq!(met[1].item_count(), 2);
        // A corner of the curve on a face counts once.
        let bent = [p(-1.0, 0.7, 0.6), p(0.0, 0.7, 0.6), p(1.0, 0.7, 0.6)].to_vec();
        let bent = Curve::from(PolylineCurve::new(bent).unwrap());
        assert_eq!(
            Trial::of("Mesh | Curve").item(cube.clone()).item(bent).texts(0),
            ["{0;0}: {0, 0.7, 0.6}"]
        );
        let circle = Circle { plane: Plane::XY.with_origin(p(0.0, 0.3, 1.3)), radius: 1.0 };
        assert_eq!(Trial::of("Mesh | Curve").item(cube).item(circle).run().outputs[0].item_count(), 2);
    }
}
