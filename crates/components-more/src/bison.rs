//! Bison: terrains as meshes: slopes, elevations, aspects, cut and fill, contours, and edits.
//!
//! Names and ports are facts from a public list of its components; ids are our own, so that objects are found by name. Colours are our
//! own, and tags come as texts, not as lettering.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_data::Colour;
use katydid_elementary::Elementary as _;
use katydid_geometry::{Containment, Curve, Interval, Mesh, MeshTree, Plane, Point3, PolylineCurve, Vector3};

/// The colours from the least value to the most: blue, green, yellow, red.
const RAMP: [[u8; 3]; 4] = [[49, 104, 189], [81, 174, 91], [245, 214, 73], [205, 55, 44]];
/// How many colours a legend has.
const LEGEND: usize = 10;
/// The most places of a grid that is looked at.
const MOST_PLACES: f64 = 2e7;
/// Every so many contours is a major one: that is our reading.
const MAJOR: i64 = 5;
/// The most contours.
const MOST_CONTOURS: f64 = 100_000.0;
/// Beyond it contours cannot be counted: doubles have no whole numbers one apart.
const COUNTABLE: f64 = 9_007_199_254_740_992.0;
/// A unit normal that rises by less is one of a wall: no per cent tells its slope, and the largest of use stands for it.
const WALL: f64 = 1e-9;
/// The slope of a wall, in per cent.
const WALL_SLOPE: f64 = 1e9;

/// The colour of a share from 0 to 1.
fn ramp(share: f64) -> [u8; 4] {
    let place = share.clamp(0.0, 1.0) * (RAMP.len() - 1) as f64;
    let first = (place as usize).min(RAMP.len() - 2);
    let t = place - first as f64;
    let mix = |k: usize| {
        let at = |i: usize| RAMP.get(i).and_then(|c| c.get(k)).map_or(0.0, |c| f64::from(*c));
        (at(first) * (1.0 - t) + at(first + 1) * t).round() as u8
    };
    [mix(0), mix(1), mix(2), 255]
}

/// A mesh coloured by a value of each vertex, the colours of a legend and its texts.
fn coloured(
    mesh: &Mesh,
    values: &[f64],
    [least, most]: [Option<f64>; 2],
    unit: &str,
) -> (Shared<Mesh>, Vec<Colour>, Vec<Shared<str>>) {
    let low = least.unwrap_or_else(|| values.iter().copied().fold(f64::INFINITY, f64::min));
    let high = most.unwrap_or_else(|| values.iter().copied().fold(f64::NEG_INFINITY, f64::max));
    let share = |x: f64| if high > low { (x - low) / (high - low) } else { 0.0 };
    let colours: Vec<[u8; 4]> = values.iter().map(|x| ramp(share(*x))).collect();
    let steps = (0..LEGEND).map(|i| i as f64 / (LEGEND - 1) as f64);
    let legend = steps.clone().map(|t| {
        let [r, g, b, a] = ramp(t);
        Colour::argb(a, r, g, b)
    });
    let tags = steps.map(|t| Shared::from(format!("{:.2}{unit}", low + (high - low) * t)));
    (Shared::new(mesh.with_colours(&colours)), legend.collect(), tags.collect())
}

/// The slope of a normal in per cent: 100 is 45 degrees.
fn per_cent(normal: Vector3) -> f64 {
    let (flat, up) = (normal.x.hypotenuse(normal.y), normal.z.abs());
    if up > WALL { flat / up * 100.0 } else { WALL_SLOPE }
}

/// Colours a mesh by its slope. Stands for Bison's Slope.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f5001", name = "Slope", nick = "Slope", at = "Bison/Analysis")]
#[output("Mesh", "Mesh", "The mesh with colours.", kind = Mesh)]
#[output("Colors", "Colors", "The colours of a legend, from the least to the most.")]
#[output("Tags", "Tags", "Its texts.")]
#[output("Slope", "Slope", "The slope at each vertex, in per cent.")]
fn slope(
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The slope of the first colour, in per cent; the least when nothing is given.
    #[port("Min", "Min", optional)]
    least: Option<f64>,
    /// The slope of the last colour; the most when nothing is given.
    #[port("Max", "Max", optional)]
    most: Option<f64>,
) -> (Shared<Mesh>, Vec<Colour>, Vec<Shared<str>>, Vec<f64>) {
    let values: Vec<f64> = mesh.vertex_normals().into_iter().map(per_cent).collect();
    let (mesh, colours, tags) = coloured(mesh, &values, [least, most], "%");
    (mesh, colours, tags, values)
}

