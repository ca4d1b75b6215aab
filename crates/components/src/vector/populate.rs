//! Vector / Grid: points strewn evenly but without order.

use std::collections::HashMap;

use katydid_component::{Context, List, Message, component};
use katydid_data::{Geometry, Kind, Value, cast};
use katydid_elementary::Elementary;
use katydid_geometry::{
    ArcLength, Box3, Brep, Interval, MeshSettings, Plane, Point2, Point3, Rectangle, Vector3,
};

use super::hit;
use crate::sets::dotnet_random::DotNetRandom;

/// Points in cubes of one size, to find the nearest one.
struct Cells {
    size: f64,
    cells: HashMap<[i64; 3], Vec<Point3>>,
    all: Vec<Point3>,
}

impl Cells {
    fn new(size: f64) -> Self {
        Self { size, cells: HashMap::new(), all: Vec::new() }
    }

    fn cell(&self, p: Point3) -> [i64; 3] {
        <[f64; 3]>::from(p).map(|x| (x / self.size).floor() as i64)
    }

    fn add(&mut self, p: Point3) {
        self.cells.entry(self.cell(p)).or_default().push(p);
        self.all.push(p);
    }

    /// The distance to the nearest point; infinite when there is none.
    fn distance(&self, p: Point3) -> f64 {
        /// Beyond so many rings of cubes looking at all points is quicker.
        const RINGS: i64 = 3;
        let [x, y, z] = self.cell(p);
        let mut best = f64::INFINITY;
        for ring in 0..=RINGS {
            for i in -ring..=ring {
                for j in -ring..=ring {
                    // Inside the ring only its two ends are new.
                    let new = i.abs() == ring || j.abs() == ring;
                    let step = if new || ring == 0 { 1 } else { 2 * ring };
                    for k in (-ring..=ring).step_by(usize::try_from(step).unwrap_or(1)) {
                        let cell = [x.saturating_add(i), y.saturating_add(j), z.saturating_add(k)];
                        for q in self.cells.get(&cell).into_iter().flatten() {
                            best = best.min(q.distance_to(p));
                        }
                    }
                }
            }
            if best <= ring as f64 * self.size {
                return best;
            }
        }
        self.all.iter().map(|q| q.distance_to(p)).fold(f64::INFINITY, f64::min)
    }
}

/// Strews points one by one: of some random candidates the one farthest from all points so far is taken (D. Mitchell,
/// *Spectrally optimal sampling for distribution ray tracing*, 1991). Looking stops early when a candidate lies nearly
/// as far off as the point before did.
fn strew(
    context: &Context<'_>,
    (count, seed): (i32, i32),
    existing: impl Iterator<Item = Point3>,
    size: f64,
    mut candidate: impl FnMut(&mut DotNetRandom) -> Option<Point3>,
) -> Result<Vec<Point3>, Message> {
    let count = usize::try_from(count).map_err(|_| Message::error("The count must not be negative"))?;
    context.items(count)?;
    let mut random = DotNetRandom::new(seed);
    let mut near = Cells::new(if size > 0.0 && size.is_finite() { size } else { 1.0 });
    existing.filter(|p| p.is_finite()).for_each(|p| near.add(p));
    let mut out = Vec::new();
    let mut last = f64::INFINITY;
    for i in 0..count {
        context.check()?;
        let attempts =
            if near.all.is_empty() { 1 } else { (near.all.len() as f64).sqrt().round().max(50.0) as usize };
        let mut best: Option<(f64, Point3)> = None;
        for k in 0..attempts {
            let far = best.map_or(0.0, |b| b.0);
            let enough = (k > 100 && far > 0.9 * last)
                || (k > 50 && far > 0.92 * last)
                || (k > 25 && far > 0.95 * last);
            if enough {
                break;
            }
            context.check()?;
            let Some(p) = candidate(&mut random) else { break };
            let distance = near.distance(p);
            if best.is_none_or(|b| distance > b.0) {
                best = Some((distance, p));
            }
        }
        let Some((distance, p)) = best else { break };
        if i > 0 || distance.is_finite() {
            last = distance;
        }
        near.add(p);
        out.push(p);
    }
    Ok(out)
}

