//! Functions of areas, volumes and what goes with them.

use std::f64::consts::PI;

use serde_json::json;

use crate::helpers::{ask, at, ball, c1, cube_brep, cube_mesh, floor, near, object};

#[test]
fn areas_and_volumes() {
    let disc = ask("areamassproperties/compute-curve", json!([c1()]));
    near(&disc["Area"], PI * 25.0);
    at(&disc["Centroid"], [0.0, 0.0, 0.0]);
    near(&disc["WorldCoordinatesMomentsOfInertia"]["Z"], 0.5 * PI * 625.0);
    near(&ask("areamassproperties/compute-brep", json!([object(&ball(0.0, 5.0))]))["Area"], 4.0 * PI * 25.0);
    near(
        &ask("volumemassproperties/compute-brep", json!([object(&ball(3.0, 5.0))]))["Volume"],
        4.0 / 3.0 * PI * 125.0,
    );
    at(
        &ask("volumemassproperties/compute-brep", json!([object(&ball(3.0, 5.0))]))["Centroid"],
        [3.0, 0.0, 0.0],
    );
    near(&ask("volumemassproperties/compute-mesh", json!([cube_mesh()]))["Volume"], 6.0);
    near(&ask("areamassproperties/compute-mesh", json!([cube_mesh()]))["Area"], 22.0);
    near(&ask("areamassproperties/compute-surface", json!([object(&floor())]))["Area"], 12.0);
    near(
        &ask("areamassproperties/compute-geometrybasearray", json!([[c1(), cube_brep()]]))["Area"],
        PI * 25.0 + 22.0,
    );
    near(&ask("brep/getvolume-brep", json!([cube_brep()])), 6.0);
    near(&ask("brep/getarea-brep_double_double", json!([cube_brep(), 1e-6, 1e-6])), 22.0);
    near(&ask("mesh/volume-mesh", json!([cube_mesh()])), 6.0);
}
