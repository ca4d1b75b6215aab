//! Laws of booleans on random pairs of solids. A case may be refused, but no answer may break a law.

#![allow(clippy::unwrap_used, reason = "a failing test may panic")]

use katydid_geometry::brep::Made;
use katydid_geometry::{
    Box3, Brep, Cylinder, Error, Interval, Plane, Point3, Sphere, Tolerance, Torus, Vector3, construct,
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
        _ => construct::torus(&Torus::new(plane, 0.6 * a, 0.25 * a).unwrap()).unwrap(),
    }
}

fn any_solid() -> impl Strategy<Value = Brep> {
    let frame = prop::array::uniform6(-1.0..1.0);
    let sizes = prop::array::uniform3(0.8..2.0);
    (0_u8..4, frame, sizes).prop_map(|(kind, frame, sizes)| solid(kind, frame, sizes))
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

/// The three sides of both laws, unless the kernel refuses one of the operations.
fn laws(a: &Brep, b: &Brep) -> Result<(), TestCaseError> {
    let t = tolerance();
    let [first, second] = [std::slice::from_ref(a), std::slice::from_ref(b)];
    let operations = || -> Result<[f64; 4], Error> {
        let union = breps(Brep::union(&[a.clone(), b.clone()], &t)?);
        let common = breps(Brep::intersection(first, second, &t)?);
        let left = breps(Brep::difference(first, second, &t)?);
        let swapped = breps(Brep::union(&[b.clone(), a.clone()], &t)?);
        Ok([volume(&union), volume(&common), volume(&left), volume(&swapped)])
    };
    let found = match operations() {
        Ok(found) => found,
        Err(Error::Refused(_)) => return Ok(()),
        Err(other) => return Err(TestCaseError::fail(other.to_string())),
    };
    let [union, common, left, swapped] = found;
    let [va, vb] = [volume(first), volume(second)];
    let near = |x: f64, y: f64| (x - y).abs() <= 2e-5 * (va + vb);
    prop_assert!(near(va + vb, union + common), "V(A) + V(B) = V(A ∪ B) + V(A ∩ B): {va} {vb} {found:?}");
    prop_assert!(near(va, left + common), "V(A) = V(A − B) + V(A ∩ B): {va} {vb} {found:?}");
    prop_assert!(near(union, swapped), "A ∪ B = B ∪ A: {found:?}");
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    fn volumes_add_up(a in any_solid(), b in any_solid()) {
        laws(&a, &b)?;
    }
}

#[test]
fn taking_away_what_is_left_gives_what_is_common() {
    let a = solid(0, [0.0, 0.0, 0.0, 0.0, 0.0, 1.0], [2.0, 2.0, 2.0]);
    let b = solid(1, [0.6, 0.2, 0.1, 0.3, -0.2, 1.0], [1.2, 3.0, 1.0]);
    let t = tolerance();
    let [one, two] = [[a], [b]];
    let common = volume(&breps(Brep::intersection(&one, &two, &t).unwrap()));
    let left = breps(Brep::difference(&one, &two, &t).unwrap());
    let again = volume(&breps(Brep::difference(&one, &left, &t).unwrap()));
    assert!(common > 0.1 && (common - again).abs() < 1e-5, "{common} {again}");
}