/// Strews points over a rectangle, about equally far apart. The same seed gives the same points.
#[component("e2d958e8-9f08-44f7-bf47-a684882d0b2a", name = "Populate 2D", nick = "Pop2D", at = "Vector/Grid")]
#[output("Population", "P", "The new points, in the order they were found.")]
fn populate_2d(
    context: &Context<'_>,
    /// The rectangle.
    #[port("Region", "R", default = Rectangle { plane: Plane::XY, x: Interval::new(0.0, 20.0), y: Interval::new(0.0, 10.0) })]
    region: Rectangle,
    /// The number of points, not negative.
    #[port("Count", "N", default = 100)]
    count: i32,
    /// Any whole number; another one gives other points.
    #[port("Seed", "S", default = 1)]
    seed: i32,
    /// Points to keep away from; they are not put out.
    #[port("Points", "P", optional)]
    points: List<Point3>,
) -> Result<Vec<Point3>, Message> {
    let size = (region.area().abs() / f64::from(count.max(1))).sqrt();
    strew(context, (count, seed), points.present(), size, |random| {
        let (u, v) = (random.next_double(), random.next_double());
        Some(region.plane.at(region.x.at(u), region.y.at(v), 0.0))
    })
}

/// Strews points through a box, about equally far apart. The same seed gives the same points.
#[component("e202025b-dc8e-4c51-ae19-4415b172886f", name = "Populate 3D", nick = "Pop3D", at = "Vector/Grid")]
#[output("Population", "P", "The new points, in the order they were found.")]
fn populate_3d(
    context: &Context<'_>,
    /// The box.
    #[port("Region", "R", default = Box3 { plane: Plane::XY, x: Interval::new(0.0, 10.0), y: Interval::new(0.0, 10.0), z: Interval::new(0.0, 2.0) })]
    region: Box3,
    /// The number of points, not negative.
    #[port("Count", "N", default = 100)]
    count: i32,
    /// Any whole number; another one gives other points.
    #[port("Seed", "S", default = 1)]
    seed: i32,
    /// Points to keep away from; they are not put out.
    #[port("Points", "P", optional)]
    points: List<Point3>,
) -> Result<Vec<Point3>, Message> {
    let size = (region.volume().abs() / f64::from(count.max(1))).cube_root();
    strew(context, (count, seed), points.present(), size, |random| {
        let (u, v, w) = (random.next_double(), random.next_double(), random.next_double());
        Some(region.at(u, v, w))
    })
}

/// Strews points about a guide, about equally far apart.
///
/// How the points lie about the guide is not documented: here they fill the box around it, and are the same each time.
#[component(
    "f08233f1-9772-4514-8965-bde4948503df",
    name = "Freeform Cloud",
    nick = "FFCloud",
    at = "Vector/Grid"
)]
#[output("Cloud", "C", "The points, in the order they were found.")]
fn freeform_cloud(
    context: &Context<'_>,
    /// Any geometry.
    #[port("Guide", "G")]
    guide: Geometry,
    /// The number of points, not negative.
    #[port("Number", "N", default = 100)]
    count: i32,
) -> Result<Vec<Point3>, Message> {
    let around = match cast::value(&guide.0, Kind::Box, context.rules()) {
        Some(Value::Box(around)) => around,
        _ => return Err(Message::error(format!("A {} has no box around it", guide.0.kind()))),
    };
    let sides =
        [around.x, around.y, around.z].map(|side| side.length().abs()).into_iter().filter(|side| *side > 0.0);
    let (mut extent, mut dimensions) = (1.0, 0);
    for side in sides {
        extent *= side;
        dimensions += 1;
    }
    let size = (extent / f64::from(count.max(1))).raised_to(1.0 / f64::from(dimensions.max(1)));
    let cloud = strew(context, (count, 1), std::iter::empty(), size, |random| {
        let (u, v, w) = (random.next_double(), random.next_double(), random.next_double());
        Some(around.at(u, v, w))
    })?;
    context.tell(Message::remark(
        "How the points lie about their guide is not documented: they fill its box here",
    ));
    Ok(cloud)
}

