//! Laws of booleans on random pairs and triples of solids. A case may be refused, but no answer may break a law.
//!
//! `KATYDID_BOOLEAN_LAWS=20000 cargo test --release -p katydid-geometry --test boolean_laws` looks at so many of each.

#![allow(clippy::unwrap_used, reason = "a failing test may panic")]

use katydid_geometry::brep::Made;
use katydid_geometry::{
    Box3, Brep, Cone, Containment, Cylinder, Error, Interval, Plane, Point3, Sphere, Tolerance, Torus,
    Vector3, construct,
};
use proptest::prelude::*;

fn placed(numbers: [f64; 6]) -> Plane {
    let [x, y, z, a, b, c] = numbers;
    let normal = Vector3::new(a, b, c).unitized().unwrap_or(Vector3::Z);
    Plane::from_normal(Point3::new(x, y, z), normal).unwrap()
}

fn solid(kind: u8, frame: [f64; 6], sizes: [f64; 3]) -> Brep {
    let plane = placed(frame);
    let [a, b, c] = sizes;
    let range = |x: f64| Interval::new(-0.5 * x, 0.5 * x);
    match kind {
        0 => construct::box_brep(&Box3 { plane, x: range(a), y: range(b), z: range(c) }).unwrap(),
        1 => construct::cylinder(&Cylinder::new(plane, 0.5 * a, range(b)).unwrap(), [true; 2]).unwrap(),
        2 => construct::sphere(&Sphere::new(plane, 0.6 * a).unwrap()).unwrap(),
        3 => construct::torus(&Torus::new(plane, 0.6 * a, 0.25 * a).unwrap()).unwrap(),
        _ => construct::cone(&Cone::new(plane, b, 0.5 * c).unwrap(), true).unwrap(),
    }
}

fn any_solid() -> impl Strategy<Value = Brep> {
    let frame = prop::array::uniform6(-1.0..1.0);
    let sizes = prop::array::uniform3(0.8..2.0);
    (0_u8..5, frame, sizes).prop_map(|(kind, frame, sizes)| solid(kind, frame, sizes))
}

fn tolerance() -> Tolerance {
    Tolerance { absolute: 1e-6, ..Tolerance::default() }
}

fn breps(made: Vec<Made>) -> Vec<Brep> {
    made.into_iter().map(|m| m.brep).collect()
}

fn volume(breps: &[Brep]) -> f64 {
    breps.iter().map(|b| b.volume_properties(1e-8, || true).unwrap().amount).sum()
}

/// The results of some operations, unless the kernel refuses one of them.
fn decided<T>(operations: impl FnOnce() -> Result<T, Error>) -> Result<Option<T>, TestCaseError> {
    match operations() {
        Ok(found) => Ok(Some(found)),
        Err(Error::Refused(_)) => Ok(None),
        Err(other) => Err(TestCaseError::fail(other.to_string())),
    }
}

/// Whether two volumes are one, beside that of all operands.
fn near(x: f64, y: f64, all: f64) -> bool {
    (x - y).abs() <= 2e-5 * all
}

fn union(of: &[Brep]) -> Result<Vec<Brep>, Error> {
    Brep::union(of, &tolerance()).map(breps)
}

fn difference(a: &[Brep], b: &[Brep]) -> Result<Vec<Brep>, Error> {
    Brep::difference(a, b, &tolerance()).map(breps)
}

fn intersection(a: &[Brep], b: &[Brep]) -> Result<Vec<Brep>, Error> {
    Brep::intersection(a, b, &tolerance()).map(breps)
}