/// Colours a mesh by its height. Stands for Bison's Elev.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f5002", name = "Elev", nick = "Elev", at = "Bison/Analysis")]
#[output("Mesh", "Mesh", "The mesh with colours.", kind = Mesh)]
#[output("Colors", "Colors", "The colours of a legend, from the least to the most.")]
#[output("Tags", "Tags", "Its texts.")]
fn elevation(
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The height of the first colour; the least when nothing is given.
    #[port("Min", "Min", optional)]
    least: Option<f64>,
    /// The height of the last colour; the most when nothing is given.
    #[port("Max", "Max", optional)]
    most: Option<f64>,
) -> (Shared<Mesh>, Vec<Colour>, Vec<Shared<str>>) {
    let values: Vec<f64> = mesh.vertices().iter().map(|p| p.z).collect();
    coloured(mesh, &values, [least, most], "")
}

/// Colours a mesh by how far its slopes look away from a direction. Stands for Bison's Aspect; that angles go from x against the clock
/// is our reading.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f5003", name = "Aspect", nick = "Aspect", at = "Bison/Analysis")]
#[output("Mesh", "Mesh", "The mesh with colours.", kind = Mesh)]
#[output("Colors", "Colors", "The colours of a legend, from the least to the most.")]
#[output("Tags", "Tags", "Its texts.")]
#[output(
    "Aspect",
    "Aspect",
    "The angle from the direction at each vertex, 0 to 180 degrees; 0 where it is flat."
)]
fn aspect(
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The direction, in degrees.
    #[port("Angle", "Angle", default = 0.0)]
    angle: f64,
) -> (Shared<Mesh>, Vec<Colour>, Vec<Shared<str>>, Vec<f64>) {
    let (sin, cos) = angle.to_radians().sine_cosine();
    let towards = Vector3::new(cos, sin, 0.0);
    let look = |n: Vector3| {
        // What faces down looks as what faces up.
        let flat = Vector3::new(n.x, n.y, 0.0) * if n.z < 0.0 { -1.0 } else { 1.0 };
        flat.angle_to(towards).map_or(0.0, f64::to_degrees)
    };
    let values: Vec<f64> = mesh.vertex_normals().into_iter().map(look).collect();
    let (mesh, colours, tags) = coloured(mesh, &values, [Some(0.0), Some(180.0)], "°");
    (mesh, colours, tags, values)
}

/// The highest place of a mesh above or below a place seen from above.
fn height(tree: &MeshTree, x: f64, y: f64) -> Option<f64> {
    let all = [f64::NEG_INFINITY, f64::INFINITY];
    let hits = tree.line_hits(Point3::new(x, y, 0.0), Vector3::Z, all).ok()?;
    hits.into_iter().map(|hit| hit.point.z).reduce(f64::max)
}

/// The volumes between two terrains inside a curve, from heights at the middles of the cells of a grid. Stands for Bison's CutFill.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f5004",
    name = "CutFill",
    nick = "CutFill",
    at = "Bison/Analysis"
)]
#[output("Mesh", "Mesh", "The proposed mesh: cut is red, fill is green.")]
#[output("Total", "Total", "What is filled less what is cut.")]
#[output("Cut", "Cut", "The volume that is cut.")]
#[output("Fill", "Fill", "The volume that is filled.")]
#[output("Units", "Units", "The unit of the volumes.")]
fn cut_fill(
    context: &Context<'_>,
    /// A flat closed curve, seen from above.
    #[port("Boundary", "Boundary")]
    boundary: &Curve,
    /// The proposed terrain.
    #[port("Proposed", "Proposed")]
    proposed: &Mesh,
    /// The terrain that is there.
    #[port("Existing", "Existing")]
    existing: &Mesh,
    /// The size of a cell of the grid, in units.
    #[port("Grid", "Grid", default = 1.0)]
    cell: f64,
) -> Result<(Shared<Mesh>, f64, f64, f64, Shared<str>), Message> {
    if !(cell > 0.0 && cell.is_finite()) {
        return Err(Message::error("The size of a cell must be greater than 0"));
    }
    let flat = boundary.transformed(&katydid_geometry::Xform::planar_projection(&Plane::XY))?;
    let bounds = flat.bounding_box();
    let size = bounds.diagonal();
    let (columns, rows) = ((size.x / cell).ceil(), (size.y / cell).ceil());
    if !(columns * rows <= MOST_PLACES) {
        return Err(Message::error("The cells are too small for the boundary"));
    }
    let (new, old) = (MeshTree::new(proposed), MeshTree::new(existing));
    let tolerance = context.tolerance();
    let (mut cut, mut fill, mut missed) = (0.0, 0.0, 0_usize);
    // Cells fill the box whole, so that the areas add up to it.
    let (dx, dy) = (size.x / columns.max(1.0), size.y / rows.max(1.0));
    for i in 0..columns as usize {
        context.check()?;
        for j in 0..rows as usize {
            let (x, y) = (bounds.min.x + (i as f64 + 0.5) * dx, bounds.min.y + (j as f64 + 0.5) * dy);
            if flat.contains_in_plane(Point3::new(x, y, 0.0), &Plane::XY, tolerance.absolute)?
                == Containment::Outside
            {
                continue;
            }
            match (height(&new, x, y), height(&old, x, y)) {
                (Some(a), Some(b)) if a < b => cut += (b - a) * dx * dy,
                (Some(a), Some(b)) => fill += (a - b) * dx * dy,
                _ => missed += 1,
            }
        }
    }
    if missed > 0 {
        context.warn(format!("{missed} cells of the grid lie beside one of the meshes: they do not count"));
    }
    let colour = |p: &Point3| match height(&old, p.x, p.y) {
        Some(z) if p.z < z => [205, 55, 44, 255],
        Some(z) if p.z > z => [81, 174, 91, 255],
        _ => [200, 200, 200, 255],
    };
    let colours: Vec<[u8; 4]> = proposed.vertices().iter().map(colour).collect();
    let mesh = Shared::new(proposed.with_colours(&colours));
    Ok((mesh, fill - cut, cut, fill, Shared::from("cubic units")))
}