/// Strews points over a mesh, the skin of a box, or a curve, about equally far apart. The same seed gives the same points.
#[component(
    "c8cb6a5c-2ffd-4095-ba2a-5c35015e09e4",
    name = "Populate Geometry",
    nick = "PopGeo",
    at = "Vector/Grid"
)]
#[output("Population", "P", "The new points, in the order they were found.")]
fn populate_geometry(
    context: &Context<'_>,
    /// What to strew over.
    #[port("Geometry", "G")]
    geometry: Geometry,
    /// The number of points, not negative.
    #[port("Count", "N", default = 100)]
    count: i32,
    /// Any whole number; another one gives other points.
    #[port("Seed", "S", default = 1)]
    seed: i32,
    /// Points to keep away from; they are not put out.
    #[port("Points", "P", optional)]
    points: List<Point3>,
) -> Result<Vec<Point3>, Message> {
    let n = f64::from(count.max(1));
    if let (Value::Surface(_) | Value::Brep(_) | Value::Kept(_), Some(brep)) =
        (&geometry.0, geometry.0.brep())
    {
        let brep = brep.map_err(Message::warning)?;
        let sown = Sown::new(context, &brep)?;
        return strew(context, (count, seed), points.present(), (sown.total / n).sqrt(), |random| {
            sown.at([random.next_double(), random.next_double(), random.next_double()])
        });
    }
    let mesh = match &geometry.0 {
        Value::Mesh(_) | Value::Box(_) => cast::value(&geometry.0, Kind::Mesh, context.rules()),
        _ => None,
    };
    if let Some(Value::Mesh(mesh)) = mesh {
        // Areas added up, so that a number picks a triangle as often as it is large.
        let mut total = 0.0;
        let triangles: Vec<(f64, [Point3; 3])> = hit::triangles(&mesh)
            .map(|t| {
                let [a, b, c] = t;
                total += 0.5 * (b - a).cross(c - a).length();
                (total, t)
            })
            .collect();
        return strew(context, (count, seed), points.present(), (total / n).sqrt(), |random| {
            let at = random.next_double() * total;
            let (u, v) = (random.next_double(), random.next_double());
            let (_, [a, b, c]) =
                triangles.get(triangles.partition_point(|t| t.0 <= at)).or(triangles.last())?;
            let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
            let (x, y): (Vector3, Vector3) = (*b - *a, *c - *a);
            Some(*a + x * u + y * v)
        });
    }
    let Some(Value::Curve(curve)) = cast::value(&geometry.0, Kind::Curve, context.rules()) else {
        return Err(Message::error(format!("A {} cannot be populated yet", geometry.0.kind())));
    };
    let lengths = ArcLength::new(&curve);
    let total = lengths.total();
    strew(context, (count, seed), points.present(), total / n, |random| {
        Some(curve.point_at(lengths.parameter_at(random.next_double() * total)))
    })
}

/// A triangle of a face in its parameters, and the areas of all up to it.
type Patch = (f64, usize, [Point2; 3]);

/// A Brep as triangles, from which points are picked by area.
struct Sown<'a> {
    brep: &'a Brep,
    patches: Vec<Patch>,
    total: f64,
}

impl<'a> Sown<'a> {
    /// How fine the triangles are, in parts of the size.
    const FINE: f64 = 1e-3;

    fn new(context: &Context<'_>, brep: &'a Brep) -> Result<Self, Message> {
        let size = brep.bounds_of_faces().map_or(1.0, |b| b.diagonal().length());
        let mesh = brep.mesh_unless(&MeshSettings::within(Self::FINE * size), &context.stop())?;
        let (mut patches, mut total) = (Vec::new(), 0.0);
        for face in mesh.faces() {
            for [a, b, c] in face.faces.iter().flat_map(|f| f.triangles()) {
                let place = |i: u32| {
                    let point = face.places.get(i as usize).and_then(|p| mesh.points().get(*p as usize));
                    Some((*point?, *face.parameters.get(i as usize)?))
                };
                let (Some(a), Some(b), Some(c)) = (place(a), place(b), place(c)) else { continue };
                total += 0.5 * (b.0 - a.0).cross(c.0 - a.0).length();
                patches.push((total, face.face, [a.1, b.1, c.1]));
            }
        }
        Ok(Self { brep, patches, total })
    }