fn pair_laws(a: &Brep, b: &Brep) -> Result<(), TestCaseError> {
    let [first, second] = [std::slice::from_ref(a), std::slice::from_ref(b)];
    let found = decided(|| {
        let both = union(&[a.clone(), b.clone()])?;
        let swapped = union(&[b.clone(), a.clone()])?;
        let [common, left] = [intersection(first, second)?, difference(first, second)?];
        Ok([volume(&both), volume(&common), volume(&left), volume(&swapped)])
    })?;
    let Some([both, common, left, swapped]) = found else { return Ok(()) };
    let [va, vb] = [volume(first), volume(second)];
    let all = va + vb;
    prop_assert!(near(all, both + common, all), "V(A) + V(B) = V(A ∪ B) + V(A ∩ B): {va} {vb} {found:?}");
    prop_assert!(near(va, left + common, all), "V(A) = V(A − B) + V(A ∩ B): {va} {vb} {found:?}");
    prop_assert!(near(both, swapped, all), "A ∪ B = B ∪ A: {found:?}");
    let again = decided(|| {
        let left = difference(first, second)?;
        if left.is_empty() { Ok(va) } else { Ok(volume(&difference(first, &left)?)) }
    })?;
    prop_assert!(again.is_none_or(|v| near(v, common, all)), "A − (A − B) = A ∩ B: {again:?} {common}");
    Ok(())
}

fn triple_laws(a: &Brep, b: &Brep, c: &Brep) -> Result<(), TestCaseError> {
    let [x, y, z] = [a, b, c].map(std::slice::from_ref);
    let all: f64 = [x, y, z].map(volume).iter().sum();
    let found = decided(|| {
        let at_once = difference(x, &[b.clone(), c.clone()])?;
        let common = intersection(&difference(x, y)?, &difference(x, z)?)?;
        Ok([volume(&at_once), volume(&common)])
    })?;
    prop_assert!(found.is_none_or(|[p, q]| near(p, q, all)), "A − (B ∪ C) = (A − B) ∩ (A − C): {found:?}");
    let found = decided(|| {
        let at_once = intersection(x, &union(&[b.clone(), c.clone()])?)?;
        let mut parts = intersection(x, y)?;
        parts.extend(intersection(x, z)?);
        Ok([volume(&at_once), volume(&union(&parts)?)])
    })?;
    prop_assert!(found.is_none_or(|[p, q]| near(p, q, all)), "A ∩ (B ∪ C) = (A ∩ B) ∪ (A ∩ C): {found:?}");
    Ok(())
}

/// Points that are inside a result must be inside the operands as the operation has it, whatever the volumes add up to.
fn points_agree(a: &Brep, b: &Brep, points: &[[f64; 3]]) -> Result<(), TestCaseError> {
    let [first, second] = [std::slice::from_ref(a), std::slice::from_ref(b)];
    let found = decided(|| Ok([intersection(first, second)?, difference(first, second)?]))?;
    let Some([common, left]) = found else { return Ok(()) };
    for p in points.iter().map(|p| Point3::from(*p)) {
        // Points near a boundary tell nothing.
        let is_in = |brep: &Brep| match brep.contains(p, 1e-4) {
            Ok(Containment::Inside) => Some(true),
            Ok(Containment::Outside) => Some(false),
            _ => None,
        };
        let any = |of: &[Brep]| of.iter().map(is_in).try_fold(false, |found, x| x.map(|x| found || x));
        let (Some(p_in_a), Some(p_in_b)) = (is_in(a), is_in(b)) else { continue };
        prop_assert!(any(&common).is_none_or(|x| x == (p_in_a && p_in_b)), "A ∩ B at {p:?}");
        prop_assert!(any(&left).is_none_or(|x| x == (p_in_a && !p_in_b)), "A − B at {p:?}");
    }
    Ok(())
}

