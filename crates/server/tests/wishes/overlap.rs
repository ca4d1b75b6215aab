//! Wrong answers when requests overlap (compute.rhino3d#149); parallel Breps that crash (dcascaval/Impala#4).

use futures_util::future::join_all;
use serde_json::json;

use crate::client::{Compute, input};
use crate::definitions::{SUM, gh};

/// The volume of a sphere with a bore through its middle.
const BORED: &str = "katydid 1\nr = Number Slider(1.0, 0..10)\nball = Sphere(XY Plane(), r)\n\
    base = Circle(plane((0, 0, -10)), 0.5)\nbore = Extrude(base, (0, 0, 20))\ncap = Cap Holes(bore)\n\
    part = Solid Difference(ball, cap)\nv = Volume(part)\n\"RH_IN:r\": r\n\"RH_OUT:v\": v\n";

#[tokio::test(flavor = "multi_thread")]
async fn requests_that_overlap_get_their_own_answers() {
    let compute = Compute::start().await;
    let sums = [gh(SUM), gh(&SUM.replace("3.0", "4.0")), gh(&SUM.replace("3.0", "5.0"))];
    let ask = async |n: usize| {
        let (which, a) = (n % 3, (n % 11) as f64);
        let answer = compute.solve(&sums[which], json!([input("RH_IN:A", "0", &[json!(a)])])).await;
        assert_eq!(answer.output("RH_OUT:sum"), a + 3.0 + which as f64, "{n}");
    };
    join_all((0..128).map(ask)).await;
}

/// What is left of the ball is twice the volume between the cylinder of half a unit and the sphere: a ring of the height
/// of the bore, 4/3 π (r² − 1/4)^(3/2) (the napkin ring).
#[tokio::test(flavor = "multi_thread")]
async fn breps_that_are_cut_side_by_side_are_right() {
    let compute = Compute::start().await;
    let algo = gh(BORED);
    let ask = async |n: usize| {
        let r = 1.0 + (n % 4) as f64;
        let answer = compute.solve(&algo, json!([input("RH_IN:r", "0", &[json!(r)])])).await;
        assert_eq!(answer.status, 200, "{}", answer.text());
        let volume = answer.output("RH_OUT:v (V)").as_f64().unwrap();
        let wanted = 4.0 / 3.0 * std::f64::consts::PI * (r * r - 0.25).powf(1.5);
        assert!((volume - wanted).abs() < 1e-3 * wanted, "{volume} is not {wanted}");
    };
    join_all((0..12).map(ask)).await;
    compute.is_well().await;
}