/// Contours of a terrain; every fifth counts as major, which is our reading, and tags are not drawn. Stands for Bison's Contour.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f5005", name = "Contour", nick = "Contour", at = "Bison/Anno")]
#[output("Major", "Major", "The major contours.", kind = Curve)]
#[output("Minor", "Minor", "The other contours.", kind = Curve)]
fn contour(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The height between contours, in units.
    #[port("Interval", "Interval", default = 1.0)]
    interval: f64,
    /// The size of tags, which are not drawn.
    #[port("Height", "Height", optional)]
    _size: Option<f64>,
    /// The distance of tags, which are not drawn.
    #[port("Tags", "Tags", optional)]
    _distance: Option<f64>,
) -> Result<(Vec<Shared<Curve>>, Vec<Shared<Curve>>), Message> {
    if !(interval > 0.0 && interval.is_finite()) {
        return Err(Message::error("The interval must be greater than 0"));
    }
    let Some(bounds) = mesh.bounding_box() else { return Ok((Vec::new(), Vec::new())) };
    let range = Interval::new((bounds.min.z / interval).ceil(), (bounds.max.z / interval).floor());
    if !(range.end - range.start <= MOST_CONTOURS && range.end.abs() < COUNTABLE) {
        return Err(Message::error("The interval is too small for the mesh"));
    }
    let (mut major, mut minor) = (Vec::new(), Vec::new());
    let mut number = range.start as i64;
    while number as f64 <= range.end {
        context.check()?;
        let plane = Plane::XY.with_origin(Point3::new(0.0, 0.0, number as f64 * interval));
        let lines = mesh.section(&plane)?;
        context.items(lines.len())?;
        let curves = lines.into_iter().filter_map(|points| PolylineCurve::new(points).ok()).map(Curve::from);
        let curves = curves.map(Shared::new);
        if number.rem_euclid(MAJOR) == 0 {
            major.extend(curves)
        } else {
            minor.extend(curves)
        }
        number += 1;
    }
    Ok((major, minor))
}

/// The heights of a terrain at points, as texts with their places. Stands for Bison's Spot Elevation; lettering is not drawn.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f5006",
    name = "Spot Elevation",
    nick = "Spot",
    at = "Bison/Anno"
)]
#[output("Spot", "Spot", "The points on the mesh.", kind = Point)]
#[output("Elevation", "Elevation", "Their heights as texts.", kind = Text)]
fn spot_elevation(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The points; they are moved up or down to the mesh.
    #[port("Point", "Point")]
    points: List<Point3>,
    /// The size of tags, which are not drawn.
    #[port("Height", "Height", optional)]
    _size: Option<f64>,
) -> Result<(Vec<Option<Point3>>, Vec<Option<Shared<str>>>), Message> {
    let tree = MeshTree::new(mesh);
    context.items(points.len())?;
    let found: Vec<Option<Point3>> = points
        .iter()
        .map(|p| p.and_then(|p| Some(Point3::new(p.x, p.y, height(&tree, p.x, p.y)?))))
        .collect();
    let texts = found.iter().map(|p| p.map(|p| Shared::from(format!("{:.2}", p.z)))).collect();
    Ok((found, texts))
}