/// Two solids that nearly share faces: each is [0, 1] or a part of it in three directions, and the sides of the second are
/// so many tolerances beside those of the first.
fn nearly_sharing(
    kind: u8,
    sides: [(u8, f64); 6],
    turn: [f64; 6],
) -> Result<Option<([Brep; 2], f64)>, TestCaseError> {
    let tau = tolerance().absolute;
    let place = |(at, off): (u8, f64)| [0.0, 0.001, 0.3, 0.999, 1.0][usize::from(at) % 5] + off * tau;
    let [x, y, z] = [0, 2, 4].map(|k| {
        let [a, b] = [place(sides[k]), place(sides[k + 1])];
        [a.min(b), a.max(b)]
    });
    let plane = placed(turn);
    let unit = Interval::new(0.0, 1.0);
    let clipped = |[from, to]: [f64; 2]| (to.min(1.0) - from.max(0.0)).max(0.0);
    if [x, y, z].iter().any(|[from, to]| to - from < 1e-4) {
        return Ok(None);
    }
    Ok(Some(if kind == 0 {
        let first = Box3 { plane, x: unit, y: unit, z: unit };
        let second = Box3 {
            plane,
            x: Interval::new(x[0], x[1]),
            y: Interval::new(y[0], y[1]),
            z: Interval::new(z[0], z[1]),
        };
        let common = [x, y, z].map(clipped).iter().product();
        ([first, second].map(|b| construct::box_brep(&b).unwrap()), common)
    } else {
        // Coaxial cylinders; the radius of the second is the length of its first range.
        let radius = x[1] - x[0];
        let made = [(1.0, unit), (radius, Interval::new(z[0], z[1]))].map(|(r, height)| {
            construct::cylinder(&Cylinder::new(plane, r, height).unwrap(), [true; 2]).unwrap()
        });
        let r = radius.min(1.0);
        (made, std::f64::consts::PI * r * r * clipped(z))
    }))
}

/// How many random cases are looked at.
fn cases(few: u32) -> u32 {
    std::env::var("KATYDID_BOOLEAN_LAWS").ok().and_then(|n| n.parse().ok()).unwrap_or(few)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(8), ..ProptestConfig::default() })]

    #[test]
    fn pairs(
        a in any_solid(),
        b in any_solid(),
        points in prop::collection::vec(prop::array::uniform3(-1.5..1.5), 24),
    ) {
        pair_laws(&a, &b)?;
        points_agree(&a, &b, &points)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(48), ..ProptestConfig::default() })]

    /// Faces may lie within the tolerance in one direction and beyond it in another: the answer is right to some
    /// tolerances, or it is refused.
    #[test]
    fn solids_that_nearly_share_faces(
        kind in 0_u8..2,
        sides in prop::array::uniform6((0_u8..5, prop_oneof![Just(0.0), -3.0..3.0_f64, -20.0..20.0_f64])),
        turn in prop::array::uniform6(-1.0..1.0),
    ) {
        let Some(([a, b], want)) = nearly_sharing(kind, sides, turn)? else { return Ok(()) };
        let [first, second] = [[a], [b]];
        let found = decided(|| Ok([volume(&intersection(&first, &second)?), volume(&difference(&first, &second)?)]))?;
        if let Some([common, left]) = found {
            // Each of six sides moves by tolerances times its area.
            let near = 50.0 * tolerance().absolute;
            prop_assert!((common - want).abs() < near, "A ∩ B: {common}, and not {want}");
            prop_assert!((left - (volume(&first) - want)).abs() < near, "A − B: {left}, and not V(A) − {want}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(3), ..ProptestConfig::default() })]

    #[test]
    fn triples(a in any_solid(), b in any_solid(), c in any_solid()) {
        triple_laws(&a, &b, &c)?;
    }
}

#[test]
fn taking_away_what_is_left_gives_what_is_common() {
    let a = solid(0, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], [2.0, 2.0, 2.0]);
    let b = solid(1, [0.6, 0.2, 0.1, 0.3, -0.2, 1.0], [1.2, 3.0, 1.0]);
    let [one, two] = [[a], [b]];
    let common = volume(&intersection(&one, &two).unwrap());
    let left = difference(&one, &two).unwrap();
    let again = volume(&difference(&one, &left).unwrap());
    assert!(common > 0.1 && (common - again).abs() < 1e-5, "{common} {again}");
}
