//! Vector / Point: points among points and other geometry.

use katydid_component::{Context, ItemOrList, List, Message, component};
use katydid_data::{Geometry, Path, Tree, TreeBuilder, Value};
use katydid_geometry::{Curve, Point3, Vector3};

use super::hit;
use super::near::ByX;
use crate::prepared;

/// Where a tree output of this iteration begins: the branch's path and the number of the iteration.
fn place(context: &Context<'_>) -> Path {
    context.path().child(context.iteration())
}

/// A place in a list as a number of 32 bits.
fn index(i: usize) -> i32 {
    i32::try_from(i).unwrap_or(i32::MAX)
}

/// The point of a cloud nearest to a point; of equally near ones the first.
///
/// A cloud without points is an error. Nulls in it are skipped.
#[component("571ca323-6e55-425a-bf9e-ee103c7ba4b9", name = "Closest Point", nick = "CP", at = "Vector/Point")]
#[output("Closest Point", "P", "The nearest point.")]
#[output("CP Index", "i", "Its place in the cloud.")]
#[output("Distance", "D", "The distance to it.")]
fn closest_point(
    context: &Context<'_>,
    /// The point to start from.
    #[port("Point", "P")]
    point: Point3,
    /// The points to choose from.
    #[port("Cloud", "C")]
    cloud: List<Point3>,
) -> Result<(Point3, i32, f64), Message> {
    if let Some(tree) = prepared::cloud(context, &cloud, Some)?.filter(|_| point.is_finite()) {
        let found = tree.closest(point).and_then(|i| Some((i, cloud.get(i)?)));
        let (i, q) = found.ok_or_else(|| Message::error("The cloud has no points"))?;
        return Ok((q, index(i), q.distance_to(point)));
    }
    let squared = |q: Point3| (q - point).length_squared();
    let mut best: Option<(usize, Point3, f64)> = None;
    for (i, q) in cloud.iter().enumerate() {
        let Some(q) = q else { continue };
        let d = squared(q);
        if best.is_none_or(|(_, _, least)| d < least) {
            best = Some((i, q, d));
        }
    }
    let (i, q, _) = best.ok_or_else(|| Message::error("The cloud has no points"))?;
    Ok((q, index(i), q.distance_to(point)))
}

/// A search for more nearest points than this sorts them all.
const MOST_NEAREST: usize = 64;

/// The points of a cloud nearest to a point, the nearest first.
///
/// A count larger than the cloud gives all of it. Nulls in the cloud are skipped.
#[component(
    "446014c4-c11c-45a7-8839-c45dc60950d6",
    name = "Closest Points",
    nick = "CPs",
    at = "Vector/Point"
)]
#[output("Closest Point", "P", "The nearest points.")]
#[output("CP Index", "i", "Their places in the cloud.")]
#[output("Distance", "D", "The distances to them.")]
fn closest_points(
    context: &Context<'_>,
    /// The point to start from.
    #[port("Point", "P")]
    point: Point3,
    /// The points to choose from.
    #[port("Cloud", "C")]
    cloud: List<Point3>,
    /// How many to give; not negative.
    #[port("Count", "N", default = 3)]
    count: i32,
) -> Result<(Vec<Point3>, Vec<i32>, Vec<f64>), Message> {
    let count = usize::try_from(count).map_err(|_| Message::error("The count must not be negative"))?;
    let tree = if count <= MOST_NEAREST { prepared::cloud(context, &cloud, Some)? } else { None };
    if let Some(tree) = tree.filter(|_| point.is_finite()) {
        let found = tree.nearest(point, count).into_iter();
        let found: Vec<(usize, Point3)> = found.filter_map(|i| Some((i, cloud.get(i)?))).collect();
        return Ok((
            found.iter().map(|f| f.1).collect(),
            found.iter().map(|f| index(f.0)).collect(),
            found.iter().map(|f| f.1.distance_to(point)).collect(),
        ));
    }
    let mut all: Vec<(f64, usize, Point3)> =
        cloud.iter().enumerate().filter_map(|(i, q)| q.map(|q| (q.distance_to(point), i, q))).collect();
    context.check()?;
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.truncate(count);
    Ok((
        all.iter().map(|a| a.2).collect(),
        all.iter().map(|a| index(a.1)).collect(),
        all.iter().map(|a| a.0).collect(),
    ))
}

