//! Surface / Util: edges of a Brep by what they are like.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_elementary::Elementary;
use katydid_geometry::{Brep, Curve, Line, Point3, Vector3, brep::ClosestOnBrep};

use super::warning;

/// Edges and their numbers.
type Edges = (Vec<Shared<Curve>>, Vec<i32>);

fn number(place: usize) -> i32 {
    i32::try_from(place).unwrap_or(i32::MAX)
}

/// The edges that still are, with their numbers.
fn all(brep: &Brep) -> Result<Vec<(usize, Curve)>, Message> {
    let mut out = Vec::with_capacity(brep.edges().len());
    for place in (0..brep.edges().len()).filter(|k| brep.edges().get(*k).is_some_and(|edge| !edge.deleted)) {
        if let Some(curve) = brep.edge_as_curve(place).map_err(warning)? {
            out.push((place, curve));
        }
    }
    Ok(out)
}

fn chosen(
    context: &Context<'_>,
    brep: &Brep,
    is_wanted: impl Fn(&Curve) -> Result<bool, Message>,
) -> Result<Edges, Message> {
    let mut out = (Vec::new(), Vec::new());
    for (place, curve) in all(brep)? {
        context.check()?;
        if is_wanted(&curve)? {
            out.0.push(Shared::new(curve));
            out.1.push(number(place));
        }
    }
    Ok(out)
}

/// The edges of a Brep whose length lies in a range.
#[component(
    "ff187e6a-84bc-4bb9-a572-b39006a0576d",
    name = "Edges from Length",
    nick = "EdgesLen",
    at = "Surface/Util"
)]
#[output("Edges", "E", "The edges.")]
#[output("Indices", "I", "Their numbers in the Brep.")]
fn edges_from_length(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The least length.
    #[port("Minimum", "L-")]
    least: f64,
    /// The greatest length.
    #[port("Maximum", "L+")]
    most: f64,
) -> Result<(Vec<Shared<Curve>>, Vec<i32>), Message> {
    chosen(context, &brep, |curve| Ok((least..=most).contains(&curve.length())))
}

/// The edges of a Brep that are straight within a range.
///
/// Counted is how far an edge strays from the line between its ends.
#[component(
    "e4ff8101-73c9-4802-8c5d-704d8721b909",
    name = "Edges from Linearity",
    nick = "EdgesLin",
    at = "Surface/Util"
)]
#[output("Edges", "E", "The edges.")]
#[output("Indices", "I", "Their numbers in the Brep.")]
fn edges_from_linearity(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The least distance from the straight line.
    #[port("Minimum", "L-", default = 0.0)]
    least: f64,
    /// The greatest distance from the straight line.
    #[port("Maximum", "L+", default = 1.0)]
    most: f64,
) -> Result<(Vec<Shared<Curve>>, Vec<i32>), Message> {
    chosen(context, &brep, |curve| Ok((least..=most).contains(&bulge(curve))))
}

/// How far a curve strays from its chord: the farthest of many places, sharpened between its neighbours.
fn bulge(curve: &Curve) -> f64 {
    const PLACES: usize = 128;
    let chord = Line::new(curve.start(), curve.end());
    let off = |x: f64| {
        let p = curve.point_at(curve.domain().at(x));
        match chord.unit_direction().filter(|_| !curve.is_closed()) {
            Some(along) => {
                let arm = p - chord.from;
                (arm - along * arm.dot(along)).length()
            }
            None => p.distance_to(chord.from),
        }
    };
    let step = 1.0 / PLACES as f64;
    let at = |k: usize| off(k as f64 * step);
    let Some(best) = (0..=PLACES).max_by(|a, b| at(*a).total_cmp(&at(*b))) else { return 0.0 };
    let (mut a, mut b) = ((best as f64 - 1.0) * step, (best as f64 + 1.0) * step);
    (a, b) = (a.max(0.0), b.min(1.0));
    for _ in 0..60 {
        let (p, q) = (a + (b - a) / 3.0, b - (b - a) / 3.0);
        if off(p) < off(q) { a = p } else { b = q }
    }
    off(0.5 * (a + b)).max(at(best))
}