/// The slope of a terrain at points, in per cent. Stands for Bison's Slope Point; the number comes, not lettering.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f5007",
    name = "Slope Point",
    nick = "SlopePt",
    at = "Bison/Anno"
)]
#[output("Slope", "Slope", "The slope of the face at each point, in per cent.")]
fn slope_point(
    /// The mesh.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The points; the nearest face counts.
    #[port("Point", "Point")]
    points: List<Point3>,
    /// The size of tags, which are not drawn.
    #[port("Height", "Height", optional)]
    _size: Option<f64>,
) -> Result<Vec<Option<f64>>, Message> {
    let (tree, normals) = (MeshTree::new(mesh), mesh.face_normals());
    points
        .iter()
        .map(|p| {
            let Some(p) = p else { return Ok(None) };
            Ok(normals.get(tree.closest(p)?.face).map(|n| per_cent(*n)))
        })
        .collect()
}

/// Brings a terrain to points, cut and filled, with a slope around each. Stands for Bison's Mesh Point; that a slope of 100 is 45 degrees
/// is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f5008",
    name = "Mesh Point",
    nick = "MeshPt",
    at = "Bison/Mesh Edit"
)]
#[output("Mesh", "Mesh", "The mesh.")]
fn mesh_point(
    /// The mesh; its vertices move up and down.
    #[port("Mesh", "Mesh")]
    mesh: &Mesh,
    /// The points.
    #[port("Point", "Point")]
    points: List<Point3>,
    /// The slope, in per cent.
    #[port("Slope", "Slope", default = 50.0)]
    slope: f64,
) -> Result<Shared<Mesh>, Message> {
    if !(slope > 0.0 && slope.is_finite()) {
        return Err(Message::error("The slope must be greater than 0"));
    }
    let points: Vec<Point3> = points.present().filter(|p| p.is_finite()).collect();
    let moved = mesh.vertices().iter().map(|v| {
        let z = points.iter().fold(v.z, |z, p| {
            let reach = (p.x - v.x).hypotenuse(p.y - v.y) * slope / 100.0;
            z.clamp(p.z - reach, p.z + reach)
        });
        Point3::new(v.x, v.y, z)
    });
    let edited =
        Mesh::from_parts(moved.collect(), mesh.faces().to_vec(), Vec::new(), mesh.colours().to_vec())?;
    Ok(Shared::new(edited.with_normals()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Curve, Interval, Mesh, Plane, Point3, Rectangle, Vector3};

    /// A mesh over 0 to 10 that rises by a share of x.
    fn ramp(rise: f64, at: f64) -> Mesh {
        let plane =
            Plane::from_axes(Point3::new(0.0, 0.0, at), Vector3::new(1.0, 0.0, rise), Vector3::Y).unwrap();
        let along = Interval::new(0.0, 10.0 * (1.0 + rise * rise).sqrt());
        Mesh::plane(&Rectangle { plane, x: along, y: Interval::new(0.0, 10.0) }, 10, 10).unwrap()
    }

    fn numbers(run: &katydid_component::Outcome, output: usize) -> Vec<f64> {
        run.outputs[output]
            .column()
            .iter()
            .map(|value| match value {
                Some(Value::Number(x)) => x,
                other => panic!("{other:?}"),
            })
            .collect()
    }

    #[test]
    fn a_ramp_has_one_slope_and_one_aspect() {
        let run = Trial::of("Slope").item(ramp(0.5, 0.0)).run();
        assert!(numbers(&run, 3).iter().all(|x| (x - 50.0).abs() < 1e-9));
        // It rises along x, so that it looks back.
        let run = Trial::of("Aspect").item(ramp(0.5, 0.0)).item(90.0).run();
        assert!(numbers(&run, 3).iter().all(|x| (x - 90.0).abs() < 1e-9));
        let point = Trial::of("Slope Point").item(ramp(0.2, 0.0)).list([Point3::new(5.0, 5.0, 0.0)]).run();
        assert!((numbers(&point, 0)[0] - 20.0).abs() < 1e-9);
    }

    #[test]
    fn cut_and_fill_are_volumes_between() {
        let side = Interval::new(0.0, 10.0);
        let frame = Rectangle { plane: Plane::XY, x: side, y: side };
        let boundary = Curve::from(frame.to_polyline().unwrap());
        let run =
            Trial::of("CutFill").item(boundary).item(ramp(1.0, -5.0)).item(ramp(0.0, 0.0)).item(0.25).run();
        // Half the square lies below, half above: 5 · 5 / 2 · 10 each.
        let found: Vec<f64> = (1..4).map(|k| numbers(&run, k)[0]).collect();
        assert!(found[0].abs() < 1e-6, "{found:?}");
        assert!((found[1] - 125.0).abs() < 0.5 && (found[2] - 125.0).abs() < 0.5, "{found:?}");
    }

    #[test]
    fn contours_stand_at_their_heights() {
        let run = Trial::of("Contour").item(ramp(1.0, 0.25)).item(1.0).run();
        // Heights 1 to 10; 5 and 10 are major.
        assert_eq!([run.outputs[0].item_count(), run.outputs[1].item_count()], [2, 8]);
    }
}