/// The nearest point on any of several pieces of geometry.
///
/// Works with points, planes, curves, Breps, meshes and boxes (on their skin). Nulls are skipped. The object's menu can
/// switch off that only the closest one counts: then every piece has its nearest point and its distance, in the order of
/// the list, with nulls for nulls, and every point has a branch of its own.
#[component("902289da-28dc-454b-98d4-b8f8aa234516", name = "Pull Point", nick = "Pull", at = "Vector/Point")]
#[output("Closest Point", "P", "The nearest point; nothing without geometry.")]
#[output("Distance", "D", "The distance to it.")]
fn pull_point(
    context: &Context<'_>,
    /// The point to pull.
    #[port("Point", "P")]
    point: Point3,
    /// What to pull it to.
    #[port("Geometry", "G")]
    geometry: List<Geometry>,
) -> Result<(ItemOrList<Point3>, ItemOrList<f64>), Message> {
    pulled(context, point, &geometry, context.settings().bool("ClosestOnly").unwrap_or(true))
}

/// A point pulled: where it comes to, and how far that is.
type Pulled = (ItemOrList<Point3>, ItemOrList<f64>);

/// The nearest point of all pieces of geometry, or of each.
fn pulled(
    context: &Context<'_>,
    point: Point3,
    geometry: &List<'_, Geometry>,
    closest_only: bool,
) -> Result<Pulled, Message> {
    if closest_only {
        let (place, distance) = nearest(context, point, geometry)?;
        return Ok((ItemOrList::Item(place), ItemOrList::Item(distance)));
    }
    let mut places = Vec::with_capacity(geometry.len());
    for piece in geometry.iter() {
        context.check()?;
        places.push(match piece {
            Some(piece) => hit::closest(context, &piece.0, point)?,
            None => None,
        });
    }
    let distances = places.iter().map(|q| q.map(|q| q.distance_to(point))).collect();
    Ok((ItemOrList::List(places), ItemOrList::List(distances)))
}

/// The nearest point of several pieces of geometry and its distance.
fn nearest(
    context: &Context<'_>,
    point: Point3,
    geometry: &List<'_, Geometry>,
) -> Result<(Option<Point3>, Option<f64>), Message> {
    if let Some(points) = geometry.slice_of::<Point3>().filter(|_| point.is_finite()) {
        let of = |piece: Geometry| match piece.0 {
            Value::Point(p) => Some(p),
            _ => None,
        };
        if let Some(tree) = prepared::cloud(context, geometry, of)? {
            let found = tree.closest(point).and_then(|i| points.get(i).copied());
            return Ok((found, found.map(|q| q.distance_to(point))));
        }
    }
    let mut best: Option<(f64, Point3)> = None;
    for piece in geometry.present() {
        if let Some(q) = hit::closest(context, &piece.0, point)? {
            let d = q.distance_to(point);
            if best.is_none_or(|(least, _)| d < least) {
                best = Some((d, q));
            }
        }
    }
    Ok((best.map(|b| b.1), best.map(|b| b.0)))
}

/// The nearest point on any of several pieces of geometry. An early form of the component of the same name.
#[component(
    "cf3a0865-4882-46bd-91a1-d512acf95be4",
    name = "Pull Point",
    nick = "Pull",
    at = "Vector/Point",
    old
)]
#[output("Closest Point", "P", "The nearest point; nothing without geometry.")]
#[output("Distance", "D", "The distance to it.")]
fn early_pull_point(
    context: &Context<'_>,
    /// The point to pull.
    #[port("Point", "P")]
    point: Point3,
    /// What to pull it to.
    #[port("Geometry", "G")]
    geometry: List<Geometry>,
    /// Whether only the nearest piece of geometry counts; else each has its own nearest point.
    #[port("Closest", "C", default = true)]
    closest: bool,
) -> Result<(ItemOrList<Point3>, ItemOrList<f64>), Message> {
    pulled(context, point, &geometry, closest)
}