/// The edges of a Brep that run in one of some directions from end to end.
#[component(
    "64ff9813-8fe8-4708-ac9f-61b825213e83",
    name = "Edges from Directions",
    nick = "EdgesDir",
    at = "Surface/Util"
)]
#[output("Edges", "E", "The edges.")]
#[output("Indices", "I", "Their numbers in the Brep.")]
#[output("Map", "M", "For each edge the number of the direction that it runs in.")]
fn edges_from_directions(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The directions.
    #[port("Directions", "D")]
    directions: List<Vector3>,
    /// Whether the opposite directions count too.
    #[port("Reflex", "R", default = true)]
    reflex: bool,
    /// The greatest angle between an edge and a direction, in radians.
    #[port("Angle", "A", default = 0.0017)]
    angle: f64,
) -> Result<(Vec<Shared<Curve>>, Vec<i32>, Vec<Shared<str>>), Message> {
    const PLACES: i32 = 8;
    let ways: Vec<Option<Vector3>> = directions.present().map(Vector3::unitized).collect();
    let (mut curves, mut numbers, mut map) = (Vec::new(), Vec::new(), Vec::new());
    for (place, curve) in all(&brep)? {
        context.check()?;
        let runs_along = |way: Vector3, sign: f64| {
            (0..=PLACES).all(|k| {
                let tangent = curve.tangent_at(curve.domain().at(f64::from(k) / f64::from(PLACES)));
                tangent.is_some_and(|t| t.angle_to(way * sign).is_some_and(|a| a <= angle))
            })
        };
        let fits = |way: &Option<Vector3>| {
            way.is_some_and(|way| runs_along(way, 1.0) || (reflex && runs_along(way, -1.0)))
        };
        if let Some(way) = ways.iter().position(fits) {
            curves.push(Shared::new(curve));
            numbers.push(number(place));
            map.push(way.to_string().into());
        }
    }
    Ok((curves, numbers, map))
}

/// The edges of a Brep that pass points.
#[component(
    "73269f6a-9645-4638-8d5e-88064dd289bd",
    name = "Edges from Points",
    nick = "EdgesPt",
    at = "Surface/Util"
)]
#[output("Edges", "E", "The edges.")]
#[output("Indices", "I", "Their numbers in the Brep.")]
#[output("Map", "M", "For each edge the numbers of the points that it passes.")]
fn edges_from_points(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
    /// How many points an edge must pass at least.
    #[port("Valence", "V", default = 1)]
    valence: i32,
    /// How far from an edge a point may be.
    #[port("Tolerance", "T", default = 0.25)]
    tolerance: f64,
) -> Result<(Vec<Shared<Curve>>, Vec<i32>, Vec<Shared<str>>), Message> {
    let points: Vec<Point3> = points.present().collect();
    let (mut curves, mut numbers, mut map) = (Vec::new(), Vec::new(), Vec::new());
    for (place, curve) in all(&brep)? {
        let mut passed = Vec::new();
        for (k, p) in points.iter().enumerate() {
            context.check()?;
            if curve.closest_point(*p).map_err(warning)?.distance <= tolerance {
                passed.push(k.to_string());
            }
        }
        if passed.len() >= usize::try_from(valence).unwrap_or(0) {
            curves.push(Shared::new(curve));
            numbers.push(number(place));
            map.push(passed.join(",").into());
        }
    }
    Ok((curves, numbers, map))
}

