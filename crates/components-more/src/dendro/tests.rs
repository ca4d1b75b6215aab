//! Volumes against closed forms.

use katydid_component::testing::Trial;
use katydid_data::Value;
use katydid_geometry::{Mesh, Point3};

fn first(trial: Trial) -> Value {
    trial.run().outputs[0].branch(0).unwrap().get(0).unwrap()
}

fn settings(voxel: f64) -> Value {
    first(Trial::of("Create Settings").item(voxel).item(4.0).item(0.0).item(0.0))
}

fn mesh(volume: Value) -> std::sync::Arc<Mesh> {
    match first(Trial::of("Volume to Mesh").item(volume)) {
        Value::Mesh(mesh) => mesh,
        other => panic!("{other:?}"),
    }
}

fn ball(at: f64) -> Value {
    let trial = Trial::of("Points To Volume").list([Point3::new(at, 0.0, 0.0)]).list([1.0]);
    first(trial.item(settings(0.1)))
}

const BALL: f64 = 4.0 / 3.0 * std::f64::consts::PI;

fn volume_of(mesh: &Mesh) -> f64 {
    assert!(mesh.is_closed());
    let six = mesh.triangles().map(|[a, b, c]| a.to_vector().dot(b.to_vector().cross(c.to_vector())));
    six.sum::<f64>() / 6.0
}

/// A part of `wanted` that may be off: what straight sides of a tenth of the radius cut away.
fn near(found: f64, wanted: f64) {
    assert!((found - wanted).abs() < 0.01 * wanted, "{found} is not {wanted}");
}

#[test]
fn balls_and_what_they_have_in_common() {
    near(volume_of(&mesh(ball(0.0))), BALL);
    // The lens of two balls of radius 1 at a distance d: π (4 + d)(2 − d)²/12.
    let lens = std::f64::consts::PI * 5.0 / 12.0;
    let both = [ball(0.0), ball(1.0)];
    near(volume_of(&mesh(first(Trial::of("Volume Union").list(both.clone())))), 2.0 * BALL - lens);
    near(volume_of(&mesh(first(Trial::of("Volume Intersection").list(both.clone())))), lens);
    let [a, b] = both;
    near(volume_of(&mesh(first(Trial::of("Volume Difference").item(a).item(b)))), BALL - lens);
}

#[test]
fn an_offset_ball_is_a_larger_ball() {
    let wider = first(Trial::of("Offset Volume").item(ball(0.0)).item(0.2));
    near(volume_of(&mesh(wider)), BALL * 1.2 * 1.2 * 1.2);
    assert!(Trial::of("Offset Volume").item(ball(0.0)).item(5.0).message().contains("band"));
}

#[test]
fn a_mesh_comes_back() {
    let again = first(Trial::of("Mesh to Volume").item(mesh(ball(0.0))).item(settings(0.1)));
    near(volume_of(&mesh(again)), BALL);
}

#[test]
fn smoothing_leaves_nearly_a_ball() {
    for kind in 0..=4 {
        let smooth = first(Trial::of("Smooth Volume").item(ball(0.0)).item(1).item(kind).item(1));
        let volume = volume_of(&mesh(smooth));
        // The mean of a distance from a centre is larger by h²/3 · (2/r)/2 at most four times: some hundredths.
        assert!(volume > 0.9 * BALL && volume < 1.02 * BALL, "{kind}: {volume}");
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    assert!(Trial::of("Create Settings").item(0.0).message().contains("greater than 0"));
    assert!(Trial::of("Create Settings").item(f64::NAN).message().contains("greater than 0"));
    assert!(Trial::of("Volume to Mesh").item(1.0).message().contains("no volume"));
    let tiny = Trial::of("Points To Volume").list([Point3::ORIGIN]).list([1e9]).item(settings(0.1));
    assert!(tiny.message().contains("voxels"));
}