/// Follows a direction from a point to the first geometry that it meets.
///
/// Where nothing lies ahead, what lies behind is taken. Works with Breps, meshes, boxes and planes.
#[component(
    "5184b8cb-b71e-4def-a590-cd2c9bc58906",
    name = "Project Point",
    nick = "Project",
    at = "Vector/Point"
)]
#[output("Point", "P", "The point met; nothing when there is none.")]
#[output("Index", "I", "The place of the geometry met in its list, -1 when there is none.")]
fn project_point(
    /// The point to project.
    #[port("Point", "P")]
    point: Point3,
    /// Where to look; not zero.
    #[port("Direction", "D", default = Vector3::new(0.0, 0.0, -1.0))]
    direction: Vector3,
    /// What to project to.
    #[port("Geometry", "G")]
    geometry: List<Geometry>,
) -> Result<(Option<Point3>, i32), Message> {
    let unit = direction.unitized().ok_or_else(|| Message::error("The direction has length 0"))?;
    // Ahead comes before behind, near before far.
    let rank = |t: f64| (t < 0.0, t.abs());
    let mut best: Option<(f64, usize)> = None;
    for (i, piece) in geometry.iter().enumerate() {
        let Some(piece) = piece else { continue };
        for t in hit::along(&piece.0, point, unit)? {
            if best.is_none_or(|(least, _)| rank(t) < rank(least)) {
                best = Some((t, i));
            }
        }
    }
    Ok((best.map(|(t, _)| point + unit * t), best.map_or(-1, |(_, i)| index(i))))
}

/// Thins out points that lie near each other. The object's menu chooses how: the first of a clump stays, all of
/// them go, or their mean takes their place (as when nothing is chosen).
///
/// In order of the list, each point not yet in a clump gathers all others within the tolerance that are in none.
#[component(
    "6eaffbb2-3392-441a-8556-2dc126aa8910",
    name = "Cull Duplicates",
    nick = "CullPt",
    at = "Vector/Point"
)]
#[output("Points", "P", "The points left.")]
#[output("Indices", "I", "Where each was in the list; -1 for the mean of a clump.")]
#[output("Valence", "V", "How many points each stands for.")]
fn cull_duplicates(
    context: &Context<'_>,
    /// The points; nulls are skipped.
    #[port("Points", "P")]
    points: List<Point3>,
    /// Points at most this far apart count as the same; not negative.
    #[port("Tolerance", "T", default = 0.1)]
    tolerance: f64,
) -> Result<(Vec<Point3>, Vec<i32>, Vec<i32>), Message> {
    if !(tolerance >= 0.0) {
        return Err(Message::error("The tolerance must not be negative"));
    }
    let (places, list): (Vec<usize>, Vec<Point3>) =
        points.iter().enumerate().filter_map(|(i, p)| p.map(|p| (i, p))).unzip();
    let near = ByX::new(&list);
    let mut taken = vec![false; list.len()];
    let (mut out, mut indices, mut valence) = (Vec::new(), Vec::new(), Vec::new());
    let mode = context.settings().i32("CullMode").unwrap_or(3);
    for (i, (&p, &place)) in list.iter().zip(&places).enumerate() {
        if taken.get(i).copied().unwrap_or(true) {
            continue;
        }
        context.check()?;
        let mut clump: Vec<usize> =
            near.within(p, tolerance).filter(|&j| taken.get(j) == Some(&false)).collect();
        clump.sort_unstable();
        for &j in &clump {
            if let Some(t) = taken.get_mut(j) {
                *t = true;
            }
        }
        if mode == 2 && clump.len() > 1 {
            continue;
        }
        let average = mode == 3 && clump.len() > 1;
        out.push(if average { mean(clump.iter().filter_map(|&j| list.get(j).copied())) } else { p });
        indices.push(if average { -1 } else { index(place) });
        valence.push(index(clump.len()));
    }
    Ok((out, indices, valence))
}

/// The mean of points, of which there is at least one.
fn mean(points: impl Iterator<Item = Point3>) -> Point3 {
    let (mut sum, mut count) = (Vector3::ZERO, 0.0);
    for p in points {
        sum += p.to_vector();
        count += 1.0;
    }
    (sum / count).to_point()
}