    /// The point on a face for three numbers from 0 to 1.
    fn at(&self, [pick, u, v]: [f64; 3]) -> Option<Point3> {
        let at = pick * self.total;
        let found = self.patches.get(self.patches.partition_point(|t| t.0 <= at)).or(self.patches.last())?;
        let (_, face, [a, b, c]) = found;
        let (s, t) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
        let mix = |a: f64, b: f64, c: f64| a + (b - a) * s + (c - a) * t;
        Some(self.brep.face_surface(*face)?.point_at(mix(a.x, b.x, c.x), mix(a.y, b.y, c.y)))
    }
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Box3, Circle, Interval, Plane, Point3};

    fn points(trial: Trial) -> Vec<Point3> {
        let column = trial.run().outputs[0].column().clone();
        column.iter().filter_map(|v| if let Some(Value::Point(p)) = v { Some(p) } else { None }).collect()
    }

    fn closest_pair(points: &[Point3]) -> f64 {
        let pairs =
            points.iter().enumerate().flat_map(|(i, p)| points[..i].iter().map(move |q| p.distance_to(*q)));
        pairs.fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn rectangles_and_boxes_fill_evenly() {
        let flat = points(Trial::of("Populate 2D"));
        assert_eq!(flat.len(), 100);
        assert!(
            flat.iter().all(|p| (0.0..=20.0).contains(&p.x) && (0.0..=10.0).contains(&p.y) && p.z == 0.0)
        );
        // Points thrown without care lie nearer than a tenth of the even spacing, 1.4.
        assert!(closest_pair(&flat) > 0.6);
        assert_eq!(flat, points(Trial::of("Populate 2D")));
        assert_ne!(flat, points(Trial::of("Populate 2D").default().item(100).item(2)));
        let solid = points(Trial::of("Populate 3D").default().item(50));
        assert!(closest_pair(&solid) > 0.6);
        assert!(solid.iter().any(|p| p.z > 1.0));
    }

    #[test]
    fn existing_points_keep_others_away() {
        let there = flat_grid();
        let new = points(Trial::of("Populate 2D").default().item(5).item(1).list(there.clone()));
        assert_eq!(new.len(), 5);
        assert!(new.iter().all(|p| there.iter().all(|q| p.distance_to(*q) > 0.5)));
        assert!(Trial::of("Populate 2D").default().item(-1).message().contains("negative"));
        assert_eq!(texts(&Trial::of("Populate 2D").default().item(0).run().outputs[0]), ["{0;0}:"]);
    }

    fn flat_grid() -> Vec<Point3> {
        (0..50).map(|i| Point3::new(f64::from(i % 10) * 2.0, f64::from(i / 10) * 2.0, 0.0)).collect()
    }

    #[test]
    fn a_cloud_fills_the_box_of_its_guide() {
        let circle = Circle { plane: Plane::XY, radius: 2.0 };
        let cloud = points(Trial::of("Freeform Cloud").item(circle).item(30));
        assert_eq!(cloud.len(), 30);
        assert!(cloud.iter().all(|p| p.x.abs() <= 2.0 && p.y.abs() <= 2.0 && p.z.abs() < 1e-12));
        assert!(Trial::of("Freeform Cloud").item(circle).item(-1).message().contains("negative"));
    }

    #[test]
    fn curves_and_skins() {
        let circle = Circle { plane: Plane::XY, radius: 2.0 };
        let around = points(Trial::of("Populate Geometry").item(circle).item(20));
        assert!(around.iter().all(|p| (p.distance_to(Point3::ORIGIN) - 2.0).abs() < 1e-9));
        let unit = Interval::UNIT;
        let skin = points(
            Trial::of("Populate Geometry")
                .item(Box3 { plane: Plane::XY, x: unit, y: unit, z: unit })
                .item(20),
        );
        assert!(
            skin.iter().all(|p| [p.x, p.y, p.z].iter().any(|c| c.abs() < 1e-12 || (c - 1.0).abs() < 1e-12))
        );
        assert!(
            Trial::of("Populate Geometry").item(Point3::ORIGIN).message().contains("cannot be populated")
        );
    }
}
