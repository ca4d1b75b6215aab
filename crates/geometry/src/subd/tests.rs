use super::*;
use crate::Point3;

/// A cube of six quads, all turned outward.
fn cube() -> SubDNet {
    let corner = |i: u32| Point3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2));
    let polygons =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]].map(Vec::from);
    SubDNet::from_polygons((0..8).map(corner).collect(), &polygons).unwrap()
}

#[test]
fn a_cube_has_twelve_smooth_edges() {
    let cube = cube();
    assert_eq!((cube.vertices().len(), cube.edges().len(), cube.faces().len()), (8, 12, 6));
    assert!(cube.edges().iter().all(|e| e.tag == SubDEdgeTag::Smooth && e.faces.len() == 2));
    assert!(cube.vertices().iter().all(|v| v.edges.len() == 3 && v.faces.len() == 3));
    assert_eq!(cube.corners(1).collect::<Vec<_>>(), [4, 5, 7, 6]);
    assert_eq!(cube.corners(6).count(), 0);
}

#[test]
fn a_boundary_is_a_crease() {
    let points = (0..4).map(|i| Point3::new(f64::from(i), f64::from(i * i), 0.0)).collect();
    let net = SubDNet::from_polygons(points, &[vec![0, 1, 2, 3]]).unwrap();
    assert!(net.edges().iter().all(|e| e.tag == SubDEdgeTag::Crease));
    assert!(net.vertices().iter().all(|v| v.tag == SubDVertexTag::Crease));
}

/// Each change breaks one promise, and the fault names the part.
#[test]
fn an_inconsistent_net_is_refused() {
    type Parts = (Vec<SubDVertex>, Vec<SubDEdge>, Vec<SubDFace>);
    type Spoil = fn(&mut Parts);
    let cases: [(&str, Spoil); 12] = [
        ("vertex 3 has the identifier 1", |p| p.0[3].id = 1),
        ("edge 0 has the identifier 0", |p| p.1[0].id = 0),
        ("vertex 2 is not finite", |p| p.0[2].point.y = f64::NAN),
        ("edge 4 has a sharpness", |p| p.1[4].sharpness[1] = f64::INFINITY),
        ("edge 5 joins vertex", |p| p.1[5].vertices = [7, 8]),
        ("edge 5 joins vertex", |p| p.1[5].vertices = [6, 6]),
        ("which does not name it", |p| p.0[0].edges.clear()),
        ("which does not name it", |p| p.1[2].faces.clear()),
        ("names edge 99", |p| p.0[1].edges.push(SubDSide::forward(99))),
        ("names face 4", |p| p.0[1].faces.push(4)),
        ("bounds face 6", |p| p.1[1].faces.push(SubDSide::forward(6))),
        ("face 3", |p| p.2[3].edges.swap(0, 1)),
    ];
    for (fault, change) in cases {
        let net = cube();
        let mut parts = (net.vertices().to_vec(), net.edges().to_vec(), net.faces().to_vec());
        change(&mut parts);
        let error = SubDNet::from_parts(parts.0, parts.1, parts.2).unwrap_err().to_string();
        assert!(error.contains(fault), "{error} should contain {fault}");
    }
}

#[test]
fn polygons_that_make_no_net_are_refused() {
    let points: Vec<Point3> = (0..4).map(|i| Point3::new(f64::from(i), 0.0, 1.0)).collect();
    for polygon in [vec![0, 1], vec![0, 1, 9], vec![0, 0, 1]] {
        assert!(SubDNet::from_polygons(points.clone(), &[polygon]).is_err());
    }
    assert!(SubD::from_levels(vec![]).is_err());
}