/// Sorts points into groups: two points are in one group when steps of at most a distance lead from one to the other.
#[component(
    "81f6afc9-22d9-49f0-8579-1fd7e0df6fa6",
    name = "Point Groups",
    nick = "PGroups",
    at = "Vector/Point"
)]
#[output("Groups", "G", "The groups, a branch each, in order of their first members.", kind = Point)]
#[output("Indices", "I", "The places of the members in the list, a branch a group.", kind = Integer)]
fn point_groups(
    context: &Context<'_>,
    /// The points; nulls are skipped.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The longest step; not negative.
    #[port("Distance", "D")]
    distance: f64,
) -> Result<(Tree, Tree), Message> {
    if !(distance >= 0.0) {
        return Err(Message::error("The distance must not be negative"));
    }
    let (places, list): (Vec<usize>, Vec<Point3>) =
        points.iter().enumerate().filter_map(|(i, p)| p.map(|p| (i, p))).unzip();
    let near = ByX::new(&list);
    let mut group: Vec<Option<usize>> = vec![None; list.len()];
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for first in 0..list.len() {
        if group.get(first).is_none_or(Option::is_some) {
            continue;
        }
        context.check()?;
        let mut members = vec![first];
        let mut next = 0;
        if let Some(g) = group.get_mut(first) {
            *g = Some(groups.len());
        }
        while let Some(&i) = members.get(next) {
            context.check()?;
            next += 1;
            let Some(&p) = list.get(i) else { continue };
            for j in near.within(p, distance) {
                if let Some(g @ None) = group.get_mut(j) {
                    *g = Some(groups.len());
                    members.push(j);
                }
            }
        }
        members.sort_unstable();
        groups.push(members);
    }
    let (mut points, mut indices) = (TreeBuilder::<Point3>::new(), TreeBuilder::<i32>::new());
    for (k, members) in groups.iter().enumerate() {
        let path = place(context).child(k);
        points.branch(path.clone());
        indices.branch(path);
        for &j in members {
            points.push(list.get(j).copied());
            indices.push(places.get(j).copied().map(index));
        }
    }
    Ok((points.finish(), indices.finish()))
}

/// Sorts points by x, those of equal x by y, then by z. Coordinates are compared exactly; nulls are left out.
#[component(
    "4e86ba36-05e2-4cc0-a0f5-3ad57c91f04e",
    name = "Sort Points",
    nick = "Sort Pt",
    at = "Vector/Point"
)]
#[output("Points", "P", "The points in order.")]
#[output("Indices", "I", "Where each was in the list.")]
fn sort_points(
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> (Vec<Point3>, Vec<i32>) {
    let mut all: Vec<(usize, Point3)> =
        points.iter().enumerate().filter_map(|(i, p)| p.map(|p| (i, p))).collect();
    all.sort_by(|(_, a), (_, b)| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)).then(a.z.total_cmp(&b.z)));
    (all.iter().map(|a| a.1).collect(), all.iter().map(|a| index(a.0)).collect())
}