/// The edges of those faces of a Brep that points lie on.
///
/// Each point counts for the face that is nearest to it.
#[component(
    "71e99dbb-2d79-4f02-a8a6-e87a09d54f47",
    name = "Edges from Faces",
    nick = "EdgesFaces",
    at = "Surface/Util"
)]
#[output("Edges", "E", "The edges.")]
#[output("Indices", "I", "Their numbers in the Brep.")]
fn edges_from_faces(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// Points on the faces.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<(Vec<Shared<Curve>>, Vec<i32>), Message> {
    let faces = (0..brep.faces().len()).map(|face| brep.sub_brep(&[face])).collect::<Result<Vec<_>, _>>();
    let faces = faces.map_err(warning)?;
    let mut wanted = vec![false; faces.len()];
    let prepared: Vec<_> = faces.into_iter().map(|face| ClosestOnBrep::new(Shared::new(face))).collect();
    for p in points.present() {
        context.check()?;
        let mut nearest: Option<(f64, usize)> = None;
        for (place, face) in prepared.iter().enumerate() {
            if let Ok(face) = face
                && let Ok(found) = face.nearest(p)
                && nearest.is_none_or(|(least, _)| found.distance < least)
            {
                nearest = Some((found.distance, place));
            }
        }
        if let Some(slot) = nearest.and_then(|(_, place)| wanted.get_mut(place)) {
            *slot = true;
        }
    }
    let mut out = (Vec::new(), Vec::new());
    for (place, curve) in all(&brep)? {
        let trims = brep.edges().get(place).map(|edge| edge.trims.as_slice()).unwrap_or_default();
        if trims.iter().filter_map(|trim| face_of(&brep, *trim)).any(|face| wanted.get(face) == Some(&true)) {
            out.0.push(Shared::new(curve));
            out.1.push(number(place));
        }
    }
    Ok(out)
}

fn face_of(brep: &Brep, trim: usize) -> Option<usize> {
    brep.loops().get(brep.trims().get(trim)?.in_loop?)?.face
}

/// The edges of a Brep that return to their start, and those that do not.
#[component(
    "70905be1-e22f-4fa8-b9ae-e119d417904f",
    name = "Closed Edges",
    nick = "EdgesCls",
    at = "Surface/Util"
)]
#[output("Closed", "C", "The edges that close.")]
#[output("Closed Indices", "Ci", "Their numbers in the Brep.")]
#[output("Open", "O", "The other edges.")]
#[output("Open Indices", "Oi", "Their numbers in the Brep.")]
fn closed_edges(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
    /// Whether an edge must close without a kink.
    #[port("Tangency", "T", default = false)]
    tangency: bool,
) -> Result<(Vec<Shared<Curve>>, Vec<i32>, Vec<Shared<Curve>>, Vec<i32>), Message> {
    let angle = context.tolerance().angle;
    let (mut closed, mut open) = ((Vec::new(), Vec::new()), (Vec::new(), Vec::new()));
    for (place, curve) in all(&brep)? {
        let ends = [curve.domain().start, curve.domain().end].map(|t| curve.tangent_at(t));
        let smooth = match ends {
            [Some(a), Some(b)] => a.angle_to(b).is_some_and(|turn| turn <= angle),
            _ => false,
        };
        let list = if curve.is_closed() && (smooth || !tangency) { &mut closed } else { &mut open };
        list.0.push(Shared::new(curve));
        list.1.push(number(place));
    }
    Ok((closed.0, closed.1, open.0, open.1))
}

/// The edges of a Brep at which its faces turn away from each other, and towards each other.
///
/// Edges along which faces go on smoothly, and those of one face only, are in neither list.
#[component(
    "8248da39-0729-4e04-8395-267b3259bc2f",
    name = "Convex Edges",
    nick = "EdgesCvx",
    at = "Surface/Util"
)]
#[output(
    "Convex",
    "Cv",
    "The numbers of edges at which faces turn away from each other, as at those of a box."
)]
#[output("Concave", "Cc", "The numbers of edges at which they turn towards each other.")]
#[output("Mixed", "Mx", "The numbers of edges that do both in turns.")]
fn convex_edges(
    context: &Context<'_>,
    /// The Brep.
    #[port("Brep", "B")]
    brep: Shared<Brep>,
) -> Result<(Vec<i32>, Vec<i32>, Vec<i32>), Message> {
    const PLACES: i32 = 8;
    let least = context.tolerance().angle.sine();
    let (mut convex, mut concave, mut mixed) = (Vec::new(), Vec::new(), Vec::new());
    for (place, curve) in all(&brep)? {
        context.check()?;
        let trims = brep.edges().get(place).map(|edge| edge.trims.as_slice()).unwrap_or_default();
        let [a, b] = *trims else { continue };
        let (mut away, mut towards) = (false, false);
        for k in 1..PLACES {
            let t = curve.domain().at(f64::from(k) / f64::from(PLACES));
            let bend = bend(&brep, [a, b], curve.point_at(t), curve.tangent_at(t)).unwrap_or(0.0);
            away |= bend > least;
            towards |= bend < -least;
        }
        match (away, towards) {
            (true, true) => mixed.push(number(place)),
            (true, false) => convex.push(number(place)),
            (false, true) => concave.push(number(place)),
            (false, false) => {}
        }
    }
    Ok((convex, concave, mixed))
}

/// The sine of the angle by which the second face of an edge turns away from the first one at a point.
fn bend(brep: &Brep, trims: [usize; 2], p: Point3, tangent: Option<Vector3>) -> Option<f64> {
    let tangent = tangent?;
    let normal = |trim: usize| {
        let face = face_of(brep, trim)?;
        let surface = brep.face_surface(face)?;
        let foot = surface.closest_point(p).ok()?;
        let normal = surface.normal_at(foot.u, foot.v)?;
        let reversed = brep.faces().get(face)?.reversed;
        Some((if reversed { -normal } else { normal }, reversed))
    };
    let ((first, reversed), (second, _)) = (normal(trims[0])?, normal(trims[1])?);
    // Counter-clockwise round the first face, seen from its front.
    let against = brep.trims().get(trims[0])?.reversed != reversed;
    let inward = first.cross(if against { -tangent } else { tangent });
    Some(-second.dot(inward))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Value;
    use katydid_geometry::{Box3, Circle, Interval, Plane, Point3, Vector3};

    fn cube() -> Value {
        let side = Interval::new(0.0, 2.0);
        Box3 { plane: Plane::XY, x: side, y: side, z: Interval::new(0.0, 5.0) }.into()
    }

    fn count(trial: Trial, output: usize) -> usize {
        trial.run().outputs[output].column().len()
    }

    /// A tube with discs at its ends.
    fn drum() -> Value {
        let circle = Circle { plane: Plane::XY, radius: 1.0 };
        let tube = Trial::of("Extrude").item(circle).item(Vector3::new(0.0, 0.0, 3.0)).run();
        let made = Trial::of("Cap Holes").item(tube.outputs[0].column().get(0).unwrap()).run();
        made.outputs[0].column().get(0).unwrap()
    }

    #[test]
    fn of_a_box() {
        assert_eq!(count(Trial::of("Edges from Length").item(cube()).item(4.0).item(6.0), 1), 4);
        assert_eq!(count(Trial::of("Edges from Linearity").item(cube()), 1), 12);
        let along = |reflex: bool| {
            count(Trial::of("Edges from Directions").item(cube()).list([Vector3::Z]).item(reflex), 1)
        };
        assert_eq!(along(true), 4);
        assert!(along(false) <= 4);
        let corner = [Point3::new(0.0, 0.0, 0.0), Point3::new(2.0, 0.0, 0.0)];
        assert_eq!(count(Trial::of("Edges from Points").item(cube()).list(corner), 1), 5);
        assert_eq!(count(Trial::of("Edges from Points").item(cube()).list(corner).item(2), 1), 1);
        let top = Point3::new(1.0, 1.0, 5.0);
        assert_eq!(count(Trial::of("Edges from Faces").item(cube()).list([top]), 1), 4);
        assert_eq!(count(Trial::of("Convex Edges").item(cube()), 0), 12);
        assert_eq!(count(Trial::of("Closed Edges").item(cube()), 1), 0);
    }

    #[test]
    fn of_a_drum() {
        assert_eq!(count(Trial::of("Closed Edges").item(drum()), 1), 2);
        assert_eq!(count(Trial::of("Closed Edges").item(drum()), 3), 1);
        assert_eq!(count(Trial::of("Convex Edges").item(drum()), 0), 2);
        assert_eq!(count(Trial::of("Convex Edges").item(drum()), 1), 0);
        assert_eq!(count(Trial::of("Edges from Linearity").item(drum()).item(1.5).item(2.5), 1), 2);
    }
}