/// Sorts points by the place on a curve that each is nearest to, from its start to its end. Nulls are left out.
#[component(
    "59aaebf8-6654-46b7-8386-89223c773978",
    name = "Sort Along Curve",
    nick = "AlongCrv",
    at = "Vector/Point"
)]
#[output("Points", "P", "The points in order.")]
#[output("Indices", "I", "Where each was in the list.")]
fn sort_along_curve(
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The curve that gives the order.
    #[port("Curve", "C")]
    curve: &Curve,
) -> Result<(Vec<Point3>, Vec<i32>), Message> {
    let mut all = Vec::with_capacity(points.len());
    for (i, p) in points.iter().enumerate() {
        if let Some(p) = p {
            all.push((curve.closest_point(p)?.parameter, i, p));
        }
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok((all.iter().map(|a| a.2).collect(), all.iter().map(|a| index(a.1)).collect()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Circle, Interval, Line, Mesh, MeshFace, Plane, Point3, Vector3};

    fn row(xs: &[f64]) -> Vec<Point3> {
        xs.iter().map(|&x| Point3::new(x, 0.0, 0.0)).collect()
    }

    #[test]
    fn nearest_points() {
        let trial = |name| Trial::of(name).item(Point3::ORIGIN).list(row(&[3.0, -1.0, 1.0]));
        assert_eq!(trial("Closest Point").texts(1), ["{0}: 1"]);
        assert_eq!(trial("Closest Point").texts(2), ["{0}: 1"]);
        assert_eq!(trial("Closest Points").item(2).texts(1), ["{0;0}: 1, 2"]);
        assert_eq!(trial("Closest Points").item(9).texts(2), ["{0;0}: 1, 1, 3"]);
        assert!(trial("Closest Points").item(-1).message().contains("negative"));
        let none = Trial::of("Closest Point").item(Point3::ORIGIN).gaps::<Point3>([None]);
        assert!(none.message().contains("no points"));
    }

    /// From the eighth question on a tree answers: the same as looking at every point, of equally near ones the first.
    #[test]
    fn many_questions_are_answered_alike() {
        let place = |k: i32, x: f64| (3.0 * (f64::from(k) * x).sin()).round();
        let cloud: Vec<Option<Point3>> = (0..60)
            .map(|k| (k % 7 != 3).then(|| Point3::new(place(k, 1.3), place(k, 0.7), place(k, 2.1))))
            .collect();
        let asked: Vec<Point3> =
            (0..40).map(|k| Point3::new(place(k, 0.9) + 0.5, place(k, 1.7), 0.0)).collect();
        let first = |p: &Point3| {
            let far = |i: &usize| cloud[*i].unwrap().distance_to(*p);
            let present = (0..cloud.len()).filter(|i| cloud[*i].is_some());
            present.min_by(|a, b| far(a).total_cmp(&far(b))).unwrap()
        };
        let wanted: Vec<String> = asked.iter().map(|p| first(p).to_string()).collect();
        let wanted = format!("{{0}}: {}", wanted.join(", "));
        let trial = |name| Trial::of(name).list(asked.clone()).gaps(cloud.clone());
        assert_eq!(trial("Closest Point").texts(1), [wanted]);
        let single =
            |p: Point3| Trial::of("Closest Points").item(p).gaps(cloud.clone()).item(3).texts(1)[0].clone();
        let many = trial("Closest Points").item(3).texts(1);
        for (k, p) in asked.iter().enumerate() {
            assert_eq!(many[k].split(": ").nth(1), single(*p).split(": ").nth(1), "{k}");
        }
        let present: Vec<Point3> = cloud.iter().flatten().copied().collect();
        let pulled = Trial::of("Pull Point").list(asked.clone()).list(present).texts(1);
        assert_eq!(pulled, trial("Closest Point").texts(2));
    }

    #[test]
    fn pulled_and_projected() {
        let p = Point3::new(5.0, 1.0, 2.0);
        let line = Line::new(Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0));
        assert_eq!(Trial::of("Pull Point").item(p).item(line).texts(0), ["{0}: {3, 0, 0}"]);
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        let pulled = Trial::of("Pull Point").item(Point3::new(5.0, 0.0, 0.0)).item(circle);
        assert_eq!(pulled.texts(1), ["{0}: 4"]);
        let unit = Interval::UNIT;
        let b = Box3 { plane: Plane::XY, x: unit, y: unit, z: unit };
        let inside = Point3::new(0.5, 0.5, 0.9);
        assert_eq!(Trial::of("Pull Point").item(inside).item(b).texts(0), ["{0}: {0.5, 0.5, 1}"]);
        let early = Trial::of_guid("cf3a0865-4882-46bd-91a1-d512acf95be4").item(p).item(line);
        assert_eq!(early.texts(0), ["{0}: {3, 0, 0}"]);
        let corners =
            row(&[0.0, 9.0]).into_iter().chain([Point3::new(9.0, 9.0, 0.0), Point3::new(0.0, 9.0, 0.0)]);
        let mesh = Mesh::new(corners.collect(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap();
        assert_eq!(Trial::of("Pull Point").item(p).item(mesh.clone()).texts(0), ["{0}: {5, 1, 0}"]);
        let project = |p: Point3| Trial::of("Project Point").item(p).default().item(mesh.clone());
        assert_eq!(project(p).texts(0), ["{0}: {5, 1, 0}"]);
        assert_eq!(project(p).texts(1), ["{0}: 0"]);
        assert_eq!(project(Point3::new(-1.0, 0.0, 1.0)).texts(1), ["{0}: -1"]);
        let up = Trial::of("Project Point").item(p).item(Vector3::Z).item(mesh);
        assert_eq!(up.texts(0), ["{0}: {5, 1, 0}"]);
    }

    /// Each piece by itself: of a line, a circle, a point and a plane the feet are worked out by hand.
    #[test]
    fn pulled_to_each() {
        let pieces = || {
            let line: Value = Line::new(Point3::ORIGIN, Point3::new(3.0, 0.0, 0.0)).into();
            let circle: Value = Circle { plane: Plane::XY, radius: 2.0 }.into();
            let point: Value = Point3::new(6.0, 8.0, 1.0).into();
            [Some(line), Some(circle), None, Some(point), Some(Plane::XY.into())]
        };
        let two = [Point3::new(6.0, 8.0, 0.0), Point3::new(3.0, -4.0, 12.0)];
        let early = "cf3a0865-4882-46bd-91a1-d512acf95be4";
        let by_setting = || Trial::of("Pull Point").setting("ClosestOnly", false).list(two).gaps(pieces());
        let by_port = || Trial::of_guid(early).list(two).gaps(pieces()).item(false);
        for [places, distances] in
            [[by_setting().texts(0), by_setting().texts(1)], [by_port().texts(0), by_port().texts(1)]]
        {
            assert_eq!(places[0], "{0;0}: {3, 0, 0}, {1.2, 1.6, 0}, null, {6, 8, 1}, {6, 8, 0}");
            assert_eq!(places[1], "{0;1}: {3, 0, 0}, {1.2, -1.6, 0}, null, {6, 8, 1}, {3, -4, 0}");
            // √(3² + 8²), 10 − 2, 1 and 0; √(4² + 12²), √((5 − 2)² + 12²), √(3² + 12² + 11²) and 12.
            let [a, b, c] = [73_f64, 153.0, 274.0].map(|x| format!("{:.6}", x.sqrt()));
            assert_eq!(distances[0], format!("{{0;0}}: {a}, 8, null, 1, 0"));
            assert_eq!(distances[1], format!("{{0;1}}: 12.649111, {b}, null, {c}, 12"));
        }
        // The closest alone is an item, as before.
        let closest = Trial::of("Pull Point").setting("ClosestOnly", true).list(two).gaps(pieces());
        assert_eq!(closest.texts(1), ["{0}: 0, 12"]);
        assert_eq!(Trial::of_guid(early).list(two).gaps(pieces()).item(true).texts(1), ["{0}: 0, 12"]);
        let none: [Option<Value>; 0] = [];
        let trial = Trial::of("Pull Point").setting("ClosestOnly", false).item(two[0]).gaps(none);
        assert_eq!(trial.texts(0), ["{0;0}:"]);
    }

    #[test]
    fn duplicates() {
        let trial = || Trial::of("Cull Duplicates").list(row(&[0.0, 5.0, 0.05, 9.0])).item(0.1);
        assert_eq!(trial().texts(0), ["{0;0}: {0.025, 0, 0}, {5, 0, 0}, {9, 0, 0}"]);
        assert_eq!(trial().texts(1), ["{0;0}: -1, 1, 3"]);
        assert_eq!(trial().texts(2), ["{0;0}: 2, 1, 1"]);
        assert_eq!(trial().setting("CullMode", 1).texts(1), ["{0;0}: 0, 1, 3"]);
        assert_eq!(trial().setting("CullMode", 2).texts(1), ["{0;0}: 1, 3"]);
    }

    #[test]
    fn groups() {
        let trial = || Trial::of("Point Groups").list(row(&[0.0, 5.0, 1.0, 2.0, 5.5])).item(1.0);
        assert_eq!(trial().texts(1), ["{0;0;0}: 0, 2, 3", "{0;0;1}: 1, 4"]);
        assert_eq!(trial().texts(0)[1], "{0;0;1}: {5, 0, 0}, {5.5, 0, 0}");
    }

    #[test]
    fn in_order() {
        let points = [[1.0, 2.0, 0.0], [1.0, 1.0, 5.0], [0.0, 9.0, 9.0]].map(Point3::from);
        assert_eq!(Trial::of("Sort Points").list(points).texts(1), ["{0}: 2, 1, 0"]);
        let line = Line::new(Point3::ORIGIN, Point3::new(0.0, 0.0, 9.0));
        assert_eq!(Trial::of("Sort Along Curve").list(points).item(line).texts(1), ["{0;0}: 0, 1, 2"]);
    }
}
